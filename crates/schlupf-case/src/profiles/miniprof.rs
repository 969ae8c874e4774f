//! Miniprof's profiles, `.ban` and `.whl`: lines `Key=Value`, then rows of numbers in mm, y
//! upwards. `ColumnDef` names the columns; without it the first two are X and Y.

use super::points::File;
use crate::error::CaseError;
use schlupf::message::quoted;

const MILLIMETRE: f64 = 1e-3;

const COLUMNS: &str = "ColumnDef";

/// Whether a file has the head of one of Miniprof's.
pub fn is_one(file: &File) -> bool {
    file.lines(&[]).any(|(_, line)| {
        line.split_once('=').is_some_and(|(key, _)| key.trim().eq_ignore_ascii_case(COLUMNS))
    })
}

/// The points of a file, in m, z up.
pub fn read(file: &File) -> Result<Vec<[f64; 2]>, CaseError> {
    let mut columns = [0, 1];
    let mut offset = [0.0; 2];
    let mut points = Vec::new();
    for (number, line) in file.lines(&['!', '#', '%']).filter(|(_, line)| !line.is_empty()) {
        if let Some((key, value)) = line.split_once('=') {
            match key.trim().to_ascii_lowercase().as_str() {
                "columndef" => columns = column_places(file, number, value)?,
                "xoffset" => offset[0] = file.number(number, value.trim())?,
                "yoffset" => offset[1] = file.number(number, value.trim())?,
                _ => {}
            }
            continue;
        }
        let is_number = |word: &str| word.parse::<f64>().is_ok();
        let first = line.split([' ', '\t', ',', ';']).find(|word| !word.is_empty());
        if points.is_empty() && !first.is_some_and(is_number) {
            // Old files have keys without values.
            continue;
        }
        let numbers = file.numbers(number, line)?;
        let last = columns[0].max(columns[1]);
        if numbers.len() <= last {
            let (needed, given) = (last + 1, numbers.len());
            let message = format!("a row must have at least {needed} numbers, but has {given}");
            return Err(file.error(number, message));
        }
        points.push([0, 1].map(|k| MILLIMETRE * (numbers[columns[k]] + offset[k])));
    }
    if points.is_empty() {
        return Err(file.error_of_all("a Miniprof profile must have rows of X and Y, but has none"));
    }
    Ok(points)
}

/// Places of the columns X and Y.
fn column_places(file: &File, line: usize, definition: &str) -> Result<[usize; 2], CaseError> {
    let names: Vec<&str> = definition.split(',').map(str::trim).collect();
    let place = |wanted: &str| {
        let place = names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        place.ok_or_else(|| {
            file.error(
                line,
                format!("{COLUMNS} must name a column {wanted}, but is {}", quoted(definition)),
            )
        })
    };
    Ok([place("X")?, place("Y")?])
}
