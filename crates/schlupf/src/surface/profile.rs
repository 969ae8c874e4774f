//! From a measured profile, one line across a surface, to a surface alike in all directions.
//!
//! The spectrum of a line across an isotropic surface is C₁(qₓ) = ∫ C(√(qₓ² + q_y²)) dq_y, an Abel
//! transform. It is undone for rings of constant C by the iteration of Richardson (1972) and Lucy
//! (1974): the variance D_k of the line in band k of wave numbers comes from the variances P_j of the
//! rings with the known shares K_kj, and
//!
//! P_j ← P_j Σ_k K_kj D_k / (K P)_k / Σ_k K_kj
//!
//! keeps P positive and its sum that of the line.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use realfft::RealFftPlanner;

use super::spectrum::hann;
use super::synthesis::isotropic;
use super::{HeightMap, Lattice};
use crate::error::{Error, require, require_positive};

/// Heights along a line, equidistant.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    spacing: f64,
    heights: Vec<f64>,
}

/// The fewest points that make a spectrum.
const FEWEST: usize = 64;

/// Each band of wave numbers is wider than the one before by this factor, and holds at least so many
/// waves: single ones scatter.
const WIDENING: f64 = 1.15;
const FEWEST_WAVES: usize = 4;

/// Steps of the iteration. Many more would fit the scatter of the line.
const STEPS: usize = 50;

impl Profile {
    /// From the spacing (in m) and the heights (in m). The straight line that fits best is taken off.
    pub fn new(spacing: f64, heights: &[f64]) -> Result<Self, Error> {
        require_positive("surface.spacing_x", spacing, "m")?;
        let count = heights.len();
        let limit = format!("at least {FEWEST}");
        require(count >= FEWEST, "surface.columns", &limit, count as f64, "")?;
        if let Some(at) = heights.iter().position(|height| !height.is_finite()) {
            let value = format!("{} m at point {at}", heights[at]);
            let requirement = "finite everywhere".to_owned();
            return Err(Error::Invalid { quantity: "surface.heights", requirement, value });
        }
        let profile = Self { spacing, heights: levelled(heights) };
        let tallest = heights.iter().fold(0.0_f64, |tallest, height| tallest.max(height.abs()));
        if profile.root_mean_square_height() <= 1e-13 * tallest || tallest == 0.0 {
            return Err(Error::Contradiction {
                quantity: "surface.heights",
                reason: "the profile is flat: its heights lie on a straight line".to_owned(),
            });
        }
        Ok(profile)
    }

    /// Distance of two points, in m.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Heights over the best straight line, in m.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Root mean square height Rq, in m.
    pub fn root_mean_square_height(&self) -> f64 {
        let squares: f64 = self.heights.iter().map(|height| height * height).sum();
        (squares / self.heights.len() as f64).sqrt()
    }

    /// The spectrum of an isotropic surface that has this profile.
    pub fn isotropic_spectrum(&self) -> RingSpectrum {
        let (step, variances) = self.line_spectrum();
        let bands = bands(variances.len());
        let edges: Vec<f64> = bands.iter().map(|band| (*band as f64 - 0.5) * step).collect();
        let line: Vec<f64> =
            bands.windows(2).map(|band| variances[band[0]..band[1]].iter().sum()).collect();
        let rings = unfolded(&line, &edges);
        let area = |edges: &[f64]| PI * (edges[1] * edges[1] - edges[0] * edges[0]);
        let densities = rings.iter().zip(edges.windows(2)).map(|(ring, edges)| ring / area(edges));
        RingSpectrum { densities: densities.collect(), edges }
    }

    /// A surface alike in all directions with the spectrum of this profile. Waves longer than the
    /// profile and shorter than two of its points are not in it.
    pub fn isotropic_surface(&self, lattice: Lattice, seed: u64) -> Result<HeightMap, Error> {
        let spectrum = self.isotropic_spectrum();
        isotropic(lattice, |q| spectrum.density(q), seed)
    }

    /// Variance (in m²) by number of waves, and the step of qₓ (in rad/m), with a Hann window.
    fn line_spectrum(&self) -> (f64, Vec<f64>) {
        let count = self.heights.len();
        let transform = RealFftPlanner::new().plan_fft_forward(count);
        let mut field: Vec<f64> =
            self.heights.iter().zip(hann(count)).map(|(height, weight)| height * weight).collect();
        let mut values = transform.make_output_vec();
        // It fails only on slices of a wrong length.
        let _ = transform.process(&mut field, &mut values);
        let variance = 2.0 / (count as f64 * count as f64);
        let variances = values.iter().map(|value| variance * value.norm_sqr()).collect();
        (TAU / (count as f64 * self.spacing), variances)
    }
}

