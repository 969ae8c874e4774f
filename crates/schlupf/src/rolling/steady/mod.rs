//! The steady state, directly: traction, temperature and friction of the whole patch as one
//! equilibrium, found on nested grids.

mod transfer;
mod yielding;
mod lag;
mod steady_friction;
mod strip_law;
mod block;
mod bristles;
mod stretching;
mod strip_factors;
mod stick_slip;
mod blend;
mod level;
mod steady_state;
mod sensitivity;
mod branches;
mod setup;
mod driven;
mod together;
mod solver;

pub use solver::{SteadySolver, solve};
