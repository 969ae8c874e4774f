//! Values on a grid of four axes, interpolated by quadratic B-splines, whose slopes are continuous
//! (de Boor 1978).

use wide::f64x2;

/// Number of axes.
pub(super) const AXES: usize = 4;

/// The axis of yaw angles.
pub(super) const YAWS: usize = 2;

/// Number of values at a node.
pub(super) const VALUES: usize = 5;

/// Equal steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axis {
    /// Position of the first node, in the unit of the axis.
    pub start: f64,
    /// Distance of nodes, in the unit of the axis.
    pub step: f64,
    /// Number of nodes.
    pub count: usize,
    /// Whether values go on beyond the first node as in a mirror.
    pub is_mirrored: bool,
}

/// Values at the nodes of four axes, the last one fastest.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub axes: [Axis; AXES],
    /// Relative to a contact of Hertz, dimensionless; none before they are known.
    values: Vec<[f64; VALUES]>,
    /// Of the splines.
    coefficients: Vec<Row>,
}

/// Nodes of an axis, neighbours of each other.
const NEIGHBOURS: usize = 3;

/// The nodes around a position, with the weights of their coefficients in the value and in the
/// slope.
struct Around {
    nodes: [usize; NEIGHBOURS],
    weights: [f64; NEIGHBOURS],
    slopes: [f64; NEIGHBOURS],
}

/// The values of a node, side by side.
#[derive(Debug, Clone, Copy)]
struct Row([f64x2; 3]);

impl Axis {
    /// Between two ends (in the unit of the axis) in so many steps.
    pub fn between([from, to]: [f64; 2], steps: usize) -> Self {
        let step = (to - from) / steps as f64;
        Self { start: from, step, count: steps + 1, is_mirrored: false }
    }

    /// Position of a node, in the unit of the axis.
    pub fn at(&self, k: usize) -> f64 {
        self.start + self.step * k as f64
    }

    /// Position of the last node, in the unit of the axis.
    pub fn end(&self) -> f64 {
        self.at(self.count - 1)
    }

    /// The first node with one on either side: contacts at yaw angles either way are mirror images.
    fn first(&self) -> usize {
        usize::from(!self.is_mirrored)
    }

    /// Nodes around a position, constant beyond the ends. Towards an end the parabola goes on that
    /// is around the last node but one.
    fn around(&self, position: f64) -> Around {
        let inside = position.clamp(self.start, self.end());
        let place = (inside - self.start) / self.step;
        let middle = ((place + 0.5) as usize).clamp(self.first(), self.count - 2);
        let t = place - middle as f64;
        let nodes = [if middle == 0 { 1 } else { middle - 1 }, middle, middle + 1];
        let weights = [0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)];
        let part = if inside == position { self.step.recip() } else { 0.0 };
        let slopes = [part * (t - 0.5), -2.0 * part * t, part * (t + 0.5)];
        Around { nodes, weights, slopes }
    }

    /// Turns the values of a line of nodes into the coefficients of their spline: at a node
    /// c₋/8 + 3c/4 + c₊/8 is its value, and at an end the difference from its neighbour is that of
    /// the values, which the same parabola around the neighbour has.
    fn interpolate(&self, line: &mut [Row]) {
        let last = line.len() - 1;
        // What is eliminated downwards: each coefficient is the line's plus a part of the next one.
        let mut parts = vec![0.0_f64; line.len()];
        if self.is_mirrored {
            line[0] = line[0].times(4.0 / 3.0);
            parts[0] = -1.0 / 3.0;
        } else {
            line[0] = line[0].plus(&line[1], -1.0);
            parts[0] = 1.0;
        }
        let end = line[last].plus(&line[last - 1], -1.0);
        for k in 1..last {
            let pivot = 0.75 + 0.125 * parts[k - 1];
            line[k] = line[k].plus(&line[k - 1], -0.125).times(pivot.recip());
            parts[k] = -0.125 / pivot;
        }
        line[last] = end.plus(&line[last - 1], 1.0).times((1.0 - parts[last - 1]).recip());
        for k in (0..last).rev() {
            line[k] = line[k].plus(&line[k + 1], parts[k]);
        }
    }
}

