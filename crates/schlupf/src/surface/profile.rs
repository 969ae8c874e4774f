//! A measured profile, one line across a surface.

use std::f64::consts::TAU;

use realfft::RealFftPlanner;
use rustfft::num_complex::Complex;

use super::form::line_without_circle;
use super::line_spectrum::LineSpectrum;
use super::spectrum::hann;
use crate::numerics::vector::root_mean_square;
use crate::reporting::{
    Error, Place, Quantity, Requirement, SurfaceError, require_at, require_positive,
};

/// Heights along a line, equidistant.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    spacing: f64,
    heights: Vec<f64>,
}

/// Fraction of the waves that are independent of their neighbours: a Hann window spreads each over
/// three.
const INDEPENDENT: f64 = 0.5;

/// Minimum number of points for a spectrum.
const FEWEST: usize = 64;

impl Profile {
    /// A profile from the spacing (in m) and the heights (in m). The best-fit straight line is
    /// removed.
    pub fn new(spacing: f64, heights: &[f64]) -> Result<Self, Error> {
        require_positive(Quantity::SpacingX, spacing)?;
        let (quantity, fewest, count) = (Quantity::Heights, FEWEST, heights.len());
        if count < fewest {
            return Err(Error::TooFew { quantity, fewest, count });
        }
        for (k, height) in heights.iter().enumerate() {
            require_at(quantity, Requirement::Finite, *height, Place::Index(k))?;
        }
        let profile = Self { spacing, heights: levelled(heights) };
        let tallest = heights.iter().fold(0.0_f64, |tallest, height| tallest.max(height.abs()));
        if profile.root_mean_square_height() <= 1e-13 * tallest || tallest == 0.0 {
            return Err(SurfaceError::Flat { height: None }.into());
        }
        Ok(profile)
    }

    /// Distance between two points, in m.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Heights above the best-fit straight line, in m.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Root mean square height Rq, in m.
    pub fn root_mean_square_height(&self) -> f64 {
        root_mean_square(&self.heights)
    }

    /// The profile without its best-fit circle, and the radius of the circle (in m), positive if
    /// convex. This removes the form of a line across a cylinder or a sphere.
    pub fn without_circle(&self) -> Result<(Self, f64), Error> {
        let (heights, radius) = line_without_circle(self.spacing, &self.heights)?;
        Ok((Self::new(self.spacing, &heights)?, radius))
    }

    /// Its spectrum, with a Hann window and the root mean square height Rq.
    pub fn line_spectrum(&self) -> LineSpectrum {
        let count = self.heights.len();
        let transform = RealFftPlanner::new().plan_fft_forward(count);
        let mut field: Vec<f64> =
            self.heights.iter().zip(hann(count)).map(|(height, weight)| height * weight).collect();
        let mut values = transform.make_output_vec();
        // It fails only for slices of the wrong length.
        let _ = transform.process(&mut field, &mut values);
        let mut variances: Vec<f64> = values.iter().map(Complex::norm_sqr).collect();
        if let (true, Some(shortest)) = (count.is_multiple_of(2), variances.last_mut()) {
            // The shortest wave is its own mirror.
            *shortest *= 0.5;
        }
        // The window gave waves in the middle of the line a larger weight.
        let found: f64 = variances.iter().skip(1).sum();
        let factor = self.root_mean_square_height().powi(2) / found;
        for variance in &mut variances {
            *variance *= factor;
        }
        LineSpectrum::of_waves(TAU / (count as f64 * self.spacing), &variances, INDEPENDENT)
    }
}

