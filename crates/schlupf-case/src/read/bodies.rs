//! `[wheel]` and `[rail]`.

use schlupf::bodies::{Body, Material};
use schlupf::normal::Radii;

use crate::FieldPath;
use crate::error::CaseError;
use crate::settings::Settings;

/// Paths of a body's fields.
#[derive(Debug)]
pub struct Paths {
    young_modulus: FieldPath,
    poisson_ratio: FieldPath,
    conductivity: FieldPath,
    density: FieldPath,
    specific_heat: FieldPath,
    bulk_temperature: FieldPath,
    radius_x: FieldPath,
    radius_y: FieldPath,
}

macro_rules! paths {
    ($body:literal) => {
        Paths {
            young_modulus: field!($body, ".young_modulus"),
            poisson_ratio: field!($body, ".poisson_ratio"),
            conductivity: field!($body, ".conductivity"),
            density: field!($body, ".density"),
            specific_heat: field!($body, ".specific_heat"),
            bulk_temperature: field!($body, ".bulk_temperature"),
            radius_x: field!($body, ".radius_x"),
            radius_y: field!($body, ".radius_y"),
        }
    };
}

/// Fields of the wheel.
pub const WHEEL: Paths = paths!("wheel");
/// Fields of the rail.
pub const RAIL: Paths = paths!("rail");

/// Material and temperature.
pub fn body(settings: &Settings, paths: &Paths) -> Result<Body, CaseError> {
    let material = Material {
        young_modulus: settings.number(paths.young_modulus)?,
        poisson_ratio: settings.number(paths.poisson_ratio)?,
        conductivity: settings.number(paths.conductivity)?,
        density: settings.number(paths.density)?,
        specific_heat: settings.number(paths.specific_heat)?,
    };
    Ok(Body { material, bulk_temperature: settings.number(paths.bulk_temperature)? })
}

/// Radii of curvature.
pub fn radii(settings: &Settings, paths: &Paths) -> Result<Radii, CaseError> {
    Ok(Radii { x: settings.number(paths.radius_x)?, y: settings.number(paths.radius_y)? })
}
