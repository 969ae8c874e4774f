//! Bristles in series with a slider: the incremental law with bristles that are stiff against the
//! cells.
//!
//! As long as |q| grows along its direction n, the law dq = k_c (ds − q |ds|) is
//! ds = (dq + n dz)/k_c with z = −ln(1 − |q|) − |q|: the sliding stretches the bristles. Where q
//! falls, only dq/k_c is taken off (along n, the law has (dq + q |dq|/(1 + |q|))/k_c); there and
//! where q turns the sliding differs by some 1/k_c. The law is rescaled so that |q| = 1 at
//! k_c s = 5, and the rest of the sliding is that of a slider with q = n. This rest is zero where
//! the contact sticks, and so as smooth along the path as the sliding under Coulomb's law, to which
//! it leads for k_c → ∞; the sliding itself jumps within a cell from the leading edge.

/// k_c s of a straight path at which |q| = 1, dimensionless: exp(−5) of the law is missing there,
/// and its initial slope is steeper by as much.
const LONGEST: f64 = 5.0;

/// Saturation (dimensionless) below which the direction fades: without traction there is none.
const FAINT: f64 = 1e-6;

/// The growth of z over a way; none where q falls.
///
/// Where z falls fast, the polynomial through earlier places may grow. Their part is then left out:
/// without traction nothing is stretched along n, wherever q comes from.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Growth {
    /// Dimensionless.
    pub value: f64,
    /// Whether it changes with z at the cell, and whether with z before.
    pub counts_here: bool,
    pub counts_before: bool,
}

impl Growth {
    /// Its change with those of both parts of the change of z, all dimensionless.
    pub fn change(&self, here: f64, before: f64) -> f64 {
        match (self.counts_here, self.counts_before) {
            (false, _) => 0.0,
            (true, false) => here,
            (true, true) => here + before,
        }
    }
}

/// The bristles of a cell under a traction.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Stretch {
    /// 1/(μ pₙ), in 1/Pa; of tractions beyond the bound, over their saturation.
    over_bound: f64,
    /// Whether the traction is beyond its bound, so that q is only its direction.
    is_beyond: bool,
    /// q, dimensionless.
    pub saturation: [f64; 2],
    /// n, dimensionless.
    pub direction: [f64; 2],
    /// |n|/|q|, dimensionless.
    turning: f64,
    /// z, dimensionless.
    pub excess: f64,
    /// dz/d|q|, dimensionless.
    slope: f64,
}

impl Stretch {
    /// Under a traction on the rail for a bound μ pₙ, both in Pa.
    pub fn of(traction: [f64; 2], bound: f64) -> Self {
        if bound <= 0.0 {
            return Self::default();
        }
        let length = (traction[0] * traction[0] + traction[1] * traction[1]).sqrt();
        let is_beyond = length > bound;
        let over_bound = length.max(bound).recip();
        let saturation = traction.map(|p| over_bound * p);
        let size = over_bound * length;
        let turning = (size * size + FAINT * FAINT).sqrt().recip();
        let reached = -(-LONGEST).exp_m1();
        let left = 1.0 - reached * size;
        Self {
            over_bound,
            is_beyond,
            saturation,
            direction: saturation.map(|q| turning * q),
            turning,
            excess: -(-reached * size).ln_1p() - size,
            slope: reached / left - 1.0,
        }
    }

    /// The part along n of what stretches the bristles over a way, from the parts of the change of
    /// z over it at the cell itself (and at a cell ahead) and at those before, all dimensionless.
    pub fn growth(here: f64, before: f64) -> Growth {
        let counts_before = before < 0.0;
        let change = if counts_before { here + before } else { here };
        Growth { value: change.max(0.0), counts_here: change > 0.0, counts_before }
    }

    /// Change of q (dimensionless) with those of the traction and of its bound, in Pa.
    pub fn saturation_change(&self, traction: [f64; 2], bound: f64) -> [f64; 2] {
        let grown = if self.is_beyond { self.along(traction) } else { bound };
        [0, 1].map(|c| self.over_bound * (traction[c] - self.saturation[c] * grown))
    }

    /// Change of z with that of q, both dimensionless.
    pub fn excess_change(&self, q: [f64; 2]) -> f64 {
        self.slope * self.along(q)
    }

    /// Change of n with that of q, both dimensionless.
    pub fn turn(&self, q: [f64; 2]) -> [f64; 2] {
        let along = self.along(q);
        [0, 1].map(|c| self.turning * (q[c] - along * self.direction[c]))
    }

    /// Change of |n| with that of |q|, both dimensionless.
    pub fn turn_of_size(&self, q: f64) -> f64 {
        let length = self.direction[0].hypot(self.direction[1]);
        self.turning * q * (1.0 - length * length)
    }

    fn along(&self, q: [f64; 2]) -> f64 {
        self.direction[0] * q[0] + self.direction[1] * q[1]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// The changes against central differences.
    #[test]
    fn changes_are_those_of_central_differences() {
        const H: f64 = 1e-4;
        for traction in [[30.0, -20.0], [0.1, 0.2], [-50.0, 60.0], [90.0, 5.0], [150.0, -80.0]] {
            let stretch = Stretch::of(traction, 100.0);
            for (by, raised) in [([1.0, 0.0], 0.0), ([0.0, 1.0], 0.0), ([0.0, 0.0], 1.0)] {
                let moved = |h: f64| {
                    let traction = [0, 1].map(|c| traction[c] + h * by[c]);
                    Stretch::of(traction, 100.0 + h * raised)
                };
                let (plus, minus) = (moved(H), moved(-H));
                let q = stretch.saturation_change(by, raised);
                let turn = stretch.turn(q);
                for c in 0..2 {
                    let change = (plus.saturation[c] - minus.saturation[c]) / (2.0 * H);
                    assert_relative_eq!(q[c], change, max_relative = 1e-6, epsilon = 1e-12);
                    let change = (plus.direction[c] - minus.direction[c]) / (2.0 * H);
                    assert_relative_eq!(turn[c], change, max_relative = 1e-4, epsilon = 1e-7);
                }
                let change = (plus.excess - minus.excess) / (2.0 * H);
                let found = stretch.excess_change(q);
                assert_relative_eq!(found, change, max_relative = 1e-4, epsilon = 1e-9);
            }
        }
    }

    /// On a straight path q = 1 − exp(−k_c s) over what is left at the end, as far as that.
    #[test]
    fn dahl_1968_straight_path() {
        for s in [0.01_f64, 0.3, 1.0, 2.5, LONGEST] {
            let q = (-s).exp_m1() / (-LONGEST).exp_m1();
            let stretch = Stretch::of([0.0, q], 1.0);
            assert_relative_eq!(q + stretch.excess, s, max_relative = 1e-12);
        }
    }
}
