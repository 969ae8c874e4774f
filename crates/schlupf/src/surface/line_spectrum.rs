//! The spectrum of a line across a surface: of a profile, or in one-third octave bands.
//!
//! The roughness of rails is given as levels L = 20 lg(r/1 µm) of the root mean square height r in
//! bands of one third of an octave about the wavelengths 10^(k/10) m (EN 15610, EN ISO 3095). The
//! density of a band is a power of the wave number, with the exponent that its neighbours give.

use std::f64::consts::{LN_2, LN_10, TAU};

use super::ring_spectrum::{RingSpectrum, bands};
use super::synthesis::{isotropic, suitable_lattice};
use super::{HeightMap, Lattice};
use crate::numerics::vector::root_mean_square;
use crate::reporting::{Error, Quantity, Requirement, SurfaceError, require};

/// Mean variance of the waves along a line, in bands of wave numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSpectrum {
    /// Spacing of the wave numbers, in rad/m.
    step: f64,
    /// First wave of each band, and the end of the last one.
    bands: Vec<usize>,
    /// Mean variance of a wave in each band, in m².
    variances: Vec<f64>,
    /// How many observations there are of each wave.
    observations: f64,
}

/// Bands in a decade of wavelengths.
const BANDS_IN_DECADE: f64 = 10.0;

/// Deviation of a nominal wavelength, such as 3.15 mm, from that of its band, in bands.
const NOMINAL: f64 = 0.1;

/// Wavelengths in m, and levels in dB re 1 µm: farther ones are in a wrong unit.
const WAVELENGTHS: [f64; 2] = [1e-7, 100.0];
const LEVELS: [f64; 2] = [-200.0, 120.0];

/// Root mean square height of level 0, in m.
const REFERENCE: f64 = 1e-6;

/// A level is the mean of so many waves that smoothness of the spectrum does not change it.
const OBSERVATIONS: f64 = 100.0;

/// The first wave, with which the band of the longest has four.
const FIRST_WAVE: usize = 16;

/// Share of the variance in waves that are too long to count.
const NEGLIGIBLE: f64 = 1e-3;

impl LineSpectrum {
    /// From the variances (in m²) of 0, 1, … waves along a line, the spacing of their wave numbers
    /// (in rad/m), and how many observations there are of each.
    pub(super) fn of_waves(step: f64, waves: &[f64], observations: f64) -> Self {
        let bands = bands(1, waves.len());
        let mean = |band: &[usize]| {
            waves[band[0]..band[1]].iter().sum::<f64>() / (band[1] - band[0]) as f64
        };
        Self { step, variances: bands.windows(2).map(mean).collect(), bands, observations }
    }

    /// From wavelengths (in m) and levels (in dB re 1 µm) of all one-third octave bands between the
    /// first and the last one, in any order.
    ///
    /// ```
    /// use schlupf::surface::LineSpectrum;
    ///
    /// let spectrum = LineSpectrum::of_octave_bands(&[8e-3, 6.3e-3, 5e-3], &[-3.0, -4.0, -5.0])?;
    /// let squares = [-0.3, -0.4, -0.5_f64].map(|bel| 10.0_f64.powf(bel));
    /// let height = 1e-6 * squares.iter().sum::<f64>().sqrt();
    /// assert!((spectrum.root_mean_square_height() - height).abs() < 1e-9 * height);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A wavelength that is not the centre of a band, is given twice, or is missing between others;
    /// a level that is none.
    pub fn of_octave_bands(wavelengths: &[f64], levels: &[f64]) -> Result<Self, Error> {
        let (expected, count) = (wavelengths.len(), levels.len());
        if expected != count {
            return Err(Error::WrongCount { quantity: Quantity::Heights, expected, count });
        }
        let mut octaves = Vec::new();
        for (index, (&wavelength, &level)) in wavelengths.iter().zip(levels).enumerate() {
            let position = BANDS_IN_DECADE * wavelength.log10();
            let is_centre = (position - position.round()).abs() < NOMINAL;
            if !is_centre || !(WAVELENGTHS[0]..=WAVELENGTHS[1]).contains(&wavelength) {
                return Err(SurfaceError::NoOctaveBand { index, wavelength }.into());
            }
            if !(LEVELS[0]..=LEVELS[1]).contains(&level) {
                return Err(SurfaceError::NoLevel { index, level, range: LEVELS }.into());
            }
            octaves.push((position.round() as i64, index, 0.1 * level));
        }
        octaves.sort_by_key(|(band, ..)| -band);
        for pair in octaves.windows(2) {
            let index = pair[1].1;
            let wavelength = wavelengths[index];
            match pair[0].0 - pair[1].0 {
                1 => {}
                0 => return Err(SurfaceError::OctaveBandTwice { index, wavelength }.into()),
                _ => {
                    let before = wavelengths[pair[0].1];
                    return Err(
                        SurfaceError::OctaveBandMissing { index, wavelength, before }.into()
                    );
                }
            }
        }
        let Some(&(longest, ..)) = octaves.first() else {
            return Err(Error::TooFew { quantity: Quantity::Heights, fewest: 1, count: 0 });
        };
        let bels: Vec<f64> = octaves.iter().map(|(.., bel)| *bel).collect();
        Ok(Self::of_bels(&bels, libm::pow(10.0, longest as f64 / BANDS_IN_DECADE)))
    }

