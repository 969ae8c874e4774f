//! Laws of the caller in place of those of a case.

use std::sync::Arc;

use schlupf::interface::friction::FrictionLaw;
use schlupf::interface::heat::PartitionLaw;
use schlupf::normal::PressureSource;

/// Laws of the caller, each in place of that of a case. What they replace of the case has no
/// effect; the reference temperature of friction stays.
#[derive(Debug, Clone, Default)]
pub struct Laws {
    /// The friction law.
    pub friction: Option<Arc<dyn FrictionLaw>>,
    /// The source of the normal pressure.
    pub pressure: Option<Arc<dyn PressureSource>>,
    /// The share of the wheel in the frictional heat.
    pub partition: Option<Arc<dyn PartitionLaw>>,
}
