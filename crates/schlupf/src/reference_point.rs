//! Creepages that hold, and a moment that is taken, at another point than the middle of the patch.
//!
//! Whatever solves has the creepages at the middle of the patch, the origin of the contact frame. A
//! problem that gives them elsewhere is moved there on the way in, and its solution back on the way
//! out; both are the same rigid motion and the same tractions, so nothing else changes.

use crate::error::Error;
use crate::kinematics::{Kinematics, ReferencePoint};
use crate::normal::NormalSummary;
use crate::problem::Problem;
use crate::solution::{Instant, Resultant, Solution};
use crate::summary;

/// Where a reference point lies in the contact frame, x and y in m.
pub(crate) fn place(reference: ReferencePoint, normal: &NormalSummary) -> Result<[f64; 2], Error> {
    match (reference, normal.origin) {
        (ReferencePoint::Patch, _) => Ok([0.0; 2]),
        (ReferencePoint::File, Some([x, y])) => Ok([-x, -y]),
        (ReferencePoint::File, None) => Err(Error::NoOrigin {}),
    }
}

/// Creepages at the middle of the patch from those at a place (x and y in m).
pub(crate) fn at_patch(kinematics: &Kinematics, [x, y]: [f64; 2]) -> Kinematics {
    kinematics.at([-x, -y])
}

/// A problem with its creepages at the middle of the patch.
pub(crate) struct Moved {
    pub problem: Problem,
    /// Where its reference point lies in the contact frame, x and y in m.
    pub place: [f64; 2],
}

impl Moved {
    /// `None` where they hold there already.
    ///
    /// # Errors
    /// A reference point that the normal contact does not have, a motion that is no rolling at the middle
    /// of the patch, and whatever [`Problem::check`] refuses.
    pub fn from(problem: &Problem) -> Result<Option<Self>, Error> {
        if problem.reference == ReferencePoint::Patch {
            return Ok(None);
        }
        problem.check()?;
        let place = place(problem.reference, &problem.normal.normal_contact(None)?.summary)?;
        let way = place.map(|part| -part);
        let history = problem.history.as_ref().map(|own| own.at(way, &problem.kinematics));
        let problem = Problem {
            kinematics: problem.kinematics.at(way),
            reference: ReferencePoint::Patch,
            history,
            ..problem.clone()
        };
        let no_rolling = |error| Error::NoRollingAtPatch { place, error: Box::new(error) };
        problem.kinematics.check().map_err(no_rolling)?;
        Ok(Some(Self { problem, place }))
    }

    /// Forces with the moment about the reference point.
    pub fn resultant_back(&self, force: &Resultant) -> Resultant {
        force.about(self.place)
    }

    /// The solution of the moved problem as one of the problem itself.
    pub fn back(&self, solution: Solution) -> Solution {
        back(solution, &self.problem, self.place)
    }
}

/// A solution with the creepages at the middle of the patch as one with the origin of the file,
/// which lies at `place` (x and y in m), as its reference point.
pub(crate) fn back(solution: Solution, problem: &Problem, place: [f64; 2]) -> Solution {
    let (kinematics, force) = (solution.kinematics.at(place), solution.force.about(place));
    let instant = |instant: Instant| Instant {
        kinematics: instant.kinematics.at(place),
        force: instant.force.about(place),
        ..instant
    };
    Solution {
        reference: ReferencePoint::File,
        kinematics,
        force,
        normalised: summary::normalised(problem, &solution.normal, &force),
        t_gamma: summary::t_gamma(&kinematics, &force),
        sensitivity: solution.sensitivity.map(|sensitivity| sensitivity.at(place)),
        history: solution.history.into_iter().map(instant).collect(),
        ..solution
    }
}
