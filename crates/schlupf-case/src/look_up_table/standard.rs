//! The table that comes with the program.

use std::sync::OnceLock;

use crate::look_up_table::archive::{StoredTable, TableFileError};

/// In a browser it is fetched when it is asked for: see [`provide`].
const BYTES: &[u8] =
    if cfg!(target_family = "wasm") { &[] } else { include_bytes!("standard.npz") };

static STANDARD: OnceLock<Result<StoredTable, TableFileError>> = OnceLock::new();

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
    if BYTES.is_empty() && STANDARD.get().is_none() {
        return StoredTable::from_bytes(BYTES);
    }
    STANDARD.get_or_init(|| StoredTable::from_bytes(BYTES)).clone()
}

/// The bytes of `standard.npz`, where it is not part of the program.
pub fn provide(bytes: &[u8]) {
    STANDARD.get_or_init(|| StoredTable::from_bytes(bytes));
}
