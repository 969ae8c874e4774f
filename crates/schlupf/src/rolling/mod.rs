//! Rolling: the material moves through the contact, and every step is an equilibrium.

mod arrival;
mod branches;
mod cell;
mod contact;
mod friction_heat;
mod initial_state;
mod lag;
mod level;
pub mod marching;
mod moving_edge;
mod past;
mod sensitivity;
pub mod shift;
mod shift_step;
pub mod steady;
mod steady_friction;
mod steady_state;
mod step_power;
mod strip_law;
mod time_step;
mod transfer;
mod turn;
mod warnings;

use crate::error::Error;
use crate::method::Method;
use crate::problem::{Driver, Options, Problem};
use crate::solution::Solution;

/// Solves a problem with the method and the driver of the options; fast methods have no driver.
///
/// `report` is called after every time step, or after the steady equilibrium.
pub fn solve(
    problem: &Problem,
    options: &Options,
    report: &mut dyn FnMut(Progress),
) -> Result<Solution, Error> {
    if options.method != Method::Full {
        return steady::solve(problem, options, report);
    }
    let is_transient = problem.history.is_some() || problem.initial_state.is_some();
    let otherwise = if is_transient { Driver::Marching } else { Driver::Steady };
    match options.driver.unwrap_or(otherwise) {
        Driver::Steady => steady::solve(problem, options, report),
        Driver::Marching => marching::march(problem, options, report),
    }
}

/// How far a driver has got.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Time steps done, or steady states found.
    pub step: usize,
    /// All of them, where known beforehand.
    pub steps: Option<usize>,
    /// Relative change of traction and temperature in the last step, dimensionless.
    pub change: f64,
}
