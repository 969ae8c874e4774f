//! An axis of the table: cubic splines through its nodes.

use nalgebra::DMatrix;
use wide::f32x4;

/// How a function continues beyond the ends of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Ends {
    /// It is unknown there: the splines have no knot at the second node and the one before the
    /// last.
    Open,
    /// It is mirrored at both ends, each time with a sign.
    Mirrored,
    /// It repeats itself, with a sign, after the period from the first node on.
    Periodic(f64),
}

/// Fewest nodes of an axis.
pub(crate) const FEWEST: usize = 4;

/// Number of non-zero basis functions at a point, and of coefficients of a cubic polynomial.
const LOCAL: usize = 4;

/// Most buckets for the search of the interval.
const MOST_BUCKETS: f64 = 4096.0;

/// Nodes, and the cubic B-splines that belong to them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    nodes: Vec<f64>,
    ends: Ends,
    /// Where the pieces of the splines begin; the last entry is the upper end.
    starts: Vec<f64>,
    pieces: Vec<Piece>,
    /// Coefficients of the four basis functions on each piece, in powers of the part of its width.
    exact: Vec<[[f64; LOCAL]; LOCAL]>,
    /// The piece at the start of each bucket.
    buckets: Vec<u32>,
    bucket_scale: f64,
}

/// What the basis functions on a piece follow from.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    start: f64,
    /// 1/width.
    scale: f64,
    /// For each power of the part of the width the coefficients of all four functions.
    powers: [f32x4; LOCAL],
}

/// The basis functions at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Weights {
    /// The first coefficient they belong to.
    pub first: usize,
    pub values: f32x4,
    /// Their derivatives along the axis.
    pub slopes: f32x4,
}

impl Axis {
    /// Nodes must ascend, and be at least [`FEWEST`]; a period must exceed their extent.
    pub fn new(nodes: Vec<f64>, ends: Ends) -> Self {
        let knots = knots(&nodes, ends);
        let count = knots.len() - LOCAL;
        let spans: Vec<usize> = (LOCAL - 1..count).filter(|k| knots[*k + 1] > knots[*k]).collect();
        let exact: Vec<_> = spans.iter().map(|span| polynomials(&knots, *span)).collect();
        let piece = |(span, exact): (&usize, &[[f64; LOCAL]; LOCAL])| Piece {
            start: knots[*span],
            scale: (knots[span + 1] - knots[*span]).recip(),
            powers: powers(exact),
        };
        let pieces: Vec<Piece> = spans.iter().zip(&exact).map(piece).collect();
        let mut starts: Vec<f64> = pieces.iter().map(|piece| piece.start).collect();
        let (low, high) = (knots[LOCAL - 1], knots[count]);
        starts.push(high);
        // No more than one piece begins in a bucket.
        let widths = starts.windows(2).map(|pair| pair[1] - pair[0]);
        let narrowest = widths.fold(high - low, f64::min);
        let bucket_count = ((high - low) / narrowest).ceil().min(MOST_BUCKETS) as usize + 1;
        let piece_at = |bucket: usize| {
            let start = low + (high - low) * bucket as f64 / bucket_count as f64;
            let above = starts[1..spans.len()].iter().filter(|knot| **knot <= start);
            above.count() as u32
        };
        let buckets = (0..bucket_count).map(piece_at).collect();
        let bucket_scale = bucket_count as f64 / (high - low);
        Self { nodes, ends, starts, pieces, exact, buckets, bucket_scale }
    }

    /// Its nodes, in ascending order; dimensionless.
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// Number of coefficients.
    pub fn coefficients(&self) -> usize {
        coefficients(self.nodes.len(), self.ends)
    }

    /// The basis functions at a point; beyond the ends those at the end.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "the axes' chains of dependent steps then overlap")]
    pub fn weights(&self, at: f64) -> Weights {
        let last = self.pieces.len() - 1;
        let low = self.starts[0];
        let at = at.max(low).min(self.starts[last + 1]);
        let bucket = ((at - low) * self.bucket_scale) as usize;
        let mut piece = self.buckets[bucket.min(self.buckets.len() - 1)] as usize;
        // Without a branch, whose outcome nothing would foretell.
        piece = (piece + usize::from(at >= self.starts[piece + 1])).min(last);
        while piece < last && at >= self.starts[piece + 1] {
            piece += 1;
        }
        let Piece { start, scale, powers: [c0, c1, c2, c3] } = self.pieces[piece];
        let u = f32x4::splat(((at - start) * scale) as f32);
        let values = c0 + u * (c1 + u * (c2 + u * c3));
        let slopes = c1 + u * (c2 + c2 + u * (c3 + c3 + c3));
        Weights { first: piece, values, slopes: slopes * f32x4::splat(scale as f32) }
    }

