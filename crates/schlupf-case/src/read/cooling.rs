//! `[cooling]`.

use schlupf::analysis::bulk_temperature::Cooling;

use crate::FieldPath;
use crate::error::CaseError;
use crate::settings::Settings;

const FILM_COEFFICIENT: FieldPath = field!("cooling.film_coefficient");

/// How the air cools the wheel, where the case says so.
pub fn cooling(settings: &Settings) -> Result<Option<Cooling>, CaseError> {
    let Some(film_coefficient) = settings.optional_number(FILM_COEFFICIENT)? else {
        return Ok(None);
    };
    Ok(Some(Cooling {
        film_coefficient,
        area: settings.number(field!("cooling.area"))?,
        air_temperature: settings.number(field!("cooling.air_temperature"))?,
    }))
}

/// What is missing where there is none.
pub fn missing(settings: &Settings) -> CaseError {
    settings.missing_for(FILM_COEFFICIENT, "the bulk temperature of the wheel")
}