/// Heights above the best-fit straight line.
fn levelled(heights: &[f64]) -> Vec<f64> {
    let count = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / count;
    let at = |i: usize| i as f64 - 0.5 * (count - 1.0);
    let products: f64 = heights.iter().enumerate().map(|(i, height)| at(i) * height).sum();
    let squares: f64 = (0..heights.len()).map(|i| at(i).powi(2)).sum();
    let line = |i: usize| mean + products / squares * at(i);
    heights.iter().enumerate().map(|(i, height)| height - line(i)).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::Lattice;
    use super::super::ring_spectrum::RingSpectrum;
    use super::super::spectrum::{RadialSpectrum, Window, spectral_gradient};
    use super::super::statistics::Statistics;
    use super::super::synthesis::{Roughness, SelfAffine};
    use super::*;

    /// Goal: lines across an isotropic surface return its height and gradient. Set-up: self-affine
    /// surface of 1024² cells; every 64th line as a profile; the mean over them, because a single
    /// line scatters.
    #[test]
    fn lines_across_a_surface_give_its_spectrum_back() {
        let lattice = Lattice::square(1024, 1e-3);
        let spectrum = SelfAffine {
            roughness: Roughness::Height(1e-6),
            hurst_exponent: 0.8,
            longest_wavelength: 1e-4,
            roll_off_wavelength: 1e-4,
            shortest_wavelength: 1e-5,
        };
        let surface = spectrum.surface(lattice, 11).unwrap();
        let lines = surface.heights().chunks_exact(1024).step_by(64);
        let spectra: Vec<RingSpectrum> = lines
            .map(|line| Profile::new(lattice.spacing_x, line).unwrap().line_spectrum().isotropic())
            .collect();
        let mean = |value: fn(&RingSpectrum) -> f64| {
            let squares: f64 = spectra.iter().map(|spectrum| value(spectrum).powi(2)).sum();
            (squares / spectra.len() as f64).sqrt()
        };
        let height = mean(RingSpectrum::root_mean_square_height);
        assert_relative_eq!(height, 1e-6, max_relative = 0.05);
        let gradient = spectral_gradient(&surface);
        let found = mean(RingSpectrum::root_mean_square_gradient);
        assert_relative_eq!(found, gradient, max_relative = 0.05);
    }

    /// A surface generated from a profile has the height of the spectrum, whatever the seed.
    #[test]
    fn a_surface_from_a_profile_has_its_roughness() {
        let wave = |i: usize, length: f64, phase: f64| (TAU * i as f64 / length + phase).sin();
        let heights: Vec<f64> =
            (0..4000).map(|i| wave(i, 130.3, 0.0) + 0.5 * wave(i, 41.7, 1.0)).collect();
        let profile = Profile::new(1e-6, &heights).unwrap();
        let lattice = Lattice::square(500, 1e-3);
        let surface = profile.line_spectrum().isotropic_surface(lattice, 5).unwrap();
        let statistics = Statistics::of(&surface).unwrap();
        let height = profile.line_spectrum().isotropic().root_mean_square_height();
        // A fraction of 10⁻⁶ is in waves too short for the lattice.
        assert_relative_eq!(statistics.root_mean_square_height, height, max_relative = 1e-5);
        assert_relative_eq!(height, profile.root_mean_square_height(), max_relative = 1e-9);
    }

    /// Goal: the spectrum from a single line is that of the surface ring by ring, without gaps.
    /// Set-up: 1024² cells, H = 0.8 and 0.3 with and without a plateau; 16 lines, each on its own.
    /// A line contains few of the longest waves, and the end of a spectrum is blurred by one ring:
    /// the comparison is restricted to what lies between, from two thirds of the longest wave.
    /// Compared with the prescribed spectrum.
    #[test]
    fn single_lines_give_the_spectrum_without_gaps() {
        for (hurst_exponent, roll_off, seed) in [(0.8, 1e-4, 1), (0.8, 4e-5, 2), (0.3, 1e-4, 3)] {
            let affine = SelfAffine {
                roughness: Roughness::Height(1e-6),
                hurst_exponent,
                longest_wavelength: 1e-4,
                roll_off_wavelength: roll_off,
                shortest_wavelength: 8e-6,
            };
            let surface = affine.surface(Lattice::square(1024, 1.024e-3), seed).unwrap();
            let truth = RadialSpectrum::of(&surface, Window::None);
            let mut off = Vec::new();
            for line in surface.heights().chunks_exact(1024).step_by(64) {
                let profile = Profile::new(1e-6, line).unwrap();
                let spectrum = profile.line_spectrum().isotropic();
                for (q, expected) in truth.wave_numbers.iter().zip(&truth.densities) {
                    if *q > 1.5 * TAU / 1e-4 && *q < 0.85 * TAU / 8e-6 {
                        off.push((spectrum.density(*q) / expected).log2());
                    }
                }
            }
            let count = off.len() as f64;
            let largest = off.iter().fold(0.0_f64, |largest, off| largest.max(off.abs()));
            let within = off.iter().filter(|off| off.abs() < 1.0).count() as f64 / count;
            let mean = off.iter().sum::<f64>() / count;
            assert!(largest < 2.0, "{hurst_exponent} {roll_off}: {largest}");
            assert!(within > 0.95, "{hurst_exponent} {roll_off}: {within}");
            assert!(mean.abs() < 0.2, "{hurst_exponent} {roll_off}: {mean}");
        }
    }

    /// A line across a tread of 0.46 m radius retains only its roughness.
    #[test]
    fn a_circle_is_taken_off() {
        for radius in [0.46, -0.46] {
            let texture = |x: f64| 1e-6 * (x / 8e-6).sin();
            let circle = |x: f64| {
                let depth =
                    (x - 1e-3).powi(2) / (1.0 + (1.0 - ((x - 1e-3) / radius).powi(2)).sqrt());
                -depth / radius + 0.01 * x
            };
            let at = |i: usize| 1e-6 * (i as f64 - 2499.5);
            let heights: Vec<f64> = (0..5000).map(|i| circle(at(i)) + texture(at(i))).collect();
            let (profile, found) = Profile::new(1e-6, &heights).unwrap().without_circle().unwrap();
            assert_relative_eq!(found, radius, max_relative = 1e-2);
            let height = profile.root_mean_square_height();
            assert_relative_eq!(height, 1e-6 / 2.0_f64.sqrt(), max_relative = 1e-2);
        }
    }

    #[test]
    fn each_defect_is_named() {
        let line: Vec<f64> = (0..100).map(f64::from).collect();
        let mut hole = line.clone();
        hole[3] = f64::NAN;
        let cases = [
            (1e-6, line.clone(), "must not be flat"),
            (1e-6, hole, "but is NaN m in place 3"),
            (0.0, line.clone(), "spacing_x must be positive"),
            (1e-6, line[..10].to_vec(), "heights needs at least 64 entries, got 10"),
        ];
        for (spacing, heights, expected) in cases {
            let message = Profile::new(spacing, &heights).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
