//! The contacts of a wheelset as text.

use schlupf::wheel_rail::{Side, WheelSolution};

use super::{WheelsetAt, WheelsetReport};
use crate::output::number::significant as number;
use crate::output::report::{Report, reasons, verdict};
use crate::output::summary::{Summary, line};

/// A line for each position, and the equivalent conicity.
pub(super) fn text(report: &WheelsetReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    line(&mut text, "wheelset on both rails; contact with the largest normal force of each wheel");
    line(&mut text, &columns(HEAD.map(str::to_owned)));
    for at in &report.positions {
        let millimetres = |value: f64| number(1e3 * value);
        let side = |side: Side| {
            let wheel = at.wheel(side);
            let Some(contact) = wheel.and_then(|wheel| wheel.contacts.first()) else {
                return [(); 3].map(|()| number(None));
            };
            let several = if has_several(wheel) { "*" } else { "" };
            [
                millimetres(contact.rail_position) + several,
                number(contact.angle),
                number(1e-6 * contact.solution.normal.peak_pressure),
            ]
        };
        let [[a, b, c], [d, e, f]] = [Side::Left, Side::Right].map(side);
        let [difference, rigid] = [at.rolling_radius_difference(), at.rigid]
            .map(|difference| number(difference.map(|difference| 1e3 * difference)));
        let cells = [millimetres(at.lateral), difference, rigid, a, b, c, d, e, f];
        line(&mut text, &columns(cells));
        if let Err(error) = &at.wheels {
            line(&mut text, &format!("             failed: {error}"));
        }
    }
    let wheels = |at| [Side::Left, Side::Right].map(|side| WheelsetAt::wheel(at, side));
    if report.positions.iter().flat_map(wheels).any(has_several) {
        line(&mut text, "  * the wheel has several contacts; CSV and JSON have all");
    }
    line(&mut text, "  rail: position on the rail's profile in mm, outwards; angles in rad");
    text.blank();
    let curve = &report.conicity;
    line(&mut text, "equivalent conicity of rigid bodies   EN 15302   harmonic linearisation");
    for k in 0..curve.amplitude.len() {
        let amplitude = 1e3 * curve.amplitude[k];
        if (amplitude - amplitude.round()).abs() < 1e-6 {
            let [one, two] = [curve.nonlinear[k], curve.harmonic[k]].map(number);
            line(&mut text, &format!("{:>12} mm{one:>33}{two:>25}", number(amplitude)));
        }
    }
    if let Some(last) = curve.amplitude.last() {
        line(
            &mut text,
            &format!(
                "  EN 15302: wavelength of the nonlinear motion; from 1 to {} mm in the CSV",
                number(1e3 * last)
            ),
        );
    }
    text.blank();
    line(&mut text, verdict(report.status()));
    for reason in reasons(&report.warnings) {
        line(&mut text, &format!("  {reason}"));
    }
    text
}

/// Head of the table of positions.
const HEAD: [&str; 9] = [
    "y (mm)",
    "Δr (mm)",
    "rigid Δr",
    "rail left",
    "angle",
    "p0 (MPa)",
    "rail right",
    "angle",
    "p0 (MPa)",
];

fn has_several(wheel: Option<&WheelSolution>) -> bool {
    wheel.is_some_and(|wheel| wheel.contacts.len() > 1)
}

fn columns(cells: [String; 9]) -> String {
    cells.map(|cell| format!("{cell:>11}")).concat()
}
