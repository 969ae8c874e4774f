//! The stiffness k_c of Eq. (8), fitted to the tangential curves of a rough contact.

use super::tangential_curve::{SimilarBodies, TangentialCurve};
use crate::numerics::root::golden_section;

/// 1 − exp(−k_c u) fitted to curves Q/(μP) over u.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct ExponentialFit {
    /// Exponent k_c, in 1/m.
    pub stiffness: f64,
    /// Root mean square misfit of the exponential to Q/(μP), all forces up to full sliding weighted
    /// equally; dimensionless.
    pub root_mean_square_error: f64,
    /// Largest misfit, dimensionless.
    pub largest_error: f64,
}

/// k_c at several mean pressures.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct ContactStiffness {
    /// Mean pressures, in Pa.
    pub mean_pressures: Vec<f64>,
    /// The fit at each of them.
    pub fits: Vec<ExponentialFit>,
    /// One fit for all of them.
    pub common: ExponentialFit,
    /// Difference between the largest and smallest k_c relative to that of the common fit,
    /// dimensionless.
    pub spread: f64,
}

/// γ of the closed form, dimensionless, in the middle of the range 0.4 to 0.5 found by theory and
/// measurement (Persson 2007, PRL 99, 125502; Lorenz and Persson 2009).
pub const TYPICAL_GAMMA: f64 = 0.45;

/// k_c = 2 (1 − ν)/(μ (2 − ν) ℓ) (in 1/m): Eq. (8) is exact where the load grows with the approach
/// as p ∝ exp(d/ℓ), with the length ℓ = γ h_rms in m.
///
/// ```
/// use schlupf::interface::roughness::{TYPICAL_GAMMA, closed_form};
/// use schlupf::interface::roughness::tangential_curve::SimilarBodies;
///
/// let bodies = SimilarBodies { friction_coefficient: 0.4, poisson_ratio: 0.28 };
/// let [fine, coarse] = [1e-6, 2e-6].map(|height| closed_form(&bodies, TYPICAL_GAMMA * height));
/// // Twice as rough is half as stiff.
/// assert!((fine / coarse - 2.0).abs() < 1e-12);
/// ```
pub fn closed_form(bodies: &SimilarBodies, length: f64) -> f64 {
    (bodies.friction_coefficient * bodies.compliance_ratio() * length).recip()
}

impl ContactStiffness {
    /// Fits each of the curves and all of them together; `None` without curves.
    pub fn fit(curves: &[TangentialCurve]) -> Option<Self> {
        if curves.is_empty() {
            return None;
        }
        let fits: Vec<ExponentialFit> =
            curves.iter().map(|curve| fit(std::slice::from_ref(curve))).collect();
        let common = fit(curves);
        let extreme = |choose: fn(f64, f64) -> f64, start: f64| {
            fits.iter().map(|fit| fit.stiffness).fold(start, choose)
        };
        let spread = extreme(f64::max, 0.0) - extreme(f64::min, f64::INFINITY);
        Some(Self {
            mean_pressures: curves.iter().map(|curve| curve.mean_pressure).collect(),
            fits,
            common,
            spread: spread / common.stiffness,
        })
    }

    /// The common k_c (in 1/m), if it varies with the pressure by less than the given fraction
    /// (dimensionless).
    pub fn single(&self, largest_spread: f64) -> Option<f64> {
        (self.spread <= largest_spread).then_some(self.common.stiffness)
    }
}

/// Steps of the golden-section search: to rounding error.
const STEPS: u32 = 60;

/// The k_c with the least sum of squares.
fn fit(curves: &[TangentialCurve]) -> ExponentialFit {
    let guess = curves.iter().map(initial_guess).sum::<f64>() / curves.len() as f64;
    let cost = |log: f64| squares(curves, log.exp());
    let range = [(guess / 30.0).ln(), (guess * 30.0).ln()];
    let stiffness = golden_section(range, STEPS, cost).exp();
    let points = curves.iter().flat_map(|curve| &curve.points);
    let largest = points.map(|p| miss(stiffness, p.displacement, p.normalised_traction).abs());
    ExponentialFit {
        stiffness,
        root_mean_square_error: (squares(curves, stiffness) / curves.len() as f64).sqrt(),
        largest_error: largest.fold(0.0, f64::max),
    }
}

