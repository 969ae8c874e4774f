//! Heights in `NumPy`'s .npy format, which says neither their unit nor their spacing.

use schlupf::surface::Lattice;

use super::{MeasuredSurface, SurfaceOptions, finish, refusal, unit};
use crate::error::CaseError;
use crate::place::Place;
use crate::tables::npy;

/// Rows along x; an array of one dimension is a line.
pub fn read(
    name: &str,
    bytes: &[u8],
    options: &SurfaceOptions,
) -> Result<MeasuredSurface, CaseError> {
    let array = npy::parse_map_or_line(bytes).map_err(|message| refusal(name, message))?;
    let convert = unit(name, options)?;
    let [spacing_x, spacing_y] = options.spacing.ok_or_else(|| {
        let message =
            format!("surface.spacing must be given, because {name} does not say how far its points are apart");
        CaseError::new("surface.spacing", message, Place::File { name: name.to_owned() })
    })?;
    let lattice = Lattice { columns: array.columns, rows: array.rows, spacing_x, spacing_y };
    let heights = array.values.into_iter().map(|height| convert.apply(height)).collect();
    finish(name, lattice, heights, options)
}
