//! Values on an equidistant lattice, from a CSV file with a row for each point or from an .npy file.

use super::columns::Columns;
use super::npy;
use crate::error::CaseError;
use crate::place::Place;

/// The field that names such files.
pub(super) const FILE: &str = "normal.file";

/// Positions may differ from the lattice by this part of a spacing: text has few digits.
const ROUNDING: f64 = 0.01;

/// A lattice with more points than this for each row is no table with holes, but no table at all.
const MAX_SPARSE: usize = 1000;

/// Values at the positions x × y, rows along x.
#[derive(Debug)]
pub(super) struct Lattice {
    /// In m, ascending.
    pub x: Vec<f64>,
    /// In m, ascending.
    pub y: Vec<f64>,
    pub values: Vec<f64>,
}

/// From the columns x, y (both in m) and a value, the rows in any order; `help` is what to do about a hole.
pub(super) fn from_columns(
    columns: &Columns,
    [xs, ys, values]: [&[f64]; 3],
    help: &str,
) -> Result<Lattice, CaseError> {
    let x = Axis::of("x", xs, columns)?;
    let y = Axis::of("y", ys, columns)?;
    if x.count.saturating_mul(y.count) > MAX_SPARSE * columns.lines.len() {
        let (nx, ny, rows) = (x.count, y.count, columns.lines.len());
        let message =
            format!("the points must fill a rectangle of {nx} by {ny}, but there are only {rows}");
        return Err(columns.error(columns.header_line, message));
    }
    let mut lines = vec![0; x.count * y.count];
    let mut filled = vec![0.0; lines.len()];
    for (row, &line) in columns.lines.iter().enumerate() {
        let cell = y.index(ys[row]) * x.count + x.index(xs[row]);
        if lines[cell] != 0 {
            let (first, at) = (lines[cell], point(xs[row], ys[row]));
            let message =
                format!("every point must be given once, but {at} stands in line {first} too");
            return Err(columns.error(line, message));
        }
        lines[cell] = line;
        filled[cell] = values[row];
    }
    if let Some(hole) = lines.iter().position(|line| *line == 0) {
        return Err(hole_error(hole, &lines, (&x, &y), columns).help(help.to_owned()));
    }
    Ok(Lattice { x: x.positions(), y: y.positions(), values: filled })
}

/// From an .npy file, centred on the origin, spacings in m; each value must be `legal`, which `requirement` says
/// in words.
pub(super) fn from_npy(
    name: &str,
    bytes: &[u8],
    spacings: [f64; 2],
    place: &Place,
    (legal, requirement): (fn(f64) -> bool, &str),
) -> Result<Lattice, CaseError> {
    let array = npy::parse(bytes).map_err(|message| npy_error(name, place, &message))?;
    if let Some(cell) = array.values.iter().position(|value| !legal(*value)) {
        let (row, column) = (cell / array.columns, cell % array.columns);
        let value = array.values[cell];
        let message =
            format!("must hold {requirement}, but is {value} in row {row}, column {column}");
        return Err(npy_error(name, place, &message));
    }
    let axis = |count: usize, spacing: f64| -> Vec<f64> {
        let middle = 0.5 * (count as f64 - 1.0);
        (0..count).map(|index| (index as f64 - middle) * spacing).collect()
    };
    let (x, y) = (axis(array.columns, spacings[0]), axis(array.rows, spacings[1]));
    Ok(Lattice { x, y, values: array.values })
}

/// An error of an .npy file; the message follows its name in a sentence.
pub(super) fn npy_error(name: &str, place: &Place, message: &str) -> CaseError {
    CaseError::new(FILE, format!("{FILE}: {name} {message}"), place.clone())
}

/// A point in words.
pub(super) fn point(x: f64, y: f64) -> String {
    format!("x = {} mm, y = {} mm", millimetres(x), millimetres(y))
}

/// A length (in m) in mm without the digits that conversion adds.
pub(super) fn millimetres(length: f64) -> f64 {
    (length * 1e9).round() / 1e6
}

/// Points at the nearest line that was given in front of a hole, if any.
fn hole_error(hole: usize, lines: &[usize], axes: (&Axis, &Axis), columns: &Columns) -> CaseError {
    let (x, y) = axes;
    let at = point(x.position(hole % x.count), y.position(hole / x.count));
    let holes = lines.iter().filter(|line| **line == 0).count();
    let message = format!(
        "the points must fill a rectangle of {} by {}, but {holes} of them are missing, the first at {at}",
        x.count, y.count
    );
    let before = lines[..hole].iter().rev().find(|line| **line != 0);
    let line = *before.unwrap_or(&columns.header_line);
    columns.error(line, message)
}

/// Equidistant positions.
#[derive(Debug)]
struct Axis {
    first: f64,
    spacing: f64,
    count: usize,
}

impl Axis {
    /// The lattice that positions in any order lie on.
    fn of(name: &str, positions: &[f64], columns: &Columns) -> Result<Self, CaseError> {
        let mut sorted = positions.to_vec();
        sorted.sort_by(f64::total_cmp);
        let widest = sorted.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        let (Some(&first), Some(&last)) = (sorted.first(), sorted.last()) else {
            let message =
                format!("{FILE} must have at least two values of {name}, but has no rows");
            return Err(columns.error(columns.header_line, message));
        };
        if widest <= 0.0 {
            let message =
                format!("{name} must have at least two values, but is the same everywhere");
            return Err(columns.error(columns.header_line, message));
        }
        let steps = ((last - first) / widest).round();
        let axis = Self { first, spacing: (last - first) / steps, count: 1 + steps as usize };
        let stray = positions.iter().position(|x| !axis.holds(*x) || !steps.is_finite());
        match stray {
            None => Ok(axis),
            Some(row) => {
                let message = format!(
                    "{name} must be equidistant, but {} mm lies between the multiples of the spacing {} mm",
                    millimetres(positions[row]),
                    millimetres(axis.spacing)
                );
                Err(columns.error(columns.lines[row], message))
            }
        }
    }

    fn index(&self, position: f64) -> usize {
        ((position - self.first) / self.spacing).round() as usize
    }

    fn position(&self, index: usize) -> f64 {
        self.first + self.spacing * index as f64
    }

    fn positions(&self) -> Vec<f64> {
        (0..self.count).map(|index| self.position(index)).collect()
    }

    fn holds(&self, position: f64) -> bool {
        (position - self.position(self.index(position))).abs() <= ROUNDING * self.spacing
    }
}
