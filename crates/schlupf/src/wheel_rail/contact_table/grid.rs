//! Values on a grid of four axes, interpolated by cubics with continuous slopes (Catmull and Rom
//! 1974).

use wide::f64x2;

use crate::numerics::interpolation::{catmull_rom, catmull_rom_slope};

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
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    pub axes: [Axis; AXES],
    /// Relative to a contact of Hertz, dimensionless.
    pub values: Vec<[f64; VALUES]>,
}

/// Four nodes around a position, with their weights in the value and in the slope.
struct Around {
    nodes: [usize; 4],
    weights: [f64; 4],
    slopes: [f64; 4],
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

    /// Four nodes around a position; constant beyond the ends.
    fn around(&self, position: f64) -> Around {
        let inside = position.clamp(self.start, self.end());
        let place = (inside - self.start) / self.step;
        let first = (place as usize).min(self.count.saturating_sub(2));
        let t = place - first as f64;
        let last = self.count - 1;
        // Contacts at yaw angles either way are mirror images.
        let before = if self.is_mirrored && first == 0 { 1 } else { first.saturating_sub(1) };
        let nodes = [before.min(last), first, (first + 1).min(last), (first + 2).min(last)];
        let factor = if inside == position { self.step.recip() } else { 0.0 };
        let (weights, slopes) = (catmull_rom(t), catmull_rom_slope(t));
        Around { nodes, weights, slopes: slopes.map(|slope| factor * slope) }
    }
}

impl Grid {
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
        Self { axes, values: Vec::new() }
    }

    /// With every second node along an axis.
    pub fn coarsened(&self, axis: usize) -> Self {
        let mut axes = self.axes;
        let Axis { step, count, .. } = axes[axis];
        axes[axis] = Axis { step: 2.0 * step, count: count.div_ceil(2), ..axes[axis] };
        let mut coarse = Self { axes, values: Vec::new() };
        let value = |index: usize| {
            let mut node = coarse.node(index);
            node[axis] *= 2;
            self.values[self.index(node)]
        };
        coarse.values = (0..coarse.count()).map(value).collect();
        coarse
    }

    /// Values at a place, and their derivatives with respect to it, in the unit of the values over
    /// that of the axis.
    pub fn at(&self, place: [f64; AXES]) -> [[f64; VALUES]; AXES + 1] {
        let [first, second, third, fourth]: [Around; AXES] =
            std::array::from_fn(|k| self.axes[k].around(place[k]));
        let mut found = [Row::ZERO; AXES + 1];
        for i in 0..4 {
            let mut of_first = [Row::ZERO; AXES];
            for j in 0..4 {
                let mut of_second = [Row::ZERO; 3];
                for k in 0..4 {
                    let start = self.index([first.nodes[i], second.nodes[j], third.nodes[k], 0]);
                    let rows = fourth.nodes.map(|node| Row::from(&self.values[start + node]));
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
    /// Weighted sums of four rows: values and slopes.
    #[inline]
    fn sums(&self, rows: &[Row; 4]) -> [Row; 2] {
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

    fn values(self) -> [f64; VALUES] {
        let [[a, b], [c, d], [e, _]] = self.0.map(f64x2::to_array);
        [a, b, c, d, e]
    }
}
