//! `[friction]`.

use std::path::Path;
use std::sync::Arc;

use schlupf::interface::friction::across::Across;
use schlupf::interface::friction::constant::Constant;
use schlupf::interface::friction::exponential::Exponential;
use schlupf::interface::friction::linear::Linear;
use schlupf::interface::friction::memory::FrictionMemory;
use schlupf::interface::friction::polach::Polach;
use schlupf::interface::friction::product::Product;
use schlupf::interface::friction::rational::Rational;
use schlupf::interface::friction::slip_terms::{SecondTerm, SlipTerms};
use schlupf::interface::friction::temperature_linear::TemperatureLinear;
use schlupf::interface::friction::temperature_piecewise_linear::TemperaturePiecewiseLinear;
use schlupf::interface::friction::{Friction, FrictionLaw};

use crate::error::CaseError;
use crate::settings::Settings;
use crate::tables;

type Law = Arc<dyn FrictionLaw>;

const MODEL: &str = "friction.model";
const SPEED_MODEL: &str = "friction.speed_model";
const VARIATION: [&str; 2] = ["friction.variation_y", "friction.variation_factor"];
const FILE: &str = "friction.variation_file";

/// The law of friction and the temperature that it counts from; `folder` is where relative paths start.
pub fn friction(settings: &Settings, folder: &Path) -> Result<Friction, CaseError> {
    let mut law = named(settings, settings.choice(MODEL)?)?;
    if settings.is_given(SPEED_MODEL) && settings.choice(SPEED_MODEL)? != "none" {
        let falling = named(settings, settings.choice(SPEED_MODEL)?)?;
        let product = Product::new(law, falling).map_err(|error| settings.explain(&error))?;
        law = Arc::new(product);
    }
    if let Some([y, factor]) = variation(settings, folder)? {
        let across = Across::new(law, y, factor).map_err(|error| settings.explain(&error))?;
        law = Arc::new(across);
    }
    let reference_temperature = settings.number("friction.reference_temperature")?;
    let memory = match settings.optional_number("friction.memory_distance")? {
        Some(distance) => {
            let least_speed = settings.optional_number("friction.memory_speed")?.unwrap_or(0.0);
            let memory = FrictionMemory::new(distance, least_speed);
            Some(memory.map_err(|error| settings.explain(&error))?)
        }
        None => None,
    };
    Ok(Friction { memory, ..Friction::new(law, reference_temperature) })
}

/// The law that a choice names.
fn named(settings: &Settings, name: &str) -> Result<Law, CaseError> {
    let coefficient = settings.number("friction.coefficient")?;
    let explain = |error| settings.explain(&error);
    Ok(match name {
        "constant" => Arc::new(Constant::new(coefficient).map_err(explain)?),
        "temperature-piecewise-linear" => {
            let hot = settings.number("friction.hot_coefficient")?;
            let range = settings.number("friction.temperature_range")?;
            let law = TemperaturePiecewiseLinear::new(coefficient, hot, range);
            Arc::new(law.map_err(explain)?)
        }
        "polach" => {
            let limit_ratio = settings.number("friction.limit_ratio")?;
            let decay = settings.number("friction.decay")?;
            Arc::new(Polach::new(coefficient, limit_ratio, decay).map_err(explain)?)
        }
        "exponential" | "rational" | "linear-in-speed" => terms(settings, name, coefficient)?,
        _ => {
            let limit = settings.number("friction.temperature_at_zero_friction")?;
            let floor = settings.number("friction.minimum_coefficient")?;
            Arc::new(TemperatureLinear::new(coefficient, limit, floor).map_err(explain)?)
        }
    })
}

/// A law with one or two terms that fall with the slip speed.
fn terms(settings: &Settings, name: &str, coefficient: f64) -> Result<Law, CaseError> {
    let kinetic = settings.number("friction.kinetic_coefficient")?;
    let half_speed = settings.number("friction.half_speed")?;
    let second = match settings.optional_number("friction.second_coefficient")? {
        Some(coefficient) => {
            let half_speed = settings.number("friction.second_half_speed")?;
            Some(SecondTerm { coefficient, half_speed })
        }
        None => None,
    };
    let terms = SlipTerms::new(coefficient, kinetic, half_speed, second)
        .map_err(|error| settings.explain(&error))?;
    Ok(match name {
        "rational" => Arc::new(Rational(terms)),
        "linear-in-speed" => Arc::new(Linear(terms)),
        _ => Arc::new(Exponential(terms)),
    })
}

/// Positions and factors, where friction varies over y.
fn variation(settings: &Settings, folder: &Path) -> Result<Option<[Vec<f64>; 2]>, CaseError> {
    if settings.is_given(FILE) {
        let path = folder.join(settings.text(FILE)?);
        let bytes = tables::read_bytes(&path, FILE, settings.place(FILE))?;
        return tables::variation_from_csv(path.display().to_string(), bytes).map(Some);
    }
    let [y, factor] = VARIATION.map(|path| settings.series(path));
    match (y, factor) {
        (None, None) => Ok(None),
        (Some(y), Some(factor)) => Ok(Some([y.to_vec(), factor.to_vec()])),
        (Some(_), None) => Err(settings.missing_beside(VARIATION[1], VARIATION[0])),
        (None, Some(_)) => Err(settings.missing_beside(VARIATION[0], VARIATION[1])),
    }
}
