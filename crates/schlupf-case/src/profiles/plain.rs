//! CSV with units, and two columns without.

use schlupf::reporting::shortened;

use super::points::{Content, File, Row, Separator, begins_with_number, number};
use crate::error::CaseError;
use crate::fields::closest;
use crate::tables::TableColumn as Column;
use crate::units::{Conversion, Measure, parse_unit};

const MILLIMETRE: f64 = 1e-3;

const COMMENTS: &[char] = &['#', '!', '%'];

/// What the header must be like.
const EXPECTED: &str = "y [m],z [m]";

const NAMES: [&str; 2] = ["y", "z"];

/// The columns that a file with a header needs.
pub const COLUMNS: [Column; 2] = [coordinate(NAMES[0]), coordinate(NAMES[1])];

const fn coordinate(name: &'static str) -> Column {
    Column { name, measure: Some(&Measure::LENGTH), required: true, holes: false }
}

/// The points of a file whose header names `y` and `z` with their units, `y [mm],z [mm]` or
/// `y_mm,z_mm`, beside other columns, or of one without a header: y and z in mm. Where columns are
/// not separated by commas, numbers may have decimal commas.
pub fn read(file: &File) -> Result<Content, CaseError> {
    let first = file.lines(COMMENTS).find(|(_, line)| !line.is_empty());
    let Some((header_line, header)) = first else {
        return Err(file.error_of_all("the file must have points, but is empty"));
    };
    if begins_with_number(header) {
        return bare(file);
    }
    let table = Table::new(file, header_line, header)?;
    let rest =
        || file.lines(COMMENTS).filter(|(line, text)| *line > header_line && !text.is_empty());
    let rows: Result<Vec<Row>, CaseError> =
        rest().map(|(line, text)| Ok(Row { place: table.row(file, line, text)?, line })).collect();
    let remark = table.separator.remark(rest().map(|(_, text)| text));
    Ok(Content::of(format!("columns with units{remark}"), rows?))
}

/// The columns of a file with a header.
struct Table {
    separator: Separator,
    count: usize,
    /// Places and units of y and z.
    wanted: [(usize, Conversion); 2],
}

impl Table {
    fn new(file: &File, line: usize, header: &str) -> Result<Self, CaseError> {
        let separator = [';', '\t', ','].into_iter().find(|sign| header.contains(*sign));
        let separator = separator.map_or(Separator::Spaces, Separator::Character);
        // A unit may stand behind a space.
        let header = header.replace(" [", "[").replace(" (", "(");
        let names = separator.cells(&header, 0);
        let split: Vec<(String, Option<&str>)> = names.iter().map(|cell| name(cell)).collect();
        let find = |wanted: &str| -> Result<(usize, Conversion), CaseError> {
            let mut places = (0..split.len()).filter(|k| split[*k].0 == wanted);
            let Some(place) = places.next() else {
                return Err(missing(file, line, wanted, &names));
            };
            if places.next().is_some() {
                return Err(file.error(line, format!("column `{wanted}` is given twice")));
            }
            let unit = split[place].1.unwrap_or_default();
            let convert = parse_unit(unit, &Measure::LENGTH).map_err(|error| {
                let examples = Measure::LENGTH.examples;
                let message = format!(
                    "column `{wanted}` must name its unit, {examples}, as in `{wanted} [mm]`: {error}"
                );
                file.error(line, message)
            })?;
            Ok((place, convert))
        };
        let [y, z] = NAMES;
        Ok(Self { separator, count: names.len(), wanted: [find(y)?, find(z)?] })
    }

    /// y and z of a row, in m.
    fn row(&self, file: &File, line: usize, text: &str) -> Result<[f64; 2], CaseError> {
        let cells = self.separator.cells(text, self.count);
        if cells.len() != self.count {
            let (given, expected) = (cells.len(), self.count);
            let message =
                format!("a row must have {expected} entries as the header, but has {given}");
            let help = self.separator.help(&cells).filter(|_| given > expected);
            return Err(file.error(line, message).help(help));
        }
        let mut place = [0.0; 2];
        for (k, (column, convert)) in self.wanted.iter().enumerate() {
            let cell = cells[*column];
            let number = number(cell).ok_or_else(|| {
                let (name, cell) = (NAMES[k], shortened(cell));
                file.error(line, format!("{name} must be a finite number, but is {cell:?}"))
            })?;
            place[k] = convert.apply(number);
        }
        Ok(place)
    }
}

/// A header without one of its columns.
fn missing(file: &File, line: usize, wanted: &str, names: &[&str]) -> CaseError {
    let given = names.iter().map(|name| format!("`{}`", shortened(name)));
    let given = given.take(6).collect::<Vec<_>>().join(", ");
    let message = format!(
        "the header must be such as `{EXPECTED}`, but has no column `{wanted}` beside {given}"
    );
    let has = |wanted: &str| names.iter().any(|cell| name(cell).0 == wanted);
    let is_meant = |cell: &&str| closest(&name(cell).0, [wanted].into_iter()).is_some();
    let help = if has("x") && has("y") {
        format!("if x is lateral and y vertical, name them `{EXPECTED}`")
    } else if names.iter().any(is_meant) {
        format!("name the column `{wanted} [mm]`")
    } else {
        "a line that is no header must be a comment, which begins with #".to_owned()
    };
    file.error(line, message).help(help)
}

/// Name, in small letters, and unit of a column: `Y [mm]`, `y (mm)` or `y_mm`.
fn name(cell: &str) -> (String, Option<&str>) {
    let within = |open: char, close: char| cell.strip_suffix(close)?.split_once(open);
    let below =
        || cell.split_once('_').filter(|(name, _)| NAMES.contains(&name.to_lowercase().as_str()));
    let split = within('[', ']').or_else(|| within('(', ')')).or_else(below);
    let (name, unit) = split.map_or((cell, None), |(name, unit)| (name, Some(unit.trim())));
    (name.trim().to_lowercase(), unit)
}

fn bare(file: &File) -> Result<Content, CaseError> {
    let lines: Vec<(usize, &str)> =
        file.lines(COMMENTS).filter(|(_, line)| !line.is_empty()).collect();
    let texts = lines.iter().map(|(_, text)| *text);
    let separator = Separator::of(&texts);
    let mut rows = Vec::with_capacity(lines.len());
    for (line, text) in &lines {
        let cells = separator.cells(text, NAMES.len());
        let numbers: Result<Vec<f64>, CaseError> =
            cells.iter().map(|cell| file.number(*line, cell)).collect();
        let [y, z] = numbers?[..] else {
            let count = cells.len();
            let message = format!("a line must have y and z in mm, but has {count} numbers");
            let header = "a header such as `y [mm],z [mm],weight` names the columns".to_owned();
            let help = separator.help(&cells).unwrap_or(header);
            return Err(file.error(*line, message).help((count > NAMES.len()).then_some(help)));
        };
        rows.push(Row { place: [y, z].map(|value| MILLIMETRE * value), line: *line });
    }
    let format = format!("two columns without units{}", separator.remark(texts));
    Ok(Content { has_units: false, ..Content::of(format, rows) })
}
