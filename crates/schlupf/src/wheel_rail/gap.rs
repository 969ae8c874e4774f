//! Where a wheel is close to a prismatic rail, and regions in which both would overlap.
//!
//! The candidates for contact are the points of the wheel at which its normal has no component
//! along the rail: exactly, so the longitudinal shift of the contact under yaw is that of the
//! surfaces. Above a roller they are those at which both surfaces have the same slope along it. The
//! gap between these points, seen from below, and the rail, seen from above, is vertical.
//!
//! The gap does not depend on the height and is computed once for each lateral position, roll and
//! yaw, at small steps. The point of first touch is found between them, so that the lightest load
//! has its region.

use super::overlap::{GapPoint, Region};
use super::pair::{Candidate, Pair};
use super::pose::{Attitude, Pose};
use super::relief::Relief;
use super::seen::Seen;
use crate::numerics::root::golden_section;
use crate::reporting::{Error, WheelRailError};

/// Largest x of a candidate relative to the radius of the wheel or of the roller, dimensionless.
const FARTHEST: f64 = 0.5;

/// Newton steps to a candidate above a roller.
const STEPS: usize = 5;

/// Golden sections to the point of first touch: a step becomes 10⁻¹³ m.
const SECTIONS: u32 = 40;

/// Power of the overlap with which the points of a region weigh in its middle, dimensionless:
/// integrated along rolling, the square of the depth.
const WEIGHT: f64 = 2.5;

/// The gap across a rail for a wheelset at its nominal height; raising the wheelset adds to it.
#[derive(Debug, Clone)]
pub(super) enum Gap {
    /// Of bodies that do not change along the way.
    Lines {
        /// Runs of neighbouring points at which both bodies are seen.
        runs: Vec<Vec<GapPoint>>,
        /// The one nearest to first touch, with the gap there.
        least: GapPoint,
    },
    /// Of others.
    Relief(Relief),
}

impl Gap {
    /// # Errors
    /// A wheel that is nowhere above the rail.
    pub fn new(pair: &Pair, attitude: &Attitude) -> Result<Self, Error> {
        let pose = pair.wheel_in(&attitude.at_height(pair.nominal_radius, 0.0));
        let beside = || {
            let wheel = pair.wheel_span.map(|y| y + pair.wheel_offset + pose.centre[1]);
            WheelRailError::BesideRail { wheel, rail: pair.across.ends }
        };
        if let Some(rail) = &pair.relief {
            let relief = Relief::new(pair, rail, &pose).ok_or_else(beside)?;
            return Ok(Self::Relief(relief));
        }
        let wheel = pair.across.wheel(wheel_line(pair, &pose));
        let mut runs: Vec<Vec<GapPoint>> = Vec::new();
        let mut is_open = false;
        for (k, (rail, wheel)) in pair.rail_from_above.iter().zip(wheel).enumerate() {
            let (Some(rail), Some(wheel)) = (rail, wheel) else {
                is_open = false;
                continue;
            };
            let z = pair.rail_height(wheel.extra[0], rail.z);
            let point = GapPoint {
                y: pair.across.at(k),
                rail: [z, rail.arc],
                inclination: rail.extra[0],
                wheel: [wheel.extra[0], wheel.arc],
                gap: wheel.z - z,
            };
            match runs.last_mut().filter(|_| is_open) {
                Some(run) => run.push(point),
                None => runs.push(vec![point]),
            }
            is_open = true;
        }
        let points = runs.iter().enumerate();
        let points = points.flat_map(|(run, of)| (0..of.len()).map(move |k| (run, k)));
        let gap = |(run, k): &(usize, usize)| runs[*run][*k].gap;
        let least = points.min_by(|one, other| gap(one).total_cmp(&gap(other)));
        let (run, k) = least.ok_or_else(beside)?;
        let beside = k.checked_sub(1).and_then(|first| runs[run].get(first..k + 2));
        let gap = beside.map_or(f64::INFINITY, |points| least_between(pair, &pose, points));
        let least = GapPoint { gap: gap.min(runs[run][k].gap), ..runs[run][k] };
        Ok(Self::Lines { runs, least })
    }

    /// The point with the least gap.
    pub fn least(&self) -> Option<GapPoint> {
        match self {
            Self::Lines { least, .. } => Some(*least),
            Self::Relief(relief) => relief.least(),
        }
    }

    /// An error if a point is where wheel or rail cease to be seen, so that a smaller gap may lie
    /// beyond.
    pub fn refuse_end(&self, pair: &Pair, point: &GapPoint) -> Result<(), Error> {
        let is = |end: Option<&GapPoint>| end.is_some_and(|end| end.y == point.y);
        let k = pair.across.index(point.y);
        let runs = match self {
            Self::Lines { runs, .. } => runs,
            Self::Relief(relief) if relief.is_end(point) => {
                let is_rail = point.rail[1] <= 0.0 || point.rail[1] >= pair.rail.length();
                return Err(pair.at_end(is_rail, [point.rail[1], point.wheel[1]], point.y));
            }
            Self::Relief(_) => return Ok(()),
        };
        let beyond = if runs.iter().any(|run| is(run.first())) {
            k.checked_sub(1)
        } else if runs.iter().any(|run| is(run.last())) {
            Some(k + 1)
        } else {
            return Ok(());
        };
        let rail = beyond.and_then(|k| pair.rail_from_above.get(k).copied().flatten());
        let arcs = [point.rail[1], point.wheel[1]];
        Err(pair.at_end(rail.is_none(), arcs, point.y))
    }

