//! The equilibrium at the end of a time step, or after a shift, with whatever contact law.

use crate::reporting::{Error, Watch};
use crate::solver::equilibrium::{Limits, Newton, Outcome};
use crate::solver::rolling::shared::contact::DiscreteContact;

use super::moved::Moved;
use super::step_response::{Prescribed, StepResponse};
use super::time_step::{TimeStepEquilibrium, TimeStepLaw, Track};

/// The data of an equilibrium.
pub(super) struct Step<'a> {
    pub contact: &'a mut DiscreteContact,
    pub law: &'a mut TimeStepLaw,
    /// μ pₙ of each cell, in Pa.
    pub bound: &'a [f64],
    pub prescribed: Prescribed,
    /// History of the material of each cell.
    pub tracks: Vec<Track>,
    /// Measures residuals relative to a traction (‖p‖₂ in Pa) if that of this step is smaller: a
    /// decaying traction need not be known more accurately than it was.
    pub largest: f64,
}

impl Step<'_> {
    /// Solves for the traction on the rail p (in Pa), starting from the given one.
    pub fn solve(
        self,
        newton: &mut Newton,
        p: &mut [f64],
        limits: &Limits,
        watch: Watch,
    ) -> Result<(Outcome, Vec<Moved>), Error> {
        let Self { contact, law, bound, prescribed, tracks, largest } = self;
        let response = StepResponse::new(contact, &prescribed);
        law.admit(p, bound);
        let mut step = TimeStepEquilibrium::new(response, law, bound, tracks, largest);
        if !step.is_coupled() {
            step.solve_uncoupled(p);
        }
        let outcome = newton.solve(&mut step, p, limits, watch)?.outcome;
        let moved = step.moved(p, newton.response());
        Ok((outcome, moved))
    }
}
