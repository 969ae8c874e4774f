//! `[grid]`, `[solver]` and `[fastsim]`.

use schlupf::method::{
    AreaReduction, Brush, FastMethod, Flexibilities, SlopeReduction, TractionBound,
};
use schlupf::problem::Branch;
use schlupf::{Method, Options};

use crate::case::Driver;
use crate::error::CaseError;
use crate::settings::Settings;

/// Numerical options.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    Ok(Options {
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

/// Which way to the solution was asked for.
pub fn driver(settings: &Settings) -> Result<Option<Driver>, CaseError> {
    let driver = settings.is_given("solver.driver").then(|| settings.choice("solver.driver"));
    Ok(driver.transpose()?.map(|name| match name {
        "marching" => Driver::Marching,
        _ => Driver::Steady,
    }))
}

/// What is solved, with the parameters of a fast method.
pub fn method(settings: &Settings) -> Result<Method, CaseError> {
    let method = match settings.choice("solver.method")? {
        "kalker-linear" => FastMethod::KalkerLinear,
        "shen-hedrick-elkins" => FastMethod::ShenHedrickElkins,
        "polach" => FastMethod::Polach(AreaReduction {
            area_adhesion: settings.number("solver.polach_area_adhesion")?,
            area_slip: settings.number("solver.polach_area_slip")?,
        }),
        "fastsim" => FastMethod::Fastsim(brush(settings)?),
        "modified-fastsim" => {
            let reduction = SlopeReduction {
                initial: settings.number("fastsim.initial_reduction")?,
                limit_ratio: settings.number("fastsim.reduction_limit_ratio")?,
                decay: settings.number("fastsim.reduction_decay")?,
            };
            FastMethod::ModifiedFastsim(brush(settings)?, reduction)
        }
        _ => return Ok(Method::Full),
    };
    method.check().map_err(|error| settings.explain(&error))?;
    Ok(Method::Fast(method))
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
