//! What a field of a case file measures, and in which units it may be given.

use super::dimension::Dimension;

/// A kind of quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// Its name with an article, such as `a speed`.
    pub name: &'static str,
    /// The SI unit that values are converted to.
    pub unit: &'static str,
    /// Units it may be given in, for messages; any of the same dimension is accepted.
    pub examples: &'static str,
    /// What a unit must be to fit.
    pub scale: Scale,
}

/// How the values of a measure are laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Multiples of a unit of this dimension.
    Ratio(Dimension),
    /// The same, in which an angle may be named or not: 1/m is rad/m.
    Turning(Dimension),
    /// Absolute temperatures, each unit with its own zero; converted to degC.
    AbsoluteTemperature,
    /// Levels, in decibels alone.
    Level,
}

impl Scale {
    /// Whether a unit of a dimension fits.
    pub fn takes(self, dimension: Dimension) -> bool {
        match self {
            Self::Ratio(own) => own == dimension,
            Self::Turning(own) => [own, own * Dimension::ANGLE].contains(&dimension),
            Self::AbsoluteTemperature | Self::Level => false,
        }
    }
}

const fn ratio(
    name: &'static str,
    unit: &'static str,
    examples: &'static str,
    dimension: Dimension,
) -> Measure {
    Measure { name, unit, examples, scale: Scale::Ratio(dimension) }
}

impl Measure {
    /// The units that it is given in as a rule.
    pub fn units(&self) -> impl Iterator<Item = &'static str> {
        self.examples.split(", ").flat_map(|units| units.split(" or "))
    }

    /// All that have a dimension.
    pub const RATIOS: [Self; 19] = [
        Self::LENGTH,
        Self::TIME,
        Self::ANGLE,
        Self::SPEED,
        Self::FORCE,
        Self::PRESSURE,
        Self::AREA,
        Self::STIFFNESS,
        Self::BEDDING,
        Self::DENSITY,
        Self::PER_LENGTH,
        Self::SPIN,
        Self::PER_SPEED,
        Self::ANGULAR_VELOCITY,
        Self::CONDUCTIVITY,
        Self::SPECIFIC_HEAT,
        Self::HEAT_TRANSFER,
        Self::WEAR_RATE,
        Self::TEMPERATURE_DIFFERENCE,
    ];

    /// Speed, in m/s.
    pub const SPEED: Self = ratio("a speed", "m/s", "m/s or km/h", Dimension::mechanical(1, 0, -1));
    /// Length, in m.
    pub const LENGTH: Self = ratio("a length", "m", "m, mm or µm", Dimension::LENGTH);
    /// Time, in s.
    pub const TIME: Self = ratio("a time", "s", "s or ms", Dimension::TIME);
    /// Angle, in rad.
    pub const ANGLE: Self = ratio("an angle", "rad", "deg, rad or mrad", Dimension::ANGLE);
    /// Angular velocity, in rad/s.
    pub const ANGULAR_VELOCITY: Self = ratio(
        "an angular velocity",
        "rad/s",
        "rad/s, deg/s or rpm",
        Dimension { angle: 1, time: -1, ..Dimension::NONE },
    );
    /// Inverse length, in 1/m.
    pub const PER_LENGTH: Self =
        ratio("an inverse length", "1/m", "1/m or 1/mm", Dimension::LENGTH.power(-1));
    /// Spin creepage: an angle per length rolled, in 1/m.
    pub const SPIN: Self = Self {
        name: "an inverse length or an angle per length",
        unit: "1/m",
        examples: "1/m, rad/m or 1/mm",
        scale: Scale::Turning(Dimension::LENGTH.power(-1)),
    };
    /// Inverse speed, in s/m.
    pub const PER_SPEED: Self =
        ratio("an inverse speed", "s/m", "s/m or h/km", Dimension::mechanical(-1, 0, 1));
    /// Force, in N.
    pub const FORCE: Self = ratio("a force", "N", "N or kN", Dimension::FORCE);
    /// Torque or moment, in N m.
    pub const TORQUE: Self = ratio("a torque", "N m", "N m or kN m", Dimension::ENERGY);
    /// Pressure or modulus, in Pa.
    pub const PRESSURE: Self = ratio("a pressure", "Pa", "Pa, MPa or GPa", Dimension::PRESSURE);
    /// Stiffness, in N/m.
    pub const STIFFNESS: Self =
        ratio("a stiffness", "N/m", "N/m or kN/mm", Dimension::mechanical(0, 1, -2));
    /// Stiffness per area, in N/m³.
    pub const BEDDING: Self =
        ratio("a stiffness per area", "N/m^3", "N/m^3 or MPa/mm", Dimension::mechanical(-2, 1, -2));
    /// Thermal conductivity, in W/(m K).
    pub const CONDUCTIVITY: Self = ratio(
        "a thermal conductivity",
        "W/(m K)",
        "W/(m K)",
        Dimension { length: 1, mass: 1, time: -3, temperature: -1, angle: 0 },
    );
    /// Density, in kg/m³.
    pub const DENSITY: Self =
        ratio("a density", "kg/m^3", "kg/m^3 or g/cm^3", Dimension::mechanical(-3, 1, 0));
    /// Specific heat, in J/(kg K).
    pub const SPECIFIC_HEAT: Self = ratio(
        "a specific heat",
        "J/(kg K)",
        "J/(kg K) or kJ/(kg K)",
        Dimension { length: 2, time: -2, temperature: -1, ..Dimension::NONE },
    );
    /// Heat transfer coefficient, in W/(m² K).
    pub const HEAT_TRANSFER: Self = ratio(
        "a heat transfer coefficient",
        "W/(m^2 K)",
        "W/(m^2 K)",
        Dimension { mass: 1, time: -3, temperature: -1, ..Dimension::NONE },
    );
    /// Mass worn per dissipated energy, in kg/J.
    pub const WEAR_RATE: Self = ratio(
        "a mass per energy",
        "kg/J",
        "ug/J or ug/(N m)",
        Dimension { length: -2, time: 2, ..Dimension::NONE },
    );
    /// Area, in m².
    pub const AREA: Self = ratio("an area", "m^2", "m^2 or cm^2", Dimension::LENGTH.power(2));
    /// Temperature difference, in K.
    pub const TEMPERATURE_DIFFERENCE: Self =
        ratio("a temperature difference", "K", "K", Dimension::TEMPERATURE);
    /// Absolute temperature, in degC.
    pub const TEMPERATURE: Self = Self {
        name: "a temperature",
        unit: "degC",
        examples: "degC, K or degF",
        scale: Scale::AbsoluteTemperature,
    };
    /// Level of a height, in dB re 1 µm.
    pub const LEVEL: Self =
        Self { name: "a level", unit: "dB", examples: "dB", scale: Scale::Level };
}
