//! `[grid]`, `[solver]` and `[fastsim]`.

use schlupf::Options;
use schlupf::method::{AreaReduction, Brush, Flexibilities, Method, SlopeReduction, TractionBound};
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
        method: method(settings)?,
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

/// What is solved, with the parameters of a fast method.
fn method(settings: &Settings) -> Result<Method, CaseError> {
    Ok(match settings.choice("solver.method")? {
        "kalker-linear" => Method::KalkerLinear,
        "shen-hedrick-elkins" => Method::ShenHedrickElkins,
        "polach" => Method::Polach(AreaReduction {
            area_adhesion: settings.number("solver.polach_area_adhesion")?,
            area_slip: settings.number("solver.polach_area_slip")?,
        }),
        "fastsim" => Method::Fastsim(brush(settings)?),
        "modified-fastsim" => {
            let reduction = SlopeReduction {
                initial: settings.number("fastsim.initial_reduction")?,
                limit_ratio: settings.number("fastsim.reduction_limit_ratio")?,
                decay: settings.number("fastsim.reduction_decay")?,
            };
            Method::ModifiedFastsim(brush(settings)?, reduction)
        }
        _ => Method::Full,
    })
}

fn brush(settings: &Settings) -> Result<Brush, CaseError> {
    let flexibilities = match settings.choice("fastsim.flexibilities")? {
        "one" => Flexibilities::One,
        _ => Flexibilities::Three,
    };
    let bound = match settings.choice("fastsim.bound")? {
        "elliptic" => TractionBound::Elliptic,
        _ => TractionBound::Parabolic,
    };
    Ok(Brush { flexibilities, bound })
}
