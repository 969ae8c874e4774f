//! Warnings for whoever uses the temperatures.

use crate::bodies::Material;
use crate::normal::NormalSummary;
use crate::problem::Problem;
use crate::reporting::{HeatLimit, Quantity, Unconverged, Warning};

use super::snapshot::{Snapshot, View};

/// Temperature above which steel austenitises (A1, 1000 K), in degC: it absorbs latent heat, has
/// lost half of its stiffness, and has a different microstructure afterwards.
const AUSTENITE: f64 = 727.0;

/// Solidus of rail steel with 0.8 % carbon, in degC.
const MOLTEN: f64 = 1380.0;

/// Relative difference by which stiffness and density of a steel may differ from those of wheels
/// and rails.
const STEEL_RANGE: f64 = 0.15;

/// Warnings for whoever uses the temperatures.
pub(crate) fn of_temperatures(
    problem: &Problem,
    View { normal, patch, now }: View,
) -> Vec<Warning> {
    let mut caveats = Vec::from_iter(of_slow_rolling(problem, normal, now));
    let temperature = super::temperature(patch, now);
    let (wheel, rail) = (Quantity::WheelBulkTemperature, Quantity::RailBulkTemperature);
    caveats.extend(of_hot_body(wheel, temperature.max_wheel, &problem.interface.wheel.material));
    caveats.extend(of_hot_body(rail, temperature.max_rail, &problem.interface.rail.material));
    if now.surfaces.as_ref().is_some_and(|surfaces| !surfaces.is_found) {
        caveats.push(Warning::of(Unconverged::HeatExchange {}));
    }
    caveats
}

/// Warns of temperatures with conduction perpendicular to the surface where rolling is too slow for
/// it.
fn of_slow_rolling(problem: &Problem, normal: &NormalSummary, now: &Snapshot) -> Option<Warning> {
    let [wheel, rail] = now.conduction.bulk_temperatures();
    let is_any = now.scaled_rise.iter().any(|scaled_rise| *scaled_rise != 0.0) || wheel != rail;
    let is_rolling = now.kinematics.speed > 0.0;
    if now.surfaces.is_some() || !is_any || !is_rolling {
        return None;
    }
    problem.interface.peclet(&now.kinematics, normal.semi_axes()).caveat(false)
}

fn of_hot_body(body: Quantity, temperature: f64, material: &Material) -> Option<Warning> {
    let known = &Material::STEEL;
    let is_near = |value: f64, of_steel: f64| (value / of_steel - 1.0).abs() < STEEL_RANGE;
    let is_steel = is_near(material.young_modulus, known.young_modulus)
        && is_near(material.density, known.density);
    let limit = match (is_steel, temperature > MOLTEN) {
        (true, true) => HeatLimit::Melting,
        (true, false) => HeatLimit::Austenite,
        (false, _) => HeatLimit::AnyMaterial,
    };
    (temperature > AUSTENITE).then_some(Warning::HotSurface { body, temperature, limit })
}
