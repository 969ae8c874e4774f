//! Marching: the paper's simulation procedure. The material moves on by one cell a time step, and
//! every step is an equilibrium. Friction follows the temperature that it makes itself in the step,
//! and the slip speed of the step before: where it falls steeply with the slip speed, a march may
//! swing for ever, and says so.

mod time_step;
mod past;
mod moving_edge;
mod arrival;
mod initial_state;
mod friction_heat;
mod step_power;
mod shift;
mod march;

pub use march::{march, shift};
