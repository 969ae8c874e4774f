//! Materials, friction, heat and method: what both modules have.

use crate::FieldPath;
use crate::import::Notice;
use crate::import::contact::control::Control;
use crate::import::contact::given::Given;
use crate::import::contact::material::{Elastic, Heat};

use super::case::Translation;
use super::frame::WheelBody;

const YOUNG: [FieldPath; 2] = fields!["wheel.young_modulus", "rail.young_modulus"];
const RELAXED: [FieldPath; 2] = fields!["wheel.relaxed_modulus", "rail.relaxed_modulus"];
const RETARDATION: [FieldPath; 2] = fields!["wheel.retardation_time", "rail.retardation_time"];
const POISSON: [FieldPath; 2] = fields!["wheel.poisson_ratio", "rail.poisson_ratio"];
const TEMPERATURE: [FieldPath; 2] = fields!["wheel.bulk_temperature", "rail.bulk_temperature"];
const CAPACITY: [FieldPath; 2] = fields!["wheel.specific_heat", "rail.specific_heat"];
const CONDUCTIVITY: [FieldPath; 2] = fields!["wheel.conductivity", "rail.conductivity"];
const DENSITY: [FieldPath; 2] = fields!["wheel.density", "rail.density"];

/// Elastic constants of both bodies.
pub fn elastic(case: &mut Translation, elastic: &Elastic, wheel: WheelBody) {
    for (path, body) in [wheel.index(), 1 - wheel.index()].into_iter().enumerate() {
        case.document.quantity(YOUNG[path], young_modulus(elastic, body), "GPa");
        case.document.number(POISSON[path], elastic.poisson[body].value);
        case.stands(YOUNG[path], elastic.shear_modulus[body]);
        case.stands(POISSON[path], elastic.poisson[body]);
    }
    for shear in elastic.shear_modulus.into_iter().filter(|shear| shear.value <= 0.0) {
        case.refuse(shear, "must be positive", "");
    }
    let is_possible = |poisson: &Given| (0.0..=0.5).contains(&poisson.value);
    for poisson in elastic.poisson.into_iter().filter(|poisson| !is_possible(poisson)) {
        case.refuse(poisson, "must be 0 to 0.5", "");
    }
    if elastic.influence.is(9) {
        let what = "influence coefficients from a file are not available";
        case.refuse(elastic.influence, what, "C3 = 2 is the half-space");
    }
}

/// Of a body, in GPa: GG is in N/mm².
fn young_modulus(elastic: &Elastic, body: usize) -> f64 {
    2.0 * elastic.shear_modulus[body].value * (1.0 + elastic.poisson[body].value) / 1e3
}

/// Influence coefficients on a curved surface for a contact in a plane.
pub fn refuse_conformal(case: &mut Translation, elastic: &Elastic) {
    let what = "influence coefficients of conformal bodies need two profiles and D = 4";
    case.refuse(elastic.influence, what, "C3 = 2 is the half-space");
}

/// MAXOUT = 1: the tractions of unlike bodies do not change their pressure.
pub fn unlike_bodies(case: &mut Translation, elastic: &Elastic, iterations: Option<Given>) {
    let [one, other] =
        [0, 1].map(|k| (1.0 - 2.0 * elastic.poisson[k].value) / elastic.shear_modulus[k].value);
    let Some(iterations) = iterations.filter(|given| given.is(1) && one != other) else { return };
    case.document.text(field!("elasticity.unlike_bodies"), "one-way");
    case.stands(field!("elasticity.unlike_bodies"), iterations);
}

