//! The law of a cell as one equation.
//!
//! With γ the stiffness of a cell and s its sliding, p = P(p + γ s), where P reduces what exceeds
//! μ pₙ to it: in stick s = 0, in slip p = μ pₙ along s. Its derivative is that of stick or of slip
//! (semismooth Newton: Alart and Curnier 1991; Hüeber, Stadler and Wohlmuth 2008).

pub(in crate::rolling) type Matrix = [[f64; 2]; 2];

/// |q|, without the care that tractions do not need.
fn length(q: [f64; 2]) -> f64 {
    (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// P(q) of a pull q for a bound μ pₙ; all in Pa.
pub(in crate::rolling) fn reduced(q: [f64; 2], bound: f64) -> [f64; 2] {
    let length = length(q);
    if length > bound { q.map(|q| q * (bound / length)) } else { q }
}

/// A traction (in Pa) over μ pₙ (in Pa), dimensionless; at most one in spite of the tolerance.
pub(in crate::rolling) fn saturation(traction: [f64; 2], bound: f64) -> [f64; 2] {
    let over = if bound > 0.0 { bound.recip() } else { 0.0 };
    reduced(traction.map(|p| over * p), 1.0)
}

/// The derivatives of P, dimensionless.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Slope {
    /// By q, dimensionless.
    pub by_pull: Matrix,
    /// By μ pₙ: the direction of sliding, dimensionless; zero in stick.
    pub by_bound: [f64; 2],
}

impl Slope {
    /// At a pull q for a bound μ pₙ, both in Pa.
    pub fn at(q: [f64; 2], bound: f64) -> Self {
        let length = length(q);
        if length <= bound {
            return Self { by_pull: [[1.0, 0.0], [0.0, 1.0]], by_bound: [0.0; 2] };
        }
        Self::of_sliding(q.map(|q| q / length), bound / length)
    }

    /// Of a cell that slides in a direction, with the ratio of its bound to the size of the pull,
    /// both dimensionless.
    pub fn of_sliding(n: [f64; 2], across: f64) -> Self {
        let mixed = -across * n[0] * n[1];
        let by_pull = [[across * n[1] * n[1], mixed], [mixed, across * n[0] * n[0]]];
        Self { by_pull, by_bound: n }
    }

    /// Whether the cell slides.
    pub fn is_sliding(&self) -> bool {
        self.by_bound != [0.0; 2]
    }

    /// The local Jacobian 1 − P′ (1 − γ B), where `stiffening` is γ B of the cell alone;
    /// dimensionless.
    pub fn jacobian(&self, stiffening: &Matrix) -> Matrix {
        let [[xx, xy], [yx, yy]] = product_2x2(&self.by_pull, stiffening);
        let by = &self.by_pull;
        [[1.0 - by[0][0] + xx, xy - by[0][1]], [yx - by[1][0], 1.0 - by[1][1] + yy]]
    }
}

pub(in crate::rolling) fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// The derivatives against central differences, in stick and in slip.
    #[test]
    fn slopes_are_those_of_central_differences() {
        const H: f64 = 1e-5;
        for (q, bound) in [([0.3, -0.2], 0.5), ([0.3, -0.8], 0.5), ([-2.0, 1.0], 0.5)] {
            let slope = Slope::at(q, bound);
            assert_eq!(slope.is_sliding(), q[0].hypot(q[1]) > bound);
            for c in 0..2 {
                let moved = |h: f64| {
                    let mut q = q;
                    q[c] += h;
                    reduced(q, bound)
                };
                let (plus, minus) = (moved(H), moved(-H));
                let raised = [reduced(q, bound + H), reduced(q, bound - H)];
                for r in 0..2 {
                    let by_pull = (plus[r] - minus[r]) / (2.0 * H);
                    assert_relative_eq!(slope.by_pull[r][c], by_pull, epsilon = 1e-8);
                    let by_bound = (raised[0][r] - raised[1][r]) / (2.0 * H);
                    assert_relative_eq!(slope.by_bound[r], by_bound, epsilon = 1e-8);
                }
            }
        }
    }
}
