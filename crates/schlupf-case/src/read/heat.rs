//! `[heat]`.

use std::sync::Arc;

use schlupf::heat::constant_source::ConstantSource;
use schlupf::heat::duhamel::Duhamel;
use schlupf::heat::partition::Partition;
use schlupf::heat::{Heat, HeatModel};

use crate::error::CaseError;
use crate::setting::Setting;
use crate::settings::Settings;

/// Frictional heating.
pub fn heat(settings: &Settings) -> Result<Heat, CaseError> {
    let model: Option<Arc<dyn HeatModel>> = match settings.choice("heat.model")? {
        "none" => None,
        "constant-source" => Some(Arc::new(ConstantSource)),
        _ => Some(Arc::new(Duhamel)),
    };
    let partition = match settings.setting("heat.partition")? {
        Setting::Number(share) => Partition::Given(share),
        _ => Partition::Velocity,
    };
    Ok(Heat { model, partition })
}