    /// The matrix that turns values at the nodes into coefficients; `signs` are those with which
    /// the function continues beyond the lower and the upper end, or after the period. `None` if it
    /// does not exist; dimensionless.
    pub fn interpolation(&self, signs: [f64; 2]) -> Option<DMatrix<f64>> {
        let fold = self.fold(signs);
        let mut values = DMatrix::zeros(self.nodes.len(), self.coefficients());
        for (row, node) in self.nodes.iter().enumerate() {
            let Weights { first, .. } = self.weights(*node);
            for (column, value) in self.exact(*node).into_iter().enumerate() {
                values[(row, first + column)] = value;
            }
        }
        Some(&fold * (values * &fold).try_inverse()?)
    }

    /// The basis functions at a point in double precision.
    fn exact(&self, at: f64) -> [f64; LOCAL] {
        let first = self.weights(at).first;
        let piece = &self.pieces[first];
        let u = (at - piece.start) * piece.scale;
        self.exact[first].map(|[c0, c1, c2, c3]| c0 + u * (c1 + u * (c2 + u * c3)))
    }

    /// All coefficients from those that belong to nodes.
    fn fold(&self, [below, above]: [f64; 2]) -> DMatrix<f64> {
        let n = self.nodes.len();
        let mut fold = DMatrix::zeros(self.coefficients(), n);
        match self.ends {
            Ends::Open => fold.fill_with_identity(),
            Ends::Mirrored => {
                (0..n).for_each(|k| fold[(k + 1, k)] = 1.0);
                fold[(0, 1)] = below;
                fold[(n + 1, n - 2)] = above;
            }
            Ends::Periodic(_) => {
                (0..n).for_each(|k| fold[(k + 1, k)] = 1.0);
                fold[(0, n - 1)] = below;
                fold[(n + 1, 0)] = above;
                fold[(n + 2, 1)] = above;
            }
        }
        fold
    }
}

/// Number of coefficients of an axis with so many nodes.
fn coefficients(nodes: usize, ends: Ends) -> usize {
    match ends {
        Ends::Open => nodes,
        Ends::Mirrored => nodes + 2,
        Ends::Periodic(_) => nodes + 3,
    }
}

/// Four more than there are coefficients.
fn knots(nodes: &[f64], ends: Ends) -> Vec<f64> {
    let n = nodes.len();
    let (low, high) = (nodes[0], nodes[n - 1]);
    let beyond = LOCAL - 1;
    match ends {
        Ends::Open => {
            let end = |at: f64| std::iter::repeat_n(at, LOCAL);
            end(low).chain(nodes[2..n - 2].iter().copied()).chain(end(high)).collect()
        }
        Ends::Mirrored => {
            let below = (1..=beyond).rev().map(|k| 2.0 * low - nodes[k]);
            let above = (1..=beyond).map(|k| 2.0 * high - nodes[n - 1 - k]);
            below.chain(nodes.iter().copied()).chain(above).collect()
        }
        Ends::Periodic(period) => {
            let below = (n - beyond..n).map(|k| nodes[k] - period);
            let above = (0..=beyond).map(|k| nodes[k] + period);
            below.chain(nodes.iter().copied()).chain(above).collect()
        }
    }
}

/// The four basis functions on the piece between two knots.
fn polynomials(knots: &[f64], span: usize) -> [[f64; LOCAL]; LOCAL] {
    let (start, width) = (knots[span], knots[span + 1] - knots[span]);
    let thirds = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
    let samples = thirds.map(|u| de_boor(knots, span, start + u * width));
    std::array::from_fn(|k| {
        let [y0, y1, y2, y3] = samples.map(|sample| sample[k]);
        // The cubic through four equidistant points.
        [
            y0,
            -5.5 * y0 + 9.0 * y1 - 4.5 * y2 + y3,
            9.0 * y0 - 22.5 * y1 + 18.0 * y2 - 4.5 * y3,
            -4.5 * y0 + 13.5 * y1 - 13.5 * y2 + 4.5 * y3,
        ]
    })
}

