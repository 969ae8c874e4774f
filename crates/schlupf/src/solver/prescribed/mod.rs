//! Forces in place of creepages: the motion that causes prescribed forces, with any solver of
//! steady states.
//!
//! The full solver finds tractions and creepages together, as one system of equations, from a first
//! guess by Kalker's linear theory with a saturation. Where that fails, and for the fast methods,
//! the forces are followed from those without the unknown creepages to the prescribed ones. Where
//! friction falls there are two such motions, or none: then the path is followed beyond its peak.

mod path;
mod scaled;

use crate::problem::{Branch, FastMethod, Method, Options, PrescribedForces, Problem};
use crate::reporting::{Error, ForceError, Warning, Watch};
use crate::solution::{Solution, Status, Strategy};
use crate::solver::rolling::steady::SteadySolver;
use crate::solver::{Solver, settings};

use path::Path;
use scaled::Scaled;

/// Finds the creepages that cause the forces prescribed by a problem, with any other solver, which
/// solves problems without such as they are. The motion of the solution is the one found.
///
/// With falling friction two motions may have the same forces: [`Branch::LowSlip`] asks for the one
/// on the rising branch of the creep curve, [`Branch::HighSlip`] for the other, and a warning has
/// the creepages of the one that was not asked for.
///
/// ```
/// use schlupf::solver::ForceSolver;
/// use schlupf::problem::{LongitudinalForce, PrescribedForces};
/// use schlupf::{Method, Options, Problem, Solver, unwatched};
///
/// let braking = Some(LongitudinalForce::Force(-10e3));
/// let prescribed = PrescribedForces { x: braking, ..PrescribedForces::default() };
/// let problem = Problem::builder().load(80e3).prescribed(prescribed).build()?;
/// let options = Options { cells_x: 12, cells_y: 12, ..Options::default() };
/// let solution = ForceSolver::new(Method::Full.solver(&options)).solve(&problem, &unwatched)?;
/// assert!((solution.force.x + 10e3).abs() < 1.0 && solution.kinematics.creepage_x > 0.0);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub struct ForceSolver {
    inner: Box<dyn Solver>,
    /// Searches on fewer cells, once needed.
    scout: Option<Box<dyn Solver>>,
}

impl Solver for ForceSolver {
    fn method(&self) -> Method {
        self.inner.method()
    }

    fn options(&self) -> &Options {
        self.inner.options()
    }

    fn solve(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        if problem.prescribed.is_none() {
            return self.inner.solve(problem, watch);
        }
        self.find(problem, watch)
    }

    fn has_derivatives(&self) -> bool {
        self.inner.has_derivatives()
    }

    /// Derivatives are those at given creepages, whatever is prescribed.
    fn solve_with_derivatives(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        if problem.prescribed.is_none() {
            return self.inner.solve_with_derivatives(problem, watch);
        }
        let kinematics = self.find(problem, watch)?.kinematics;
        let prescribed = PrescribedForces::default();
        let given = Problem { kinematics, prescribed, ..problem.clone() };
        self.inner.solve_with_derivatives(&given, watch)
    }

    fn forget(&mut self) {
        self.inner.forget();
        if let Some(scout) = &mut self.scout {
            scout.forget();
        }
    }
}

/// Cells of the rectangle around the patch.
fn cells(options: &Options) -> f64 {
    (options.cells_x * options.cells_y) as f64
}

impl ForceSolver {
    /// With the solver for given creepages.
    pub fn new(inner: Box<dyn Solver>) -> Self {
        Self { inner, scout: None }
    }

    fn find(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let scaled = Scaled::new(problem, watch)?;
        let is_constant = problem.interface.has_constant_bound();
        let is_limited = !matches!(self.inner.method(), Method::Fast(FastMethod::KalkerLinear));
        if is_limited && scaled.has_uniform_friction() {
            refuse_beyond_friction(&scaled)?;
        }
        if !self.inner.solves_for_forces() {
            return self.along_path(&scaled, watch);
        }
        if is_constant {
            let guessed = scaled.from(scaled.guess());
            if let Some(found) = self.inner.solve_for_forces(&guessed, watch)? {
                return Ok(found);
            }
        }
        self.scouted(&scaled, watch)
    }

    /// The state from those that a solver on fewer cells finds along the path.
    fn scouted(&mut self, scaled: &Scaled, watch: Watch) -> Result<Solution, Error> {
        let options = self.inner.options();
        let coarse = Options {
            cells_x: options.cells_x.min(settings::cells_of_scout()),
            cells_y: options.cells_y.min(settings::cells_of_scout()),
            tolerance: options.tolerance.max(settings::tolerance_of_scout()),
            sensitivity: false,
            extrapolate: false,
            keeps_state: false,
            ..options.clone()
        };
        let branch = options.branch;
        let is_single = scaled.problem.interface.has_constant_bound();
        let scout = self.scout.get_or_insert_with(|| Box::new(SteadySolver::new(&coarse))).as_mut();
        let path = path::follow(scaled, scout, (is_single, watch))?;
        let mut found = Vec::new();
        for state in &path.states {
            let near = scaled.from(state.solution.kinematics);
            self.inner.forget();
            found.extend(self.inner.solve_for_forces(&near, watch)?);
        }
        // They are those of the path, one below and one above the largest force.
        let are_apart = match &found[..] {
            [low, high] => {
                let size = |state: &Solution| scaled.creepages(&state.kinematics).norm();
                scaled.are_distinct(low, high) && size(low) < size(high)
            }
            _ => true,
        };
        let is_whole = found.len() == path.states.len() && are_apart;
        let mut found = found.into_iter();
        let Some(first) = found.next().filter(|_| is_whole) else {
            // The states on fewer cells are not those of this grid.
            return self.along_path(scaled, watch);
        };
        let mut solution = chosen(scaled, first, found.next(), branch);
        let share = cells(&coarse) / cells(self.inner.options());
        count_path(&mut solution, share * path.products);
        Ok(solution)
    }