/// What solves the case: digits M and B.
pub fn method(
    case: &mut Translation,
    control: &Control,
    elastic: &Elastic,
    wheel: Option<WheelBody>,
) {
    let material = control.material;
    match material.whole() {
        1 => match wheel.filter(|_| control.tangential.is(3)) {
            Some(wheel) => viscoelastic(case, (control, elastic), wheel),
            None => case.refuse(
                material,
                "viscoelastic bodies are available in steady rolling of module 3 only",
                "M = 0 is elastic",
            ),
        },
        2 => case.refuse(
            material,
            "FASTSIM with a flexibility FLX that is given is not available",
            "M = 3 finds the flexibilities from Kalker's coefficients",
        ),
        3 => fastsim(case, control, elastic),
        of_half_spaces => {
            match of_half_spaces {
                0 => {}
                4 => third_body(case, elastic),
                _ => fastrip(case, material, elastic),
            }
            case.document.text(field!("elasticity.model"), "half-space");
            case.document.text(field!("contact_law.model"), "coulomb");
            if control.bound.is(3) {
                case.refuse(
                    control.bound,
                    "a parabolic pressure on the half-space is not available",
                    "B = 0 or 2 is that of Hertz; with M = 3 B = 3 is available",
                );
            }
        }
    }
    bound(case, control);
    if control.damping.value >= 2.0 {
        case.refuse(control.damping, "damping is not available", "leave it out: M2 = 0");
    }
}

/// Standard linear solids: FG = E/E∞ − 1, and TC in s.
fn viscoelastic(
    case: &mut Translation,
    (control, elastic): (&Control, &Elastic),
    wheel: WheelBody,
) {
    if control.normal.is(0) {
        let what = "the approach of viscoelastic bodies is not available";
        case.refuse(control.normal, what, "N = 1 gives the load");
    }
    if control.bound.is(2) || control.bound.is(3) {
        let what = "a given pressure of viscoelastic bodies is not available";
        case.refuse(control.bound, what, "B = 0 solves the normal contact");
    }
    case.document.text(field!("elasticity.model"), "viscoelastic");
    case.document.text(field!("contact_law.model"), "coulomb");
    let [first, second, first_time, second_time] = elastic.model[..] else { return };
    let solids = [[first, first_time], [second, second_time]];
    for (path, body) in [wheel.index(), 1 - wheel.index()].into_iter().enumerate() {
        let [ratio, time] = solids[body];
        for given in [ratio, time].into_iter().filter(|given| given.value < 0.0) {
            case.refuse(given, "must not be negative", "");
        }
        let young = young_modulus(elastic, body) / (1.0 + ratio.value);
        case.document.quantity(RELAXED[path], young, "GPa");
        case.quantity(RETARDATION[path], time, (1.0, "s"));
        case.stands(RELAXED[path], ratio);
    }
}

/// A layer between the surfaces: GG3 in N/mm², LAYTHK in mm, TAU_C0 in N/mm², where it is zero
/// elastic only, and K_TAU in N/mm³.
fn third_body(case: &mut Translation, elastic: &Elastic) {
    let [shear_modulus, thickness, stress, hardening] = elastic.model[..] else { return };
    case.quantity(field!("layer.thickness"), thickness, (1.0, "mm"));
    case.quantity(field!("layer.shear_modulus"), shear_modulus, (1.0, "MPa"));
    if stress.value > 0.0 {
        case.quantity(field!("layer.yield_stress"), stress, (1.0, "MPa"));
        if hardening.value != 0.0 {
            case.quantity(field!("layer.hardening"), hardening, (1.0, "MPa/mm"));
        }
    }
}

/// What bounds the traction with every material: the digit B, as far as it is refused.
fn bound(case: &mut Translation, control: &Control) {
    let bound = control.bound;
    let what = match bound.whole() {
        1 => "a compressible layer (FLXZ) is not available",
        4 => "the contact of two half-ellipses (SDEC) is not available",
        _ => return,
    };
    case.refuse(bound, what, "B = 0 solves the normal contact");
}

/// K0_MF, ALFAMF and BETAMF, and whether they change nothing.
fn slope_reduction(elastic: &Elastic) -> ([Given; 3], bool) {
    let none = Given { value: 1.0, ..elastic.influence };
    let given = std::array::from_fn(|k| elastic.model.get(k).copied().unwrap_or(none));
    let [initial, limit, _] = given;
    (given, initial.is(1) && limit.is(1))
}

