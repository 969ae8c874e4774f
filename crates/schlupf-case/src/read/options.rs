//! `[grid]` and `[solver]`.

use schlupf::Options;
use schlupf::problem::{Branch, Driver};

use crate::error::CaseError;
use crate::settings::Settings;

/// Numerical options.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    let driver = settings.is_given("solver.driver").then(|| settings.choice("solver.driver"));
    let driver = match driver.transpose()? {
        None => None,
        Some("marching") => Some(Driver::Marching),
        Some(_) => Some(Driver::Steady),
    };
    Ok(Options {
        driver,
        cells_x: settings.count("grid.cells_x")?,
        cells_y: settings.count("grid.cells_y")?,
        branch: match settings.choice("solver.branch")? {
            "high-slip" => Branch::HighSlip,
            _ => Branch::LowSlip,
        },
        tolerance: settings.number("solver.tolerance")?,
        max_iterations: settings.count("solver.max_iterations")?,
        max_steps: settings.count("solver.max_steps")?,
        slip_threshold: settings.number("solver.slip_threshold")?,
        sensitivity: settings.flag("solver.sensitivity")?,
    })
}
