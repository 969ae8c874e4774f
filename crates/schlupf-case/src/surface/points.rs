//! Points x, y, height or one-third octave bands as text: CSV with units in its header, and .xyz
//! without.

use schlupf::Error;
use schlupf::normal::Axis;
use schlupf::reporting::SurfaceError;
use schlupf::surface::{Lattice, LineSpectrum};

use super::{
    ADVICE_ON_HEIGHTS, MeasuredSurface, Reading, SurfaceData, finish, is_too_high, too_high, unit,
};
use crate::error::CaseError;
use crate::tables::axis::axis;
use crate::tables::columns::{Column, Columns};
use crate::tables::lattice::{self, Along};
use crate::units::Measure;

const fn length(name: &'static str, required: bool, holes: bool) -> Column {
    Column { name, measure: Some(&Measure::LENGTH), required, holes }
}

/// Without y, or all along x or all along y, it is a profile; with heights alone, one whose spacing
/// is given beside it.
pub const COLUMNS: [Column; 3] =
    [length("x", false, false), length("y", false, false), length("height", true, true)];

/// One-third octave bands of a line: levels are 20 lg(r/1 µm) of the root mean square height r.
pub const BANDS: [Column; 2] = [
    length("wavelength", true, false),
    Column { name: "level", measure: Some(&Measure::LEVEL), required: true, holes: false },
];

/// A lattice with more points than this for each row is no map with holes, but no map at all.
const MAX_SPARSE: usize = 4;

/// From a CSV file with the columns x, y and height or those of bands, its rows in any order.
pub fn from_csv(name: String, bytes: Vec<u8>, how: Reading) -> Result<MeasuredSurface, CaseError> {
    if Columns::has_column(&bytes, BANDS[0].name) {
        return from_bands(&Columns::read(name, bytes, how.field_name(), &BANDS)?, how);
    }
    from_columns(&Columns::read(name, bytes, how.field_name(), &COLUMNS)?, how)
}

fn from_bands(columns: &Columns, how: Reading) -> Result<MeasuredSurface, CaseError> {
    let spectrum = LineSpectrum::of_octave_bands(&columns.values[0], &columns.values[1]);
    let data = spectrum.map(SurfaceData::Spectrum).map_err(|error| match error {
        Error::Surface {
            error:
                SurfaceError::NoOctaveBand { index, .. }
                | SurfaceError::NoLevel { index, .. }
                | SurfaceError::OctaveBandTwice { index, .. }
                | SurfaceError::OctaveBandMissing { index, .. },
        } => columns.error(columns.lines[index], error.text(&how.names)),
        error => how.of_file(columns.source.name.as_ref(), &error),
    })?;
    Ok(MeasuredSurface { data, filled: 0.0 })
}

/// From lines `x y z` in the unit of the options.
pub fn from_xyz(name: String, bytes: Vec<u8>, how: Reading) -> Result<MeasuredSurface, CaseError> {
    let convert = unit(&name, how)?;
    from_columns(&Columns::read_bare(name, bytes, how.field_name(), &COLUMNS, convert)?, how)
}

fn from_columns(columns: &Columns, how: Reading) -> Result<MeasuredSurface, CaseError> {
    let name = &columns.source.name;
    let [xs, ys, heights] = &columns.values[..] else {
        return Err(how.refusal(name, "must have three columns"));
    };
    if let Some(row) = heights.iter().position(|height| is_too_high(*height)) {
        let message = format!("{} {}", how.field_name(), too_high(heights[row], "this one"));
        return Err(columns.error(columns.lines[row], message).help(ADVICE_ON_HEIGHTS.to_owned()));
    }
    if xs.is_empty() && !heights.is_empty() {
        if !ys.is_empty() {
            let message = "column `x` is missing beside `y`";
            return Err(columns.error(columns.header_line, message));
        }
        let [spacing_x, spacing_y] = how.spacings(name)?;
        let lattice = Lattice { columns: heights.len(), rows: 1, spacing_x, spacing_y };
        return finish(name, lattice, heights.clone(), how);
    }
    let zeros = vec![0.0; xs.len()];
    let ys = if ys.is_empty() { &zeros } else { ys };
    let is_level = |values: &[f64]| values.windows(2).all(|pair| pair[0] == pair[1]);
    // A line along y is a profile as well as one along x.
    let is_along_y = is_level(xs) && !is_level(ys);
    let (xs, ys, names) = if is_along_y { (ys, xs, ["y", "x"]) } else { (xs, ys, ["x", "y"]) };
    let x = axis(names[0], xs, columns)?;
    let y = if is_level(ys) {
        Axis { start: ys[0], spacing: x.spacing, count: 1 }
    } else {
        axis("y", ys, columns)?
    };
    let along_x = Along { name: names[0], axis: &x, positions: xs };
    let along_y = Along { name: names[1], axis: &y, positions: ys };
    let (places, lines) = lattice::places(&along_x, &along_y, MAX_SPARSE, columns)?;
    let mut map = vec![f64::NAN; lines.len()];
    for (&place, &height) in places.iter().zip(heights) {
        map[place] = height;
    }
    let [spacing_x, spacing_y] = spacings([&x, &y], ["x", "y"].map(|name| columns.digit(name)));
    let lattice = Lattice { columns: x.count, rows: y.count, spacing_x, spacing_y };
    finish(name, lattice, map, how)
}

/// Spacings along x and y (in m); the same where they differ by no more than the last digits of the
/// positions leave open. The longer side knows it better.
fn spacings([x, y]: [&Axis; 2], digits: [f64; 2]) -> [f64; 2] {
    let lengths = [x, y].map(|axis| axis.spacing * axis.count as f64);
    let open = digits[0] / lengths[0] + digits[1] / lengths[1];
    if (x.spacing / y.spacing - 1.0).abs() > open {
        [x.spacing, y.spacing]
    } else if lengths[0] >= lengths[1] {
        [x.spacing; 2]
    } else {
        [y.spacing; 2]
    }
}
