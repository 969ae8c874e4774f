//! What a case can be asked, from the case to a report: the part that the command and the Python
//! package share.
//!
//! A task reads no arguments and writes no files. Errors are those of the core; each face tells them
//! in its own words, with [`schlupf_case::Case::explain`] or without.

#![forbid(unsafe_code)]

pub mod contact_law;
pub mod solve;

use schlupf::Warning;
use schlupf::message::Message;
use schlupf_case::FieldNames;

/// Warnings of the core in the words of a case file.
pub fn messages<'a>(
    warnings: impl IntoIterator<Item = &'a Warning>,
) -> impl Iterator<Item = Message> {
    warnings.into_iter().map(|warning| warning.message(&FieldNames::CASE))
}
