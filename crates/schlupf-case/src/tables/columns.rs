//! CSV files whose header names columns and their units, such as `x [mm],pressure [MPa]`.

use std::sync::Arc;

use schlupf::reporting::{quoted, shortened};

use super::records::Records;
use crate::error::CaseError;
use crate::fields::{NOT_PER_CENT, closest, is_per_cent};
use crate::place::{INDEX, Place, Source};
use crate::units::{Conversion, Measure, comma, comma_readings, parse_unit};

/// A column that a file may have.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Its name in the header.
    pub name: &'static str,
    /// What it measures; nothing where it is dimensionless.
    pub measure: Option<&'static Measure>,
    /// Whether the file must have it.
    pub required: bool,
    /// Whether a value may be missing: NaN.
    pub holes: bool,
}

impl Column {
    /// The SI unit of its numbers; empty where they are dimensionless.
    pub fn unit(&self) -> &'static str {
        self.measure.map_or("", |measure| measure.unit)
    }
}

/// What instruments write where they measured nothing, in small letters.
const HOLES: [&str; 6] = ["", "nan", "bad", "no data", "nodata", "---"];

/// The columns of a file, in SI units.
#[derive(Debug)]
pub struct Columns {
    /// The file.
    pub source: Arc<Source>,
    /// Number of the header's line, from 1.
    pub header_line: usize,
    /// Number of each row's line, from 1.
    pub lines: Vec<usize>,
    /// One entry for each column that was asked for, empty where the file does not have it.
    pub values: Vec<Vec<f64>>,
    /// Names of these columns.
    names: Vec<&'static str>,
    /// What the last digit of each column stands for, in SI units.
    digits: Vec<f64>,
    /// Which of the columns that were asked for the file has.
    present: Vec<bool>,
    field: String,
}

/// A column that the file has: which one of those asked for, and how its numbers become SI.
struct Assigned {
    index: usize,
    convert: Option<Conversion>,
}

impl Columns {
    /// Reads a file that `field` names. Lines that begin with `#` are comments.
    pub fn read(
        name: String,
        bytes: Vec<u8>,
        field: &str,
        wanted: &[Column],
    ) -> Result<Self, CaseError> {
        let mut columns = Self::empty(name, bytes, field, wanted)?;
        columns.fill(wanted)?;
        Ok(columns)
    }

    /// Reads a file without a header, its columns in the order of `wanted`, apart by spaces or
    /// tabs; what more there is belongs to the last column. All are multiplied to SI alike.
    pub fn read_bare(
        name: String,
        bytes: Vec<u8>,
        field: &str,
        wanted: &[Column],
        convert: Conversion,
    ) -> Result<Self, CaseError> {
        let mut columns = Self::empty(name, bytes, field, wanted)?;
        let header: Vec<Assigned> =
            (0..wanted.len()).map(|index| Assigned { index, convert: Some(convert) }).collect();
        let source = Arc::clone(&columns.source);
        for (line, text) in (1..).zip(source.text.lines()) {
            let text = text.trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            let words: Vec<&str> = text.split_whitespace().collect();
            let (first, last) = words.split_at(words.len().min(wanted.len()) - 1);
            let last = last.join(" ");
            let cells: Vec<&str> = first.iter().copied().chain([last.as_str()]).collect();
            columns.row(&cells, line, &header, wanted)?;
        }
        Ok(columns)
    }

    fn empty(
        name: String,
        bytes: Vec<u8>,
        field: &str,
        wanted: &[Column],
    ) -> Result<Self, CaseError> {
        let text = String::from_utf8(bytes).map_err(|_| {
            let message = format!("{field} must be a text file (UTF-8), but is not");
            CaseError::new(field, message, Place::File { name: name.clone() })
        })?;
        let text = text.trim_start_matches('\u{feff}').to_owned();
        let source = Arc::new(Source { name, text });
        let values = vec![Vec::new(); wanted.len()];
        let digits = vec![f64::INFINITY; wanted.len()];
        let present = vec![false; wanted.len()];
        let names = wanted.iter().map(|column| column.name).collect();
        let lines = Vec::new();
        let field = field.to_owned();
        Ok(Self { source, header_line: 1, lines, values, names, digits, present, field })
    }

    /// Whether the header of a file has a column of this name, in letters of any size.
    pub fn has_column(bytes: &[u8], name: &str) -> bool {
        let text = String::from_utf8_lossy(bytes);
        let mut records = Records::new(text.trim_start_matches('\u{feff}'));
        records.read().is_some()
            && records.cells().iter().any(|cell| split_header(cell).0.eq_ignore_ascii_case(name))
    }

    /// Whether the file has a column, by its number among those that were asked for.
    pub fn has(&self, index: usize) -> bool {
        self.present[index]
    }

