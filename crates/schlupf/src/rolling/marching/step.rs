//! The equilibrium at the end of a time step, or after a shift, with whatever contact law.

use crate::equilibrium::{Limits, Newton, Outcome};
use crate::error::Error;
use crate::progress::Watch;
use crate::rolling::shared::contact::DiscreteContact;

use super::moved::Moved;
use super::step_response::{Prescribed, StepResponse};
use super::stick_slip_step::{StickSlip, StickSlipStep, Track};

/// The data of an equilibrium.
pub(super) struct Step<'a> {
    pub contact: &'a mut DiscreteContact,
    pub stick_slip: &'a mut StickSlip,
    /// μ pₙ of each cell, in Pa.
    pub bound: &'a [f64],
    pub prescribed: Prescribed,
    /// History of the material of each cell.
    pub tracks: Vec<Track>,
    /// Measures residuals relative to a traction (‖p‖₂ in Pa) if that of this step is smaller: a
    /// decaying traction need not be known more accurately than it was.
    pub largest: f64,
}

/// Factors by which γ is reduced, one after another, where Newton's method goes in circles between
/// stick and slip: with a smaller γ fewer cells change from one to the other in a step.
const SOFTER: [f64; 3] = [1.0, 0.25, 0.25];

impl Step<'_> {
    /// Solves for the traction on the rail p (in Pa), starting from the given one.
    pub fn solve(
        self,
        newton: &mut Newton,
        p: &mut [f64],
        limits: &Limits,
        watch: Watch,
    ) -> Result<(Outcome, Vec<Moved>), Error> {
        let Self { contact, stick_slip, bound, prescribed, tracks, largest } = self;
        let response = StepResponse::new(contact, &prescribed);
        stick_slip.admit(p, bound);
        let mut step = StickSlipStep::new(response, stick_slip, bound, tracks, largest);
        let mut whole = Outcome::default();
        for softer in SOFTER {
            step.soften(softer);
            let solved = newton.solve(&mut step, p, limits, watch)?;
            whole = Outcome {
                iterations: whole.iterations + solved.outcome.iterations,
                products: whole.products + solved.outcome.products,
                ..solved.outcome
            };
            if whole.converged {
                break;
            }
        }
        let moved = step.moved(p, newton.response());
        Ok((whole, moved))
    }
}
