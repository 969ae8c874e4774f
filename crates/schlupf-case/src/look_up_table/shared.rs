//! Tables that last as long as the program, as methods of solution need them.

use std::sync::{Mutex, PoisonError};

use crate::look_up_table::archive::{StoredTable, TableFileError};

/// The bytes of a file and the table in it.
type Kept = (Box<[u8]>, &'static StoredTable);

static KEPT: Mutex<Vec<Kept>> = Mutex::new(Vec::new());

/// The table in a file, which is kept until the program ends: the same bytes give the same table,
/// and take no more memory.
///
/// # Errors
/// Those of [`StoredTable::from_bytes`].
pub fn shared(bytes: &[u8]) -> Result<&'static StoredTable, TableFileError> {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, table)) = kept.iter().find(|(file, _)| **file == *bytes) {
        return Ok(table);
    }
    let table: &'static StoredTable = Box::leak(Box::new(StoredTable::from_bytes(bytes)?));
    kept.push((bytes.into(), table));
    Ok(table)
}
