//! Points of a table that fill a rectangle: in any order from a CSV file, or from an .npy file.

use schlupf::normal::Axis;

use super::axis::{axis, rounded};
use super::columns::Columns;
use super::npy;
use crate::FieldPath;
use crate::error::CaseError;
use crate::place::Place;

/// The field that names the files of the normal contact.
pub const FILE: FieldPath = field!("normal.file");

/// A lattice with more points than this for each row is no table with holes, but no table at all.
const MAX_SPARSE: usize = 1000;

/// Equidistant points, rows along x one after another.
#[derive(Debug)]
pub struct Lattice {
    /// Along x.
    pub x: Axis,
    /// Along y.
    pub y: Axis,
    /// Where on the lattice each row of the file lies.
    pub places: Vec<usize>,
}

impl Lattice {
    /// The lattice of positions (in m), each given once; `advice` says what to give where there is
    /// nothing.
    pub fn of(xs: &[f64], ys: &[f64], columns: &Columns, advice: &str) -> Result<Self, CaseError> {
        let (x, y) = (axis("x", xs, columns)?, axis("y", ys, columns)?);
        let along_x = Along { name: "x", axis: &x, positions: xs };
        let along_y = Along { name: "y", axis: &y, positions: ys };
        let (places, lines) = places(&along_x, &along_y, MAX_SPARSE, columns)?;
        match lines.iter().position(|line| *line == 0) {
            Some(hole) => Err(hole_error(hole, &lines, [&x, &y], columns).help(advice.to_owned())),
            None => Ok(Self { x, y, places }),
        }
    }

    /// A column of the file in the order of the lattice.
    pub fn arranged(&self, column: &[f64]) -> Vec<f64> {
        let mut arranged = vec![0.0; column.len()];
        for (&place, &value) in self.places.iter().zip(column) {
            arranged[place] = value;
        }
        arranged
    }
}

/// A column with positions along an axis.
#[derive(Debug)]
pub struct Along<'a> {
    /// Its name.
    pub name: &'static str,
    /// Where positions may be.
    pub axis: &'a Axis,
    /// In m.
    pub positions: &'a [f64],
}

/// Where on the lattice of two columns each row of a file lies, and in which line of the file each
/// place of the lattice is given, zero if nowhere. The lattice has at most `sparse` times as many
/// points as the file.
pub fn places(
    along_x: &Along,
    along_y: &Along,
    sparse: usize,
    columns: &Columns,
) -> Result<(Vec<usize>, Vec<usize>), CaseError> {
    let (x, y) = (along_x.axis, along_y.axis);
    if x.count.saturating_mul(y.count) > sparse * columns.lines.len() {
        let (nx, ny, rows) = (x.count, y.count, columns.lines.len());
        let message =
            format!("the points must fill a rectangle of {nx} by {ny}, but there are only {rows}");
        return Err(columns.error(columns.header_line, message));
    }
    let mut lines = vec![0; x.count * y.count];
    let mut places = Vec::with_capacity(columns.lines.len());
    for (row, &line) in columns.lines.iter().enumerate() {
        let [at_x, at_y] = [along_x, along_y].map(|along| along.positions[row]);
        let place = y.nearest(at_y) * x.count + x.nearest(at_x);
        if lines[place] != 0 {
            let message = format!(
                "every point must be given once, but {} = {} mm, {} = {} mm stands in line {} too",
                along_x.name,
                millimetres(at_x),
                along_y.name,
                millimetres(at_y),
                lines[place]
            );
            return Err(columns.error(line, message));
        }
        lines[place] = line;
        places.push(place);
    }
    Ok((places, lines))
}

/// Values at the positions x × y, rows along x.
#[derive(Debug)]
pub struct Table {
    /// In m, ascending.
    pub x: Vec<f64>,
    /// In m, ascending.
    pub y: Vec<f64>,
    /// One for each point.
    pub values: Vec<f64>,
}

/// From the columns x, y (both in m) and a value, the rows in any order; `advice` is what to do
/// about a hole.
pub fn from_columns(
    columns: &Columns,
    [xs, ys, values]: [&[f64]; 3],
    advice: &str,
) -> Result<Table, CaseError> {
    let lattice = Lattice::of(xs, ys, columns, advice)?;
    let values = lattice.arranged(values);
    Ok(Table { x: lattice.x.positions(), y: lattice.y.positions(), values })
}

/// An .npy file, centred on the origin unless it says where it starts.
#[derive(Debug)]
pub struct NpyFile<'a> {
    /// For messages.
    pub name: &'a str,
    /// What is in it.
    pub bytes: &'a [u8],
    /// Along x and y, in m.
    pub spacings: [f64; 2],
    /// Its first place along x and y, in m.
    pub start: Option<[f64; 2]>,
    /// Where it is named.
    pub place: Place,
}

impl NpyFile<'_> {
    /// Its values, each of which must be `legal`; `requirement` says in words what that is.
    pub fn table(
        &self,
        legal: impl Fn(f64) -> bool,
        requirement: &str,
    ) -> Result<Table, CaseError> {
        let array = npy::parse(self.bytes).map_err(|message| self.error(&message))?;
        if let Some(cell) = array.values.iter().position(|value| !legal(*value)) {
            let (row, column) = (cell / array.columns, cell % array.columns);
            let value = array.values[cell];
            return Err(self.error(&format!(
                "must hold {requirement}, but is {value} in row {row}, column {column}"
            )));
        }
        let axis = |count: usize, side: usize| -> Vec<f64> {
            let (spacing, middle) = (self.spacings[side], 0.5 * (count as f64 - 1.0));
            let start = self.start.map(|start| start[side]);
            let at = |index: usize| match start {
                Some(start) => start + index as f64 * spacing,
                None => (index as f64 - middle) * spacing,
            };
            (0..count).map(at).collect()
        };
        let (x, y) = (axis(array.columns, 0), axis(array.rows, 1));
        Ok(Table { x, y, values: array.values })
    }

    /// An error of it; the message follows its name in a sentence.
    pub fn error(&self, message: &str) -> CaseError {
        CaseError::new(FILE, format!("{FILE}: {} {message}", self.name), self.place.clone())
    }
}

/// A point for messages.
pub fn point(x: f64, y: f64) -> String {
    format!("x = {} mm, y = {} mm", millimetres(x), millimetres(y))
}

/// A length (in m) in mm without the digits that conversion adds.
pub fn millimetres(length: f64) -> f64 {
    rounded(length * 1e3)
}

/// Points at the nearest line that was given in front of a hole, if any.
fn hole_error(hole: usize, lines: &[usize], [x, y]: [&Axis; 2], columns: &Columns) -> CaseError {
    let at = point(x.at(hole % x.count), y.at(hole / x.count));
    let holes = lines.iter().filter(|line| **line == 0).count();
    let message = format!(
        "the points must fill a rectangle of {} by {}, but {holes} of them are missing, the first at {at}",
        x.count, y.count
    );
    let before = lines[..hole].iter().rev().find(|line| **line != 0);
    let line = *before.unwrap_or(&columns.header_line);
    columns.error(line, message)
}