    /// The state along the path of this solver.
    fn along_path(&mut self, scaled: &Scaled, watch: Watch) -> Result<Solution, Error> {
        let branch = self.inner.options().branch;
        let is_single = scaled.problem.interface.has_constant_bound();
        let path = path::follow(scaled, self.inner.as_mut(), (is_single, watch))?;
        let mut states = path.states.iter().map(|state| state.solution.clone());
        let Some(first) = states.next() else {
            return Err(self.not_found(scaled, &path, watch)?);
        };
        let found = chosen(scaled, first, states.next(), branch);
        let mut solution = self.refined(scaled, &found, (&path, watch))?;
        let is_of_path = |warning: &Warning| {
            matches!(warning, Warning::SeveralMotions { .. } | Warning::OneMotion {})
        };
        solution.warnings.extend(found.warnings.into_iter().filter(is_of_path));
        count_path(&mut solution, path.products);
        Ok(solution)
    }

    /// A state of the path as it was asked for: those of the path have results that were not, or
    /// lack those that were. Where the states of the path are those of another solver, which knows
    /// derivatives, the creepages are corrected by them.
    fn refined(
        &mut self,
        scaled: &Scaled,
        found: &Solution,
        (path, watch): (&Path, Watch),
    ) -> Result<Solution, Error> {
        let mut solution = self.inner.solve(&scaled.at(found.kinematics), watch)?;
        let of_path =
            path.states.iter().find(|state| state.solution.kinematics == found.kinematics);
        let inverse = of_path.and_then(|state| state.jacobian.clone().try_inverse());
        let tolerance = settings::accuracy_of_forces() * self.inner.options().tolerance;
        let mut products = 0.0;
        for _ in 0..settings::most_corrections() {
            let Some((inverse, off)) = inverse.as_ref().zip(scaled.missing(&solution)) else {
                break;
            };
            if off.norm() <= tolerance || solution.status != Status::Converged {
                break;
            }
            let creepages = scaled.creepages(&solution.kinematics) + inverse * off;
            let better = scaled.motion(&creepages);
            if better.check().is_err() {
                break;
            }
            products += solution.work.operator_products;
            solution = self.inner.solve(&scaled.at(better), watch)?;
        }
        solution.work.operator_products += products;
        Ok(solution)
    }

    fn not_found(&mut self, scaled: &Scaled, path: &Path, watch: Watch) -> Result<Error, Error> {
        let first = scaled.prescribed.first().unwrap_or(crate::Quantity::ForceX);
        let at_rest = self.inner.solve(&scaled.at(scaled.problem.kinematics), watch)?;
        if !scaled.has_forces(&at_rest.force) {
            return Ok(ForceError::NotPossible { quantity: first }.into());
        }
        // Along the way to forces far beyond friction the peak is lost between two steps.
        let nearer = scaled.reduced(1.0);
        let nearer = nearer.map(|near| path::follow(&near, self.inner.as_mut(), (true, watch)));
        let nearer = nearer.transpose()?.filter(|nearer| nearer.states.is_empty());
        let path = nearer.as_ref().unwrap_or(path);
        let terms = scaled.in_terms(&path.largest);
        let Some(terms) = terms else {
            return Ok(ForceError::NotPossible { quantity: first }.into());
        };
        let (quantity, [value, largest]) = terms;
        let is_reached = terms.1[1].abs() >= terms.1[0].abs();
        if !path.is_complete || is_reached {
            return Ok(ForceError::NotFound { quantity, value, nearest: largest }.into());
        }
        let limit = scaled.has_uniform_friction().then_some(scaled.limit);
        let has_others = scaled.count() > 1;
        Ok(ForceError::Unreachable { quantity, value, largest, limit, has_others }.into())
    }
}

/// Adds the work of the path to that of the solution at its end.
fn count_path(solution: &mut Solution, products: f64) {
    let work = &mut solution.work;
    work.operator_products += products;
    work.strategy = work.strategy.max(work.strategy.and(Some(Strategy::Continuation)));
}

/// Tangential forces of the friction limit and beyond need no search.
fn refuse_beyond_friction(scaled: &Scaled) -> Result<(), Error> {
    let ratio = scaled.tangential();
    if ratio < 1.0 {
        return Ok(());
    }
    let largest = &scaled.target / ratio;
    match scaled.in_terms(&largest) {
        Some((quantity, [value, largest])) => {
            let (limit, has_others) = (Some(scaled.limit), scaled.count() > 1);
            Err(ForceError::Unreachable { quantity, value, largest, limit, has_others }.into())
        }
        None => Ok(()),
    }
}

/// The state of the branch that is asked for, with a warning if there is another.
fn chosen(scaled: &Scaled, first: Solution, second: Option<Solution>, branch: Branch) -> Solution {
    let Some(second) = second.filter(|second| scaled.are_distinct(&first, second)) else {
        let mut only = first;
        if branch == Branch::HighSlip && !scaled.problem.interface.has_constant_bound() {
            only.warnings.push(Warning::OneMotion {});
        }
        return only;
    };
    let is_low = branch == Branch::LowSlip;
    let (mut here, there) = if is_low { (first, second) } else { (second, first) };
    let other = there.kinematics;
    let creepages = [other.creepage_x, other.creepage_y, other.spin];
    here.warnings.push(Warning::SeveralMotions { is_low, creepages });
    here
}
