//! Removal of waviness by the Gaussian filter: of profiles according to ISO 16610-21, of maps
//! according to ISO 16610-61.
//!
//! Waviness is the mean of the heights with the weights exp(−π (x/(α λc))²), α = √(ln 2/π), along x
//! and y. A wave of the cut-off wavelength λc keeps half of its height, one of λ keeps 1 − exp(−π
//! (α λc/λ)²). Near an edge the mean is taken over the existing points.

use std::f64::consts::{LN_2, PI};

use super::profile::Profile;
use super::{HeightMap, Lattice};
use crate::reporting::{Error, Quantity, Requirement, require};

/// Range of the weights in cut-off wavelengths: beyond, they are below 10⁻⁶.
const REACH: f64 = 1.0;

impl HeightMap {
    /// The surface without waves longer than a cut-off wavelength (in m).
    ///
    /// ```
    /// use schlupf::surface::{HeightMap, Lattice};
    ///
    /// let lattice = Lattice { columns: 64, rows: 64, spacing_x: 1e-6, spacing_y: 1e-6 };
    /// let wave = |cell: u32| 1e-6 * (f64::from(cell % 64) / 64.0).sin();
    /// let ripple = |cell: u32| 1e-8 * f64::from(cell % 2);
    /// let heights = (0..4096).map(|cell| wave(cell) + ripple(cell)).collect();
    /// let rough = HeightMap::new(lattice, heights)?.without_waviness(8e-6)?;
    /// assert!(rough.heights().iter().all(|height| height.abs() < 1e-7));
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A cut-off wavelength shorter than two cells or longer than the surface.
    pub fn without_waviness(&self, cutoff: f64) -> Result<Self, Error> {
        let lattice = *self.lattice();
        let Lattice { columns, rows, spacing_x, spacing_y } = lattice;
        require_cutoff(
            cutoff,
            spacing_x.max(spacing_y),
            lattice.length_x().min(lattice.length_y()),
        )?;
        let across = mean_across(self.heights(), columns, &weights(cutoff, spacing_y));
        let turned = transposed(&across, columns);
        let both = mean_across(&turned, rows, &weights(cutoff, spacing_x));
        let waviness = transposed(&both, rows);
        let heights = self.heights().iter().zip(waviness).map(|(height, mean)| height - mean);
        Self::new(lattice, heights.collect())
    }
}

impl Profile {
    /// The profile without waves longer than a cut-off wavelength (in m).
    pub fn without_waviness(&self, cutoff: f64) -> Result<Self, Error> {
        let length = self.spacing() * self.heights().len() as f64;
        require_cutoff(cutoff, self.spacing(), length)?;
        let waviness = mean_across(self.heights(), 1, &weights(cutoff, self.spacing()));
        let heights: Vec<f64> =
            self.heights().iter().zip(waviness).map(|(height, mean)| height - mean).collect();
        Self::new(self.spacing(), &heights)
    }
}

fn require_cutoff(cutoff: f64, spacing: f64, length: f64) -> Result<(), Error> {
    let range = Requirement::Between(2.0 * spacing, length);
    require(Quantity::CutoffWavelength, range, cutoff)
}

/// Weights of a cell and the following ones, dimensionless.
fn weights(cutoff: f64, spacing: f64) -> Vec<f64> {
    // π (x/(α λc))² with α² = ln 2/π
    let weight = |k: usize| libm::exp(-PI * PI / LN_2 * (k as f64 * spacing / cutoff).powi(2));
    (0..=(REACH * cutoff / spacing) as usize).map(weight).collect()
}

/// Weighted means over the rows, for lines with the given number of columns.
fn mean_across(heights: &[f64], columns: usize, weights: &[f64]) -> Vec<f64> {
    let rows = heights.len() / columns;
    let mut means = vec![0.0; heights.len()];
    for (row, mean) in means.chunks_exact_mut(columns).enumerate() {
        let (first, end) = (row.saturating_sub(weights.len() - 1), (row + weights.len()).min(rows));
        let mut sum = 0.0;
        for other in first..end {
            let weight = weights[row.abs_diff(other)];
            let line = &heights[other * columns..(other + 1) * columns];
            mean.iter_mut().zip(line).for_each(|(mean, height)| *mean += weight * height);
            sum += weight;
        }
        for mean in mean {
            *mean /= sum;
        }
    }
    means
}

/// Exchanges rows and columns.
fn transposed(values: &[f64], columns: usize) -> Vec<f64> {
    (0..columns).flat_map(|i| values[i..].iter().step_by(columns).copied()).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::*;

    /// Goal: the transmission of ISO 16610-21 and -61, 1 − exp(−π (α λc/λ)²): half at the cut-off.
    /// Away from the edges, for waves along x, along y and oblique.
    #[test]
    fn iso_16610_transmission() {
        let lattice = Lattice { columns: 200, rows: 160, spacing_x: 1e-6, spacing_y: 1.5e-6 };
        let cutoff = 40e-6;
        for [x, y] in [[40e-6, f64::INFINITY], [f64::INFINITY, 20e-6], [60e-6, 80e-6]] {
            let wave = |a: f64, b: f64| (TAU * (a / x + b / y)).cos();
            let surface = HeightMap::from_fn(lattice, wave).unwrap();
            let filtered = surface.without_waviness(cutoff).unwrap();
            let ratio = LN_2 * cutoff * cutoff * (x.powi(-2) + y.powi(-2));
            let transmission = 1.0 - (-ratio).exp();
            for (i, j) in [(100, 80), (93, 71), (110, 90)] {
                let cell = j * 200 + i;
                let expected = transmission * surface.heights()[cell];
                assert_relative_eq!(filtered.heights()[cell], expected, epsilon = 2e-4);
            }
        }
    }

    #[test]
    fn a_profile_keeps_half_of_a_wave_at_the_cut_off() {
        let heights: Vec<f64> = (0..1000).map(|i| (TAU * f64::from(i) / 100.0).sin()).collect();
        let profile = Profile::new(1e-6, &heights).unwrap();
        let filtered = profile.without_waviness(100e-6).unwrap();
        assert_relative_eq!(filtered.heights()[525], 0.5 * heights[525], epsilon = 2e-3);
        let long = profile.without_waviness(2e-3).unwrap_err().to_string();
        assert!(long.contains("cutoff_wavelength must be between 2e-6 and 1e-3 m"), "{long}");
    }
}
