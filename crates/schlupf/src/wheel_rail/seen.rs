//! What is seen of a line from above or from below, at equal steps across the rail.

use super::profile_curve::CurvePoint;

/// Step across a rail, in m, and that with surfaces that change along the way.
const STEP: f64 = 2e-5;
const COARSE_STEP: f64 = 1e-4;

/// Smallest part of y in the direction of a profile that is seen from above or below,
/// dimensionless: steeper parts hide beneath others.
pub(super) const FLATTEST: f64 = 1e-3;

/// Equidistant positions across a rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Across {
    /// Ends of the rail, in m.
    pub ends: [f64; 2],
    /// Number of positions, from the first end on.
    pub count: usize,
    /// In m.
    step: f64,
}

/// A point of a line that is seen from above or below.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    /// In the track, in m.
    pub y: f64,
    /// In the track, in m.
    pub z: f64,
    /// Arc length along the profile, in m.
    pub arc: f64,
    /// What goes with it: the inclination of a rail and the angle by which it rises forwards in
    /// rad, x of a wheel in m.
    pub extra: [f64; 2],
}

impl Across {
    /// Between two ends (in m).
    pub fn between(ends: [f64; 2]) -> Self {
        Self::every(STEP, ends)
    }

    /// The same with larger steps.
    pub fn coarsely(ends: [f64; 2]) -> Self {
        Self::every(COARSE_STEP, ends)
    }

    fn every(step: f64, ends: [f64; 2]) -> Self {
        Self { ends, count: ((ends[1] - ends[0]) / step).floor() as usize + 1, step }
    }

    /// A position, in m.
    pub fn at(&self, k: usize) -> f64 {
        self.ends[0] + k as f64 * self.step
    }

    /// The index of a position (in m).
    pub fn index(&self, y: f64) -> usize {
        ((y - self.ends[0]) / self.step).round() as usize
    }

    /// The rail as it is seen from above, with its inclination (in rad).
    pub fn rail(&self, arc: &[f64], points: &[CurvePoint]) -> Vec<Option<Seen>> {
        self.seen_from_above(arc.iter().zip(points).map(|(arc, point)| {
            let [y, z] = point.place;
            Some(Seen { y, z, arc: *arc, extra: [point.inclination(), 0.0] })
        }))
    }

    /// A rail as it is seen from above.
    pub fn seen_from_above(&self, line: impl Iterator<Item = Option<Seen>>) -> Vec<Option<Seen>> {
        self.seen(line, |one, other| one > other)
    }

    /// The wheel as it is seen from below.
    pub fn wheel(&self, line: impl Iterator<Item = Option<Seen>>) -> Vec<Option<Seen>> {
        self.seen(line, |one, other| one < other)
    }

    /// What is seen of a line along which y grows: where it folds over itself, the z that
    /// `is_nearer`. It is interrupted where it has no point.
    fn seen(
        &self,
        line: impl Iterator<Item = Option<Seen>>,
        is_nearer: impl Fn(f64, f64) -> bool,
    ) -> Vec<Option<Seen>> {
        let start = self.ends[0];
        let mut found: Vec<Option<Seen>> = vec![None; self.count];
        let mut before: Option<Seen> = None;
        for point in line {
            let (Some(one), Some(two)) = (std::mem::replace(&mut before, point), point) else {
                continue;
            };
            if two.y <= one.y || two.y < start {
                continue;
            }
            // To round up is a call of a function on many processors.
            let from = ((one.y - start) / self.step).max(0.0);
            let whole = from as usize;
            let first = whole + usize::from(from > whole as f64);
            for (k, place) in found.iter_mut().enumerate().skip(first) {
                let y = self.at(k);
                if y > two.y {
                    break;
                }
                let share = (y - one.y) / (two.y - one.y);
                let mixed = |from: f64, to: f64| from + share * (to - from);
                let z = mixed(one.z, two.z);
                if place.is_none_or(|known| is_nearer(z, known.z)) {
                    let arc = mixed(one.arc, two.arc);
                    let extra = [0, 1].map(|c| mixed(one.extra[c], two.extra[c]));
                    *place = Some(Seen { y, z, arc, extra });
                }
            }
        }
        found
    }
}
