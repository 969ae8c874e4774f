//! The steady state, directly: traction, temperature and friction of the whole patch as one
//! equilibrium, found on nested grids.

use std::sync::Arc;

use crate::equilibrium::{Limits, Newton, Outcome};
use crate::error::Error;
use crate::interface::InterfaceConstant;
use crate::interface::contact_law::Slide;
use crate::kinematics::Kinematics;
use crate::method::Method;
use crate::numerics::vector::dot;
use crate::problem::{Branch, Options, Problem};
use crate::quantity::Quantity;
use crate::reference_point::Moved;
use crate::simplified::FastContact;
use crate::solution::{Resultant, Solution, Status, Work};
use crate::state::State;
use crate::summary::{self, snapshot::Snapshot};
use crate::warning::Warning;

use super::Progress;
use super::branches;
use super::level::{self, Level};
use super::marching;
use super::sensitivity::{by_constants, sensitivity};
use super::steady_state::SteadyState;
use super::warnings;

/// Solves a problem for its steady state.
///
/// Where Newton's method fails, the state is marched to instead, and a warning says so.
///
/// With a fast method it is that method's state.
///
/// # Errors
/// A history or an initial state, which only marching can follow, and whatever
/// [`Problem::check`] and [`Options::check`] refuse.
pub fn solve(
    problem: &Problem,
    options: &Options,
    report: &mut dyn FnMut(Progress),
) -> Result<Solution, Error> {
    SteadySolver::new(options).solve(problem, report)
}

fn refuse_transient(problem: &Problem) -> Result<(), Error> {
    let what = "the steady driver is for";
    if problem.history.is_some() {
        return Err(Error::NotSteady { quantity: Quantity::Driver, what });
    }
    if problem.initial_state.is_some() {
        return Err(Error::NotSteady { quantity: Quantity::InitialState, what });
    }
    Ok(())
}

/// A solver for steady states that are near each other: points of a creep curve, or families of
/// them.
///
/// Problems that share the normal contact and the elasticity (the same `Arc`s, as clones of a problem
/// do) share grids, kernels and transforms, and each starts from the solutions before; where that
/// fails, from none. The result depends on them within the tolerance only. It is a steady solver
/// whatever the driver of the options. A fast method has its own set-up, which it keeps likewise.
pub struct SteadySolver {
    options: Options,
    setup: Option<Setup>,
    newton: Newton,
    fast: Option<FastContact>,
}

impl SteadySolver {
    /// A solver without a past.
    pub fn new(options: &Options) -> Self {
        Self { options: options.clone(), setup: None, newton: Newton::default(), fast: None }
    }

    /// How it solves.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Solves a problem for its steady state; see [`solve`].
    pub fn solve(
        &mut self,
        problem: &Problem,
        report: &mut dyn FnMut(Progress),
    ) -> Result<Solution, Error> {
        match Moved::from(problem)? {
            None => self.solve_at_patch(problem, report),
            Some(moved) => Ok(moved.back(self.solve_at_patch(&moved.problem, report)?)),
        }
    }

    /// The same of a problem with its creepages at the middle of the patch.
    fn solve_at_patch(
        &mut self,
        problem: &Problem,
        report: &mut dyn FnMut(Progress),
    ) -> Result<Solution, Error> {
        if self.options.method != Method::Full {
            let solution = self.solve_fast(problem)?;
            report(Progress { step: 1, steps: Some(1), change: 0.0 });
            return Ok(solution);
        }
        let Failure { outcome, warning } =
            match self.solve_at_once(problem, self.options.sensitivity)? {
                Ok(solution) => {
                    report(Progress { step: 1, steps: Some(1), change: solution.residual });
                    return Ok(solution);
                }
                Err(failure) => failure,
            };
        let mut marched = marching::march(problem, &self.options, report)?;
        let (residual, newton_steps) = (outcome.residual, outcome.iterations);
        marched.warnings.push(Warning::Marched { residual, newton_steps });
        marched.warnings.extend(warning);
        Ok(marched)
    }

    fn solve_fast(&mut self, problem: &Problem) -> Result<Solution, Error> {
        let fast = match &mut self.fast {
            Some(fast) => {
                fast.set_problem(problem)?;
                fast
            }
            none => none.insert(FastContact::new(problem, &self.options)?),
        };
        Ok(fast.solution())
    }

