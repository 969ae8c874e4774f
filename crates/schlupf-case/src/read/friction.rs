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
        _ => {
            let limit = settings.number("friction.temperature_at_zero_friction")?;
            let floor = settings.number("friction.minimum_coefficient")?;
            Arc::new(TemperatureLinear::new(coefficient, limit, floor).map_err(explain)?)
        }
    };
    let reference_temperature = settings.number("friction.reference_temperature")?;
    Ok(Friction { law, reference_temperature })
}