/// FaStrip approximates the equations that are solved here.
fn fastrip(case: &mut Translation, material: Given, elastic: &Elastic) {
    case.notice(Notice::NoStrips {}, material);
    let ([initial, ..], is_plain) = slope_reduction(elastic);
    if material.is(5) && !is_plain {
        let what = "FaStrip with reduced slopes is not available";
        case.refuse(initial, what, "M = 3 is modified FASTSIM; K0_MF = ALFAMF = 1 reduces nothing");
    }
}

fn fastsim(case: &mut Translation, control: &Control, elastic: &Elastic) {
    let ([initial, limit, decay], is_plain) = slope_reduction(elastic);
    case.document
        .text(field!("solver.method"), if is_plain { "fastsim" } else { "modified-fastsim" });
    let bound = if control.bound.is(3) { "parabolic" } else { "elliptic" };
    case.document.text(field!("fastsim.flexibilities"), "three");
    case.document.text(field!("fastsim.bound"), bound);
    if is_plain {
        return;
    }
    case.document.number(field!("fastsim.initial_reduction"), initial.value);
    case.document.number(field!("fastsim.reduction_limit_ratio"), limit.value);
    // CONTACT's ratio of slip to adhesion is that of the softened contact: k0 times ours.
    case.document.number(field!("fastsim.reduction_decay"), initial.value * decay.value);
    case.stands(field!("fastsim.initial_reduction"), initial);
    case.stands(field!("fastsim.reduction_limit_ratio"), limit);
    case.stands(field!("fastsim.reduction_decay"), decay);
}

/// How CONTACT's FASTSIM differs, for a creepage along rolling only or any other.
pub fn notice_fastsim(
    case: &mut Translation,
    control: &Control,
    elastic: &Elastic,
    is_along: bool,
) {
    if !control.material.is(3) {
        return;
    }
    case.notice(Notice::OtherFastsim {}, control.material);
    let ([_, limit, decay], is_plain) = slope_reduction(elastic);
    let falls = !is_plain && limit.value != 1.0 && decay.value != 0.0;
    if falls && !is_along {
        case.notice(Notice::OtherSlopeReduction {}, decay);
    }
}

/// The digit H, with the constants that it needs.
pub fn heat(case: &mut Translation, control: &Control, heat: Option<&Heat>, wheel: WheelBody) {
    let digit = control.heat;
    if digit.is(0) {
        case.document.text(field!("heat.model"), "none");
        return;
    }
    let Some(heat) = heat else { return case.miss(digit, "the thermal constants of both bodies") };
    case.document.text(field!("heat.model"), "duhamel");
    case.document.text(field!("heat.partition"), "velocity");
    for (path, body) in [wheel.index(), 1 - wheel.index()].into_iter().enumerate() {
        let [temperature, capacity, conductivity, density] = heat.bodies[body];
        case.quantity(TEMPERATURE[path], temperature, (1.0, "degC"));
        case.quantity(CAPACITY[path], capacity, (1.0, "J/(kg K)"));
        // W/(mm K) and kg/mm³.
        case.quantity(CONDUCTIVITY[path], conductivity, (1e3, "W/(m K)"));
        case.quantity(DENSITY[path], density, (1e9, "kg/m^3"));
    }
    let is_plastic =
        case.document.fields().iter().any(|field| field.path == field!("layer.yield_stress"));
    if let Some(part) = heat.plastic_part.filter(|part| is_plastic && !part.is(1)) {
        let what = "a part of the plastic work that does not heat is not available";
        case.refuse(part, what, "BETAPL = 1 heats with all of it");
    }
}

/// What is left out of both modules.
pub fn notice_digits(case: &mut Translation, control: &Control) {
    if control.stress.value != 0.0 {
        case.notice(Notice::PointsLeftOut {}, control.stress);
    }
}
