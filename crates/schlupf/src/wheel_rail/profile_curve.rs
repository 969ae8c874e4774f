//! The profile of a wheel or a rail as a curve (y(s), z(s)) over its length s.
//!
//! y points outwards, away from the middle of the track, and z up; s grows with y. Points closer
//! together than [`LEAST_SPACING`] are thinned, because the rounding of printed numbers over steps
//! of 10⁻⁵ mm makes curvatures of thousands per metre. Through the rest runs a cubic spline over
//! the arc length, or a smoothing spline (see [`ProfileCurve::new`]), which is split where the
//! profile has a kink.

use super::spline;
use crate::numerics::interpolation::{hermite, hermite_slope};
use crate::numerics::quadrature;
use crate::reporting::{Error, Place, Quantity, Requirement, WheelRailError, require_at};

/// Least distance of two points that a curve runs through, in m.
pub const LEAST_SPACING: f64 = 3e-5;

/// Least turn of the direction at a kink, dimensionless (rad).
const KINK: f64 = 0.35;

/// Largest turn at the points next to a kink relative to that of the kink, dimensionless: arcs with
/// few points turn as much at every point.
const KINK_RATIO: f64 = 0.3;

/// Distance of the points between which directions are taken, over the length of the smoothing:
/// arcs of up to one and a half of it are kinks, too.
const REACH: f64 = 0.25;

/// Least number of points of a profile.
const FEWEST_POINTS: usize = 4;

/// Largest coordinate, in m: more is a wrong unit.
const LARGEST: f64 = 1.0;

/// A profile as a smooth curve.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileCurve {
    /// Arc length at the points, in m, ascending.
    length: Vec<f64>,
    /// y and z of the points, in m.
    points: Vec<[f64; 2]>,
    /// Slopes of y and z at the start and at the end of each interval, dimensionless.
    slopes: Vec<[[f64; 2]; 2]>,
    smoothing: f64,
}

/// A point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// y and z, in m.
    pub place: [f64; 2],
    /// Their derivatives with respect to the arc length, dimensionless.
    pub tangent: [f64; 2],
    /// Their second derivatives, in 1/m.
    pub bend: [f64; 2],
}

impl CurvePoint {
    /// Inclination of the curve, dimensionless (rad): positive where z grows with y.
    pub fn inclination(&self) -> f64 {
        self.tangent[1].atan2(self.tangent[0])
    }

    /// Curvature, in 1/m: positive where the curve turns upwards as y grows.
    pub fn curvature(&self) -> f64 {
        let [[y, z], [yy, zz]] = [self.tangent, self.bend];
        (y * zz - z * yy) / y.hypot(z).powi(3)
    }
}

impl ProfileCurve {
    /// The curve through `points` (y outwards and z up, in m, from either end), smoothed over a
    /// length L (in m; 0: not at all): what is shorter than L along the profile is levelled out.
    /// `quantity` is the profile of the wheel or of the rail, for messages.
    ///
    /// ```
    /// use schlupf::Quantity;
    /// use schlupf::wheel_rail::ProfileCurve;
    ///
    /// let arc = |k: i32| {
    ///     let angle = 1e-3 * f64::from(k);
    ///     [0.3 * angle.sin(), 0.3 * (angle.cos() - 1.0)]
    /// };
    /// let points: Vec<_> = (-50..=50).map(arc).collect();
    /// let curve = ProfileCurve::new(&points, 0.0, Quantity::RailProfile)?;
    /// assert!((curve.at(0.5 * curve.length()).curvature() + 1.0 / 0.3).abs() < 1e-6);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// Fewer than four points, a coordinate that is not finite or beyond 1 m, an impossible length.
    pub fn new(points: &[[f64; 2]], smoothing: f64, quantity: Quantity) -> Result<Self, Error> {
        for (k, coordinate) in points.iter().enumerate().flat_map(|(k, p)| p.map(|c| (k, c))) {
            let requirement = Requirement::Magnitude(LARGEST);
            require_at(quantity, requirement, coordinate, Place::Index(k + 1))?;
        }
        let points = thinned(points);
        if points.len() < FEWEST_POINTS {
            let (count, fewest) = (points.len(), FEWEST_POINTS);
            return Err(WheelRailError::FewPoints { profile: quantity, count, fewest }.into());
        }
        let requirement = Requirement::Between(0.0, LARGEST);
        crate::reporting::require(Quantity::ProfileSmoothing, requirement, smoothing)?;
        let kinks = kinks(&points, REACH * smoothing);
        let mut length = chords(&points);
        let points = smoothed(&length, points, &kinks, smoothing);
        let mut slopes = fitted(&length, &points, &kinks);
        for _ in 0..3 {
            // From the length of the chords to that of the curve itself.
            let curve = Self { length, points: points.clone(), slopes, smoothing };
            length = curve.arc_lengths();
            slopes = fitted(&length, &points, &kinks);
        }
        Ok(Self { length, points, slopes, smoothing })
    }

