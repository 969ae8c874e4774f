//! What the reader of the full solver's numbers must know.

use crate::material::contact_modulus;
use crate::problem::{Options, Problem};
use crate::summary::{self, snapshot::Snapshot};

use super::contact::DiscreteContact;

/// Largest displacement at the outer edge of the surroundings over the largest one.
const LARGEST_EDGE_DISPLACEMENT: f64 = 0.01;

/// Largest part of the friction power that the bristles may return unmentioned.
const LARGEST_RETURNED_POWER: f64 = 0.01;

/// Largest pressure over E* from which on steel, too, is no longer elastic: its hardness is below that.
const YIELDING: f64 = 0.03;

/// A largest pressure (in Pa) that no body stands.
fn yielding(problem: &Problem, peak_pressure: f64) -> Option<String> {
    let modulus = contact_modulus(&problem.wheel.material, &problem.rail.material);
    (peak_pressure > YIELDING * modulus).then(|| {
        format!(
            "normal: the largest pressure is {:.0} MPa, {:.1} % of the contact modulus, and steel has yielded \
             before 2.5 %: are load and shape in their right units?",
            1e-6 * peak_pressure,
            1e2 * peak_pressure / modulus
        )
    })
}

/// Whatever the reader must know.
pub(crate) fn warnings(
    problem: &Problem,
    options: &Options,
    contact: &mut DiscreteContact,
    now: &Snapshot,
) -> Vec<String> {
    let mut warnings: Vec<String> = problem.elasticity.caveat().into_iter().collect();
    warnings.extend(problem.elasticity.caveat_of_parts(contact.normal.parts));
    warnings.extend(problem.normal.caveat());
    warnings.extend(yielding(problem, contact.normal.peak_pressure));
    warnings
        .extend(summary::caveats::of_temperatures(problem, (&contact.normal, &contact.patch, now)));
    let edge = contact.edge_displacement(&now.traction);
    if edge > LARGEST_EDGE_DISPLACEMENT {
        warnings.push(format!(
            "elasticity.margin: the displacement at the outer edge of the layer is {:.1} % of the \
             largest; a larger margin is needed where that exceeds 1 %",
            100.0 * edge
        ));
    }
    let power = summary::power(&contact.patch, now, &summary::force(&contact.patch, now));
    let limit = problem.friction.cold_coefficient() * contact.normal.load;
    let noise = options.tolerance * limit * now.kinematics.speed;
    if power.returned > (LARGEST_RETURNED_POWER * power.friction.abs()).max(noise) {
        warnings.push(format!(
            "contact_law: the bristles return {:.3e} W of {:.3e} W friction power; that part is cut \
             off and does not cool. Where it is large in steady rolling, the grid is too coarse for \
             the contact law",
            power.returned, power.friction
        ));
    }
    warnings
}
