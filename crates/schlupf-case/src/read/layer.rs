//! `[layer]`.

use schlupf::interface::{ThirdBodyLayer, YieldLimit};

use crate::FieldPath;
use crate::error::CaseError;
use crate::settings::Settings;

const THICKNESS: FieldPath = field!("layer.thickness");
const SHEAR_MODULUS: FieldPath = field!("layer.shear_modulus");
const YIELD_STRESS: FieldPath = field!("layer.yield_stress");
const HARDENING: FieldPath = field!("layer.hardening");

/// The layer between the surfaces, if there is one.
pub fn layer(settings: &Settings) -> Result<Option<ThirdBodyLayer>, CaseError> {
    if !settings.any_given(&[THICKNESS, SHEAR_MODULUS, YIELD_STRESS, HARDENING]) {
        return Ok(None);
    }
    let explain = |error| settings.explain(&error);
    let [thickness, shear_modulus] = [settings.number(THICKNESS)?, settings.number(SHEAR_MODULUS)?];
    let layer = ThirdBodyLayer::new(thickness, shear_modulus).map_err(explain)?;
    if !settings.any_given(&[YIELD_STRESS, HARDENING]) {
        return Ok(Some(layer));
    }
    let limit = YieldLimit {
        stress: settings.number(YIELD_STRESS)?,
        hardening: settings.optional_number(HARDENING)?.unwrap_or(0.0),
    };
    layer.with_yield(limit).map(Some).map_err(explain)
}
