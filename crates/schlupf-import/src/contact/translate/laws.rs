//! Materials, friction, heat and method: what both modules have.

use crate::contact::control::Control;
use crate::contact::friction::Friction;
use crate::contact::given::Given;
use crate::contact::material::{Elastic, Heat};

use super::case::Translation;
use super::frame::WheelBody;

const YOUNG: [&str; 2] = ["wheel.young_modulus", "rail.young_modulus"];
const POISSON: [&str; 2] = ["wheel.poisson_ratio", "rail.poisson_ratio"];
const TEMPERATURE: [&str; 2] = ["wheel.bulk_temperature", "rail.bulk_temperature"];
const CAPACITY: [&str; 2] = ["wheel.specific_heat", "rail.specific_heat"];
const CONDUCTIVITY: [&str; 2] = ["wheel.conductivity", "rail.conductivity"];
const DENSITY: [&str; 2] = ["wheel.density", "rail.density"];

/// Elastic constants of both bodies.
pub fn elastic(case: &mut Translation, elastic: &Elastic, wheel: WheelBody) {
    for (path, body) in [wheel.index(), 1 - wheel.index()].into_iter().enumerate() {
        let (shear, poisson) = (elastic.shear_modulus[body].value, elastic.poisson[body].value);
        // N/mm² in GPa.
        let young = 2.0 * shear * (1.0 + poisson) / 1e3;
        case.document.quantity(YOUNG[path], young, "GPa");
        case.document.number(POISSON[path], poisson);
    }
    for shear in elastic.shear_modulus.into_iter().filter(|shear| shear.value <= 0.0) {
        case.refuse(shear, "must be positive", "");
    }
    let is_possible = |poisson: &Given| (0.0..=0.5).contains(&poisson.value);
    for poisson in elastic.poisson.into_iter().filter(|poisson| !is_possible(poisson)) {
        case.refuse(poisson, "must be 0 to 0.5", "");
    }
    match elastic.influence.whole() {
        4 => case.refuse(
            elastic.influence,
            "influence coefficients of conformal bodies are not available",
            "C3 = 2 is the half-space",
        ),
        9 => case.refuse(
            elastic.influence,
            "influence coefficients from a file are not available",
            "C3 = 2 is the half-space",
        ),
        _ => {}
    }
}

/// What solves the case: digits M and B.
pub fn method(case: &mut Translation, control: &Control, elastic: &Elastic) {
    let material = control.material;
    match material.whole() {
        0 | 4 => {
            if material.is(4) {
                third_body(case, elastic);
            }
            case.document.text("elasticity.model", "half-space");
            case.document.text("contact_law.model", "coulomb");
            if control.bound.is(3) {
                case.refuse(
                    control.bound,
                    "a parabolic pressure on the half-space is not available",
                    "B = 0 or 2 is that of Hertz; with M = 3 B = 3 is available",
                );
            }
        }
        3 => fastsim(case, control, elastic),
        1 => case.refuse(material, "viscoelastic bodies are not available", "M = 0 is elastic"),
        2 => case.refuse(
            material,
            "FASTSIM with a flexibility FLX that is given is not available",
            "M = 3 finds the flexibilities from Kalker's coefficients",
        ),
        _ => case.refuse(
            material,
            "FaStrip is not available",
            "M = 3 is FASTSIM, M = 0 solves all equations",
        ),
    }
    bound(case, control);
    if control.damping.value >= 2.0 {
        case.refuse(control.damping, "damping is not available", "leave it out: M2 = 0");
    }
}

/// A layer between the surfaces: GG3 in N/mm², LAYTHK in mm, TAU_C0 in N/mm², where it is zero
/// elastic only, and K_TAU in N/mm³.
fn third_body(case: &mut Translation, elastic: &Elastic) {
    let [shear_modulus, thickness, stress, hardening] = elastic.model[..] else { return };
    let document = &mut case.document;
    document.quantity("layer.thickness", thickness.value, "mm");
    document.quantity("layer.shear_modulus", shear_modulus.value, "MPa");
    if stress.value > 0.0 {
        document.quantity("layer.yield_stress", stress.value, "MPa");
        if hardening.value != 0.0 {
            document.quantity("layer.hardening", hardening.value, "MPa/mm");
        }
    }
}

/// What bounds the traction with every material: the digit B, as far as it is refused.
fn bound(case: &mut Translation, control: &Control) {
    let bound = control.bound;
    let what = match bound.whole() {
        1 => "a compressible layer (FLXZ) is not available",
        4 => "the contact of two half-ellipses (SDEC) is not available",
        5 => "the approximate contact of Kik and Piotrowski (KPEC) is not available",
        6 => "the approximate contact ANALYN is not available",
        _ => return,
    };
    case.refuse(bound, what, "B = 0 solves the normal contact");
}

