//! Wheel and rail as lines of few points, on which their overlap is integrated.

use wide::f64x4;

use crate::numerics::lanes::{FOUR, Lanes};
use crate::wheel_rail::pair::{Candidate, Pair};

/// Step of the rail across the track, in units of the steps at which it is seen from above.
const STRIDE: usize = 5;

/// Overlap that the points resolve (in m), and in how many steps they resolve its half width.
const OVERLAP: f64 = 5e-5;
const STEPS: f64 = 5.0;

/// Shortest and longest step along the wheel, in m.
const SHORTEST: f64 = 5e-5;
const LONGEST: f64 = 5e-4;

/// Angle (in rad) by which a wheel may roll when its points meet those of the rail.
const ROLLING: f64 = 0.03;

/// Beside all rails, in m: where there is no wheel.
const NOWHERE: f64 = 1e3;

/// Angle (in rad) up to which a wheel may roll and yaw where parts of it are passed over.
const TURNING: f64 = 0.1;

/// A point of the wheel's profile, or four of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node<T = f64> {
    /// Arc length along the profile, in m.
    pub arc: T,
    /// Position along the axle, in m.
    pub y: T,
    /// Radius of the wheel, in m.
    pub radius: T,
    /// Slope dz/dy of the profile, dimensionless.
    pub slope: T,
    /// Part of the axle that it stands for, in m.
    pub width: T,
}

/// The rail at a position across the track, or at four of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RailAt<T = f64> {
    /// Height, in m.
    pub z: T,
    /// Slope, dimensionless.
    pub slope: T,
    /// Inclination, in rad.
    pub inclination: T,
    /// Its derivative, in rad/m.
    pub bend: T,
}

/// Four parts of the wheel that are side by side, each as it looks from a node in its middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts {
    pub middle: Node<f64x4>,
    /// To the further end, in m.
    pub half: f64x4,
    /// Least c ≥ 0 with which all nodes are above a parabola through the middle, −c Δy²/2 below its
    /// tangent; in 1/m.
    pub concavity: f64x4,
    /// Largest difference of slopes, and how far half their squares fall at most; dimensionless.
    pub turn: f64x4,
    pub fall: f64x4,
}

/// Parts of one size along the wheel.
#[derive(Debug, Clone)]
pub(super) struct Level {
    pub parts: Vec<Parts>,
    /// Largest second derivative of the rail, at least zero, that such a part may reach from each
    /// of its intervals; in 1/m.
    rising: Vec<f64>,
}

/// Both lines.
#[derive(Debug, Clone)]
pub(super) struct Outlines {
    /// By growing y, without those that face away from the rail.
    pub nodes: Vec<Node>,
    /// The same in fours; the last ones may have no width.
    pub blocks: Vec<Node<f64x4>>,
    /// Parts of four nodes each, then parts of sixteen, …, until they are few.
    pub levels: Vec<Level>,
    rail: Rail,
}

/// The rail at equal steps across the track; not a number where it is not seen from above, and
/// before and behind it.
#[derive(Debug, Clone)]
struct Rail {
    /// First position and step (in m), and the inverse of that.
    start: f64,
    step: f64,
    per_step: f64,
    /// The last interval.
    last: i32,
    /// Height (in m), slope times the step (in m), and inclination (in rad).
    at: Vec<[f64; 3]>,
}

impl Outlines {
    pub fn new(pair: &Pair) -> Self {
        let rail = Rail::new(pair);
        let placed = placed(pair, &rail);
        let of = |(place, candidate): &(f64, Candidate)| {
            let Candidate { arc, y, radius, slope } = *candidate;
            Node { arc, y: pair.wheel_offset + y, radius, slope, width: *place }
        };
        let nodes: Vec<Node> = placed.iter().map(of).collect();
        let four = |chunk: &[Node]| {
            let last = Node { width: 0.0, ..chunk[chunk.len() - 1] };
            Node::side_by_side(std::array::from_fn(|k| *chunk.get(k).unwrap_or(&last)))
        };
        let blocks = nodes.chunks(FOUR).map(four).collect();
        let mut levels = Vec::new();
        let mut size = FOUR;
        loop {
            let parts: Vec<&[Node]> = nodes.chunks(size).collect();
            let parts: Vec<Parts> = parts.chunks(FOUR).map(Parts::new).collect();
            let is_short = parts.len() <= FOUR;
            let reaches =
                parts.iter().map(|part| part.reach(TURNING, TURNING * TURNING).to_array());
            let reach = reaches.flatten().fold(0.0, f64::max);
            levels.push(Level { parts, rising: rail.rising(reach) });
            if is_short {
                return Self { nodes, blocks, levels, rail };
            }
            size *= FOUR;
        }
    }

