//! The spectrum of a line across a surface: of a profile, or in one-third octave bands.
//!
//! The roughness of rails is given as levels L = 20 lg(r/1 µm) of the root mean square height r in
//! bands of one third of an octave about the wavelengths 10^(k/10) m (EN 15610, EN ISO 3095). The
//! density of a band is a power of the wave number, with the exponent that its neighbours give.

use std::f64::consts::{LN_2, TAU};

use super::ring_spectrum::RingSpectrum;
use super::synthesis::{isotropic, suitable_lattice};
use super::{HeightMap, Lattice};
use crate::numerics::vector::root_mean_square;
use crate::reporting::{Error, Quantity, Requirement, SurfaceError, require};

/// Variance of the heights along a line by number of waves.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSpectrum {
    /// Distance of two wave numbers, in rad/m.
    step: f64,
    /// Of 0, 1, … steps, in m².
    variances: Vec<f64>,
    /// How many observations each is the mean of.
    observations: f64,
}

/// Bands in a decade of wavelengths.
const BANDS_IN_DECADE: f64 = 10.0;

/// Deviation of a nominal wavelength, such as 3.15 mm, from that of its band, in bands.
const NOMINAL: f64 = 0.1;

/// Root mean square height of level 0, in m.
const REFERENCE: f64 = 1e-6;

/// Levels of bands are means over many waves, and are met.
const OBSERVATIONS: f64 = 100.0;

/// Number of the first wave: four are in the band of the longest.
const FIRST_WAVE: f64 = 16.0;

impl LineSpectrum {
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
    /// A wavelength that is none of a band, is given twice, or is missing between others.
    pub fn of_octave_bands(wavelengths: &[f64], levels: &[f64]) -> Result<Self, Error> {
        let refuse = |index: usize, expected| {
            let wavelength = wavelengths[index];
            Error::from(SurfaceError::OctaveBands { index, wavelength, expected })
        };
        let mut bands = Vec::new();
        for (index, (&wavelength, &level)) in wavelengths.iter().zip(levels).enumerate() {
            let position = BANDS_IN_DECADE * wavelength.log10();
            let is_band = (position - position.round()).abs() < NOMINAL;
            if !is_band || !level.is_finite() {
                return Err(refuse(index, None));
            }
            bands.push((position.round() as i64, index, level));
        }
        bands.sort_by_key(|(band, ..)| -band);
        for pair in bands.windows(2) {
            let next = pair[0].0 - 1;
            if pair[1].0 != next {
                let expected = libm::pow(10.0, next as f64 / BANDS_IN_DECADE);
                return Err(refuse(pair[1].1, Some(expected)));
            }
        }
        let Some(&(longest, ..)) = bands.first() else {
            return Err(Error::TooFew { quantity: Quantity::Heights, fewest: 1, count: 0 });
        };
        let edge =
            |band: i64, side: f64| TAU / libm::pow(10.0, (band as f64 + side) / BANDS_IN_DECADE);
        // A wave stands for all from half a step below to half a step above.
        let step = edge(longest, 0.5) / (FIRST_WAVE - 0.5);
        let mut variances = Vec::new();
        let bel = |k: usize| 0.1 * bands[k].2;
        for (k, &(band, ..)) in bands.iter().enumerate() {
            let variance = REFERENCE * REFERENCE * libm::pow(10.0, bel(k));
            let (before, after) = (k.saturating_sub(1), (k + 1).min(bands.len() - 1));
            let exponent =
                BANDS_IN_DECADE * (bel(after) - bel(before)) / (after - before).max(1) as f64;
            let [low, high] = [0.5, -0.5].map(|side| edge(band, side) / step);
            // Share of the band below a number of waves.
            let below = |wave: f64| {
                let of = |wave: f64| match (wave / low).ln() {
                    wide if exponent == 0.0 => wide,
                    wide => (exponent * wide).exp_m1(),
                };
                of(wave.clamp(low, high)) / of(high)
            };
            let last = (high + 0.5).floor() as usize;
            variances.resize(last + 1, 0.0);
            for (wave, sum) in variances.iter_mut().enumerate().skip((low + 0.5) as usize) {
                let middle = wave as f64;
                *sum += variance * (below(middle + 0.5) - below(middle - 0.5));
            }
        }
        Ok(Self { step, variances, observations: OBSERVATIONS })
    }

    /// From the variances (in m²) of 0, 1, … waves, the distance of their wave numbers (in rad/m),
    /// and how many independent observations each is.
    pub(super) fn new(step: f64, variances: Vec<f64>, observations: f64) -> Self {
        Self { step, variances, observations }
    }

