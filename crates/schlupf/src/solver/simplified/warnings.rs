//! Warnings of the fast methods for whoever uses the results.

use crate::interface::Interface;
use crate::interface::friction::FrictionState;
use crate::normal::{NormalSummary, Pressure};
use crate::problem::look_up_table::LookUpTable;
use crate::problem::{FastMethod, Problem};
use crate::reporting::Warning;
use crate::solution::{Power, Resultant};
use crate::solver::kalker_coefficients::is_tabulated;

/// A force exceeding the friction limit by less than this fraction is rounding error.
const ROUNDING: f64 = 1e-9;

/// All warnings of the solution; `limit` is μN, in N.
pub(super) fn of(
    problem: &Problem,
    normal: &NormalSummary,
    method: &FastMethod,
    force: &Resultant,
    limit: f64,
) -> Vec<Warning> {
    let mut warnings = of_any_motion(problem, normal, method);
    warnings.extend(beyond_friction(method, force, limit));
    warnings
}

/// What the method neglects whatever the motion is.
pub(crate) fn of_any_motion(
    problem: &Problem,
    normal: &NormalSummary,
    method: &FastMethod,
) -> Vec<Warning> {
    let name = method.name();
    let mut warnings = Vec::from_iter(match method {
        FastMethod::Table(table) => of_table(table, normal),
        _ => of_slender_patch(normal, name),
    });
    warnings.extend(of_shape(problem, name));
    warnings.extend(problem.interface.beyond_elastic(normal.peak_pressure));
    warnings.extend(of_interface(&problem.interface, method));
    warnings
}

/// What the method neglects of an interface.
pub(crate) fn of_interface(interface: &Interface, method: &FastMethod) -> Vec<Warning> {
    let name = method.name();
    let elasticity = &interface.elasticity;
    let unlike = elasticity.pressure_coupling().map(|coupling| coupling.constant);
    let unlike = unlike.filter(|constant| *constant != 0.0);
    let unlike = unlike.map(|constant| Warning::DissimilarBodies { constant });
    let mut warnings = Vec::from_iter(unlike.or_else(|| elasticity.caveat()));
    if interface.friction_memory().is_some() {
        warnings.push(Warning::NoMemory { method: name });
    }
    let may_yield = interface.layer.is_some_and(|layer| layer.yield_limit().is_some());
    if may_yield && !method.has_fields() {
        warnings.push(Warning::NoYield { method: name });
    }
    let is_cold = !method.has_fields() && *method != FastMethod::KalkerLinear;
    if is_cold && depends_on_temperature(interface) {
        warnings.push(Warning::ColdFriction { method: name });
    }
    warnings
}

/// A force beyond `limit` = μN, in N.
pub(super) fn beyond_friction(
    method: &FastMethod,
    force: &Resultant,
    limit: f64,
) -> Option<Warning> {
    let ratio = force.tangential() / limit;
    is_beyond_friction(method, force, limit)
        .then(|| Warning::BeyondFriction { method: method.name(), ratio })
}

/// Whether a force exceeds friction; a square takes less time than a root.
#[inline]
pub(super) fn is_beyond_friction(method: &FastMethod, force: &Resultant, limit: f64) -> bool {
    let most = limit * (1.0 + ROUNDING);
    force.x * force.x + force.y * force.y > most * most && !method.has_fields()
}

/// Beyond the table of Kalker's coefficients their error is larger.
fn of_slender_patch(normal: &NormalSummary, method: &'static str) -> Option<Warning> {
    let axis_ratio = normal.semi_axis_x / normal.semi_axis_y;
    (!is_tabulated(axis_ratio)).then_some(Warning::SlenderPatch { method, axis_ratio })
}

/// A patch more slender than those of the table.
fn of_table(table: &LookUpTable, normal: &NormalSummary) -> Option<Warning> {
    let axis_ratio = normal.semi_axis_x / normal.semi_axis_y;
    let range = table.axis_ratios();
    (!table.covers(axis_ratio)).then_some(Warning::OutsideTable { axis_ratio, range })
}

/// A non-elliptical patch is represented by an ellipse.
fn of_shape(problem: &Problem, method: &'static str) -> Option<Warning> {
    let normal = problem.normal.normal_contact(None).ok()?;
    let is_table = matches!(normal.pressure, Pressure::Tabulated(..));
    let parts = normal.summary.parts;
    is_table.then_some(Warning::CountsAsEllipse { method, parts })
}

/// Fraction of the creep power by which the friction power may differ without a warning.
const LARGEST_GAP: f64 = 0.05;

/// FASTSIM with three flexibilities does not balance the powers if there is spin.
pub(super) fn of_power(power: Power) -> Option<Warning> {
    let gap = (power.friction - power.creep).abs();
    let (friction, creep, part) = (power.friction, power.creep, LARGEST_GAP);
    (gap > part * creep.abs()).then_some(Warning::PowerGap { friction, creep, part })
}

fn depends_on_temperature(interface: &Interface) -> bool {
    let at = |temperature: f64| {
        let state = FrictionState { temperature, ..FrictionState::default() };
        interface.friction.law.respond(&state).coefficient
    };
    interface.heat.model.is_some() && [30.0, 300.0, 3000.0].into_iter().any(|t| at(t) != at(0.0))
}
