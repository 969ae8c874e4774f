//! Puts the shares of a study together.

use std::path::{Path, PathBuf};

use crate::study::error::StudyError;
use crate::study::lock::OutputLock;
use crate::study::parts::{folder_with, unfinished};
use crate::study::run::{Report, assemble, existing};
use crate::study::table::{Cells, Contents, Format, Place, Reader, Rows};

/// Shards whose files stay open together, dimensionless; a process may open 1024 as a rule.
const OPEN: usize = 256;

/// A table to merge, open or not.
struct Shard<'a> {
    path: &'a Path,
    contents: Contents,
    reading: Reading,
}

enum Reading {
    Open(Box<Reader>),
    /// Closed, to go on from here.
    Closed(Place),
}

impl<'a> Shard<'a> {
    /// Reads what the table is of.
    fn open(path: &'a Path, stays_open: bool) -> Result<Self, StudyError> {
        let reader = Reader::open(path)?;
        let contents = reader.contents().clone();
        let place = reader.place();
        let reading =
            if stays_open { Reading::Open(Box::new(reader)) } else { Reading::Closed(place) };
        Ok(Self { path, contents, reading })
    }

    /// The rows of its next batch; `None` at the end.
    fn next_batch(&mut self) -> Result<Option<Rows>, StudyError> {
        match &mut self.reading {
            Reading::Open(reader) => reader.next_batch(),
            Reading::Closed(place) => {
                let mut reader = Reader::open_at(self.path, *place)?;
                let rows = reader.next_batch()?;
                *place = reader.place();
                Ok(rows)
            }
        }
    }
}

/// Writes the table of all shards: the same, byte for byte, as that of a run without shards.
///
/// # Errors
/// Tables of different studies, a shard that is missing, there twice or not whole, an output that
/// is something else than the table of this study or that another run writes, and files that cannot
/// be read or written.
pub fn merge(shards: &[PathBuf], output: &Path) -> Result<Report, StudyError> {
    Format::of(output)?;
    let stays_open = shards.len() <= OPEN;
    let shards = shards.iter().map(|path| Shard::open(path, stays_open));
    let mut shards = shards.collect::<Result<Vec<_>, _>>()?;
    let Some(first) = shards.first() else {
        return Err(StudyError::table(output, "merging needs the tables of shards"));
    };
    let whole = Contents { shard: [1, 1], ..first.contents.clone() };
    let count = first.contents.shard[1];
    for Shard { path, contents, .. } in &shards {
        let mut own = contents.clone();
        let shards = std::mem::replace(&mut own.shard, [1, 1])[1];
        if own != whole || shards != count {
            let first = first.path.display();
            let reason = if own.program == whole.program {
                format!("it is not of the same study as {first}")
            } else {
                format!("it is of {}, but {first} is of {}", own.program, whole.program)
            };
            return Err(StudyError::table(path, reason));
        }
    }
    shards.sort_by_key(|shard| shard.contents.shard[0]);
    for shard in 1..=count {
        let mut of_shard = shards.iter().filter(|one| one.contents.shard[0] == shard);
        match (of_shard.next(), of_shard.next()) {
            (Some(_), None) => {}
            (None, _) => {
                let reason = format!("shard {shard}/{count} is missing among the tables to merge");
                return Err(StudyError::table(output, reason));
            }
            (Some(one), Some(other)) => {
                let reason = format!("it is shard {shard}/{count}, as {} is", one.path.display());
                return Err(StudyError::table(other.path, reason));
            }
        }
    }
    if output.exists() {
        return existing(output, &whole);
    }
    let _lock = OutputLock::take(output).map_err(|cause| StudyError::file(output, cause))?;
    // Another run may just have ended.
    if output.exists() {
        return existing(output, &whole);
    }
    let mut report = Report::default();
    assemble(output, unfinished(folder_with(output)), &whole, &mut |batch| {
        let shard = &mut shards[batch % count];
        let rows = shard.next_batch()?;
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
                Err(StudyError::table(shard.path, reason))
            }
        }
    })?;
    Ok(report)
}
