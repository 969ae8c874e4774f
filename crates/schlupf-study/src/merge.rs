//! Puts the shares of a study together.

use std::path::{Path, PathBuf};

use crate::error::StudyError;
use crate::parts::{folder_with, unfinished};
use crate::run::{Report, assemble};
use crate::table::{Cells, Contents, Format, Reader};

/// Writes the table of all shards: the same, byte for byte, as that of a run without shards.
///
/// # Errors
/// Tables of different studies, a shard that is missing, there twice or not whole, and files that
/// cannot be read or written.
pub fn merge(shards: &[PathBuf], output: &Path) -> Result<Report, StudyError> {
    Format::of(output)?;
    let mut readers = Vec::new();
    for path in shards {
        readers.push((path, Reader::open(path)?));
    }
    let Some((first, reader)) = readers.first() else {
        return Err(StudyError::table(output, "merging needs the tables of shards"));
    };
    let whole = Contents { shard: [1, 1], ..reader.contents().clone() };
    let count = reader.contents().shard[1];
    for (path, reader) in &readers {
        let mut own = reader.contents().clone();
        let shards = std::mem::replace(&mut own.shard, [1, 1])[1];
        if own != whole || shards != count {
            let first = first.display();
            let reason = if own.program == whole.program {
                format!("it is not of the same study as {first}")
            } else {
                format!("it is of {}, but {first} is of {}", own.program, whole.program)
            };
            return Err(StudyError::table(path, reason));
        }
    }
    readers.sort_by_key(|(_, reader)| reader.contents().shard[0]);
    for shard in 1..=count {
        let mut of_shard = readers.iter().filter(|(_, reader)| reader.contents().shard[0] == shard);
        match (of_shard.next(), of_shard.next()) {
            (Some(_), None) => {}
            (None, _) => {
                let reason = format!("shard {shard}/{count} is missing among the tables to merge");
                return Err(StudyError::table(output, reason));
            }
            (Some((one, _)), Some((other, _))) => {
                let reason = format!("it is shard {shard}/{count}, as {} is", one.display());
                return Err(StudyError::table(other, reason));
            }
        }
    }
    let mut report = Report::default();
    assemble(output, unfinished(folder_with(output)), &whole, &mut |batch| {
        let (path, reader) = &mut readers[batch % count];
        let rows = reader.next_batch()?;
        let wanted = whole.rows_of(batch);
        let is_whole = rows.as_ref().is_some_and(|rows| {
            let index = rows.first();
            let starts = matches!(index, Some(Cells::Counts(index))
                if index.first().copied() == i64::try_from(wanted.start).ok());
            starts && rows.iter().all(|cells| cells.len() == wanted.len())
        });
        match rows {
            Some(rows) if is_whole => {
                report.add(&whole, &rows);
                Ok(rows)
            }
            _ => {
                let reason = format!("it lacks rows from {} on", wanted.start);
                Err(StudyError::table(path, reason))
            }
        }
    })?;
    Ok(report)
}