    /// The steady state with its derivatives. Nothing where Newton's method fails: this never
    /// marches. Nothing with a fast method, which has no derivatives.
    pub fn solve_with_derivatives(&mut self, problem: &Problem) -> Result<Option<Solution>, Error> {
        if self.options.method != Method::Full {
            return Ok(None);
        }
        match Moved::from(problem)? {
            None => self.solve_at_once(problem, true).map(Result::ok),
            Some(moved) => {
                let found = self.solve_at_once(&moved.problem, true)?.ok();
                Ok(found.map(|solution| moved.back(solution)))
            }
        }
    }

    /// The steady state with the derivatives of forces and moment by some constants of contact law and
    /// friction, one for each (in N and N m over the unit of the constant). A constant that a law does not
    /// have has no effect. Nothing where Newton's method or a linear system fails, and with a fast method.
    pub fn solve_with_derivatives_by(
        &mut self,
        problem: &Problem,
        constants: &[InterfaceConstant],
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let Some(moved) = Moved::from(problem)? else {
            return self.solve_with_derivatives_by_at_patch(problem, constants);
        };
        let found = self.solve_with_derivatives_by_at_patch(&moved.problem, constants)?;
        Ok(found.map(|(solution, derivatives)| {
            let derivatives = derivatives.iter().map(|by| moved.resultant_back(by)).collect();
            (moved.back(solution), derivatives)
        }))
    }

    fn solve_with_derivatives_by_at_patch(
        &mut self,
        problem: &Problem,
        constants: &[InterfaceConstant],
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        if self.options.method != Method::Full {
            return Ok(None);
        }
        let Ok(mut solution) = self.solve_at_once(problem, false)? else { return Ok(None) };
        let Some(Setup { levels, .. }) = &mut self.setup else { return Ok(None) };
        let (size, tolerance) = (self.newton.response().len(), self.options.tolerance);
        let (found, products) = by_constants(problem, levels, size, tolerance, constants);
        solution.work.sensitivity_products = products;
        Ok(found.map(|derivatives| (solution, derivatives)))
    }

    /// Forgets all solutions, but not the set-up.
    pub fn forget(&mut self) {
        if let Some(setup) = &mut self.setup {
            setup.earlier.clear();
        }
    }

    /// The steady state, or how far Newton's method got from a cold start.
    fn solve_at_once(
        &mut self,
        problem: &Problem,
        with_derivatives: bool,
    ) -> Result<Result<Solution, Failure>, Error> {
        problem.check()?;
        self.options.check()?;
        refuse_transient(problem)?;
        let setup = self.setup.take().filter(|setup| setup.fits(problem));
        let mut setup = match setup {
            Some(setup) => setup,
            None => Setup::new(problem, &self.options)?,
        };
        if problem.kinematics.is_pure_rolling() {
            // Nothing slides: no earlier solution is as near as none.
            setup.earlier.clear();
        }
        let mut work = Work::default();
        let mut outcome = setup.find(problem, &self.options, &mut self.newton, &mut work);
        let mut warning = None;
        if branches::may_be_several(problem, &setup.levels[0], outcome.converged) {
            (outcome, warning) =
                setup.follow_branches(problem, &self.options, &mut self.newton, &mut work);
        }
        let result = if outcome.converged {
            let response = self.newton.response();
            let mut solution = setup.solution(problem, &self.options, response, (outcome, work));
            solution.warnings.extend(warning);
            if with_derivatives {
                self.differentiate(problem, &mut setup, &mut solution);
            }
            Ok(solution)
        } else {
            Err(Failure { outcome, warning })
        };
        self.setup = Some(setup);
        Ok(result)
    }

    /// Adds the derivatives to a solution that was just found.
    fn differentiate(&mut self, problem: &Problem, setup: &mut Setup, solution: &mut Solution) {
        let response = self.newton.response();
        let levels = &mut setup.levels;
        let (found, products) = sensitivity(problem, levels, response, self.options.tolerance);
        solution.sensitivity = found;
        solution.work.sensitivity_products = products;
        if found.is_none() {
            solution.warnings.push(Warning::NoSensitivity {});
        }
    }
}

