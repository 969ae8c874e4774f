//! `[heat]`.

use std::sync::Arc;

use schlupf::interface::heat::{ConstantSource, Duhamel, Heat, HeatModel, Partition};

use crate::error::CaseError;
use crate::fields::choice::HeatChoice;
use crate::settings::Settings;

/// Frictional heating.
pub fn heat(settings: &Settings) -> Result<Heat, CaseError> {
    let model: Option<Arc<dyn HeatModel>> = match settings.chosen(field!("heat.model"))? {
        HeatChoice::Duhamel => Some(Arc::new(Duhamel)),
        HeatChoice::ConstantSource => Some(Arc::new(ConstantSource)),
        HeatChoice::Nothing => None,
    };
    let share = settings.number(field!("heat.partition")).ok();
    let partition = share.map_or(Partition::Velocity, Partition::Given);
    Ok(Heat { model, partition })
}
