//! The extension module `schlupf._core` of the Python package.
//!
//! It reads and solves cases, and hands out numbers; what a user of Python sees (attributes, data
//! sets, plots, documentation) is made of that in the package, see `python/schlupf`.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]
#![allow(clippy::needless_pass_by_value, reason = "arguments from Python are extracted by value")]

mod case_file;
mod conditions;
mod contact_table;
mod element;
mod errors;
mod fields;
mod imports;
mod interruptible;
mod laws;
mod look_up_table;
mod records;
mod report;
mod solution;
mod study;
mod tasks;

use pyo3::prelude::pymodule;

/// Compiled part of schlupf.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::case_file::CaseFile;
    #[pymodule_export]
    use super::conditions::{BatchSolver, batch, condition_status, conditions, force_names};
    #[pymodule_export]
    use super::contact_table::contact_table;
    #[pymodule_export]
    use super::element::{Element, element_status};
    #[pymodule_export]
    use super::fields::{catalogue, command, error_codes, warning_codes};
    #[pymodule_export]
    use super::imports::import_contact;
    #[pymodule_export]
    use super::look_up_table::LookUpTable;
    #[pymodule_export]
    use super::records::column_table;
    #[pymodule_export]
    use super::report::{Report, own_file, stresses_at};
    #[pymodule_export]
    use super::solution::Solution;
    #[pymodule_export]
    use super::tasks::run;

    #[pymodule_export]
    use super::study::{Study, StudyRun, merge, read_table};

    /// Version of the library.
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "its name in Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
