//! The steady state, directly: traction, temperature and friction of the whole patch as one
//! equilibrium, found on nested grids.

use std::sync::Arc;

use crate::equilibrium::{Limits, Newton, Outcome};
use crate::error::Error;
use crate::interface::InterfaceConstant;
use crate::interface::contact_law::Slide;
use crate::kinematics::Kinematics;
use crate::method::Method;
use crate::problem::{Branch, Options, Problem};
use crate::progress::Watch;
use crate::reference_point::AtPatch;
use crate::solution::{Resultant, Solution, Status, Work};
use crate::solver::Solver;
use crate::state::State;
use crate::summary::{self, snapshot::Snapshot};
use crate::transient::Transient;

use super::branches;
use super::level::{self, Descent, Level};
use super::marching::march;
use super::sensitivity::{by_constants, sensitivity};
use super::steady_state::SteadyState;
use super::warnings;

/// Solves a problem for its steady state.
///
/// Where Newton's method fails, the state is marched to instead, and a warning says so.
///
/// # Errors
/// Whatever [`Problem::check`] and [`Options::check`] refuse, and [`Error::Stopped`].
pub fn solve(problem: &Problem, options: &Options, watch: Watch) -> Result<Solution, Error> {
    SteadySolver::new(options).solve(problem, watch)
}

/// Finds steady states of the full equations at once.
///
/// Each starts from the solutions before; where that fails, from none.
pub struct SteadySolver {
    options: Options,
    setup: Option<Setup>,
    newton: Newton,
}

/// What an attempt to find the steady state at once came to.
enum Attempt {
    Found(Box<Solution>),
    /// How far Newton's method got from a cold start, and what is to be said beside.
    Failed(Outcome, Option<String>),
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
        marched.warnings.push(format!(
            "the steady equilibrium was not found at once (residual {:.1e} after {} Newton steps); \
             this is the end of a march, without derivatives",
            outcome.residual, outcome.iterations
        ));
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

    fn forget(&mut self) {
        if let Some(setup) = &mut self.setup {
            setup.earlier.clear();
        }
    }
}

impl SteadySolver {
    /// A solver without a past.
    pub fn new(options: &Options) -> Self {
        Self { options: options.clone(), setup: None, newton: Newton::default() }
    }

    /// The steady state with the derivatives of forces and moment by some constants of contact law and
    /// friction, one for each (in N and N m over the unit of the constant). A constant that a law does not
    /// have has no effect. Nothing where Newton's method or a linear system fails.
    pub fn solve_with_derivatives_by(
        &mut self,
        problem: &Problem,
        constants: &[InterfaceConstant],
        watch: Watch,
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let at = AtPatch::new(problem, watch)?;
        let Some(mut solution) = self.attempt(&at.problem, false, watch)?.found() else {
            return Ok(None);
        };
        let Some(Setup { levels, .. }) = &mut self.setup else { return Ok(None) };
        let tolerance = self.options.tolerance;
        let (found, products) = by_constants(&at.problem, levels, tolerance, constants);
        solution.work.sensitivity_products = products;
        Ok(found.map(|derivatives| {
            let derivatives = derivatives.iter().map(|by| at.resultant_back(by)).collect();
            (at.back(solution), derivatives)
        }))
    }

    /// The steady state of a problem with its creepages at the middle of the patch.
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
            None => Setup::new(problem, &self.options)?,
        };
        if problem.kinematics.is_pure_rolling() {
            // Nothing slides: no earlier solution is as near as none.
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
                self.differentiate(problem, &mut setup, &mut solution);
            }
            Attempt::Found(Box::new(solution))
        } else {
            Attempt::Failed(outcome, warning)
        };
        self.setup = Some(setup);
        Ok(attempt)
    }

    /// Adds the derivatives to a solution that was just found.
    fn differentiate(&self, problem: &Problem, setup: &mut Setup, solution: &mut Solution) {
        let tolerance = self.options.tolerance;
        let (found, products) = sensitivity(problem, &mut setup.levels, tolerance);
        solution.sensitivity = found;
        solution.work.sensitivity_products = products;
        if found.is_none() {
            solution.warnings.push(
                "sensitivity: a linear system at the solution was not solved; the derivatives are \
                 left out"
                    .to_owned(),
            );
        }
    }
}

