//! Where a wheel is close to a prismatic rail, and regions in which both would overlap.
//!
//! The candidates for contact are the points of the wheel at which its normal has no component
//! along the rail. On the surface of revolution of radius r(y) they lie, in the wheelset's axes, at
//! x = −r r′ tan ψ with the yaw angle ψ: exactly, so the longitudinal shift of the contact under
//! yaw is that of the surfaces. The gap between these points, seen from below, and the rail, seen
//! from above, is vertical.

use super::pair::{FLATTEST, Pair, Samples};
use super::pose::Attitude;
use crate::error::{Error, WheelRailError};

/// Step of the gap across the rail, in m.
const STEP: f64 = 2e-5;

/// Largest x of a candidate relative to the radius of the wheel, dimensionless.
const FARTHEST: f64 = 0.5;

/// Power of the overlap with which the points of a region weigh in its middle, dimensionless:
/// integrated along rolling, the square of the depth.
const WEIGHT: f64 = 2.5;

/// A point of the gap.
#[derive(Debug, Clone, Copy)]
pub(super) struct GapPoint {
    /// Lateral position in the track, in m.
    pub y: f64,
    /// The rail's height there, in m, and arc length, in m.
    pub rail: [f64; 2],
    /// Inclination of the rail, in rad.
    pub inclination: f64,
    /// x of the wheel's candidate in the track, in m, and its arc length, in m.
    pub wheel: [f64; 2],
    /// Vertical gap (in m) with the wheelset at its nominal height.
    pub gap: f64,
}

/// The gap across a rail for a wheelset at its nominal height; raising the wheelset adds to it.
#[derive(Debug, Clone)]
pub(super) struct Gap {
    /// Runs of neighbouring points at which both bodies are seen.
    runs: Vec<Vec<GapPoint>>,
}

/// A region in which wheel and rail would overlap.
#[derive(Debug, Clone, Copy)]
pub(super) struct Region {
    /// Sum of the depths to the power of 2.5, in m to that power.
    pub weight: f64,
    /// Weighted mean, in m.
    pub x: f64,
    /// Weighted mean, in m.
    pub y: f64,
    /// Weighted mean of the rail's inclination, in rad.
    pub inclination: f64,
    /// Ends on the rail, y and z in m.
    pub ends: [[f64; 2]; 2],
    /// Extent along x, in m.
    pub along: [f64; 2],
    /// The nearest gap point to the middle.
    pub nearest: GapPoint,
}

impl Gap {
    /// # Errors
    /// A wheel that is nowhere above the rail.
    pub fn new(pair: &Pair, attitude: &Attitude) -> Result<Self, Error> {
        let [from, to] = pair.rail_samples.span();
        let count = ((to - from) / STEP).floor() as usize + 1;
        let grid = |k: usize| from + k as f64 * STEP;
        let rail = seen(count, grid, &rail_lines(&pair.rail_samples), |one, other| one > other);
        let wheel = seen(count, grid, &wheel_lines(pair, attitude), |one, other| one < other);
        let mut runs: Vec<Vec<GapPoint>> = Vec::new();
        let mut is_open = false;
        for (k, (rail, wheel)) in rail.into_iter().zip(wheel).enumerate() {
            let (Some(rail), Some(wheel)) = (rail, wheel) else {
                is_open = false;
                continue;
            };
            let point = GapPoint {
                y: grid(k),
                rail: [rail.z, rail.arc],
                inclination: rail.extra,
                wheel: [wheel.extra, wheel.arc],
                gap: wheel.z - rail.z,
            };
            match runs.last_mut().filter(|_| is_open) {
                Some(run) => run.push(point),
                None => runs.push(vec![point]),
            }
            is_open = true;
        }
        if runs.is_empty() {
            let wheel = pair.wheel_samples.span();
            let wheel = wheel.map(|y| y + pair.wheel_offset + attitude.lateral);
            return Err(WheelRailError::BesideRail { wheel, rail: [from, to] }.into());
        }
        Ok(Self { runs })
    }

    /// The point with the least gap.
    pub fn least(&self) -> Option<GapPoint> {
        let points = self.runs.iter().flatten();
        points.min_by(|one, other| one.gap.total_cmp(&other.gap)).copied()
    }