fn fastsim(case: &mut Translation, control: &Control, elastic: &Elastic) {
    let [initial, limit, decay] =
        std::array::from_fn(|k| elastic.model.get(k).map_or(1.0, |given| given.value));
    let is_plain = initial == 1.0 && limit == 1.0;
    case.document.text("solver.method", if is_plain { "fastsim" } else { "modified-fastsim" });
    let bound = if control.bound.is(3) { "parabolic" } else { "elliptic" };
    case.document.text("fastsim.flexibilities", "three");
    case.document.text("fastsim.bound", bound);
    if !is_plain {
        case.document.number("fastsim.initial_reduction", initial);
        case.document.number("fastsim.reduction_limit_ratio", limit);
        case.document.number("fastsim.reduction_decay", decay);
        case.remark(
            "The ratio of slip to adhesion that reduces the slope is not scaled as in CONTACT: forces of \
             modified FASTSIM differ.",
        );
    }
}

/// The law of friction.
pub fn friction(case: &mut Translation, friction: &Friction) {
    let [a, b, c, d, e] = friction.first();
    let level = friction.static_coefficient();
    match friction.law.whole() {
        0 => {
            case.document.text("friction.model", "constant");
            if b.value != a.value {
                case.refuse(
                    b,
                    &format!("FKIN must equal FSTAT, {}, as it must in CONTACT", a.value),
                    "L = 2, 3 and 4 are laws of friction that falls with the slip",
                );
            }
        }
        6 => {
            case.document.text("friction.model", "temperature-piecewise-linear");
            case.document.number("friction.hot_coefficient", a.value + c.value);
            case.document.quantity("friction.reference_temperature", b.value, "degC");
            case.document.quantity("friction.temperature_range", d.value, "K");
        }
        law => {
            let [first, second] = [(b.value, c.value), (d.value, e.value)];
            falling(case, law, [first, second]);
            if first.0 != 0.0 || second.0 != 0.0 {
                case.document.number("friction.kinetic_coefficient", a.value);
            }
        }
    }
    case.document.number("friction.coefficient", level);
    if let Some([distance, speed]) = friction.memory.filter(|[distance, _]| distance.value > 0.0) {
        // mm in µm, mm/s.
        case.document.quantity("friction.memory_distance", 1e3 * distance.value, "um");
        case.document.quantity("friction.memory_speed", speed.value, "mm/s");
    }
}

/// A law of two terms, each with its size and the slip speed (in mm/s) at which it has halved.
fn falling(case: &mut Translation, law: i64, [first, second]: [(f64, f64); 2]) {
    if first.0 == 0.0 && second.0 == 0.0 {
        case.document.text("friction.model", "constant");
        return;
    }
    let model = match law {
        2 => "linear-in-speed",
        3 => "rational",
        _ => "exponential",
    };
    case.document.text("friction.model", model);
    // The first term needs a speed even where it vanishes.
    let first_speed = if first.0 == 0.0 { second.1 } else { first.1 };
    case.document.quantity("friction.half_speed", first_speed, "mm/s");
    if second.0 != 0.0 {
        case.document.number("friction.second_coefficient", second.0);
        case.document.quantity("friction.second_half_speed", second.1, "mm/s");
    }
}

/// The digit H, with the constants that it needs.
pub fn heat(case: &mut Translation, control: &Control, heat: Option<&Heat>, wheel: WheelBody) {
    let digit = control.heat;
    if digit.is(0) {
        case.document.text("heat.model", "none");
        return;
    }
    let Some(heat) = heat else { return case.miss(digit, "the thermal constants of both bodies") };
    case.document.text("heat.model", "duhamel");
    case.document.text("heat.partition", "velocity");
    for (path, body) in [wheel.index(), 1 - wheel.index()].into_iter().enumerate() {
        let [temperature, capacity, conductivity, density] =
            heat.bodies[body].map(|given| given.value);
        case.document.quantity(TEMPERATURE[path], temperature, "degC");
        case.document.quantity(CAPACITY[path], capacity, "J/(kg K)");
        // W/(mm K) and kg/mm³.
        case.document.quantity(CONDUCTIVITY[path], 1e3 * conductivity, "W/(m K)");
        case.document.quantity(DENSITY[path], 1e9 * density, "kg/m^3");
    }
}

/// What is said of digits of both modules.
pub fn remark_digits(case: &mut Translation, control: &Control) {
    if control.stress.value != 0.0 {
        case.remark(
            "The points of stresses below the surface (S) are left out: `schlupf subsurface` computes \
             them for this case.",
        );
    }
}
