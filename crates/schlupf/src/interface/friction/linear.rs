//! Friction that falls linearly with the slip speed, down to a floor.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::slip_terms::SlipTerms;
use super::{FrictionLaw, FrictionResponse, FrictionState};
use crate::reporting::Error;

/// μ = μ_kin + μ1 max(0, 1 − s/2s1) + μ2 max(0, 1 − s/2s2), with s the slip speed, μ1 = μ0 − μ_kin
/// − μ2; the terms have halved at s1 and s2 and vanish at twice these speeds, where μ_kin remains.
///
/// Source: Vollebregt, User guide for CONTACT, "Slip velocity dependent friction", L = 2. Limits: μ
/// follows the slip speed immediately, so that it jumps at the onset of sliding; neither term may
/// increase.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, Linear, SlipTerms};
///
/// let law = Linear(SlipTerms::new(0.4, 0.2, 1.5, None)?);
/// let state = FrictionState { slip_speed: 1.5, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.3).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear(pub SlipTerms);

impl FrictionLaw for Linear {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        self.0.respond(state.slip_speed, [ramp; 2])
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for Linear {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        self.0.constants()
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        Ok(Arc::new(Self(self.0.with_constants(changes)?)))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        self.0.by_constant(constant, state.slip_speed, [ramp; 2])
    }
}

/// max(0, 1 − x/2).
fn ramp(x: f64) -> [f64; 2] {
    if x < 2.0 { [1.0 - 0.5 * x, -0.5] } else { [0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::friction::SecondTerm;
    use approx::assert_relative_eq;

    fn at(law: &Linear, slip_speed: f64) -> f64 {
        law.respond(&FrictionState { slip_speed, ..FrictionState::default() }).coefficient
    }

    /// Vollebregt, User guide for CONTACT, figure of the laws: μ_kin = μ1 = 0.15, half at 3 m/s.
    #[test]
    fn vollebregt_half_speeds() {
        let law = Linear(SlipTerms::new(0.3, 0.15, 3.0, None).unwrap());
        for (speed, expected) in
            [(0.0, 0.3), (1.5, 0.2625), (3.0, 0.225), (6.0, 0.15), (99.0, 0.15)]
        {
            assert_relative_eq!(at(&law, speed), expected, max_relative = 1e-14);
        }
        let second = Some(SecondTerm { coefficient: 0.1, half_speed: 0.5 });
        let law = Linear(SlipTerms::new(0.3, 0.15, 3.0, second).unwrap());
        assert_relative_eq!(at(&law, 0.5), 0.15 + 0.05 * 11.0 / 12.0 + 0.05, max_relative = 1e-14);
        assert_relative_eq!(at(&law, 3.0), 0.175, max_relative = 1e-14);
    }

    /// Without a floor of its own the law ends at zero, not below.
    #[test]
    fn friction_without_a_floor_vanishes_and_is_never_negative() {
        let law = Linear(SlipTerms::new(0.3, 0.0, 1.0, None).unwrap());
        assert_eq!([at(&law, 2.0), at(&law, 50.0)], [0.0, 0.0]);
    }
}
