//! The steady state, directly: traction, temperature and friction of the whole patch as one
//! equilibrium, found on nested grids.

mod transfer;
mod yielding;
mod lag;
mod steady_friction;
mod strip_law;
mod level;
mod steady_state;
mod sensitivity;
mod branches;
mod goal;
mod nested;
mod result;
mod strategy;
mod solver;

pub use solver::{SteadySolver, solve};
