//! The tangential curves as a table.

use std::fmt::Write;

use super::RoughnessReport;
use crate::number::without_sign_of_zero;

const HEAD: &str = "# units: Pa, m, Pa, 1, 1, Pa/m, m, 1, 1; the last column is Eq. (8) with the k_c of this pressure\n\
                    mean_pressure,displacement,traction,normalised_traction,normalised_displacement,\
                    stiffness,micro_slip,sliding_fraction,exponential\n";

/// All curves: a comment line (`#`) with the units, a header line, then one row per point, curve after
/// curve. Every number has the digits that give back the same number when read.
pub fn table(report: &RoughnessReport) -> String {
    let mut table = HEAD.to_owned();
    let result = &report.result;
    for (curve, fit) in result.tangential.iter().zip(&result.stiffness.fits) {
        for point in &curve.points {
            let values = [
                curve.mean_pressure,
                point.displacement,
                point.traction,
                point.normalised_traction,
                point.normalised_displacement,
                point.stiffness,
                point.micro_slip,
                point.sliding_fraction,
                -(-fit.stiffness * point.displacement).exp_m1(),
            ];
            let cells = values.map(|value| format!("{:e}", without_sign_of_zero(value)));
            // Writing to a String cannot fail.
            let _ = writeln!(table, "{}", cells.join(","));
        }
    }
    table
}
