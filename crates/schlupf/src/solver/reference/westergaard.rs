//! A wavy surface pressed against a flat one: Westergaard 1939, J. Appl. Mech. 6, 49; Johnson,
//! Greenwood and Higginson 1985, Int. J. Mech. Sci. 27, 383; Johnson, *Contact Mechanics* (1985),
//! §13.2.

use std::f64::consts::PI;

/// Frictionless elastic contact over the undeformed distance Δ (1 − cos(2πx/λ)), the same for all
/// y.
///
/// ```
/// use schlupf::solver::reference::Westergaard;
///
/// let wave = Westergaard { amplitude: 1e-6, wavelength: 1e-3, contact_modulus: 115e9 };
/// assert_eq!(wave.contact_fraction(wave.closing_pressure()), 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Westergaard {
    /// Amplitude Δ of the wave, in m.
    pub amplitude: f64,
    /// Wavelength λ, in m.
    pub wavelength: f64,
    /// Contact modulus E* of both bodies, in Pa.
    pub contact_modulus: f64,
}

impl Westergaard {
    /// Mean pressure p* = πE*Δ/λ (in Pa) at which full contact is reached.
    pub fn closing_pressure(&self) -> f64 {
        PI * self.contact_modulus * self.amplitude / self.wavelength
    }

    /// Ratio of the width of the contact strip in each wave to the wavelength, 2a/λ = (2/π) arcsin
    /// √(p̄/p*), dimensionless, under a mean pressure p̄ (in Pa).
    pub fn contact_fraction(&self, mean_pressure: f64) -> f64 {
        2.0 / PI * (mean_pressure / self.closing_pressure()).min(1.0).sqrt().asin()
    }

    /// Pressure (in Pa) at the distance x from a crest (in m) under a mean pressure p̄ (in Pa): p =
    /// (2p̄ cos ψ/sin² ψₐ) √(sin² ψₐ − sin² ψ) with ψ = πx/λ in the strip |x| < a; in full contact
    /// p = p̄ + p* cos 2ψ.
    pub fn pressure(&self, mean_pressure: f64, x: f64) -> f64 {
        let psi = PI * x / self.wavelength;
        let closing = self.closing_pressure();
        if mean_pressure >= closing {
            return mean_pressure + closing * (2.0 * psi).cos();
        }
        let edge = mean_pressure / closing;
        2.0 * closing * psi.cos().abs() * (edge - psi.sin().powi(2)).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const WAVE: Westergaard =
        Westergaard { amplitude: 1e-7, wavelength: 1e-4, contact_modulus: 115e9 };

    /// The pressure has the required mean, and is nowhere negative.
    #[test]
    fn the_pressure_carries_the_load() {
        const NODES: u32 = 100_000;
        for share in [0.1, 0.5, 0.9, 1.0, 1.7] {
            let mean = share * WAVE.closing_pressure();
            let at = |k: u32| (f64::from(k) + 0.5) / f64::from(NODES) * WAVE.wavelength;
            let sum: f64 = (0..NODES).map(|k| WAVE.pressure(mean, at(k))).sum();
            assert_relative_eq!(sum / f64::from(NODES), mean, max_relative = 1e-6);
            let edge = 0.5 * WAVE.contact_fraction(mean) * WAVE.wavelength;
            // Beyond the edge there is none; in full contact the trough keeps the rest.
            let left = (mean - WAVE.closing_pressure()).max(0.0);
            let beyond = WAVE.pressure(mean, edge * 1.0001);
            assert_relative_eq!(beyond, left, max_relative = 1e-6, epsilon = 1e-6 * mean);
        }
    }

    /// Johnson 1985, Eq. 4.45: under a light load each crest is a cylinder in Hertz contact,
    /// a² = 4 P R/(πE*) with 1/R = 4π²Δ/λ² and P = p̄ λ.
    #[test]
    fn a_light_load_gives_hertz_contact_of_cylinders() {
        let mean = 1e-5 * WAVE.closing_pressure();
        let radius = WAVE.wavelength.powi(2) / (4.0 * PI * PI * WAVE.amplitude);
        let force = mean * WAVE.wavelength;
        let half_width = (4.0 * force * radius / (PI * WAVE.contact_modulus)).sqrt();
        let fraction = 2.0 * half_width / WAVE.wavelength;
        assert_relative_eq!(WAVE.contact_fraction(mean), fraction, max_relative = 1e-5);
        let peak = 2.0 * force / (PI * half_width);
        assert_relative_eq!(WAVE.pressure(mean, 0.0), peak, max_relative = 1e-5);
    }
}
