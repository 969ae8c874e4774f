//! What a case can be asked, from the case to a report: the part that the command and the Python
//! package share.
//!
//! A task takes a request in SI units with the names that messages call its parts by, since a face
//! has options or arguments for them. It checks whatever can be checked before the work (`plan`),
//! and does the work (`find`). It reads no arguments and writes no files.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod bulk;
pub mod calibrate;
pub mod compare;
pub mod contact_law;
pub mod curve;
mod error;
pub mod fit;
pub mod import;
mod notice;
pub mod roughness;
pub mod solve;
pub mod states;
pub mod subsurface;
pub mod temperature;
pub mod wear;
pub mod wheelset;

pub use error::TaskError;
pub use notice::Notice;

use schlupf::Warning;
use schlupf::message::Message;
use schlupf_case::FieldNames;

/// Warnings of the core in the words of a case file.
pub fn messages<'a>(
    warnings: impl IntoIterator<Item = &'a Warning>,
) -> impl Iterator<Item = Message> {
    warnings.into_iter().map(|warning| warning.message(&FieldNames::CASE))
}
