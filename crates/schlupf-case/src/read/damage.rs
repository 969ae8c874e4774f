//! `[damage]`.

use schlupf::analysis::damage::{
    ArchardWear, CrackFunction, EnergyWear, Laws, SurfaceFatigue, WearMap,
};

use crate::error::CaseError;
use crate::settings::Settings;
use crate::{FieldPath, tables};

const MAP: FieldPath = field!("damage.wear_map");
const COEFFICIENTS: [FieldPath; 3] = fields![
    "damage.wear_coefficient_mild",
    "damage.wear_coefficient_severe",
    "damage.wear_coefficient_catastrophic",
];
const CRACKS: [FieldPath; 2] = fields!["damage.crack_t_gamma", "damage.crack_damage"];

/// The laws of fatigue and wear; the rest of [`Laws`] is that of the default.
pub fn damage(settings: &Settings) -> Result<Laws, CaseError> {
    let fatigue = SurfaceFatigue {
        shear_yield_stress: settings.number(field!("damage.shear_yield_stress"))?,
    };
    let archard = ArchardWear {
        hardness: settings.number(field!("damage.hardness"))?,
        map: wear_map(settings)?,
    };
    let energy = EnergyWear {
        mild: settings.number(field!("damage.wear_rate_mild"))?,
        catastrophic: settings.number(field!("damage.wear_rate_catastrophic"))?,
    };
    let melting_temperature = settings.number(field!("damage.melting_temperature"))?;
    let cracks = cracks(settings)?;
    Ok(Laws { fatigue, cracks, archard, energy, melting_temperature, ..Laws::default() })
}

fn wear_map(settings: &Settings) -> Result<WearMap, CaseError> {
    if settings.is_given(MAP) {
        let (name, bytes) = settings.read_file(MAP)?;
        return tables::wear_map_from_csv(name, bytes);
    }
    let mut coefficients = WearMap::DRY_STEEL;
    for (coefficient, path) in coefficients.iter_mut().zip(COEFFICIENTS) {
        *coefficient = settings.optional_number(path)?.unwrap_or(*coefficient);
    }
    Ok(WearMap::jendel(coefficients))
}

fn cracks(settings: &Settings) -> Result<CrackFunction, CaseError> {
    let [t_gamma, damage] = CRACKS.map(|path| settings.series(path));
    match (t_gamma, damage) {
        (None, None) => Ok(CrackFunction::default()),
        (Some(t_gamma), Some(damage)) => {
            let function = CrackFunction::new(t_gamma.to_vec(), damage.to_vec());
            function.map_err(|error| settings.explain(&error))
        }
        (Some(_), None) => Err(settings.missing_beside(CRACKS[1], CRACKS[0])),
        (None, Some(_)) => Err(settings.missing_beside(CRACKS[0], CRACKS[1])),
    }
}