    /// The rail at four places y (in m), and where it is seen from above; zeros elsewhere.
    #[inline]
    pub fn rail_at_four(&self, y: f64x4) -> (RailAt<f64x4>, [bool; FOUR]) {
        let [one, two, three, four] = y.to_array().map(|y| self.rail.around(y));
        let each = |end: usize, k: usize| {
            f64x4::from([one, two, three, four].map(|(ends, _)| ends[end][k]))
        };
        let ends = [0, 1].map(|end| [0, 1, 2].map(|k| each(end, k)));
        let t = f64x4::from([one, two, three, four].map(|(_, t)| t));
        let found = RailAt::between(ends, t, self.rail.per_step);
        let RailAt { z, slope, inclination, bend } = found;
        // What is not a number is not at most itself.
        let is_seen = z.at_most(z);
        let [z, slope, inclination, bend] =
            [z, slope, inclination, bend].map(|value| Lanes::choose(is_seen, value, f64x4::ZERO));
        let is_seen = found.z.to_array().map(|z| !z.is_nan());
        (RailAt { z, slope, inclination, bend }, is_seen)
    }

    /// Largest second derivative of the rail, at least zero, within reach of a part of a level with
    /// its middle at y (in m); in 1/m.
    #[inline]
    pub fn rising(&self, level: &Level, y: f64x4) -> f64x4 {
        f64x4::from(y.to_array().map(|y| level.rising[self.rail.interval(y).0]))
    }

    /// The rail at y, in m.
    #[inline]
    pub fn rail(&self, y: f64) -> Option<RailAt> {
        self.rail.at(y)
    }

    /// Whether the first or the last node is at an arc length, in m.
    #[inline]
    pub fn is_end(&self, arc: f64) -> bool {
        let [first, last] = [0, self.nodes.len() - 1].map(|k| self.nodes[k].arc);
        arc <= first || arc >= last
    }

    /// How far y is beside the rail; both in m.
    pub fn beside_rail(&self, y: f64) -> f64 {
        let Rail { start, step, last, .. } = &self.rail;
        (start + step - y).max(y - start - step * f64::from(*last))
    }

    /// Positions across the track (in m) at which the rail has a slope (dimensionless).
    pub fn with_slope(&self, slope: f64) -> Vec<f64> {
        let off = |at: &[f64; 3]| at[1] / self.rail.step - slope;
        let pairs = self.rail.at.windows(2).enumerate();
        let crossing = pairs.filter_map(|(k, two)| {
            let [from, to] = [off(&two[0]), off(&two[1])];
            let is_between = from * to <= 0.0 && from != to;
            is_between.then(|| self.rail.start + self.rail.step * (k as f64 + from / (from - to)))
        });
        crossing.collect()
    }
}

impl Node<f64x4> {
    fn side_by_side(nodes: [Node; FOUR]) -> Self {
        let of = |part: fn(&Node) -> f64| f64x4::from(nodes.each_ref().map(part));
        Self {
            arc: of(|node| node.arc),
            y: of(|node| node.y),
            radius: of(|node| node.radius),
            slope: of(|node| node.slope),
            width: of(|node| node.width),
        }
    }
}

impl Parts {
    fn new(parts: &[&[Node]]) -> Self {
        let nowhere = Node { arc: 0.0, y: NOWHERE, radius: 0.0, slope: 0.0, width: 0.0 };
        let middle = |k: usize| parts.get(k).map_or(nowhere, |part| part[part.len() / 2]);
        let middles = std::array::from_fn(middle);
        let of = |value: fn(&[Node]) -> f64| {
            f64x4::from(std::array::from_fn(|k| parts.get(k).map_or(0.0, |part| value(part))))
        };
        let half = |part: &[Node]| {
            let [first, middle, last] = [0, part.len() / 2, part.len() - 1].map(|k| part[k].y);
            (last - middle).max(middle - first)
        };
        let concavity = |part: &[Node]| {
            let Node { y, radius, slope, .. } = part[part.len() / 2];
            let below = part.iter().filter(|node| node.y != y).map(|node| {
                let away = node.y - y;
                2.0 * (node.radius - radius + slope * away) / (away * away)
            });
            below.fold(0.0, f64::max)
        };
        let turn = |part: &[Node]| {
            let turns = part.iter().map(|node| (node.slope - part[part.len() / 2].slope).abs());
            turns.fold(0.0, f64::max)
        };
        let fall = |part: &[Node]| {
            let square = |node: &Node| 0.5 * node.slope * node.slope;
            let falls = part.iter().map(|node| square(&part[part.len() / 2]) - square(node));
            falls.fold(0.0, f64::max)
        };
        Self {
            middle: Node::side_by_side(middles),
            half: of(half),
            concavity: of(concavity),
            turn: of(turn),
            fall: of(fall),
        }
    }

    /// How far nodes are at most from the middle across the track (in m), in a wheel that rolls by
    /// an angle (in rad) and yaws by one with a squared tangent.
    #[inline]
    pub fn reach(&self, roll: f64, lean: f64) -> f64x4 {
        let steepest = self.middle.slope.abs() + self.turn;
        let [roll, lean] = [roll.abs(), lean].map(f64x4::splat);
        let along = f64x4::ONE + roll * steepest + lean * steepest * steepest;
        self.half * along + self.middle.radius * self.turn * lean
    }
}