    /// What the last digit of a column stands for, in SI units: its numbers may be off by half of
    /// it.
    pub fn digit(&self, name: &str) -> f64 {
        let column = self.names.iter().position(|column| *column == name);
        column.map_or(0.0, |column| self.digits[column])
    }

    /// An error at a line of the file.
    pub fn error(&self, line: usize, message: impl Into<String>) -> CaseError {
        CaseError::new(&self.field, message, Place::line(&self.source, line))
    }

    /// The field or option that names the file.
    pub fn field(&self) -> &str {
        &self.field
    }

    fn fill(&mut self, wanted: &[Column]) -> Result<(), CaseError> {
        let source = Arc::clone(&self.source);
        let mut header: Option<Vec<Assigned>> = None;
        let mut records = Records::new(&source.text);
        let mut first = 0;
        while let Some(line) = records.read() {
            let cells = records.cells();
            if header.is_none() {
                first = usize::from(cells.first() == Some(&INDEX));
            }
            let cells = cells.get(first..).unwrap_or_default();
            if cells.iter().any(|cell| cell.contains('\n')) {
                return Err(self.error(line, "a quotation mark must be closed in its line"));
            }
            match &header {
                None => {
                    self.header_line = line;
                    let assigned = self.header(cells, wanted)?;
                    for column in &assigned {
                        self.present[column.index] = true;
                    }
                    header = Some(assigned);
                }
                Some(header) => self.row(cells, line, header, wanted)?,
            }
        }
        if header.is_some() {
            return Ok(());
        }
        let expected = expected_header(wanted);
        let message =
            format!("{} must have a header such as `{expected}`, but is empty", self.field);
        Err(self.error(1, message))
    }

    fn header(&self, cells: &[&str], wanted: &[Column]) -> Result<Vec<Assigned>, CaseError> {
        if let Some(cell) = cells.iter().find(|cell| cell.contains([';', '\t'])) {
            return Err(self.other_separator(cell, wanted));
        }
        let mut assigned: Vec<Assigned> = Vec::new();
        for cell in cells {
            let (name, unit) = split_header(cell);
            let Some(index) = wanted.iter().position(|column| column.name == name) else {
                return Err(self.unknown_column(cell, name, wanted));
            };
            if assigned.iter().any(|column| column.index == index) {
                return Err(self.error(self.header_line, format!("column `{name}` is given twice")));
            }
            let convert = self.column_unit(&wanted[index], unit)?;
            assigned.push(Assigned { index, convert });
        }
        let is_missing =
            |index: &usize| wanted[*index].required && assigned.iter().all(|c| c.index != *index);
        if let Some(index) = (0..wanted.len()).find(is_missing) {
            let message = format!(
                "column `{}` is missing; the header must be such as `{}`",
                wanted[index].name,
                expected_header(wanted)
            );
            return Err(self.error(self.header_line, message));
        }
        Ok(assigned)
    }

    fn other_separator(&self, cell: &str, wanted: &[Column]) -> CaseError {
        let separator = if cell.contains(';') { "semicolons" } else { "tabs" };
        let message = format!(
            "columns must be separated by commas, as in `{}`, but are by {separator}",
            expected_header(wanted)
        );
        let help = "numbers have a decimal point, not a comma".to_owned();
        self.error(self.header_line, message).help(help)
    }

    fn unknown_column(&self, cell: &str, name: &str, wanted: &[Column]) -> CaseError {
        let expected = expected_header(wanted);
        let message = format!(
            "the header must be such as `{expected}`, but has a column `{}`",
            shortened(cell)
        );
        let meant = closest(name, wanted.iter().map(|column| column.name));
        let help = meant.map(|meant| format!("did you mean `{meant}`?"));
        self.error(self.header_line, message).help(help)
    }

    fn column_unit(
        &self,
        column: &Column,
        unit: Option<&str>,
    ) -> Result<Option<Conversion>, CaseError> {
        let name = column.name;
        match (column.measure, unit) {
            (Some(measure), unit) => {
                parse_unit(unit.unwrap_or_default(), measure).map(Some).map_err(|error| {
                    let message = format!(
                        "column `{name}` must name its unit, {}, as in `{name} [{}]`: {error}",
                        measure.examples, measure.unit
                    );
                    self.error(self.header_line, message)
                })
            }
            (None, None | Some("" | "-" | "1")) => Ok(None),
            (None, Some(unit)) => {
                let message = format!(
                    "column `{name}` must be dimensionless, but has the unit `{}`",
                    shortened(unit)
                );
                let help = is_per_cent(unit).then(|| NOT_PER_CENT.to_owned());
                Err(self.error(self.header_line, message).help(help))
            }
        }
    }

