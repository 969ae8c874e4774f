//! Algebra of physical dimensions.

use std::fmt;
use std::ops::Mul;

/// Exponents of the base units.
///
/// The angle is a base dimension here, so that `"1/s"` or `"Hz"` is not taken for `"rad/s"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dimension {
    /// Exponent of the metre.
    pub length: i32,
    /// Exponent of the kilogram.
    pub mass: i32,
    /// Exponent of the second.
    pub time: i32,
    /// Exponent of the kelvin.
    pub temperature: i32,
    /// Exponent of the radian.
    pub angle: i32,
}

impl Dimension {
    /// Of a pure number.
    pub const NONE: Self = Self::mechanical(0, 0, 0);
    /// Of a length.
    pub const LENGTH: Self = Self::mechanical(1, 0, 0);
    /// Of a mass.
    pub const MASS: Self = Self::mechanical(0, 1, 0);
    /// Of a time.
    pub const TIME: Self = Self::mechanical(0, 0, 1);
    /// Of a temperature difference.
    pub const TEMPERATURE: Self = Self { temperature: 1, ..Self::NONE };
    /// Of an angle.
    pub const ANGLE: Self = Self { angle: 1, ..Self::NONE };
    /// Of a force.
    pub const FORCE: Self = Self::mechanical(1, 1, -2);
    /// Of a pressure.
    pub const PRESSURE: Self = Self::mechanical(-1, 1, -2);
    /// Of an energy.
    pub const ENERGY: Self = Self::mechanical(2, 1, -2);
    /// Of a power.
    pub const POWER: Self = Self::mechanical(2, 1, -3);

    /// Product of powers of metre, kilogram and second.
    pub const fn mechanical(length: i32, mass: i32, time: i32) -> Self {
        Self { length, mass, time, temperature: 0, angle: 0 }
    }

    /// This dimension to an integer power.
    pub const fn power(self, exponent: i32) -> Self {
        Self {
            length: self.length * exponent,
            mass: self.mass * exponent,
            time: self.time * exponent,
            temperature: self.temperature * exponent,
            angle: self.angle * exponent,
        }
    }
}

impl Mul for Dimension {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            length: self.length + other.length,
            mass: self.mass + other.mass,
            time: self.time + other.time,
            temperature: self.temperature + other.temperature,
            angle: self.angle + other.angle,
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bases = [
            ("kg", self.mass),
            ("m", self.length),
            ("s", self.time),
            ("K", self.temperature),
            ("rad", self.angle),
        ];
        let factors: Vec<String> = bases
            .iter()
            .filter(|(_, exponent)| *exponent != 0)
            .map(|(base, exponent)| match exponent {
                1 => (*base).to_owned(),
                _ => format!("{base}^{exponent}"),
            })
            .collect();
        if factors.is_empty() { f.write_str("1") } else { f.write_str(&factors.join(" ")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn force_times_length_is_energy() {
        assert_eq!(Dimension::FORCE * Dimension::LENGTH, Dimension::ENERGY);
        assert_eq!(Dimension::ENERGY * Dimension::TIME.power(-1), Dimension::POWER);
        assert_eq!(Dimension::FORCE * Dimension::LENGTH.power(-2), Dimension::PRESSURE);
    }

    #[test]
    fn it_prints_in_base_units() {
        assert_eq!(Dimension::PRESSURE.to_string(), "kg m^-1 s^-2");
        assert_eq!(Dimension::NONE.to_string(), "1");
    }
}