impl Grid {
    /// Without values. An axis has at least three nodes.
    pub fn new(axes: [Axis; AXES]) -> Self {
        Self { axes, values: Vec::new(), coefficients: Vec::new() }
    }

    /// Its values at all nodes, dimensionless.
    pub fn values(&self) -> &[[f64; VALUES]] {
        &self.values
    }

    /// With values at all nodes, dimensionless.
    #[must_use]
    pub fn with(self, values: Vec<[f64; VALUES]>) -> Self {
        let mut coefficients: Vec<Row> = values.iter().map(Row::from).collect();
        let mut stride = coefficients.len();
        for axis in &self.axes {
            let block = stride;
            stride /= axis.count;
            for first in (0..coefficients.len()).filter(|k| k % block < stride) {
                let at = |k: usize| first + k * stride;
                let mut line: Vec<Row> = (0..axis.count).map(|k| coefficients[at(k)]).collect();
                axis.interpolate(&mut line);
                line.into_iter().enumerate().for_each(|(k, row)| coefficients[at(k)] = row);
            }
        }
        Self { axes: self.axes, values, coefficients }
    }

    pub fn index(&self, node: [usize; AXES]) -> usize {
        node.iter().zip(&self.axes).fold(0, |index, (k, axis)| index * axis.count + k)
    }

    /// Number of nodes.
    pub fn count(&self) -> usize {
        self.axes.iter().map(|axis| axis.count).product()
    }

    /// The node with an index.
    pub fn node(&self, mut index: usize) -> [usize; AXES] {
        let mut node = [0; AXES];
        for (k, axis) in self.axes.iter().enumerate().rev() {
            (node[k], index) = (index % axis.count, index / axis.count);
        }
        node
    }

    /// With half the steps along an axis, without values.
    pub fn refined(&self, axis: usize) -> Self {
        let mut axes = self.axes;
        axes[axis] =
            Axis { step: 0.5 * axes[axis].step, count: 2 * axes[axis].count - 1, ..axes[axis] };
        Self::new(axes)
    }

    /// With every second node along an axis.
    pub fn coarsened(&self, axis: usize) -> Self {
        let mut axes = self.axes;
        let Axis { step, count, .. } = axes[axis];
        axes[axis] = Axis { step: 2.0 * step, count: count.div_ceil(2), ..axes[axis] };
        let coarse = Self::new(axes);
        let value = |index: usize| {
            let mut node = coarse.node(index);
            node[axis] *= 2;
            self.values[self.index(node)]
        };
        let values = (0..coarse.count()).map(value).collect();
        coarse.with(values)
    }

    /// Values at a place, and their derivatives with respect to it, in the unit of the values over
    /// that of the axis.
    pub fn at(&self, place: [f64; AXES]) -> [[f64; VALUES]; AXES + 1] {
        let [first, second, third, fourth]: [Around; AXES] =
            std::array::from_fn(|k| self.axes[k].around(place[k]));
        let mut found = [Row::ZERO; AXES + 1];
        for i in 0..NEIGHBOURS {
            let mut of_first = [Row::ZERO; AXES];
            for j in 0..NEIGHBOURS {
                let mut of_second = [Row::ZERO; 3];
                for k in 0..NEIGHBOURS {
                    let start = self.index([first.nodes[i], second.nodes[j], third.nodes[k], 0]);
                    let rows = fourth.nodes.map(|node| self.coefficients[start + node]);
                    let of_third = fourth.sums(&rows);
                    of_second[0].add(&of_third[0], third.weights[k]);
                    of_second[1].add(&of_third[0], third.slopes[k]);
                    of_second[2].add(&of_third[1], third.weights[k]);
                }
                of_first[0].add(&of_second[0], second.weights[j]);
                of_first[1].add(&of_second[0], second.slopes[j]);
                of_first[2].add(&of_second[1], second.weights[j]);
                of_first[3].add(&of_second[2], second.weights[j]);
            }
            found[0].add(&of_first[0], first.weights[i]);
            found[1].add(&of_first[0], first.slopes[i]);
            for k in 1..AXES {
                found[k + 1].add(&of_first[k], first.weights[i]);
            }
        }
        found.map(Row::values)
    }
}

