//! Forces in place of creepages: the motion that causes prescribed forces, with any solver of
//! steady states.
//!
//! The full solver finds tractions and creepages together, as one system of equations, from a first
//! guess by Kalker's linear theory with a saturation. Where that fails, and for the fast methods,
//! the forces are followed from those without the free creepages to the prescribed ones. Where
//! friction falls there are two such motions, or none: then the path is followed beyond its peak.

mod goal;
mod bordered;
mod path;

use nalgebra::DVector;

use crate::bodies::Kinematics;
use crate::problem::{Branch, FastMethod, Method, Options, Problem};
use crate::reporting::{Error, ForceError, Progress, Quantity, Stage, Warning, Watch, tell};
use crate::solution::{Solution, Status, Strategy};
use crate::solver::{Solver, reference_point, settings};

use path::Path;

pub(crate) use bordered::{MovedEquilibrium, solve};
pub(crate) use goal::{ForceGoal, linear_share};
pub(crate) use path::{Responds, Response, Search};

/// The state with the forces that a problem prescribes, by whatever solver.
pub(crate) fn find<S: Solver + ?Sized>(
    solver: &mut S,
    problem: &Problem,
    watch: Watch,
) -> Result<Solution, Error> {
    problem.check()?;
    problem.normal.prepare(None, watch)?;
    let normal = problem.normal.normal_contact(None)?.summary;
    let place = reference_point::place(problem.reference, &normal)?;
    let sought = Sought {
        goal: ForceGoal::new(problem, &problem.prescribed, (&normal, [0.0; 2]))?,
        problem: problem.without_forces(),
        is_single: problem.interface.has_constant_bound(),
        has_limit: problem.uniform_friction(normal.semi_axis_y).is_some(),
        branch: problem.branch,
        watch,
    };
    let is_limited = solver.method() != Method::Fast(FastMethod::KalkerLinear);
    if is_limited && sought.has_limit {
        sought.goal.refuse_beyond_friction()?;
    }
    if sought.is_single {
        let guess = sought.goal.guess(problem, (&normal, place))?;
        if let Some(found) = solver.solve_for_forces(&sought.from(guess), watch)? {
            return Ok(found);
        }
    }
    match sought.by_coarser(solver)? {
        Some(found) => Ok(found),
        None => sought.along_path(solver),
    }
}

/// What is sought.
#[derive(Clone)]
struct Sought<'a> {
    /// With all creepages given.
    problem: Problem,
    goal: ForceGoal,
    /// Whether there is no other state, because nothing changes what bounds the traction.
    is_single: bool,
    /// Whether friction is μ0 everywhere, whatever the motion.
    has_limit: bool,
    branch: Branch,
    watch: Watch<'a>,
}

