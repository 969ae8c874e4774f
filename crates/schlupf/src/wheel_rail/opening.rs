//! How far the tractions of a contact move its surfaces apart.

use super::pressed::Pressed;
use super::side::Side;
use crate::normal::profile::UndeformedDistance;
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solution::Solution;
use crate::solver::unlike_bodies::opening_under;

/// The opening of a contact by its tractions, seen from the left.
#[derive(Debug)]
pub(super) struct Opening {
    /// Over the contact frame of the tractions, in m.
    distance: UndeformedDistance,
    /// Origin of that frame in the contact's, in m.
    origin: [f64; 2],
    side: Side,
}

impl Opening {
    /// That of a contact's solution; `None` where tractions leave the pressure as it is.
    pub fn new(
        (pressed, problem, solution): (&Pressed, &Problem, &Solution),
        side: Side,
    ) -> Result<Option<Self>, Error> {
        let coupling = problem.interface.elasticity.pressure_coupling();
        let Some(coupling) = coupling.filter(|coupling| coupling.is_mutual) else {
            return Ok(None);
        };
        if solution.fields.is_empty() {
            return Ok(None);
        }
        let origin = solution.normal.origin.unwrap_or_default();
        let [x, mut y] = in_frame(side, origin, [&pressed.x, &pressed.s]);
        y.sort_unstable_by(f64::total_cmp);
        let distance = opening_under(&solution.fields, &coupling, [&x, &y])?;
        Ok(Some(Self { distance, origin, side }))
    }

    /// At the positions `x` × `s` (in m) relative to the contact's origin, rows along x, in m;
    /// beyond what is known as at its edge.
    pub fn sample(&self, x: &[f64], s: &[f64]) -> Vec<f64> {
        let bounds = self.distance.bounds();
        let mut lines = in_frame(self.side, self.origin, [x, s]);
        for (line, [from, to]) in lines.iter_mut().zip(bounds) {
            for at in line {
                *at = at.clamp(from, to);
            }
        }
        self.distance.sample(&lines[0], &lines[1])
    }
}

/// Positions x and s (in m) in the frame of the tractions.
fn in_frame(side: Side, [x, y]: [f64; 2], [along, across]: [&[f64]; 2]) -> [Vec<f64>; 2] {
    let sign = side.outwards();
    [along.iter().map(|at| at - x).collect(), across.iter().map(|s| sign * s - y).collect()]
}
