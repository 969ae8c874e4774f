//! Interpolation: weights, and tables along a line.

/// Linear interpolation between two values by a share (dimensionless); exact at both ends.
pub(crate) fn mix([from, to]: [f64; 2], share: f64) -> f64 {
    (1.0 - share) * from + share * to
}

/// Value and slope, at a position, of a table over ascending positions, linear between the points
/// and constant outside.
pub(crate) fn piecewise_linear(positions: &[f64], values: &[f64], at: f64) -> [f64; 2] {
    let after = positions.partition_point(|position| *position <= at);
    if after == 0 {
        return [values[0], 0.0];
    }
    if after == values.len() {
        return [values[after - 1], 0.0];
    }
    let ends = [values[after - 1], values[after]];
    let width = positions[after] - positions[after - 1];
    let share = (at - positions[after - 1]) / width;
    [mix(ends, share), (ends[1] - ends[0]) / width]
}

/// Weights of the four corners of a rectangle, (0, 0), (1, 0), (0, 1), (1, 1), at fractional
/// positions along its sides.
pub(crate) fn bilinear([x, y]: [f64; 2]) -> [f64; 4] {
    [(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y]
}

/// First of the four nodes of a regular line around a position given in spacings, and their weights
/// in Lagrange's cubic; near the ends the cubic through the four outermost nodes. There must be at
/// least four.
pub(crate) fn cubic(position: f64, nodes: usize) -> (usize, [f64; 4]) {
    let first = (position.floor() - 1.0).clamp(0.0, (nodes - 4) as f64);
    let s = position - first;
    let weights = [
        -(s - 1.0) * (s - 2.0) * (s - 3.0) / 6.0,
        s * (s - 2.0) * (s - 3.0) / 2.0,
        -s * (s - 1.0) * (s - 3.0) / 2.0,
        s * (s - 1.0) * (s - 2.0) / 6.0,
    ];
    (first as usize, weights)
}

/// Weights, in Hermite's cubic at a fraction t of an interval, of the values at its ends and of the
/// slopes there times its width.
pub(crate) fn hermite(t: f64) -> [f64; 4] {
    let rest = 1.0 - t;
    [(1.0 + 2.0 * t) * rest * rest, t * t * (3.0 - 2.0 * t), t * rest * rest, -t * t * rest]
}

/// Their derivatives with respect to t.
pub(crate) fn hermite_slope(t: f64) -> [f64; 4] {
    let rest = 1.0 - t;
    [-6.0 * t * rest, 6.0 * t * rest, rest * (1.0 - 3.0 * t), t * (3.0 * t - 2.0)]
}

/// Their second derivatives with respect to t.
pub(crate) fn hermite_bend(t: f64) -> [f64; 4] {
    [12.0 * t - 6.0, 6.0 - 12.0 * t, 6.0 * t - 4.0, 6.0 * t - 2.0]
}

/// Weights of four equidistant nodes at a fraction t of the interval between the middle two, with
/// the slopes of Hermite's cubic from the differences of neighbours (Catmull and Rom 1974).
pub(crate) fn catmull_rom(t: f64) -> [f64; 4] {
    let [from, to, out, into] = hermite(t);
    [-0.5 * out, from - 0.5 * into, to + 0.5 * out, 0.5 * into]
}

/// Derivatives of these weights with respect to t.
pub(crate) fn catmull_rom_slope(t: f64) -> [f64; 4] {
    let [from, to, out, into] = hermite_slope(t);
    [-0.5 * out, from - 0.5 * into, to + 0.5 * out, 0.5 * into]
}

/// Functions of one number, from their values at equal steps, by cubics with continuous slopes;
/// constant beyond the ends.
#[derive(Debug, Clone)]
pub(crate) struct Cubics<const N: usize> {
    start: f64,
    step: f64,
    at: Vec<[f64; N]>,
}

impl<const N: usize> Cubics<N> {
    /// Between two ends (in the unit of the number), in at least three steps.
    pub fn new<E>(
        [start, end]: [f64; 2],
        steps: usize,
        values: impl Fn(f64) -> Result<[f64; N], E>,
    ) -> Result<Self, E> {
        let step = (end - start) / steps as f64;
        let at = (0..=steps).map(|k| values(start + step * k as f64)).collect::<Result<_, E>>()?;
        Ok(Self { start, step, at })
    }

    /// Values (in the unit of the function) and slopes, in that over the unit of the number.
    pub fn at(&self, position: f64) -> [[f64; 2]; N] {
        let last = (self.at.len() - 1) as f64;
        let place = (position - self.start) / self.step;
        let inside = place.clamp(0.0, last);
        let first = inside.floor().clamp(1.0, last - 2.0);
        let t = inside - first;
        let part = if inside == place { self.step.recip() } else { 0.0 };
        let (weights, slopes) = (catmull_rom(t), catmull_rom_slope(t).map(|slope| part * slope));
        let points = &self.at[first as usize - 1..][..4];
        std::array::from_fn(|k| {
            [weights, slopes]
                .map(|all| points.iter().zip(all).map(|(point, weight)| weight * point[k]).sum())
        })
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn tables_are_linear_in_between_and_constant_outside() {
        let at = |x| piecewise_linear(&[-4.0, 0.0, 2.0], &[0.5, 1.0, 0.8], x);
        for (x, value, slope) in [
            (-9.0, 0.5, 0.0),
            (-4.0, 0.5, 0.125),
            (-2.0, 0.75, 0.125),
            (0.0, 1.0, -0.1),
            (2.0, 0.8, 0.0),
            (9.0, 0.8, 0.0),
        ] {
            assert_relative_eq!(at(x)[0], value, max_relative = 1e-15);
            assert_relative_eq!(at(x)[1], slope, max_relative = 1e-14);
        }
    }

    /// Lagrange's cubic is exact for cubics, also near the ends; that of Catmull and Rom for
    /// parabolas; Hermite's cubic and its derivative reproduce the given data.
    #[test]
    fn cubics_are_exact() {
        let cubic_at = |x: f64| 2.0 - x + 0.5 * x * x - 0.25 * x * x * x;
        for x in [0.3, 1.0, 2.6, 4.5, 5.0] {
            let (first, weights) = cubic(x, 6);
            let terms = weights.iter().enumerate().map(|(k, w)| w * cubic_at((first + k) as f64));
            assert_relative_eq!(terms.sum::<f64>(), cubic_at(x), epsilon = 1e-13);
        }
        let given = [cubic_at(0.0), cubic_at(1.0), -1.0, -0.75];
        let sum = |weights: [f64; 4]| weights.iter().zip(given).map(|(w, v)| w * v).sum::<f64>();
        assert_relative_eq!(sum(hermite(0.3)), cubic_at(0.3), max_relative = 1e-14);
        let slope = -1.0 + 0.3 - 0.75 * 0.09;
        assert_relative_eq!(sum(hermite_slope(0.3)), slope, max_relative = 1e-14);
        let bend = 1.0 - 1.5 * 0.3;
        assert_relative_eq!(sum(hermite_bend(0.3)), bend, max_relative = 1e-13);
        let parabola = |x: f64| 1.0 + x * (3.0 - x);
        let terms = (-1..3).zip(catmull_rom(0.7)).map(|(k, w)| w * parabola(f64::from(k)));
        assert_relative_eq!(terms.sum::<f64>(), parabola(0.7), max_relative = 1e-14);
    }

    #[test]
    fn corners_weigh_bilinearly() {
        let weights = bilinear([0.25, 0.5]);
        assert_eq!(weights, [0.375, 0.125, 0.375, 0.125]);
    }
}
