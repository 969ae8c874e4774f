//! The maximum of a creep curve.

use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::solution::{Resultant, Status};

use super::{Path, Point, Solver};

/// Where the tangential force |F| is largest.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Whether |F| does not fall behind it: everything slides. The abscissa is the first of the curve
    /// from which on |F| stays within [`PLATEAU`] of its largest value; forces are those of that value.
    pub is_saturated: bool,
}

/// Part of the largest force within which it counts as reached, dimensionless.
pub const PLATEAU: f64 = 1e-3;

/// A force that still rises comes within [`PLATEAU`] of its largest value at the very end; one that is
/// saturated does so before this part of the last creepage.
const LATEST_SATURATION: f64 = 0.8;

/// A fall by less than this many tolerances of the solutions is none.
const NOISE: f64 = 10.0;

/// Most solutions to find one maximum.
const MAX_SOLUTIONS: usize = 8;

/// The creepage of a maximum is found to this part of it: the force is, then, to its square.
const PRECISION: f64 = 1e-3;

/// The maxima on both sides of zero, below first; each side has its points from zero outwards.
pub(super) fn of_sides(
    solver: &mut Solver,
    [above, below]: &[Vec<Point>; 2],
) -> Result<Vec<Maximum>, Error> {
    let mut maxima = Vec::new();
    for (side, other) in [(below, above), (above, below)] {
        let mut side = side.clone();
        // Between the two sides, zero itself is the inner end.
        if let (Some(first), Some(across)) = (side.first(), other.first()) {
            if first.abscissa != 0.0 {
                let zero = if across.abscissa == 0.0 { *across } else { solver.point(0.0)? };
                side.insert(0, zero);
            }
        }
        side.retain(|point| point.status == Status::Converged);
        maxima.extend(of_side(solver, &side)?);
    }
    Ok(maxima)
}

/// The maximum of points from zero outwards; `None` where it lies at an end.
fn of_side(solver: &mut Solver, side: &[Point]) -> Result<Option<Maximum>, Error> {
    let force = |point: &Point| point.traction_coefficient;
    let Some(top) = (0..side.len()).max_by(|i, k| force(&side[*i]).total_cmp(&force(&side[*k])))
    else {
        return Ok(None);
    };
    let noise = NOISE * solver.options.tolerance * solver.problem.friction.cold_coefficient();
    let is_lower = |point: &&Point| force(point) < force(&side[top]) - noise;
    let before = side[..top].iter().rev().find(is_lower);
    let after = side[top..].iter().find(is_lower);
    match (before, after) {
        (_, None) => Ok(saturated(solver.path, side, top)),
        (None, Some(_)) => Ok(None),
        (Some(before), Some(after)) => highest(solver, [*before, side[top], *after]).map(Some),
    }
}

/// The beginning of a plateau that reaches to the end, if there is one.
fn saturated(path: &Path, side: &[Point], top: usize) -> Option<Maximum> {
    let highest = &side[top];
    let level = highest.traction_coefficient * (1.0 - PLATEAU);
    let last = side.last()?;
    let begin = side.iter().rposition(|p| p.traction_coefficient < level).map_or(0, |k| k + 1);
    let first = side.get(begin)?;
    let abscissa = match side[..begin].last() {
        None => first.abscissa,
        Some(below) => {
            let rise = first.traction_coefficient - below.traction_coefficient;
            let share = (level - below.traction_coefficient) / rise;
            below.abscissa + share * (first.abscissa - below.abscissa)
        }
    };
    let is_saturated = highest.traction_coefficient > 0.0
        && abscissa.abs() <= LATEST_SATURATION * last.abscissa.abs();
    is_saturated.then(|| Maximum {
        abscissa,
        kinematics: path.at(abscissa).at_speed(highest.kinematics.speed),
        is_saturated,
        ..Maximum::at(highest)
    })
}

/// The maximum between two lower points, by parabolas through three points of which the middle one is
/// the highest, with a solution at the top of each.
fn highest(solver: &mut Solver, mut three: [Point; 3]) -> Result<Maximum, Error> {
    for _ in 0..MAX_SOLUTIONS {
        let [before, middle, after] = three;
        let top = top_of_parabola(&three.map(|p| [p.abscissa, p.traction_coefficient]));
        if (top - middle.abscissa).abs() <= PRECISION * middle.abscissa.abs() {
            break;
        }
        let next = solver.point(top)?;
        if next.status == Status::NotConverged {
            break;
        }
        let is_before = (top < middle.abscissa) == (before.abscissa < middle.abscissa);
        three = match (is_before, next.traction_coefficient > middle.traction_coefficient) {
            (true, true) => [before, next, middle],
            (true, false) => [next, middle, after],
            (false, true) => [middle, next, after],
            (false, false) => [before, middle, next],
        };
    }
    Ok(Maximum::at(&three[1]))
}

/// Where the parabola through three points has its top, the middle one being the highest.
fn top_of_parabola(&[[x0, y0], [x1, y1], [x2, y2]]: &[[f64; 2]; 3]) -> f64 {
    let [left, right] = [(y1 - y0) * (x2 - x1), (y1 - y2) * (x1 - x0)];
    let top = 0.5 * (left * (x1 + x2) + right * (x0 + x1)) / (left + right);
    // Points that coincide have none.
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