impl Around {
    /// Weighted sums of the rows of its nodes: values and slopes.
    #[inline]
    fn sums(&self, rows: &[Row; NEIGHBOURS]) -> [Row; 2] {
        let mut sums = [Row::ZERO; 2];
        for (k, row) in rows.iter().enumerate() {
            sums[0].add(row, self.weights[k]);
            sums[1].add(row, self.slopes[k]);
        }
        sums
    }
}

impl Row {
    const ZERO: Self = Self([f64x2::ZERO; 3]);

    #[inline]
    fn from([a, b, c, d, e]: &[f64; VALUES]) -> Self {
        Self([[*a, *b], [*c, *d], [*e, 0.0]].map(f64x2::from))
    }

    #[inline]
    fn add(&mut self, row: &Self, weight: f64) {
        let weight = f64x2::splat(weight);
        for (own, value) in self.0.iter_mut().zip(row.0) {
            *own += weight * value;
        }
    }

    /// With so much of another one.
    fn plus(mut self, row: &Self, weight: f64) -> Self {
        self.add(row, weight);
        self
    }

    fn times(self, factor: f64) -> Self {
        Self::ZERO.plus(&self, factor)
    }

    fn values(self) -> [f64; VALUES] {
        let [[a, b], [c, d], [e, _]] = self.0.map(f64x2::to_array);
        [a, b, c, d, e]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Any parabola along every axis, even along the mirrored one, up to the ends and constant
    /// beyond them; and any values at nodes, with slopes that go on between intervals.
    #[test]
    fn splines_interpolate() {
        let ends = [[-1.0, 2.0], [0.0, 1.0], [0.0, 3.0], [1.0, 2.0]];
        let steps = [5, 2, 3, 7];
        let mut axes: [Axis; AXES] = std::array::from_fn(|k| Axis::between(ends[k], steps[k]));
        axes[YAWS].is_mirrored = true;
        let at = |of: &dyn Fn([f64; AXES]) -> f64| {
            let grid = Grid::new(axes);
            let place = |index: usize| {
                let node = grid.node(index);
                std::array::from_fn(|k| axes[k].at(node[k]))
            };
            let values = (0..grid.count()).map(|index| [of(place(index)), 1.0, 0.0, 2.0, -1.0]);
            let values = values.collect();
            grid.with(values)
        };
        let smooth = |[x, y, z, w]: [f64; AXES]| {
            (1.0 + x - 0.3 * x * x) * (2.0 - y + y * y) + (1.0 + 0.2 * z * z) * (w - 0.7 * w * w)
        };
        let grid = at(&smooth);
        for place in [[-1.0, 0.1, 0.0, 1.0], [0.3, 0.5, 1.4, 1.77], [2.0, 1.0, 2.9, 2.0]] {
            let found = grid.at(place);
            assert_relative_eq!(found[0][0], smooth(place), max_relative = 1e-13);
            assert_relative_eq!(found[0][4], -1.0, max_relative = 1e-13);
            for axis in 0..AXES {
                let [more, less] = [1e-5, -1e-5].map(|by| {
                    let mut moved = place;
                    moved[axis] += by;
                    smooth(moved)
                });
                assert_relative_eq!(
                    found[1 + axis][0],
                    (more - less) / 2e-5,
                    max_relative = 1e-9,
                    epsilon = 1e-9
                );
            }
        }
        let beyond = grid.at([2.5, -0.1, 0.5, 1.5]);
        assert_relative_eq!(beyond[0][0], smooth([2.0, 0.0, 0.5, 1.5]), max_relative = 1e-13);
        assert_eq!([beyond[1][0], beyond[2][0]], [0.0; 2]);

        let rough = |place: [f64; AXES]| place.iter().map(|x| (37.0 * x).sin()).product::<f64>();
        let grid = at(&rough);
        for index in 0..grid.count() {
            let node = grid.node(index);
            let place = std::array::from_fn(|k| axes[k].at(node[k]));
            assert_relative_eq!(grid.at(place)[0][0], rough(place), epsilon = 1e-12);
        }
        let half = axes[3].step * 0.5;
        let [before, after] =
            [-1e-9, 1e-9].map(|by| grid.at([0.3, 0.5, 1.4, 1.0 + 5.0 * half + by]));
        for (one, other) in before.iter().zip(&after) {
            assert_relative_eq!(one[0], other[0], epsilon = 1e-6);
        }
    }
}
