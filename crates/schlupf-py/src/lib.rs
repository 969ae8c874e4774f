//! The extension module `schlupf._core` of the Python package.
//!
//! It reads and solves cases, and hands out numbers; what a user of Python sees (attributes, data
//! sets, plots, documentation) is made of that in the package, see `python/schlupf`.

#![allow(clippy::needless_pass_by_value, reason = "arguments from Python are extracted by value")]

mod case_file;
mod conditions;
mod curve;
mod errors;
mod fields;
mod interruptible;
mod records;
mod solution;

use pyo3::prelude::pymodule;

/// Compiled part of schlupf.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::case_file::CaseFile;
    #[pymodule_export]
    use super::conditions::{BatchSolver, batch};
    #[pymodule_export]
    use super::curve::{CreepCurve, creep_curve};
    #[pymodule_export]
    use super::fields::{field_table, warning_codes};
    #[pymodule_export]
    use super::solution::Solution;

    /// Version of the library.
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "its name in Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
