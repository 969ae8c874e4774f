//! `[contact_law]`.

use schlupf::bodies::Material;
use schlupf::interface::{ContactLaw, Incremental, TotalDisplacement};

use super::roughness::{self, OfRoughness};
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::choice::ContactLawModel;
use crate::law_stiffness::{LawStiffness, StiffnessOrigin};
use crate::settings::Settings;

const MODEL: FieldPath = field!("contact_law.model");
const STIFFNESS: FieldPath = field!("contact_law.stiffness");

/// How traction grows with sliding.
pub fn contact_law(settings: &Settings, stiffness: f64) -> Result<ContactLaw, CaseError> {
    let explain = |error| settings.explain(&error);
    Ok(match settings.chosen(MODEL)? {
        ContactLawModel::Incremental => Incremental::new(stiffness).map_err(explain)?.into(),
        ContactLawModel::TotalDisplacement => {
            TotalDisplacement::new(stiffness).map_err(explain)?.into()
        }
        ContactLawModel::Coulomb => ContactLaw::Coulomb,
    })
}

/// k_c, or what a micro model finds it from.
pub fn stiffness(settings: &Settings, materials: [&Material; 2]) -> Result<OfRoughness, CaseError> {
    if settings.chosen::<ContactLawModel>(MODEL)? == ContactLawModel::Coulomb {
        let (stiffness, origin) = (f64::INFINITY, StiffnessOrigin::Given);
        return Ok(OfRoughness::Known(LawStiffness { stiffness, origin }));
    }
    if let Some(stiffness) = settings.optional_number(STIFFNESS)? {
        let origin = StiffnessOrigin::Given;
        return Ok(OfRoughness::Known(LawStiffness { stiffness, origin }));
    }
    let default = LawStiffness {
        stiffness: Incremental::DEFAULT_STIFFNESS,
        origin: StiffnessOrigin::Default,
    };
    let found = roughness::stiffness(settings, materials)?;
    Ok(found.unwrap_or(OfRoughness::Known(default)))
}
