//! What the reader of a fast method's numbers must know.

use crate::interface::friction::FrictionState;
use crate::kalker_coefficients::is_tabulated;
use crate::method::FastMethod;
use crate::normal::{NormalSummary, Pressure};
use crate::problem::Problem;
use crate::solution::{Power, Resultant};

/// A force above the friction limit by less than this part of it is rounding.
const ROUNDING: f64 = 1e-9;

/// Whatever the reader must know; `limit` is μN, in N.
pub(super) fn of(
    problem: &Problem,
    normal: &NormalSummary,
    method: FastMethod,
    force: &Resultant,
    limit: f64,
) -> Vec<String> {
    let name = method.name();
    let mut warnings = Vec::from_iter(of_slender_patch(normal, name));
    warnings.extend(of_shape(problem, name));
    if problem.friction_memory().is_some() {
        warnings.push(format!(
            "friction.memory_distance: {name:?} knows no memory; friction follows its law at once"
        ));
    }
    if method.has_fields() {
        return warnings;
    }
    let what = if force.moment_z.is_nan() { "forces only" } else { "forces and moment only" };
    warnings.push(format!("solver.method: {name:?} gives {what}, no fields and no temperatures"));
    if method != FastMethod::KalkerLinear && depends_on_temperature(problem) {
        warnings.push(format!(
            "friction.model: {name:?} knows no temperatures, so friction is that of material as warm \
             as it enters"
        ));
    }
    let total = force.x.hypot(force.y);
    if total > limit * (1.0 + ROUNDING) {
        warnings.push(format!(
            "solver.method: the force of {name:?} is {:.3} times the friction limit μN, and not to be \
             trusted: the method does not cut it off",
            total / limit
        ));
    }
    warnings
}

/// Beyond the table of Kalker's coefficients their error is larger.
fn of_slender_patch(normal: &NormalSummary, name: &str) -> Option<String> {
    let axis_ratio = normal.semi_axis_x / normal.semi_axis_y;
    (!is_tabulated(axis_ratio)).then(|| {
        format!(
            "solver.method: {name:?} takes Kalker's coefficients beyond their table, a/b = \
             {axis_ratio:.4} where it spans 1/10 to 10, from Kalker's limits: C11, C22 and C23 are off by \
             up to 7 % at 1/30 and 30, C33 is a limit only"
        )
    })
}

/// A patch that is no ellipse counts as one.
fn of_shape(problem: &Problem, name: &str) -> Option<String> {
    let normal = problem.normal.normal_contact(None).ok()?;
    let is_table = matches!(normal.pressure, Pressure::Tabulated(..));
    let parts = normal.summary.parts;
    let apart = if parts > 1 {
        format!(
            "; here that ellipse spans {parts} separate parts, and the gaps between them count as contact"
        )
    } else {
        String::new()
    };
    is_table.then(|| {
        format!(
            "solver.method: {name:?} takes Kalker's coefficients of the ellipse with the length and \
             width of the patch{apart}"
        )
    })
}

/// Part of the creep power by which the friction power may differ unmentioned.
const LARGEST_GAP: f64 = 0.05;

/// FASTSIM with three flexibilities cannot close the balance of power where spin takes part.
pub(super) fn of_power(power: &Power) -> Option<String> {
    let gap = (power.friction - power.creep).abs();
    (gap > LARGEST_GAP * power.creep.abs()).then(|| {
        format!(
            "solver.method: the friction power of FASTSIM, {:.4e} W, differs from the creep power, \
             {:.4e} W, by more than {} %: temperatures are uncertain by as much",
            power.friction,
            power.creep,
            100.0 * LARGEST_GAP
        )
    })
}

fn depends_on_temperature(problem: &Problem) -> bool {
    let at = |temperature: f64| {
        let state = FrictionState { temperature, ..FrictionState::default() };
        problem.friction.law.respond(&state).coefficient
    };
    problem.heat.model.is_some() && [30.0, 300.0, 3000.0].into_iter().any(|t| at(t) != at(0.0))
}
