//! `[damage]`.

use schlupf::damage::{ArchardWear, EnergyWear, SurfaceFatigue};

use crate::error::CaseError;
use crate::settings::Settings;

/// The laws of fatigue and wear.
pub fn damage(settings: &Settings) -> Result<(SurfaceFatigue, ArchardWear, EnergyWear), CaseError> {
    let fatigue =
        SurfaceFatigue { shear_yield_stress: settings.number("damage.shear_yield_stress")? };
    let archard = ArchardWear {
        hardness: settings.number("damage.hardness")?,
        mild: settings.number("damage.wear_coefficient_mild")?,
        severe: settings.number("damage.wear_coefficient_severe")?,
        catastrophic: settings.number("damage.wear_coefficient_catastrophic")?,
    };
    let energy = EnergyWear {
        mild: settings.number("damage.wear_rate_mild")?,
        catastrophic: settings.number("damage.wear_rate_catastrophic")?,
    };
    Ok((fatigue, archard, energy))
}