    /// Wavelengths of the longest and the shortest waves that have a height, in m.
    pub fn wavelengths(&self) -> [f64; 2] {
        let has_height = |wave: &usize| *wave > 0 && self.variances[*wave] > 0.0;
        let mut waves = (0..self.variances.len()).filter(has_height);
        let longest = waves.next().unwrap_or(1);
        let shortest = waves.next_back().unwrap_or(longest);
        [longest, shortest].map(|wave| TAU / (wave as f64 * self.step))
    }

    /// A square lattice that represents all waves, as that of a
    /// [self-affine spectrum](super::synthesis::SelfAffine::suitable_lattice) does.
    pub fn suitable_lattice(&self) -> Lattice {
        suitable_lattice(self.wavelengths())
    }

    /// Root mean square height Rq of the line, in m.
    pub fn root_mean_square_height(&self) -> f64 {
        self.variances.iter().skip(1).sum::<f64>().sqrt()
    }

    /// The spectrum without waves longer than a cut-off wavelength (in m), by the Gaussian filter of
    /// ISO 16610-21: a wave of the cut-off wavelength keeps half of its height.
    ///
    /// # Errors
    /// A cut-off wavelength shorter than all waves.
    pub fn without_waviness(&self, cutoff: f64) -> Result<Self, Error> {
        let [_, shortest] = self.wavelengths();
        require(Quantity::CutoffWavelength, Requirement::AtLeast(shortest), cutoff)?;
        let kept = |wave: usize| {
            let waves_in_cutoff = cutoff * wave as f64 * self.step / TAU;
            1.0 - libm::exp(-LN_2 * waves_in_cutoff * waves_in_cutoff)
        };
        let waves = self.variances.iter().enumerate();
        let variances = waves.map(|(wave, variance)| kept(wave).powi(2) * variance).collect();
        Ok(Self { variances, ..*self })
    }

    /// The spectrum of an isotropic surface that has this line. It is higher than a line of which
    /// the longest waves are not known: oblique waves of the surface are longer along the line.
    pub fn isotropic(&self) -> RingSpectrum {
        let spectrum = RingSpectrum::of_line(&self.variances, self.step, self.observations);
        if self.variances.get(1).is_none_or(|variance| *variance == 0.0) {
            return spectrum;
        }
        // All of the line is known, so that it is as high as the surface.
        let found = spectrum.root_mean_square_height();
        spectrum.scaled(self.root_mean_square_height() / found)
    }

    /// An isotropic surface that has lines with this spectrum. Waves longer than the lattice and
    /// shorter than two of its cells are missing, and so is their share of the height.
    pub fn isotropic_surface(&self, lattice: Lattice, seed: u64) -> Result<HeightMap, Error> {
        let spectrum = self.isotropic();
        let surface = isotropic(lattice, |q| spectrum.density(q), seed)?;
        let longest = lattice.length_x().max(lattice.length_y());
        let shortest = 2.0 * lattice.spacing_x.max(lattice.spacing_y);
        let carried = spectrum.height_between([0.5 * TAU / longest, TAU / shortest]);
        let found = root_mean_square(surface.heights());
        surface.require_rough()?;
        Ok(surface.scaled(carried / found))
    }
}

#[cfg(test)]
mod tests {
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
        // Away from the ends, beyond which there is nothing here; within a ring, a tenth wide, C is
        // constant.
        for wavelength in bands(-20..=-4) {
            let q = TAU / wavelength;
            assert_relative_eq!(spectrum.density(q), unit * q.powf(-3.6), max_relative = 0.2);
        }
    }

    /// The lines of a surface have the levels of the bands. Set-up: a side of eight of the longest
    /// waves, so that a band of the lines has two to four waves, in 240 lines.
    #[test]
    fn lines_of_a_surface_have_the_levels_of_the_bands() {
        let wavelengths = [1e-2, 8e-3, 6.3e-3, 5e-3, 4e-3, 3.15e-3];
        let line = LineSpectrum::of_octave_bands(&wavelengths, &[0.0; 6]).unwrap();
        let [longest, shortest] = line.wavelengths();
        assert_relative_eq!(longest, 1e-2 * libm::pow(10.0, 0.05), max_relative = 0.05);
        assert_relative_eq!(shortest, libm::pow(10.0, -2.55), max_relative = 0.05);
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

    #[test]
    fn what_is_no_series_of_bands_is_refused() {
        let refused = |wavelengths: &[f64], levels: &[f64], expected: &str| {
            let error = LineSpectrum::of_octave_bands(wavelengths, levels).unwrap_err();
            assert!(error.to_string().contains(expected), "{error}");
        };
        refused(&[0.01, 0.009], &[0.0; 2], "but has one at 9e-3 m");
        refused(&[-0.01], &[0.0], "but has one at -0.01 m");
        refused(&[0.01], &[f64::NAN], "finite levels");
        refused(&[0.01, 0.005, 0.0063], &[0.0; 3], "is missing");
        refused(&[0.01, 0.01], &[0.0; 2], "is given twice");
        refused(&[], &[], "at least 1");
    }
}
