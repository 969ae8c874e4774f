//! Tables of normal pressure on an equidistant lattice.

use schlupf::normal::PressureTable;

use super::columns::Columns;
use super::lattice::{self, FILE, NpyFile};
use super::layouts::PRESSURE as COLUMNS;
use crate::error::CaseError;
use crate::names::FieldNames;

/// A table from a CSV file with columns x, y and pressure, its rows in any order.
pub fn from_csv(name: String, bytes: Vec<u8>) -> Result<PressureTable, CaseError> {
    let columns = Columns::read(name, bytes, &FILE, &COLUMNS)?;
    let [xs, ys, pressures] = &columns.values[..] else {
        return Err(columns.error(columns.header_line, "three columns are needed"));
    };
    if let Some(row) = pressures.iter().position(|pressure| *pressure < 0.0) {
        let at = lattice::point(xs[row], ys[row]);
        let message =
            format!("pressure must not be negative, but is {} Pa at {at}", pressures[row]);
        return Err(columns.error(columns.lines[row], message));
    }
    let help = "give pressure 0 outside the contact";
    let table = lattice::from_columns(&columns, [xs, ys, pressures], help)?;
    PressureTable::new(&table.x, &table.y, table.values)
        .map_err(|error| columns.error(columns.header_line, error.text(&FieldNames::CASE)))
}

/// A table from an .npy file, in Pa.
pub fn from_npy(file: &NpyFile) -> Result<PressureTable, CaseError> {
    let legal = |value: f64| value.is_finite() && value >= 0.0;
    let table = file.table(legal, "finite pressures that are not negative")?;
    PressureTable::new(&table.x, &table.y, table.values)
        .map_err(|cause| file.error(&format!("is no table: {cause}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "# measured\nx [mm],y [mm],pressure [MPa]\n\
                        1,0,2\n0,0,1\n2,0,3\n# half way\n0,0.5,4\n1,0.5,5\n2,0.5,6\n";

    fn read(text: &str) -> Result<PressureTable, String> {
        from_csv("p.csv".to_owned(), text.as_bytes().to_vec()).map_err(|error| error.to_string())
    }

    #[test]
    fn rows_may_come_in_any_order() {
        let table = read(GOOD).unwrap();
        let sorted = "x [m],y [m],pressure [Pa]\n0,0,1e6\n1e-3,0,2e6\n2e-3,0,3e6\n\
                      0,5e-4,4e6\n1e-3,5e-4,5e6\n2e-3,5e-4,6e6\n";
        let [first, second] = [table, read(sorted).unwrap()].map(|table| table.load());
        assert!((first - second).abs() < 1e-9 * first);
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let cases = [
            ("1,0,2\n", "", "p.csv:3:1: the points must fill a rectangle of 3 by 2"),
            ("2,0.5,6", "1,0.5,6", "p.csv:9:1: every point must be given once"),
            ("0,0,1", "0,0,-1", "p.csv:4:1: pressure must not be negative"),
            ("0,0,1", "0,0,nan", "p.csv:4:1: pressure must be a finite number, but is \"nan\""),
            ("0,0,1", "0,0,", "p.csv:4:1: pressure must be a finite number, but is \"\""),
            ("0,0,1", "0,0", "p.csv:4:1: a row must have 3 entries"),
            ("1,0,2", "1.3,0,2", "p.csv:3:1: x must be equidistant"),
            ("[MPa]", "", "p.csv:2:1: column `pressure` must name its unit, Pa, MPa or GPa"),
            ("[MPa]", "[mm]", "`mm` is the unit of a length"),
            ("pressure", "presure", "did you mean `pressure`?"),
            ("y [mm],", "", "p.csv:2:1: column `y` is missing"),
            ("y [mm]", "x [mm]", "p.csv:2:1: column `x` is given twice"),
            (GOOD, "# nothing", "p.csv:1:1: normal.file must have a header"),
            (GOOD, "x [mm],y [mm],pressure [MPa]\n", "has no rows"),
            (GOOD, "x [mm],y [mm],pressure [MPa]\n0,0,1\n1,0,1\n", "y must have at least two"),
        ];
        for (from, to, expected) in cases {
            let message = read(&GOOD.replacen(from, to, 1)).unwrap_err();
            assert!(message.contains(expected), "{from:?} -> {to:?}: {message}");
        }
    }
}
