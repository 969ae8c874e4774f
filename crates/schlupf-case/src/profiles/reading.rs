//! What was read of a profile: size, axes, order and spacing of its points.

use std::fmt;

use super::outline::{Change, JUMP, LONGEST_TWIG, distance, median_step};
use super::points::Row;
use crate::FieldPath;
use crate::fields::readable;

/// A jump is a hole from this length (in m) on.
const HOLE_LENGTH: f64 = 2e-3;

/// What was read of a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileReading {
    /// Path of the field: `wheel.profile` or `rail.profile`.
    pub field: FieldPath,
    /// The file, or the name of a built-in profile.
    pub name: String,
    /// What kind of file, and the unit of its numbers.
    pub format: String,
    /// Number of points, and of those between which the curve runs.
    pub points: [usize; 2],
    /// Width and height of all points, in m.
    pub size: [f64; 2],
    /// Direction of y in the file, and how it is known.
    pub y: String,
    /// Direction of z in the file, and how it is known.
    pub z: String,
    /// y of the flange back of a wheel with y outwards, in m.
    pub flange_back: Option<f64>,
    /// The usual and the largest step between points, in m.
    pub spacing: [f64; 2],
    /// Ends of the steps without points, y outwards and z up, in m.
    pub holes: Vec<[[f64; 2]; 2]>,
    /// What was done to the order of the points.
    pub order: Vec<String>,
}

impl ProfileReading {
    /// Takes spacing and holes from the points of the curve, y outwards and z up.
    pub(super) fn spaced(mut self, points: &[Row]) -> Self {
        let usual = median_step(points);
        let step = |pair: &[Row]| distance(&pair[0], &pair[1]);
        self.spacing = [usual, points.windows(2).map(step).fold(0.0, f64::max)];
        let is_hole = |pair: &&[Row]| step(pair) > HOLE_LENGTH.max(JUMP * usual);
        let holes = points.windows(2).filter(is_hole);
        self.holes = holes.map(|pair| [pair[0].place, pair[1].place]).collect();
        self
    }
}

/// A length in mm.
pub(super) fn millimetres(length: f64) -> String {
    format!("{} mm", readable(1e3 * (1e7 * length).round() / 1e7))
}

impl Change {
    /// As a sentence about the points of a file.
    pub(super) fn text(&self) -> String {
        let at = |row: &Row| {
            let [y, z] = row.place.map(millimetres);
            format!("line {} (y = {y}, z = {z})", row.line)
        };
        match self {
            Self::Repeated { count, first } => {
                let are = if *count == 1 { "row is" } else { "rows are" };
                format!("{count} repeated {are} left out, the first in {}", at(first))
            }
            Self::Sorted { count, first } => {
                let times = if *count == 1 { "place" } else { "places" };
                format!(
                    "the points are not in the order of the outline in {count} {times}, the first \
                     near {}: they were sorted along it",
                    at(first)
                )
            }
            Self::Beside { count, first } => {
                let are = if *count == 1 { "point is" } else { "points are" };
                format!(
                    "{count} {are} left out where the outline turns back within {}, the first in {}",
                    millimetres(LONGEST_TWIG),
                    at(first)
                )
            }
            Self::Overlap { ends, count, distance } => format!(
                "two passes overlap from {} to {} and are up to {} apart: the {count} points of the \
                 later one are left out there",
                at(&ends[0]),
                at(&ends[1]),
                millimetres(*distance)
            ),
        }
    }
}

impl fmt::Display for ProfileReading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.size.map(millimetres);
        let [usual, largest] = self.spacing.map(millimetres);
        let [all, used] = self.points;
        writeln!(f, "{}: {}", self.field, self.name)?;
        writeln!(
            f,
            "  read       {}, {all} points, {used} of them on the side that runs",
            self.format
        )?;
        writeln!(f, "  size       {width} wide, {height} high")?;
        writeln!(f, "  axes       y {}, z {}", self.y, self.z)?;
        if let Some(position) = self.flange_back {
            writeln!(f, "  flange     back at y = {}", millimetres(position))?;
        }
        writeln!(f, "  spacing    {usual}, at most {largest}")?;
        for [from, to] in &self.holes {
            let [y, z] = from.map(millimetres);
            let [to_y, to_z] = to.map(millimetres);
            writeln!(f, "  hole       from y = {y}, z = {z} to y = {to_y}, z = {to_z}")?;
        }
        for text in &self.order {
            writeln!(f, "  order      {text}")?;
        }
        Ok(())
    }
}
