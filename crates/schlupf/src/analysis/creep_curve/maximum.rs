//! The maximum of a creep curve.

use crate::bodies::Kinematics;
use crate::numerics::root::GOLDEN;
use crate::reporting::Error;
use crate::solution::{Resultant, Status};

use super::{Point, Points};

/// Where the tangential force |F| is largest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Maximum {
    /// Abscissa of the curve; dimensionless, or in 1/m for spin.
    pub abscissa: f64,
    /// Speed and creepages there.
    pub kinematics: Kinematics,
    /// Forces and moment on the wheel.
    pub force: Resultant,
    /// F/(μ0 N), and Mz/(μ0 N √(ab)); dimensionless.
    pub normalised: Resultant,
    /// |F|/N, dimensionless.
    pub traction_coefficient: f64,
    /// Whether |F| does not fall beyond it: full sliding. The abscissa is the first of the curve
    /// from which on |F| stays within [`PLATEAU`] of its largest value; the forces are those at the
    /// largest value.
    #[cfg_attr(feature = "serde", serde(rename = "saturated"))]
    pub is_saturated: bool,
}

/// Relative distance to the largest force within which it counts as reached, dimensionless.
pub const PLATEAU: f64 = 1e-3;

/// A force that still rises comes within [`PLATEAU`] of its largest value only at the very end; a
/// saturated one does so before this fraction of the last creepage.
const LATEST_SATURATION: f64 = 0.8;

/// Relative accuracy of the creepage at which saturation begins.
const SATURATION_PRECISION: f64 = 0.01;

/// A decrease by less than this many tolerances of the solutions is noise.
const NOISE: f64 = 10.0;

/// Maximum number of solutions to find one maximum.
const MAX_SOLUTIONS: usize = 60;

/// Relative accuracy of the creepage of a maximum; the force is far more accurate, because it is
/// flat there.
const PRECISION: f64 = 1e-3;

/// Position at which the slope at an end is probed, as a fraction of the distance to the next
/// point.
const PROBE: f64 = 0.01;

/// The maxima on both sides of zero, lower side first; each side has its points from zero outwards.
pub(super) fn of_sides(
    solver: &mut Points,
    [above, below]: &[Vec<Point>; 2],
) -> Result<Vec<Maximum>, Error> {
    let mut maxima = Vec::new();
    for (side, other) in [(below, above), (above, below)] {
        let mut points = side.clone();
        // Between the two sides, zero itself is the inner end.
        if let (Some(first), Some(across)) = (side.first(), other.first())
            && first.abscissa != 0.0
        {
            let zero = if across.abscissa == 0.0 { *across } else { solver.point(0.0)? };
            points.insert(0, zero);
        }
        let (points, failed) =
            points.into_iter().partition(|point| point.status == Status::Converged);
        let noise = NOISE
            * solver.solver.options().tolerance
            * solver.problem.interface.friction.cold_coefficient();
        maxima.extend(Side { solver, points, failed, noise }.maximum()?);
    }
    Ok(maxima)
}

fn force(point: &Point) -> f64 {
    point.traction_coefficient
}

/// The points on one side of zero, from there outwards.
struct Side<'a, 'b> {
    solver: &'a mut Points<'b>,
    /// Points that converged.
    points: Vec<Point>,
    /// Points that did not: a maximum near one of them may be missed.
    failed: Vec<Point>,
    /// Differences of |F|/N below this are noise.
    noise: f64,
}

impl Side<'_, '_> {
    /// `None` if |F| rises up to the outer end or falls from the inner end.
    fn maximum(&mut self) -> Result<Option<Maximum>, Error> {
        let by_force =
            |i: &usize, k: &usize| force(&self.points[*i]).total_cmp(&force(&self.points[*k]));
        let Some(top) = (0..self.points.len()).max_by(by_force) else { return Ok(None) };
        let highest = self.points[top];
        let is_lower = |point: &&Point| force(point) < force(&highest) - self.noise;
        let before = self.points[..top].iter().rev().find(is_lower).copied();
        let after = self.points[top..].iter().find(is_lower).copied();
        let three = match (before, after) {
            (Some(before), Some(after)) => Some([before, highest, after]),
            (None, None) => return self.saturation(&highest),
            (Some(before), None) => match self.probe(&highest, &before)? {
                None => return self.saturation(&highest),
                three => three,
            },
            (None, Some(after)) => self.probe(&highest, &after)?,
        };
        match three {
            Some(three) if self.is_known(three[0].abscissa, three[2].abscissa, &highest) => {
                self.highest(three)
            }
            _ => Ok(None),
        }
    }

    /// Whether no point failed between two abscissae where |F| may have exceeded the highest value.
    fn is_known(&self, from: f64, to: f64, highest: &Point) -> bool {
        self.failed.iter().all(|point| {
            let is_outside = point.abscissa < from.min(to) || point.abscissa > from.max(to);
            is_outside && force(point) <= force(highest)
        })
    }

    /// Three points with the highest in the middle, if |F| rises from the highest point, an end of
    /// the curve, towards the next one: then there is a maximum between them.
    fn probe(&mut self, end: &Point, next: &Point) -> Result<Option<[Point; 3]>, Error> {
        let step = (next.abscissa - end.abscissa).abs().min(end.abscissa.abs()) * PROBE;
        let towards = (next.abscissa - end.abscissa).signum();
        let probe = self.solver.point(end.abscissa + towards * step)?;
        let rises = force(&probe) > force(end) + self.noise;
        Ok((rises && probe.status == Status::Converged).then_some([*end, probe, *next]))
    }

