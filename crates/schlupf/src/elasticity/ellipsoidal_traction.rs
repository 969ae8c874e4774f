//! Displacement of the half-space under a tangential traction that is distributed like the pressure
//! of Hertz, in closed form.

use std::f64::consts::PI;

/// The displacement under t = t0 √(1 − x²/a² − y²/b²), inside the ellipse a quadratic function of
/// the position (Vermeulen and Johnson 1964; Kalker 1990, §3.2).
///
/// Every direction θ contributes the integral of t along the line through the point, weighted by
/// f(θ); with tan θ = (b/a) tan ψ and r² = a² cos²ψ + b² sin²ψ this is
///
/// U = t0 ab/(2G) ∫₀^π f(θ)/r (1 − (x sin ψ/a − y cos ψ/b)²) dψ,
///
/// f_xx = 1 − ν + ν cos²θ, f_yy = 1 − ν + ν sin²θ, f_xy = ν sin θ cos θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipsoidalTraction {
    semi_axes: [f64; 2],
    /// Coefficients of 1, (x/a)² and (y/b)² in u_x under t_x and in u_y under t_y, in m/Pa.
    along: [f64; 3],
    across: [f64; 3],
    /// Coefficient of xy/(ab) in u_y under t_x, in m/Pa.
    mixed: f64,
}

/// Directions of the integral, which converges exponentially.
const DIRECTIONS: u32 = 400;

impl EllipsoidalTraction {
    /// On a half-space of shear modulus G (in Pa) and Poisson's ratio ν (dimensionless), on an
    /// ellipse with semi-axes a and b (in m).
    pub fn new(shear_modulus: f64, poisson_ratio: f64, [a, b]: [f64; 2]) -> Self {
        let [mut along, mut across] = [[0.0; 3]; 2];
        let mut mixed = 0.0;
        let step = PI / f64::from(DIRECTIONS);
        let factor = a * b / (2.0 * shear_modulus) * step;
        for direction in 0..DIRECTIONS {
            let (sin, cos) = ((f64::from(direction) + 0.5) * step).sin_cos();
            let r = (a * cos).hypot(b * sin);
            let [cos_theta, sin_theta] = [a * cos / r, b * sin / r];
            let share = factor / r;
            let powers = [1.0, -sin * sin, -cos * cos].map(|power| share * power);
            let straight = 1.0 - poisson_ratio;
            for (power, (along, across)) in powers.iter().zip(along.iter_mut().zip(&mut across)) {
                *along += power * (straight + poisson_ratio * cos_theta * cos_theta);
                *across += power * (straight + poisson_ratio * sin_theta * sin_theta);
            }
            mixed += 2.0 * share * sin * cos * poisson_ratio * sin_theta * cos_theta;
        }
        Self { semi_axes: [a, b], along, across, mixed }
    }

    /// u_x under t_x, u_y under t_y, and u_y under t_x or u_x under t_y (in m) at a point (in m)
    /// for the largest traction t0 (in Pa). A point outside the ellipse is moved to its edge,
    /// towards the centre.
    pub fn displacement(&self, peak: f64, [x, y]: [f64; 2]) -> [f64; 3] {
        let [x, y] = [x / self.semi_axes[0], y / self.semi_axes[1]];
        let outside = x.hypot(y).max(1.0);
        let [x, y] = [x / outside, y / outside];
        let at = |c: &[f64; 3]| peak * (c[0] + c[1] * x * x + c[2] * y * y);
        [at(&self.along), at(&self.across), peak * self.mixed * x * y]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Mindlin 1949; Johnson 1985, Eq. (7.36): on a circle of radius a, u_x = π t0/(32 G a) (4 (2 −
    /// ν) a² − (4 − 3ν) x² − (4 − ν) y²), u_y = π t0/(32 G a) 2ν xy, for one body of shear modulus
    /// G. Ours is the sum of both bodies, with 1/G the mean of theirs: twice as much.
    #[test]
    fn mindlin_1949_circle() {
        let (a, nu, shear) = (5e-3, 0.28, 82e9);
        let circle = EllipsoidalTraction::new(shear, nu, [a, a]);
        for [x, y] in [[0.0, 0.0], [2e-3, -1e-3], [-3e-3, 4e-3]] {
            let factor = 2.0 * PI * 1e9 / (32.0 * shear * a);
            let along = 4.0 * (2.0 - nu) * a * a - (4.0 - 3.0 * nu) * x * x - (4.0 - nu) * y * y;
            let across = 4.0 * (2.0 - nu) * a * a - (4.0 - 3.0 * nu) * y * y - (4.0 - nu) * x * x;
            let [xx, yy, xy] = circle.displacement(1e9, [x, y]);
            assert_relative_eq!(xx, factor * along, max_relative = 1e-12);
            assert_relative_eq!(yy, factor * across, max_relative = 1e-12);
            assert_relative_eq!(xy, factor * 2.0 * nu * x * y, epsilon = 1e-18);
        }
    }
}
