//! Elastic and thermal constants of a body, and combined constants of two bodies.

use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// A homogeneous, isotropic, linearly elastic and heat-conducting material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E, in Pa.
    pub young_modulus: f64,
    /// Poisson's ratio ν, dimensionless, in [0, 0.5].
    pub poisson_ratio: f64,
    /// Thermal conductivity λ, in W/(m K).
    pub conductivity: f64,
    /// Density ρ, in kg/m³.
    pub density: f64,
    /// Specific heat c, in J/(kg K).
    pub specific_heat: f64,
}

impl Material {
    /// Wheel and rail steel: E = 210 GPa, ν = 0.28, λ = 50 W/(m K), ρ = 7850 kg/m³,
    /// c = 450 J/(kg K).
    pub const STEEL: Self = Self {
        young_modulus: 210.0e9,
        poisson_ratio: 0.28,
        conductivity: 50.0,
        density: 7850.0,
        specific_heat: 450.0,
    };

    /// Shear modulus G = E / (2 (1 + ν)), in Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.young_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }

    /// Thermal diffusivity κ = λ / (ρ c), in m²/s; Eq. (20).
    pub fn diffusivity(&self) -> f64 {
        self.conductivity / (self.density * self.specific_heat)
    }

    /// Thermal effusivity β = √(λ ρ c), in J/(m² K √s).
    pub fn effusivity(&self) -> f64 {
        (self.conductivity * self.density * self.specific_heat).sqrt()
    }

    fn check(&self, quantities: [Quantity; 5]) -> Result<(), Error> {
        let [young_modulus, poisson_ratio, conductivity, density, specific_heat] = quantities;
        require_positive(young_modulus, self.young_modulus)?;
        require(poisson_ratio, Requirement::Between(0.0, 0.5), self.poisson_ratio)?;
        require_positive(conductivity, self.conductivity)?;
        require_positive(density, self.density)?;
        require_positive(specific_heat, self.specific_heat)
    }
}

impl Default for Material {
    fn default() -> Self {
        Self::STEEL
    }
}

/// A wheel or rail: its material and its temperature far from the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// The material.
    pub material: Material,
    /// Temperature before it enters the contact, in degC.
    pub bulk_temperature: f64,
}

impl Body {
    /// Steel at 20 degC.
    pub const STEEL: Self = Self { material: Material::STEEL, bulk_temperature: 20.0 };

    /// Checks the constants of a wheel.
    pub fn check_wheel(&self) -> Result<(), Error> {
        self.material.check([
            Quantity::WheelYoungModulus,
            Quantity::WheelPoissonRatio,
            Quantity::WheelConductivity,
            Quantity::WheelDensity,
            Quantity::WheelSpecificHeat,
        ])?;
        self.check_temperature(Quantity::WheelBulkTemperature)
    }

    /// Checks the constants of a rail.
    pub fn check_rail(&self) -> Result<(), Error> {
        self.material.check([
            Quantity::RailYoungModulus,
            Quantity::RailPoissonRatio,
            Quantity::RailConductivity,
            Quantity::RailDensity,
            Quantity::RailSpecificHeat,
        ])?;
        self.check_temperature(Quantity::RailBulkTemperature)
    }

    fn check_temperature(&self, quantity: Quantity) -> Result<(), Error> {
        require(quantity, Requirement::AtLeast(ABSOLUTE_ZERO), self.bulk_temperature)
    }
}

/// In degC.
const ABSOLUTE_ZERO: f64 = -273.15;

impl Default for Body {
    fn default() -> Self {
        Self::STEEL
    }
}

/// Plane-strain modulus of two bodies together, 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, in Pa
/// (Hertz 1882; Johnson 1985, Eq. 4.20).
///
/// ```
/// use schlupf::bodies::{Material, contact_modulus};
///
/// let steel = Material::STEEL;
/// let plane_strain = steel.young_modulus / (1.0 - steel.poisson_ratio.powi(2));
/// assert!((2.0 * contact_modulus(&steel, &steel) / plane_strain - 1.0).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn contact_modulus(first: &Material, second: &Material) -> f64 {
    let compliance = |m: &Material| (1.0 - m.poisson_ratio.powi(2)) / m.young_modulus;
    1.0 / (compliance(first) + compliance(second))
}

/// Combined constants of two bodies: 1/G = ½ (1/G₁ + 1/G₂) in Pa, and ν/G = ½ (ν₁/G₁ + ν₂/G₂).
pub(crate) fn shear_modulus_and_poisson_ratio(first: &Material, second: &Material) -> [f64; 2] {
    let [one, other] = [first, second].map(|material| 0.5 / material.shear_modulus());
    let shear_modulus = (one + other).recip();
    let poisson_ratio = first.poisson_ratio * one + second.poisson_ratio * other;
    [shear_modulus, shear_modulus * poisson_ratio]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn steel_has_the_derived_constants_of_its_definition() {
        let steel = Material::STEEL;
        assert_relative_eq!(steel.shear_modulus(), 82.03125e9, max_relative = 1e-12);
        assert_relative_eq!(steel.diffusivity(), 1.4154e-5, max_relative = 1e-4);
        assert_relative_eq!(steel.effusivity(), 13290.0, max_relative = 1e-4);
    }

    #[test]
    fn two_equal_bodies_halve_the_plane_strain_modulus() {
        let steel = Material::STEEL;
        let single = steel.young_modulus / (1.0 - 0.28 * 0.28);
        assert_relative_eq!(contact_modulus(&steel, &steel), 0.5 * single, max_relative = 1e-14);
    }

    #[test]
    fn an_impossible_constant_is_named() {
        let mut body = Body::STEEL;
        body.material.poisson_ratio = 0.6;
        let message = body.check_rail().unwrap_err().to_string();
        assert_eq!(message, "rail_poisson_ratio must be between 0 and 0.5, but is 0.6");
    }
}