    /// From the levels (in bel) of adjacent bands, and the centre of the first one, that of the
    /// longest waves (in m).
    fn of_bels(bels: &[f64], longest: f64) -> Self {
        let edge = |band: usize| libm::pow(10.0, (band as f64 - 0.5) / BANDS_IN_DECADE);
        // A wave stands for all from half a step below to half a step above.
        let start = FIRST_WAVE as f64 - 0.5;
        let step = TAU / longest * edge(0) / start;
        // Variance of the waves up to the end of each band.
        let mut sums = vec![0.0];
        for bel in bels {
            let before = sums[sums.len() - 1];
            sums.push(before + REFERENCE * REFERENCE * libm::pow(10.0, *bel));
        }
        let below = |wave: f64| {
            let position = BANDS_IN_DECADE * (wave / start).log10();
            let band = (position.max(0.0) as usize).min(bels.len() - 1);
            let (before, after) = (band.saturating_sub(1), (band + 1).min(bels.len() - 1));
            let exponent = (bels[after] - bels[before]) / (after - before).max(1) as f64;
            let part = (position - band as f64).clamp(0.0, 1.0);
            let grown = |part: f64| (LN_10 * exponent * part).exp_m1();
            let share = if exponent == 0.0 { part } else { grown(part) / grown(1.0) };
            sums[band] + share * (sums[band + 1] - sums[band])
        };
        let end = (start * edge(bels.len()) / edge(0) + 0.5).ceil() as usize;
        let bands = bands(FIRST_WAVE, end);
        let variances = bands.windows(2).map(|band| {
            let [low, high] = [band[0], band[1]].map(|wave| below(wave as f64 - 0.5));
            (high - low) / (band[1] - band[0]) as f64
        });
        Self { step, variances: variances.collect(), bands, observations: OBSERVATIONS }
    }

    /// Wavelengths of the longest waves that count and of the shortest, in m.
    pub fn wavelengths(&self) -> [f64; 2] {
        let least = NEGLIGIBLE * self.variance(self.variances.len());
        let longest = (1..=self.variances.len()).position(|bands| self.variance(bands) > least);
        let shortest = self.variances.iter().rposition(|variance| *variance > 0.0);
        let wavelength = |wave: usize| TAU / (wave as f64 * self.step);
        [
            wavelength(self.bands[longest.unwrap_or(0)]),
            wavelength(self.bands[shortest.unwrap_or(0) + 1] - 1),
        ]
    }

    /// Variance (in m²) of the waves of the first bands.
    fn variance(&self, bands: usize) -> f64 {
        let each = self.bands.windows(2).zip(&self.variances).take(bands);
        each.map(|(band, variance)| (band[1] - band[0]) as f64 * variance).sum()
    }

    /// A square lattice that represents all waves, as that of a
    /// [self-affine spectrum](super::synthesis::SelfAffine::suitable_lattice) does.
    pub fn suitable_lattice(&self) -> Lattice {
        suitable_lattice(self.wavelengths())
    }

    /// Root mean square height Rq of the line, in m.
    pub fn root_mean_square_height(&self) -> f64 {
        self.variance(self.variances.len()).sqrt()
    }

    /// The spectrum without waves longer than a cut-off wavelength (in m), by the Gaussian filter
    /// of ISO 16610-21: a wave of the cut-off wavelength keeps half of its height.
    ///
    /// # Errors
    /// A cut-off wavelength shorter than all waves.
    pub fn without_waviness(&self, cutoff: f64) -> Result<Self, Error> {
        let [_, shortest] = self.wavelengths();
        require(Quantity::CutoffWavelength, Requirement::AtLeast(shortest), cutoff)?;
        let kept = |band: &[usize]| {
            let middle = 0.5 * (band[0] + band[1] - 1) as f64;
            let waves_in_cutoff = cutoff * middle * self.step / TAU;
            1.0 - libm::exp(-LN_2 * waves_in_cutoff * waves_in_cutoff)
        };
        let bands = self.bands.windows(2).zip(&self.variances);
        let variances = bands.map(|(band, variance)| kept(band).powi(2) * variance).collect();
        Ok(Self { variances, ..self.clone() })
    }

