//! Rolling: the material moves through the contact, and every step is an equilibrium.

mod arrival;
mod contact;
mod friction_heat;
pub mod marching;
mod snapshot;
mod summary;
mod time_step;
mod turn;

/// How far a driver has got.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Time steps done.
    pub step: usize,
    /// All time steps, where known beforehand.
    pub steps: Option<usize>,
    /// Relative change of traction and temperature in the last step, dimensionless.
    pub change: f64,
}
