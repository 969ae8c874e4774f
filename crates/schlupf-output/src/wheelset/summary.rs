//! The contacts of a wheelset as text.

use schlupf::wheel_rail::WheelSolution;

use super::WheelsetReport;
use crate::number::significant as number;
use crate::report::{Report, reasons, verdict};
use crate::summary::{Summary, line};

/// A line for each position, and the equivalent conicity.
pub(super) fn text(report: &WheelsetReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    line(&mut text, "wheelset on both rails; contact with the largest normal force of each wheel");
    let head =
        ["y (mm)", "Δr (mm)", "rail left", "angle", "p0 (MPa)", "rail right", "angle", "p0 (MPa)"];
    line(&mut text, &columns(&head.map(str::to_owned)));
    for at in &report.positions {
        let millimetres = |value: f64| number(1e3 * value);
        let side = |wheel: &WheelSolution| {
            let Some(contact) = wheel.contacts.first() else {
                return [(); 3].map(|()| number(None));
            };
            let several = if wheel.contacts.len() > 1 { "*" } else { "" };
            [
                millimetres(contact.rail_position) + several,
                number(contact.angle),
                number(1e-6 * contact.solution.normal.peak_pressure),
            ]
        };
        let [[a, b, c], [d, e, f]] = at.wheels.each_ref().map(side);
        let difference = number(at.rolling_radius_difference().map(|difference| 1e3 * difference));
        line(&mut text, &columns(&[millimetres(at.lateral), difference, a, b, c, d, e, f]));
    }
    let has_several = |at: &super::WheelsetAt| at.wheels.iter().any(|w| w.contacts.len() > 1);
    if report.positions.iter().any(has_several) {
        line(&mut text, "  * the wheel has several contacts; CSV and JSON have all");
    }
    line(&mut text, "  rail: position on the rail's profile in mm, outwards; angles in rad");
    text.blank();
    let curve = &report.conicity;
    line(&mut text, "equivalent conicity (rigid, harmonic linearisation)");
    for (amplitude, conicity) in curve.amplitude.iter().zip(&curve.conicity) {
        let amplitude = number(1e3 * amplitude);
        line(&mut text, &format!("{amplitude:>12} mm{:>11}", number(*conicity)));
    }
    text.blank();
    line(&mut text, verdict(report.status()));
    for reason in reasons(&report.warnings) {
        line(&mut text, &format!("  {reason}"));
    }
    text
}

fn columns(cells: &[String; 8]) -> String {
    let padded = cells.each_ref().map(|cell| format!("{cell:>11}"));
    padded.concat()
}
