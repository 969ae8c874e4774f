//! `[wheel]` and `[rail]`.

use schlupf::material::{Body, Material};
use schlupf::normal::hertz::Radii;

use crate::error::CaseError;
use crate::settings::Settings;

/// Paths of a body's fields.
#[derive(Debug)]
pub struct Paths {
    young_modulus: &'static str,
    poisson_ratio: &'static str,
    conductivity: &'static str,
    density: &'static str,
    specific_heat: &'static str,
    bulk_temperature: &'static str,
    radius_x: &'static str,
    radius_y: &'static str,
}

macro_rules! paths {
    ($body:literal) => {
        Paths {
            young_modulus: concat!($body, ".young_modulus"),
            poisson_ratio: concat!($body, ".poisson_ratio"),
            conductivity: concat!($body, ".conductivity"),
            density: concat!($body, ".density"),
            specific_heat: concat!($body, ".specific_heat"),
            bulk_temperature: concat!($body, ".bulk_temperature"),
            radius_x: concat!($body, ".radius_x"),
            radius_y: concat!($body, ".radius_y"),
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
