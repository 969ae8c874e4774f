//! The normal contact of module 3.

use std::fmt::Write;

use schlupf::Error;
use schlupf::normal::PressureSource;
use schlupf::normal::profile::{Profile, UndeformedDistance};

use crate::import::contact::basic::{Area, Basic, Distance};
use crate::import::contact::given::Given;
use crate::import::document::number;

use super::approach::{MILLIMETRE, above, accepted, load};
use super::case::Translation;
use super::contact::{Contact, NormalProblem};
use super::elements::{self, Elements, across, cells};
use super::hertz;
use super::line;

/// Writes the normal contact; nothing if it is refused.
pub fn write(
    case: &mut Translation,
    given: NormalProblem,
    basic: &Basic,
    stem: &str,
) -> Option<Contact> {
    let contact = match &basic.distance {
        _ if given.area.is_hertzian() => hertzian(case, given, stem),
        Some(distance) => by_distance(case, given, distance, stem),
        None => {
            case.miss(given.control.distance, "the undeformed distance");
            None
        }
    }?;
    // N in kN.
    case.document.quantity(field!("normal.load"), contact.load / 1e3, "kN");
    case.stands(field!("normal.load"), given.motion.normal);
    Some(contact)
}

fn hertzian(case: &mut Translation, given: NormalProblem, stem: &str) -> Option<Contact> {
    let area = given.area;
    let [first, second, scale] = area.values[..] else {
        case.refuse(
            area.kind,
            "the contact of two half-ellipses (SDEC) is not available",
            "IPOTCN = -3 is one ellipse",
        );
        return None;
    };
    if area.kind.value < -3.0 {
        let what = "a line contact of finite width is not available";
        case.refuse(area.kind, what, "give its pressure as a file: normal.model = \"tabulated\"");
        return None;
    }
    for value in [first, second, scale] {
        if value.value <= 0.0 {
            case.refuse(value, "must be positive", "");
            return None;
        }
    }
    if scale.value < 1.0 {
        case.refuse(scale, "must be at least 1, or the area cuts the contact off", "");
    }
    let modulus = hertz::modulus(given.elastic);
    // Over the semi-axes.
    let inside = area.cells.map(|count| {
        let side = 2.0 * scale.value / count.value;
        elements::inside([-1.0, 1.0], (0.5 * side - scale.value, side, count))
    });
    match Elements::new(area.cells, inside) {
        Elements::Ellipse => {}
        Elements::Uniform => {
            let axes = semi_axes(case, given, given.motion.normal.value)?;
            let sides = axes.map(|axis| 2.0 * scale.value * axis);
            return elements::uniform(case, given, (sides, [0.0; 2]), stem);
        }
        Elements::Few(count) => {
            elements::refuse_few(case, count);
            return None;
        }
    }
    let found = match area.kind.whole() {
        -3 => {
            let axes = [first.value, second.value];
            case.document.text(field!("normal.model"), "ellipse");
            case.document.quantity(field!("normal.semi_axis_x"), axes[0], "mm");
            case.document.quantity(field!("normal.semi_axis_y"), axes[1], "mm");
            let axes = axes.map(|axis| MILLIMETRE * axis);
            load(case, given, |approach| hertz::load_of_ellipse(axes, modulus, approach))
        }
        _ => curvatures(area).and_then(|curvatures| curved(case, given, curvatures)),
    };
    let load = accepted(case, area.kind, found)?;
    for (path, count) in fields!["grid.cells_x", "grid.cells_y"].into_iter().zip(area.cells) {
        cells(case, path, count.value / scale.value);
    }
    let width = 2.0 * scale.value * semi_axes(case, given, load)?[1];
    let side = width / area.cells[1].value;
    let rows = Some([0.5 * (side - width), side]);
    Some(Contact { load, centre: [0.0; 2], rows })
}

/// A1 and B1 in 1/m, as given or from the ratio of the semi-axes.
fn curvatures(area: &Area) -> Result<[f64; 2], Error> {
    let [first, second] = [0, 1].map(|k| area.values.get(k).map_or(0.0, |given| given.value));
    let ratio = match area.kind.whole() {
        -1 => second / first,
        _ => hertz::curvature_ratio(second)?,
    };
    Ok([1e3 * first, 1e3 * first * ratio])
}

