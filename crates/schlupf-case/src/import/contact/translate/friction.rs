//! Friction.

use crate::FieldPath;
use crate::import::contact::friction::Friction;
use crate::import::contact::given::Given;

use super::case::Translation;

/// A law that is the same everywhere: the first set of parameters.
pub fn uniform(case: &mut Translation, friction: &Friction) {
    let [a, b, c, d, e] = friction.first();
    let level = friction.static_coefficient();
    match friction.law.whole() {
        0 => {
            case.document.text(field!("friction.model"), "constant");
            if b.value != a.value {
                case.refuse(
                    b,
                    &format!("FKIN must equal FSTAT, {}, as it must in CONTACT", a.value),
                    "L = 2, 3 and 4 are laws of friction that falls with the slip",
                );
            }
        }
        6 => {
            case.document.text(field!("friction.model"), "temperature-piecewise-linear");
            case.document.number(field!("friction.hot_coefficient"), a.value + c.value);
            case.stands(field!("friction.hot_coefficient"), c);
            case.quantity(field!("friction.reference_temperature"), b, (1.0, "degC"));
            case.quantity(field!("friction.temperature_range"), d, (1.0, "K"));
        }
        law => {
            falling(case, law, [(b, c), (d, e)]);
            if b.value != 0.0 || d.value != 0.0 {
                case.document.number(field!("friction.kinetic_coefficient"), a.value);
                case.stands(field!("friction.kinetic_coefficient"), a);
            }
        }
    }
    case.document.number(field!("friction.coefficient"), level);
    case.stands(field!("friction.coefficient"), a);
    if let Some([distance, speed]) = friction.memory.filter(|[distance, _]| distance.value > 0.0) {
        // mm in µm, mm/s.
        case.quantity(field!("friction.memory_distance"), distance, (1e3, "um"));
        case.quantity(field!("friction.memory_speed"), speed, (1.0, "mm/s"));
    }
}

/// A law of two terms, each with its size and the slip speed (in mm/s) at which it has halved.
fn falling(case: &mut Translation, law: i64, [first, second]: [(Given, Given); 2]) {
    if first.0.value == 0.0 && second.0.value == 0.0 {
        case.document.text(field!("friction.model"), "constant");
        return;
    }
    let model = match law {
        2 => "linear-in-speed",
        3 => "rational",
        _ => "exponential",
    };
    case.document.text(field!("friction.model"), model);
    // The first term needs a speed even where it vanishes.
    let first_speed = if first.0.value == 0.0 { second.1 } else { first.1 };
    case.quantity(field!("friction.half_speed"), first_speed, (1.0, "mm/s"));
    if second.0.value != 0.0 {
        case.document.number(field!("friction.second_coefficient"), second.0.value);
        case.stands(field!("friction.second_coefficient"), second.0);
        case.quantity(field!("friction.second_half_speed"), second.1, (1.0, "mm/s"));
    }
}

/// A law that varies over places, ascending and in a unit: factors on that at zero.
pub fn varying(
    case: &mut Translation,
    friction: &Friction,
    (path, places, unit): (FieldPath, &[f64], &str),
) {
    let digit = friction.variation;
    let middle = friction.between(places, 0.0);
    uniform(case, &middle);
    let level = middle.static_coefficient();
    if level <= 0.0 {
        return case.refuse(digit, "friction must be positive at the middle", "");
    }
    let factors: Vec<f64> = friction.each().map(|set| set.static_coefficient() / level).collect();
    let own = friction.each().zip(&factors).find(|(set, factor)| !set.is(&middle, **factor));
    if own.is_some() {
        let what = "a law whose constants do not vary by one common factor is not available";
        case.refuse(digit, what, "V = 0 is the same everywhere");
    }
    if places.len() < 2 {
        return;
    }
    case.document.quantities(path, places, unit);
    case.document.numbers(field!("friction.variation_factor"), &factors);
}
