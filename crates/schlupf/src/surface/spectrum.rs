//! The power spectral density of a surface.
//!
//! C(q) is the contribution to the variance of the heights per unit area of wave vectors: ⟨h²⟩ = ∫
//! C(q) d²q, and h_rms² = 2π ∫ C(q) q dq for an isotropic surface (Persson et al. 2005, J. Phys.
//! Condens. Matter 17, R1). On a lattice of area A the wave vector q has C(q) = (A/4π²) |h_q|²,
//! where h_q is the mean of h(x) exp(−i q·x).

use std::f64::consts::{PI, TAU};

use super::HeightMap;
use crate::numerics::fourier::RealTransform;
use crate::reporting::{Column, Record, columns};

/// Treatment of the jump where a surface that is not periodic is continued.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Window {
    /// Nothing: for periodic surfaces.
    None,
    /// Heights fade out towards the edge as sin², and have a larger weight in the middle.
    #[default]
    Hann,
}

impl Window {
    /// The window that a surface needs.
    pub fn of(surface: &HeightMap) -> Self {
        if surface.is_periodic() { Self::None } else { Self::Hann }
    }
}

/// Power spectral density averaged over all directions.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct RadialSpectrum {
    /// Mean wave number of each ring, in rad/m.
    pub wave_numbers: Vec<f64>,
    /// Mean density C(q) in each ring, in m⁴.
    pub densities: Vec<f64>,
}

impl RadialSpectrum {
    /// Spectrum of the heights about their mean, in rings as wide as the step of wave numbers along
    /// the shorter side, up to the shortest wave that the lattice can represent in every direction.
    pub fn of(surface: &HeightMap, window: Window) -> Self {
        let lattice = surface.lattice();
        let weights = [lattice.columns, lattice.rows].map(|count| weights(count, window));
        let field = weighted(surface, &weights);
        let spacing = [lattice.spacing_x, lattice.spacing_y];
        let step = TAU / lattice.length_x().min(lattice.length_y());
        let largest = PI / spacing[0].max(spacing[1]);
        let mut rings = Rings::new(step, largest);
        let density = lattice.area() / (TAU * TAU);
        for (q, [square, multiplicity]) in squares(&field, surface) {
            rings.add(q, density * square, multiplicity);
        }
        rings.into_spectrum()
    }
}

/// The power law C ∝ q^(−2(1+H)) of a self-affine surface, fitted to its spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PowerLaw {
    /// Hurst exponent H, dimensionless, from 0 to 1.
    pub hurst_exponent: f64,
    /// Range of wave numbers, in rad/m.
    pub wave_numbers: [f64; 2],
}

/// The power law is fitted from the wave number below which this fraction of the variance of the
/// heights is found, to the one with this fraction of the variance of the gradients; dimensionless.
const LAW_FROM: f64 = 0.7;
const LAW_TO: f64 = 0.9;

impl RadialSpectrum {
    /// The power law between the waves that determine the height and those that determine the
    /// gradient; `None` if they are less than half a decade apart, or if the exponent is not that
    /// of a self-affine surface.
    pub fn power_law(&self) -> Option<PowerLaw> {
        let reached = |power: i32, share: f64| {
            let terms = || self.wave_numbers.iter().zip(&self.densities);
            let term = |(q, density): (&f64, &f64)| q.powi(power) * density;
            let total: f64 = terms().map(term).sum();
            let mut sum = 0.0;
            terms().position(|at| {
                sum += term(at);
                sum >= share * total
            })
        };
        let (first, last) = (reached(1, LAW_FROM)?, reached(3, LAW_TO)?);
        if self.wave_numbers[last] < SHORTEST_LAW * self.wave_numbers[first] {
            return None;
        }
        let points = || {
            let rings = first..(last + 1).max(first);
            rings.map(|ring| [self.wave_numbers[ring].ln(), self.densities[ring].ln()])
        };
        if points().len() < FEWEST_RINGS || points().any(|point| !point[1].is_finite()) {
            return None;
        }
        // Rings become dense at large wave numbers: each is weighted by its width in ln q.
        let mut sums = [0.0; 5];
        for [x, y] in points() {
            let weight = (-x).exp();
            let terms = [1.0, x, y, x * x, x * y];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += weight * term);
        }
        let [n, x, y, xx, xy] = sums;
        let slope = (n * xy - x * y) / (n * xx - x * x);
        let hurst_exponent = -0.5 * slope - 1.0;
        let wave_numbers = [self.wave_numbers[first], self.wave_numbers[last]];
        (0.0..=1.0).contains(&hurst_exponent).then_some(PowerLaw { hurst_exponent, wave_numbers })
    }
}

