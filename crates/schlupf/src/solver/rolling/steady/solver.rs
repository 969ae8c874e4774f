//! The direct solver for steady states.

use crate::bodies::Kinematics;
use crate::interface::InterfaceConstant;
use crate::normal::Grid;
use crate::problem::{Method, Options, PrescribedForces, Problem};
use crate::reporting::{Error, Warning, Watch};
use crate::solution::{Resultant, Solution, Work};
use crate::solver::equilibrium::{Directions, Newton};
use crate::solver::prescribed::ForceGoal;
use crate::solver::reference_point::AtPatch;
use crate::solver::viscoelastic::LastPressure;
use crate::solver::{Solver, settings, unlike_bodies};

use super::goal::{Found, Goal};
use super::level::Level;
use super::nested::{NestedGrids, Search};
use super::sensitivity::{by_constants, by_motions, sensitivity};

/// Solves a problem for its steady state.
///
/// Where Newton's method finds it neither from no traction nor along other motions, the solver
/// marches to it, and a warning says so.
///
/// ```
/// use schlupf::{solver, Options, Problem, unwatched};
///
/// let problem = Problem::builder().creepage_x(0.003).build()?;
/// let options = Options { cells_x: 12, cells_y: 12, ..Options::default() };
/// let solution = solver::solve(&problem, &options, &unwatched)?;
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
/// Each solution starts from previous ones; what follows if that fails is a
/// [`Strategy`](crate::solution::Strategy).
pub struct SteadySolver {
    options: Options,
    /// The cells, where they are not those across the patch.
    grid: Option<Grid>,
    grids: Option<NestedGrids>,
    newton: Newton,
    viscoelastic: LastPressure,
    /// Searches on fewer cells, once needed.
    coarser: Option<Box<Self>>,
}

/// Outcome of Newton's method.
enum State {
    Found(Box<Solution>),
    Lost(Found, Work),
}

