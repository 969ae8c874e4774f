//! `[contact_law]`.

use std::sync::Arc;

use schlupf::interface::contact_law::{ContactLaw, Incremental, TotalDisplacement};

use super::roughness::{self, Circumstances};
use crate::error::CaseError;
use crate::law_stiffness::{LawStiffness, StiffnessOrigin};
use crate::settings::Settings;

const STIFFNESS: &str = "contact_law.stiffness";

/// How traction grows with sliding.
pub fn contact_law(
    settings: &Settings,
    circumstances: &Circumstances,
) -> Result<(Arc<dyn ContactLaw>, LawStiffness), CaseError> {
    let law_stiffness = stiffness(settings, circumstances)?;
    let stiffness = law_stiffness.stiffness;
    let explain = |error| settings.explain(&error);
    let law: Arc<dyn ContactLaw> = match settings.choice("contact_law.model")? {
        "total-displacement" => Arc::new(TotalDisplacement::new(stiffness).map_err(explain)?),
        _ => Arc::new(Incremental::new(stiffness).map_err(explain)?),
    };
    Ok((law, law_stiffness))
}

fn stiffness(settings: &Settings, at: &Circumstances) -> Result<LawStiffness, CaseError> {
    if let Some(stiffness) = settings.optional_number(STIFFNESS)? {
        return Ok(LawStiffness { stiffness, origin: StiffnessOrigin::Given });
    }
    let default = || LawStiffness {
        stiffness: Incremental::DEFAULT_STIFFNESS,
        origin: StiffnessOrigin::Default,
    };
    Ok(roughness::stiffness(settings, at)?.unwrap_or_else(default))
}