impl RadialSpectrum {
    /// Fraction of the variance of the heights (dimensionless) in waves longer than a wavelength
    /// (in m).
    pub fn share_of_longer(&self, wavelength: f64) -> f64 {
        let terms = self.wave_numbers.iter().zip(&self.densities).map(|(q, c)| [*q, q * c]);
        let [mut longer, mut total] = [0.0; 2];
        for [q, term] in terms {
            total += term;
            longer += if q * wavelength < TAU { term } else { 0.0 };
        }
        longer / total
    }
}

/// Minimum number of rings and range of wave numbers for a power law: half a decade, √10.
const FEWEST_RINGS: usize = 5;
const SHORTEST_LAW: f64 = 3.162_277_660_168_379_5;

/// Weights of the samples along one side; the mean of their squares is one.
fn weights(count: usize, window: Window) -> Vec<f64> {
    match window {
        Window::None => vec![1.0; count],
        Window::Hann => hann(count),
    }
}

/// √(8/3) sin²(π (i + ½)/n), dimensionless.
pub(super) fn hann(count: usize) -> Vec<f64> {
    let weight = |i: usize| libm::sin(PI * (i as f64 + 0.5) / count as f64).powi(2);
    (0..count).map(|i| (8.0_f64 / 3.0).sqrt() * weight(i)).collect()
}

/// Wave number, |h_q|² and multiplicity, for every wave vector of the half spectrum.
fn squares(field: &[f64], surface: &HeightMap) -> Vec<(f64, [f64; 2])> {
    let lattice = surface.lattice();
    let size = [lattice.columns, lattice.rows];
    let mut transform = RealTransform::new(size, size);
    transform.forward(field);
    let normalised = (lattice.len() as f64).powi(-2);
    let waves = transform.wave_numbers([lattice.spacing_x, lattice.spacing_y]);
    let values = transform.spectrum().iter().zip(transform.multiplicities());
    waves.zip(values).map(|(q, (value, m))| (q, [normalised * value.norm_sqr(), m])).collect()
}

/// Heights (in m) about their mean, multiplied by weights along x and y.
fn weighted(surface: &HeightMap, [along, across]: &[Vec<f64>; 2]) -> Vec<f64> {
    let mean = surface.mean();
    let weights = across.iter().flat_map(|across| along.iter().map(move |along| across * along));
    surface.heights().iter().zip(weights).map(|(height, w)| w * (height - mean)).collect()
}

/// Root mean square gradient h'_rms from the spectrum, dimensionless: √(Σ q² |h_q|²) for a periodic
/// surface. For any other, the mean over the squared weights w² of a window,
///
/// ⟨w² |∇h|²⟩ = ⟨|∇(w h)|²⟩ + ⟨h² w ∇²w⟩
///
/// by parts, with the first term from the spectrum: neither the seam nor the slope of the window
/// contributes. The window is Tukey's, constant except for sin² flanks over an eighth of each side
/// at either end: it wastes less of the surface than Hann's.
pub fn spectral_gradient(surface: &HeightMap) -> f64 {
    if surface.is_periodic() {
        return mean_square_gradient(surface.heights(), surface).sqrt();
    }
    let lattice = surface.lattice();
    let sides = [(lattice.columns, lattice.length_x()), (lattice.rows, lattice.length_y())];
    let [along, across] = sides.map(|(count, length)| Tukey::new(count, length));
    let field = weighted(surface, &[along.weights.clone(), across.weights.clone()]);
    let flanks = across.terms().flat_map(|[v, bend_v]| {
        // w = u(x) v(y): w ∇²w = u u'' v² + u² v v''
        along.terms().map(move |[u, bend_u]| u * u * v * bend_v + u * bend_u * v * v)
    });
    let mean = surface.mean();
    let squares = surface.heights().iter().map(|height| (height - mean).powi(2));
    let of_flanks: f64 = squares.zip(flanks).map(|(square, flank)| square * flank).sum();
    let sum = mean_square_gradient(&field, surface) + of_flanks / lattice.len() as f64;
    sum.max(0.0).sqrt()
}

/// Σ q² |h_q|² of heights on the lattice of a surface, dimensionless.
fn mean_square_gradient(heights: &[f64], surface: &HeightMap) -> f64 {
    let waves = squares(heights, surface).into_iter();
    waves.map(|(q, [square, multiplicity])| multiplicity * q * q * square).sum()
}