    fn row(
        &mut self,
        cells: &[&str],
        line: usize,
        header: &[Assigned],
        wanted: &[Column],
    ) -> Result<(), CaseError> {
        if cells.len() != header.len() {
            let (given, expected) = (cells.len(), header.len());
            let message =
                format!("a row must have {expected} entries as the header, but has {given}");
            return Err(self.error(line, message));
        }
        for (cell, column) in cells.iter().zip(header) {
            let number = self.number(cell, line, &wanted[column.index])?;
            let value = column.convert.map_or(number, |convert| convert.apply(number));
            self.values[column.index].push(value);
            let digit = last_digit(cell);
            let digit = column.convert.map_or(digit, |convert| convert.apply(digit));
            self.digits[column.index] = self.digits[column.index].min(digit.abs());
        }
        self.lines.push(line);
        Ok(())
    }

    fn number(&self, cell: &str, line: usize, column: &Column) -> Result<f64, CaseError> {
        let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
        if let Some(number) = number {
            return Ok(number);
        }
        if column.holes && HOLES.contains(&cell.to_lowercase().as_str()) {
            return Ok(f64::NAN);
        }
        let name = column.name;
        let message = format!("{name} must be a finite number, but is {}", quoted(cell));
        let readings = comma_readings(cell);
        let help = (!readings.is_empty()).then(|| comma(&readings));
        Err(self.error(line, message).help(help))
    }
}

/// What the last digit of a number stands for: 0.01 in `1.25`.
fn last_digit(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent = exponent.parse::<i32>().unwrap_or(0);
    10.0_f64.powi(exponent.saturating_sub(decimals.try_into().unwrap_or(i32::MAX)))
}

/// `pressure [MPa]` into its name and its unit.
fn split_header(cell: &str) -> (&str, Option<&str>) {
    match cell.strip_suffix(']').and_then(|cell| cell.split_once('[')) {
        Some((name, unit)) => (name.trim(), Some(unit.trim())),
        None => (cell, None),
    }
}

fn expected_header(wanted: &[Column]) -> String {
    let names: Vec<String> = wanted
        .iter()
        .map(|column| match column.measure {
            Some(measure) => format!("{} [{}]", column.name, measure.unit),
            None => column.name.to_owned(),
        })
        .collect();
    names.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    const WANTED: [Column; 2] = [
        Column { name: "time", measure: Some(&Measure::TIME), required: true, holes: false },
        Column { name: "factor", measure: None, required: false, holes: false },
    ];

    fn read(text: &str) -> Result<Columns, String> {
        Columns::read("f.csv".to_owned(), text.as_bytes().to_vec(), "field", &WANTED)
            .map_err(|error| error.to_string())
    }

    /// Empty lines, comments, with quotation marks and without, ends of lines of both kinds, a byte
    /// order mark.
    #[test]
    fn rows_have_their_lines() {
        let text = "\u{feff}# a, \"b\n\n \t\n\"time [s]\", \"factor\"\n# c\n\n1,2\n 3 ,\"4\"\n";
        for text in [text.to_owned(), text.replace('\n', "\r\n"), text.trim_end().to_owned()] {
            let columns = read(&text).unwrap();
            assert_eq!((columns.header_line, &columns.lines[..]), (4, &[7, 8][..]), "{text:?}");
            assert_eq!(columns.values, [[1.0, 3.0], [2.0, 4.0]]);
        }
    }

    /// As spreadsheets write where the decimal sign is a comma.
    #[test]
    fn semicolons_and_tabs_are_told() {
        for (text, separator) in
            [("time [s];factor\n0,5;1\n", "semicolons"), ("time [s]\tfactor\n", "tabs")]
        {
            let expected = format!(
                "f.csv:1:1: columns must be separated by commas, as in `time [s],factor`, but are by {separator}"
            );
            let message = read(text).unwrap_err();
            assert!(message.starts_with(&expected), "{message}");
        }
    }

    /// As tables of programs have.
    #[test]
    fn rows_may_have_names() {
        let columns = read("index,time [s],factor\n10,1,2\nb,3,4\n").unwrap();
        assert_eq!(columns.values, [[1.0, 3.0], [2.0, 4.0]]);
        let message = read("index,time [s],factor\n10,1,2\nb,3,x\n").unwrap_err();
        assert!(message.starts_with("f.csv, row b: factor must be a finite number"), "{message}");
        let message = read("index,factor\n10,1\n").unwrap_err();
        assert!(message.starts_with("f.csv: column `time` is missing"), "{message}");
    }

    #[test]
    fn commas_within_quotation_marks_separate_nothing() {
        let message = |row: &str| read(&format!("time [s],factor\n0,1\n{row}\n2,3\n")).unwrap_err();
        assert!(
            message("1,\"2,5\"")
                .contains("f.csv:3:1: factor must be a finite number, but is \"2,5\"")
        );
        assert!(message("1,2,5").contains("f.csv:3:1: a row must have 2 entries"));
        assert!(message("1,\"2").contains("f.csv:3:1: a quotation mark must be closed"));
    }
}
