//! Friction that falls exponentially with the slip speed, with the parameters of Polach.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::{FrictionLaw, FrictionResponse, FrictionState, require_coefficient};
use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// μ = μ0 ((1 − A) e^(−B s) + A), with s the slip speed.
///
/// Source: Polach, Creep forces in simulations of traction vehicles running on adhesion limit, Wear
/// 258 (2005) 992–1000, with typical values for real vehicles: dry μ0 = 0.55, A = 0.40, B = 0.60
/// s/m, wet μ0 = 0.30, A = 0.40, B = 0.20 s/m. Limits: in the source s is the slip speed of the
/// whole contact, here that of each point, so that points that stick have μ0; B includes the
/// decrease due to heating, which an additional temperature law would count twice.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, Polach};
///
/// let law = Polach::new(0.55, 0.4, 0.6)?;
/// let state = FrictionState { slip_speed: 1e3, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.55 * 0.4).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polach {
    coefficient: f64,
    limit_ratio: f64,
    decay: f64,
}

impl Polach {
    /// μ0 (dimensionless), A = μ(∞)/μ0 (dimensionless), B (in s/m).
    pub fn new(coefficient: f64, limit_ratio: f64, decay: f64) -> Result<Self, Error> {
        require_coefficient(coefficient)?;
        require(Quantity::LimitRatio, Requirement::Between(0.0, 1.0), limit_ratio)?;
        require_positive(Quantity::Decay, decay)?;
        Ok(Self { coefficient, limit_ratio, decay })
    }
}

impl FrictionLaw for Polach {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let falling = (1.0 - self.limit_ratio) * (-self.decay * state.slip_speed).exp();
        let ratio = falling + self.limit_ratio;
        FrictionResponse {
            coefficient: self.coefficient * ratio,
            by_slip_speed: -self.coefficient * self.decay * falling,
            by_cold_coefficient: ratio,
            ..FrictionResponse::default()
        }
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for Polach {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        vec![
            (FrictionConstant::ColdCoefficient, self.coefficient),
            (FrictionConstant::LimitRatio, self.limit_ratio),
            (FrictionConstant::Decay, self.decay),
        ]
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        Ok(Arc::new(Self::new(
            changes.of(FrictionConstant::ColdCoefficient, self.coefficient),
            changes.of(FrictionConstant::LimitRatio, self.limit_ratio),
            changes.of(FrictionConstant::Decay, self.decay),
        )?))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        let fade = (-self.decay * state.slip_speed).exp();
        let fall = (1.0 - self.limit_ratio) * fade;
        match constant {
            FrictionConstant::ColdCoefficient => fall + self.limit_ratio,
            FrictionConstant::LimitRatio => self.coefficient * (1.0 - fade),
            FrictionConstant::Decay => -self.coefficient * state.slip_speed * fall,
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::exponential::Exponential;
    use super::*;
    use crate::interface::friction::SlipTerms;
    use approx::assert_relative_eq;

    fn at(law: &dyn FrictionLaw, slip_speed: f64) -> f64 {
        law.respond(&FrictionState { slip_speed, ..FrictionState::default() }).coefficient
    }

    /// Polach 2005, typical parameters: from 0.55 to 0.22 on dry rails, from 0.30 to 0.12 on wet
    /// ones. The value at 1 m/s is 0.55 (0.6 · 0.5488116 + 0.4).
    #[test]
    fn polach_2005_dry_and_wet() {
        let dry = Polach::new(0.55, 0.40, 0.60).unwrap();
        assert_relative_eq!(at(&dry, 0.0), 0.55, max_relative = 1e-14);
        assert_relative_eq!(at(&dry, 1.0), 0.401_107_84, max_relative = 1e-8);
        assert_relative_eq!(at(&dry, 1e3), 0.22, max_relative = 1e-14);
        let wet = Polach::new(0.30, 0.40, 0.20).unwrap();
        assert_relative_eq!(at(&wet, 0.0), 0.30, max_relative = 1e-14);
        assert_relative_eq!(at(&wet, 1e3), 0.12, max_relative = 1e-14);
    }

    /// Vollebregt, User guide for CONTACT: Polach's law is the exponential one with μ_kin = A μ0
    /// and the half speed ln 2/B.
    #[test]
    fn vollebregt_polach_is_exponential() {
        let (polach, half_speed) = (Polach::new(0.55, 0.4, 0.6).unwrap(), 2.0_f64.ln() / 0.6);
        let exponential = Exponential(SlipTerms::new(0.55, 0.22, half_speed, None).unwrap());
        for speed in [0.0, 0.1, 1.0, 10.0] {
            assert_relative_eq!(at(&polach, speed), at(&exponential, speed), max_relative = 1e-14);
        }
    }

    #[test]
    fn impossible_constants_are_named() {
        let message = |m0, ratio, decay| Polach::new(m0, ratio, decay).unwrap_err().to_string();
        assert!(message(-0.1, 0.4, 0.6).starts_with("friction_coefficient"));
        assert!(message(0.55, -0.1, 0.6).starts_with("limit_ratio"));
        assert!(message(0.55, 1.1, 0.6).contains("between 0 and 1, but is 1.1"));
        assert!(message(0.55, 0.4, 0.0).starts_with("decay"));
        assert!(message(0.55, 0.4, f64::INFINITY).contains("inf s/m"));
    }
}