impl Rail {
    fn new(pair: &Pair) -> Self {
        let points = pair.rail_from_above.iter().step_by(STRIDE);
        let step = pair.across.at(STRIDE) - pair.across.at(0);
        let at = |point: &Option<_>| match point {
            Some(crate::wheel_rail::seen::Seen { z, extra: [inclination, _], .. }) => {
                [*z, step * inclination.tan(), *inclination]
            }
            None => [f64::NAN; 3],
        };
        let nothing = || std::iter::once([f64::NAN; 3]);
        let at: Vec<[f64; 3]> = nothing().chain(points.map(at)).chain(nothing()).collect();
        let (start, per_step) = (pair.across.at(0) - step, step.recip());
        Self { start, step, per_step, last: at.len() as i32 - 2, at }
    }

    /// Largest second derivative, at least zero, within a distance (in m) of each interval; in 1/m.
    fn rising(&self, distance: f64) -> Vec<f64> {
        let own = self.at.windows(2).map(|ends| {
            let [[z0, m0, _], [z1, m1, _]] = [ends[0], ends[1]];
            // Of Hermite's cubic, at both ends of the interval.
            let rise = 6.0 * (z1 - z0);
            let [start, end] = [rise - 4.0 * m0 - 2.0 * m1, 4.0 * m1 + 2.0 * m0 - rise];
            start.max(end).max(0.0) * self.per_step * self.per_step
        });
        let own: Vec<f64> = own.collect();
        let reach = (distance * self.per_step).ceil() as usize + 1;
        let around = |k: usize| {
            let near = &own[k.saturating_sub(reach)..(k + reach + 1).min(own.len())];
            near.iter().copied().fold(0.0, f64::max)
        };
        (0..own.len()).map(around).collect()
    }

    /// The interval around y, and the part of it before y.
    #[inline]
    fn interval(&self, y: f64) -> (usize, f64) {
        let place = (y - self.start) * self.per_step;
        let k = (place as i32).clamp(0, self.last);
        (k as usize, place - f64::from(k))
    }

    /// The ends of the interval around y, one of which is not a number where the rail is not seen;
    /// and the part of it before y.
    #[inline]
    fn around(&self, y: f64) -> (&[[f64; 3]; 2], f64) {
        let (k, t) = self.interval(y);
        let interval = self.at.get(k..).and_then(<[_]>::first_chunk);
        (interval.unwrap_or(&[[f64::NAN; 3]; 2]), t)
    }

    #[inline]
    fn at(&self, y: f64) -> Option<RailAt> {
        let (ends, t) = self.around(y);
        let found = RailAt::between(*ends, t, self.per_step);
        found.z.is_finite().then_some(found)
    }
}

impl<T: Lanes> RailAt<T> {
    /// Hermite's cubic between two points.
    #[inline]
    fn between([before, after]: [[T; 3]; 2], t: T, per_step: f64) -> Self {
        let ([z0, m0, i0], [z1, m1, i1]) = (before, after);
        let per_step = T::from(per_step);
        let (rise, double) = (z1 - z0, m0 + m0);
        let [two, three] = [m0 + m1 - rise - rise, rise + rise + rise - double - m1];
        let z = z0 + t * (m0 + t * (three + t * two));
        let slope = (m0 + t * (three + three + T::from(3.0) * t * two)) * per_step;
        let turn = i1 - i0;
        Self { z, slope, inclination: i0 + t * turn, bend: turn * per_step }
    }
}

/// Candidates at steps that resolve an overlap, each with the part of the axle that it stands for,
/// in m.
fn placed(pair: &Pair, rail: &Rail) -> Vec<(f64, Candidate)> {
    let bends = rail.at.windows(2).map(|two| {
        let bend = (two[1][2] - two[0][2]) / rail.step * two[0][2].cos();
        (two[0][2], bend.abs())
    });
    let mut bends: Vec<(f64, f64)> = bends.filter(|(at, _)| at.is_finite()).collect();
    bends.sort_unstable_by(|one, two| one.0.total_cmp(&two.0));
    let of_rail = |inclination: f64| {
        let first = bends.partition_point(|(at, _)| *at < inclination - ROLLING);
        let near = bends[first..].iter().take_while(|(at, _)| *at < inclination + ROLLING);
        near.map(|(_, bend)| *bend).fold(0.0, f64::max)
    };
    let mut kept: Vec<Candidate> = Vec::new();
    let mut next = f64::NEG_INFINITY;
    for candidate in pair.candidates.iter().flatten() {
        let is_next = kept.last().is_none_or(|last| candidate.y > last.y);
        if candidate.arc < next || !is_next {
            continue;
        }
        let curvature = pair.wheel.point(0.0, candidate.arc).map_or(0.0, |point| {
            let [y, z] = point.bend;
            y.hypot(z)
        });
        let curvature = curvature + of_rail(candidate.slope.atan());
        let step = (2.0 * OVERLAP / curvature).sqrt() / STEPS;
        next = candidate.arc + step.clamp(SHORTEST, LONGEST);
        kept.push(*candidate);
    }
    let y = |k: usize| kept[k].y;
    let last = kept.len().saturating_sub(1);
    let width = |k: usize| 0.5 * (y((k + 1).min(last)) - y(k.saturating_sub(1)));
    (0..kept.len()).map(|k| (width(k), kept[k])).collect()
}
