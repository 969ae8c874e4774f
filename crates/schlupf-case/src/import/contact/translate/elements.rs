//! Elements of a grid that is so coarse that their pressures make no ellipse.

use std::fmt::Write;

use schlupf::problem::MAX_CELLS;

use crate::FieldPath;
use crate::import::contact::given::Given;
use crate::import::document::number;

use super::case::Translation;
use super::contact::{Contact, NormalProblem};

/// Elements across a contact with one pressure, by symmetry.
pub const ALIKE: usize = 2;

/// What the elements of a contact have as their pressures.
pub enum Elements {
    /// So many that they are those of an ellipse.
    Ellipse,
    /// The same: one or two across the whole grid in both directions.
    Uniform,
    /// That of a contact in a plane, or one of parts of the grid: the number of elements that is
    /// too small.
    Few(Given),
}

impl Elements {
    /// Those of a grid of some elements, of which so many have their centre in the contact.
    pub fn new(cells: [Given; 2], inside: [usize; 2]) -> Self {
        let few = inside.map(|count| count <= ALIKE);
        let is_whole = |k: usize| inside[k] as i64 == cells[k].whole();
        match few {
            [false, false] => Self::Ellipse,
            [true, true] if is_whole(0) && is_whole(1) => Self::Uniform,
            [true, _] => Self::Few(cells[0]),
            _ => Self::Few(cells[1]),
        }
    }
}

/// Number of elements with their centre between two ends, from the first centre and the side.
pub fn inside([low, high]: [f64; 2], (first, side, cells): (f64, f64, Given)) -> usize {
    (0..cells.whole()).filter(|k| (low..high).contains(&(first + *k as f64 * side))).count()
}

/// Cells across the contact.
pub fn cells(case: &mut Translation, path: FieldPath, count: f64) {
    let least = if path == field!("grid.cells_x") { 2.0 } else { 1.0 };
    let count = count.round().clamp(least, MAX_CELLS as f64);
    case.document.count(path, count as usize);
}

/// Cells across the contact in a direction, between two ends in mm; returns the number of elements
/// inside.
pub fn across(
    case: &mut Translation,
    given: NormalProblem,
    k: usize,
    [low, high]: [f64; 2],
) -> usize {
    let (first, side) = given.area.lattice();
    let count = given.area.cells[k];
    let from = first[k] - 0.5 * side[k];
    let to = from + count.value * side[k];
    // A cell that is touched at its edge alone may be outside.
    if low < from - side[k] || high > to + side[k] {
        let [from, to, low, high] = [from, to, low, high].map(rounded);
        let what = format!(
            "the potential contact area, {from} to {to} mm, cuts the contact off, which goes from \
             {low} to {high} mm"
        );
        case.refuse(count, &what, "a larger area contains it");
    }
    cells(case, fields!["grid.cells_x", "grid.cells_y"][k], (high - low) / side[k]);
    inside([low, high], (first[k], side[k], count))
}

fn rounded(length: f64) -> String {
    number((1e3 * length).round() / 1e3)
}

/// Refuses elements that are too few for an ellipse and too many for one pressure.
pub fn refuse_few(case: &mut Translation, count: Given) {
    let what = "one or two elements have the same pressure, which is not that of an ellipse";
    let help = "3 or more across the contact are those of an ellipse; a potential contact area of 1 \
                or 2 in both directions about the middle of the contact is a rectangle under one \
                pressure";
    case.refuse(count, what, help);
}

/// A rectangle under one pressure, which its elements have: sides and middle in mm.
pub fn uniform(
    case: &mut Translation,
    given: NormalProblem,
    (sides, centre): ([f64; 2], [f64; 2]),
    stem: &str,
) -> Option<Contact> {
    let (load, cells) = (given.motion.normal, given.area.cells);
    if given.control.normal.is(0) {
        let what = "an approach is not available for so few elements that they have one pressure";
        case.refuse(load, what, "N = 1 gives the normal force FN");
        return None;
    }
    if !given.control.bound.is(0) {
        let what = "an elliptic or parabolic pressure is not available for one or two elements";
        case.refuse(given.control.bound, what, "B = 0 is their own pressure");
        return None;
    }
    let positive = sides.iter().all(|side| side.is_finite() && *side > 0.0);
    if load.value <= 0.0 || !positive {
        let (wrong, what) = if positive {
            (load, "must be positive")
        } else {
            (given.area.kind, "the sides of the elements must be positive")
        };
        case.refuse(wrong, what, "");
        return None;
    }
    let pressure = load.value / (sides[0] * sides[1]);
    // Two samples for each element: what does not fall towards its end goes on to the edge.
    let samples = cells.map(|count| 2.0 * count.value);
    let mut text = String::from("x [mm],y [mm],pressure [MPa]\n");
    for row in 0..samples[1] as usize {
        for column in 0..samples[0] as usize {
            let [x, y] = [(column, 0), (row, 1)]
                .map(|(place, k)| ((place as f64 + 0.5) / samples[k] - 0.5) * sides[k]);
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{},{},{}", number(x), number(y), number(pressure));
        }
    }
    let name = format!("{stem}_pressure.csv");
    case.document.text(field!("normal.model"), "tabulated");
    case.document.text(field!("normal.file"), &name);
    case.document.files.push((name, text.into_bytes()));
    case.document.count(field!("grid.cells_x"), 2);
    case.document.count(field!("grid.cells_y"), cells[1].whole() as usize);
    case.remark(format!(
        "The elements have one pressure by symmetry, {} MPa over {} x {} mm.",
        number(pressure),
        number(sides[0]),
        number(sides[1])
    ));
    let side = sides[1] / cells[1].value;
    Some(Contact { load: load.value, centre, rows: Some([0.5 * (side - sides[1]), side]) })
}
