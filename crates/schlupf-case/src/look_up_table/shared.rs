//! Tables that methods of solution share.

use std::sync::{Arc, Mutex, PoisonError, Weak};

use schlupf::problem::look_up_table::LookUpTable;

use crate::look_up_table::Metadata;
use crate::look_up_table::archive::{StoredTable, TableFileError};

/// The bytes of a file, and what is in it.
type Kept = (Box<[u8]>, Metadata, Weak<LookUpTable>);

static KEPT: Mutex<Vec<Kept>> = Mutex::new(Vec::new());

/// The table in a file: the same bytes give the same table as long as anyone has it.
///
/// # Errors
/// Those of [`StoredTable::from_bytes`].
pub fn shared(bytes: &[u8]) -> Result<StoredTable, TableFileError> {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    kept.retain(|(.., table)| table.strong_count() > 0);
    let known = kept.iter().find(|(file, ..)| **file == *bytes);
    let known = known.and_then(|(_, metadata, table)| Some((metadata, table.upgrade()?)));
    if let Some((metadata, table)) = known {
        return Ok(StoredTable { table, metadata: metadata.clone() });
    }
    let stored = StoredTable::from_bytes(bytes)?;
    kept.push((bytes.into(), stored.metadata.clone(), Arc::downgrade(&stored.table)));
    Ok(stored)
}