/// Variances of the rings from those of the line, between the same edges.
fn unfolded(line: &[f64], edges: &[f64]) -> Vec<f64> {
    let count = line.len();
    let share = |band: usize, ring: usize| {
        let within = |radius: f64| strip(radius, edges[band + 1]) - strip(radius, edges[band]);
        let whole = |radius: f64| PI * radius * radius;
        let [inner, outer] = [edges[ring], edges[ring + 1]];
        (within(outer) - within(inner)) / (whole(outer) - whole(inner))
    };
    let shares: Vec<Vec<f64>> =
        (0..count).map(|band| (0..count).map(|ring| share(band, ring)).collect()).collect();
    let mut rings = line.to_vec();
    for _ in 0..STEPS {
        let model = |band: usize| shares[band].iter().zip(&rings).map(|(k, p)| k * p).sum::<f64>();
        let ratios: Vec<f64> =
            (0..count).map(|band| line[band] / model(band).max(f64::MIN_POSITIVE)).collect();
        for (ring, variance) in rings.iter_mut().enumerate() {
            let column = (0..=ring).map(|band| shares[band][ring]);
            let (seen, corrected) = column
                .zip(&ratios)
                .fold((0.0, 0.0), |(seen, sum), (k, ratio)| (seen + k, sum + k * ratio));
            *variance *= corrected / seen;
        }
    }
    rings
}

/// Area of a disc within the distance `half_width` of a line through its middle.
fn strip(radius: f64, half_width: f64) -> f64 {
    let angle = if half_width < radius { (half_width / radius).asin() } else { FRAC_PI_2 };
    radius * radius * (2.0 * angle + (2.0 * angle).sin())
}

/// Heights over the straight line that fits best.
fn levelled(heights: &[f64]) -> Vec<f64> {
    let count = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / count;
    let at = |i: usize| i as f64 - 0.5 * (count - 1.0);
    let products: f64 = heights.iter().enumerate().map(|(i, height)| at(i) * height).sum();
    let squares: f64 = (0..heights.len()).map(|i| at(i).powi(2)).sum();
    let line = |i: usize| mean + products / squares * at(i);
    heights.iter().enumerate().map(|(i, height)| height - line(i)).collect()
}

/// First wave of each band, and the end of the last one.
fn bands(end: usize) -> Vec<usize> {
    let mut bands = vec![1];
    let mut first = 1;
    loop {
        let next = (first + FEWEST_WAVES).max((first as f64 * WIDENING) as usize);
        if next + FEWEST_WAVES > end {
            bands.push(end);
            return bands;
        }
        bands.push(next);
        first = next;
    }
}

/// A spectrum of an isotropic surface, constant in rings of wave vectors.
#[derive(Debug, Clone, PartialEq)]
pub struct RingSpectrum {
    /// Edges of the rings, in rad/m.
    edges: Vec<f64>,
    /// C(q) in each ring, in m⁴.
    densities: Vec<f64>,
}

impl RingSpectrum {
    /// C(q) (in m⁴) at a wave number (in rad/m); zero outside of all rings.
    pub fn density(&self, wave_number: f64) -> f64 {
        let above = self.edges.partition_point(|edge| *edge <= wave_number);
        above.checked_sub(1).and_then(|ring| self.densities.get(ring)).copied().unwrap_or(0.0)
    }

    /// Root mean square height √(2π ∫ C q dq), in m.
    pub fn root_mean_square_height(&self) -> f64 {
        self.moment(|q| PI * q * q).sqrt()
    }

    /// Root mean square gradient √(2π ∫ C q³ dq), dimensionless.
    pub fn root_mean_square_gradient(&self) -> f64 {
        self.moment(|q| 0.5 * PI * q.powi(4)).sqrt()
    }

    fn moment(&self, integral: impl Fn(f64) -> f64) -> f64 {
        let rings = self.edges.windows(2).zip(&self.densities);
        rings.map(|(edges, density)| density * (integral(edges[1]) - integral(edges[0]))).sum()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::spectrum::spectral_gradient;
    use super::super::statistics::Statistics;
    use super::super::synthesis::{Roughness, SelfAffine};
    use super::*;

    /// Goal: lines across an isotropic surface give its height and gradient back.
    /// Set-up: self-affine surface of 1024² cells; every 64th line as a profile; the mean over them,
    /// because a single line scatters.
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
            .map(|line| Profile::new(lattice.spacing_x, line).unwrap().isotropic_spectrum())
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

    /// A surface made from a profile has the spectrum's height, whatever the seed.
    #[test]
    fn a_surface_from_a_profile_has_its_roughness() {
        let wave = |i: usize, length: f64, phase: f64| (TAU * i as f64 / length + phase).sin();
        let heights: Vec<f64> =
            (0..4000).map(|i| wave(i, 130.3, 0.0) + 0.5 * wave(i, 41.7, 1.0)).collect();
        let profile = Profile::new(1e-6, &heights).unwrap();
        let lattice = Lattice::square(500, 1e-3);
        let surface = profile.isotropic_surface(lattice, 5).unwrap();
        let statistics = Statistics::of(&surface).unwrap();
        let height = profile.isotropic_spectrum().root_mean_square_height();
        assert_relative_eq!(statistics.root_mean_square_height, height, max_relative = 0.1);
        assert_relative_eq!(height, profile.root_mean_square_height(), max_relative = 0.1);
    }

    #[test]
    fn each_defect_is_named() {
        let line: Vec<f64> = (0..100).map(f64::from).collect();
        let mut hole = line.clone();
        hole[3] = f64::NAN;
        let cases = [
            (1e-6, line.clone(), "the profile is flat"),
            (1e-6, hole, "but is NaN m at point 3"),
            (0.0, line.clone(), "surface.spacing_x must be positive"),
            (1e-6, line[..10].to_vec(), "surface.columns must be at least 64, but is 10"),
        ];
        for (spacing, heights, expected) in cases {
            let message = Profile::new(spacing, &heights).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
