//! Creep curves as a table, one row per point.

use std::fmt::Write;

use schlupf::creep_curve::{Abscissa, Point};

use super::CurveFamily;
use crate::json::status;
use crate::number::without_sign_of_zero;

/// Name, unit, and how to get the number.
type Column = (&'static str, &'static str, fn(&Point) -> f64);

const COLUMNS: [Column; 19] = [
    ("creepage_x", "1", |point| point.kinematics.creepage_x),
    ("creepage_y", "1", |point| point.kinematics.creepage_y),
    ("spin", "1/m", |point| point.kinematics.spin),
    ("force_x", "N", |point| point.force.x),
    ("force_y", "N", |point| point.force.y),
    ("moment_z", "N m", |point| point.force.moment_z),
    ("normalised_x", "1", |point| point.normalised.x),
    ("normalised_y", "1", |point| point.normalised.y),
    ("normalised_moment_z", "1", |point| point.normalised.moment_z),
    ("traction_coefficient", "1", |point| point.traction_coefficient),
    ("friction_power", "W", |point| point.power.friction),
    ("creep_power", "W", |point| point.power.creep),
    ("max_rise", "K", |point| point.max_rise),
    ("contact_area", "m^2", |point| point.area.contact),
    ("stick_area", "m^2", |point| point.area.stick),
    ("slip_area", "m^2", |point| point.area.slip),
    ("residual", "1", |point| point.residual),
    ("newton_iterations", "1", |point| point.work.newton_iterations as f64),
    ("operator_products", "1", |point| point.work.operator_products),
];

/// All points of all curves: a comment line (`#`) with the units, a header line, then one row per point.
/// The first column is the field in which the curves differ, if there is one; then comes the total
/// creepage where the curves run in a fixed direction. Every number has the digits that give back the
/// same number when read.
pub fn table(family: &CurveFamily) -> String {
    let total: Option<Column> = family
        .abscissa()
        .filter(|abscissa| matches!(abscissa, Abscissa::Total { .. }))
        .map(|abscissa| (abscissa.name(), "1", (|point| point.abscissa) as fn(&Point) -> f64));
    let columns: Vec<&Column> = total.iter().chain(&COLUMNS).collect();
    let over = family.over.as_deref();
    let units = over.map(|_| "as given").into_iter().chain(columns.iter().map(|column| column.1));
    let names = over.into_iter().chain(columns.iter().map(|column| column.0));
    let mut table = format!(
        "# units: {}, converged or not-converged; forces on the wheel\n{},status\n",
        units.collect::<Vec<_>>().join(", "),
        names.collect::<Vec<_>>().join(",")
    );
    for member in &family.members {
        for point in &member.curve.points {
            if over.is_some() {
                let value = member.value.as_deref().unwrap_or_default();
                // Writing to a String cannot fail.
                let _ = write!(table, "{},", quoted(value));
            }
            for (_, _, value) in &columns {
                let _ = write!(table, "{:e},", without_sign_of_zero(value(point)));
            }
            let _ = writeln!(table, "{}", status(point.status));
        }
    }
    table
}

/// A text in quotes where it would not be one entry without (RFC 4180).
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r', '#']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
