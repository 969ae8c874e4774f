//! Two terms that fall with the slip speed, shared by three friction laws.

use super::constants::{Changes, FrictionConstant};
use super::{FrictionResponse, require_below, require_coefficient};
use crate::reporting::{Error, Quantity, require_positive};

/// Relative tolerance by which sums of coefficients may exceed μ0: decimal numbers add up with
/// rounding error.
const ROUNDING: f64 = 1e-12;

/// The second term of a law μ_kin + μ1 f1(s/s1) + μ2 f2(s/s2) of the slip speed s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondTerm {
    /// μ2, its size without slip, dimensionless.
    pub coefficient: f64,
    /// s2, the slip speed at which it has halved, in m/s.
    pub half_speed: f64,
}

/// A function of s/s_half with f(0) = 1 and f(1) = ½, and its derivative.
pub(super) type Shape = fn(f64) -> [f64; 2];

/// The constants of a law μ = μ_kin + μ1 f1(s/s1) + μ2 f2(s/s2), where μ1 = μ0 − μ_kin − μ2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipTerms {
    coefficient: f64,
    kinetic_coefficient: f64,
    half_speed: f64,
    second: SecondTerm,
}

impl SlipTerms {
    /// Terms with μ0 and μ_kin, dimensionless; s1, in m/s; the second term, if any. Friction cannot
    /// become negative: μ_kin ≥ 0, and both terms are at least zero.
    pub fn new(
        coefficient: f64,
        kinetic_coefficient: f64,
        half_speed: f64,
        second: Option<SecondTerm>,
    ) -> Result<Self, Error> {
        require_coefficient(coefficient)?;
        require_below(Quantity::KineticCoefficient, kinetic_coefficient, coefficient)?;
        require_positive(Quantity::HalfSpeed, half_speed)?;
        let second = second.unwrap_or(SecondTerm { coefficient: 0.0, half_speed });
        let left = coefficient - kinetic_coefficient + ROUNDING * coefficient;
        if !(0.0..=left).contains(&second.coefficient) {
            let (second, kinetic) = (second.coefficient, kinetic_coefficient);
            return Err(Error::SecondTerm { second, coefficient, kinetic });
        }
        require_positive(Quantity::SecondHalfSpeed, second.half_speed)?;
        Ok(Self { coefficient, kinetic_coefficient, half_speed, second })
    }

    /// The law at a slip speed, in m/s, with the shapes of both terms.
    pub(super) fn respond(&self, slip_speed: f64, shapes: [Shape; 2]) -> FrictionResponse {
        let second = self.second.coefficient;
        let first = (self.coefficient - self.kinetic_coefficient - second).max(0.0);
        let [shape, slope] = shapes[0](slip_speed / self.half_speed);
        let [second_shape, second_slope] = shapes[1](slip_speed / self.second.half_speed);
        FrictionResponse {
            coefficient: self.kinetic_coefficient + first * shape + second * second_shape,
            by_slip_speed: first * slope / self.half_speed
                + second * second_slope / self.second.half_speed,
            by_cold_coefficient: shape,
            ..FrictionResponse::default()
        }
    }

    /// The constants by name; those of the second term only if there is one.
    pub(super) fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        let mut constants = vec![
            (FrictionConstant::ColdCoefficient, self.coefficient),
            (FrictionConstant::KineticCoefficient, self.kinetic_coefficient),
            (FrictionConstant::HalfSpeed, self.half_speed),
        ];
        if self.second.coefficient > 0.0 {
            constants.push((FrictionConstant::SecondCoefficient, self.second.coefficient));
            constants.push((FrictionConstant::SecondHalfSpeed, self.second.half_speed));
        }
        constants
    }

    /// The same terms with other values.
    pub(super) fn with_constants(&self, changes: &Changes) -> Result<Self, Error> {
        let Self { second, .. } = self;
        let second = SecondTerm {
            coefficient: changes.of(FrictionConstant::SecondCoefficient, second.coefficient),
            half_speed: changes.of(FrictionConstant::SecondHalfSpeed, second.half_speed),
        };
        Self::new(
            changes.of(FrictionConstant::ColdCoefficient, self.coefficient),
            changes.of(FrictionConstant::KineticCoefficient, self.kinetic_coefficient),
            changes.of(FrictionConstant::HalfSpeed, self.half_speed),
            Some(second),
        )
    }

    /// Derivative of the law with respect to a constant, at a slip speed in m/s.
    pub(super) fn by_constant(
        &self,
        constant: FrictionConstant,
        slip_speed: f64,
        shapes: [Shape; 2],
    ) -> f64 {
        let first = self.coefficient - self.kinetic_coefficient - self.second.coefficient;
        let [x, second_x] = [slip_speed / self.half_speed, slip_speed / self.second.half_speed];
        let [shape, slope] = shapes[0](x);
        let [second_shape, second_slope] = shapes[1](second_x);
        match constant {
            FrictionConstant::ColdCoefficient => shape,
            FrictionConstant::KineticCoefficient => 1.0 - shape,
            FrictionConstant::HalfSpeed => -first.max(0.0) * slope * x / self.half_speed,
            FrictionConstant::SecondCoefficient => second_shape - shape,
            FrictionConstant::SecondHalfSpeed => {
                -self.second.coefficient * second_slope * second_x / self.second.half_speed
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0.5 − 0.4 is less than 0.1 in double precision.
    #[test]
    fn terms_may_add_up_to_the_whole() {
        let second = Some(SecondTerm { coefficient: 0.1, half_speed: 1.0 });
        let terms = SlipTerms::new(0.5, 0.4, 1.0, second).unwrap();
        let gone: Shape = |_| [0.0, 0.0];
        assert_eq!(terms.respond(1.0, [gone; 2]).coefficient, 0.4);
    }

    #[test]
    fn impossible_constants_are_named() {
        let message = |m0, kinetic, speed, second: Option<[f64; 2]>| {
            let second =
                second.map(|[coefficient, half_speed]| SecondTerm { coefficient, half_speed });
            SlipTerms::new(m0, kinetic, speed, second).unwrap_err().to_string()
        };
        assert!(message(0.0, 0.0, 1.0, None).starts_with("friction_coefficient"));
        assert!(message(0.4, -0.1, 1.0, None).contains("between 0 and friction_coefficient = 0.4"));
        assert!(message(0.4, 0.5, 1.0, None).starts_with("kinetic_coefficient"));
        assert!(message(0.4, 0.2, 0.0, None).starts_with("half_speed"));
        assert!(message(0.4, 0.2, f64::NAN, None).contains("NaN m/s"));
        let second = message(0.4, 0.3, 1.0, Some([0.2, 1.0]));
        assert!(second.starts_with("second_coefficient") && second.contains("0.4 - 0.3"));
        assert!(message(0.4, 0.3, 1.0, Some([-0.1, 1.0])).contains("but is -0.1"));
        let message = message(0.4, 0.3, 1.0, Some([0.1, -1.0]));
        assert!(message.starts_with("second_half_speed"));
    }
}
