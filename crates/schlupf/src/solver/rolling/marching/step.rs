//! The equilibrium at the end of a time step, or of a shift, with whatever contact law.

use crate::bodies::Kinematics;
use crate::reporting::{Error, Watch};
use crate::solver::equilibrium::{Limits, Newton, Outcome};
use crate::solver::prescribed::{self, ForceGoal, MovedEquilibrium as _};
use crate::solver::rolling::shared::contact::DiscreteContact;

use super::moved::Moved;
use super::step_response::{Known, StepResponse};
use super::time_step::{TimeStepEquilibrium, TimeStepLaw, Track};

/// The data of an equilibrium.
pub(super) struct Step<'a> {
    pub contact: &'a mut DiscreteContact,
    pub law: &'a mut TimeStepLaw,
    /// μ pₙ of each cell, in Pa.
    pub bound: &'a [f64],
    pub known: &'a Known,
    /// History of the material of each cell.
    pub tracks: Vec<Track>,
    /// Measures residuals relative to a traction (‖p‖₂ in Pa) if that of this step is smaller: a
    /// decaying traction need not be known more accurately than it was.
    pub largest: f64,
}

impl Step<'_> {
    /// Solves for the traction on the rail p (in Pa) and the motion over the step, at the centre of
    /// the patch, with which it ends at the forces of a goal, starting from those given.
    pub fn solve(
        self,
        newton: &mut Newton,
        p: &mut Vec<f64>,
        (goal, motion): (&ForceGoal, &mut Kinematics),
        (limits, watch): (&Limits, Watch),
    ) -> Result<(Outcome, Vec<Moved>), Error> {
        let Self { contact, law, bound, known, tracks, largest } = self;
        let response = StepResponse::new(contact, known);
        law.admit(p, bound);
        let mut step = TimeStepEquilibrium::new(response, law, bound, tracks, largest);
        step.set_motion(motion);
        if !step.is_coupled() {
            step.solve_uncoupled(p);
        }
        let outcome = prescribed::solve(newton, &mut step, (goal, motion), p, (limits, watch))?;
        let moved = step.moved(p, newton.response());
        Ok((outcome, moved))
    }
}