    /// Its length, in m.
    pub fn length(&self) -> f64 {
        self.length[self.length.len() - 1]
    }

    /// The length over which it was smoothed, in m.
    pub fn smoothing(&self) -> f64 {
        self.smoothing
    }

    /// The points that it runs through, y and z in m.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The step between two points that covers most of an interval of arc lengths (in m): its
    /// length, in m, the part of the interval that it covers, dimensionless, and y of its ends, in
    /// m.
    pub(super) fn widest_step(&self, [from, to]: [f64; 2]) -> Option<[f64; 4]> {
        let covered = |k: &usize| self.length[k + 1].min(to) - self.length[*k].max(from);
        let steps = 0..self.length.len() - 1;
        let k = steps.max_by(|j, k| covered(j).total_cmp(&covered(k)))?;
        let share = covered(&k) / (to - from);
        let step = self.length[k + 1] - self.length[k];
        share.is_finite().then(|| [step, share, self.points[k][0], self.points[k + 1][0]])
    }

    /// The median step between two points, in m.
    pub(super) fn usual_step(&self) -> f64 {
        let mut steps: Vec<f64> = self.length.windows(2).map(|pair| pair[1] - pair[0]).collect();
        steps.sort_unstable_by(f64::total_cmp);
        steps[steps.len() / 2]
    }

    /// The point at an arc length `s` (in m) from the first one; at the ends the outermost cubics
    /// are continued.
    pub fn at(&self, s: f64) -> CurvePoint {
        let after = self.length.partition_point(|length| *length <= s);
        let k = after.clamp(1, self.length.len() - 1) - 1;
        let width = self.length[k + 1] - self.length[k];
        let t = (s - self.length[k]) / width;
        let [value, slope] = [hermite(t), hermite_slope(t)];
        let bend = [12.0 * t - 6.0, 6.0 - 12.0 * t, 6.0 * t - 4.0, 6.0 * t - 2.0];
        let given = |c: usize| {
            let [from, to] = self.slopes[k];
            [self.points[k][c], self.points[k + 1][c], width * from[c], width * to[c]]
        };
        let given = [given(0), given(1)];
        let sum = |weights: [f64; 4]| {
            given.map(|given| (0..4).map(|i| weights[i] * given[i]).sum::<f64>())
        };
        CurvePoint {
            place: sum(value),
            tangent: sum(slope).map(|slope| slope / width),
            bend: sum(bend).map(|bend| bend / (width * width)),
        }
    }

    /// The same turned about the origin of its coordinates by an angle (in rad, from y towards z),
    /// then moved by `way` (in m).
    #[must_use]
    pub fn placed(&self, angle: f64, way: [f64; 2]) -> Self {
        let (sin, cos) = angle.sin_cos();
        let turned = |[y, z]: [f64; 2]| [cos * y - sin * z, sin * y + cos * z];
        let moved = |point: &[f64; 2]| {
            let [y, z] = turned(*point);
            [y + way[0], z + way[1]]
        };
        Self {
            length: self.length.clone(),
            points: self.points.iter().map(moved).collect(),
            slopes: self.slopes.iter().map(|ends| ends.map(turned)).collect(),
            smoothing: self.smoothing,
        }
    }

    /// A curve over the same arc lengths between two of them (in m), with what `at` says of an arc
    /// length as its value and slope.
    pub(super) fn mapped(&self, ends: [f64; 2], at: impl Fn(f64) -> [[f64; 2]; 2]) -> Self {
        let inside = self.length.iter().copied().filter(|s| ends[0] < *s && *s < ends[1]);
        let length: Vec<f64> = std::iter::once(ends[0]).chain(inside).chain([ends[1]]).collect();
        let (points, slopes): (Vec<_>, Vec<_>) =
            length.iter().map(|s| at(*s)).map(|[value, slope]| (value, slope)).unzip();
        let slopes = slopes.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        Self { length, points, slopes, smoothing: self.smoothing }
    }

    /// Arc lengths at the points, in m, by Gauss's rule with four points in each interval.
    fn arc_lengths(&self) -> Vec<f64> {
        let mut total = 0.0;
        let mut lengths = vec![0.0];
        for ends in self.length.windows(2) {
            let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
            for (node, weight) in quadrature::FOUR {
                let [y, z] = self.at(middle + half * node).tangent;
                total += half * weight * y.hypot(z);
            }
            lengths.push(total);
        }
        lengths
    }
}

/// The points in the order of growing y, without those too close to the one before.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let mut keep = |point: &[f64; 2]| {
        let is_apart = |last: &[f64; 2]| distance(last, point) >= LEAST_SPACING;
        if kept.last().is_none_or(is_apart) {
            kept.push(*point);
        }
    };
    let is_reversed = matches!((points.first(), points.last()), (Some(p), Some(q)) if p[0] > q[0]);
    if is_reversed {
        points.iter().rev().for_each(&mut keep);
    } else {
        points.iter().for_each(&mut keep);
    }
    kept
}

fn distance(p: &[f64; 2], q: &[f64; 2]) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}

