//! Text files of points, and which way their axes point.

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

impl File {
    /// # Errors
    /// Bytes that are no text.
    pub fn new(name: String, bytes: Vec<u8>, field: &'static str) -> Result<Self, CaseError> {
        // Names of places in measuring devices are in any code page; numbers are in ASCII.
        let text = match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => error.as_bytes().iter().map(|byte| char::from(*byte)).collect(),
        };
        if text.contains('\0') {
            let message = format!("{field} must be a text file, but is not");
            return Err(CaseError::new(field, message, Place::File { name }));
        }
        let text = text.trim_start_matches('\u{feff}').to_owned();
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
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| self.error(line, format!("{} must be a finite number", quoted(word))))
    }

    /// The words of a line as numbers, apart by spaces, tabs, commas or semicolons.
    pub fn numbers(&self, line: usize, text: &str) -> Result<Vec<f64>, CaseError> {
        let words = text.split([' ', '\t', ',', ';']).filter(|word| !word.is_empty());
        words.map(|word| self.number(line, word)).collect()
    }
}

/// Whether z of a profile points down: the mean of z over y of a running surface is near its top,
/// from which flange or sides hang down.
pub fn is_upside_down(points: &[[f64; 2]]) -> bool {
    let (mut area, mut width) = (0.0, 0.0);
    for pair in points.windows(2) {
        let step = (pair[1][0] - pair[0][0]).abs();
        area += 0.5 * (pair[0][1] + pair[1][1]) * step;
        width += step;
    }
    let mean = area / width;
    let [low, high] = range(points, 1);
    mean - low < CLEARLY * (high - mean)
}

/// Ratio of the distances of the mean from both ends above which it counts as near neither,
/// dimensionless.
const CLEARLY: f64 = 0.9;

/// Whether the lowest point of a wheel, that of its flange, has the larger y.
pub fn has_flange_outside(points: &[[f64; 2]]) -> bool {
    let [from, to] = range(points, 0);
    let lowest = points.iter().min_by(|p, q| p[1].total_cmp(&q[1]));
    let [low, high] = range(points, 1);
    let is_flanged = high - low > LEAST_FLANGE;
    is_flanged && lowest.is_some_and(|[y, _]| *y > 0.5 * (from + to))
}

/// Least height of what counts as a flange, in m.
const LEAST_FLANGE: f64 = 0.015;

fn range(points: &[[f64; 2]], axis: usize) -> [f64; 2] {
    points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
        [low.min(point[axis]), high.max(point[axis])]
    })
}
