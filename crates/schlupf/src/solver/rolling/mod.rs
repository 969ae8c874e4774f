//! Rolling: the material moves through the contact, and every step is an equilibrium.

pub(crate) mod shared;
pub mod marching;
pub mod steady;
mod from_steady;
mod solvers;

pub use from_steady::march;
pub use solvers::MarchingSolver;
