//! Temperatures along lines as a table.

use std::fmt::Write;

use super::{Line, Temperatures};
use crate::number::without_sign_of_zero;

const HEAD: &str = "# units: profile or row, m, m, m, degC, degC\n\
                    line,x,y,depth,temperature_wheel,temperature_rail\n";

/// All lines: a comment line (`#`) with the units, a header line, then one row per point, first those of the profile
/// below the point. Every number has the digits that give back the same number when read.
pub fn table(temperatures: &Temperatures) -> String {
    let mut table = HEAD.to_owned();
    let [x, y] = temperatures.request.point;
    lines(&mut table, "profile", &temperatures.profile, |depth| [x, y, depth]);
    for row in &temperatures.rows {
        lines(&mut table, "row", &row.line, |x| [x, y, row.depth]);
    }
    table
}

fn lines(table: &mut String, name: &str, line: &Line, place: impl Fn(f64) -> [f64; 3]) {
    for (k, position) in line.position.iter().enumerate() {
        let [x, y, depth] = place(*position).map(without_sign_of_zero);
        // Writing to a String cannot fail.
        let _ =
            writeln!(table, "{name},{x:e},{y:e},{depth:e},{:e},{:e}", line.wheel[k], line.rail[k]);
    }
}