/// Semi-axes of Hertz's contact, in mm.
fn semi_axes(case: &mut Translation, given: NormalProblem, load: f64) -> Option<[f64; 2]> {
    let area = given.area;
    if area.kind.is(-3) {
        return Some([area.values.first()?.value, area.values.get(1)?.value]);
    }
    let contact = curvatures(area)
        .and_then(|curvatures| hertz::contact(curvatures, hertz::modulus(given.elastic), load));
    match contact {
        Ok(contact) => Some(contact.semi_axes().map(|axis| axis / MILLIMETRE)),
        Err(error) => {
            case.refuse(area.kind, &format!("is no contact of Hertz: {error}"), "");
            None
        }
    }
}

/// Bodies with the distance A x² + B y² (in 1/m); their load, in N.
fn curved(
    case: &mut Translation,
    given: NormalProblem,
    curvatures: [f64; 2],
) -> Result<f64, Error> {
    let [x, y] = curvatures.map(|curvature| 0.5 / curvature);
    case.document.text(field!("normal.model"), "hertz");
    case.document.quantity(field!("wheel.radius_x"), 1e3 * x, "mm");
    case.document.quantity(field!("wheel.radius_y"), 1e3 * y, "mm");
    case.document.text(field!("rail.radius_x"), "inf");
    case.document.text(field!("rail.radius_y"), "inf");
    let modulus = hertz::modulus(given.elastic);
    let load = load(case, given, |approach| hertz::load(curvatures, modulus, approach))?;
    // Line contacts, and loads that no contact has.
    if load > 0.0 {
        hertz::contact(curvatures, modulus, load)?;
    }
    Ok(load)
}

fn by_distance(
    case: &mut Translation,
    given: NormalProblem,
    distance: &Distance,
    stem: &str,
) -> Option<Contact> {
    if !distance.plan.is(1) {
        case.refuse(
            distance.plan,
            "a planform that limits the contact is not available",
            "IPLAN = 1 is unrestricted; a distance that grows outside of it does the same",
        );
        return None;
    }
    let is_row = given.area.cells[1].is(1);
    if distance.base.is(1)
        && let [b1, b2, b3, b4, b5, b6] = distance.values[..]
        && (b2.value == 0.0 || is_row)
    {
        if let Some(rectangle) = alike(given.area, [b1, b3], [b4, b5]) {
            return elements::uniform(case, given, rectangle, stem);
        }
        if !is_row {
            return quadratic(case, given, [b1, b3, b4, b5, b6]);
        }
    }
    if is_row { line::write(case, given, distance) } else { table(case, given, distance, stem) }
}

/// Sides and middle, in mm, of an area whose elements have one pressure by symmetry: one or two in
/// each direction, two on both sides of where the distance has no slope.
fn alike(area: &Area, curvatures: [Given; 2], slopes: [Given; 2]) -> Option<([f64; 2], [f64; 2])> {
    let (first, side) = area.lattice();
    let counts = area.cells.map(|count| count.value);
    let middle = [0, 1].map(|k| first[k] + 0.5 * (counts[k] - 1.0) * side[k]);
    let is_alike = |k: usize| {
        let curvature = curvatures[k].value;
        let slope = 2.0 * curvature * middle[k] + slopes[k].value;
        // Numbers of the file are rounded.
        area.cells[k].is(1)
            || area.cells[k].whole() as usize <= elements::ALIKE
                && slope.abs() <= 1e-6 * curvature.abs() * side[k]
    };
    let sides = [0, 1].map(|k| counts[k] * side[k]);
    (is_alike(0) && is_alike(1)).then_some((sides, middle))
}