    /// The beginning of a plateau that extends to the end, if there is one.
    fn saturation(&mut self, highest: &Point) -> Result<Option<Maximum>, Error> {
        let level = force(highest) * (1.0 - PLATEAU);
        let begin = self.points.iter().rposition(|point| force(point) < level);
        let below = begin.map(|k| self.points[k].abscissa);
        let mut reached = self.points[begin.map_or(0, |k| k + 1)].abscissa;
        let end = self.points[self.points.len() - 1].abscissa;
        let is_known =
            self.is_known(below.unwrap_or(reached), f64::INFINITY.copysign(end), highest);
        if !is_known || force(highest) <= self.noise {
            return Ok(None);
        }
        let latest = LATEST_SATURATION * end;
        if reached.abs() > latest.abs() {
            let is_between = below.is_some_and(|below| below.abs() < latest.abs());
            if !is_between || !self.reaches(latest, level)? {
                return Ok(None);
            }
            reached = latest;
        }
        // Without a point below it, the whole curve is saturated.
        let mut lower = below.unwrap_or(reached);
        while (reached - lower).abs() > SATURATION_PRECISION * reached.abs() {
            let middle = 0.5 * (lower + reached);
            if self.reaches(middle, level)? {
                reached = middle;
            } else {
                lower = middle;
            }
        }
        let reached_at = self.solver.path.at(reached);
        Ok(Some(Maximum {
            abscissa: reached,
            kinematics: reached_at.in_place_of(&highest.kinematics),
            is_saturated: true,
            ..Maximum::at(highest)
        }))
    }

    fn reaches(&mut self, abscissa: f64, level: f64) -> Result<bool, Error> {
        let point = self.solver.point(abscissa)?;
        Ok(force(&point) >= level && point.status == Status::Converged)
    }

    /// The maximum within three points of which the middle one is the highest (Brent 1973): at the
    /// vertex of the parabola through them, or, where that narrows the range too slowly, in the
    /// larger part.
    fn highest(&mut self, mut three: [Point; 3]) -> Result<Option<Maximum>, Error> {
        let width = |three: &[Point; 3]| (three[2].abscissa - three[0].abscissa).abs();
        let mut narrowed = true;
        for _ in 0..MAX_SOLUTIONS {
            let middle = three[1];
            let precision = PRECISION * middle.abscissa.abs();
            let before = width(&three);
            if before <= 2.0 * precision {
                break;
            }
            let next = self.solver.point(next_abscissa(&three, narrowed, precision))?;
            if next.status == Status::NotConverged {
                return Ok(None);
            }
            three = with(&three, &next);
            narrowed = width(&three) < 0.5 * before;
        }
        Ok(Some(Maximum::at(&three[1])))
    }
}

/// The next abscissa: on the side of the vertex of the parabola, at least half the precision away
/// from the middle point, so that the range closes on both sides of it.
fn next_abscissa(three: &[Point; 3], narrowed: bool, precision: f64) -> f64 {
    let [before, middle, after] = three.map(|point| point.abscissa);
    let larger = if (before - middle).abs() > (after - middle).abs() { before } else { after };
    if !narrowed {
        return middle + (1.0 - GOLDEN) * (larger - middle);
    }
    let top = top_of_parabola(&three.map(|point| [point.abscissa, force(&point)]));
    let least = 0.5 * precision;
    if (top - middle).abs() >= least {
        return top;
    }
    middle + least.min(0.5 * (larger - middle).abs()) * (larger - middle).signum()
}

/// Three points around the highest of these four.
fn with([before, middle, after]: &[Point; 3], next: &Point) -> [Point; 3] {
    let is_before = (next.abscissa < middle.abscissa) == (before.abscissa < middle.abscissa);
    let three = match (is_before, force(next) > force(middle)) {
        (true, true) => [before, next, middle],
        (true, false) => [next, middle, after],
        (false, true) => [middle, next, after],
        (false, false) => [before, middle, next],
    };
    three.map(|point| *point)
}

/// The vertex of the parabola through three points, the middle one being the highest.
fn top_of_parabola(&[[x0, y0], [x1, y1], [x2, y2]]: &[[f64; 2]; 3]) -> f64 {
    let [left, right] = [(y1 - y0) * (x2 - x1), (y1 - y2) * (x1 - x0)];
    let top = 0.5 * (left * (x1 + x2) + right * (x0 + x1)) / (left + right);
    // Coincident points have none.
    let [low, high] = [x0.min(x2), x0.max(x2)];
    if top > low && top < high { top } else { x1 }
}

impl Maximum {
    fn at(point: &Point) -> Self {
        Self {
            abscissa: point.abscissa,
            kinematics: point.kinematics,
            force: point.force,
            normalised: point.normalised,
            traction_coefficient: point.traction_coefficient,
            is_saturated: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn a_parabola_has_its_top_where_it_is() {
        let parabola = |x: f64| [x, 3.0 - 2.0 * (x - 0.3).powi(2)];
        for points in [[0.0, 0.2, 1.0], [1.0, 0.5, -0.5], [0.0, 0.3, 0.4]] {
            let top = top_of_parabola(&points.map(parabola));
            assert_relative_eq!(top, 0.3, max_relative = 1e-14);
        }
        assert_eq!(top_of_parabola(&[[0.1, 1.0]; 3]), 0.1);
    }
}
