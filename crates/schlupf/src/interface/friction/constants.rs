//! Constants of the friction laws, by name, for identification from measurements.

use std::sync::Arc;

use super::{FrictionLaw, FrictionState};
use crate::reporting::{Error, Quantity};

/// A constant of a friction law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FrictionConstant {
    /// μ0, of every law.
    ColdCoefficient,
    /// T_E, in K.
    TemperatureAtZeroFriction,
    /// Floor of a law that falls with temperature.
    MinimumCoefficient,
    /// μ_hot.
    HotCoefficient,
    /// ΔT, in K.
    TemperatureRange,
    /// μ_kin.
    KineticCoefficient,
    /// s1, in m/s.
    HalfSpeed,
    /// μ2.
    SecondCoefficient,
    /// s2, in m/s.
    SecondHalfSpeed,
    /// A of Polach.
    LimitRatio,
    /// B of Polach, in s/m.
    Decay,
}

impl FrictionConstant {
    /// All constants.
    pub const ALL: [Self; 11] = [
        Self::ColdCoefficient,
        Self::TemperatureAtZeroFriction,
        Self::MinimumCoefficient,
        Self::HotCoefficient,
        Self::TemperatureRange,
        Self::KineticCoefficient,
        Self::HalfSpeed,
        Self::SecondCoefficient,
        Self::SecondHalfSpeed,
        Self::LimitRatio,
        Self::Decay,
    ];

    /// The corresponding quantity.
    pub fn quantity(self) -> Quantity {
        match self {
            Self::ColdCoefficient => Quantity::FrictionCoefficient,
            Self::TemperatureAtZeroFriction => Quantity::TemperatureAtZeroFriction,
            Self::MinimumCoefficient => Quantity::MinimumCoefficient,
            Self::HotCoefficient => Quantity::HotCoefficient,
            Self::TemperatureRange => Quantity::TemperatureRange,
            Self::KineticCoefficient => Quantity::KineticCoefficient,
            Self::HalfSpeed => Quantity::HalfSpeed,
            Self::SecondCoefficient => Quantity::SecondCoefficient,
            Self::SecondHalfSpeed => Quantity::SecondHalfSpeed,
            Self::LimitRatio => Quantity::LimitRatio,
            Self::Decay => Quantity::Decay,
        }
    }
}

/// New values of some constants, in SI units or dimensionless.
#[derive(Debug, Clone, Copy)]
pub struct Changes<'a>(pub &'a [(FrictionConstant, f64)]);

impl Changes<'_> {
    /// The new value of a constant (in its SI unit, or dimensionless), or its present one.
    pub fn of(&self, constant: FrictionConstant, otherwise: f64) -> f64 {
        let change = self.0.iter().find(|(changed, _)| *changed == constant);
        change.map_or(otherwise, |(_, value)| *value)
    }
}

/// A friction law whose constants can be read and changed.
pub trait AdjustableFriction: Send + Sync {
    /// Its constants with their values, in SI units or dimensionless.
    fn constants(&self) -> Vec<(FrictionConstant, f64)>;

    /// The same law with other values. Constants that it does not have are ignored.
    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error>;

    /// ∂μ/∂constant at constant values of the others, in the reciprocal of its unit or
    /// dimensionless; zero for a constant that it does not have.
    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64;
}