/// b1 x² + b3 y² + b4 x + b5 y + b6: Hertz's contact about the lowest point.
fn quadratic(
    case: &mut Translation,
    given: NormalProblem,
    [b1, b3, b4, b5, b6]: [Given; 5],
) -> Option<Contact> {
    for (curvature, direction) in [(b1, "along"), (b3, "across")] {
        if curvature.value <= 0.0 {
            let what = format!("the distance must be curved {direction} rolling");
            case.refuse(curvature, &what, "MY = 1 is a line contact, straight across rolling");
            return None;
        }
    }
    let centre = [-0.5 * b4.value / b1.value, -0.5 * b5.value / b3.value];
    let least = b6.value + 0.5 * (b4.value * centre[0] + b5.value * centre[1]);
    let motion = above(given, least);
    let curvatures = [1e3 * b1.value, 1e3 * b3.value];
    let found = curved(case, NormalProblem { motion: &motion, ..given }, curvatures);
    let load = accepted(case, b1, found)?;
    let contact = hertz::contact(curvatures, hertz::modulus(given.elastic), load).ok()?;
    let axes = contact.semi_axes().map(|axis| axis / MILLIMETRE);
    let inside = [0, 1].map(|k| across(case, given, k, [centre[k] - axes[k], centre[k] + axes[k]]));
    let (first, side) = given.area.lattice();
    // Where the grid is larger than the contact, its elements do not share the force evenly.
    if let Some(k) = (0..2).find(|k| inside[*k] <= elements::ALIKE) {
        elements::refuse_few(case, given.area.cells[k]);
    }
    let rows = Some([first[1] - centre[1], side[1]]);
    Some(Contact { load, centre, rows })
}

/// The distance on the grid of the file as a table of its own.
fn table(
    case: &mut Translation,
    given: NormalProblem,
    distance: &Distance,
    stem: &str,
) -> Option<Contact> {
    let counts = given.area.cells.map(|count| count.whole() as usize);
    if let Some(count) = given.area.cells.into_iter().find(|count| count.value < 4.0) {
        let what = "must be at least 4 for a distance that is given on the grid";
        case.refuse(count, what, "MY = 1 is a line contact");
        return None;
    }
    if distance.base.is(9) && distance.values.len() != counts[0] * counts[1] {
        let what = "distances of another grid (IBASE = 9) cannot be kept";
        case.refuse(given.control.distance, what, "Z = 2 gives those of this grid");
        return None;
    }
    let (first, side) = given.area.lattice();
    if side[0] <= 0.0 || side[1] <= 0.0 {
        let sides = given.area.values.get(2).copied().unwrap_or(given.area.kind);
        case.refuse(sides, "the sides of the elements must be positive", "");
        return None;
    }
    let frame = given.frame;
    let mut text = String::from("x [mm],y [mm],distance [mm]\n");
    let mut heights = Vec::with_capacity(counts[0] * counts[1]);
    for row in 0..counts[1] {
        for column in 0..counts[0] {
            let x = first[0] + column as f64 * side[0];
            let y = first[1] + row as f64 * side[1];
            let height = distance.at([x, y], row * counts[0] + column);
            heights.push(MILLIMETRE * height);
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "{},{},{}",
                number(frame.coordinate_x * x),
                number(frame.coordinate_y * y),
                number(height)
            );
        }
    }
    let places =
        |k: usize| (0..counts[k]).map(move |n| MILLIMETRE * (first[k] + n as f64 * side[k]));
    let modulus = hertz::modulus(given.elastic);
    let distance =
        UndeformedDistance::on_lattice(places(0).collect(), places(1).collect(), heights);
    let found = distance.and_then(|distance| {
        let motion = above(given, distance.lowest() / MILLIMETRE);
        load(case, NormalProblem { motion: &motion, ..given }, |approach| {
            let cells = Profile::DEFAULT_CELLS;
            let profile = Profile::from_approach(distance, modulus, approach, cells)?;
            Ok(profile.normal_contact(None)?.summary.load)
        })
    });
    let load = accepted(case, given.motion.normal, found)?;
    let name = format!("{stem}_distance.csv");
    case.document.text(field!("normal.model"), "profile");
    case.document.text(field!("normal.file"), &name);
    case.document.text(field!("kinematics.reference"), "file");
    case.document.files.push((name, text.into_bytes()));
    Some(Contact { load, centre: [0.0; 2], rows: None })
}
