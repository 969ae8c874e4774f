//! The direct solver for steady states.

use crate::equilibrium::{Newton, Outcome};
use crate::error::Error;
use crate::interface::InterfaceConstant;
use crate::method::Method;
use crate::prescribed_forces::{Direction, PrescribedForces};
use crate::problem::{Options, Problem};
use crate::progress::Watch;
use crate::reference_point::AtPatch;
use crate::rolling::marching::march;
use crate::solution::{Resultant, Solution, Work};
use crate::solver::Solver;
use crate::transient::Transient;
use crate::warning::Warning;

use super::branches;
use super::driven::Drives;
use super::level::Level;
use super::sensitivity::{by_constants, by_motions, sensitivity};
use super::setup::{Search, Setup};

/// Solves a problem for its steady state.
///
/// Where Newton's method fails, the solver marches to the state instead, and a warning says so.
///
/// ```
/// use schlupf::{Options, Problem, rolling, unwatched};
///
/// let problem = Problem::builder().creepage_x(0.003).build()?;
/// let options = Options { cells_x: 12, cells_y: 12, ..Options::default() };
/// let solution = rolling::steady::solve(&problem, &options, &unwatched)?;
/// // What friction dissipates is what the creep forces put in.
/// let power = solution.power.unwrap_or_default();
/// assert!((power.friction / power.creep - 1.0).abs() < 1e-3);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Whatever [`Problem::check`] and [`Options::check`] reject, and [`Error::Stopped`].
pub fn solve(problem: &Problem, options: &Options, watch: Watch) -> Result<Solution, Error> {
    SteadySolver::new(options).solve(problem, watch)
}

/// Finds steady states of the full equations directly.
///
/// Each solution starts from previous ones; if that fails, from none.
pub struct SteadySolver {
    options: Options,
    setup: Option<Setup>,
    newton: Newton,
}

/// Outcome of an attempt to find the steady state directly.
enum Attempt {
    Found(Box<Solution>),
    /// How far Newton's method got from a cold start, and an additional warning.
    Failed(Outcome, Option<Warning>),
}

impl Attempt {
    fn found(self) -> Option<Solution> {
        match self {
            Self::Found(solution) => Some(*solution),
            Self::Failed(..) => None,
        }
    }
}

impl Solver for SteadySolver {
    fn method(&self) -> Method {
        Method::Full
    }

    fn options(&self) -> &Options {
        &self.options
    }

    fn solve(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let at = AtPatch::new(problem, watch)?;
        let attempt = self.attempt(&at.problem, self.options.sensitivity, watch)?;
        let (outcome, warning) = match attempt {
            Attempt::Found(solution) => return Ok(at.back(*solution)),
            Attempt::Failed(outcome, warning) => (outcome, warning),
        };
        let mut marched = march(&Transient::to_steady_state(problem), &self.options, watch)?;
        let (residual, newton_steps) = (outcome.residual, outcome.iterations);
        marched.warnings.push(Warning::Marched { residual, newton_steps });
        marched.warnings.extend(warning);
        Ok(marched)
    }

    fn has_derivatives(&self) -> bool {
        true
    }

    fn solve_with_derivatives(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        let at = AtPatch::new(problem, watch)?;
        let found = self.attempt(&at.problem, true, watch)?.found();
        Ok(found.map(|solution| at.back(solution)))
    }

    fn solve_with_slopes(
        &mut self,
        problem: &Problem,
        directions: &[Direction],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        self.solve_with(problem, watch, |at, levels| {
            let to_centre = at.place().map(|part| -part);
            let motions: Vec<_> = directions.iter().map(|way| way.unit().at(to_centre)).collect();
            by_motions(&at.problem, levels, &motions, watch)
        })
    }

    fn solves_for_forces(&self) -> bool {
        true
    }

    fn solve_for_forces(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        let given = Problem { prescribed: PrescribedForces::default(), ..problem.clone() };
        let at = AtPatch::new(&given, watch)?;
        self.attempt_together(&at, &problem.prescribed, watch)
    }

    fn forget(&mut self) {
        if let Some(setup) = &mut self.setup {
            setup.earlier.clear();
        }
    }
}

impl SteadySolver {
    /// A solver without previous solutions.
    pub fn new(options: &Options) -> Self {
        Self { options: options.clone(), setup: None, newton: Newton::default() }
    }

    /// The steady state with the derivatives of forces and moment with respect to some constants of
    /// contact law and friction, one for each (in N and N m per unit of the constant). A constant
    /// that a law does not have has no effect. `None` if Newton's method or a linear system fails.
    pub fn solve_with_derivatives_by(
        &mut self,
        problem: &Problem,
        constants: &[InterfaceConstant],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let tolerance = self.options.tolerance;
        self.solve_with(problem, watch, |at, levels| {
            by_constants(&at.problem, levels, tolerance, (constants, watch))
        })
    }

