//! What surfaces are too hot for.

/// What a surface is too hot for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum HeatLimit {
    /// Steel melts.
    Melting,
    /// Steel austenitises (A1).
    Austenite,
    /// Most materials fail.
    AnyMaterial,
}

impl HeatLimit {
    pub(super) fn text(self) -> &'static str {
        match self {
            Self::Melting => "above the melting range of steel",
            Self::Austenite => "above 727 degC, where steel starts to austenitise",
            Self::AnyMaterial => "more than most materials withstand",
        }
    }
}
