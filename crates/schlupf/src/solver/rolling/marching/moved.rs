//! What the material of a cell has done within a time step.

use crate::problem::Places;

/// The result of a step, for the element of a cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Moved {
    /// Traction on the rail over μ pₙ, dimensionless.
    pub saturation: [f64; 2],
    /// Sliding distance since entry, in m.
    pub sliding: [f64; 2],
    /// Earlier places of the path, the latest first.
    pub track: Places,
    /// Slip velocity over the rolling speed, dimensionless.
    pub slip: [f64; 2],
}
