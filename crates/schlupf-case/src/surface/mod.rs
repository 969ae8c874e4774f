//! Files of measured surfaces: CSV, .npy, X3P (ISO 25178-72) and ASCII .xyz.

mod npy;
mod points;
mod source;
mod x3p;

use std::path::Path;

use schlupf::Error;
use schlupf::surface::{HeightMap, Holes, Lattice, LineSpectrum, Profile, require_few};

use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::readable;
use crate::files::InputFile;
use crate::names::{self, FieldNames};
use crate::place::Place;
use crate::units::{Measure, parse_unit};

pub use points::{BANDS as BAND_COLUMNS, COLUMNS as HEIGHT_COLUMNS};
pub use source::{RoughSurface, SurfaceOrigin, SurfaceSource};

/// Fields that errors of surfaces name.
const FILE: FieldPath = field!("contact_law.roughness.file");
const UNIT: FieldPath = field!("contact_law.roughness.unit");
const SPACING: FieldPath = field!("contact_law.roughness.spacing");
const FILL_HOLES: FieldPath = field!("contact_law.roughness.fill_holes");
const SQUARE_CELLS: FieldPath = field!("contact_law.roughness.square_cells");

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
    /// One-third octave bands of a line.
    Spectrum(LineSpectrum),
}

/// What was read.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredSurface {
    /// Without holes.
    pub data: SurfaceData,
    /// Part of its points that had no height and were filled, dimensionless.
    pub filled: f64,
}

/// How a file is read, and what the fields are called that say so.
#[derive(Clone, Copy)]
struct Reading<'a> {
    options: &'a SurfaceOptions,
    names: FieldNames,
    /// Path of the field that names the file.
    field: FieldPath,
}

/// Reads a file of the format that its ending names; `names` are for messages.
pub fn read(
    file: &InputFile,
    options: &SurfaceOptions,
    names: FieldNames,
) -> Result<MeasuredSurface, CaseError> {
    Reading { options, names, field: FILE }.file(file)
}

impl Reading<'_> {
    fn file(self, file: &InputFile) -> Result<MeasuredSurface, CaseError> {
        let name = file.path().display().to_string();
        let bytes = file.read().map_err(|error| {
            let message = format!("must be a readable file, but is not: {error}");
            self.refusal(&name, message).of_file(&name, &error)
        })?;
        let (given, own) = (self.options.unit.as_deref(), file.unit());
        if given.is_some() && own.is_some_and(|own| Some(own) != given) {
            return Err(self.twice(UNIT, &name));
        }
        let (spacing, spacings) = (self.options.spacing, file.spacings());
        if spacing.is_some() && spacings.is_some_and(|own| Some(own) != spacing) {
            return Err(self.twice(SPACING, &name));
        }
        // Arrays of a program are in SI units.
        let unit = given.or(own).or(file.data().map(|_| "m")).map(str::to_owned);
        let spacing = spacing.or(spacings);
        let how = Reading { options: &SurfaceOptions { unit, spacing, ..*self.options }, ..self };
        how.bytes(name, &file.ending(), bytes)
    }

    /// An option that contradicts what data say.
    fn twice(self, option: FieldPath, name: &str) -> CaseError {
        let message =
            format!("{} must be left out, because {name} has its own", self.names.name(option));
        CaseError::new(option, message, Place::File { name: name.to_owned() })
    }

    fn bytes(
        self,
        name: String,
        ending: &str,
        bytes: Vec<u8>,
    ) -> Result<MeasuredSurface, CaseError> {
        match ending {
            "csv" => points::from_csv(name, bytes, self),
            "xyz" => points::from_xyz(name, bytes, self),
            "npy" => npy::read(&name, &bytes, self),
            "x3p" => x3p::read(&name, bytes, self),
            _ => Err(self.refusal(&name, "must be a .csv, .npy, .x3p or .xyz file, but is not")),
        }
    }

    /// Distances of the points along x and y (in m) of a file that does not have them.
    fn spacings(self, name: &str) -> Result<[f64; 2], CaseError> {
        self.options.spacing.ok_or_else(|| {
            let message = format!(
                "{} must be given, because {name} does not say how far its points are apart",
                self.names.name(SPACING)
            );
            CaseError::new(SPACING, message, Place::File { name: name.to_owned() })
        })
    }

    /// What the field that names the file is called.
    fn field_name(self) -> &'static str {
        self.names.name(self.field)
    }

    /// An error of all of a file, which its place names; the message follows the field.
    fn refusal(self, name: &str, message: impl AsRef<str>) -> CaseError {
        let message = format!("{} {}", self.field_name(), message.as_ref());
        CaseError::new(self.field, message, Place::File { name: name.to_owned() })
    }

    /// An error of the core, at no place yet.
    fn explained(self, error: &Error) -> CaseError {
        let field = names::quantity_field(error.quantity()).unwrap_or(self.field);
        CaseError::new(field, error.text(&self.names), Place::Default)
    }

    /// The same of a file.
    fn of_file(self, file: &Path, error: &Error) -> CaseError {
        let error = error.text(&self.names);
        self.refusal(&file.display().to_string(), format!("cannot be used: {error}"))
    }
}

/// The factor of the unit that the options name.
fn unit(name: &str, how: Reading) -> Result<crate::units::Conversion, CaseError> {
    let text = how.options.unit.as_deref().unwrap_or_default();
    parse_unit(text, &Measure::LENGTH).map_err(|error| {
        let message = format!(
            "{} must be a unit of length, {}, because {name} names none: {error}",
            how.names.name(UNIT),
            Measure::LENGTH.examples
        );
        CaseError::new(UNIT, message, Place::File { name: name.to_owned() })
    })
}

/// Heights with holes as a surface: a profile if there is one row or one column.
fn finish(
    name: &str,
    lattice: Lattice,
    heights: Vec<f64>,
    how: Reading,
) -> Result<MeasuredSurface, CaseError> {
    let Reading { options, names, .. } = how;
    let explain =
        |error: Error| how.refusal(name, format!("is no surface: {}", error.text(&names)));
    if let Some(cell) = heights.iter().position(|height| is_too_high(*height)) {
        let (row, column) = (cell / lattice.columns, cell % lattice.columns);
        let message = too_high(heights[cell], &format!("in row {row}, column {column}"));
        return Err(how.refusal(name, message).help(ADVICE_ON_HEIGHTS.to_owned()));
    }
    let holes = heights.iter().filter(|height| !height.is_finite()).count();
    if holes > 0 && options.holes == Holes::Refuse {
        return Err(holes_error(name, &lattice, &heights, how));
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
                how.refusal(name, format!("must have square cells, but they are {x} µm by {y} µm"));
            return Err(error.help(format!("{} resamples it", names.switch(SQUARE_CELLS))));
        }
    };
    Ok(MeasuredSurface { data: SurfaceData::Map(map), filled })
}

/// Heights (in m) beyond this are none of a rough surface, but in a wrong unit or sentinels for
/// missing values.
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

fn holes_error(name: &str, lattice: &Lattice, heights: &[f64], how: Reading) -> CaseError {
    let holes: Vec<usize> = (0..heights.len()).filter(|cell| !heights[*cell].is_finite()).collect();
    let (count, first) = (holes.len(), holes.first().copied().unwrap_or(0));
    let (row, column) = (first / lattice.columns, first % lattice.columns);
    let all = heights.len();
    let message = format!(
        "must have a height at every point, but {count} of {all} are missing, the first in row \
         {row}, column {column}"
    );
    let switch = how.names.switch(FILL_HOLES);
    how.refusal(name, message).help(format!("{switch} fills them"))
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
