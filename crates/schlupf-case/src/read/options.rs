//! `[grid]`, `[solver]`, `[fastsim]` and `[element]`.

use super::kinematics::rolling_radius;
use crate::FieldPath;
use std::sync::Arc;

use schlupf::element;
use schlupf::problem::look_up_table::LookUpTable;
use schlupf::problem::{
    AreaReduction, Branch, Brush, Driver, FastMethod, Flexibilities, SlopeReduction, TractionBound,
};
use schlupf::{Method, Options};

use crate::error::CaseError;
use crate::fields::choice::{
    BoundChoice, BranchChoice, DriverChoice, ElementMotion, ElementNormal, FlexibilitiesChoice,
    MethodChoice,
};
use crate::settings::Settings;

const TABLE: FieldPath = field!("solver.table");

/// Numerical options.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    Ok(Options {
        cells_x: settings.count(field!("grid.cells_x"))?,
        cells_y: settings.count(field!("grid.cells_y"))?,
        tolerance: settings.number(field!("solver.tolerance"))?,
        max_iterations: settings.count(field!("solver.max_iterations"))?,
        max_steps: settings.count(field!("solver.max_steps"))?,
        slip_threshold: settings.number(field!("solver.slip_threshold"))?,
        sensitivity: settings.flag(field!("solver.sensitivity"))?,
        fields_every: 0,
        extrapolate: settings.flag(field!("solver.extrapolate"))?,
        keeps_state: true,
    })
}

/// What a force element takes, and how it behaves at standstill.
pub fn element(settings: &Settings) -> Result<element::Settings, CaseError> {
    Ok(element::Settings {
        motion: match settings.chosen(field!("element.motion"))? {
            ElementMotion::Velocities => element::Motion::Velocities,
            ElementMotion::Creepages => element::Motion::Creepages,
        },
        normal: match settings.chosen(field!("element.normal"))? {
            ElementNormal::Load => element::Normal::Load,
            ElementNormal::Approach => element::Normal::Approach,
        },
        has_memory: settings.flag(field!("element.memory"))?,
        standstill_speed: settings.number(field!("element.standstill_speed"))?,
        rolling_radius: rolling_radius(settings)?,
    })
}

/// The driver that was asked for.
pub fn driver(settings: &Settings) -> Result<Option<Driver>, CaseError> {
    if !settings.is_given(field!("solver.driver")) {
        return Ok(None);
    }
    Ok(Some(match settings.chosen(field!("solver.driver"))? {
        DriverChoice::Steady => Driver::Steady,
        DriverChoice::Marching => Driver::Marching,
    }))
}

/// Which of several steady states.
pub fn branch(settings: &Settings) -> Result<Branch, CaseError> {
    Ok(match settings.chosen(field!("solver.branch"))? {
        BranchChoice::LowSlip => Branch::LowSlip,
        BranchChoice::HighSlip => Branch::HighSlip,
    })
}

/// What is solved, with the parameters of a fast method.
pub fn method(settings: &Settings) -> Result<Method, CaseError> {
    let method = match settings.chosen(field!("solver.method"))? {
        MethodChoice::Full => return Ok(Method::Full),
        MethodChoice::KalkerLinear => FastMethod::KalkerLinear,
        MethodChoice::ShenHedrickElkins => FastMethod::ShenHedrickElkins,
        MethodChoice::Polach => FastMethod::Polach(AreaReduction {
            area_adhesion: settings.number(field!("solver.polach_area_adhesion"))?,
            area_slip: settings.number(field!("solver.polach_area_slip"))?,
        }),
        MethodChoice::Table => FastMethod::Table(look_up_table(settings)?),
        MethodChoice::Fastsim => FastMethod::Fastsim(brush(settings)?),
        MethodChoice::ModifiedFastsim => {
            let reduction = SlopeReduction {
                initial: settings.number(field!("fastsim.initial_reduction"))?,
                limit_ratio: settings.number(field!("fastsim.reduction_limit_ratio"))?,
                decay: settings.number(field!("fastsim.reduction_decay"))?,
            };
            FastMethod::ModifiedFastsim(brush(settings)?, reduction)
        }
    };
    method.check().map_err(|error| settings.explain(&error))?;
    Ok(Method::Fast(method))
}

/// The table that was given, or the standard one.
fn look_up_table(settings: &Settings) -> Result<Arc<LookUpTable>, CaseError> {
    let stored = if settings.is_given(TABLE) {
        let (name, bytes) = settings.read_file(TABLE)?;
        crate::look_up_table::shared(&bytes)
            .map_err(|error| settings.error(TABLE, format!("{TABLE}: {name} {error}")))
    } else {
        crate::look_up_table::standard().map_err(|error| {
            settings.error(field!("solver.method"), format!("the standard table {error}"))
        })
    };
    Ok(stored?.table)
}

/// The bound of FASTSIM.
const BOUND: FieldPath = field!("fastsim.bound");

fn brush(settings: &Settings) -> Result<Brush, CaseError> {
    let flexibilities = match settings.chosen(field!("fastsim.flexibilities"))? {
        FlexibilitiesChoice::Three => Flexibilities::Three,
        FlexibilitiesChoice::One => Flexibilities::One,
    };
    // The paraboloid exceeds the pressure by a third, so a layer would flow where it does not.
    let flows = settings.is_given(field!("layer.yield_stress"));
    let bound = match settings.chosen(BOUND)? {
        BoundChoice::Parabolic if flows && settings.is_given(BOUND) => {
            let reason = "must be \"elliptic\" with layer.yield_stress: the paraboloid exceeds the \
                          pressure, so the layer would flow too early";
            return Err(settings.error(BOUND, format!("{BOUND} {reason}")));
        }
        BoundChoice::Parabolic if flows => TractionBound::Elliptic,
        BoundChoice::Parabolic => TractionBound::Parabolic,
        BoundChoice::Elliptic => TractionBound::Elliptic,
    };
    Ok(Brush { flexibilities, bound })
}
