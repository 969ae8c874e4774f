//! A comparison as a table, one row for each method.

use std::fmt::Write;

use super::{Answer, Comparison};
use crate::number::without_sign_of_zero;

/// Name, unit, and how to get the number.
type Column = (&'static str, &'static str, fn(&Answer) -> f64);

const COLUMNS: [Column; 11] = [
    ("force_x", "N", |answer| answer.solution.force.x),
    ("force_y", "N", |answer| answer.solution.force.y),
    ("moment_z", "N m", |answer| answer.solution.force.moment_z),
    ("normalised_x", "1", |answer| answer.solution.normalised.x),
    ("normalised_y", "1", |answer| answer.solution.normalised.y),
    ("normalised_moment_z", "1", |answer| answer.solution.normalised.moment_z),
    ("traction_coefficient", "1", |answer| answer.solution.traction_coefficient),
    ("creep_power", "W", |answer| answer.solution.power.creep),
    ("max_rise", "K", |answer| answer.solution.temperature.max_rise),
    ("time", "s", |answer| answer.time),
    ("time_again", "s", |answer| answer.time_again),
];

/// All methods: a comment line (`#`) with the units, a header line, then one row for each. What a method does
/// not know is empty, all numbers where it has no answer. Every other number has the digits that give back the
/// same number when read.
pub fn table(comparison: &Comparison) -> String {
    let units: Vec<&str> = COLUMNS.iter().map(|column| column.1).collect();
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.0).collect();
    let mut table = format!(
        "# units: name, name, {}, converged or not-converged or not-available, text; forces on the wheel\n\
         method,elasticity,{},status,reason\n",
        units.join(", "),
        names.join(",")
    );
    for entry in &comparison.entries {
        // Writing to a String cannot fail.
        let _ = write!(table, "{},{},", entry.method, entry.elasticity.unwrap_or_default());
        for (_, _, value) in COLUMNS {
            let value = entry.answer.as_ref().map_or(f64::NAN, value);
            if value.is_finite() {
                let _ = write!(table, "{:e}", without_sign_of_zero(value));
            }
            table.push(',');
        }
        let _ = writeln!(table, "{},{}", entry.status(), quoted(entry.reason()));
    }
    table
}

/// A text as an entry of a CSV file, empty where there is none.
fn quoted(text: Option<&str>) -> String {
    text.map(|text| format!("\"{}\"", text.replace('"', "\"\""))).unwrap_or_default()
}
