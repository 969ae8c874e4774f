//! Files of measured surfaces: CSV, .npy, X3P (ISO 25178-72) and ASCII .xyz.

mod npy;
mod points;
mod source;
mod x3p;

use std::path::Path;

use schlupf::Error;
use schlupf::surface::holes::{Holes, require_few};
use schlupf::surface::profile::Profile;
use schlupf::surface::{HeightMap, Lattice};

use crate::error::{CaseError, Cause};
use crate::fields::readable;
use crate::place::Place;
use crate::units::{Measure, parse_unit};

pub use source::{RoughSurface, SurfaceOrigin, SurfaceSource, renamed};

const FILE: &str = "surface.file";

/// What becomes of a map whose cells are not square.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cells {
    /// It is an error.
    #[default]
    RefuseNonSquare,
    /// It is resampled in square cells as large as the shorter side.
    MakeSquare,
}

/// What a file does not say, and what to do where it is not as it should be.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SurfaceOptions {
    /// Unit of heights in .npy files, and of all lengths in .xyz files, such as `um`.
    pub unit: Option<String>,
    /// Cell sizes along x and y in .npy files, in m.
    pub spacing: Option<[f64; 2]>,
    /// Points without a height.
    pub holes: Holes,
    /// Cells that are longer than wide.
    pub cells: Cells,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceData {
    /// Heights over x and y.
    Map(HeightMap),
    /// Heights along a line.
    Profile(Profile),
}

/// What was read.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredSurface {
    /// Without holes.
    pub data: SurfaceData,
    /// Part of its points that had no height and were filled, dimensionless.
    pub filled: f64,
}

/// Reads a file of the format that its ending names.
pub fn read(path: &Path, options: &SurfaceOptions) -> Result<MeasuredSurface, CaseError> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| {
        let message = format!("{FILE} must be a readable file, but is not: {error}");
        let place = Place::File { name: name.clone() };
        CaseError { cause: Cause::FileSystem, ..CaseError::new(FILE, message, place) }
    })?;
    from_bytes(name, bytes, options)
}

/// The same from the bytes of a file.
pub fn from_bytes(
    name: String,
    bytes: Vec<u8>,
    options: &SurfaceOptions,
) -> Result<MeasuredSurface, CaseError> {
    let ending = Path::new(&name).extension().and_then(|ending| ending.to_str());
    match ending.map(str::to_lowercase).as_deref() {
        Some("csv") => points::from_csv(name, bytes, options),
        Some("xyz") => points::from_xyz(name, bytes, options),
        Some("npy") => npy::read(&name, &bytes, options),
        Some("x3p") => x3p::read(&name, bytes, options),
        _ => Err(refusal(&name, "must be a .csv, .npy, .x3p or .xyz file, but is not")),
    }
}

/// An error of all of a file, which its place names; the message follows the field.
fn refusal(name: &str, message: impl AsRef<str>) -> CaseError {
    let message = format!("{FILE} {}", message.as_ref());
    CaseError::new(FILE, message, Place::File { name: name.to_owned() })
}

/// The factor of the unit that the options name.
fn unit(name: &str, options: &SurfaceOptions) -> Result<crate::units::Conversion, CaseError> {
    let text = options.unit.as_deref().unwrap_or_default();
    parse_unit(text, &Measure::LENGTH).map_err(|error| {
        let message = format!(
            "surface.unit must be a unit of length, {}, because {name} names none: {error}",
            Measure::LENGTH.examples
        );
        CaseError::new("surface.unit", message, Place::File { name: name.to_owned() })
    })
}

