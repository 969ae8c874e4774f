//! Temperatures along lines as text.

use super::{Line, Temperatures};
use crate::output::number::significant as number;
use crate::output::report::{reasons, verdict};
use crate::output::summary::{Summary, line};

/// Maximum number of points of a line in a table.
const MOST_ROWS: usize = 11;

/// The profile below the point, and the surface temperatures along its row, as text.
pub(super) fn text(temperatures: &Temperatures) -> Summary {
    let mut text = Summary::titled(&temperatures.title);
    text.blank();
    let request = &temperatures.request;
    let millimetres = |value: f64| number(value / 1e-3);
    let [x, y] = request.point.map(millimetres);
    line(&mut text, &format!("below x = {x} mm, y = {y} mm"));
    table(&mut text, "depth (mm)", &temperatures.profile);
    text.blank();
    let [entry, exit] = request.passage.map(millimetres);
    let row = format!("on the surface along y = {y} mm, in contact from x = {entry} to {exit} mm");
    line(&mut text, &row);
    if let Some(surface) = temperatures.rows.first() {
        table(&mut text, "x (mm)", &surface.line);
        let largest = |values: &[f64]| number(values.iter().copied().fold(f64::MIN, f64::max));
        let Line { wheel, rail, .. } = &surface.line;
        line(
            &mut text,
            &format!("largest of these: wheel {} °C, rail {} °C", largest(wheel), largest(rail)),
        );
    }
    text.blank();
    let [wheel, rail] = temperatures.bulk.map(number);
    let verdict = verdict(temperatures.status);
    line(&mut text, &format!("{verdict}; bulk temperatures: wheel {wheel} °C, rail {rail} °C"));
    for reason in reasons(&temperatures.warnings) {
        line(&mut text, &format!("  {reason}"));
    }
    text
}

fn table(text: &mut Summary, position: &str, values: &Line) {
    line(text, &format!("{position:>12}{:>12}{:>12}", "wheel (°C)", "rail (°C)"));
    let last = values.position.len().saturating_sub(1);
    let rows = last.clamp(1, MOST_ROWS - 1);
    for k in (0..=rows.min(last)).map(|row| row * last / rows) {
        let entries = [values.position[k] / 1e-3, values.wheel[k], values.rail[k]].map(number);
        let [position, wheel, rail] = entries;
        line(text, &format!("{position:>12}{wheel:>12}{rail:>12}"));
    }
    if rows < last {
        line(text, &format!("  ({} of {} points; CSV and JSON have all)", rows + 1, last + 1));
    }
}
