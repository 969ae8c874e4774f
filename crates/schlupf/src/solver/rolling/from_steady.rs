//! Rolling over time, also from a state of steady rolling.

use std::sync::Arc;

use crate::normal::AtLoad;
use crate::problem::{Options, Problem, Transient};
use crate::reporting::{Error, Watch};
use crate::solution::{Instant, Solution, Status};
use crate::solver::Solver;

use super::marching::{self, grid_over_history};
use super::steady::SteadySolver;

/// Rolls over time, step by step. It starts without tractions or in the given state, or in the
/// steady state of its first row where the history [starts
/// rolling](crate::problem::History::starts_rolling) and no state is given.
///
/// # Errors
/// What [`Transient::check`] rejects, and those of [`Solver::solve`].
pub fn march(transient: &Transient, options: &Options, watch: Watch) -> Result<Solution, Error> {
    if !transient.history.starts_rolling || transient.initial_state.is_some() {
        return marching::march(transient, options, watch);
    }
    transient.check()?;
    let steady = before(transient, options, watch)?;
    let initial_state = Some(steady.state.clone());
    let mut rolled =
        marching::march(&Transient { initial_state, ..transient.clone() }, options, watch)?;
    let time = transient.history.span()[0];
    let instants = steady.history.into_iter().map(|instant| Instant { time, ..instant });
    rolled.history.splice(0..0, instants);
    rolled.work.newton_iterations += steady.work.newton_iterations;
    rolled.work.operator_products += steady.work.operator_products;
    if steady.status == Status::NotConverged {
        rolled.status = steady.status;
        rolled.residual = rolled.residual.max(steady.residual);
        rolled.warnings.splice(0..0, steady.warnings);
    }
    Ok(rolled)
}

/// The steady state of the first row, on the cells of the history.
fn before(transient: &Transient, options: &Options, watch: Watch) -> Result<Solution, Error> {
    let Transient { problem, history, .. } = transient;
    problem.normal.prepare(history.largest_load(), watch)?;
    let grid = grid_over_history(transient, options)?;
    let [start, _] = history.span();
    let mut first = Problem {
        kinematics: history.kinematics(start, &problem.kinematics),
        prescribed: history.prescribed(start, &problem.prescribed),
        ..problem.clone()
    };
    if let Some(load) = history.load(start) {
        first.normal = Arc::new(AtLoad::new(Arc::clone(&problem.normal), load)?);
    }
    let options =
        Options { sensitivity: false, extrapolate: false, keeps_state: true, ..options.clone() };
    SteadySolver::on(grid, &options).solve(&first, watch)
}