    /// The spectrum of an isotropic surface that has this line. It is higher than a line of which
    /// the longest waves are not known: oblique waves of the surface are longer along the line.
    pub fn isotropic(&self) -> RingSpectrum {
        let spectrum =
            RingSpectrum::of_line(self.step, &self.bands, &self.variances, self.observations);
        if self.bands[0] > 1 {
            return spectrum;
        }
        // All of the line is known, so that it is as high as the surface.
        let found = spectrum.root_mean_square_height();
        spectrum.scaled(self.root_mean_square_height() / found)
    }

    /// An isotropic surface that has lines with this spectrum. Waves longer than the lattice and
    /// shorter than two of its cells are missing, and so is their share of the height.
    ///
    /// # Errors
    /// A lattice on which none of the waves is.
    pub fn isotropic_surface(&self, lattice: Lattice, seed: u64) -> Result<HeightMap, Error> {
        let spectrum = self.isotropic();
        let surface = isotropic(lattice, |q| spectrum.density(q), seed)?;
        let longest = lattice.length_x().max(lattice.length_y());
        let shortest = 2.0 * lattice.spacing_x.max(lattice.spacing_y);
        let carried = spectrum.height_between([0.5 * TAU / longest, TAU / shortest]);
        let found = root_mean_square(surface.heights());
        if carried <= 0.0 || found <= 0.0 {
            let (waves, lattice) = (self.wavelengths(), [longest, shortest]);
            return Err(SurfaceError::NoWaveFits { waves, lattice }.into());
        }
        surface.require_rough()?;
        Ok(surface.scaled(carried / found))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::*;

    /// Wavelengths of bands, in m.
    fn bands(range: std::ops::RangeInclusive<i32>) -> Vec<f64> {
        range.map(|band| libm::pow(10.0, f64::from(band) / 10.0)).collect()
    }

    /// Goal: the bands of a line give the spectrum of its surface back. Set-up: C(q) = q^−3.6
    /// without ends, whose line has a spectrum ∝ q^−2.6, over 2.5 decades; by the closed form of
    /// the integral over a strip, √π Γ(1.3)/Γ(1.8) q^−2.6.
    #[test]
    fn bands_of_a_power_law_give_its_exponent_and_its_height() {
        let wavelengths = bands(-25..=-1);
        let edges =
            |wavelength: f64| [0.05, -0.05].map(|half| TAU / (wavelength * libm::pow(10.0, half)));
        let unit = 1e-9;
        let integral = 1.707_916 * unit;
        let levels: Vec<f64> = wavelengths
            .iter()
            .map(|wavelength| {
                let [low, high] = edges(*wavelength);
                // Waves of either sign.
                let variance = 2.0 * integral / 1.6 * (low.powf(-1.6) - high.powf(-1.6));
                10.0 * (variance / 1e-12).log10()
            })
            .collect();
        let line = LineSpectrum::of_octave_bands(&wavelengths, &levels).unwrap();
        let sum: f64 = levels.iter().map(|level| 1e-12 * 10.0_f64.powf(level / 10.0)).sum();
        assert_relative_eq!(line.root_mean_square_height(), sum.sqrt(), max_relative = 1e-12);
        let spectrum = line.isotropic();
        // Away from the shortest waves, where those that are shorter still are missing here; by the
        // variance, because C is constant in rings.
        for wavelength in bands(-20..=-2) {
            let [low, high] = edges(wavelength);
            let exact = 2.0 * PI * unit / 1.6 * (low.powf(-1.6) - high.powf(-1.6));
            let found = spectrum.height_between([low, high]).powi(2);
            assert_relative_eq!(found, exact, max_relative = 0.05);
        }
    }

    /// The lines of a surface have the levels of the bands. Set-up: a side of eight of the longest
    /// waves, so that a band of the lines has two to four waves, in 240 lines.
    #[test]
    fn lines_of_a_surface_have_the_levels_of_the_bands() {
        let wavelengths = [1e-2, 8e-3, 6.3e-3, 5e-3, 4e-3, 3.15e-3];
        let line = LineSpectrum::of_octave_bands(&wavelengths, &[0.0; 6]).unwrap();
        let [longest, shortest] = line.wavelengths();
        assert_relative_eq!(
            longest,
            1e-2 * libm::pow(10.0, 0.05) * 15.5 / 16.0,
            max_relative = 1e-12
        );
        assert_relative_eq!(shortest, libm::pow(10.0, -2.55), max_relative = 0.02);
        let cells = 240;
        let surface = line.isotropic_surface(Lattice::square(cells, 0.08), 3).unwrap();
        let variance = |wave: usize| {
            let of_line = |row: &[f64]| {
                let part = |shift: f64| -> f64 {
                    let at = |i: usize| TAU * (wave * i) as f64 / cells as f64 + shift;
                    row.iter().enumerate().map(|(i, height)| height * at(i).cos()).sum()
                };
                2.0 * (part(0.0).powi(2) + part(0.25 * TAU).powi(2)) / (cells * cells) as f64
            };
            surface.heights().chunks_exact(cells).map(of_line).sum::<f64>() / cells as f64
        };
        // From half a wave below to half a wave above: 7.5 to 28.5 waves, 10.7 to 2.8 mm.
        let found: f64 = (8..=28).map(variance).sum();
        let share = 1.0 - 10.0 * (0.01_f64 * 1.122 / (0.08 / 7.5)).log10();
        assert_relative_eq!(found, 1e-12 * (5.0 + share), max_relative = 0.1);
    }

    /// A wave of the cut-off wavelength keeps half of its height, those much shorter all of it.
    #[test]
    fn the_filter_takes_long_waves() {
        let level = |wavelength: f64, cutoff: f64| {
            let line = LineSpectrum::of_octave_bands(&[wavelength], &[0.0]).unwrap();
            line.without_waviness(cutoff).unwrap().root_mean_square_height()
        };
        // The band reaches from 8.9 to 11.2 mm.
        assert_relative_eq!(level(0.01, 0.01), 0.5e-6, max_relative = 0.02);
        assert_relative_eq!(level(0.01, 0.1), 1e-6, max_relative = 1e-9);
        let line = LineSpectrum::of_octave_bands(&[0.01], &[0.0]).unwrap();
        let message = line.without_waviness(1e-3).unwrap_err().to_string();
        assert!(message.contains("cutoff_wavelength must be at least"), "{message}");
    }

    /// Whatever the longest band, it has all of its variance in four waves; wide spectra take no
    /// memory.
    #[test]
    fn every_band_has_its_variance() {
        for band in -60..=10 {
            let line = LineSpectrum::of_octave_bands(&bands(band..=band), &[0.0]).unwrap();
            assert_eq!(line.bands[0], FIRST_WAVE);
            assert_relative_eq!(line.root_mean_square_height(), 1e-6, max_relative = 1e-12);
        }
        let nearly = [0.0, 1e-15, 0.0, 1e-300];
        let line = LineSpectrum::of_octave_bands(&bands(-24..=-21), &nearly).unwrap();
        assert_relative_eq!(line.root_mean_square_height(), 2e-6, max_relative = 1e-12);
        let wide = LineSpectrum::of_octave_bands(&bands(-60..=0), &[-3.0; 61]).unwrap();
        assert!(wide.variances.len() < 200);
        assert!(wide.isotropic().root_mean_square_height() > wide.root_mean_square_height());
    }

    #[test]
    fn what_is_no_series_of_bands_is_refused() {
        let refused = |wavelengths: &[f64], levels: &[f64], expected: &str| {
            let error = LineSpectrum::of_octave_bands(wavelengths, levels).unwrap_err();
            assert!(error.to_string().contains(expected), "{error}");
        };
        refused(&[0.01, 0.009], &[0.0; 2], "but one is 9e-3 m");
        for wavelength in [-0.01, 0.0, f64::NAN, f64::INFINITY, 1e-309, 1e-9, 1e3] {
            refused(&[wavelength], &[0.0], "must be centres of one-third octave bands");
        }
        for level in [f64::NAN, f64::NEG_INFINITY, 300.0] {
            refused(&[0.01], &[level], "must have levels from -200 to 120 dB");
        }
        refused(&[0.01, 0.005, 0.0063], &[0.0; 3], "between 0.01 m and 6.3e-3 m");
        refused(&[0.01, 0.01], &[0.0; 2], "twice");
        refused(&[], &[], "at least 1 entry");
        refused(&[0.01], &[], "needs 1 values, got 0");
        let line = LineSpectrum::of_octave_bands(&[0.01], &[0.0]).unwrap();
        let message = line.isotropic_surface(Lattice::square(64, 1e-3), 1).unwrap_err().to_string();
        assert!(message.contains("none of its waves"), "{message}");
    }
}
