//! The fields as a table, one row per contact cell.

use std::fmt::Write;

use schlupf::solution::{Fields, Solution};

use crate::number::without_sign_of_zero;

const COLUMNS: &str = "x,y,pressure,traction_x,traction_y,slip_x,slip_y,friction_coefficient,\
                       friction_power,temperature_rise_wheel,temperature_rise_rail,sliding";
const UNITS: &str = "# units: m, m, Pa, Pa, Pa, m/s, m/s, 1, W/m^2, K, K, 0 or 1; tractions on the \
                     wheel, positions are centroids of the covered part of a cell";

/// The fields of all contact cells: a comment line (`#`) with the units, a header line, then one row
/// per cell. Every number has the digits that give back the same number when read.
pub fn fields(solution: &Solution) -> String {
    let fields = &solution.fields;
    let mut table = format!("{UNITS}\n{COLUMNS}\n");
    for cell in 0..fields.len() {
        row(&mut table, fields, cell);
    }
    table
}

fn row(table: &mut String, fields: &Fields, cell: usize) {
    let columns = [
        &fields.x,
        &fields.y,
        &fields.pressure,
        &fields.traction_x,
        &fields.traction_y,
        &fields.slip_x,
        &fields.slip_y,
        &fields.friction_coefficient,
        &fields.friction_power,
        &fields.temperature_rise_wheel,
        &fields.temperature_rise_rail,
    ];
    for column in columns {
        // The shortest text that reads back as the same number. Writing to a String cannot fail.
        let _ = write!(table, "{:e},", without_sign_of_zero(column[cell]));
    }
    table.push_str(if fields.sliding[cell] { "1\n" } else { "0\n" });
}
