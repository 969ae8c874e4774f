//! Tables over y.

use super::columns::Columns;
use super::layouts::VARIATION as COLUMNS;
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::readable;
use crate::names::FieldNames;

const FILE: FieldPath = field!("friction.variation_file");

/// Fields whose arrays hold the same.
const FIELDS: [FieldPath; 2] = fields!["friction.variation_y", "friction.variation_factor"];

/// Positions (in m) and factors from a CSV file.
pub fn from_csv(name: String, bytes: Vec<u8>) -> Result<[Vec<f64>; 2], CaseError> {
    let columns = Columns::read(name, bytes, &FILE, &COLUMNS)?;
    for ((column, values), field) in COLUMNS.iter().zip(&columns.values).zip(FIELDS) {
        let requirement = field.field().requirement;
        if let Some(row) = values.iter().position(|value| !requirement.holds(*value)) {
            let (name, value) = (column.name, readable(values[row]));
            let unit = column.unit();
            let requirement = requirement.text(unit, &FieldNames::CASE);
            let message = format!("{name} must be {requirement}, but is {value} {unit}");
            return Err(columns.error(columns.lines[row], message.trim_end()));
        }
    }
    let steps_back = columns.values[0].windows(2).position(|pair| pair[1] <= pair[0]);
    if let Some(row) = steps_back {
        let [before, after] = [row, row + 1].map(|row| readable(columns.values[0][row] * 1e3));
        let message = format!("y must ascend, but {after} mm comes after {before} mm");
        return Err(columns.error(columns.lines[row + 1], message));
    }
    if columns.lines.len() < 2 {
        let message =
            format!("{FILE} must have at least two rows, but has {}", columns.lines.len());
        return Err(columns.error(columns.header_line, message));
    }
    let mut values = columns.values.into_iter();
    Ok([(); 2].map(|()| values.next().unwrap_or_default()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<[Vec<f64>; 2], String> {
        from_csv("f.csv".to_owned(), text.as_bytes().to_vec()).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_are_converted() {
        let [y, factor] = read("factor,y [mm]\n0.5,-4\n# centre\n1,0\n").unwrap();
        assert_eq!((y, factor), (vec![-4e-3, 0.0], vec![0.5, 1.0]));
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let cases = [
            ("y [mm],factor\n0,1\n0,1\n", "f.csv:3:1: y must ascend, but 0 mm comes after 0 mm"),
            ("y [mm],factor\n0,1\n1,-0.1\n", "f.csv:3:1: factor must be between 0 and 100"),
            ("y [km],factor\n0,1\n1,1\n", "f.csv:3:1: y must be finite and at most ±100 m"),
            ("y [mm],factor\n0,1\n", "f.csv:1:1: friction.variation_file must have at least two"),
            ("y,factor\n0,1\n1,1\n", "f.csv:1:1: column `y` must name its unit, m, mm"),
            ("y [mm],factor [mm]\n0,1\n1,1\n", "must be dimensionless"),
            ("y [mm],coefficient\n0,1\n1,1\n", "has a column `coefficient`"),
            ("y [mm]\n0\n1\n", "column `factor` is missing"),
        ];
        for (text, expected) in cases {
            let message = read(text).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
    }
}
