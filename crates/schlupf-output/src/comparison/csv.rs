//! A comparison as a table, one row for each method.

use std::fmt::Write;

use super::{Comparison, Entry};
use crate::json::status;
use crate::number::without_sign_of_zero;

/// Name, unit, and how to get the number.
type Column = (&'static str, &'static str, fn(&Entry) -> f64);

const COLUMNS: [Column; 11] = [
    ("force_x", "N", |entry| entry.solution.force.x),
    ("force_y", "N", |entry| entry.solution.force.y),
    ("moment_z", "N m", |entry| entry.solution.force.moment_z),
    ("normalised_x", "1", |entry| entry.solution.normalised.x),
    ("normalised_y", "1", |entry| entry.solution.normalised.y),
    ("normalised_moment_z", "1", |entry| entry.solution.normalised.moment_z),
    ("traction_coefficient", "1", |entry| entry.solution.traction_coefficient),
    ("creep_power", "W", |entry| entry.solution.power.creep),
    ("max_rise", "K", |entry| entry.solution.temperature.max_rise),
    ("time", "s", |entry| entry.time),
    ("time_again", "s", |entry| entry.time_again),
];

/// All methods: a comment line (`#`) with the units, a header line, then one row for each. What a method does
/// not know is empty. Every other number has the digits that give back the same number when read.
pub fn table(comparison: &Comparison) -> String {
    let units: Vec<&str> = COLUMNS.iter().map(|column| column.1).collect();
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.0).collect();
    let mut table = format!(
        "# units: name, name, {}, converged or not-converged; forces on the wheel\n\
         method,elasticity,{},status\n",
        units.join(", "),
        names.join(",")
    );
    for entry in &comparison.entries {
        let elasticity = entry.elasticity.unwrap_or_default();
        // Writing to a String cannot fail.
        let _ = write!(table, "{},{elasticity},", entry.solution.method.name());
        for (_, _, value) in COLUMNS {
            let value = value(entry);
            if value.is_finite() {
                let _ = write!(table, "{:e}", without_sign_of_zero(value));
            }
            table.push(',');
        }
        let _ = writeln!(table, "{}", status(entry.solution.status));
    }
    table
}
