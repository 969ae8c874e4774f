//! Where a table needs more nodes: around states in which it is off, on those axes on which the
//! nodes there are far from what their neighbours say about them.

use crate::problem::look_up_table::TableNodes;

/// Intervals are halved on axes on which the deviation is at least this part of the largest.
const PART: f64 = 0.5;

/// The values at the nodes on a grid, and where they continue beyond its ends.
pub(super) struct Grid<'a> {
    pub nodes: &'a TableNodes,
}

/// New nodes on each axis: a/b, azimuth, inclination, saturation.
pub(super) type Additions = [Vec<f64>; 4];

/// A place of the table: a/b, azimuth, inclination, saturation.
pub(super) type Place = [f64; 4];

impl Grid<'_> {
    /// The middles of the intervals that are to be halved for places of the table where it is off:
    /// on the axes on which the nodes around them deviate most.
    pub fn additions(&self, places: &[Place]) -> Additions {
        let mut additions = Additions::default();
        for place in places {
            let intervals = std::array::from_fn(|axis| self.interval(axis, place[axis]));
            let deviations: [f64; 4] =
                std::array::from_fn(|axis| self.deviation_around(axis, intervals));
            let largest = deviations.iter().fold(0.0_f64, |largest, d| largest.max(*d));
            for (axis, new) in additions.iter_mut().enumerate() {
                if deviations[axis] >= PART * largest && largest > 0.0 {
                    new.extend(self.middle(axis, intervals[axis]));
                }
            }
        }
        for new in &mut additions {
            new.sort_unstable_by(f64::total_cmp);
            new.dedup();
        }
        additions
    }

    /// The interval of an axis in which a position lies.
    fn interval(&self, axis: usize, position: f64) -> usize {
        let nodes = self.axes()[axis];
        let last = if axis == AZIMUTH { nodes.len() - 1 } else { nodes.len() - 2 };
        nodes.partition_point(|node| *node <= position).saturating_sub(1).min(last)
    }

    /// The largest deviation along an axis at the corners of a cell.
    fn deviation_around(&self, axis: usize, cell: [usize; 4]) -> f64 {
        let corner = |k: usize| -> [isize; 4] {
            std::array::from_fn(|axis| (cell[axis] + ((k >> axis) & 1)) as isize)
        };
        (0..16).map(|k| self.deviation(axis, corner(k))).fold(0.0, f64::max)
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

    /// Difference of the force over μN at a node from the cubic polynomial through its neighbours
    /// on an axis; zero at the ends.
    fn deviation(&self, axis: usize, index: [isize; 4]) -> f64 {
        let Some(weights) = self.neighbours(axis, index[axis]) else { return 0.0 };
        let mut difference = self.value(index);
        for (neighbour, weight) in weights {
            let there = std::array::from_fn(|k| if k == axis { neighbour } else { index[k] });
            let value = self.value(there);
            difference = std::array::from_fn(|c| difference[c] - weight * value[c]);
        }
        let part = self.nodes.saturations[index[SATURATION] as usize];
        let [x, y, moment] = difference.map(|difference| part * difference);
        x.hypot(y).max(moment.abs())
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

    /// The middle of an interval.
    fn middle(&self, axis: usize, interval: usize) -> Option<f64> {
        let low = self.position(axis, interval as isize)?;
        let middle = f64::midpoint(low, self.position(axis, interval as isize + 1)?);
        Some(if axis == RATIO { middle.exp() } else { middle })
    }
}

const RATIO: usize = 0;
const AZIMUTH: usize = 1;
const SATURATION: usize = 3;