/// How far Newton's method got, and what is to be said beside.
struct Failure {
    outcome: Outcome,
    warning: Option<Warning>,
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
    fn find(
        &mut self,
        problem: &Problem,
        options: &Options,
        newton: &mut Newton,
        work: &mut Work,
    ) -> Outcome {
        if !self.earlier.is_empty() {
            let outcome = self.find_equilibrium(problem, options, newton, work);
            if outcome.converged {
                return outcome;
            }
        }
        let outcome = self.find_equilibrium(problem, options, newton, work);
        if outcome.converged {
            return outcome;
        }
        for softer in softened(problem) {
            let found = self.find_equilibrium(&softer, options, newton, work);
            if !found.converged {
                return outcome;
            }
        }
        self.find_equilibrium(problem, options, newton, work)
    }

    /// Newton's method for the whole patch, from the coarsest grid to the finest.
    fn find_equilibrium(
        &mut self,
        problem: &Problem,
        options: &Options,
        newton: &mut Newton,
        work: &mut Work,
    ) -> Outcome {
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
            outcome = newton.solve(&mut system, &mut traction, &limits);
            self.levels[depth].traction = traction;
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
        outcome
    }

    /// Follows the creepage to a problem from high slip and from low slip, the branch that is asked
    /// for last. The state on it, with a warning if the other one is another; where a branch is lost,
    /// whichever state is found, with a warning that says so.
    fn follow_branches(
        &mut self,
        problem: &Problem,
        options: &Options,
        newton: &mut Newton,
        work: &mut Work,
    ) -> (Outcome, Option<Warning>) {
        let (other, [here, there]) = match options.branch {
            Branch::LowSlip => (Branch::HighSlip, ["low", "high"]),
            Branch::HighSlip => (Branch::LowSlip, ["high", "low"]),
        };
        let mut follow = |branch| {
            self.earlier.clear();
            let mut outcome = None;
            for kinematics in branches::way_to(&problem.kinematics, branch) {
                let on_the_way = Problem { kinematics, ..problem.clone() };
                let found = self.find(&on_the_way, options, newton, work);
                outcome = Some(found).filter(|found| found.converged);
                outcome?;
            }
            let force = summary::resultant(&self.levels[0].contact.patch, &self.levels[0].traction);
            outcome.map(|outcome| (outcome, force))
        };
        let elsewhere = follow(other);
        let (Some((outcome, force)), Some((_, other))) = (follow(options.branch), elsewhere) else {
            self.earlier.clear();
            return (self.find(problem, options, newton, work), Some(Warning::BranchLost {}));
        };
        let normal = &self.levels[0].contact.normal;
        let limit = problem.friction.cold_coefficient() * normal.load;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        let turned = (force.moment_z - other.moment_z) / lever;
        let apart = (force.x - other.x).hypot(force.y - other.y).hypot(turned);
        let warning = (apart > branches::DISTINCT * options.tolerance * limit).then(|| {
            let tangential = |force: Resultant| [force.x, force.y];
            Warning::SeveralStates {
                branch: here,
                force: tangential(force),
                other_branch: there,
                other_force: tangential(other),
            }
        });
        (outcome, warning)
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
        if let (Some(transfer), Some(next)) = (&level.transfer, coarser.first_mut()) {
            let news = &mut next.room.right;
            for (news, (found, foreseen)) in
                news.iter_mut().zip(next.traction.iter().zip(&next.foreseen))
            {
                *news = found - foreseen;
            }
            transfer.add_prolonged(news, &mut level.traction);
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
        let squared = dot(&made, &made);
        if squared == 0.0 {
            return 0.0;
        }
        let ahead = dot(&made, &next) / squared;
        let aside: f64 = (0..3).map(|c| (next[c] - ahead * made[c]).powi(2)).sum();
        if aside > 1e-6 * dot(&next, &next) { 0.0 } else { ahead.clamp(-1.0, FARTHEST) }
    }

    /// All results; `response` is what Newton's method found last.
    fn solution(
        &mut self,
        problem: &Problem,
        options: &Options,
        response: &[f64],
        (outcome, mut work): (Outcome, Work),
    ) -> Solution {
        let Level { contact, strips, friction, traction, .. } = &mut self.levels[0];
        let mut now = Snapshot::blank(problem.kinematics, friction.conduction, strips.len());
        now.traction.copy_from_slice(traction);
        contact.product(traction, &mut now.displacement);
        now.stored_energy = contact.stored_energy();
        work.operator_products += 1.0;
        let mut change = vec![0.0; traction.len()];
        contact.change_in_passing(&mut change);
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