    /// The steady state with derivatives of forces and moment, which are found with the levels of
    /// its solution; `None` if Newton's method or a linear system fails.
    fn solve_with(
        &mut self,
        problem: &Problem,
        watch: Watch,
        derive: impl FnOnce(&AtPatch, &mut [Level]) -> Result<(Option<Vec<Resultant>>, usize), Error>,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let at = AtPatch::new(problem, watch)?;
        let Some(mut solution) = self.attempt(&at.problem, false, watch)?.found() else {
            return Ok(None);
        };
        let Some(Setup { levels, .. }) = &mut self.setup else { return Ok(None) };
        let (found, products) = derive(&at, levels)?;
        solution.work.sensitivity_products = products;
        Ok(found.map(|derivatives| {
            let derivatives = derivatives.iter().map(|by| at.resultant_back(by)).collect();
            (at.back(solution), derivatives)
        }))
    }

    /// The steady state of a problem with its creepages at the centre of the patch.
    fn attempt(
        &mut self,
        problem: &Problem,
        with_derivatives: bool,
        watch: Watch,
    ) -> Result<Attempt, Error> {
        self.options.check()?;
        let setup = self.setup.take().filter(|setup| setup.fits(problem));
        let mut setup = match setup {
            Some(setup) => setup,
            None => Setup::new(problem, &self.options, watch)?,
        };
        let is_plane = setup.levels[0].contact.patch.rows.is_none();
        if problem.kinematics.is_pure_rolling() && is_plane {
            // Nothing slides: no earlier solution is closer than none.
            setup.earlier.clear();
        }
        let mut search = Search {
            options: &self.options,
            newton: &mut self.newton,
            work: Work::default(),
            watch,
        };
        let mut outcome = setup.find(problem, &mut search)?;
        let mut warning = None;
        if branches::may_be_several(problem, &setup.levels[0], outcome.converged) {
            (outcome, warning) = setup.follow_branches(problem, &mut search)?;
        }
        let work = search.work;
        let attempt = if outcome.converged {
            let mut solution = setup.solution(problem, &self.options, &outcome, work);
            solution.warnings.extend(warning);
            if with_derivatives {
                self.differentiate(problem, &mut setup, &mut solution, watch)?;
            }
            Attempt::Found(Box::new(solution))
        } else {
            Attempt::Failed(outcome, warning)
        };
        self.setup = Some(setup);
        Ok(attempt)
    }

    /// The state with prescribed forces, from the creepages of a problem at the centre of the
    /// patch.
    fn attempt_together(
        &mut self,
        at: &AtPatch,
        prescribed: &PrescribedForces,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        self.options.check()?;
        let setup = self.setup.take().filter(|setup| setup.fits(&at.problem));
        let mut setup = match setup {
            Some(setup) => setup,
            None => Setup::new(&at.problem, &self.options, watch)?,
        };
        let drives = Drives::of(&at.problem, &setup.levels[0], (prescribed, at.place()))?;
        let mut search = Search {
            options: &self.options,
            newton: &mut self.newton,
            work: Work::default(),
            watch,
        };
        let is_warm = !setup.earlier.is_empty();
        let mut found = setup.find_together(&at.problem, &drives, &mut search)?;
        if is_warm && !found.0.converged {
            found = setup.find_together(&at.problem, &drives, &mut search)?;
        }
        if !found.0.converged && setup.find(&at.problem, &mut search)?.converged {
            // From the state of the guessed motion.
            found = setup.find_together(&at.problem, &drives, &mut search)?;
        }
        let (outcome, kinematics) = found;
        let work = search.work;
        let problem = Problem { kinematics, ..at.problem.clone() };
        if outcome.converged && self.options.extrapolate {
            // Forces are extrapolated at the same motion on all grids.
            self.setup = Some(setup);
            let found = self.attempt(&problem, self.options.sensitivity, watch)?.found();
            return Ok(found.map(|mut solution| {
                solution.work.operator_products += work.operator_products;
                solution.work.newton_iterations += work.newton_iterations;
                at.back(solution)
            }));
        }
        let mut found = None;
        if outcome.converged {
            let mut solution = setup.solution(&problem, &self.options, &outcome, work);
            if self.options.sensitivity {
                self.differentiate(&problem, &mut setup, &mut solution, watch)?;
            }
            found = Some(at.back(solution));
        }
        self.setup = Some(setup);
        Ok(found)
    }

    /// Adds the derivatives to a solution that has just been found.
    fn differentiate(
        &self,
        problem: &Problem,
        setup: &mut Setup,
        solution: &mut Solution,
        watch: Watch,
    ) -> Result<(), Error> {
        let tolerance = self.options.tolerance;
        let (found, products) = sensitivity(problem, &mut setup.levels, tolerance, watch)?;
        solution.sensitivity = found;
        solution.work.sensitivity_products = products;
        if found.is_none() {
            solution.warnings.push(Warning::NoSensitivity {});
        }
        Ok(())
    }
}
