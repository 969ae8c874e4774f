//! The load, as given or from an approach.

use schlupf::Error;

use crate::import::contact::basic::Motion;
use crate::import::contact::given::Given;
use crate::import::document::number;

use super::case::Translation;
use super::contact::NormalProblem;

/// In m.
pub const MILLIMETRE: f64 = 1e-3;

/// The load (in N), as given or from the approach.
pub fn load(
    case: &mut Translation,
    given: NormalProblem,
    of_approach: impl FnOnce(f64) -> Result<f64, Error>,
) -> Result<f64, Error> {
    let normal = given.motion.normal;
    // What is not positive is refused with its name.
    if given.control.normal.is(1) || normal.value <= 0.0 {
        return Ok(normal.value);
    }
    let load = of_approach(MILLIMETRE * normal.value)?;
    case.remark(format!("The load is that for an approach of {} mm.", number(normal.value)));
    Ok(load)
}

/// The load, if there is a contact.
pub fn accepted(case: &mut Translation, given: Given, load: Result<f64, Error>) -> Option<f64> {
    match load {
        Ok(load) if load.is_finite() && load > 0.0 => Some(load),
        Ok(_) => {
            case.refuse(given, "FN, or PEN, must be positive", "");
            None
        }
        Err(error) => {
            case.refuse(given, &format!("there is no such contact: {error}"), "");
            None
        }
    }
}

/// The motion with an approach from the least distance, in mm.
pub fn above(given: NormalProblem, least: f64) -> Motion {
    let normal = given.motion.normal;
    let from = if given.control.normal.is(1) { 0.0 } else { least };
    Motion { normal: Given { value: normal.value - from, ..normal }, ..*given.motion }
}
