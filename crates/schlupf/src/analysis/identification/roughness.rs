//! Stiffness of the contact law from the height of the roughness.

use crate::bodies::Material;
use crate::elasticity::HalfSpace;
use crate::reporting::Error;

/// Default γ (dimensionless): theory and measurements give 0.4 to 0.5.
pub const DEFAULT_GAMMA: f64 = 0.45;

/// μ0 k_c h_rms (dimensionless) of two bodies whose rough surfaces approach by γ h_rms when the
/// pressure grows e-fold, P ∝ exp(d/(γ h_rms)):
///
/// k_c = 2 (1 − ν)/(μ0 (2 − ν) γ h_rms).
///
/// h_rms is the combined r.m.s. height of both surfaces, √(h₁² + h₂²); γ is dimensionless. Source:
/// the tangential curve of similar elastic bodies follows from the normal one (Ciavarella 1998,
/// Jäger 1998); P and d of rough surfaces: Persson 2007. Limits: elastic asperities, similar
/// bodies.
pub fn stiffness_number(wheel: &Material, rail: &Material, gamma: f64) -> Result<f64, Error> {
    crate::reporting::require_positive(crate::reporting::Quantity::SlopeFactor, gamma)?;
    let nu = HalfSpace::new(wheel, rail)?.poisson_ratio();
    Ok(2.0 * (1.0 - nu) / ((2.0 - nu) * gamma))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ν = 0.28, μ0 = 0.4, γ = 0.45, h_rms = 0.5 µm: k_c = 1.44/(0.4 · 1.72 · 0.225e-6) =
    /// 9.302e6/m.
    #[test]
    fn half_a_micrometre_of_roughness() {
        let number = stiffness_number(&Material::STEEL, &Material::STEEL, 0.45).unwrap();
        assert!(stiffness_number(&Material::STEEL, &Material::STEEL, 0.0).is_err());
        assert!((number / (0.4 * 0.5e-6) / 9.302_33e6 - 1.0).abs() < 1e-5, "{number}");
    }
}
