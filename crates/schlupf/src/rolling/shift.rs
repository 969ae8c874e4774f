//! Two bodies at rest, pressed together and shifted tangentially: Cattaneo's and Mindlin's problem,
//! for any patch, elasticity and contact law.
//!
//! Nothing is carried along, so there is one equilibrium: every cell slides by D − A p, the shift less
//! what the bodies yield, with the same D in all of them and no history.

use crate::equilibrium::{Limits, Newton, Outcome};
use crate::error::{Error, require_finite};
use crate::grid::Grid;
use crate::interface::contact_law::Slide;
use crate::kinematics::Kinematics;
use crate::method::Method;
use crate::patch::Patch;
use crate::problem::{Options, Problem};
use crate::solution::{Instant, Solution, Status, Work};
use crate::state::{Element, State};
use crate::summary::{self, snapshot::Snapshot};

use super::contact::DiscreteContact;
use super::time_step::TimeStep;
use super::warnings;

/// Presses the two bodies of a problem together and shifts the wheel over the rail by `shift` (along and
/// across rolling, in m), in one go.
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
    for component in shift {
        require_finite("shift", component, "m")?;
    }
    let problem = &without_creepage(problem);
    problem.check()?;
    options.check()?;
    let normal = problem.normal.normal_contact(None)?;
    let grid = Grid::across(&normal.extent(), options.cells_x, options.cells_y);
    let mut contact = DiscreteContact::new(problem, &normal, grid)?;
    let cells = contact.patch.len();
    let mut now = pressed_together(problem, &contact.patch);
    let bound = now.bound(&contact.patch);
    let prescribed = shift.repeat(cells);
    let slides = vec![Slide::default(); cells];
    let limits = Limits {
        tolerance: options.tolerance,
        max_iterations: options.max_iterations,
        is_monotone: false,
    };
    let law = problem.contact_law.as_ref();
    let mut step = TimeStep::new(&mut contact, law, &bound, &prescribed, slides);
    let outcome = step.solve(&mut Newton::default(), &mut now.traction, &limits);
    let (slides, responses) = (step.slides, step.responses);
    contact.product(&now.traction, &mut now.displacement);
    let element = |k: usize| Element {
        index: contact.patch.cells[k].index,
        traction: now.traction_at(k),
        saturation: responses[k].traction,
        sliding: slides[k].increment,
        ..Element::default()
    };
    let elements = (0..cells).map(element).collect();
    let account = account(problem, options, (&mut contact, &now), (outcome, elements));
    Ok(summary::solution(problem, options, (&contact.normal, &contact.patch, &now), account))
}

fn refuse_a_past(problem: &Problem) -> Result<(), Error> {
    let refuse = |quantity, what| {
        let reason = format!("a shift starts from rest, but the problem has {what}");
        Err(Error::Contradiction { quantity, reason })
    };
    if problem.history.is_some() {
        return refuse("history", "a history");
    }
    if problem.initial_state.is_some() {
        return refuse("solver.initial_state", "an initial state");
    }
    Ok(())
}

/// The problem with both bodies at the same speed: whichever it is, they meet as bodies at rest do.
fn without_creepage(problem: &Problem) -> Problem {
    let kinematics =
        Kinematics { creepage_x: 0.0, creepage_y: 0.0, spin: 0.0, ..problem.kinematics };
    Problem { kinematics, ..problem.clone() }
}

/// No traction yet, and the friction of the temperature with which the bodies meet.
fn pressed_together(problem: &Problem, patch: &Patch) -> Snapshot {
    let conduction = problem.conduction(&problem.kinematics);
    let at_rest = Kinematics { speed: 0.0, ..problem.kinematics };
    let mut now = Snapshot::blank(at_rest, conduction, patch.len());
    for (friction, cell) in now.friction.iter_mut().zip(&patch.cells) {
        *friction = problem.entry_friction(&conduction, cell.y).coefficient;
    }
    now
}

fn account(
    problem: &Problem,
    options: &Options,
    (contact, now): (&mut DiscreteContact, &Snapshot),
    (outcome, elements): (Outcome, Vec<Element>),
) -> summary::Account {
    let mut warnings = warnings::warnings(problem, options, contact, now);
    let has_converged = outcome.residual <= options.tolerance;
    if !has_converged {
        warnings.insert(
            0,
            format!(
                "not converged: after {} Newton steps the equilibrium has a residual of {:.1e}, above \
                 the tolerance {:.1e}",
                outcome.iterations, outcome.residual, options.tolerance
            ),
        );
    }
    let instant = Instant {
        time: 0.0,
        kinematics: now.kinematics,
        load: contact.normal.load,
        force: summary::force(&contact.patch, now),
        max_rise: summary::temperature(&contact.patch, now).max_rise,
        newton_iterations: outcome.iterations,
        residual: outcome.residual,
    };
    summary::Account {
        method: Method::Full,
        status: if has_converged { Status::Converged } else { Status::NotConverged },
        residual: outcome.residual,
        history: vec![instant],
        warnings,
        sensitivity: None,
        work: Work {
            newton_iterations: outcome.iterations,
            operator_products: outcome.products as f64 + 1.0,
            outer_iterations: 1,
            steps: 0,
            cells: contact.patch.len(),
            sensitivity_products: 0,
        },
        state: State { grid: contact.patch.grid, time: 0.0, elements },
    }
}
