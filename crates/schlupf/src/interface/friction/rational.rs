//! Friction that falls as a rational function of the slip speed.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::slip_terms::SlipTerms;
use super::{FrictionLaw, FrictionResponse, FrictionState};
use crate::reporting::Error;

/// μ = μ_kin + μ1/(1 + s/s1) + μ2/(1 + (s/s2)²), with s the slip speed, μ1 = μ0 − μ_kin − μ2; the
/// terms have halved at s1 and s2.
///
/// Source: Vollebregt, User guide for CONTACT, "Slip velocity dependent friction", L = 3. The first
/// term falls from the start and slowly at large speeds, the second starts with zero slope. Limits:
/// μ follows the slip speed immediately, so that it jumps at the onset of sliding; neither term may
/// increase.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, Rational, SlipTerms};
///
/// let law = Rational(SlipTerms::new(0.4, 0.2, 1.5, None)?);
/// let state = FrictionState { slip_speed: 1.5, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.3).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rational(pub SlipTerms);

impl FrictionLaw for Rational {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        self.0.respond(state.slip_speed, [hyperbola, bell])
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for Rational {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        self.0.constants()
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        Ok(Arc::new(Self(self.0.with_constants(changes)?)))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        self.0.by_constant(constant, state.slip_speed, [hyperbola, bell])
    }
}

/// 1/(1 + x).
fn hyperbola(x: f64) -> [f64; 2] {
    let shape = 1.0 / (1.0 + x);
    [shape, -shape * shape]
}

/// 1/(1 + x²).
fn bell(x: f64) -> [f64; 2] {
    let shape = 1.0 / (1.0 + x * x);
    [shape, -2.0 * x * shape * shape]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::friction::SecondTerm;
    use approx::assert_relative_eq;

    fn at(law: &Rational, slip_speed: f64) -> f64 {
        law.respond(&FrictionState { slip_speed, ..FrictionState::default() }).coefficient
    }

    /// Vollebregt, User guide for CONTACT, figure of the laws: μ_kin = 0.15 and one term of 0.15,
    /// half at 3 m/s; at three times the speed the term is a quarter, and with the second kind a
    /// tenth.
    #[test]
    fn vollebregt_half_speeds() {
        let law = Rational(SlipTerms::new(0.3, 0.15, 3.0, None).unwrap());
        for (speed, expected) in [(0.0, 0.3), (3.0, 0.225), (9.0, 0.1875), (1e15, 0.15)] {
            assert_relative_eq!(at(&law, speed), expected, max_relative = 1e-14);
        }
        let second = Some(SecondTerm { coefficient: 0.15, half_speed: 3.0 });
        let law = Rational(SlipTerms::new(0.3, 0.15, 1.0, second).unwrap());
        for (speed, expected) in [(0.0, 0.3), (3.0, 0.225), (9.0, 0.165), (1e15, 0.15)] {
            assert_relative_eq!(at(&law, speed), expected, max_relative = 1e-14);
        }
    }
}
