//! `[subsurface]`.

use schlupf::analysis::temperature_field::Side;

use crate::error::CaseError;
use crate::fields::choice::BodyChoice;
use crate::settings::Settings;
use crate::subsurface::SubsurfaceRequest;

/// Where to compute stresses below the surface.
pub fn subsurface(settings: &Settings) -> Result<SubsurfaceRequest, CaseError> {
    Ok(SubsurfaceRequest {
        side: match settings.chosen(field!("subsurface.body"))? {
            BodyChoice::Rail => Side::Rail,
            BodyChoice::Wheel => Side::Wheel,
        },
        depth: settings.optional_number(field!("subsurface.depth"))?,
        layers: settings.count(field!("subsurface.layers"))?,
        margin: settings.optional_number(field!("subsurface.margin"))?,
    })
}
