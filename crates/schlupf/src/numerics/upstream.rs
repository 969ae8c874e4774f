//! Means over what lies upstream, with a weight that falls exponentially: what a material with a
//! single relaxation time remembers in steady rolling.

use super::quadrature;

/// Relaxation lengths beyond which the weight is rounding error.
const NEGLIGIBLE: f64 = 37.0;

/// Relaxation length over the spacing below which the kernel does not change within it.
const VANISHING: f64 = 1e-12;

/// Longest piece of the tail in relaxation lengths.
const LONGEST: f64 = 2.0;

/// ∫₀^∞ exp(−s/L)/L k(x + s) ds of a kernel k that is smooth between multiples of half the spacing,
/// at `from` spacings and so many places upwards from it, in the unit of the kernel. Spacing and L
/// are in m; at an L of next to nothing it is the kernel itself.
///
/// From one place to the next upstream m(x) = ∫₀^h exp(−s/L)/L k(x + s) ds + exp(−h/L) m(x + h).
pub(crate) fn means<const N: usize>(
    [from, count]: [isize; 2],
    (spacing, length): (f64, f64),
    kernel: impl Fn(f64) -> [f64; N],
) -> Vec<[f64; N]> {
    let place = |k: isize| (from + k) as f64 * spacing;
    if length < VANISHING * spacing {
        return (0..count).map(|k| kernel(place(k))).collect();
    }
    let piece = |x: f64, [start, end]: [f64; 2]| {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        quadrature::FOUR.iter().fold([0.0; N], |sum, (node, weight)| {
            let s = middle + half * node;
            let weight = half * weight * (-s / length).exp() / length;
            added(sum, weight, kernel(x + s))
        })
    };
    let far = place(count - 1);
    let mut mean =
        tail(spacing, length).iter().fold([0.0; N], |sum, ends| added(sum, 1.0, piece(far, *ends)));
    let within = cell(spacing, length);
    let kept = (-spacing / length).exp();
    let mut means = vec![mean];
    for k in (0..count - 1).rev() {
        let own = within.iter().fold([0.0; N], |sum, ends| added(sum, 1.0, piece(place(k), *ends)));
        mean = added(own, kept, mean);
        means.push(mean);
    }
    means.reverse();
    means
}

fn added<const N: usize>(sum: [f64; N], weight: f64, value: [f64; N]) -> [f64; N] {
    std::array::from_fn(|k| sum[k] + weight * value[k])
}

/// Pieces of a cell: between kinks of the kernel, and no longer than L.
fn cell(spacing: f64, length: f64) -> Vec<[f64; 2]> {
    let half = 0.5 * spacing;
    let count = (half / length).ceil().max(1.0);
    let (step, reach) = (half / count, NEGLIGIBLE * length);
    let pieces = (0..2 * count as usize).map(|k| [k as f64 * step, (k + 1) as f64 * step]);
    pieces.take_while(|[start, _]| *start < reach).collect()
}

/// Pieces of what lies beyond the last place: growing, as the kernel is smooth there.
fn tail(spacing: f64, length: f64) -> Vec<[f64; 2]> {
    let (mut pieces, mut start) = (Vec::new(), 0.0);
    let mut step = 0.5 * spacing.min(LONGEST * length);
    while start < NEGLIGIBLE * length {
        pieces.push([start, start + step]);
        start += step;
        step = (1.5 * step).min(LONGEST * length);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// The mean of exp(−|x|) is that of two exponentials, in closed form: e^(−x)/(1 + L) for x ≥ 0,
    /// and for x < 0 (e^x − e^(x/L))/(1 − L) + e^(x/L)/(1 + L).
    #[test]
    fn means_of_an_exponential() {
        for length in [1e-3, 0.3, 0.7, 40.0] {
            let found = means([-6, 13], (0.5, length), |x| [(-x.abs()).exp()]);
            for (k, [mean]) in found.iter().enumerate() {
                let x = 0.5 * (k as f64 - 6.0);
                let exact = if x >= 0.0 {
                    (-x).exp() / (1.0 + length)
                } else {
                    let kept = (x / length).exp();
                    (x.exp() - kept) / (1.0 - length) + kept / (1.0 + length)
                };
                assert_relative_eq!(*mean, exact, max_relative = 1e-5);
            }
        }
        for length in [0.0, f64::from_bits(1)] {
            assert_eq!(means([1, 2], (0.5, length), |x| [x]), [[0.5], [1.0]]);
        }
    }
}