impl State {
    fn found(self) -> Option<Solution> {
        match self {
            Self::Found(solution) => Some(*solution),
            Self::Lost(..) => None,
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

    fn solve_given(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let rolling = self.rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        let how = (self.options.tolerance, watch);
        unlike_bodies::settled(problem, how, |problem| self.solve_under_pressure(problem, watch))
    }

    fn rolling(&mut self, problem: &Problem, watch: Watch) -> Result<Option<Problem>, Error> {
        self.viscoelastic.rolling(problem, watch)
    }

    fn has_derivatives(&self) -> bool {
        true
    }

    fn solve_given_with_derivatives(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        self.solve_with_sensitivity(problem, self.options.tolerance, watch)
    }

    fn solve_with_slopes(
        &mut self,
        problem: &Problem,
        changes: &[Kinematics],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        self.solve_with(problem, watch, |at, state| {
            let to_centre = at.place().map(|part| -part);
            let changes: Vec<_> = changes.iter().map(|change| change.at(to_centre)).collect();
            by_motions(&at.problem, state, &changes, watch)
        })
    }

    fn coarser(&mut self) -> Option<&mut dyn Solver> {
        let (options, cells) = (&self.options, settings::cells_of_coarse_search());
        let coarser = self.coarser.get_or_insert_with(|| {
            Box::new(Self::new(&Options {
                cells_x: options.cells_x.min(cells),
                cells_y: options.cells_y.min(cells),
                tolerance: options.tolerance.max(settings::tolerance_of_coarse_search()),
                sensitivity: false,
                extrapolate: false,
                keeps_state: false,
                ..options.clone()
            }))
        });
        Some(&mut **coarser)
    }

    fn solve_for_forces(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        let rolling = self.rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        let given = Problem { prescribed: PrescribedForces::default(), ..problem.clone() };
        let at = AtPatch::new(&given, watch)?;
        let state = self.state(&at, &problem.prescribed, self.asked(), watch)?;
        Ok(state.found().map(|solution| at.back(solution)))
    }

    fn forget(&mut self) {
        if let Some(grids) = &mut self.grids {
            grids.earlier.clear();
            grids.levels[0].changes.clear();
        }
        if let Some(coarser) = &mut self.coarser {
            coarser.forget();
        }
    }
}

impl SteadySolver {
    /// The steady state under a pressure that the tractions do not change.
    fn solve_under_pressure(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let at = AtPatch::new(problem, watch)?;
        match self.state(&at, &PrescribedForces::default(), self.asked(), watch)? {
            State::Found(solution) => Ok(at.back(*solution)),
            State::Lost(found, work) => {
                found.march((problem, self.grid), (&self.options, &work), watch)
            }
        }
    }

    /// The steady state with all derivatives to about a thousandth; `None` as in
    /// [`Solver::solve_with_derivatives`].
    pub(crate) fn solve_with_all_slopes(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        self.solve_with_sensitivity(problem, f64::INFINITY, watch)
    }

    fn solve_with_sensitivity(
        &mut self,
        problem: &Problem,
        accuracy: f64,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        let rolling = self.rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        let mut is_found = true;
        let how = (self.options.tolerance, watch);
        let solution = unlike_bodies::settled(problem, how, |problem| {
            let at = AtPatch::new(problem, watch)?;
            let state = self.state(&at, &PrescribedForces::default(), Some(accuracy), watch)?;
            if let Some(solution) = state.found() {
                return Ok(at.back(solution));
            }
            is_found = false;
            self.solve_under_pressure(problem, watch)
        })?;
        Ok(is_found.then_some(solution))
    }

    /// A solver without previous solutions.
    pub fn new(options: &Options) -> Self {
        let (options, newton) = (options.clone(), Newton::default());
        let viscoelastic = LastPressure::default();
        Self { options, grid: None, grids: None, newton, viscoelastic, coarser: None }
    }

    /// One on the cells of a grid.
    pub(crate) fn on(grid: Grid, options: &Options) -> Self {
        Self { grid: Some(grid), ..Self::new(options) }
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
        self.solve_with(problem, watch, |at, state| {
            by_constants(&at.problem, state, tolerance, (constants, watch))
        })
    }

    /// The steady state with derivatives of forces and moment, which are found with the levels of
    /// its solution; `None` if Newton's method or a linear system fails.
    fn solve_with(
        &mut self,
        problem: &Problem,
        watch: Watch,
        derive: impl FnOnce(
            &AtPatch,
            (&mut [Level], &mut Directions),
        ) -> Result<(Option<Vec<Resultant>>, usize), Error>,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let rolling = self.rolling(problem, watch)?;
        let problem = rolling.as_ref().unwrap_or(problem);
        let at = AtPatch::new(problem, watch)?;
        let state = self.state(&at, &PrescribedForces::default(), None, watch)?;
        let Some(mut solution) = state.found() else { return Ok(None) };
        let Some(NestedGrids { levels, .. }) = &mut self.grids else { return Ok(None) };
        let (found, products) = derive(&at, (levels, self.newton.directions()))?;
        solution.work.sensitivity_products = products;
        Ok(found.map(|derivatives| {
            let derivatives = derivatives.iter().map(|by| at.resultant_back(by)).collect();
            (at.back(solution), derivatives)
        }))
    }

    /// The tolerance of the derivatives that the options ask for, dimensionless.
    fn asked(&self) -> Option<f64> {
        self.options.sensitivity.then_some(self.options.tolerance)
    }

    /// The steady state of a problem at the centre of the patch, by Newton's method, with
    /// derivatives to a tolerance (dimensionless). Creepages whose forces are prescribed are a
    /// first guess.
    fn state(
        &mut self,
        at: &AtPatch,
        prescribed: &PrescribedForces,
        derivatives: Option<f64>,
        watch: Watch,
    ) -> Result<State, Error> {
        self.options.check()?;
        let grids = self.grids.take().filter(|grids| grids.fits(&at.problem));
        let mut grids = match grids {
            Some(grids) => grids,
            None => NestedGrids::new(&at.problem, self.grid, &self.options, watch)?,
        };
        let state = self.state_on(&mut grids, (at, prescribed), derivatives, watch);
        self.grids = Some(grids);
        state
    }

    fn state_on(
        &mut self,
        grids: &mut NestedGrids,
        (at, prescribed): (&AtPatch, &PrescribedForces),
        derivatives: Option<f64>,
        watch: Watch,
    ) -> Result<State, Error> {
        let normal = &grids.levels[0].contact.normal;
        let forces = &ForceGoal::new(&at.problem, prescribed, (normal, at.place()))?;
        let (options, work) = (&self.options, Work::default());
        let mut search = Search { options, newton: &mut self.newton, work, watch };
        let goal = Goal { problem: &at.problem, forces, tolerance: options.tolerance };
        let mut found = grids.find(goal, &mut search)?;
        let problem = grids.problem.clone();
        if found.outcome.converged && !forces.is_none() && options.extrapolate {
            // Forces are extrapolated at the same motion on all grids.
            let given = Goal { problem: &problem, forces: &ForceGoal::default(), ..goal };
            found.outcome = grids.solve(given, &mut search)?;
        }
        let work = search.work;
        if !found.outcome.converged {
            return Ok(State::Lost(found, work));
        }
        let mut solution = grids.solution(&problem, &self.options, &found.outcome, work);
        solution.warnings.extend(found.warning);
        if let Some(accuracy) = derivatives {
            self.differentiate((&problem, accuracy), grids, &mut solution, watch)?;
        }
        Ok(State::Found(Box::new(solution)))
    }

    /// Adds the derivatives to a solution that has just been found.
    fn differentiate(
        &mut self,
        (problem, tolerance): (&Problem, f64),
        grids: &mut NestedGrids,
        solution: &mut Solution,
        watch: Watch,
    ) -> Result<(), Error> {
        let (found, products) =
            sensitivity(problem, (&mut grids.levels, self.newton.directions()), tolerance, watch)?;
        solution.sensitivity = found;
        solution.work.sensitivity_products = products;
        if found.is_none() {
            solution.warnings.push(Warning::NoSensitivity {});
        }
        Ok(())
    }
}
