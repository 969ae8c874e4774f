//! `[friction]`.

use std::sync::Arc;

use schlupf::interface::friction::{
    Across, Constant, Exponential, Friction, FrictionLaw, FrictionMemory, Linear, Polach, Product,
    Rational, SecondTerm, SlipTerms, TemperatureLinear, TemperaturePiecewiseLinear, Variation,
};

use crate::error::CaseError;
use crate::fields::choice::{FrictionModel, SpeedModel};
use crate::settings::Settings;
use crate::{FieldPath, tables};

type Law = Arc<dyn FrictionLaw>;

const MODEL: FieldPath = field!("friction.model");
const SPEED_MODEL: FieldPath = field!("friction.speed_model");
const OVER_Y: FieldPath = field!("friction.variation_y");
const OVER_INCLINATION: FieldPath = field!("friction.variation_inclination");
const FACTOR: FieldPath = field!("friction.variation_factor");
const FILE: FieldPath = field!("friction.variation_file");

/// The law of friction and the temperature that it counts from.
pub fn friction(settings: &Settings) -> Result<Friction, CaseError> {
    let mut law = law(settings, settings.chosen(MODEL)?)?;
    if let Some(model) = speed_model(settings)? {
        let falling = of_slip_speed(settings, model)?;
        let product = Product::new(law, falling).map_err(|error| settings.explain(&error))?;
        law = Arc::new(product);
    }
    if let Some(variation) = variation_over_patch(settings)? {
        law = Arc::new(Across::new(law, variation));
    }
    let reference_temperature = settings.number(field!("friction.reference_temperature"))?;
    let memory = match settings.optional_number(field!("friction.memory_distance"))? {
        Some(distance) => {
            let least_speed =
                settings.optional_number(field!("friction.memory_speed"))?.unwrap_or(0.0);
            let memory = FrictionMemory::new(distance, least_speed);
            Some(memory.map_err(|error| settings.explain(&error))?)
        }
        None => None,
    };
    Ok(Friction { memory, ..Friction::new(law, reference_temperature) })
}

/// A law of the slip speed that multiplies another one.
fn speed_model(settings: &Settings) -> Result<Option<SlipLaw>, CaseError> {
    if !settings.is_given(SPEED_MODEL) {
        return Ok(None);
    }
    Ok(match settings.chosen(SPEED_MODEL)? {
        SpeedModel::Nothing => None,
        SpeedModel::Exponential => Some(SlipLaw::Exponential),
        SpeedModel::Rational => Some(SlipLaw::Rational),
        SpeedModel::LinearInSpeed => Some(SlipLaw::Linear),
        SpeedModel::Polach => Some(SlipLaw::Polach),
    })
}

fn law(settings: &Settings, model: FrictionModel) -> Result<Law, CaseError> {
    let coefficient = settings.number(field!("friction.coefficient"))?;
    let explain = |error| settings.explain(&error);
    Ok(match model {
        FrictionModel::Constant => Arc::new(Constant::new(coefficient).map_err(explain)?),
        FrictionModel::TemperatureLinear => {
            let limit = settings.number(field!("friction.temperature_at_zero_friction"))?;
            let floor = settings.number(field!("friction.minimum_coefficient"))?;
            Arc::new(TemperatureLinear::new(coefficient, limit, floor).map_err(explain)?)
        }
        FrictionModel::TemperaturePiecewiseLinear => {
            let hot = settings.number(field!("friction.hot_coefficient"))?;
            let range = settings.number(field!("friction.temperature_range"))?;
            let law = TemperaturePiecewiseLinear::new(coefficient, hot, range);
            Arc::new(law.map_err(explain)?)
        }
        FrictionModel::Exponential => of_slip_speed(settings, SlipLaw::Exponential)?,
        FrictionModel::Rational => of_slip_speed(settings, SlipLaw::Rational)?,
        FrictionModel::LinearInSpeed => of_slip_speed(settings, SlipLaw::Linear)?,
        FrictionModel::Polach => of_slip_speed(settings, SlipLaw::Polach)?,
    })
}

/// A law that falls with the slip speed.
#[derive(Clone, Copy)]
enum SlipLaw {
    Exponential,
    Rational,
    Linear,
    Polach,
}

fn of_slip_speed(settings: &Settings, law: SlipLaw) -> Result<Law, CaseError> {
    Ok(match law {
        SlipLaw::Exponential => Arc::new(Exponential(terms(settings)?)),
        SlipLaw::Rational => Arc::new(Rational(terms(settings)?)),
        SlipLaw::Linear => Arc::new(Linear(terms(settings)?)),
        SlipLaw::Polach => {
            let coefficient = settings.number(field!("friction.coefficient"))?;
            let limit_ratio = settings.number(field!("friction.limit_ratio"))?;
            let decay = settings.number(field!("friction.decay"))?;
            let law = Polach::new(coefficient, limit_ratio, decay);
            Arc::new(law.map_err(|error| settings.explain(&error))?)
        }
    })
}

/// One or two terms that fall with the slip speed.
fn terms(settings: &Settings) -> Result<SlipTerms, CaseError> {
    let coefficient = settings.number(field!("friction.coefficient"))?;
    let kinetic = settings.number(field!("friction.kinetic_coefficient"))?;
    let half_speed = settings.number(field!("friction.half_speed"))?;
    let second = match settings.optional_number(field!("friction.second_coefficient"))? {
        Some(coefficient) => {
            let half_speed = settings.number(field!("friction.second_half_speed"))?;
            Some(SecondTerm { coefficient, half_speed })
        }
        None => None,
    };
    let terms = SlipTerms::new(coefficient, kinetic, half_speed, second);
    terms.map_err(|error| settings.explain(&error))
}

/// A factor over the position across the patch.
fn variation_over_patch(settings: &Settings) -> Result<Option<Variation>, CaseError> {
    let table = if settings.is_given(FILE) {
        let (name, bytes) = settings.read_file(FILE)?;
        Some(tables::variation_from_csv(name, bytes)?)
    } else {
        table(settings, OVER_Y)?
    };
    let variation = table.map(|[y, factor]| Variation::over_y(y, factor)).transpose();
    variation.map_err(|error| settings.explain(&error))
}

/// A factor over the inclination of the rail's profile.
pub fn variation_over_rail(settings: &Settings) -> Result<Option<Variation>, CaseError> {
    let table = table(settings, OVER_INCLINATION)?;
    let variation = table.map(|[at, factor]| Variation::over_inclination(at, factor)).transpose();
    variation.map_err(|error| settings.explain(&error))
}

/// The points of a table of factors, if they are over this field.
fn table(settings: &Settings, over: FieldPath) -> Result<Option<[Vec<f64>; 2]>, CaseError> {
    match [over, FACTOR].map(|path| settings.series(path)) {
        [Some(at), Some(factor)] => Ok(Some([at.to_vec(), factor.to_vec()])),
        [Some(_), None] => Err(settings.missing_beside(FACTOR, over)),
        [None, Some(_)] if !settings.is_given(OVER_Y) && !settings.is_given(OVER_INCLINATION) => {
            Err(settings.missing_beside(OVER_Y, FACTOR))
        }
        [None, _] => Ok(None),
    }
}
