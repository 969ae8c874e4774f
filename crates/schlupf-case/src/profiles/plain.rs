//! CSV with units, and two columns without.

use schlupf::message::shortened;

use super::points::{Content, File, Row, number, words};
use crate::error::CaseError;
use crate::fields::closest;
use crate::units::{Conversion, Measure, parse_unit};

const MILLIMETRE: f64 = 1e-3;

const COMMENTS: &[char] = &['#', '!', '%'];

/// What the header must be like.
const EXPECTED: &str = "y [m],z [m]";

const NAMES: [&str; 2] = ["y", "z"];

/// The points of a file whose header names `y` and `z` with their units, `y [mm],z [mm]` or
/// `y_mm,z_mm`, beside other columns, or of one without a header: y and z in mm. Where columns are
/// not apart by commas, numbers may have decimal commas.
pub fn read(file: &File) -> Result<Content, CaseError> {
    let first = file.lines(COMMENTS).find(|(_, line)| !line.is_empty());
    let Some((header_line, header)) = first else {
        return Err(file.error_of_all("the file must have points, but is empty"));
    };
    if Numbers::of(header).words.first().is_some_and(|word| number(word).is_some()) {
        return bare(file);
    }
    let table = Table::new(file, header_line, header)?;
    let rest = file.lines(COMMENTS).filter(|(line, text)| *line > header_line && !text.is_empty());
    let rows: Result<Vec<Row>, CaseError> =
        rest.map(|(line, text)| Ok(Row { place: table.row(file, line, text)?, line })).collect();
    Ok(Content::of("columns with units", rows?))
}

/// The columns of a file with a header.
struct Table {
    separator: Option<char>,
    count: usize,
    /// Places and units of y and z.
    wanted: [(usize, Conversion); 2],
}

impl Table {
    fn new(file: &File, line: usize, header: &str) -> Result<Self, CaseError> {
        let separator = [';', '\t', ','].into_iter().find(|sign| header.contains(*sign));
        // A unit may stand behind a space.
        let header = header.replace(" [", "[").replace(" (", "(");
        let names = cells(&header, separator);
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
        let cells = cells(text, self.separator);
        if cells.len() != self.count {
            let (given, expected) = (cells.len(), self.count);
            let message =
                format!("a row must have {expected} entries as the header, but has {given}");
            let help = (self.separator == Some(',') && given > expected).then(|| {
                "separate columns by semicolons if numbers have decimal commas".to_owned()
            });
            return Err(file.error(line, message).help(help));
        }
        let mut place = [0.0; 2];
        for (k, (column, convert)) in self.wanted.iter().enumerate() {
            let cell = cells[*column];
            let number = number(&cell.replace(',', ".")).ok_or_else(|| {
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
    let meant = names.iter().find(|cell| closest(&name(cell).0, [wanted].into_iter()).is_some());
    file.error(line, message).help(meant.map(|_| format!("name the column `{wanted} [mm]`")))
}

/// The cells of a line.
fn cells(line: &str, separator: Option<char>) -> Vec<&str> {
    let cells: Vec<&str> = match separator {
        Some(separator) => line.split(separator).collect(),
        None => line.split_whitespace().collect(),
    };
    cells.into_iter().map(|cell| cell.trim().trim_matches('"').trim()).collect()
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

/// The numbers of a line without a header.
struct Numbers {
    words: Vec<String>,
    has_decimal_commas: bool,
}

impl Numbers {
    fn of(line: &str) -> Self {
        let is_decimal = |word: &str| {
            let digits = |part: &str| part.trim_start_matches(['-', '+']).bytes().all(is_digit);
            word.split_once(',').is_some_and(|(whole, decimals)| {
                !decimals.is_empty() && digits(whole) && decimals.bytes().all(is_digit)
            })
        };
        let is_digit_or_sign = |word: &str| word.parse::<i64>().is_ok();
        let between = |separators: &[char]| -> Vec<String> {
            let words = line.split(separators).map(str::trim).filter(|word| !word.is_empty());
            words.map(str::to_owned).collect()
        };
        let apart = between(&[';', ' ', '\t']);
        let is_one = |word: &String| is_decimal(word) || is_digit_or_sign(word);
        let has_decimal_commas = apart.len() > 1
            && apart.iter().all(is_one)
            && apart.iter().any(|word| is_decimal(word));
        if has_decimal_commas {
            let words = apart.iter().map(|word| word.replace(',', ".")).collect();
            return Self { words, has_decimal_commas };
        }
        Self { words: words(line).map(str::to_owned).collect(), has_decimal_commas }
    }
}

fn is_digit(byte: u8) -> bool {
    byte.is_ascii_digit()
}

fn bare(file: &File) -> Result<Content, CaseError> {
    let mut rows = Vec::new();
    let mut has_decimal_commas = false;
    for (line, text) in file.lines(COMMENTS).filter(|(_, line)| !line.is_empty()) {
        let numbers = Numbers::of(text);
        has_decimal_commas |= numbers.has_decimal_commas;
        let values: Result<Vec<f64>, CaseError> =
            numbers.words.iter().map(|word| file.number(line, word)).collect();
        let [y, z] = values?[..] else {
            let count = numbers.words.len();
            let message = format!("a line must have y and z in mm, but has {count} numbers");
            let help = "a header such as `y [mm],z [mm],weight` names the columns".to_owned();
            return Err(file.error(line, message).help((count > 2).then_some(help)));
        };
        rows.push(Row { place: [y, z].map(|value| MILLIMETRE * value), line });
    }
    let remark = if has_decimal_commas { " with decimal commas" } else { "" };
    let format = format!("two columns without units{remark}");
    Ok(Content { has_units: false, ..Content::of(format, rows) })
}
