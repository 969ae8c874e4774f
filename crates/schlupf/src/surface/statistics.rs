//! Height and gradient parameters of a surface (ISO 25178-2:2021, 4.2 and 4.4).

use super::HeightMap;
use super::spectrum::spectral_gradient;
use crate::reporting::Error;

/// Height and hybrid parameters of ISO 25178-2, about the mean height: form and tilt must be
/// removed before (see [`super::form`]).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Statistics {
    /// Arithmetical mean height Sa, in m.
    pub arithmetic_mean_height: f64,
    /// Root mean square height Sq, in m; h_rms of contact mechanics.
    pub root_mean_square_height: f64,
    /// Skewness Ssk, dimensionless.
    pub skewness: f64,
    /// Kurtosis Sku, dimensionless; 3 for Gaussian heights.
    pub kurtosis: f64,
    /// Largest peak height Sp, in m.
    pub peak_height: f64,
    /// Largest pit depth Sv, in m.
    pub pit_depth: f64,
    /// Maximum height Sz = Sp + Sv, in m.
    pub maximum_height: f64,
    /// Root mean square gradient Sdq from differences of neighbours, dimensionless.
    pub root_mean_square_gradient: f64,
    /// Developed area ratio Sdr = A/A₀ − 1 from differences of neighbours, dimensionless.
    pub developed_area_ratio: f64,
    /// Root mean square gradient h'_rms from the spectrum, dimensionless (see
    /// [`spectral_gradient`]). It exceeds Sdq because differences of neighbours smooth the surface.
    pub spectral_gradient: f64,
}

impl Statistics {
    /// Statistics of a surface that is not flat.
    pub fn of(surface: &HeightMap) -> Result<Self, Error> {
        surface.require_rough()?;
        let mean = surface.mean();
        let count = surface.heights().len() as f64;
        let moment = |power: fn(f64) -> f64| {
            surface.heights().iter().map(|height| power(height - mean)).sum::<f64>() / count
        };
        let root_mean_square = moment(|h| h * h).sqrt();
        let [low, high] = surface.range();
        let (gradient, developed_area_ratio) = gradients(surface);
        Ok(Self {
            arithmetic_mean_height: moment(f64::abs),
            root_mean_square_height: root_mean_square,
            skewness: moment(|h| h * h * h) / root_mean_square.powi(3),
            kurtosis: moment(|h| h * h * h * h) / root_mean_square.powi(4),
            peak_height: high - mean,
            pit_depth: mean - low,
            maximum_height: high - low,
            root_mean_square_gradient: gradient,
            developed_area_ratio,
            spectral_gradient: spectral_gradient(surface),
        })
    }
}

/// Sdq and Sdr: gradients over each rectangle between four neighbours, from the differences along
/// two adjacent edges (Stout et al. 1993, *The development of methods for the characterisation of
/// roughness in three dimensions*, EUR 15178).
fn gradients(surface: &HeightMap) -> (f64, f64) {
    let lattice = surface.lattice();
    let at = |i: usize, j: usize| surface.heights()[j * lattice.columns + i];
    let (mut squares, mut stretches) = (0.0, 0.0);
    for j in 1..lattice.rows {
        for i in 1..lattice.columns {
            let x = (at(i, j) - at(i - 1, j)) / lattice.spacing_x;
            let y = (at(i, j) - at(i, j - 1)) / lattice.spacing_y;
            let square = x * x + y * y;
            squares += square;
            // √(1 + s) − 1 without cancellation.
            stretches += square / (1.0 + (1.0 + square).sqrt());
        }
    }
    let count = ((lattice.columns - 1) * (lattice.rows - 1)) as f64;
    ((squares / count).sqrt(), stretches / count)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use approx::assert_relative_eq;

    use super::super::Lattice;
    use super::*;

    /// A sine of amplitude a: Sa = 2a/π, Sq = a/√2, Ssk = 0, Sku = 3/2, gradient a k/√2.
    #[test]
    fn a_sine_has_the_parameters_of_its_definition() {
        let lattice = Lattice { columns: 600, rows: 2, spacing_x: 1e-6, spacing_y: 3e-6 };
        let (a, k) = (0.4e-6, TAU / lattice.length_x());
        let wave = |x: f64, _| 7e-6 + a * (k * x).sin();
        let surface = HeightMap::from_fn(lattice, wave).unwrap().into_periodic();
        let statistics = Statistics::of(&surface).unwrap();
        assert_relative_eq!(statistics.arithmetic_mean_height, 2.0 * a / PI, max_relative = 1e-5);
        let root = 2.0_f64.sqrt();
        assert_relative_eq!(statistics.root_mean_square_height, a / root, max_relative = 1e-12);
        assert_relative_eq!(statistics.skewness, 0.0, epsilon = 1e-9);
        assert_relative_eq!(statistics.kurtosis, 1.5, max_relative = 1e-9);
        assert_relative_eq!(statistics.maximum_height, 2.0 * a, max_relative = 1e-4);
        assert_relative_eq!(statistics.peak_height, statistics.pit_depth, max_relative = 1e-9);
        assert_relative_eq!(statistics.spectral_gradient, a * k / root, max_relative = 1e-10);
        let gradient = statistics.root_mean_square_gradient;
        assert_relative_eq!(gradient, a * k / root, max_relative = 2e-3);
        let small = 0.5 * gradient * gradient;
        assert_relative_eq!(statistics.developed_area_ratio, small, max_relative = 1e-4);
    }

    /// A tilted plane has its slope everywhere, and A/A₀ = √(1 + slope²).
    #[test]
    fn a_plane_has_its_slope() {
        let lattice = Lattice { columns: 5, rows: 4, spacing_x: 1.0, spacing_y: 0.5 };
        let plane = HeightMap::from_fn(lattice, |x, y| 3.0 * x - 4.0 * y).unwrap();
        let statistics = Statistics::of(&plane).unwrap();
        assert_relative_eq!(statistics.root_mean_square_gradient, 5.0, max_relative = 1e-14);
        let stretch = 26.0_f64.sqrt() - 1.0;
        assert_relative_eq!(statistics.developed_area_ratio, stretch, max_relative = 1e-14);
    }

    #[test]
    fn a_flat_surface_has_no_skewness() {
        let flat = HeightMap::from_fn(Lattice::square(4, 1.0), |_, _| 1.0).unwrap();
        assert!(Statistics::of(&flat).unwrap_err().to_string().contains("flat"));
    }
}