/// Estimated from the point where Q/(μP) = 1 − 1/e.
fn initial_guess(curve: &TangentialCurve) -> f64 {
    let share = 1.0 - (-1.0_f64).exp();
    let above = curve.points.iter().find(|point| point.normalised_traction >= share);
    above.map_or(1.0, |point| point.displacement).recip()
}

fn miss(stiffness: f64, displacement: f64, traction: f64) -> f64 {
    traction + (-stiffness * displacement).exp_m1()
}

/// Sum over the curves of ∫₀¹ (q − 1 + exp(−k_c u))² dq with q = Q/(μP), by the trapezoidal rule.
fn squares(curves: &[TangentialCurve], stiffness: f64) -> f64 {
    let of_curve = |curve: &TangentialCurve| -> f64 {
        let square = |k: usize| {
            let point = &curve.points[k];
            miss(stiffness, point.displacement, point.normalised_traction).powi(2)
        };
        let width = |k: usize| {
            curve.points[k + 1].normalised_traction - curve.points[k].normalised_traction
        };
        (0..curve.points.len() - 1).map(|k| 0.5 * width(k) * (square(k) + square(k + 1))).sum()
    };
    curves.iter().map(of_curve).sum()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::load_curve::{LoadCurve, LoadPoint};
    use super::*;

    const STEEL: SimilarBodies = SimilarBodies { friction_coefficient: 0.3, poisson_ratio: 0.28 };

    fn point(mean_pressure: f64, approach: f64) -> LoadPoint {
        LoadPoint {
            mean_pressure,
            approach,
            mean_gap: 0.0,
            contact_fraction: 1e-10 * mean_pressure,
            corrected_contact_fraction: 1e-10 * mean_pressure,
            spot_pressure: 1e10,
            plastic_fraction: 0.0,
            is_converged: true,
            iterations: 1,
        }
    }

    /// Eq. (8) is exact where p ∝ exp(d/ℓ): over ten decades, k_c is that of the closed form at
    /// every pressure.
    #[test]
    fn an_exponential_normal_curve_gives_eq_8() {
        let length = 4e-7;
        let pressures = (0..=100).map(|k| 1e9 * 10_f64.powf(f64::from(k - 100) / 10.0));
        let curve = pressures.map(|p| point(p, length * (1.0 + (p / 0.1).ln())));
        let normal = LoadCurve::new(curve.collect()).unwrap();
        let curves = [1e8, 5e8, 1e9].map(|p| TangentialCurve::new(&normal, p, &STEEL).unwrap());
        let stiffness = ContactStiffness::fit(&curves).unwrap();
        let expected = closed_form(&STEEL, length);
        for fit in stiffness.fits.iter().chain([&stiffness.common]) {
            assert_relative_eq!(fit.stiffness, expected, max_relative = 1e-3);
            assert!(fit.largest_error < 1e-3, "{}", fit.largest_error);
        }
        assert!(stiffness.spread < 1e-3);
        assert_eq!(stiffness.single(0.1), Some(stiffness.common.stiffness));
        assert_relative_eq!(curves[2].initial_stiffness, 0.3e9 * expected, max_relative = 1e-3);
    }

    /// A sphere is not exponential, and the fit reports this: the force rises too linearly.
    #[test]
    fn a_sphere_is_fitted_with_its_error() {
        let points =
            (0..30).map(|k| f64::from(k + 1)).map(|x| point(1e8 * x, 1e-6 * x.cbrt().powi(2)));
        let normal = LoadCurve::new(points.collect()).unwrap();
        let curves = [1e9, 3e9].map(|p| TangentialCurve::new(&normal, p, &STEEL).unwrap());
        let stiffness = ContactStiffness::fit(&curves).unwrap();
        assert!(stiffness.common.largest_error > 0.05, "{}", stiffness.common.largest_error);
        // d ∝ p^(2/3), and so is 1/k_c.
        let ratio = stiffness.fits[0].stiffness / stiffness.fits[1].stiffness;
        assert_relative_eq!(ratio, 3_f64.powf(2.0 / 3.0), max_relative = 1e-3);
        assert_eq!(stiffness.single(0.1), None);
        assert!(ContactStiffness::fit(&[]).is_none());
    }
}