/// How a state is looked for, and the work that it was.
struct Search<'a> {
    options: &'a Options,
    newton: &'a mut Newton,
    work: Work,
    watch: Watch<'a>,
}

/// What problems with one normal contact and elasticity share.
struct Setup {
    /// The problem solved last.
    problem: Problem,
    levels: Vec<Level>,
    /// Motions of the solutions that the levels remember, the latest first.
    earlier: Vec<Kinematics>,
}

/// Parts of k_c by way of which a state is looked for that is not found otherwise.
const SOFTER: [f64; 2] = [0.01, 0.1];

/// The same problem with softer bristles, the softest first, if the law can be made softer.
fn softened(problem: &Problem) -> Vec<Problem> {
    let stiffness = problem.contact_law.respond(&Slide::default()).by_increment[0][0];
    let soften = |part: f64| {
        let contact_law = problem.contact_law.with_stiffness(part * stiffness).ok()??;
        Some(Problem { contact_law, ..problem.clone() })
    };
    SOFTER.into_iter().filter_map(soften).collect()
}

/// Largest defect of a coarse grid from which a finer one starts, dimensionless; and the same where
/// only the change since an earlier solution counts.
const COARSE_TOLERANCE: [f64; 2] = [1e-1, 1e-2];

/// Farthest extrapolation, in distances between the last two solutions.
const FARTHEST: f64 = 2.5;

impl Setup {
    fn new(problem: &Problem, options: &Options) -> Result<Self, Error> {
        let normal = problem.normal.normal_contact(None)?;
        let levels = level::nested(problem, &normal, options)?;
        Ok(Self { problem: problem.clone(), levels, earlier: Vec::new() })
    }

    fn fits(&self, problem: &Problem) -> bool {
        Arc::ptr_eq(&self.problem.normal, &problem.normal)
            && Arc::ptr_eq(&self.problem.elasticity, &problem.elasticity)
    }

    /// The steady state, from the solutions before; where that fails, from none; and then by way of softer
    /// bristles, with which it is smoother.
    fn find(&mut self, problem: &Problem, search: &mut Search) -> Result<Outcome, Error> {
        if !self.earlier.is_empty() {
            let outcome = self.find_equilibrium(problem, search)?;
            if outcome.converged {
                return Ok(outcome);
            }
        }
        let outcome = self.find_equilibrium(problem, search)?;
        if outcome.converged {
            return Ok(outcome);
        }
        for softer in softened(problem) {
            let found = self.find_equilibrium(&softer, search)?;
            if !found.converged {
                return Ok(outcome);
            }
        }
        self.find_equilibrium(problem, search)
    }

    /// Newton's method for the whole patch, from the coarsest grid to the finest.
    fn find_equilibrium(
        &mut self,
        problem: &Problem,
        search: &mut Search,
    ) -> Result<Outcome, Error> {
        let Search { options, newton, work, watch } = search;
        let cells = self.levels[0].contact.patch.len();
        (work.cells, work.outer_iterations) = (cells, 1);
        let ahead = self.extrapolation(problem);
        self.problem = problem.clone();
        let mut outcome = Outcome::default();
        for depth in (0..self.levels.len()).rev() {
            self.levels[depth].set_problem(problem);
            self.guess(depth, ahead);
            let coarse = COARSE_TOLERANCE[usize::from(!self.earlier.is_empty())];
            let limits = Limits {
                tolerance: if depth == 0 { options.tolerance } else { coarse },
                max_iterations: options.max_iterations,
                is_monotone: branches::may_be_several(problem, &self.levels[depth], false),
            };
            let mut traction = std::mem::take(&mut self.levels[depth].traction);
            let mut system = SteadyState::new(problem, &mut self.levels[depth..]);
            let solved = newton.solve(&mut system, &mut traction, &limits, *watch);
            self.levels[depth].traction = traction;
            let solved = solved?;
            self.levels[depth].response.clear();
            self.levels[depth].response.extend_from_slice(solved.response);
            outcome = solved.outcome;
            let share = self.levels[depth].strips.len() as f64 / cells as f64;
            work.newton_iterations += outcome.iterations;
            work.operator_products += share * outcome.products as f64;
        }
        if outcome.converged {
            let is_at_rest = self.levels[0].traction.iter().all(|p| *p == 0.0);
            if is_at_rest { self.earlier.clear() } else { self.remember(problem.kinematics) }
        } else {
            self.earlier.clear();
        }
        Ok(outcome)
    }

