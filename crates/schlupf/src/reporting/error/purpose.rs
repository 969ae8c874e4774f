//! What a method may lack.

/// What temperatures or fields are needed for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MethodPurpose {
    /// The bulk temperature of a wheel that friction heats.
    BulkTemperature,
    /// Temperatures below the surface.
    Field,
    /// Stresses below the surface.
    Stress,
    /// Wear in the cells and across the profile.
    Wear,
}

impl MethodPurpose {
    pub(super) fn text(self) -> &'static str {
        match self {
            Self::BulkTemperature => "bulk temperatures need a method with temperatures",
            Self::Field => "temperatures below the surface need the heat record of \"full\"",
            Self::Stress => "stresses below the surface need pressure and traction in cells",
            Self::Wear => "wear in cells and across the profile needs slip and traction in cells",
        }
    }
}
