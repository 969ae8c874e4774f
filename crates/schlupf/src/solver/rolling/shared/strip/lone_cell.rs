//! A cell that its own traction alone displaces.

use crate::solver::rolling::shared::cell::{inverse_2x2, times};

use super::resolvent::Resolvent;

/// The equation p = R(p + γ (v₀ − C p)) of a cell.
#[derive(Debug, Clone, Copy)]
pub(in crate::solver::rolling) struct LoneCell {
    /// γ v₀, in Pa.
    pub sliding: [f64; 2],
    /// γ C of both components, dimensionless.
    pub stiffening: [f64; 2],
    /// μ pₙ, in Pa.
    pub bound: f64,
}

impl LoneCell {
    /// Solves for p (in Pa), in place, given R. With γ times the mean of C near one Newton's method
    /// converges in a few steps. Where it does not, p is left as it is.
    pub fn solve(&self, p: &mut [f64], resolvent: impl Fn([f64; 2]) -> Resolvent) {
        let Self { sliding, stiffening, bound } = *self;
        let start = [p[0], p[1]];
        let diagonal = [[stiffening[0], 0.0], [0.0, stiffening[1]]];
        for _ in 0..f64::MANTISSA_DIGITS {
            let trial = [0, 1].map(|c| p[c] + sliding[c] - stiffening[c] * p[c]);
            let resolvent = resolvent(trial);
            let left = [0, 1].map(|c| p[c] - resolvent.traction[c]);
            let step = times(&inverse_2x2(resolvent.jacobian(&diagonal)), left);
            for c in 0..2 {
                p[c] -= step[c];
            }
            // The next step would be as small as the square of this one.
            if step[0].hypot(step[1]) <= f64::EPSILON.sqrt() * bound {
                return;
            }
        }
        p.copy_from_slice(&start);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::rolling::shared::strip::BristleState;

    /// Cells of unlike stiffnesses, from the traction of any earlier motion, under Coulomb's law
    /// and with bristles: p is what R makes of it.
    #[test]
    fn cells_are_solved_from_anywhere() {
        let mut seed = 1_u64;
        let mut random = |low: f64, high: f64| {
            seed = seed * 48_271 % 2_147_483_647;
            low + (high - low) * seed as f64 / 2_147_483_647.0
        };
        let mut unsolved = 0;
        for _ in 0..20_000 {
            let first = random(0.02, 1.98);
            let stiffening = [first, 2.0 - first];
            let sliding = [random(-1.0, 1.0), random(-1.0, 1.0)].map(|s: f64| 3.0 * s.powi(3));
            let mut p = [random(-0.7, 0.7), random(-0.7, 0.7)];
            let bristles = BristleState {
                compliance: if random(0.0, 1.0) < 0.5 { 0.0 } else { random(0.0, 1.0).powi(4) },
                own: 1.0,
                upstream: [random(-0.7, 0.7), random(-0.7, 0.7)],
                order: 1,
                ..BristleState::default()
            };
            let resolvent = |trial| Resolvent::at(trial, 1.0, &bristles);
            LoneCell { sliding, stiffening, bound: 1.0 }.solve(&mut p, resolvent);
            let trial = [0, 1].map(|c| p[c] + sliding[c] - stiffening[c] * p[c]);
            let made = resolvent(trial).traction;
            if (p[0] - made[0]).hypot(p[1] - made[1]) > 1e-12 {
                unsolved += 1;
            }
        }
        assert_eq!(unsolved, 0);
    }
}
