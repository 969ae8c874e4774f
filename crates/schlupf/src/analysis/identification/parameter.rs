//! The parameters that can be fitted.

use crate::interface::friction::FrictionConstant;
use crate::reporting::Quantity;

/// A constant that can be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Parameter {
    /// A constant of the friction law.
    Friction(FrictionConstant),
    /// k_c of the contact law, in 1/m.
    ContactStiffness,
    /// r.m.s. height of the combined roughness of both surfaces, from which k_c follows, in m.
    Roughness,
    /// Shear modulus of the layer between the surfaces, in Pa.
    LayerShearModulus,
    /// Its yield stress τ_c0, in Pa.
    LayerYieldStress,
    /// Its hardening k_τ, in Pa/m.
    LayerHardening,
    /// k_A of Polach's method, dimensionless.
    AreaAdhesion,
    /// k_S of Polach's method, dimensionless.
    AreaSlip,
}

/// How a fit scales a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scale {
    /// Relative changes: it is positive.
    Logarithmic,
    /// Absolute changes in a unit (in that of the parameter, if it is not dimensionless): it may be
    /// zero.
    Linear { unit: f64 },
}

/// The unit of a hardening, in Pa/m: layers of Hou et al. (1997) have 0.02 to 0.4 of it.
const HARDENING_UNIT: f64 = 1e12;

/// Smallest reference size of a parameter that may be zero, in its unit of absolute changes.
const NEXT_TO_NOTHING: f64 = 0.1;

impl Parameter {
    /// All parameters.
    pub fn all() -> impl Iterator<Item = Self> {
        let friction = FrictionConstant::ALL.into_iter().map(Self::Friction);
        friction.chain([
            Self::ContactStiffness,
            Self::Roughness,
            Self::LayerShearModulus,
            Self::LayerYieldStress,
            Self::LayerHardening,
            Self::AreaAdhesion,
            Self::AreaSlip,
        ])
    }

    /// The corresponding quantity.
    pub fn quantity(self) -> Quantity {
        match self {
            Self::Friction(constant) => constant.quantity(),
            Self::ContactStiffness => Quantity::ContactStiffness,
            Self::Roughness => Quantity::ContactRoughness,
            Self::LayerShearModulus => Quantity::LayerShearModulus,
            Self::LayerYieldStress => Quantity::LayerYieldStress,
            Self::LayerHardening => Quantity::LayerHardening,
            Self::AreaAdhesion => Quantity::PolachAreaAdhesion,
            Self::AreaSlip => Quantity::PolachAreaSlip,
        }
    }

    /// Smallest and largest admissible value in a fit, in its SI unit if it is not dimensionless:
    /// no contact of wheel and rail comes close to either.
    pub fn bounds(self) -> [f64; 2] {
        match self {
            Self::Friction(constant) => match constant {
                FrictionConstant::ColdCoefficient => [1e-3, 3.0],
                FrictionConstant::TemperatureAtZeroFriction
                | FrictionConstant::TemperatureRange => [1.0, 1e5],
                FrictionConstant::HalfSpeed | FrictionConstant::SecondHalfSpeed => [1e-4, 1e3],
                FrictionConstant::Decay => [1e-4, 1e4],
                FrictionConstant::LimitRatio => [0.0, 1.0],
                _ => [0.0, 3.0],
            },
            Self::ContactStiffness => [1e3, 1e11],
            Self::Roughness => [1e-10, 1e-2],
            Self::LayerShearModulus => [1e3, 1e14],
            Self::LayerYieldStress => [1e3, 1e13],
            Self::LayerHardening => [-1e13, 1e13],
            Self::AreaAdhesion | Self::AreaSlip => [1e-3, 1.0],
        }
    }

    /// Whether a bound (in its unit) is a natural bound of the constant, so that a fit may end
    /// there. The other bounds only limit the search.
    pub(super) fn may_end_at(self, bound: f64) -> bool {
        match self {
            Self::Friction(FrictionConstant::LimitRatio) => true,
            Self::AreaAdhesion | Self::AreaSlip => bound == 1.0,
            _ => bound == 0.0,
        }
    }

    pub(super) fn scale(self) -> Scale {
        match self {
            _ if self.bounds()[0] > 0.0 => Scale::Logarithmic,
            Self::LayerHardening => Scale::Linear { unit: HARDENING_UNIT },
            _ => Scale::Linear { unit: 1.0 },
        }
    }

    /// Reference size for its uncertainty, in its unit: its value, or the smallest reference size.
    pub(super) fn size(self, value: f64) -> f64 {
        match self.scale() {
            Scale::Logarithmic => value,
            Scale::Linear { unit } => value.abs().max(NEXT_TO_NOTHING * unit),
        }
    }
}

impl Scale {
    /// The value for a scaled coordinate, which is dimensionless and zero at the start.
    pub fn value(self, moved: f64, start: f64) -> f64 {
        match self {
            Self::Logarithmic => start * moved.exp(),
            Self::Linear { unit } => start + unit * moved,
        }
    }

    /// The scaled coordinate (dimensionless) of a value.
    pub fn moved(self, value: f64, start: f64) -> f64 {
        match self {
            Self::Logarithmic => (value / start).ln(),
            Self::Linear { unit } => (value - start) / unit,
        }
    }

    /// Derivative of the value with respect to the coordinate, in the unit of the value if that is
    /// not dimensionless.
    pub fn slope(self, value: f64) -> f64 {
        match self {
            Self::Logarithmic => value,
            Self::Linear { unit } => unit,
        }
    }
}

/// As its quantity.
#[cfg(feature = "serde")]
impl serde::Serialize for Parameter {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.quantity().serialize(serializer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_the_scale_is_that_of_its_value() {
        for parameter in Parameter::all() {
            let scale = parameter.scale();
            let [low, high] = parameter.bounds();
            let start = 0.9 * low + 0.1 * high;
            assert_eq!(scale.value(0.0, start), start, "{parameter:?}");
            assert_eq!(scale.moved(start, start), 0.0, "{parameter:?}");
            let (at, step) = (0.3, 1e-6);
            let [plus, minus] = [at + step, at - step].map(|moved| scale.value(moved, start));
            let slope = (plus - minus) / (2.0 * step);
            let exact = scale.slope(scale.value(at, start));
            assert!((slope / exact - 1.0).abs() < 1e-8, "{parameter:?}");
        }
    }
}
