//! Where a wheel is close to a rail if one of them changes along the way: the vertical gap on a
//! lattice over x and y, and the regions of overlap as connected parts of it.
//!
//! In every plane x = const both bodies are lines, of which the rail is seen from above and the
//! wheel from below. Along x the gap is Catmull and Rom's cubic (1974) through the lattice, which
//! is exact for parabolas. The means of a region weigh the square of the depth, as those of
//! [`super::gap`] do along rolling.

use super::overlap::{GapPoint, Region};
use super::pair::Pair;
use super::pose::Pose;
use super::profile_curve::{CurvePoint, ProfileCurve};
use super::rail_relief::{RailRelief, STEP, along};
use super::seen::{Across, FLATTEST, Seen};
use crate::numerics::interpolation::hermite;

/// Parts into which interpolation divides a step along the track.
const PARTS: usize = 8;

/// What the gap between two nodes may be less than at both of them, in m.
const DIP: f64 = 3e-5;

/// Rounds to the angle at which a point of a wheel that is out of round is in a plane.
const ROUNDS: usize = 3;

/// The gap on a lattice, for a wheelset at its nominal height.
#[derive(Debug, Clone)]
pub(super) struct Relief {
    across: Across,
    /// In m.
    x: Vec<f64>,
    /// In m, in rows along x; infinite where one of the bodies is not seen.
    gap: Vec<f64>,
    /// The least gap of each row, in m.
    least: Vec<f64>,
    points: Vec<Option<GapPoint>>,
    /// Angle by which the rail rises forwards, in rad.
    rise: Vec<f64>,
}

/// Neighbouring parts of steps in a row in which the bodies overlap.
struct Stretch {
    row: usize,
    /// First and last part.
    ends: [usize; 2],
}

impl Relief {
    /// Of a wheel with a pose in the track; `None` if it is nowhere above the rail.
    pub fn new(pair: &Pair, rail: &RailRelief, pose: &Pose) -> Option<Self> {
        let (across, x) = (rail.across, rail.x.clone());
        let (columns, rows) = (x.len(), across.count);
        let mut gap = vec![f64::INFINITY; columns * rows];
        let mut points = vec![None; columns * rows];
        let mut rise = vec![0.0; columns * rows];
        let wheel = Wheel::new(pair, pose);
        for (i, x) in x.iter().enumerate() {
            let seen = across.wheel(wheel.in_plane(*x));
            for (k, (wheel, rail)) in seen.iter().zip(rail.column(i)).enumerate() {
                let (Some(wheel), Some(rail)) = (wheel, rail) else { continue };
                let z = pair.rail_height(*x, rail.z);
                let at = k * columns + i;
                gap[at] = wheel.z - z;
                rise[at] = rail.extra[1];
                points[at] = Some(GapPoint {
                    y: across.at(k),
                    rail: [z, rail.arc],
                    inclination: rail.extra[0],
                    wheel: [*x, wheel.arc],
                    gap: gap[at],
                });
            }
        }
        let mut relief = Self { across, x, gap, least: Vec::new(), points, rise };
        relief.least =
            (0..rows).map(|k| relief.least_of(k).map_or(f64::INFINITY, |p| p.1)).collect();
        relief.least.iter().any(|gap| gap.is_finite()).then_some(relief)
    }

    fn node(&self, row: usize, i: usize) -> f64 {
        self.gap[row * self.x.len() + i]
    }

    /// The gap in a row at a part of a step, in m.
    fn at(&self, row: usize, part: usize) -> f64 {
        let (i, share) = (part / PARTS, (part % PARTS) as f64 / PARTS as f64);
        let (one, last) = (self.node(row, i), self.x.len() - 1);
        if share == 0.0 || !one.is_finite() {
            return one;
        }
        let two = self.node(row, i + 1);
        let beside = |here: f64, other: f64, there: Option<usize>| {
            let beyond = there.map_or(f64::INFINITY, |i| self.node(row, i));
            if beyond.is_finite() { beyond } else { 2.0 * here - other }
        };
        let before = beside(one, two, i.checked_sub(1));
        let after = beside(two, one, (i + 2 <= last).then_some(i + 2));
        let [a, b] = [0.5 * (two - before), 0.5 * (after - one)];
        let weights = hermite(share);
        weights[0] * one + weights[1] * two + weights[2] * a + weights[3] * b
    }

