//! Points below the surface.

use super::columns::{Column, Columns};
use crate::error::CaseError;
use crate::fields::readable;
use crate::files::InputFile;
use crate::units::Measure;

const fn length(name: &'static str) -> Column {
    Column { name, measure: Some(&Measure::LENGTH), required: true, holes: false }
}

/// The columns of a table of points.
pub const COLUMNS: [Column; 3] = [length("x"), length("y"), length("depth")];

/// Most points of a table: each is a sum over all cells.
const MOST: usize = 1_000_000;

/// Points may be so far away, in m.
const FARTHEST: f64 = 1e3;

/// Points below the surface, each with x, y and depth in m, of a CSV file that `option` names.
///
/// # Errors
/// A file that cannot be read, columns that are missing or misnamed, a point above the surface,
/// none at all, and more than a million.
pub fn read(option: &str, file: &InputFile) -> Result<Vec<[f64; 3]>, CaseError> {
    let name = file.path().display().to_string();
    let what = "the table of points";
    let bytes = file.read().map_err(|error| CaseError::unreadable("", what, &name, &error))?;
    let columns = Columns::read(name, bytes, option, &COLUMNS)?;
    let error =
        |text: &str| Err(columns.error(columns.header_line, format!("{option} must have {text}")));
    match columns.lines.len() {
        0 => return error("points"),
        count if count > MOST => {
            return error(&format!("at most {MOST} points, but has {count}"));
        }
        _ => {}
    }
    for (column, values) in COLUMNS.iter().zip(&columns.values) {
        let least = if column.name == "depth" { 0.0 } else { -FARTHEST };
        for (value, line) in values.iter().zip(&columns.lines) {
            if (least..=FARTHEST).contains(value) {
                continue;
            }
            let (name, value) = (column.name, readable(*value));
            let text = format!("{name} must be between {least} and {FARTHEST} m, but is {value} m");
            let above = (name == "depth")
                .then(|| "it counts from the surface into the body, in wheel and rail".to_owned());
            return Err(columns.error(*line, text).help(above));
        }
    }
    let value = |column: usize, row: usize| columns.values[column][row];
    Ok((0..columns.lines.len()).map(|row| std::array::from_fn(|c| value(c, row))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(text: &str) -> Result<Vec<[f64; 3]>, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.csv");
        std::fs::write(&path, text).unwrap();
        read("--points", &InputFile::at(&path)).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_have_any_order_and_units() {
        let points = read_text("depth [um],y [m],x [mm]\n# on the surface\n0,0.5,-2\n250,0,1\n");
        assert_eq!(points, Ok(vec![[-2e-3, 0.5, 0.0], [1e-3, 0.0, 250e-6]]));
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let head = "x [mm],y [mm],depth [mm]\n";
        for (text, expected) in [
            (format!("{head}0,0,1\n0,0,-1\n"), "p.csv:3:1: depth must be between 0 and 1000 m"),
            (format!("{head}0,0,-1\n"), "from the surface into the body"),
            (format!("{head}0,2e6,1\n"), "p.csv:2:1: y must be between -1000 and 1000 m"),
            (format!("{head}0,0\n"), "p.csv:2:1: a row must have 3 entries"),
            (format!("{head}0,far,0\n"), "p.csv:2:1: y must be a finite number"),
            (head.to_owned(), "--points must have points"),
            (String::new(), "--points must have a header such as `x [m],y [m],depth [m]`"),
            ("x [mm],y [mm],z [mm]\n".to_owned(), "has a column `z [mm]`"),
            ("x [mm],y [mm]\n".to_owned(), "column `depth` is missing"),
            ("x,y,depth\n".to_owned(), "column `x` must name its unit"),
        ] {
            let message = read_text(&text).unwrap_err();
            assert!(message.contains(expected), "{expected:?} is not in {message}");
        }
    }
}
