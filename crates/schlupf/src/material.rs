//! Elastic and thermal constants of a body, and what two bodies have in common.

use crate::error::{Error, require, require_positive};

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

    fn check(&self, names: &[&'static str; 5]) -> Result<(), Error> {
        require_positive(names[0], self.young_modulus, "Pa")?;
        let ratio = self.poisson_ratio;
        require((0.0..=0.5).contains(&ratio), names[1], "between 0 and 0.5", ratio, "")?;
        require_positive(names[2], self.conductivity, "W/(m K)")?;
        require_positive(names[3], self.density, "kg/m^3")?;
        require_positive(names[4], self.specific_heat, "J/(kg K)")
    }
}

impl Default for Material {
    fn default() -> Self {
        Self::STEEL
    }
}

/// Wheel or rail: its material and its temperature far from the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// What it is made of.
    pub material: Material,
    /// Temperature before it enters the contact, in degC.
    pub bulk_temperature: f64,
}

impl Body {
    /// Steel at 20 degC.
    pub const STEEL: Self = Self { material: Material::STEEL, bulk_temperature: 20.0 };

    /// Checks the constants of a wheel.
    pub fn check_wheel(&self) -> Result<(), Error> {
        self.material.check(&[
            "wheel.young_modulus",
            "wheel.poisson_ratio",
            "wheel.conductivity",
            "wheel.density",
            "wheel.specific_heat",
        ])?;
        self.check_temperature("wheel.bulk_temperature")
    }

    /// Checks the constants of a rail.
    pub fn check_rail(&self) -> Result<(), Error> {
        self.material.check(&[
            "rail.young_modulus",
            "rail.poisson_ratio",
            "rail.conductivity",
            "rail.density",
            "rail.specific_heat",
        ])?;
        self.check_temperature("rail.bulk_temperature")
    }

    fn check_temperature(&self, quantity: &'static str) -> Result<(), Error> {
        let value = self.bulk_temperature;
        let above_absolute_zero = value.is_finite() && value >= -273.15;
        require(above_absolute_zero, quantity, "finite and at least -273.15 degC", value, "degC")
    }
}

impl Default for Body {
    fn default() -> Self {
        Self::STEEL
    }
}

/// Plane-strain modulus of two bodies together, 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, in Pa
/// (Hertz 1882; Johnson 1985, Eq. 4.20).
pub fn contact_modulus(first: &Material, second: &Material) -> f64 {
    let compliance = |m: &Material| (1.0 - m.poisson_ratio.powi(2)) / m.young_modulus;
    1.0 / (compliance(first) + compliance(second))
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
        assert_eq!(message, "rail.poisson_ratio must be between 0 and 0.5, but is 0.6");
    }
}
