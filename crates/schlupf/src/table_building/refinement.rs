//! Where a table needs more nodes: where a node is far from what its neighbours on the same axis
//! say about it.

use crate::look_up_table::TableNodes;

/// Exponent of the mean by which deviations at many places count: nearly the largest.
const EXPONENT: i32 = 8;

/// Intervals are halved next to nodes whose deviation is at least this part of the largest.
const PART: f64 = 0.5;

/// The values at the nodes on a grid, and where they continue beyond its ends.
pub(super) struct Grid<'a> {
    pub nodes: &'a TableNodes,
}

/// New nodes on each axis: a/b, azimuth, inclination, saturation.
pub(super) type Additions = [Vec<f64>; 4];

impl Grid<'_> {
    /// The middles of the intervals that are to be halved.
    pub fn additions(&self) -> Additions {
        let deviations: [Vec<f64>; 4] = std::array::from_fn(|axis| {
            (0..self.counts()[axis]).map(|node| self.deviation(axis, node)).collect()
        });
        let largest = deviations.iter().flatten().fold(0.0_f64, |largest, d| largest.max(*d));
        std::array::from_fn(|axis| self.middles(axis, &deviations[axis], PART * largest))
    }

    fn counts(&self) -> [usize; 4] {
        self.axes().map(<[f64]>::len)
    }

    /// The positions on the axes, with a/b as its logarithm left to [`Self::position`].
    fn axes(&self) -> [&[f64]; 4] {
        let nodes = self.nodes;
        [&nodes.axis_ratios, &nodes.azimuths, &nodes.inclinations, &nodes.saturations]
    }

    /// Where a node lies on its axis; azimuths continue beyond their ends.
    fn position(&self, axis: usize, node: isize) -> Option<f64> {
        let nodes = self.axes()[axis];
        let count = nodes.len() as isize;
        if axis == AZIMUTH {
            let turns = node.div_euclid(count) as f64;
            return Some(nodes[node.rem_euclid(count) as usize] + turns * std::f64::consts::PI);
        }
        let position = *nodes.get(usize::try_from(node).ok()?)?;
        Some(if axis == RATIO { position.ln() } else { position })
    }

    /// R at a node whose index may lie beyond the ends of the azimuths.
    fn value(&self, mut index: [isize; 4]) -> [f64; 3] {
        let counts = self.counts();
        let azimuths = counts[AZIMUTH] as isize;
        let is_mirrored = index[AZIMUTH].div_euclid(azimuths) % 2 != 0;
        index[AZIMUTH] = index[AZIMUTH].rem_euclid(azimuths);
        let flat = index.iter().zip(counts).fold(0, |flat, (k, count)| flat * count + *k as usize);
        let [x, y, moment] = self.nodes.values[flat].map(f64::from);
        if is_mirrored { [x, -y, -moment] } else { [x, y, moment] }
    }

    /// Mean over all lines through a node along an axis, of the difference of the force over μN
    /// from the cubic polynomial through the two neighbours on each side; zero at the ends.
    fn deviation(&self, axis: usize, node: usize) -> f64 {
        let Some(weights) = self.neighbours(axis, node as isize) else { return 0.0 };
        let counts = self.counts();
        let (mut sum, mut lines) = (0.0, 0_usize);
        for flat in 0..self.nodes.count() {
            let mut index = [0_isize; 4];
            let mut rest = flat;
            for k in (0..4).rev() {
                index[k] = (rest % counts[k]) as isize;
                rest /= counts[k];
            }
            if index[axis] != node as isize {
                continue;
            }
            let mut difference = self.value(index);
            for (neighbour, weight) in weights {
                let there = std::array::from_fn(|k| if k == axis { neighbour } else { index[k] });
                let value = self.value(there);
                difference = std::array::from_fn(|c| difference[c] - weight * value[c]);
            }
            let part = self.nodes.saturations[index[SATURATION] as usize];
            let [x, y, moment] = difference.map(|difference| part * difference);
            sum += x.hypot(y).max(moment.abs()).powi(EXPONENT);
            lines += 1;
        }
        (sum / lines as f64).powf(f64::from(EXPONENT).recip())
    }

    /// Two neighbours on each side, or what there is at an end, with their weights in the
    /// polynomial through them.
    fn neighbours(&self, axis: usize, node: isize) -> Option<[(isize, f64); 4]> {
        let at = self.position(axis, node)?;
        let sides = [[-2, -1, 1, 2], [-1, 1, 2, 3], [-3, -2, -1, 1]];
        let places = sides.into_iter().find_map(|side| {
            let places =
                side.map(|step| self.position(axis, node + step).map(|x| (node + step, x)));
            let [Some(a), Some(b), Some(c), Some(d)] = places else { return None };
            Some([a, b, c, d])
        })?;
        Some(places.map(|(neighbour, here)| {
            let others = places.iter().filter(|(other, _)| *other != neighbour);
            let weight: f64 = others.map(|(_, other)| (at - other) / (here - other)).product();
            (neighbour, weight)
        }))
    }

    /// Middles of the intervals next to nodes with at least this deviation.
    fn middles(&self, axis: usize, deviations: &[f64], least: f64) -> Vec<f64> {
        let count = deviations.len();
        let is_marked = |node: usize| deviations[node % count] >= least && least > 0.0;
        let last = if axis == AZIMUTH { count } else { count - 1 };
        let intervals = (0..last).filter(|k| is_marked(*k) || is_marked(k + 1));
        let middle = |k: usize| {
            let ends = [k as isize, k as isize + 1].map(|node| self.position(axis, node));
            let [Some(low), Some(high)] = ends else { return None };
            let middle = f64::midpoint(low, high);
            Some(if axis == RATIO { middle.exp() } else { middle })
        };
        intervals.filter_map(middle).collect()
    }
}

const RATIO: usize = 0;
const AZIMUTH: usize = 1;
const SATURATION: usize = 3;