/// Fraction of a side taken by each flank of Tukey's window.
const FLANK: f64 = 0.125;

/// Weights along a side and their second derivatives; the mean of the squared weights is one.
struct Tukey {
    weights: Vec<f64>,
    /// In 1/m².
    bends: Vec<f64>,
}

impl Tukey {
    /// The window for a number of cells over a length (in m).
    fn new(count: usize, length: f64) -> Self {
        let from_end = |i: usize| (i.min(count - 1 - i) as f64 + 0.5) / count as f64;
        // sin²(πt/2f) on the flank, with the second derivative ½ (π/f)² cos(πt/f)
        let flank = |t: f64| match t / FLANK {
            part if part < 1.0 => {
                let bend = 0.5 * (PI / (FLANK * length)).powi(2) * libm::cos(PI * part);
                (libm::sin(0.5 * PI * part).powi(2), bend)
            }
            _ => (1.0, 0.0),
        };
        let (mut weights, mut bends): (Vec<f64>, Vec<f64>) =
            (0..count).map(|i| flank(from_end(i))).unzip();
        let mean_square = weights.iter().map(|w| w * w).sum::<f64>() / count as f64;
        let factor = mean_square.sqrt().recip();
        weights.iter_mut().chain(&mut bends).for_each(|value| *value *= factor);
        Self { weights, bends }
    }

    fn terms(&self) -> impl Iterator<Item = [f64; 2]> {
        self.weights.iter().zip(&self.bends).map(|(weight, bend)| [*weight, *bend])
    }
}

/// Sums by wave number.
struct Rings {
    step: f64,
    /// Sums of multiplicity, multiplicity times q, multiplicity times C(q).
    sums: Vec<[f64; 3]>,
}

impl Rings {
    fn new(step: f64, largest: f64) -> Self {
        Self { step, sums: vec![[0.0; 3]; (largest / step).floor() as usize + 1] }
    }

    /// The mean height, in the ring around zero, is omitted.
    fn add(&mut self, q: f64, density: f64, multiplicity: f64) {
        let ring = (q / self.step).round() as usize;
        if let Some(sum) = self.sums.get_mut(ring).filter(|_| ring > 0) {
            *sum =
                [sum[0] + multiplicity, sum[1] + multiplicity * q, sum[2] + multiplicity * density];
        }
    }

    fn into_spectrum(self) -> RadialSpectrum {
        let filled = self.sums.iter().filter(|sum| sum[0] > 0.0);
        let (wave_numbers, densities) =
            filled.map(|[count, q, density]| (q / count, density / count)).unzip();
        RadialSpectrum { wave_numbers, densities }
    }
}