    /// Part of a step with the least gap in a row, and that gap in m.
    fn least_of(&self, row: usize) -> Option<(usize, f64)> {
        let columns = self.x.len();
        let of = |i: &usize| self.node(row, *i);
        let lowest = (0..columns).map(|i| of(&i)).fold(f64::INFINITY, f64::min);
        let near = (0..columns - 1).filter(|i| of(i).min(of(&(i + 1))) < lowest + DIP);
        let parts = near.flat_map(|i| i * PARTS..=(i + 1) * PARTS);
        let gaps = parts.map(|part| (part, self.at(row, part)));
        gaps.filter(|(_, gap)| gap.is_finite()).min_by(|one, two| one.1.total_cmp(&two.1))
    }

    fn position(&self, part: usize) -> f64 {
        self.x[0] + part as f64 * STEP / PARTS as f64
    }

    /// The node next to a part of a step in a row at which both bodies are seen.
    fn beside(&self, row: usize, part: usize) -> Option<usize> {
        let near = (part + PARTS / 2) / PARTS;
        let nodes = [near, part / PARTS, part / PARTS + 1].map(|i| row * self.x.len() + i);
        nodes.into_iter().find(|node| self.points.get(*node).is_some_and(Option::is_some))
    }

    fn point(&self, row: usize, part: usize) -> Option<GapPoint> {
        let near = self.points[self.beside(row, part)?]?;
        Some(GapPoint {
            gap: self.at(row, part),
            wheel: [self.position(part), near.wheel[1]],
            ..near
        })
    }

    /// The point with the least gap.
    pub fn least(&self) -> Option<GapPoint> {
        let rows = 0..self.least.len();
        let row = rows.min_by(|j, k| self.least[*j].total_cmp(&self.least[*k]))?;
        self.point(row, self.least_of(row)?.0)
    }

    /// Whether one of the bodies ceases to be seen next to a point.
    pub fn is_end(&self, point: &GapPoint) -> bool {
        let row = self.across.index(point.y);
        let i = ((point.wheel[0] - self.x[0]) / STEP).round() as usize;
        let (columns, rows) = (self.x.len(), self.least.len());
        let is_inside = row > 0 && row + 1 < rows && i > 0 && i + 1 < columns;
        let is_seen = |row: usize, i: usize| self.node(row, i).is_finite();
        !(is_inside
            && [(row - 1, i), (row + 1, i), (row, i - 1), (row, i + 1)]
                .iter()
                .all(|(row, i)| is_seen(*row, *i)))
    }

    /// Regions of overlap with the wheelset `height` (in m) above its nominal height, by growing y.
    pub fn regions(&self, height: f64) -> Vec<Region> {
        let stretches = self.stretches(height);
        let mut group: Vec<usize> = (0..stretches.len()).collect();
        for k in 0..stretches.len() {
            for j in (0..k).rev().take_while(|j| stretches[*j].row + 1 >= stretches[k].row) {
                if stretches[j].touches(&stretches[k]) {
                    let (one, two) = (root(&group, j), root(&group, k));
                    group[one.max(two)] = one.min(two);
                }
            }
        }
        let roots: Vec<usize> = (0..stretches.len()).map(|k| root(&group, k)).collect();
        let heads = (0..stretches.len()).filter(|k| roots[*k] == *k);
        let own = |head: usize| {
            let members = stretches.iter().zip(&roots).filter(move |(_, root)| **root == head);
            members.map(|(stretch, _)| stretch).collect::<Vec<_>>()
        };
        let mut regions: Vec<Region> =
            heads.filter_map(|head| self.region(&own(head), height)).collect();
        regions.sort_unstable_by(|one, two| one.ends[0][0].total_cmp(&two.ends[0][0]));
        regions
    }

    fn stretches(&self, height: f64) -> Vec<Stretch> {
        let mut found = Vec::new();
        for row in (0..self.least.len()).filter(|row| self.least[*row] + height < 0.0) {
            let mut open: Option<usize> = None;
            let parts = (self.x.len() - 1) * PARTS;
            let mut part = 0;
            while part <= parts {
                let i = (part / PARTS).min(self.x.len() - 2);
                let is_clear = self.node(row, i).min(self.node(row, i + 1)) + height > DIP;
                let is_overlap = !is_clear && self.at(row, part) + height < 0.0;
                match open {
                    None if is_overlap => open = Some(part),
                    Some(from) if !is_overlap => {
                        found.push(Stretch { row, ends: [from, part - 1] });
                        open = None;
                    }
                    _ => {}
                }
                part += if is_clear && part % PARTS == 0 && part < parts { PARTS } else { 1 };
            }
            if let Some(from) = open {
                found.push(Stretch { row, ends: [from, parts] });
            }
        }
        found
    }