impl Sought<'_> {
    fn motion(&self, creepages: &DVector<f64>) -> Kinematics {
        self.goal.motion(&self.problem.kinematics, creepages.as_slice())
    }

    fn rolls(&self, creepages: &DVector<f64>) -> bool {
        self.motion(creepages).check().is_ok()
    }

    /// The problem with all creepages given.
    fn at(&self, creepages: &DVector<f64>) -> Problem {
        Problem { kinematics: self.motion(creepages), ..self.problem.clone() }
    }

    /// The problem with its forces, from a first guess.
    fn from(&self, kinematics: Kinematics) -> Problem {
        Problem { kinematics, prescribed: *self.goal.prescribed(), ..self.problem.clone() }
    }

    /// The state from those that a solver on fewer cells finds along the path; `None` if there is
    /// no such solver, or if the states on fewer cells are not those of this grid.
    fn by_coarser<S: Solver + ?Sized>(&self, solver: &mut S) -> Result<Option<Solution>, Error> {
        let Some(coarser) = solver.coarser() else { return Ok(None) };
        let (path, products) = self.path(coarser, self.is_single)?;
        let products = products * cells(coarser.options()) / cells(solver.options());
        let mut found = Vec::new();
        for state in &path.states {
            solver.forget();
            let near = self.from(self.motion(&state.creepages));
            found.extend(solver.solve_for_forces(&near, self.watch)?);
        }
        let creepages: Vec<_> =
            found.iter().map(|state| self.goal.creepages(&state.kinematics)).collect();
        // They are those of the path, one below and one above the largest force.
        let are_apart = creepages
            .windows(2)
            .all(|pair| are_distinct(&pair[0], &pair[1]) && pair[0].norm() < pair[1].norm());
        if found.is_empty() || found.len() < path.states.len() || !are_apart {
            return Ok(None);
        }
        let (which, warning) = self.chosen(&creepages);
        let found = found.swap_remove(which);
        Ok(Some(after_path(found, warning, products)))
    }

    /// The state along the path of the solver itself.
    fn along_path<S: Solver + ?Sized>(&self, solver: &mut S) -> Result<Solution, Error> {
        let (path, products) = self.path(solver, self.is_single)?;
        if path.states.is_empty() {
            return Err(self.not_found(solver, path)?);
        }
        let creepages: Vec<_> = path.states.iter().map(|state| state.creepages.clone()).collect();
        let (which, warning) = self.chosen(&creepages);
        let solution = self.refined(solver, &path.states[which])?;
        Ok(after_path(solution, warning, products))
    }

    /// A state of the path as it was asked for: those of the path have results that were not, or
    /// lack those that were. Where the states of the path are those of another solver, which knows
    /// derivatives, the creepages are corrected by them.
    fn refined<S: Solver + ?Sized>(
        &self,
        solver: &mut S,
        state: &Response,
    ) -> Result<Solution, Error> {
        let Self { goal, watch, .. } = self;
        let tolerance = settings::accuracy_of_forces() * solver.options().tolerance;
        let inverse = state.jacobian.clone().try_inverse();
        let mut solution = solver.solve(&self.at(&state.creepages), watch)?;
        let mut products = 0.0;
        for _ in 0..settings::most_corrections() {
            let missing = goal.forces(&solution.force).map(|forces| &goal.target - forces);
            let Some((missing, inverse)) = missing.zip(inverse.as_ref()) else { break };
            let better = goal.creepages(&solution.kinematics) + inverse * &missing;
            let is_lost = solution.status != Status::Converged || !self.rolls(&better);
            if missing.norm() <= tolerance || is_lost {
                break;
            }
            products += solution.work.operator_products;
            solution = solver.solve(&self.at(&better), watch)?;
        }
        solution.work.operator_products += products;
        Ok(solution)
    }

    /// Why a path led to no state.
    fn not_found<S: Solver + ?Sized>(&self, solver: &mut S, path: Path) -> Result<Error, Error> {
        // Along the way to forces far beyond friction the peak is lost between two steps.
        let nearer = self.goal.reduced().map(|goal| Self { goal, ..self.clone() });
        let nearer = nearer.map(|near| near.path(solver, true)).transpose()?;
        let nearer = nearer.map(|(path, _)| path).filter(|path| path.states.is_empty());
        let Path { largest, is_complete, .. } = nearer.unwrap_or(path);
        let forces = largest.map_or_else(|| &self.goal.target * 0.0, |state| state.forces);
        Ok(self.goal.missed(&forces, (is_complete, self.has_limit)).into())
    }

    /// The path of a solver, with the products with the compliance that it took.
    fn path<S: Solver + ?Sized>(
        &self,
        solver: &mut S,
        is_single: bool,
    ) -> Result<(Path, f64), Error> {
        let tolerance = settings::accuracy_of_forces() * solver.options().tolerance;
        let mut states = States { sought: self, solver, done: 0, products: 0.0 };
        let path = Search::new(&mut states, (&self.goal.target, tolerance)).follow(is_single)?;
        Ok((path, states.products))
    }

    /// Which of one or two states is the one of the branch that is asked for, with a warning if
    /// there is another, or if there should be.
    fn chosen(&self, states: &[DVector<f64>]) -> (usize, Option<Warning>) {
        let is_low = self.branch == Branch::LowSlip;
        if let [low, high] = states
            && are_distinct(low, high)
        {
            let other = self.motion(if is_low { high } else { low });
            let creepages = [other.creepage_x, other.creepage_y, other.spin];
            return (usize::from(!is_low), Some(Warning::SeveralMotions { is_low, creepages }));
        }
        (0, (!is_low && !self.is_single).then_some(Warning::OneMotion {}))
    }
}

/// The states of a solver at the creepages that a search tries.
struct States<'a, S: ?Sized> {
    sought: &'a Sought<'a>,
    solver: &'a mut S,
    done: usize,
    products: f64,
}

impl<S: Solver + ?Sized> Responds for States<'_, S> {
    fn respond(&mut self, creepages: DVector<f64>) -> Result<Option<Response>, Error> {
        let Sought { goal, watch, .. } = self.sought;
        tell(watch, Progress::count(Stage::Steady, self.done))?;
        self.done += 1;
        let problem = self.sought.at(&creepages);
        let found = self.solver.solve_with_slopes(&problem, &goal.changes(), watch)?;
        let Some((Solution { status, force, work, .. }, slopes)) = found else { return Ok(None) };
        self.products += work.operator_products + work.sensitivity_products as f64;
        let Some((forces, jacobian)) = goal.forces(&force).zip(goal.jacobian(&slopes)) else {
            let quantity = goal.prescribed().first().unwrap_or(Quantity::ForceX);
            return Err(ForceError::NotPossible { quantity }.into());
        };
        let is_found = status == Status::Converged;
        Ok(is_found.then_some(Response { creepages, forces, jacobian }))
    }

    fn rolls(&self, creepages: &DVector<f64>) -> bool {
        self.sought.rolls(creepages)
    }
}

/// Cells of the rectangle around the patch.
fn cells(options: &Options) -> f64 {
    (options.cells_x * options.cells_y) as f64
}

/// Whether free creepages are those of different motions.
fn are_distinct(one: &DVector<f64>, other: &DVector<f64>) -> bool {
    (one - other).norm() > settings::distinct_motions() * one.norm().max(other.norm())
}

/// A solution that was found along a path, with the work of that.
fn after_path(solution: Solution, warning: Option<Warning>, products: f64) -> Solution {
    let mut solution = solution;
    let work = &mut solution.work;
    work.operator_products += products;
    work.strategy = work.strategy.max(work.strategy.and(Some(Strategy::Continuation)));
    solution.warnings.extend(warning);
    solution
}
