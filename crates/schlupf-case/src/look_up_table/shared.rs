//! Tables that methods of solution share.

use std::sync::{Arc, Mutex, PoisonError, Weak};

use crate::look_up_table::archive::{StoredTable, TableFileError};

/// The bytes of a file and the table in it.
type Kept = (Box<[u8]>, Weak<StoredTable>);

static KEPT: Mutex<Vec<Kept>> = Mutex::new(Vec::new());

/// The table in a file: the same bytes give the same table as long as anyone has it.
///
/// # Errors
/// Those of [`StoredTable::from_bytes`].
pub fn shared(bytes: &[u8]) -> Result<Arc<StoredTable>, TableFileError> {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    kept.retain(|(_, table)| table.strong_count() > 0);
    let known = kept.iter().find(|(file, _)| **file == *bytes);
    if let Some(table) = known.and_then(|(_, table)| table.upgrade()) {
        return Ok(table);
    }
    let table = Arc::new(StoredTable::from_bytes(bytes)?);
    kept.push((bytes.into(), Arc::downgrade(&table)));
    Ok(table)
}
