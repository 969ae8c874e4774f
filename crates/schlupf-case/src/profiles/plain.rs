//! CSV with units, and two columns without.

use super::points::File;
use crate::error::CaseError;
use crate::tables::columns::{Column, Columns};
use crate::units::Measure;

const MILLIMETRE: f64 = 1e-3;

const WANTED: [Column; 2] = [
    Column { name: "y", measure: Some(&Measure::LENGTH), required: true, holes: false },
    Column { name: "z", measure: Some(&Measure::LENGTH), required: true, holes: false },
];

/// The points of a file whose header names `y` and `z` with their units, `y [mm],z [mm]` or
/// `y_mm,z_mm`, or of one without a header: y and z in mm.
pub fn read(file: &File) -> Result<Vec<[f64; 2]>, CaseError> {
    let first = file.lines(&['#', '!', '%']).find(|(_, line)| !line.is_empty());
    let Some((header_line, header)) = first else {
        return Err(file.error_of_all("the file must have points, but is empty"));
    };
    let begins_with_number = header
        .split([' ', '\t', ',', ';'])
        .find(|word| !word.is_empty())
        .is_some_and(|word| word.parse::<f64>().is_ok());
    if begins_with_number {
        return bare(file);
    }
    let text = with_units(&file.source.text, header_line);
    let columns = Columns::read(file.source.name.clone(), text.into_bytes(), file.field, &WANTED)?;
    let [y, z] = [&columns.values[0], &columns.values[1]];
    Ok(y.iter().zip(z).map(|(y, z)| [*y, *z]).collect())
}

/// The same text with `y_mm` in its header written as `y [mm]`.
fn with_units(text: &str, header_line: usize) -> String {
    let cell = |cell: &str| match cell.trim().split_once('_') {
        Some((name @ ("y" | "z"), unit)) => format!("{name} [{unit}]"),
        _ => cell.to_owned(),
    };
    let line = |(number, line): (usize, &str)| {
        if number == header_line {
            line.split(',').map(cell).collect::<Vec<_>>().join(",")
        } else {
            line.to_owned()
        }
    };
    (1..).zip(text.lines()).map(line).collect::<Vec<_>>().join("\n")
}

fn bare(file: &File) -> Result<Vec<[f64; 2]>, CaseError> {
    let mut points = Vec::new();
    for (number, line) in file.lines(&['#', '!', '%']).filter(|(_, line)| !line.is_empty()) {
        let numbers = file.numbers(number, line)?;
        let [y, z] = numbers[..] else {
            let message =
                format!("a line must have y and z in mm, but has {} numbers", numbers.len());
            return Err(file.error(number, message));
        };
        points.push([MILLIMETRE * y, MILLIMETRE * z]);
    }
    Ok(points)
}