    /// Follows the creepage to a problem from high slip and from low slip, the branch that is asked
    /// for last. The state on it, with a warning if the other one is another; where a branch is lost,
    /// whichever state is found, with a warning that says so.
    fn follow_branches(
        &mut self,
        problem: &Problem,
        search: &mut Search,
    ) -> Result<(Outcome, Option<String>), Error> {
        let options = search.options;
        let (other, [here, there]) = match options.branch {
            Branch::LowSlip => (Branch::HighSlip, ["low", "high"]),
            Branch::HighSlip => (Branch::LowSlip, ["high", "low"]),
        };
        let elsewhere = self.follow(problem, other, search)?;
        let here_found = self.follow(problem, options.branch, search)?;
        let (Some((outcome, force)), Some((_, other))) = (here_found, elsewhere) else {
            self.earlier.clear();
            return Ok((self.find(problem, search)?, Some(branches::LOST.to_owned())));
        };
        let normal = &self.levels[0].contact.normal;
        let limit = problem.friction.cold_coefficient() * normal.load;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        let turned = (force.moment_z - other.moment_z) / lever;
        let apart = (force.x - other.x).hypot(force.y - other.y).hypot(turned);
        let warning = (apart > branches::DISTINCT * options.tolerance * limit).then(|| {
            format!(
                "friction falls so fast that there are several steady states: this one is reached \
                 from {here} slip, with Fx = {:.6e} N and Fy = {:.6e} N; from {there} slip they \
                 are {:.6e} N and {:.6e} N",
                force.x, force.y, other.x, other.y
            )
        });
        Ok((outcome, warning))
    }

    /// The end of a branch with its forces; nothing where it is lost.
    fn follow(
        &mut self,
        problem: &Problem,
        branch: Branch,
        search: &mut Search,
    ) -> Result<Option<(Outcome, Resultant)>, Error> {
        self.earlier.clear();
        let mut end = None;
        for kinematics in branches::way_to(&problem.kinematics, branch) {
            let on_the_way = Problem { kinematics, ..problem.clone() };
            let outcome = self.find(&on_the_way, search)?;
            if !outcome.converged {
                return Ok(None);
            }
            end = Some(outcome);
        }
        let force = summary::resultant(&self.levels[0].contact.patch, &self.levels[0].traction);
        Ok(end.map(|outcome| (outcome, force)))
    }

    /// The first guess on a level: what extrapolation along the earlier solutions gives, and the
    /// part of the next coarser solution that this did not foresee.
    fn guess(&mut self, depth: usize, ahead: f64) {
        let (levels, coarser) = self.levels.split_at_mut(depth + 1);
        let level = &mut levels[depth];
        let [last, before] = &level.earlier;
        match self.earlier.len() {
            0 => level.traction.fill(0.0),
            1 => level.traction.copy_from_slice(last),
            _ => {
                let pairs = last.iter().zip(before);
                for (guess, (last, before)) in level.traction.iter_mut().zip(pairs) {
                    *guess = last + ahead * (last - before);
                }
            }
        }
        level.clip();
        level.foreseen.copy_from_slice(&level.traction);
        if let (Some(Descent { transfer, carried, .. }), Some(next)) =
            (&mut level.descent, coarser.first())
        {
            let pairs = next.traction.iter().zip(&next.foreseen);
            for (news, (found, foreseen)) in carried.iter_mut().zip(pairs) {
                *news = found - foreseen;
            }
            transfer.add_prolonged(carried, &mut level.traction);
            level.clip();
        }
    }

