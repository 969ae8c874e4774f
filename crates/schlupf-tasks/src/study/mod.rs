//! Studies: many states of a case, each a row of results in one table.
//!
//! A [`Study`] is a case and what varies over it. [`run`](run::run) solves its rows in batches on
//! all threads and writes each batch as soon as it is done, so that a run that ends early goes on
//! where it was; [`merge`](merge::merge) puts the shares of several machines together. The table is
//! the same, byte for byte, however the work was divided. [`damage`] makes wear and fatigue of the
//! table of a run.

mod batch;
mod chunks;
mod columns;
mod counts;
pub mod damage;
pub mod design;
mod digest;
mod error;
pub mod lock;
pub mod merge;
mod order;
mod parts;
mod plan;
pub mod run;
mod solved;
pub mod table;

pub use counts::Counts;
pub use error::StudyError;
pub use plan::Study;

/// A folder to work in.
///
/// # Errors
/// Whatever keeps it from being made.
pub fn scratch() -> std::io::Result<crate::task::Scratch> {
    Ok(Box::new(tempfile::tempdir()?))
}
