//! What the reader of temperatures must know.

use crate::heat::peclet::semi_axes;
use crate::material::Material;
use crate::normal::NormalSummary;
use crate::patch::Patch;
use crate::problem::Problem;

use super::snapshot::Snapshot;

/// Temperature from which on steel austenitises (A1, 1000 K), in degC: it takes up heat without
/// warming, has lost half of its stiffness, and is another steel afterwards.
const AUSTENITE: f64 = 727.0;

/// Solidus of rail steel with 0.8 % carbon, in degC.
const MOLTEN: f64 = 1380.0;

/// Part by which stiffness and density of a steel may differ from that of wheels and rails.
const STEEL_RANGE: f64 = 0.15;

/// Whatever the reader of the temperatures must know.
pub(crate) fn of_temperatures(
    problem: &Problem,
    (normal, patch, now): (&NormalSummary, &Patch, &Snapshot),
) -> Vec<String> {
    let mut caveats = Vec::from_iter(of_slow_rolling(problem, normal, now));
    let temperature = super::temperature(patch, now);
    let wheel = ("wheel", temperature.max_wheel, &problem.wheel.material);
    let rail = ("rail", temperature.max_rail, &problem.rail.material);
    caveats.extend([wheel, rail].into_iter().filter_map(of_hot_body));
    if now.surfaces.as_ref().is_some_and(|surfaces| !surfaces.is_found) {
        caveats.push(
            "not converged: the exchange of heat between wheel and rail that makes their surfaces equally \
             hot was not found; temperatures are wrong"
                .to_owned(),
        );
    }
    caveats
}

/// Temperatures with conduction perpendicular to the surface that is too slow for it.
fn of_slow_rolling(problem: &Problem, normal: &NormalSummary, now: &Snapshot) -> Option<String> {
    let [wheel, rail] = now.conduction.bulk_temperatures();
    let is_any = now.rise.iter().any(|rise| *rise != 0.0) || wheel != rail;
    let is_rolling = now.kinematics.speed > 0.0;
    if now.surfaces.is_some() || !is_any || !is_rolling {
        return None;
    }
    problem.peclet(&now.kinematics, semi_axes(normal)).caveat(
        "Temperatures of all but steady rolling with solver.method = \"full\", solver.driver = \"steady\" \
         and heat.model = \"duhamel\"",
    )
}

fn of_hot_body((name, temperature, material): (&str, f64, &Material)) -> Option<String> {
    let known = &Material::STEEL;
    let is_near = |value: f64, of_steel: f64| (value / of_steel - 1.0).abs() < STEEL_RANGE;
    let is_steel = is_near(material.young_modulus, known.young_modulus)
        && is_near(material.density, known.density);
    let what = match (is_steel, temperature > MOLTEN) {
        (true, true) => "above the melting range of steel",
        (true, false) => "above 727 degC, where steel starts to austenitise",
        (false, _) => "more than most materials withstand",
    };
    (temperature > AUSTENITE).then(|| {
        format!(
            "heat: the surface of the {name} reaches {temperature:.0} degC, {what}: constants of material, \
             elasticity and friction do not hold there"
        )
    })
}
