//! Rolling of an ellipse that is slender along rolling, strip by strip: Haines and Ollerton,
//! *Contact stress distributions on elliptical contact surfaces subjected to radial and tangential
//! forces*, Proc. Instn Mech. Engrs 177 (1963); Johnson, *Contact Mechanics* (1985), §8.4.

use std::f64::consts::{FRAC_PI_2, PI};

use super::carter::Carter;

/// An elliptic contact under p0 √(1 − x²/a² − y²/b²) that rolls with longitudinal creepage,
/// modelled as a row of strips in plane strain, each of them a [`Carter`] contact.
///
/// The strip at y has the half-length a(y) = a √(1 − y²/b²) and the largest pressure p0 √(1 −
/// y²/b²). As p0/a is the same in all of them, the centre of the sticking zone is ahead of that of
/// the strip by the same d = a(y) − c(y) in all, ξ = 2 μ p0 (1 − ν) d/(G a), and strips with a(y) <
/// d slide completely.
///
/// Limits: a ≪ b; similar bodies; no lateral creepage, no spin. The interaction of the strips is
/// neglected: at a/b = 0.1 (0.2) the force under a small creepage is 0.9 % (2.6 %) too small for
/// ν = 0.25, and 1.9 % (4.9 %) for ν = 0 (compared with `data/kalker_coefficients.csv`).
///
/// ```
/// use schlupf::solver::reference::HainesOllerton;
///
/// let (semi_axis_x, semi_axis_y, peak_pressure) = (1e-3, 8e-3, 1e9);
/// let (friction_coefficient, shear_modulus, poisson_ratio) = (0.3, 82e9, 0.28);
/// let ellipse = HainesOllerton {
///     semi_axis_x, semi_axis_y, peak_pressure, friction_coefficient, shear_modulus, poisson_ratio,
/// };
/// let creepage = ellipse.full_sliding_creepage();
/// assert!((ellipse.force_over_limit(creepage).abs() - 1.0).abs() < 1e-6);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HainesOllerton {
    /// Semi-axis a along rolling, in m.
    pub semi_axis_x: f64,
    /// Semi-axis b across rolling, in m.
    pub semi_axis_y: f64,
    /// Largest pressure p0, in Pa.
    pub peak_pressure: f64,
    /// Coefficient of friction μ, dimensionless.
    pub friction_coefficient: f64,
    /// Combined shear modulus G of both bodies, in Pa.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio ν of both bodies, dimensionless.
    pub poisson_ratio: f64,
}

impl HainesOllerton {
    /// Normal load N = (2/3) π a b p0, in N.
    pub fn load(&self) -> f64 {
        2.0 / 3.0 * PI * self.semi_axis_x * self.semi_axis_y * self.peak_pressure
    }

    /// The strip at y (in m), which must lie inside the ellipse.
    pub fn strip(&self, y: f64) -> Carter {
        let height = (1.0 - (y / self.semi_axis_y).powi(2)).max(0.0).sqrt();
        Carter {
            half_length: height * self.semi_axis_x,
            peak_pressure: height * self.peak_pressure,
            friction_coefficient: self.friction_coefficient,
            shear_modulus: self.shear_modulus,
            poisson_ratio: self.poisson_ratio,
        }
    }

    /// Creepage at the onset of full sliding, 2 μ p0 (1 − ν)/G; dimensionless.
    pub fn full_sliding_creepage(&self) -> f64 {
        self.strip(0.0).full_sliding_creepage()
    }

    /// Force on the wheel divided by μN (dimensionless) under the creepage ξ (dimensionless).
    ///
    /// With κ = d/a = |ξ| over the full-sliding creepage, the strips of |y| < b √(1 − κ²) stick in
    /// part, and what they lack of full sliding, (c/a)² of each strip's own load, integrates to
    ///
    /// F/μN = −sgn ξ (1 − (3/2) √(1 − κ²) + ½ (1 − κ²)^{3/2} + (3/2) κ acos κ).
    pub fn force_over_limit(&self, creepage: f64) -> f64 {
        let kappa = (creepage.abs() / self.full_sliding_creepage()).min(1.0);
        let root = (1.0 - kappa * kappa).sqrt();
        let lacking = 1.5 * root - 0.5 * root.powi(3) - 1.5 * kappa * kappa.acos();
        -creepage.signum() * (1.0 - lacking)
    }

    /// Traction on the wheel (in Pa) at x and y (in m), the leading edge at larger x, under the
    /// creepage ξ (dimensionless).
    pub fn traction(&self, creepage: f64, x: f64, y: f64) -> f64 {
        if y.abs() < self.semi_axis_y { self.strip(y).traction(creepage, x) } else { 0.0 }
    }

    /// Kalker's creep coefficient of the strips C11 = π²/(4 (1 − ν)), dimensionless: the limit for
    /// a/b → 0 (Kalker 1990, Table E.3).
    pub fn creep_coefficient(&self) -> f64 {
        0.5 * FRAC_PI_2 * PI / (1.0 - self.poisson_ratio)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const STEEL: HainesOllerton = HainesOllerton {
        semi_axis_x: 2e-3,
        semi_axis_y: 20e-3,
        peak_pressure: 1e9,
        friction_coefficient: 0.3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
    };

    /// The closed form is the sum of the strips' forces, including those that slide completely.
    #[test]
    fn the_strips_add_up_to_the_force() {
        const STRIPS: u32 = 4000;
        let width = 2.0 * STEEL.semi_axis_y / f64::from(STRIPS);
        for share in [-0.02, 0.1, 0.5, 0.9, 0.99, 1.2] {
            let creepage = share * STEEL.full_sliding_creepage();
            let force = |k: u32| {
                let strip = STEEL.strip((f64::from(k) + 0.5) * width - STEEL.semi_axis_y);
                width * strip.load() * strip.force_over_limit(creepage)
            };
            let sum: f64 = (0..STRIPS).map(force).sum();
            let expected = STEEL.force_over_limit(creepage);
            assert_relative_eq!(sum / STEEL.load(), expected, max_relative = 1e-5);
        }
    }

    /// Kalker 1990, Table E.3, a/b → 0: C11 = π²/(4 (1 − ν)), for ν = ¼ 3.29; F = −G a b C11 ξ.
    #[test]
    fn kalker_1990_small_creepage() {
        let quarter = HainesOllerton { poisson_ratio: 0.25, ..STEEL };
        assert_relative_eq!(quarter.creep_coefficient(), 3.29, max_relative = 1e-3);
        let creepage = 1e-6;
        let force = quarter.force_over_limit(creepage) * 0.3 * quarter.load();
        let linear = -82e9 * 2e-3 * 20e-3 * quarter.creep_coefficient() * creepage;
        assert_relative_eq!(force, linear, max_relative = 1e-3);
    }

    #[test]
    fn all_slides_from_the_creepage_of_the_middle_strip_on() {
        let full = STEEL.full_sliding_creepage();
        assert_relative_eq!(full, 2.0 * 0.3 * 1e9 * 0.72 / 82e9, max_relative = 1e-14);
        assert!(STEEL.force_over_limit(0.99 * full) > -1.0);
        assert_relative_eq!(STEEL.force_over_limit(full), -1.0);
        assert_eq!(STEEL.force_over_limit(-2.0 * full), 1.0);
        assert_eq!(STEEL.force_over_limit(0.0).abs(), 0.0);
        assert_relative_eq!(STEEL.traction(full, 0.0, 0.0), -0.3e9);
        assert_eq!(STEEL.traction(full, 0.0, 20e-3), 0.0);
    }
}
