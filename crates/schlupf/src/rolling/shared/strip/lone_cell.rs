//! A cell that its own traction alone displaces.

use crate::rolling::shared::cell::{inverse_2x2, times};

use super::resolvent::Resolvent;

/// Solves p = R(p + γ (v₀ − C p)), in place: with γ v₀ (in Pa), γ C of both components
/// (dimensionless), μ pₙ (in Pa) and R.
pub(in crate::rolling) fn solve_alone(
    p: &mut [f64],
    (sliding, stiffening, bound): ([f64; 2], [f64; 2], f64),
    resolvent: impl Fn([f64; 2]) -> Resolvent,
) {
    let diagonal = [[stiffening[0], 0.0], [0.0, stiffening[1]]];
    for _ in 0..f64::MANTISSA_DIGITS {
        let trial = [0, 1].map(|c| p[c] + sliding[c] - stiffening[c] * p[c]);
        let resolvent = resolvent(trial);
        let left = [0, 1].map(|c| p[c] - resolvent.traction[c]);
        let step = times(&inverse_2x2(resolvent.jacobian(&diagonal)), left);
        for c in 0..2 {
            p[c] -= step[c];
        }
        if step[0].hypot(step[1]) <= f64::EPSILON * bound {
            return;
        }
    }
}
