//! Text files of points.

use std::sync::Arc;

use crate::error::CaseError;
use crate::place::{Place, Source};
use schlupf::message::quoted;

/// A text file.
pub struct File {
    pub source: Arc<Source>,
    /// The field that names it.
    pub field: &'static str,
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
    pub fn new(name: String, bytes: &[u8], field: &'static str) -> Result<Self, CaseError> {
        let text = decoded(bytes);
        if text.contains('\0') {
            let message = format!("{field} must be a text file, but is not");
            return Err(CaseError::new(field, message, Place::File { name }));
        }
        // Lines as text editors count them.
        let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
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

    /// A finite number of a line.
    pub fn number(&self, line: usize, word: &str) -> Result<f64, CaseError> {
        number(word)
            .ok_or_else(|| self.error(line, format!("{} must be a finite number", quoted(word))))
    }

    /// The words of a line as numbers, apart by spaces, tabs, commas or semicolons.
    pub fn numbers(&self, line: usize, text: &str) -> Result<Vec<f64>, CaseError> {
        words(text).map(|word| self.number(line, word)).collect()
    }
}

/// Text in UTF-8 or UTF-16, or in a code page of which only ASCII is understood: names of places in
/// measuring devices are in any, numbers are in ASCII.
fn decoded(bytes: &[u8]) -> String {
    // ASCII in UTF-16 without a byte order mark.
    let is_every_second =
        |zero: usize| bytes.len() > 3 && (0..4).all(|k| (bytes[k] == 0) == (k % 2 == zero));
    let is_little = bytes.starts_with(&[0xff, 0xfe]) || is_every_second(1);
    let is_big = bytes.starts_with(&[0xfe, 0xff]) || is_every_second(0);
    if is_little || is_big {
        let unit = |pair: &[u8]| {
            let pair = [pair[0], pair[1]];
            if is_little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) }
        };
        let units: Vec<u16> = bytes.chunks_exact(2).map(unit).collect();
        return String::from_utf16_lossy(&units);
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
    }
}

/// The words of a line, apart by spaces, tabs, commas or semicolons.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split([' ', '\t', ',', ';']).filter(|word| !word.is_empty())
}

/// A finite number, also with the exponent of Fortran's double precision.
pub fn number(word: &str) -> Option<f64> {
    let parsed = word.parse::<f64>().or_else(|_| word.replacen(['d', 'D'], "e", 1).parse());
    parsed.ok().filter(|number| number.is_finite())
}

/// The numbers with which a line begins.
pub fn leading_numbers(line: &str) -> Vec<f64> {
    words(line).map_while(number).collect()
}