/// For each power the coefficients of the four basis functions.
fn powers(piece: &[[f64; LOCAL]; LOCAL]) -> [f32x4; LOCAL] {
    std::array::from_fn(|power| f32x4::from(piece.map(|basis| basis[power] as f32)))
}

/// The non-zero cubic basis functions at a point of a piece (de Boor 1972).
fn de_boor(knots: &[f64], span: usize, at: f64) -> [f64; LOCAL] {
    let mut basis = [1.0, 0.0, 0.0, 0.0];
    for degree in 1..LOCAL {
        let mut carried = 0.0;
        for k in 0..degree {
            let (left, right) = (knots[span + 1 + k - degree], knots[span + 1 + k]);
            let part = basis[k] / (right - left);
            basis[k] = carried + (right - at) * part;
            carried = (at - left) * part;
        }
        basis[degree] = carried;
    }
    basis
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Value and derivative at a point of the spline through a function.
    fn interpolated(
        axis: &Axis,
        signs: [f64; 2],
        function: impl Fn(f64) -> f64,
        at: f64,
    ) -> [f64; 2] {
        let values = axis.nodes.iter().map(|node| function(*node));
        let values = nalgebra::DVector::from_iterator(axis.nodes.len(), values);
        let coefficients = axis.interpolation(signs).unwrap() * values;
        let Weights { first, values, slopes } = axis.weights(at);
        [values, slopes].map(|weights| {
            let weights = weights.to_array().into_iter().map(f64::from);
            weights.zip(coefficients.iter().skip(first)).map(|(w, c)| w * c).sum()
        })
    }

    /// Open ends: cubic polynomials are reproduced, with their derivative, on any nodes.
    #[test]
    fn cubic_polynomials_are_exact_between_open_ends() {
        let axis = Axis::new(vec![-1.0, -0.4, -0.3, 0.2, 0.9, 1.0], Ends::Open);
        for at in [-1.0, -0.7, -0.35, 0.0, 0.55, 0.95, 1.0] {
            let [value, slope] =
                interpolated(&axis, [1.0; 2], |x| 1.0 + x - 2.0 * x * x + 3.0 * x.powi(3), at);
            assert_relative_eq!(value, 1.0 + at - 2.0 * at * at + 3.0 * at.powi(3), epsilon = 1e-6);
            assert_relative_eq!(slope, 1.0 - 4.0 * at + 9.0 * at * at, epsilon = 2e-5);
        }
    }

    /// A sine is odd at zero and even at a quarter of its period, a cosine the reverse; both repeat
    /// with a change of sign. The error of cubic splines is of fourth order.
    #[test]
    fn waves_continue_beyond_the_ends_with_their_signs() {
        use std::f64::consts::{FRAC_PI_2, PI};
        let error = |n: usize| {
            let quarter = (0..=n).map(|k| FRAC_PI_2 * k as f64 / n as f64).collect();
            let half = (0..2 * n).map(|k| PI * k as f64 / (2 * n) as f64).collect();
            let (mirrored, periodic) =
                (Axis::new(quarter, Ends::Mirrored), Axis::new(half, Ends::Periodic(PI)));
            let mut largest = 0.0_f64;
            for k in 0..57 {
                let at = FRAC_PI_2 * f64::from(k) / 56.0;
                let sine = interpolated(&mirrored, [-1.0, 1.0], f64::sin, at)[0];
                let cosine = interpolated(&mirrored, [1.0, -1.0], f64::cos, at)[0];
                let wave = interpolated(&periodic, [-1.0, -1.0], f64::sin, 2.0 * at)[0];
                let double = |x: f64| (2.0 * x).cos();
                let twice = interpolated(&periodic, [1.0, 1.0], double, 2.0 * at)[0];
                let errors = [
                    sine - at.sin(),
                    cosine - at.cos(),
                    wave - (2.0 * at).sin(),
                    twice - (4.0 * at).cos(),
                ];
                largest = errors.iter().fold(largest, |largest, error| largest.max(error.abs()));
            }
            largest
        };
        let (coarse, fine) = (error(4), error(8));
        assert!(coarse < 2e-2, "{coarse}");
        assert!(fine < coarse / 12.0, "{coarse} {fine}");
    }
}
