//! What finds steady states of rolling, whatever the method.

use crate::error::Error;
use crate::method::Method;
use crate::problem::{Options, Problem};
use crate::progress::Watch;
use crate::solution::Solution;

/// Finds steady states, one problem after another: points of a creep curve, or families of them.
/// Extension point.
///
/// Problems that share the normal contact and the elasticity (the same `Arc`s, as clones of a
/// problem do) share the set-up, and each may start from the solutions before. The result depends
/// on them within the tolerance only.
pub trait Solver: Send + Sync {
    /// What it solves.
    fn method(&self) -> Method;

    /// How it solves.
    fn options(&self) -> &Options;

    /// The steady state of a problem.
    ///
    /// # Errors
    /// Whatever [`Problem::check`] and [`Options::check`] refuse, and [`Error::Stopped`].
    fn solve(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error>;

    /// Whether it finds derivatives of the forces.
    fn has_derivatives(&self) -> bool {
        false
    }

    /// The steady state with its derivatives. Nothing where it is not found at once, or the method
    /// has none.
    ///
    /// # Errors
    /// As [`Self::solve`].
    fn solve_with_derivatives(
        &mut self,
        _problem: &Problem,
        _watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        Ok(None)
    }

    /// Forgets all solutions, but not the set-up.
    fn forget(&mut self) {}
}
