//! The trait of solvers for steady rolling, independent of the method.

pub(crate) mod settings;
pub(crate) mod equilibrium;
pub(crate) mod summary;
pub(crate) mod reference_point;
pub mod reference;
pub mod kalker_coefficients;
pub mod simplified;
pub(crate) mod rolling;
pub(crate) mod prescribed;

pub use prescribed::ForceSolver;
pub use rolling::MarchingSolver;
pub use rolling::marching::{march, shift};
pub use rolling::steady::{SteadySolver, solve};

use crate::problem::{Direction, Method, Options, Problem};
use crate::reporting::{Error, Watch};
use crate::solution::{Resultant, Solution};

/// Finds steady states, one problem after another: points of a creep curve, or families of them.
/// Extension point.
///
/// Problems that share the normal contact and the elasticity (the same `Arc`s, as in clones of a
/// problem) share the set-up, and each may start from earlier solutions. The result depends on them
/// only within the tolerance.
pub trait Solver: Send + Sync {
    /// The method of the solver.
    fn method(&self) -> Method;

    /// The options of the solver.
    fn options(&self) -> &Options;

    /// Solves for the steady state of a problem whose creepages are given; whatever forces it
    /// prescribes is an error: [`ForceSolver`] finds their creepages with any solver.
    ///
    /// # Errors
    /// Whatever [`Problem::check`] and [`Options::check`] reject, and [`Error::Stopped`].
    fn solve(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error>;

    /// Whether it computes derivatives of the forces.
    fn has_derivatives(&self) -> bool {
        false
    }

    /// The steady state with its derivatives. `None` if it is not found directly, or if the method
    /// has no derivatives.
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

    /// The steady state with the derivatives of forces and moment with respect to the creepages of
    /// some directions (in N and N m, for the spin in N m and N m²), for a search: to about a
    /// thousandth. `None` as for [`Self::solve_with_derivatives`].
    ///
    /// # Errors
    /// As [`Self::solve`].
    fn solve_with_slopes(
        &mut self,
        problem: &Problem,
        directions: &[Direction],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let found = self.solve_with_derivatives(problem, watch)?;
        Ok(found.and_then(|solution| {
            let by = solution.sensitivity?;
            let slope = |direction: &Direction| match direction {
                Direction::X => by.creepage_x,
                Direction::Y => by.creepage_y,
                Direction::Spin => by.spin,
            };
            Some((solution, directions.iter().map(slope).collect()))
        }))
    }

    /// Whether it finds states together with the creepages that prescribed forces cause.
    fn solves_for_forces(&self) -> bool {
        false
    }

    /// The steady state with the forces that the problem prescribes, found together with the
    /// creepages that they cause, from those of the problem as a first guess. `None` if that fails,
    /// or if the solver cannot do it.
    ///
    /// # Errors
    /// As [`Self::solve`].
    fn solve_for_forces(
        &mut self,
        _problem: &Problem,
        _watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        Ok(None)
    }

    /// Whether its states are those of a wheel on a rail with all its contacts, and creepages those
    /// of its nominal radius.
    fn is_of_wheel(&self) -> bool {
        false
    }

    /// Discards all solutions, but not the set-up.
    fn forget(&mut self) {}
}