    fn remember(&mut self, kinematics: Kinematics) {
        for level in &mut self.levels {
            level.earlier.swap(0, 1);
            level.earlier[0].copy_from_slice(&level.traction);
        }
        self.earlier.truncate(1);
        self.earlier.insert(0, kinematics);
    }

    /// How far a motion lies ahead on the line through the last two, in distances between them; zero
    /// where it does not lie on that line.
    fn extrapolation(&self, problem: &Problem) -> f64 {
        let [last, before] = self.earlier.as_slice() else { return 0.0 };
        let normal = &self.levels[0].contact.normal;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        let difference = |to: &Kinematics, from: &Kinematics| {
            [
                to.creepage_x - from.creepage_x,
                to.creepage_y - from.creepage_y,
                lever * (to.spin - from.spin),
            ]
        };
        let (made, next) = (difference(last, before), difference(&problem.kinematics, last));
        let dot = |v: &[f64; 3], w: &[f64; 3]| v.iter().zip(w).map(|(v, w)| v * w).sum::<f64>();
        let squared = dot(&made, &made);
        if squared == 0.0 {
            return 0.0;
        }
        let ahead = dot(&made, &next) / squared;
        let aside: f64 = (0..3).map(|c| (next[c] - ahead * made[c]).powi(2)).sum();
        if aside > 1e-6 * dot(&next, &next) { 0.0 } else { ahead.clamp(-1.0, FARTHEST) }
    }

    /// All results.
    fn solution(
        &mut self,
        problem: &Problem,
        options: &Options,
        outcome: &Outcome,
        mut work: Work,
    ) -> Solution {
        let Level { contact, strips, friction, traction, response, .. } = &mut self.levels[0];
        let mut now = Snapshot::blank(problem.kinematics, friction.conduction, strips.len());
        now.traction.copy_from_slice(traction);
        let mut made = contact.product(traction);
        made.at_cells(&mut now.displacement);
        now.stored_energy = made.stored_energy();
        let mut change = vec![0.0; traction.len()];
        made.change_in_passing(&mut change);
        work.operator_products += 1.0;
        friction.evaluate(problem, &contact.patch, traction, &change);
        now.slip.copy_from_slice(&friction.slip);
        now.friction_power.copy_from_slice(&friction.power);
        now.rise.copy_from_slice(&friction.rise);
        now.friction.copy_from_slice(&friction.lag.coefficient);
        let mut elements = strips.elements(&contact.patch, traction, response);
        for (k, element) in elements.iter_mut().enumerate() {
            element.slip_speed = friction.slip[k][0].hypot(friction.slip[k][1]);
            element.rise = friction.rise[k];
            element.friction_on_leaving = friction.lag.on_leaving(k);
            if problem.heat.model.is_some() {
                element.heat = friction.record_on_leaving(k);
            }
        }
        let patch = &contact.patch;
        let exits = patch.strips.iter().map(|strip| friction.exit_rise(problem, strip));
        now.exit_rise = exits.collect();
        now.surfaces = friction.surfaces(patch);
        let is_found = now.surfaces.as_ref().is_none_or(|surfaces| surfaces.is_found);
        let solved = (work.newton_iterations, outcome.residual);
        let instant = summary::instant((&contact.normal, patch, &now), [0.0; 2], solved);
        let account = summary::Account {
            method: Method::Full,
            status: if is_found { Status::Converged } else { Status::NotConverged },
            residual: outcome.residual,
            history: vec![instant],
            warnings: warnings::warnings(problem, options, contact, &now),
            sensitivity: None,
            work,
            state: State { grid: contact.patch.grid, time: 0.0, elements },
        };
        summary::solution(problem, options, (&contact.normal, &contact.patch, &now), account)
    }
}
