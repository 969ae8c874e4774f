//! Creepages and moments at a reference point other than the centre of the patch.
//!
//! All solvers take the creepages at the centre of the patch, the origin of the contact frame. A
//! problem that gives them elsewhere is converted on the way in, and its solution is converted back
//! on the way out; both describe the same rigid motion and the same tractions, so nothing else
//! changes.
//!
//! No kernel knows about the reference point: any new entry point must go through here, too.

use crate::bodies::{Kinematics, ReferencePoint};
use crate::normal::NormalSummary;
use crate::problem::{Problem, Transient};
use crate::reporting::{Error, ForceError, Watch};
use crate::solution::{Extrapolation, Instant, Resultant, Solution};
use crate::solver::{summary, viscoelastic};

/// Position of a reference point in the contact frame, x and y in m.
pub(crate) fn place(reference: ReferencePoint, normal: &NormalSummary) -> Result<[f64; 2], Error> {
    match (reference, normal.origin) {
        (ReferencePoint::Patch, _) => Ok([0.0; 2]),
        (ReferencePoint::File, Some([x, y])) => Ok([-x, -y]),
        (ReferencePoint::File, None) => Err(Error::NoOrigin {}),
    }
}

/// A shift (in m) and turn (in rad) at another point, at `place` (in m) from the present one.
fn shift_at([x, y, turn]: [f64; 3], place: [f64; 2]) -> [f64; 3] {
    [x - turn * place[1], y + turn * place[0], turn]
}

/// A problem with its creepages at the centre of the patch, and the way back. Every solver takes
/// its problem through this.
#[derive(Debug, Clone)]
pub(crate) struct AtPatch {
    pub problem: Problem,
    reference: ReferencePoint,
    /// Position of the reference point in the contact frame, x and y in m.
    place: [f64; 2],
}

impl AtPatch {
    /// # Errors
    /// A reference point that the normal contact does not have, a motion that is not rolling at the
    /// centre of the patch, whatever [`Problem::check`] rejects, and [`Error::Stopped`].
    pub fn new(problem: &Problem, watch: Watch) -> Result<Self, Error> {
        let rolling = viscoelastic::viscoelastic_rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        problem.check()?;
        if let Some(quantity) = problem.prescribed.first() {
            return Err(ForceError::NotPossible { quantity }.into());
        }
        problem.normal.prepare(None, watch)?;
        let reference = problem.reference;
        if reference == ReferencePoint::Patch {
            return Ok(Self { problem: problem.clone(), reference, place: [0.0; 2] });
        }
        let place = place(reference, &problem.normal.normal_contact(None)?.summary)?;
        let kinematics = problem.kinematics.at(place.map(|part| -part));
        let no_rolling = |error| Error::NoRollingAtPatch { place, error: Box::new(error) };
        kinematics.check().map_err(no_rolling)?;
        let problem = Problem { kinematics, reference: ReferencePoint::Patch, ..problem.clone() };
        Ok(Self { problem, reference, place })
    }

    /// The given transient, with its problem and its history at the centre of the patch.
    pub fn transient(&self, given: &Transient) -> Transient {
        let history = match self.reference {
            ReferencePoint::Patch => given.history.clone(),
            ReferencePoint::File => {
                given.history.at(self.place.map(|part| -part), &given.problem.kinematics)
            }
        };
        let (problem, initial_state) = (self.problem.clone(), given.initial_state.clone());
        Transient { problem, history, initial_state }
    }

    /// Position of the reference point in the contact frame, x and y in m.
    pub fn place(&self) -> [f64; 2] {
        self.place
    }

    /// Switches to another motion, given at the reference point.
    pub fn set_motion(&mut self, motion: &Kinematics) {
        self.problem.kinematics = match self.reference {
            ReferencePoint::Patch => *motion,
            ReferencePoint::File => motion.at(self.place.map(|part| -part)),
        };
    }

    /// Forces with the moment about the reference point.
    pub fn resultant_back(&self, force: &Resultant) -> Resultant {
        match self.reference {
            ReferencePoint::Patch => *force,
            ReferencePoint::File => force.about(self.place),
        }
    }

    /// Converts the solution at the centre of the patch into one of the given problem.
    pub fn back(&self, solution: Solution) -> Solution {
        if self.reference == ReferencePoint::Patch {
            return solution;
        }
        let place = self.place;
        let (kinematics, force) = (solution.kinematics.at(place), solution.force.about(place));
        let instant = |instant: Instant| Instant {
            kinematics: instant.kinematics.at(place),
            force: instant.force.about(place),
            shift: instant.shift.map(|shift| shift_at(shift, place)),
            ..instant
        };
        let extrapolated = |extrapolation: Extrapolation| {
            let force = extrapolation.force.about(place);
            let normalised = summary::normalised(&self.problem, &solution.normal, &force);
            Extrapolation { force, normalised, error: extrapolation.error.about(place) }
        };
        Solution {
            extrapolation: solution.extrapolation.map(extrapolated),
            reference: self.reference,
            kinematics,
            force,
            normalised: summary::normalised(&self.problem, &solution.normal, &force),
            t_gamma: summary::t_gamma(&kinematics, &force, solution.t_gamma.rows),
            sensitivity: solution.sensitivity.map(|sensitivity| sensitivity.at(place)),
            history: solution.history.into_iter().map(instant).collect(),
            ..solution
        }
    }
}
