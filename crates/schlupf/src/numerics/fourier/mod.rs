//! The Fourier transform of a real field on a regular lattice, optionally padded with zeros.
//!
//! F(k) = Σ f(x) exp(−i k·x), of which half is kept: the transform of a real field at −k is the
//! conjugate of that at k. Every line is transformed on its own, in a fixed order, so the same
//! field gives bit-identical results.

pub(crate) mod cosine;

use std::f64::consts::TAU;
use std::fmt;
use std::sync::Arc;

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

const ZERO: Complex<f64> = Complex { re: 0.0, im: 0.0 };

/// Transform of fields of one size, with its plans and buffers.
///
/// The spectrum is kept column by column: wave number i along x (0 to n/2), j across, at
/// `i * size[1] + j`.
pub(crate) struct RealTransform {
    /// Columns and rows of the field.
    filled: [usize; 2],
    /// Columns and rows including the padding: the lengths of the transforms.
    size: [usize; 2],
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    across: [Arc<dyn Fft<f64>>; 2],
    line: Vec<f64>,
    /// Half the spectrum of every filled row, row by row.
    lines: Vec<Complex<f64>>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl RealTransform {
    /// For fields that fill `filled` columns and rows of a lattice of `size`.
    pub(crate) fn new(filled: [usize; 2], size: [usize; 2]) -> Self {
        let mut real = RealFftPlanner::new();
        let (forward, inverse) = (real.plan_fft_forward(size[0]), real.plan_fft_inverse(size[0]));
        let mut complex = FftPlanner::new();
        let across = [complex.plan_fft_forward(size[1]), complex.plan_fft_inverse(size[1])];
        let scratch = across.iter().map(|fft| fft.get_inplace_scratch_len());
        let scratch = scratch.chain([forward.get_scratch_len(), inverse.get_scratch_len()]).max();
        let half = size[0] / 2 + 1;
        Self {
            filled,
            size,
            forward,
            inverse,
            across,
            line: vec![0.0; size[0]],
            lines: vec![ZERO; half * filled[1]],
            spectrum: vec![ZERO; half * size[1]],
            scratch: vec![ZERO; scratch.unwrap_or(0)],
        }
    }

    /// The spectrum.
    pub(crate) fn spectrum(&self) -> &[Complex<f64>] {
        &self.spectrum
    }

    /// The spectrum, to be changed or filled before [`Self::inverse`].
    pub(crate) fn spectrum_mut(&mut self) -> &mut [Complex<f64>] {
        &mut self.spectrum
    }

    /// Transforms a field, its rows along x one after another.
    pub(crate) fn forward(&mut self, field: &[f64]) {
        let half = self.half();
        let rows = field.chunks_exact(self.filled[0]).zip(self.lines.chunks_exact_mut(half));
        for (row, line) in rows {
            let (filled, padding) = self.line.split_at_mut(self.filled[0]);
            filled.copy_from_slice(row);
            padding.fill(0.0);
            // It fails only for slices of the wrong length.
            let _ = self.forward.process_with_scratch(&mut self.line, line, &mut self.scratch);
        }
        let (filled, ny) = (self.filled[1], self.size[1]);
        transpose(&self.lines, &mut self.spectrum, [half, filled], ny);
        for column in self.spectrum.chunks_exact_mut(ny) {
            column[filled..].fill(ZERO);
        }
        self.across[0].process_with_scratch(&mut self.spectrum, &mut self.scratch);
    }

    /// Transforms back from the spectrum, which is destroyed, without the factor of one over the
    /// number of points.
    pub(crate) fn inverse(&mut self, field: &mut [f64]) {
        let half = self.half();
        let is_even = self.size[0].is_multiple_of(2);
        self.across[1].process_with_scratch(&mut self.spectrum, &mut self.scratch);
        transpose_back(&self.spectrum, &mut self.lines, [half, self.filled[1]], self.size[1]);
        let rows = field.chunks_exact_mut(self.filled[0]).zip(self.lines.chunks_exact_mut(half));
        for (row, line) in rows {
            // A self-conjugate value is real; its imaginary part is rounding error.
            line[0].im = 0.0;
            if is_even {
                line[half - 1].im = 0.0;
            }
            // It fails only for slices of the wrong length.
            let _ = self.inverse.process_with_scratch(line, &mut self.line, &mut self.scratch);
            row.copy_from_slice(&self.line[..self.filled[0]]);
        }
    }

    /// Multiplies the spectrum by real numbers, given in its order.
    pub(crate) fn multiply(&mut self, symbol: &[f64]) {
        for (value, factor) in self.spectrum.iter_mut().zip(symbol) {
            *value *= factor;
        }
    }

    /// Wave vectors in the order of the spectrum, as integer numbers of waves along x and y.
    pub(crate) fn wave_vectors(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [nx, ny] = self.size;
        let signed = move |j: usize| if 2 * j <= ny { j as f64 } else { j as f64 - ny as f64 };
        (0..=nx / 2).flat_map(move |i| (0..ny).map(move |j| [i as f64, signed(j)]))
    }

    /// |k| in the order of the spectrum, for a lattice of the given spacings: in 1/m for spacings
    /// in m.
    pub(crate) fn wave_numbers(&self, spacing: [f64; 2]) -> impl Iterator<Item = f64> + use<> {
        let step = [0, 1].map(|c| TAU / (self.size[c] as f64 * spacing[c]));
        self.wave_vectors().map(move |[i, j]| (i * step[0]).hypot(j * step[1]))
    }

    /// Multiplicity of each value in the full spectrum, in its order: one if it is its own mirror
    /// along x, otherwise two.
    pub(crate) fn multiplicities(&self) -> impl Iterator<Item = f64> + use<> {
        let [nx, ny] = self.size;
        (0..=nx / 2).flat_map(move |i| {
            let multiplicity = if i == 0 || 2 * i == nx { 1.0 } else { 2.0 };
            std::iter::repeat_n(multiplicity, ny)
        })
    }

    fn half(&self) -> usize {
        self.size[0] / 2 + 1
    }
}

impl fmt::Debug for RealTransform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RealTransform").field("size", &self.size).finish_non_exhaustive()
    }
}

