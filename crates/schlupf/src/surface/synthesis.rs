//! Random surfaces with a given spectrum.
//!
//! Every wave vector q gets the amplitude required by its spectral density and a random phase, so
//! that the variance of heights and gradients is that of the spectrum in every single surface.
//! Phases are drawn in order of increasing wave vectors, in square rings: the same seed on a finer
//! lattice gives the same surface with more detail.
//!
//! Phases come from a PCG XSL 128/64 generator (O'Neill 2014), identical on every machine; heights
//! are identical to rounding error of the Fourier transform.

use std::f64::consts::TAU;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use rustfft::num_complex::Complex;

use super::spectrum::spectral_gradient;
use super::{HeightMap, LARGEST, Lattice};
use crate::numerics::fourier::{RealTransform, smooth_from};
use crate::numerics::vector::root_mean_square;
use crate::reporting::{Error, Quantity, Requirement, SurfaceError, require, require_positive};

/// Prescribed roughness of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Roughness {
    /// Root mean square height h_rms, in m.
    Height(f64),
    /// Root mean square gradient h'_rms of the spectrum, dimensionless.
    Gradient(f64),
}

/// A self-affine spectrum: C(q) constant from the longest wavelength to the roll-off, then C ∝
/// q^(−2(1+H)) down to the shortest wavelength, zero elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SelfAffine {
    /// Roughness of the surface.
    pub roughness: Roughness,
    /// Hurst exponent H, dimensionless, between 0 and 1.
    pub hurst_exponent: f64,
    /// Longest wavelength, in m.
    pub longest_wavelength: f64,
    /// Wavelength of the roll-off, in m.
    pub roll_off_wavelength: f64,
    /// Shortest wavelength, in m.
    pub shortest_wavelength: f64,
}

/// For a suitable lattice: cells per shortest wave, maximum number of longest waves along a side,
/// and maximum number of cells along a side as long as the longest wave fits twice.
const CELLS_IN_SHORTEST: f64 = 4.0;
const LONGEST_WAVES: [f64; 2] = [2.0, 8.0];
const MOST_CELLS: f64 = 1024.0;

impl SelfAffine {
    /// A square lattice that represents all waves: with four cells per shortest one, and up to
    /// eight of the longest along a side of at most 1024 cells. If only two of them fit, the cells
    /// grow to half the shortest wave; beyond that there are more cells.
    pub fn suitable_lattice(&self) -> Lattice {
        suitable_lattice([self.longest_wavelength, self.shortest_wavelength])
    }

    /// A surface with zero mean height and exactly the given roughness.
    ///
    /// ```
    /// use schlupf::surface::synthesis::{Roughness, SelfAffine};
    /// use schlupf::surface::{Lattice, Statistics};
    ///
    /// let spectrum = SelfAffine {
    ///     roughness: Roughness::Height(1e-6),
    ///     hurst_exponent: 0.8,
    ///     longest_wavelength: 0.5e-3,
    ///     roll_off_wavelength: 0.25e-3,
    ///     shortest_wavelength: 0.05e-3,
    /// };
    /// let surface = spectrum.surface(Lattice::square(64, 1e-3), 1)?;
    /// assert!((Statistics::of(&surface)?.root_mean_square_height - 1e-6).abs() < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn surface(&self, lattice: Lattice, seed: u64) -> Result<HeightMap, Error> {
        lattice.check()?;
        self.check(&lattice)?;
        let surface = isotropic(lattice, |q| self.shape(q), seed)?;
        surface.require_rough()?;
        let (wanted, there) = match self.roughness {
            Roughness::Height(height) => (height, root_mean_square(surface.heights())),
            Roughness::Gradient(gradient) => (gradient, spectral_gradient(&surface)),
        };
        Ok(surface.scaled(wanted / there))
    }

    /// C(q) relative to its value at the roll-off, dimensionless.
    fn shape(&self, q: f64) -> f64 {
        let inside = |wavelength: f64, rounding: f64| TAU / wavelength * (1.0 + rounding);
        if q < inside(self.longest_wavelength, -ROUNDING)
            || q > inside(self.shortest_wavelength, ROUNDING)
        {
            return 0.0;
        }
        let ratio = q * self.roll_off_wavelength / TAU;
        libm::pow(ratio.max(1.0), -2.0 * (1.0 + self.hurst_exponent))
    }

    fn check(&self, lattice: &Lattice) -> Result<(), Error> {
        match self.roughness {
            Roughness::Height(height) => require_positive(Quantity::RmsHeight, height)?,
            Roughness::Gradient(gradient) => require_positive(Quantity::RmsSlope, gradient)?,
        }
        let between = Requirement::Between;
        require(Quantity::HurstExponent, between(0.0, 1.0), self.hurst_exponent)?;
        let (longest, shortest) = (self.longest_wavelength, self.shortest_wavelength);
        let side = lattice.length_x().min(lattice.length_y());
        let up_to_side = Requirement::AboveUpTo(0.0, side * (1.0 + ROUNDING));
        require(Quantity::LongestWavelength, up_to_side, longest)?;
        let roll_off = between(shortest, longest * (1.0 + ROUNDING));
        require(Quantity::RollOffWavelength, roll_off, self.roll_off_wavelength)?;
        let two_cells = 2.0 * lattice.spacing_x.max(lattice.spacing_y);
        require_positive(Quantity::ShortestWavelength, shortest)?;
        if shortest < two_cells * (1.0 - ROUNDING) {
            return Err(SurfaceError::ShortWaves { shortest, two_cells }.into());
        }
        Ok(())
    }
}

