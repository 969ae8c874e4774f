//! `[friction]`.

use std::sync::Arc;

use schlupf::interface::friction::constant::Constant;
use schlupf::interface::friction::temperature_linear::TemperatureLinear;
use schlupf::interface::friction::{Friction, FrictionLaw};

use crate::error::CaseError;
use crate::settings::Settings;

/// The law of friction and the temperature that it counts from.
pub fn friction(settings: &Settings) -> Result<Friction, CaseError> {
    let coefficient = settings.number("friction.coefficient")?;
    let explain = |error| settings.explain(&error);
    let law: Arc<dyn FrictionLaw> = match settings.choice("friction.model")? {
        "constant" => Arc::new(Constant::new(coefficient).map_err(explain)?),
        _ => Arc::new(temperature_linear(settings, coefficient)?),
    };
    let reference_temperature = settings.number("friction.reference_temperature")?;
    Ok(Friction { law, reference_temperature })
}

fn temperature_linear(
    settings: &Settings,
    coefficient: f64,
) -> Result<TemperatureLinear, CaseError> {
    let limit = settings.number("friction.temperature_at_zero_friction")?;
    let floor = settings.number("friction.minimum_coefficient")?;
    TemperatureLinear::new(coefficient, limit, floor).map_err(|error| settings.explain(&error))
}