    /// Regions of overlap with the wheelset `height` (in m) above its nominal height, by growing y.
    /// `radius` (in m) is that of the wheel.
    pub fn regions(&self, height: f64, radius: f64) -> Vec<Region> {
        let is_overlap = |point: &GapPoint| point.gap + height < 0.0;
        let overlaps = |run: &Vec<GapPoint>| -> Vec<Region> {
            let parts = run.chunk_by(|p, q| is_overlap(p) == is_overlap(q));
            let parts = parts.filter(|part| is_overlap(&part[0]));
            parts.map(|part| Region::of(part, height, radius)).collect()
        };
        self.runs.iter().flat_map(overlaps).collect()
    }
}

impl Region {
    fn of(points: &[GapPoint], height: f64, radius: f64) -> Self {
        let depth = |point: &GapPoint| -point.gap - height;
        let weigh = |point: &GapPoint| depth(point).powf(WEIGHT);
        let weight: f64 = points.iter().map(weigh).sum();
        let mean = |value: fn(&GapPoint) -> f64| {
            points.iter().map(|point| weigh(point) * value(point)).sum::<f64>() / weight
        };
        let half = |point: &GapPoint| (2.0 * radius * depth(point)).sqrt();
        let end = |point: &GapPoint| [point.y, point.rail[0]];
        let y = mean(|point| point.y);
        let (first, last) = (&points[0], &points[points.len() - 1]);
        let after = points.partition_point(|point| point.y < y).min(points.len() - 1);
        Self {
            weight,
            x: mean(|point| point.wheel[0]),
            y,
            inclination: mean(|point| point.inclination),
            ends: [end(first), end(last)],
            along: [
                points.iter().map(|p| p.wheel[0] - half(p)).fold(f64::INFINITY, f64::min),
                points.iter().map(|p| p.wheel[0] + half(p)).fold(f64::NEG_INFINITY, f64::max),
            ],
            nearest: points[after],
        }
    }
}

/// A point of a line that is seen from above or below, y and z in m, with something that goes with
/// it.
#[derive(Debug, Clone, Copy)]
struct Seen {
    y: f64,
    z: f64,
    /// Arc length along the profile, in m.
    arc: f64,
    extra: f64,
}

/// Runs of points along which y grows.
fn rail_lines(samples: &Samples) -> Vec<Option<Seen>> {
    let points = samples.arc.iter().zip(&samples.points);
    points
        .map(|(arc, point)| {
            let [y, z] = point.place;
            Some(Seen { y, z, arc: *arc, extra: point.inclination() })
        })
        .collect()
}

/// The candidates of the wheel in the track.
fn wheel_lines(pair: &Pair, attitude: &Attitude) -> Vec<Option<Seen>> {
    let pose = attitude.at_height(pair.nominal_radius, 0.0);
    let tangent = attitude.yaw.tan();
    let samples = pair.wheel_samples.arc.iter().zip(&pair.wheel_samples.points);
    samples
        .map(|(arc, point)| {
            let ([y, z], [along, up]) = (point.place, point.tangent);
            let radius = pair.nominal_radius - z;
            let x = radius * up / along * tangent;
            if along < FLATTEST || x.abs() > FARTHEST * radius {
                return None;
            }
            let below = -(radius * radius - x * x).sqrt();
            let [x, y, z] = pose.in_track([x, pair.wheel_offset + y, below]);
            Some(Seen { y, z, arc: *arc, extra: x })
        })
        .collect()
}

/// What is seen of a line at `count` positions: where it folds over itself, the z that `is_nearer`.
fn seen(
    count: usize,
    grid: impl Fn(usize) -> f64,
    line: &[Option<Seen>],
    is_nearer: impl Fn(f64, f64) -> bool,
) -> Vec<Option<Seen>> {
    let start = grid(0);
    let step = grid(1) - start;
    let mut found: Vec<Option<Seen>> = vec![None; count];
    for pair in line.windows(2) {
        let (Some(one), Some(two)) = (pair[0], pair[1]) else { continue };
        if two.y <= one.y {
            continue;
        }
        let first = ((one.y - start) / step).ceil().max(0.0) as usize;
        for (k, place) in found.iter_mut().enumerate().skip(first) {
            let y = grid(k);
            if y > two.y {
                break;
            }
            let share = (y - one.y) / (two.y - one.y);
            let mixed = |from: f64, to: f64| from + share * (to - from);
            let z = mixed(one.z, two.z);
            if place.is_none_or(|known| is_nearer(z, known.z)) {
                let (arc, extra) = (mixed(one.arc, two.arc), mixed(one.extra, two.extra));
                *place = Some(Seen { y, z, arc, extra });
            }
        }
    }
    found
}
