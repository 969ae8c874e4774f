//! The cosine transform of two real lines at once.
//!
//! D_k = 2 Σ z_j cos(π k (j + ½)/n), of z = x + i y: because the transform is real, its real part
//! is the transform of x and its imaginary part that of y. Computed by one complex Fourier
//! transform of the same length (Makhoul 1980): of the even points in ascending order, then the odd
//! ones in descending order.

use std::f64::consts::PI;
use std::fmt;
use std::sync::Arc;

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

use super::ZERO;

/// Transform of lines of one length, with its plans and buffers.
///
/// Points of a line are stored in the order of [`Self::place`], wave numbers k in natural order.
pub(crate) struct PairedCosine {
    forward: Arc<dyn Fft<f64>>,
    inverse: Arc<dyn Fft<f64>>,
    /// exp(−i π k/(2n)) for k up to n/2.
    turns: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl PairedCosine {
    /// For lines of `length` points.
    pub(crate) fn new(length: usize) -> Self {
        let mut planner = FftPlanner::new();
        let (forward, inverse) =
            (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
        let scratch = forward.get_inplace_scratch_len().max(inverse.get_inplace_scratch_len());
        let turn = |k: usize| Complex::cis(-0.5 * PI * k as f64 / length as f64);
        Self {
            turns: (0..=length / 2).map(turn).collect(),
            scratch: vec![ZERO; scratch],
            forward,
            inverse,
        }
    }

    /// Storage position of point j of a line.
    pub(crate) fn place(&self, j: usize) -> usize {
        if j.is_multiple_of(2) { j / 2 } else { self.forward.len() - 1 - j / 2 }
    }

    /// Transforms the points of a line to D.
    pub(crate) fn forward(&mut self, line: &mut [Complex<f64>]) {
        self.forward.process_with_scratch(line, &mut self.scratch);
        line[0] *= 2.0;
        self.combine(line, |turn, low, high| {
            let (p, q) = (turn * low, turn.conj() * high);
            (p + q, (p - q) * Complex::I)
        });
    }

    /// Transforms D to 2n times the points of a line.
    pub(crate) fn inverse(&mut self, line: &mut [Complex<f64>]) {
        self.combine(line, |turn, low, high| {
            let high = high * Complex::I;
            (turn.conj() * (low - high), turn * (low + high))
        });
        self.inverse.process_with_scratch(line, &mut self.scratch);
    }

    /// Combines the values at k and n − k, except for k = 0.
    fn combine(
        &self,
        line: &mut [Complex<f64>],
        with: impl Fn(Complex<f64>, Complex<f64>, Complex<f64>) -> (Complex<f64>, Complex<f64>),
    ) {
        let length = line.len();
        for k in 1..length.div_ceil(2) {
            (line[k], line[length - k]) = with(self.turns[k], line[k], line[length - k]);
        }
        if length.is_multiple_of(2) {
            let middle = length / 2;
            line[middle] = with(self.turns[middle], line[middle], line[middle]).0;
        }
    }
}

impl fmt::Debug for PairedCosine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PairedCosine").field("length", &self.forward.len()).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Agrees with the defining sum, for even and odd lengths; and back.
    #[test]
    fn makhoul_1980_two_lines_at_once() {
        for length in 1..=12 {
            let mut cosine = PairedCosine::new(length);
            let point = |j: usize| Complex::new((j * j % 7) as f64 - 2.0, (3 * j % 5) as f64);
            let mut line = vec![ZERO; length];
            for j in 0..length {
                line[cosine.place(j)] = point(j);
            }
            let points = line.clone();
            cosine.forward(&mut line);
            for (k, value) in line.iter().enumerate() {
                let phase = |j: usize| PI * k as f64 * (j as f64 + 0.5) / length as f64;
                let sum: Complex<f64> =
                    (0..length).map(|j| point(j) * (2.0 * phase(j).cos())).sum();
                assert!((value - sum).norm() < 1e-12, "{length} {k}: {value} {sum}");
            }
            cosine.inverse(&mut line);
            for (value, point) in line.iter().zip(points) {
                assert!((value / (2 * length) as f64 - point).norm() < 1e-13, "{length}");
            }
        }
    }
}
