//! Marching: the paper's simulation procedure. The material moves on by one cell per time step, and
//! every step is an equilibrium. Friction follows the temperature that it generates in the step
//! itself, and the slip speed of the previous step: if it falls steeply with the slip speed, a
//! march may oscillate indefinitely, which is reported.

mod change;
mod moved;
mod past;
mod moving_edge;
mod arrival;
mod step_response;
mod time_step;
mod step;
mod initial_state;
mod friction_heat;
mod step_power;
mod forces_over_time;
mod march;

pub(super) use initial_state::grid_over_history;
pub(crate) use march::march_from;
pub use march::{march, shift};
