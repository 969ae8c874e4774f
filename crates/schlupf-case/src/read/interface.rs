//! `[contact_law]`.

use std::sync::Arc;

use schlupf::interface::contact_law::{ContactLaw, Incremental, TotalDisplacement};

use crate::error::CaseError;
use crate::settings::Settings;

/// How traction grows with sliding.
pub fn contact_law(settings: &Settings) -> Result<Arc<dyn ContactLaw>, CaseError> {
    let stiffness = settings.number("contact_law.stiffness")?;
    let explain = |error| settings.explain(&error);
    match settings.choice("contact_law.model")? {
        "total-displacement" => Ok(Arc::new(TotalDisplacement::new(stiffness).map_err(explain)?)),
        _ => Ok(Arc::new(Incremental::new(stiffness).map_err(explain)?)),
    }
}
