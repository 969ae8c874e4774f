//! Selection of the solver of steady states by method.

use crate::bodies::Kinematics;
use crate::problem::{Driver, Method, Options, Problem, Transient};
use crate::reporting::{Error, Watch};
use crate::solution::{Resultant, Solution};
use crate::solver::Solver;
use crate::solver::simplified::FastSolver;
use crate::solver::unlike_bodies;

use super::marching::march;
use super::steady::SteadySolver;

impl Method {
    /// The solver of steady states for this method, at given creepages or under prescribed forces.
    ///
    /// ```
    /// use schlupf::problem::FastMethod;
    /// use schlupf::{Method, Options, Problem, unwatched};
    ///
    /// let problem = Problem::builder().creepage_x(0.0005).build()?;
    /// let method = Method::Fast(FastMethod::KalkerLinear);
    /// let mut solver = method.solver(&Options::default());
    /// let force = solver.solve(&problem, &unwatched)?.force;
    /// let twice = Problem::builder().creepage_x(0.001).build()?;
    /// assert!((solver.solve(&twice, &unwatched)?.force.x / force.x - 2.0).abs() < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn solver(&self, options: &Options) -> Box<dyn Solver> {
        self.solver_by(Driver::Steady, options)
    }

    /// The same by a driver, which only the full equations have.
    pub fn solver_by(&self, driver: Driver, options: &Options) -> Box<dyn Solver> {
        match (self, driver) {
            (Self::Full, Driver::Steady) => Box::new(SteadySolver::new(options)),
            (Self::Full, Driver::Marching) => Box::new(MarchingSolver::new(options)),
            (Self::Fast(method), _) => Box::new(FastSolver::new(method.clone(), options)),
        }
    }
}

/// Marches to steady states of the full equations, each from rest. Derivatives are those of a
/// [`SteadySolver`].
pub struct MarchingSolver {
    steady: SteadySolver,
}

impl MarchingSolver {
    /// A solver without previous solutions.
    pub fn new(options: &Options) -> Self {
        Self { steady: SteadySolver::new(options) }
    }
}

impl Solver for MarchingSolver {
    fn method(&self) -> Method {
        Method::Full
    }

    fn options(&self) -> &Options {
        self.steady.options()
    }

    fn solve_given(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let rolling = self.rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        let how = (self.options().tolerance, watch);
        unlike_bodies::settled(problem, how, |problem| {
            march(&Transient::to_steady_state(problem), self.options(), watch)
        })
    }

    fn rolling(&mut self, problem: &Problem, watch: Watch) -> Result<Option<Problem>, Error> {
        self.steady.rolling(problem, watch)
    }

    fn has_derivatives(&self) -> bool {
        true
    }

    fn solve_given_with_derivatives(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        self.steady.solve_given_with_derivatives(problem, watch)
    }

    fn solve_with_slopes(
        &mut self,
        problem: &Problem,
        changes: &[Kinematics],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        self.steady.solve_with_slopes(problem, changes, watch)
    }

    fn forget(&mut self) {
        self.steady.forget();
    }
}
