//! `[grid]` and `[solver]`.

use schlupf::Options;

use crate::error::CaseError;
use crate::settings::Settings;

/// Numerical options.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    Ok(Options {
        cells_x: settings.count("grid.cells_x")?,
        cells_y: settings.count("grid.cells_y")?,
        tolerance: settings.number("solver.tolerance")?,
        max_iterations: settings.count("solver.max_iterations")?,
        max_steps: settings.count("solver.max_steps")?,
        slip_threshold: settings.number("solver.slip_threshold")?,
    })
}