/// The distance that a place on a periodic line of so many stands for: beyond half of them it is
/// negative.
pub(crate) fn wrapped(k: usize, count: usize) -> isize {
    if 2 * k < count { k as isize } else { k as isize - count as isize }
}

/// The smallest product of 2, 3 and 5 that is not below `least`: efficient lengths for the fast
/// transforms.
pub(crate) fn smooth_from(least: usize) -> usize {
    let is_smooth = |mut n: usize| {
        for factor in [2, 3, 5] {
            while n.is_multiple_of(factor) {
                n /= factor;
            }
        }
        n == 1
    };
    // A power of two is smooth, so the search ends.
    (least..=2 * least).find(|n| is_smooth(*n)).unwrap_or(least)
}

/// Tile size for the transposition, chosen so that both sides stay in the cache.
const TILE: usize = 16;

/// Writes the rows of `from` (each `columns` long) as the beginnings of the columns of `to` (each
/// `stride` long).
pub(crate) fn transpose(
    from: &[Complex<f64>],
    to: &mut [Complex<f64>],
    [columns, rows]: [usize; 2],
    stride: usize,
) {
    for first in (0..rows).step_by(TILE) {
        for i in 0..columns {
            for j in first..rows.min(first + TILE) {
                to[i * stride + j] = from[j * columns + i];
            }
        }
    }
}

/// The reverse.
pub(crate) fn transpose_back(
    from: &[Complex<f64>],
    to: &mut [Complex<f64>],
    [columns, rows]: [usize; 2],
    stride: usize,
) {
    for first in (0..columns).step_by(TILE) {
        for j in 0..rows {
            for i in first..columns.min(first + TILE) {
                to[j * columns + i] = from[i * stride + j];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Round trips preserve fields of even and odd lengths, with padding and without.
    #[test]
    fn there_and_back_is_the_field_times_the_number_of_points() {
        for (filled, size) in [([6, 4], [6, 4]), ([5, 3], [9, 5]), ([7, 5], [7, 5])] {
            let mut transform = RealTransform::new(filled, size);
            let field: Vec<f64> =
                (0..filled[0] * filled[1]).map(|k| (k * k % 7) as f64 - 2.0).collect();
            let mut back = vec![0.0; field.len()];
            transform.forward(&field);
            transform.inverse(&mut back);
            for (value, expected) in back.iter().zip(&field) {
                let expected = expected * (size[0] * size[1]) as f64;
                assert_relative_eq!(*value, expected, epsilon = 1e-11);
            }
        }
    }

    /// A single wave has two conjugate lines at its wave vector, one of which is kept.
    #[test]
    fn a_wave_is_found_at_its_wave_vector() {
        let mut transform = RealTransform::new([8, 6], [8, 6]);
        let phase = |x: usize, y: usize| TAU * (2.0 * x as f64 / 8.0 - y as f64 / 6.0);
        let field: Vec<f64> = (0..48).map(|k| phase(k % 8, k / 8).cos()).collect();
        transform.forward(&field);
        let vectors = transform.wave_vectors().zip(transform.spectrum());
        for (vector, value) in vectors {
            let expected = if vector == [2.0, -1.0] { 24.0 } else { 0.0 };
            assert_relative_eq!(value.re, expected, epsilon = 1e-12);
            assert_relative_eq!(value.im, 0.0, epsilon = 1e-12);
        }
        let energy: f64 = transform
            .spectrum()
            .iter()
            .zip(transform.multiplicities())
            .map(|(v, m)| m * v.norm_sqr())
            .sum();
        assert_relative_eq!(energy / 48.0, 24.0, max_relative = 1e-12);
    }

    #[test]
    fn smooth_lengths_are_products_of_two_three_and_five() {
        assert_eq!([1, 7, 11, 127].map(smooth_from), [1, 8, 12, 128]);
    }
}
