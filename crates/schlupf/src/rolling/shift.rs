//! Two bodies at rest, pressed together and shifted tangentially: Cattaneo's and Mindlin's problem,
//! for any patch, elasticity and contact law.

use crate::error::{Error, require_finite};
use crate::history::History;
use crate::problem::{Options, Problem};
use crate::quantity::Quantity;
use crate::solution::Solution;

use super::marching::march;

/// Presses the two bodies of a problem together and shifts the wheel over the rail by `shift` (along and
/// across rolling, in m), in one go: a history with nothing but a shift.
///
/// The bodies do not roll: creepages and spin of the problem play no part, and those of the solution
/// are zero, as is its speed. A shift has no duration either, so there is no slip velocity, no friction
/// power and no heat; friction is that of the temperature with which the bodies meet. How far each
/// element has slid, in m, is in the solution's state, from which marching can go on.
///
/// # Errors
/// A problem with a history or an initial state, a shift that is not finite, and whatever
/// [`Problem::check`] and [`Options::check`] refuse.
pub fn shift(problem: &Problem, shift: [f64; 2], options: &Options) -> Result<Solution, Error> {
    refuse_a_past(problem)?;
    require_finite(Quantity::ShiftX, shift[0])?;
    require_finite(Quantity::ShiftY, shift[1])?;
    let history = History { shift: Some(shift), ..History::default() };
    march(&Problem { history: Some(history), ..problem.clone() }, options, &mut |_| ())
}

fn refuse_a_past(problem: &Problem) -> Result<(), Error> {
    let what = "a shift starts from rest, not from";
    if problem.history.is_some() {
        return Err(Error::NotSteady { quantity: Quantity::Time, what });
    }
    if problem.initial_state.is_some() {
        return Err(Error::NotSteady { quantity: Quantity::InitialState, what });
    }
    Ok(())
}