    fn region(&self, stretches: &[&Stretch], height: f64) -> Option<Region> {
        let mut sums = [0.0; 5];
        let mut deepest: Option<(f64, usize, usize)> = None;
        for Stretch { row, ends } in stretches {
            for part in ends[0]..=ends[1] {
                let (depth, Some(node)) = (-self.at(*row, part) - height, self.beside(*row, part))
                else {
                    continue;
                };
                let (weight, Some(point)) = (depth * depth, self.points[node]) else { continue };
                let values =
                    [1.0, self.position(part), point.y, point.inclination, self.rise[node]];
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
                if deepest.is_none_or(|(other, ..)| depth > other) {
                    deepest = Some((depth, *row, part));
                }
            }
        }
        let (_, row, part) = deepest?;
        let [weight, x, y, inclination, rise] = sums;
        let [x, y, inclination, rise] = [x, y, inclination, rise].map(|sum| sum / weight);
        let end = |stretch: &Stretch| {
            let middle = usize::midpoint(stretch.ends[0], stretch.ends[1]);
            Some([self.across.at(stretch.row), self.point(stretch.row, middle)?.rail[0]])
        };
        let (first, last) = (stretches.first()?, stretches.last()?);
        let parts = || stretches.iter().flat_map(|stretch| stretch.ends);
        let step = STEP / PARTS as f64;
        Some(Region {
            weight,
            x,
            y,
            inclination,
            rise,
            ends: [end(first)?, end(last)?],
            along: [self.position(parts().min()?) - step, self.position(parts().max()?) + step],
            nearest: self.point(row, part)?,
        })
    }
}

impl Stretch {
    fn touches(&self, other: &Self) -> bool {
        self.row != other.row
            && self.ends[0] <= other.ends[1] + 1
            && other.ends[0] <= self.ends[1] + 1
    }
}

fn root(group: &[usize], mut k: usize) -> usize {
    while group[k] != k {
        k = group[k];
    }
    k
}

/// A wheel to be cut by planes across the track.
struct Wheel<'a> {
    pair: &'a Pair,
    pose: &'a Pose,
    arcs: Vec<f64>,
    /// Of a round wheel.
    points: Vec<CurvePoint>,
}

impl<'a> Wheel<'a> {
    fn new(pair: &'a Pair, pose: &'a Pose) -> Self {
        let arcs = along(&pair.wheel);
        let of = |curve: &ProfileCurve| arcs.iter().map(|arc| curve.at(*arc)).collect();
        let points = pair.wheel.uniform().map_or_else(Vec::new, of);
        Self { pair, pose, arcs, points }
    }

    /// Its line in the plane at x (in m).
    fn in_plane(&self, x: f64) -> impl Iterator<Item = Option<Seen>> {
        (0..self.arcs.len()).map(move |k| {
            let [along, across, up] = self.pose.rotation[0];
            let size = along.hypot(up);
            let mut angle = up.atan2(along);
            let start = angle;
            let mut found = None;
            for _ in 0..if self.points.is_empty() { ROUNDS } else { 1 } {
                let point = match self.points.get(k) {
                    Some(point) => *point,
                    None => self.pair.wheel.point(angle, self.arcs[k])?,
                };
                let radius = self.pair.nominal_radius - point.place[1];
                let y = self.pair.wheel_offset + point.place[0];
                let sine = (x - self.pose.centre[0] - across * y) / (size * radius);
                if sine.abs() >= 1.0 {
                    return None;
                }
                angle = start + sine.asin();
                found = (point.tangent[0] >= FLATTEST).then_some([radius, y]);
            }
            let [radius, y] = found?;
            let (sin, cos) = angle.sin_cos();
            let [_, y, z] = self.pose.in_track([radius * sin, y, -radius * cos]);
            Some(Seen { y, z, arc: self.arcs[k], extra: [x, 0.0] })
        })
    }
}
