//! Tables over time.

use schlupf::problem::History;

use super::columns::{Column, Columns};
use super::layouts::HISTORY as COLUMNS;
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::{self, Requirement, readable};
use crate::names::FieldNames;

const FILE: FieldPath = field!("history.file");

/// What the numbers of a column must be: the same as in the array of its name.
fn requirement(column: &Column) -> Requirement {
    let field =
        fields::all().find(|field| field.section() == "history" && field.name() == column.name);
    field.map_or(Requirement::Finite, |field| field.requirement)
}

/// A history from a CSV file.
pub fn from_csv(name: String, bytes: Vec<u8>) -> Result<History, CaseError> {
    let columns = Columns::read(name, bytes, &FILE, &COLUMNS)?;
    for (column, values) in COLUMNS.iter().zip(&columns.values) {
        let requirement = requirement(column);
        let stray = values.iter().position(|value| !requirement.holds(*value));
        if let Some(row) = stray {
            let (name, value) = (column.name, readable(values[row]));
            let unit = column.unit();
            let requirement = requirement.text(unit, &FieldNames::CASE);
            let message = format!("{name} must be {requirement}, but is {value} {unit}");
            let error = columns.error(columns.lines[row], message.trim_end());
            return Err(error.help(fields::creepage_in_per_cent(name, values[row])));
        }
    }
    let history = history(columns.values.clone());
    check(&history).map_err(|(row, message)| {
        let line = columns.lines.get(row).copied().unwrap_or(columns.header_line);
        columns.error(line, message)
    })?;
    Ok(history)
}

/// Time, shifts, ξ, η, φ, v0, N, F_x, F_y, M_z to a history.
fn history(columns: Vec<Vec<f64>>) -> History {
    let mut columns = columns.into_iter();
    let time = columns.next().unwrap_or_default();
    let mut next = || columns.next().filter(|values| !values.is_empty());
    let (shift_x, shift_y, turn) = (next(), next(), next());
    let (creepage_x, creepage_y, spin) = (next(), next(), next());
    let (speed, load) = (next(), next());
    let (force_x, force_y, moment_z) = (next(), next(), next());
    let shifts = History { time, shift_x, shift_y, turn, ..History::default() };
    let motion = History { speed, creepage_x, creepage_y, spin, ..shifts };
    History { load, force_x, force_y, moment_z, ..motion }
}

/// Checks that times ascend, and that shifts are at rest; the error names the row.
pub fn check(history: &History) -> Result<(), (usize, String)> {
    let History { time, shift_x, shift_y, turn, .. } = history;
    let shifts = [shift_x, shift_y, turn].map(Option::as_deref);
    let fewest = if shifts.iter().any(Option::is_some) { 1 } else { 2 };
    if time.len() < fewest {
        let message =
            format!("a history must have at least {fewest} instants, but has {}", time.len());
        return Err((0, message));
    }
    for row in 1..time.len() {
        let (before, after) = (time[row - 1], time[row]);
        if after < before {
            let message = format!("time must ascend, but {after} s comes after {before} s");
            return Err((row, message));
        }
        if after > before && shifts.iter().flatten().any(|shifts| shifts[row] != 0.0) {
            let message = format!(
                "the wheel rolls until {after} s: a shift needs a row of its own, with the same \
                 time as the row before"
            );
            return Err((row, message));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<History, String> {
        from_csv("h.csv".to_owned(), text.as_bytes().to_vec()).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_are_converted() {
        let history = read("load [kN],time [ms],creepage_x\n80,0,0\n60,1,0.002\n").unwrap();
        assert_eq!(history.time, [0.0, 0.001]);
        assert_eq!(history.load, Some(vec![80e3, 60e3]));
        assert_eq!(history.creepage_x, Some(vec![0.0, 0.002]));
        assert_eq!(history.speed, None);
        // From rest, and nothing changes any more.
        assert_eq!(read("time [s]\n0\n1\n").unwrap().time, [0.0, 1.0]);
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let cases = [
            ("time [s],creepage_x\n0,0\n-1,1\n", "h.csv:3:1: time must ascend"),
            ("time [s],creepage_x\n0,0\n", "at least 2 instants"),
            ("time [s],shifts_x [mm]\n0,1\n1,1\n", "h.csv:3:1: the wheel rolls until 1 s"),
            ("time [s],load [kN]\n0,80\n1,0\n", "h.csv:3:1: load must be between"),
            ("time [s],creepage_x [mm]\n0,80\n1,0\n", "must be dimensionless"),
            ("time [s],creepage_y\n0,0\n1,2\n", "h.csv:3:1: creepage_y must be above -1"),
            ("time;creepage_x\n0;1\n", "columns must be separated by commas"),
        ];
        for (text, expected) in cases {
            let message = read(text).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
    }
}