    /// Regions of overlap with the wheelset `height` (in m) above its nominal height, by growing y.
    /// `radius` (in m) is that of the wheel.
    pub fn regions(&self, height: f64, radius: f64) -> Vec<Region> {
        let is_overlap = |point: &GapPoint| point.gap + height < 0.0;
        let overlaps = |run: &Vec<GapPoint>| -> Vec<Region> {
            let parts = run.chunk_by(|p, q| is_overlap(p) == is_overlap(q));
            let parts = parts.filter(|part| is_overlap(&part[0]));
            parts.map(|part| region(part, height, radius)).collect()
        };
        match self {
            Self::Lines { runs, least } => {
                let regions: Vec<Region> = runs.iter().flat_map(overlaps).collect();
                let is_between = regions.is_empty() && is_overlap(least);
                if is_between { vec![region(&[*least], height, radius)] } else { regions }
            }
            Self::Relief(relief) => relief.regions(height),
        }
    }
}

/// The region of neighbouring points that overlap.
fn region(points: &[GapPoint], height: f64, radius: f64) -> Region {
    let depth = |point: &GapPoint| -point.gap - height;
    let weights: Vec<f64> = points.iter().map(|point| depth(point).powf(WEIGHT)).collect();
    let weight: f64 = weights.iter().sum();
    let mean = |value: fn(&GapPoint) -> f64| {
        points.iter().zip(&weights).map(|(point, own)| own * value(point)).sum::<f64>() / weight
    };
    let half = |point: &GapPoint| (2.0 * radius * depth(point)).sqrt();
    let end = |point: &GapPoint| [point.y, point.rail[0]];
    let y = mean(|point| point.y);
    let (first, last) = (&points[0], &points[points.len() - 1]);
    let after = points.partition_point(|point| point.y < y).min(points.len() - 1);
    Region {
        weight,
        x: mean(|point| point.wheel[0]),
        y,
        inclination: mean(|point| point.inclination),
        rise: 0.0,
        ends: [end(first), end(last)],
        along: [
            points.iter().map(|p| p.wheel[0] - half(p)).fold(f64::INFINITY, f64::min),
            points.iter().map(|p| p.wheel[0] + half(p)).fold(f64::NEG_INFINITY, f64::max),
        ],
        nearest: points[after],
    }
}

/// The candidates of the wheel in the track.
fn wheel_line(pair: &Pair, pose: &Pose) -> impl Iterator<Item = Option<Seen>> {
    pair.candidates.iter().map(move |candidate| seen_from_below(pair, pose, &(*candidate)?))
}

fn seen_from_below(pair: &Pair, pose: &Pose, candidate: &Candidate) -> Option<Seen> {
    let [mut sin, mut cos] = pose.silhouette(candidate.slope)?.sin_cos;
    if let Some(roller) = pair.roller {
        [sin, cos] = above_roller(pose, candidate, (pair, roller), [sin, cos])?;
    }
    let Candidate { arc, y, radius, .. } = *candidate;
    let [x, y, z] = pose.in_track([radius * sin, pair.wheel_offset + y, -radius * cos]);
    (sin.abs() <= FARTHEST).then_some(Seen { y, z, arc, extra: [x, 0.0] })
}

/// The least gap between the first and the last of some neighbours, in m.
fn least_between(pair: &Pair, pose: &Pose, points: &[GapPoint]) -> f64 {
    let [.., before, _, after] = points else { return f64::INFINITY };
    let gap = |arc: f64| {
        let candidate = Candidate::new(arc, &pair.wheel.point(0.0, arc)?, pair.nominal_radius)?;
        let wheel = seen_from_below(pair, pose, &candidate)?;
        let rail = pair.rail_arc([0.0, wheel.y], 0.5 * (before.rail[1] + after.rail[1]));
        let [_, z] = pair.rail.point(0.0, rail)?.place;
        Some(wheel.z - pair.rail_height(wheel.extra[0], z))
    };
    let gap = |arc: f64| gap(arc).unwrap_or(f64::INFINITY);
    gap(golden_section([before.wheel[1], after.wheel[1]], SECTIONS, gap))
}

/// Sine and cosine of the angle at which a point of the wheel has the slope along the track that a
/// roller of a radius (in m) has below it, from those at which it has none; dimensionless.
///
/// With the normal N of the wheel, −N_x/N_z = −x/√(r² − x²).
fn above_roller(
    pose: &Pose,
    candidate: &Candidate,
    (pair, roller): (&Pair, f64),
    [sin, cos]: [f64; 2],
) -> Option<[f64; 2]> {
    let Candidate { y, radius, slope, .. } = *candidate;
    let mut angle = sin.atan2(cos);
    let mut place = [sin, cos];
    for _ in 0..STEPS {
        let [sin, cos] = place;
        let [n_x, _, n_z] = pose.turned([sin, slope, -cos]);
        let [by_x, _, by_z] = pose.turned([cos, 0.0, sin]);
        let [x, ..] = pose.in_track([radius * sin, pair.wheel_offset + y, -radius * cos]);
        let height = (roller * roller - x * x).sqrt();
        let off = n_x / n_z - x / height;
        let slope = (by_x * n_z - n_x * by_z) / (n_z * n_z)
            - radius * by_x * roller * roller / height.powi(3);
        angle -= off / slope;
        if !(angle.abs() < 1.0 && x.abs() <= FARTHEST * roller) {
            return None;
        }
        let (sin, cos) = angle.sin_cos();
        place = [sin, cos];
    }
    Some(place)
}
