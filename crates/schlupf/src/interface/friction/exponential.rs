//! Friction that falls exponentially with the slip speed.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::slip_terms::SlipTerms;
use super::{FrictionLaw, FrictionResponse, FrictionState};
use crate::reporting::Error;

/// μ = μ_kin + μ1 2^(−s/s1) + μ2 2^(−s/s2), with s the slip speed, μ1 = μ0 − μ_kin − μ2; each term
/// halves with every further s1 or s2.
///
/// Source: Vollebregt, User guide for CONTACT, "Slip velocity dependent friction", L = 4. With one
/// term it is the law of [`super::Polach`]. Limits: μ follows the slip speed immediately, so that
/// it jumps at the onset of sliding; neither term may increase.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, Exponential, SlipTerms};
///
/// let law = Exponential(SlipTerms::new(0.4, 0.2, 1.5, None)?);
/// let state = FrictionState { slip_speed: 1.5, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.3).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponential(pub SlipTerms);

impl FrictionLaw for Exponential {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        self.0.respond(state.slip_speed, [halving; 2])
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for Exponential {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        self.0.constants()
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        Ok(Arc::new(Self(self.0.with_constants(changes)?)))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        self.0.by_constant(constant, state.slip_speed, [halving; 2])
    }
}

/// 2^(−x).
fn halving(x: f64) -> [f64; 2] {
    let shape = (-x).exp2();
    [shape, -std::f64::consts::LN_2 * shape]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::friction::SecondTerm;
    use approx::assert_relative_eq;

    fn at(law: &Exponential, slip_speed: f64) -> f64 {
        law.respond(&FrictionState { slip_speed, ..FrictionState::default() }).coefficient
    }

    /// Vollebregt, User guide for CONTACT, figure of the laws: μ_kin = μ1 = 0.15, half at 3 m/s.
    #[test]
    fn vollebregt_half_speeds() {
        let law = Exponential(SlipTerms::new(0.3, 0.15, 3.0, None).unwrap());
        for (speed, expected) in [(0.0, 0.3), (3.0, 0.225), (6.0, 0.1875), (1e4, 0.15)] {
            assert_relative_eq!(at(&law, speed), expected, max_relative = 1e-14);
        }
        let second = Some(SecondTerm { coefficient: 0.05, half_speed: 0.5 });
        let law = Exponential(SlipTerms::new(0.3, 0.15, 3.0, second).unwrap());
        assert_relative_eq!(at(&law, 0.0), 0.3, max_relative = 1e-14);
        assert_relative_eq!(at(&law, 3.0), 0.15 + 0.1 / 2.0 + 0.05 / 64.0, max_relative = 1e-14);
    }
}
