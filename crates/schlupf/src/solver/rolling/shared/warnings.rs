//! Warnings of the full solver for whoever uses the results.

use crate::normal::NormalSummary;
use crate::problem::{Options, Problem};
use crate::reporting::Warning;
use crate::solver::summary::snapshot::{Snapshot, View};
use crate::solver::summary::{self};

use super::contact::DiscreteContact;

/// Largest admissible ratio of the displacement at the outer edge of the surroundings to the
/// largest one.
const LARGEST_EDGE_DISPLACEMENT: f64 = 0.01;

/// Largest fraction of the friction power that the bristles may return without a warning.
const LARGEST_RETURNED_POWER: f64 = 0.01;

/// What the solver neglects whatever the motion is.
pub(crate) fn of_any_motion(problem: &Problem, normal: &NormalSummary) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = problem.interface.elasticity.caveat().into_iter().collect();
    let coupling = problem.interface.elasticity.pressure_coupling();
    warnings.extend(
        coupling.filter(|coupling| coupling.is_mutual && coupling.constant != 0.0).map(
            |coupling| Warning::UnchangedPressure {
                constant: coupling.constant,
                in_derivatives: false,
            },
        ),
    );
    warnings.extend(problem.interface.elasticity.caveat_of_parts(normal.parts));
    warnings.extend(problem.normal.caveat());
    warnings.extend(problem.interface.beyond_elastic(normal.peak_pressure));
    warnings
}

/// All warnings of the solution.
pub(crate) fn warnings(
    problem: &Problem,
    options: &Options,
    contact: &mut DiscreteContact,
    now: &Snapshot,
) -> Vec<Warning> {
    let mut warnings = of_any_motion(problem, &contact.normal);
    let view = View { normal: &contact.normal, patch: &contact.patch, now };
    warnings.extend(summary::caveats::of_temperatures(problem, view));
    let edge = contact.edge_displacement(&now.traction);
    if edge > LARGEST_EDGE_DISPLACEMENT {
        warnings.push(Warning::SmallMargin { edge });
    }
    let force = summary::force(&contact.patch, now);
    let limit = problem.interface.friction.cold_coefficient() * contact.normal.load;
    let noise = options.tolerance * limit * now.kinematics.speed;
    warnings.extend(summary::power(&contact.patch, now, &force).and_then(|power| {
        let (returned, friction) = (power.returned, power.friction);
        (returned > (LARGEST_RETURNED_POWER * friction.abs()).max(noise))
            .then_some(Warning::ReturnedPower { returned, friction })
    }));
    warnings
}
