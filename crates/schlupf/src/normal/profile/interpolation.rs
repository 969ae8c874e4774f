//! Cubic interpolation between points of any spacing.

use crate::numerics::interpolation::hermite;

/// What a value in between takes of the points around it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weights {
    first: usize,
    values: [f64; 4],
    count: usize,
}

impl Weights {
    /// The interpolated value, in the unit of the values; the weights are dimensionless.
    pub fn apply(&self, value: impl Fn(usize) -> f64) -> f64 {
        (0..self.count).map(|k| self.values[k] * value(self.first + k)).sum()
    }
}

/// Weights of the points for the position `at` (same unit); beyond the ends the outermost cubics go
/// on. There must be at least three points, ascending.
pub(super) fn weights_at(points: &[f64], at: f64) -> Weights {
    let last = points.len() - 1;
    let above = points.partition_point(|point| *point <= at);
    let i = above.saturating_sub(1).min(last - 1);
    let first = i.saturating_sub(1);
    let count = (i + 2).min(last) - first + 1;
    let width = points[i + 1] - points[i];
    let t = (at - points[i]) / width;
    let mut weights = [0.0; 4];
    let [from, to, out, into] = hermite(t);
    weights[i - first] += from;
    weights[i + 1 - first] += to;
    for (point, share) in [(i, out), (i + 1, into)] {
        let start = point.saturating_sub(1).min(last - 2);
        let by = slope(&points[start..start + 3], points[point]);
        for (k, by) in by.into_iter().enumerate() {
            weights[start + k - first] += share * width * by;
        }
    }
    Weights { first, values: weights, count }
}

/// Slope of the parabola through three points at some position: its weights of the three values, in
/// one over the unit of the points.
fn slope(points: &[f64], at: f64) -> [f64; 3] {
    std::array::from_fn(|k| {
        let (p, q) = (points[(k + 1) % 3], points[(k + 2) % 3]);
        (2.0 * at - p - q) / ((points[k] - p) * (points[k] - q))
    })
}
