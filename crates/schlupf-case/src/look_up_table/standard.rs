//! The table that comes with the program.

use std::sync::OnceLock;

use crate::look_up_table::archive::{StoredTable, TableFileError};

const BYTES: &[u8] = include_bytes!("standard.npz");

/// The standard table: a/b from 0.1 to 10, all creepages, ν = 0.28, Coulomb's law; `schlupf table`
/// without options makes it. It is read once.
///
/// ```
/// let standard = schlupf_case::look_up_table::standard()?;
/// // A circle that is nearly all slides.
/// let force = standard.table.normalised_force(1.0, [1.0, 0.0, 0.0]).force;
/// assert!(force[0] < -0.99 && force[0] >= -1.0);
/// # Ok::<(), schlupf_case::look_up_table::TableFileError>(())
/// ```
///
/// # Errors
/// None, unless the program was built from a damaged file.
pub fn standard() -> Result<StoredTable, TableFileError> {
    static STANDARD: OnceLock<Result<StoredTable, TableFileError>> = OnceLock::new();
    STANDARD.get_or_init(|| StoredTable::from_bytes(BYTES)).clone()
}