/// A lattice that represents the waves between two wavelengths (in m).
pub(super) fn suitable_lattice([longest, shortest]: [f64; 2]) -> Lattice {
    let ratio = (longest / shortest).max(1.0);
    let [least, most] = LONGEST_WAVES;
    let waves = (MOST_CELLS / (CELLS_IN_SHORTEST * ratio)).floor().clamp(least, most);
    let wanted = (waves * ratio * CELLS_IN_SHORTEST).min(MOST_CELLS).max(2.0 * waves * ratio);
    let cells = smooth_from((wanted * (1.0 - ROUNDING)).ceil().min(LARGEST as f64) as usize);
    Lattice::square(cells, waves * longest)
}

/// Wavelengths of exactly an integer number of waves must not be lost to rounding error.
const ROUNDING: f64 = 1e-9;

/// An isotropic surface with the spectral density C(q) (in m⁴, of q in rad/m) and zero mean height.
/// Waves shorter than two cells are omitted.
///
/// ```
/// use schlupf::surface::Lattice;
/// use schlupf::surface::synthesis::isotropic;
///
/// let white = isotropic(Lattice::square(32, 1e-4), |_| 1e-24, 7)?;
/// assert_eq!(white.heights().len(), 32 * 32);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn isotropic(
    lattice: Lattice,
    density: impl Fn(f64) -> f64,
    seed: u64,
) -> Result<HeightMap, Error> {
    lattice.check()?;
    let size = [lattice.columns, lattice.rows];
    let mut transform = RealTransform::new(size, size);
    let step = [TAU / lattice.length_x(), TAU / lattice.length_y()];
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let reach = size.map(|count| (count as i64 - 1) / 2);
    let rows = lattice.rows as i64;
    let spectrum = transform.spectrum_mut();
    for [i, j] in half_plane(reach[0].max(reach[1])) {
        let phase = TAU * uniform(&mut random);
        if i > reach[0] || j.abs() > reach[1] {
            continue;
        }
        let q = (i as f64 * step[0]).hypot(j as f64 * step[1]);
        // |h_q|² = C(q) 4π²/A
        let amplitude = (density(q) * step[0] * step[1]).sqrt();
        let value = Complex::new(libm::cos(phase), libm::sin(phase)) * amplitude;
        let row = |j: i64| j.rem_euclid(rows) as usize;
        spectrum[i as usize * lattice.rows + row(j)] = value;
        if i == 0 {
            spectrum[row(-j)] = value.conj();
        }
    }
    let mut heights = vec![0.0; lattice.len()];
    transform.inverse(&mut heights);
    Ok(HeightMap::new(lattice, heights)?.into_periodic())
}

/// Wave vectors of which no two are opposite, in order of increasing largest component.
fn half_plane(reach: i64) -> impl Iterator<Item = [i64; 2]> {
    (1..=reach).flat_map(|ring| {
        let side = (-ring..=ring).map(move |j| [ring, j]);
        let ends = (0..ring).flat_map(move |i| [[i, ring], [i, -ring]]);
        side.chain(ends.filter(|[i, j]| *i > 0 || *j > 0))
    })
}

