//! Heights in `NumPy`'s .npy format, which says neither their unit nor their spacing.

use schlupf::surface::Lattice;

use super::{MeasuredSurface, Reading, finish, unit};
use crate::error::CaseError;
use crate::tables::npy;

/// Rows along x; an array of one dimension is a line.
pub fn read(name: &str, bytes: &[u8], how: Reading) -> Result<MeasuredSurface, CaseError> {
    let array = npy::parse_map_or_line(bytes).map_err(|message| how.refusal(name, message))?;
    let convert = unit(name, how)?;
    let [spacing_x, spacing_y] = how.spacings(name)?;
    let lattice = Lattice { columns: array.columns, rows: array.rows, spacing_x, spacing_y };
    let heights = array.values.into_iter().map(|height| convert.apply(height)).collect();
    finish(name, lattice, heights, how)
}
