//! Which errors say that something was not found.

use super::{Error, FitError, ForceError, WheelRailError};

impl Error {
    /// Whether the input may be right, but what follows from it was not found.
    pub fn is_of_convergence(&self) -> bool {
        matches!(
            self,
            Self::NormalNotConverged { .. }
                | Self::ContactNotFound { .. }
                | Self::Fit { error: FitError::FitStuck { .. } }
                | Self::Force { error: ForceError::NotFound { .. } }
                | Self::WheelRail { error: WheelRailError::RollNotSettled { .. } }
        )
    }
}