fn chords(points: &[[f64; 2]]) -> Vec<f64> {
    let mut total = 0.0;
    let ends = points.windows(2).map(|pair| {
        total += distance(&pair[0], &pair[1]);
        total
    });
    std::iter::once(0.0).chain(ends).collect()
}

/// Indices at which smooth pieces begin and end: the first and last point, and kinks. The direction
/// on both sides of a point is that of the chord to the first point that is `reach` away (in m), or
/// to the next one, so noise over shorter distances turns nothing.
fn kinks(points: &[[f64; 2]], reach: f64) -> Vec<usize> {
    let ends = |k: usize| {
        let is_away = |j: &usize| distance(&points[*j], &points[k]) >= reach;
        Some([(0..k).rev().find(is_away)?, (k + 1..points.len()).find(is_away)?])
    };
    let chord = |from: usize, to: usize| [0, 1].map(|c| points[to][c] - points[from][c]);
    let turn = |k: usize| {
        let [before, after] = ends(k)?;
        let [p, q] = [chord(before, k), chord(k, after)];
        Some((p[0] * q[1] - p[1] * q[0]).atan2(p[0] * q[0] + p[1] * q[1]).abs())
    };
    let turns: Vec<f64> = (0..points.len()).map(|k| turn(k).unwrap_or(0.0)).collect();
    let is_kink = |k: &usize| {
        let Some([before, after]) = ends(*k).filter(|_| turns[*k] >= KINK) else { return false };
        let beside = turns[before].max(turns[after]);
        let is_largest = |j: usize| turns[j] < turns[*k] || j >= *k && turns[j] == turns[*k];
        beside <= KINK_RATIO * turns[*k] && (before..=after).all(is_largest)
    };
    let inside = (0..points.len()).filter(is_kink);
    std::iter::once(0).chain(inside).chain([points.len() - 1]).collect()
}

/// The points on smoothing splines between kinks.
fn smoothed(
    length: &[f64],
    mut points: Vec<[f64; 2]>,
    kinks: &[usize],
    smoothing: f64,
) -> Vec<[f64; 2]> {
    if smoothing == 0.0 {
        return points;
    }
    for ends in kinks.windows(2) {
        let piece = ends[0]..=ends[1];
        for c in 0..2 {
            let values: Vec<f64> = points[piece.clone()].iter().map(|point| point[c]).collect();
            let smooth = spline::smoothed(&length[piece.clone()], &values, smoothing);
            for (point, value) in points[piece.clone()].iter_mut().zip(smooth) {
                point[c] = value;
            }
        }
    }
    points
}

/// Slopes at both ends of all intervals.
fn fitted(length: &[f64], points: &[[f64; 2]], kinks: &[usize]) -> Vec<[[f64; 2]; 2]> {
    let mut slopes = Vec::with_capacity(points.len());
    for ends in kinks.windows(2) {
        let piece = ends[0]..=ends[1];
        let [y, z] = [0, 1].map(|c| {
            let values: Vec<f64> = points[piece.clone()].iter().map(|point| point[c]).collect();
            spline::slopes(&length[piece.clone()], &values)
        });
        let at: Vec<[f64; 2]> = y.into_iter().zip(z).map(|(y, z)| [y, z]).collect();
        slopes.extend(at.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arc of 13 mm with noise of 10 µm that a corner of 45° ends: with smoothing that corner is
    /// the only kink, however long it is and whichever points are taken.
    #[test]
    fn noise_of_dense_points_makes_no_kinks() {
        let mut state = 12_345_u64;
        let mut noise = || {
            // Twelve uniform numbers (Knuth's generator) are nearly a normal one.
            let mut uniform = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 11) as f64 / (1_u64 << 53) as f64
            };
            1e-5 * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0)
        };
        let (radius, end) = (13e-3_f64, 15e-3);
        let at = |s: f64| {
            let (sin, cos) = (s.min(end) / radius - 1.0).sin_cos();
            let beyond = (s - end).max(0.0);
            let (down, along) = (1.0 - end / radius - std::f64::consts::FRAC_PI_4).sin_cos();
            [radius * sin + beyond * along, radius * cos + beyond * down]
        };
        let dense: Vec<[f64; 2]> = (0..1000)
            .map(|k| at(3e-5 * f64::from(k)))
            .map(|[y, z]| [y + noise(), z + noise()])
            .collect();
        for every in [1, 2, 5, 10] {
            let points: Vec<[f64; 2]> = dense.iter().step_by(every).copied().collect();
            for smoothing in [2e-3, 3e-3, 5e-3, 8e-3] {
                let found = kinks(&points, REACH * smoothing);
                let [first, corner, last] = found[..] else {
                    panic!("{every} {smoothing}: {found:?}")
                };
                assert_eq!([first, last], [0, points.len() - 1]);
                let off = (3e-5 * (every * corner) as f64 - end).abs();
                assert!(off < 0.1 * smoothing, "{every} {smoothing}: {off}");
            }
        }
    }
}
