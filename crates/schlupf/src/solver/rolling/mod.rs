//! Rolling: the material moves through the contact, and every step is an equilibrium.

mod shared;
pub mod marching;
pub mod steady;
mod solvers;

pub use solvers::MarchingSolver;
