//! Text files of points.

use std::sync::Arc;

use crate::FieldPath;
use crate::error::CaseError;
use crate::files::text;
use crate::place::{Place, Source};
use schlupf::reporting::quoted;

/// A text file.
pub struct File {
    pub source: Arc<Source>,
    /// The field that names it.
    pub field: FieldPath,
}

/// What a file says.
pub struct Content {
    /// What kind of file it is, and what its numbers are.
    pub format: String,
    /// Its points in the file's axes, in m, each with the number of its line.
    pub rows: Vec<Row>,
    /// Which way its axes point where the format says so.
    pub axes: Axes,
    /// y of the flange back where the format says so, with y outwards, in m.
    pub flange_back: Option<f64>,
    /// Whether lengths have their unit in the file or by its format.
    pub has_units: bool,
    /// Settings of the file that are not applied.
    pub left_out: Vec<String>,
}

/// A point of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// y and z in m.
    pub place: [f64; 2],
    /// Number of its line.
    pub line: usize,
}

/// Which way the axes of a file point.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Axes {
    /// Whether y points towards the middle of the track.
    pub is_inwards: Option<bool>,
    /// Whether z points down.
    pub is_down: Option<bool>,
}

impl Content {
    /// Points in a format with units that says nothing about axes.
    pub fn of(format: impl Into<String>, rows: Vec<Row>) -> Self {
        Self {
            format: format.into(),
            rows,
            axes: Axes::default(),
            flange_back: None,
            has_units: true,
            left_out: Vec::new(),
        }
    }
}

impl File {
    /// # Errors
    /// Bytes that are no text.
    pub fn new(name: String, bytes: &[u8], field: FieldPath) -> Result<Self, CaseError> {
        let Some(text) = text(bytes) else {
            let message = format!("{field} must be a text file, but is not");
            return Err(CaseError::new(field, message, Place::File { name }));
        };
        // Lines as text editors count them.
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        Ok(Self { source: Arc::new(Source { name, text }), field })
    }

    /// Its lines with their numbers, without comments that begin with any of these characters,
    /// and without spaces around them.
    pub fn lines<'a>(&'a self, comments: &'a [char]) -> impl Iterator<Item = (usize, &'a str)> {
        let code = move |line: &'a str| line.split(comments).next().unwrap_or_default().trim();
        (1..).zip(self.source.text.lines().map(code))
    }

    /// An error at a line.
    pub fn error(&self, line: usize, message: impl Into<String>) -> CaseError {
        let message = format!("{}: {}", self.field, message.into());
        CaseError::new(self.field, message, Place::line(&self.source, line))
    }

    /// An error of the file as a whole.
    pub fn error_of_all(&self, message: impl Into<String>) -> CaseError {
        self.error(1, message)
    }

    /// Refuses a rail as a wheel and the reverse, by what the file says of itself.
    pub fn check_body(
        &self,
        [is, is_wheel]: [bool; 2],
        line: usize,
        says: &str,
    ) -> Result<(), CaseError> {
        if is == is_wheel {
            return Ok(());
        }
        let [given, wanted] = [is, is_wheel].map(|is| if is { "a wheel" } else { "a rail" });
        let message = format!("the file must be that of {wanted}, but its {says}, that of {given}");
        Err(self.error(line, message))
    }

    /// A finite number of a line.
    pub fn number(&self, line: usize, word: &str) -> Result<f64, CaseError> {
        number(word)
            .ok_or_else(|| self.error(line, format!("{} must be a finite number", quoted(word))))
    }
}

/// What separates the numbers of all rows of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Separator {
    Character(char),
    Spaces,
}

impl Separator {
    /// The one that leaves two numbers at the beginning of most rows.
    pub fn of<'a>(rows: &(impl Iterator<Item = &'a str> + Clone)) -> Self {
        let fits = |separator: &Self| {
            let begins = |row: &&str| {
                let cells = separator.cells(row, 0);
                cells.len() >= 2 && cells[..2].iter().all(|cell| number(cell).is_some())
            };
            rows.clone().filter(begins).count()
        };
        let all = [Self::Character(','), Self::Character(';'), Self::Spaces];
        all.into_iter().max_by_key(fits).unwrap_or(Self::Spaces)
    }

    /// The cells of a row; empty last ones only as far as there must be so many.
    pub fn cells(self, row: &str, expected: usize) -> Vec<&str> {
        let cells: Vec<&str> = match self {
            Self::Character(character) => row.split(character).collect(),
            Self::Spaces => row.split_whitespace().collect(),
        };
        let trimmed = cells.into_iter().map(|cell| cell.trim().trim_matches('"').trim());
        let mut cells: Vec<&str> = trimmed.collect();
        while cells.len() > expected && cells.last().is_some_and(|cell| cell.is_empty()) {
            cells.pop();
        }
        cells
    }

    /// What helps if a row has too many cells because of decimal commas.
    pub fn help(self, cells: &[&str]) -> Option<String> {
        let is_likely =
            self == Self::Character(',') && !cells.iter().any(|cell| cell.contains('.'));
        is_likely
            .then(|| "separate columns by semicolons if numbers have decimal commas".to_owned())
    }

    /// Says whether numbers of rows have decimal commas.
    pub fn remark<'a>(self, mut rows: impl Iterator<Item = &'a str>) -> &'static str {
        let is_one = |cell: &&str| cell.contains(',') && number(cell).is_some();
        let has_one = rows.any(|row| self.cells(row, 0).iter().any(is_one));
        if has_one { ", decimal commas" } else { "" }
    }
}

/// Whether each word of a line is a number, whatever separates them.
fn are_numbers(line: &str) -> impl Iterator<Item = bool> {
    let words = line.split([' ', '\t', ',', ';']).filter(|word| !word.is_empty());
    words.map(|word| number(word).is_some())
}

/// Whether a line begins with a number.
pub fn begins_with_number(line: &str) -> bool {
    are_numbers(line).next().unwrap_or(false)
}

/// Whether a line has nothing but numbers, at least two.
pub fn is_row(line: &str) -> bool {
    are_numbers(line).all(|is_number| is_number) && are_numbers(line).count() > 1
}

/// A finite number, also with a decimal comma between digits and with the exponent of Fortran's
/// double precision.
pub fn number(word: &str) -> Option<f64> {
    let with_point = match word.split_once(',') {
        Some((whole, decimals)) => {
            let is_decimal = whole.ends_with(|c: char| c.is_ascii_digit())
                && decimals.starts_with(|c: char| c.is_ascii_digit());
            is_decimal.then(|| format!("{whole}.{decimals}"))?
        }
        None => word.to_owned(),
    };
    let parsed = with_point.replacen(['d', 'D'], "e", 1).parse::<f64>();
    parsed.ok().filter(|number| number.is_finite())
}