/// A number from 0 to less than 1 with 53 random bits.
fn uniform(random: &mut Pcg64Mcg) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::spectrum::{RadialSpectrum, Window};
    use super::super::statistics::Statistics;
    use super::*;

    const SPECTRUM: SelfAffine = SelfAffine {
        roughness: Roughness::Height(0.8e-6),
        hurst_exponent: 0.8,
        longest_wavelength: 100e-6,
        roll_off_wavelength: 50e-6,
        shortest_wavelength: 5e-6,
    };

    #[test]
    fn the_roughness_is_exactly_that_asked_for() {
        let lattice = Lattice { columns: 120, rows: 100, spacing_x: 1e-6, spacing_y: 1.5e-6 };
        let surface = SPECTRUM.surface(lattice, 7).unwrap();
        let statistics = Statistics::of(&surface).unwrap();
        assert_relative_eq!(statistics.root_mean_square_height, 0.8e-6, max_relative = 1e-12);
        assert_relative_eq!(surface.mean(), 0.0, epsilon = 1e-18);
        let steep = SelfAffine { roughness: Roughness::Gradient(0.1), ..SPECTRUM };
        let statistics = Statistics::of(&steep.surface(lattice, 7).unwrap()).unwrap();
        assert_relative_eq!(statistics.spectral_gradient, 0.1, max_relative = 1e-12);
    }

    /// The computed spectrum is the prescribed one: a plateau, then q^(−2(1+H)).
    #[test]
    fn the_spectrum_is_that_asked_for() {
        let surface = SPECTRUM.surface(Lattice::square(200, 100e-6), 1).unwrap();
        let spectrum = RadialSpectrum::of(&surface, Window::None);
        let at = |wave: usize| spectrum.densities[wave - 1];
        assert_relative_eq!(at(1), at(2), max_relative = 0.25);
        let slope = (at(16) / at(4)).log2() / 2.0;
        assert_relative_eq!(slope, -3.6, max_relative = 0.02);
        assert!(at(22) < 1e-12 * at(18), "{} {}", at(22), at(18));
    }

    /// Goal: a finer lattice has the same waves and additional ones. Its shortest waves are new,
    /// and at the points of the coarse lattice the old ones agree.
    #[test]
    fn a_finer_lattice_keeps_the_surface() {
        let coarse = SPECTRUM.surface(Lattice::square(60, 100e-6), 3).unwrap();
        let fine = SPECTRUM.surface(Lattice::square(180, 100e-6), 3).unwrap();
        for (row, column) in [(0, 0), (17, 5), (59, 31)] {
            // The centre of a coarse cell is that of the middle one of three fine ones; the whole
            // surface starts at the centre of the first cell.
            let here = coarse.heights()[row * 60 + column];
            let there = fine.heights()[3 * row * 180 + 3 * column];
            assert_relative_eq!(here, there, max_relative = 1e-9);
        }
    }

    #[test]
    fn seeds_give_surfaces_of_their_own_and_the_same_one_again() {
        let lattice = Lattice::square(40, 100e-6);
        let surface = |seed| SPECTRUM.surface(lattice, seed).unwrap();
        assert_eq!(surface(1), surface(1));
        assert_ne!(surface(1), surface(2));
    }

    #[test]
    fn a_suitable_lattice_carries_all_waves() {
        let of = |longest_wavelength: f64, shortest_wavelength: f64| {
            let roll_off_wavelength = longest_wavelength;
            let spectrum = SelfAffine {
                longest_wavelength,
                roll_off_wavelength,
                shortest_wavelength,
                ..SPECTRUM
            };
            let lattice = spectrum.suitable_lattice();
            spectrum.check(&lattice).unwrap();
            (lattice.columns, (lattice.length_x() / longest_wavelength).round())
        };
        assert_eq!(of(1e-4, 1e-5), (320, 8.0));
        assert_eq!(of(1e-4, 2e-6), (1000, 5.0));
        assert_eq!(of(1e-4, 5e-7), (1024, 2.0));
        assert_eq!(of(1e-4, 1e-7).1, 2.0);
    }

    #[test]
    fn each_defect_is_named() {
        let cases = [
            (SelfAffine { hurst_exponent: 1.2, ..SPECTRUM }, "hurst_exponent must be"),
            (
                SelfAffine { longest_wavelength: 2e-4, ..SPECTRUM },
                "longest_wavelength must be above 0 and at most",
            ),
            (SelfAffine { roll_off_wavelength: 2e-4, ..SPECTRUM }, "roll_off_wavelength"),
            (SelfAffine { shortest_wavelength: 1e-6, ..SPECTRUM }, "at least two cells"),
            (SelfAffine { roughness: Roughness::Height(0.0), ..SPECTRUM }, "rms_height"),
            (SelfAffine { shortest_wavelength: f64::NAN, ..SPECTRUM }, "wavelength"),
        ];
        for (spectrum, expected) in cases {
            let message = spectrum.surface(Lattice::square(50, 100e-6), 0).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
