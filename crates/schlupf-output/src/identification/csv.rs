//! The points of a fit as a table.

use std::fmt::Write;

use schlupf::identification::FittedPoint;

use super::{FitReport, component};
use crate::number::without_sign_of_zero;

/// All points: a comment line (`#`) with the units, a header line, then one row per measured force. Every
/// number has the digits that give back the same number when read; a standard deviation that is not
/// known is left empty.
pub fn table(report: &FitReport) -> String {
    let mut table =
        "# units: 1, 1, 1/m, m/s, N, x or y, 1, 1, 1, 1; forces on the rail over the load, \
                     residual = measured - fitted\n\
                     creepage_x,creepage_y,spin,speed,load,component,force_ratio,fitted,residual,\
                     standard_deviation\n"
            .to_owned();
    for point in &report.fit.points {
        row(&mut table, report, point);
    }
    table
}

fn row(table: &mut String, report: &FitReport, point: &FittedPoint) {
    let motion = &point.data.condition.kinematics;
    let place =
        [motion.creepage_x, motion.creepage_y, motion.spin, motion.speed, report.load_of(point)];
    let forces = [point.data.force_ratio, point.fitted, point.residual()];
    // Writing to a String cannot fail.
    for number in place {
        let _ = write!(table, "{:e},", without_sign_of_zero(number));
    }
    let _ = write!(table, "{},", component(point.data.component));
    for number in forces {
        let _ = write!(table, "{:e},", without_sign_of_zero(number));
    }
    match point.data.standard_deviation {
        Some(deviation) => {
            let _ = writeln!(table, "{deviation:e}");
        }
        None => table.push('\n'),
    }
}