/// Power spectral density of a surface.
impl Record for RadialSpectrum {
    fn rows(&self) -> usize {
        self.wave_numbers.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { RadialSpectrum:
        WaveNumber => |spectrum, k| spectrum.wave_numbers[k],
        SpectralDensity => |spectrum, k| spectrum.densities[k],
    };
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::Lattice;
    use super::super::form::Form;
    use super::super::synthesis::{Roughness, SelfAffine};
    use super::*;

    /// A single wave of amplitude a has h_rms² = a²/2, all of it in the ring of its wave number: C
    /// times the area of wave vectors in the ring.
    #[test]
    fn the_rings_hold_the_variance() {
        let lattice = Lattice { columns: 32, rows: 24, spacing_x: 1e-6, spacing_y: 2e-6 };
        let [kx, ky] = [3.0 * TAU / lattice.length_x(), 4.0 * TAU / lattice.length_y()];
        let surface = HeightMap::from_fn(lattice, |x, y| 5e-7 * (kx * x + ky * y).cos()).unwrap();
        let surface = surface.into_periodic();
        let spectrum = RadialSpectrum::of(&surface, Window::None);
        let step = TAU / lattice.length_x();
        let ring = (kx.hypot(ky) / step).round();
        let found = spectrum.wave_numbers.iter().zip(&spectrum.densities);
        for (q, density) in found {
            if (q / step).round() == ring {
                assert!(*density > 0.0, "{q}");
            } else {
                assert!(*density < 1e-50, "{q} {density}");
            }
        }
        let gradient = 5e-7 * kx.hypot(ky) / 2.0_f64.sqrt();
        assert_relative_eq!(spectral_gradient(&surface), gradient, max_relative = 1e-12);
    }

    /// Goal: the seam of a map that is not periodic does not count as a slope. Set-up: five pieces
    /// of 128² cells of a periodic surface of 1024² cells with known gradient; with a tilt that the
    /// form removal eliminates.
    #[test]
    fn a_piece_of_a_surface_has_its_gradient() {
        let affine = SelfAffine {
            roughness: Roughness::Gradient(0.1423),
            hurst_exponent: 0.8,
            longest_wavelength: 100e-6,
            roll_off_wavelength: 100e-6,
            shortest_wavelength: 12e-6,
        };
        let whole = affine.surface(Lattice::square(1024, 1.024e-3), 3).unwrap();
        let of_piece = |piece: usize| {
            let cell = |[i, j]: [usize; 2]| (150 * piece + j) * 1024 + 170 * piece + i;
            let at = (0..128).flat_map(|j| (0..128).map(move |i| [i, j]));
            let tilted = at.map(|[i, j]| whole.heights()[cell([i, j])] + 1e-7 * i as f64);
            let piece = HeightMap::new(Lattice::square(128, 128e-6), tilted.collect()).unwrap();
            spectral_gradient(&piece.without_form(Form::Plane).unwrap().surface)
        };
        let found: Vec<f64> = (0..5).map(of_piece).collect();
        for gradient in &found {
            assert_relative_eq!(*gradient, 0.1423, max_relative = 0.1);
        }
        assert_relative_eq!(found.iter().sum::<f64>() / 5.0, 0.1423, max_relative = 0.05);
    }

    /// A non-integer number of waves: the gradient is a k/√2 wherever the seam is.
    #[test]
    fn a_wave_that_does_not_close_has_its_gradient() {
        let (amplitude, k) = (5e-7, 10.4 * TAU);
        let wave = |x: f64, y: f64| amplitude * (k * (0.6 * x + 0.8 * y)).cos();
        let surface = HeightMap::from_fn(Lattice::square(64, 1.0), wave).unwrap();
        let expected = amplitude * k / 2.0_f64.sqrt();
        assert_relative_eq!(spectral_gradient(&surface), expected, max_relative = 1e-3);
    }

    /// The exponent of a self-affine surface is found.
    #[test]
    fn a_power_law_is_found() {
        for hurst_exponent in [0.3, 0.8] {
            let affine = SelfAffine {
                roughness: Roughness::Height(1e-6),
                hurst_exponent,
                longest_wavelength: 5e-5,
                roll_off_wavelength: 5e-5,
                shortest_wavelength: 1e-6,
            };
            let surface = affine.surface(Lattice::square(400, 2e-4), 4).unwrap();
            let law = RadialSpectrum::of(&surface, Window::None).power_law().unwrap();
            assert_relative_eq!(law.hurst_exponent, hurst_exponent, epsilon = 0.05);
            assert!(law.wave_numbers[0] > TAU / 5e-5 && law.wave_numbers[1] < TAU / 1e-6);
        }
        let wave = HeightMap::from_fn(Lattice::square(64, 1.0), |x, _| (TAU * x).cos()).unwrap();
        assert_eq!(RadialSpectrum::of(&wave, Window::None).power_law(), None);
    }

    /// No exponent for a spectrum that falls as q^(−2(1+H)) with H = 2.3 or −0.9, nor for one over
    /// a third of a decade.
    #[test]
    fn what_is_not_self_affine_has_no_exponent() {
        let law = |hurst_exponent: f64, decades: f64| {
            let wave_numbers: Vec<f64> =
                (0..200).map(|k| 10.0_f64.powf(5.0 + decades * f64::from(k) / 200.0)).collect();
            let density = |q: &f64| q.powf(-2.0 * (1.0 + hurst_exponent));
            let densities = wave_numbers.iter().map(density).collect();
            RadialSpectrum { wave_numbers, densities }.power_law()
        };
        assert_relative_eq!(law(0.5, 3.0).unwrap().hurst_exponent, 0.5, max_relative = 1e-9);
        assert_eq!([law(2.3, 3.0), law(-0.9, 3.0), law(0.5, 0.3)], [None; 3]);
    }

    #[test]
    fn windows_keep_the_variance() {
        for window in [Window::None, Window::Hann] {
            let squares: f64 = weights(64, window).iter().map(|w| w * w).sum();
            assert_relative_eq!(squares, 64.0, max_relative = 1e-12);
        }
    }
}
