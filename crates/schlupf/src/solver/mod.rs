//! What solves a problem: the full equations, directly or step by step, and fast methods.

pub(crate) mod settings;
pub(crate) mod equilibrium;
pub(crate) mod summary;
mod viscoelastic;
pub(crate) mod reference_point;
pub mod reference;
pub mod kalker_coefficients;
pub mod simplified;
pub(crate) mod prescribed;
pub(crate) mod unlike_bodies;
pub(crate) mod rolling;

pub(crate) use rolling::marching::march_from;
pub use rolling::marching::shift;
pub use rolling::steady::{SteadySolver, solve};
pub use rolling::{MarchingSolver, march};
pub use viscoelastic::viscoelastic_rolling;

use crate::bodies::Kinematics;
use crate::problem::{Method, Options, Problem};
use crate::reporting::{Error, Watch};
use crate::solution::{Resultant, Solution};

/// Finds steady states, one problem after another: points of a creep curve, or families of them.
///
/// Problems that share the normal contact and the elasticity (the same `Arc`s, as in clones of a
/// problem) share the set-up, and each may start from earlier solutions. The result depends on them
/// only within the tolerance.
pub trait Solver: Send + Sync {
    /// The method of the solver.
    fn method(&self) -> Method;

    /// The options of the solver.
    fn options(&self) -> &Options;

    /// Solves for the steady state of a problem, with the creepages that it gives, or with those
    /// that the forces cause that it prescribes: the motion of the solution is the one found.
    ///
    /// With falling friction two motions may have the same forces. [`Problem::branch`] asks for the
    /// one on the rising branch of the creep curve or for the other, and a warning has the
    /// creepages of the one that was not asked for.
    ///
    /// ```
    /// use schlupf::problem::{LongitudinalForce, PrescribedForces};
    /// use schlupf::{Method, Options, Problem, unwatched};
    ///
    /// let braking = Some(LongitudinalForce::Force(-10e3));
    /// let prescribed = PrescribedForces { x: braking, ..PrescribedForces::default() };
    /// let problem = Problem::builder().load(80e3).prescribed(prescribed).build()?;
    /// let options = Options { cells_x: 12, cells_y: 12, ..Options::default() };
    /// let solution = Method::Full.solver(&options).solve(&problem, &unwatched)?;
    /// assert!((solution.force.x + 10e3).abs() < 1.0 && solution.kinematics.creepage_x > 0.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// Whatever [`Problem::check`] and [`Options::check`] reject, forces that no motion causes, or
    /// for which none was found, and [`Error::Stopped`].
    fn solve(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        if problem.prescribed.is_none() {
            return self.solve_given(problem, watch);
        }
        if self.method() != Method::Full {
            return prescribed::find(self, problem, watch);
        }
        let rolling = self.rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        let how = (self.options().tolerance, watch);
        unlike_bodies::settled(problem, how, |problem| prescribed::find(self, problem, watch))
    }

    /// The same where all creepages are given: prescribed forces are an error.
    ///
    /// # Errors
    /// As [`Self::solve`].
    fn solve_given(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error>;

    /// As [`viscoelastic_rolling`]; a solver may keep the last pressure.
    ///
    /// # Errors
    /// As [`viscoelastic_rolling`].
    fn rolling(&mut self, problem: &Problem, watch: Watch) -> Result<Option<Problem>, Error> {
        viscoelastic_rolling(problem, watch)
    }

    /// Whether it computes derivatives of the forces.
    fn has_derivatives(&self) -> bool {
        false
    }

    /// The steady state with its derivatives: those at given creepages, whatever is prescribed.
    /// `None` if it is not found directly, or if the method has no derivatives.
    ///
    /// # Errors
    /// As [`Self::solve`].
    fn solve_with_derivatives(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        if problem.prescribed.is_none() {
            return self.solve_given_with_derivatives(problem, watch);
        }
        let kinematics = self.solve(problem, watch)?.kinematics;
        let given = Problem { kinematics, ..problem.without_forces() };
        self.solve_given_with_derivatives(&given, watch)
    }

    /// The same where all creepages are given.
    ///
    /// # Errors
    /// As [`Self::solve_given`].
    fn solve_given_with_derivatives(
        &mut self,
        _problem: &Problem,
        _watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        Ok(None)
    }

    /// The state at given creepages with the derivatives of forces and moment (in N and N m) along
    /// some changes of the creepages, whatever their speed, for a search: to about a thousandth.
    /// `None` where the state or one nearby is not found.
    ///
    /// # Errors
    /// As [`Self::solve`].
    fn solve_with_slopes(
        &mut self,
        problem: &Problem,
        changes: &[Kinematics],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        if !self.has_derivatives() {
            return central_differences(self, problem, changes, watch);
        }
        let found = self.solve_given_with_derivatives(problem, watch)?;
        Ok(found.and_then(|solution| {
            let by = solution.sensitivity?;
            let slope = |change: &Kinematics| {
                let by_x = by.creepage_x.scaled(change.creepage_x, change.creepage_x);
                by_x.plus(change.creepage_y, &by.creepage_y).plus(change.spin, &by.spin)
            };
            Some((solution, changes.iter().map(slope).collect()))
        }))
    }

    /// A solver of the same method on few cells that finds its way to prescribed forces, near which
    /// [`Self::solve_for_forces`] then finds the state.
    fn coarser(&mut self) -> Option<&mut dyn Solver> {
        None
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

/// The state with slopes by central differences; changes are of the order of one step of a search.
fn central_differences(
    solver: &mut (impl Solver + ?Sized),
    problem: &Problem,
    changes: &[Kinematics],
    watch: Watch,
) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
    let mut at = |change: &Kinematics, step: f64| {
        let kinematics = problem.kinematics.changed(step, change);
        let is_possible = kinematics.check().is_ok();
        let problem = Problem { kinematics, ..problem.clone() };
        is_possible.then(|| solver.solve_given(&problem, watch)).transpose()
    };
    let (step, mut slopes) = (settings::difference(), Vec::new());
    for change in changes {
        let [more, less] = [at(change, step)?, at(change, -step)?];
        let Some((more, less)) = more.zip(less) else { return Ok(None) };
        let over = 0.5 / step;
        slopes.push(more.force.plus(-1.0, &less.force).scaled(over, over));
    }
    Ok(Some((solver.solve_given(problem, watch)?, slopes)))
}
