//! A single row of elements: a line contact.

use schlupf::normal::{Line, PressureSource};

use crate::import::contact::basic::Distance;

use super::approach::{MILLIMETRE, above, accepted, load};
use super::case::Translation;
use super::contact::{Contact, NormalProblem};
use super::elements::{self, across};
use super::hertz;

/// Writes two cylinders of the length of a row.
pub fn write(case: &mut Translation, given: NormalProblem, distance: &Distance) -> Option<Contact> {
    let (first, side) = given.area.lattice();
    let [curvature, slope, constant] = along(distance, first[1]).or_else(|| {
        let what = "a single row of elements is available for a distance that is quadratic along x";
        case.refuse(distance.base, what, "IBASE = 1, or 2 with XM and RM");
        None
    })?;
    if curvature <= 0.0 || side[1] <= 0.0 {
        let what = "the distance must be curved along rolling, and DY positive";
        case.refuse(distance.base, what, "");
        return None;
    }
    let centre = [-0.5 * slope / curvature, first[1]];
    let motion = above(given, constant + 0.5 * slope * centre[0]);
    let given = NormalProblem { motion: &motion, ..given };
    // In m.
    let radii = [0.5 * MILLIMETRE / curvature, f64::INFINITY];
    let (length, modulus) = (MILLIMETRE * side[1], hertz::modulus(given.elastic));
    let loaded = |line: Line| Ok(line.normal_contact(None)?.summary);
    let found = load(case, given, |approach| {
        Ok(loaded(Line::from_approach(radii, length, modulus, approach)?)?.load)
    });
    let load = accepted(case, given.motion.normal, found)?;
    let contact = Line::new(radii, length, modulus, load).and_then(loaded).ok()?;
    case.document.text(field!("normal.model"), "line");
    case.document.quantity(field!("normal.length"), side[1], "mm");
    case.document.quantity(field!("wheel.radius_x"), radii[0] / MILLIMETRE, "mm");
    case.document.text(field!("rail.radius_x"), "inf");
    let a = contact.semi_axis_x / MILLIMETRE;
    let inside = across(case, given, 0, [centre[0] - a, centre[0] + a]);
    if inside <= elements::ALIKE {
        elements::refuse_few(case, given.area.cells[0]);
    }
    case.document.count(field!("grid.cells_y"), 1);
    Some(Contact { load, centre, rows: Some([0.0, side[1]]) })
}

/// The distance in a row at y as c x² + s x + d, all in mm: c, s and d.
fn along(distance: &Distance, y: f64) -> Option<[f64; 3]> {
    let b = |k: usize| distance.values.get(k).map_or(0.0, |given| given.value);
    match distance.base.whole() {
        1 => Some([b(0), b(1) * y + b(3), b(2) * y * y + b(4) * y + b(5)]),
        2 => {
            let (middle, curvature) = (b(1), 0.5 / b(2));
            let height = distance.at([middle, y], 0);
            Some([curvature, -2.0 * curvature * middle, curvature * middle * middle + height])
        }
        _ => None,
    }
}