/// Heights with holes as a surface: a profile if there is one row or one column.
fn finish(
    name: &str,
    lattice: Lattice,
    heights: Vec<f64>,
    options: &SurfaceOptions,
) -> Result<MeasuredSurface, CaseError> {
    let explain = |error: Error| refusal(name, format!("is no surface: {error}"));
    if let Some(cell) = heights.iter().position(|height| is_too_high(*height)) {
        let (row, column) = (cell / lattice.columns, cell % lattice.columns);
        let message = too_high(heights[cell], &format!("in row {row}, column {column}"));
        return Err(refusal(name, message).help(ADVICE_ON_HEIGHTS.to_owned()));
    }
    let holes = heights.iter().filter(|height| !height.is_finite()).count();
    if holes > 0 && options.holes == Holes::Refuse {
        return Err(holes_error(name, &lattice, &heights));
    }
    let filled = holes as f64 / heights.len().max(1) as f64;
    if lattice.rows == 1 || lattice.columns == 1 {
        require_few(&heights).map_err(explain)?;
        let heights = if holes > 0 { bridged(&heights) } else { heights };
        let spacing = if lattice.rows == 1 { lattice.spacing_x } else { lattice.spacing_y };
        let profile = Profile::new(spacing, &heights).map_err(explain)?;
        return Ok(MeasuredSurface { data: SurfaceData::Profile(profile), filled });
    }
    let map = HeightMap::with_holes(lattice, heights, options.holes).map_err(explain)?;
    map.require_rough().map_err(explain)?;
    let map = match options.cells {
        _ if lattice.has_square_cells() => map,
        Cells::MakeSquare => map.with_square_cells().map_err(explain)?,
        Cells::RefuseNonSquare => {
            let [x, y] = [lattice.spacing_x, lattice.spacing_y].map(micrometres);
            let error =
                refusal(name, format!("must have square cells, but they are {x} µm by {y} µm"));
            let advice = "ask for square cells: the surface is then resampled";
            return Err(error.help(advice.to_owned()));
        }
    };
    Ok(MeasuredSurface { data: SurfaceData::Map(map), filled })
}

/// Heights (in m) beyond this are none of a rough surface, but in a wrong unit or sentinels for missing
/// values.
const HIGHEST: f64 = 1.0;

const ADVICE_ON_HEIGHTS: &str =
    "is it in another unit, or does it stand for a missing value? A missing one must be nan";

fn is_too_high(height: f64) -> bool {
    height.is_infinite() || height.abs() > HIGHEST
}

/// What is wrong with a height (in m) that is too high at a place.
fn too_high(height: f64, place: &str) -> String {
    format!("must have heights of at most {HIGHEST} m, but {place} is {} m", readable(height))
}

fn holes_error(name: &str, lattice: &Lattice, heights: &[f64]) -> CaseError {
    let holes: Vec<usize> = (0..heights.len()).filter(|cell| !heights[*cell].is_finite()).collect();
    let (count, first) = (holes.len(), holes.first().copied().unwrap_or(0));
    let (row, column) = (first / lattice.columns, first % lattice.columns);
    let all = heights.len();
    let message = format!(
        "must have a height at every point, but {count} of {all} are missing, the first in row \
         {row}, column {column}"
    );
    refusal(name, message).help("ask for holes to be filled".to_owned())
}

/// Straight lines across the holes of a profile; beyond its first and last height it goes on level.
fn bridged(heights: &[f64]) -> Vec<f64> {
    let known: Vec<usize> = (0..heights.len()).filter(|k| heights[*k].is_finite()).collect();
    let at = |k: usize| {
        let above = known.partition_point(|index| *index < k);
        match (above.checked_sub(1).map(|below| known[below]), known.get(above)) {
            (_, Some(&high)) if high == k => heights[k],
            (Some(low), Some(&high)) => {
                let t = (k - low) as f64 / (high - low) as f64;
                heights[low] + t * (heights[high] - heights[low])
            }
            (Some(index), None) | (None, Some(&index)) => heights[index],
            (None, None) => f64::NAN,
        }
    };
    (0..heights.len()).map(at).collect()
}

/// A length in µm without the digits that conversion adds.
fn micrometres(length: f64) -> f64 {
    (length * 1e12).round() / 1e6
}
