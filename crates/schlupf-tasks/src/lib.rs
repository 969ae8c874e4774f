//! What a case can be asked, from the case to a report: the part that all faces share.
//!
//! A [`Task`] has a name, a request and a report. [`TASKS`] lists them: a face gives values to the
//! fields of a request, has it read ([`Entry::read`](task::Entry::read)) and done for a case, and
//! renders the report, which knows its own summary, JSON, tables, figures and files. A new task is
//! one file and one line there. Tasks read no arguments and write no files.
//!
//! ```
//! use schlupf_case::{CaseFile, Folder, Overrides};
//! use schlupf_tasks::{Asked, Face, Given, TaskError, Value, Wanted, find};
//!
//! let text = "kinematics.creepage_x = 0.002\ngrid = { cells_x = 10, cells_y = 10 }";
//! let case = CaseFile::from_str(text, "a case", Folder::new(""), Overrides::NONE)?;
//! let task = find("subsurface").ok_or("no such task")?;
//! let asked = Asked::new(Face::Functions, (task.fields)(), |field| match field.name {
//!     "x" => Ok(vec![Value::Text("-1 mm".to_owned())]),
//!     _ => Ok::<_, TaskError>(vec![]),
//! })?;
//! let work = (task.read)(&asked)?;
//! let found = work(&Given::of(&case), &Wanted::default(), &schlupf::unwatched)?;
//! assert!(found.report.summary().to_string().contains("von Mises"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod error;
mod notice;
pub mod output;
pub mod request;
pub mod task;
pub mod contact_law;
pub mod solve;
mod patch;
mod curve;
mod roughness;
#[cfg(feature = "compare")]
mod compare;
mod temperature;
mod subsurface;
mod wear;
#[cfg(feature = "bulk")]
mod bulk;
#[cfg(feature = "fitting")]
mod calibrate;
#[cfg(feature = "fitting")]
mod fit;
mod wheelset;
mod catalogue;
pub mod states;
#[cfg(feature = "study")]
pub mod study;

pub use catalogue::catalogue;
pub use error::TaskError;
pub use notice::Notice;
pub use request::{Asked, Face, Value};
pub use task::{Entry, Given, Task, Wanted};

use schlupf::Warning;
use schlupf::reporting::Message;
use schlupf_case::{FieldNames, import};

/// All tasks, in the order of help.
pub const TASKS: &[Entry] = &[
    Entry::of::<solve::Solve>(),
    Entry::of::<patch::ContactPatch>(),
    Entry::of::<curve::Curve>(),
    Entry::of::<roughness::Roughness>(),
    #[cfg(feature = "compare")]
    Entry::of::<compare::Compare>(),
    Entry::of::<temperature::Temperature>(),
    Entry::of::<subsurface::Subsurface>(),
    Entry::of::<wear::Wear>(),
    #[cfg(feature = "bulk")]
    Entry::of::<bulk::Bulk>(),
    #[cfg(feature = "fitting")]
    Entry::of::<calibrate::Calibrate>(),
    #[cfg(feature = "fitting")]
    Entry::of::<fit::Fit>(),
    Entry::of::<wheelset::Wheelset>(),
    #[cfg(feature = "study")]
    Entry::of::<study::damage::Damage>(),
];

/// The task with a name.
pub fn find(name: &str) -> Option<&'static Entry> {
    TASKS.iter().find(|task| task.name == name)
}

/// The codes of all warnings with what they mean, in Markdown.
pub fn warning_codes() -> Vec<(&'static str, &'static str)> {
    [Warning::codes(), schlupf_case::Notice::codes(), import::Notice::codes(), Notice::codes()]
        .concat()
}

/// Warnings of the core in the words of a case file.
pub fn messages<'a>(
    warnings: impl IntoIterator<Item = &'a Warning>,
) -> impl Iterator<Item = Message> {
    warnings.into_iter().map(|warning| warning.message(&FieldNames::CASE))
}
