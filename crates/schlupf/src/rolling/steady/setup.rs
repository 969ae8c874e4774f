//! Shared data of steady states with the same normal contact and elasticity, and the search for a
//! state on nested grids.

use std::sync::Arc;

use crate::equilibrium::{Equilibrium, Limits, Newton, Outcome};
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::method::Method;
use crate::numerics::vector::{dot, norm};
use crate::problem::{Branch, Options, Problem};
use crate::progress::Watch;
use crate::rolling::shared::passage::speed_of;
use crate::rolling::shared::warnings::warnings;
use crate::solution::{Extrapolation, Resultant, Solution, Status, Work};
use crate::state::{HeatRecord, State};
use crate::summary::{
    self,
    snapshot::{Snapshot, View},
};
use crate::warning::Warning;

use super::branches;
use super::level::{self, Descent, Level};
use super::steady_state::SteadyState;

/// Parameters of the search for a state, and its work.
pub(super) struct Search<'a> {
    pub options: &'a Options,
    pub newton: &'a mut Newton,
    pub work: Work,
    pub watch: Watch<'a>,
}

/// Shared data of problems with the same normal contact and elasticity.
pub(super) struct Setup {
    /// The problem solved last.
    pub problem: Problem,
    pub levels: Vec<Level>,
    /// Motions of the solutions stored in the levels, the latest first.
    pub earlier: Vec<Kinematics>,
}

/// Multiples of a motion through which a state is approached that is not found otherwise: the more
/// of the contact slides, the fewer cells change between stick and slip.
const FASTER: [f64; 3] = [3.0, 1.8, 1.3];

/// Largest creepage of such a motion, dimensionless.
const FASTEST: f64 = 0.5;

/// The same problem with all creepages and the spin larger, the largest first.
fn quickened(problem: &Problem) -> impl Iterator<Item = Problem> {
    let quicken = |times: f64| {
        let Kinematics { creepage_x, creepage_y, spin, .. } = problem.kinematics;
        let [creepage_x, creepage_y, spin] = [creepage_x, creepage_y, spin].map(|of| times * of);
        let kinematics = Kinematics { creepage_x, creepage_y, spin, ..problem.kinematics };
        (creepage_x.hypot(creepage_y) < FASTEST).then(|| Problem { kinematics, ..problem.clone() })
    };
    FASTER.into_iter().filter_map(quicken)
}

/// Largest defect of a coarse grid from which a finer one starts, dimensionless.
pub(super) const COARSE_TOLERANCE: f64 = 1e-2;

/// Defect of a coarse grid's prediction from earlier solutions up to which its solution tells a
/// finer one nothing new, dimensionless: such a change is hardly more than what the coarse
/// solutions leave undone.
const LEAST_NEWS: f64 = 1.5e-2;

/// Tolerance of the next coarser grid over that of the finest, if forces are extrapolated from
/// both.
const EXTRAPOLATED: f64 = 10.0;

/// The largest such tolerance, whatever that of the finest grid: far below what the grids differ
/// by, dimensionless.
const EXTRAPOLATED_TOLERANCE: f64 = 1e-5;

/// Least ratio of the sizes of their cells, dimensionless.
const LEAST_COARSER: f64 = 1.5;

/// Farthest extrapolation, as a multiple of the distance between the last two solutions.
const FARTHEST: f64 = 2.5;

impl Setup {
    pub fn new(problem: &Problem, options: &Options, watch: Watch) -> Result<Self, Error> {
        let normal = problem.normal.normal_contact(None)?;
        let levels = level::nested(problem, &normal, options, watch)?;
        Ok(Self { problem: problem.clone(), levels, earlier: Vec::new() })
    }

    pub fn fits(&self, problem: &Problem) -> bool {
        Arc::ptr_eq(&self.problem.normal, &problem.normal)
            && Arc::ptr_eq(&self.problem.elasticity, &problem.elasticity)
            && self.problem.layer == problem.layer
            && std::mem::discriminant(&self.problem.contact_law)
                == std::mem::discriminant(&problem.contact_law)
    }

    /// The steady state, starting from previous solutions; if that fails, from none; and then from
    /// those of faster motions.
    pub fn find(&mut self, problem: &Problem, search: &mut Search) -> Result<Outcome, Error> {
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
        Ok(self.find_from_faster(problem, search)?.unwrap_or(outcome))
    }

    /// The steady state, starting from those of faster motions; none if there may be several, or
    /// none of those is found.
    fn find_from_faster(
        &mut self,
        problem: &Problem,
        search: &mut Search,
    ) -> Result<Option<Outcome>, Error> {
        if branches::may_be_several(problem, &self.levels[0], false) {
            return Ok(None);
        }
        for faster in quickened(problem) {
            self.find_equilibrium(&faster, search)?;
        }
        if self.earlier.is_empty() {
            return Ok(None);
        }
        self.find_equilibrium(problem, search).map(Some)
    }

    /// Newton's method for the whole patch, from the coarsest grid to the finest.
    fn find_equilibrium(
        &mut self,
        problem: &Problem,
        search: &mut Search,
    ) -> Result<Outcome, Error> {
        let cells = self.levels[0].contact.patch.len();
        (search.work.cells, search.work.outer_iterations) = (cells, 1);
        let mut ahead = self.extrapolation(problem);
        self.problem = problem.clone();
        if self.is_nearer_rest() && self.is_misled(ahead, search) {
            self.earlier.clear();
            ahead = 0.0;
        }
        let mut outcome = Outcome::default();
        for depth in (0..self.levels.len()).rev() {
            self.levels[depth].set_problem(problem);
            self.guess(depth, ahead);
            let tolerance = match depth {
                0 => search.options.tolerance,
                1 if search.options.extrapolate => {
                    EXTRAPOLATED_TOLERANCE.min(EXTRAPOLATED * search.options.tolerance)
                }
                _ => COARSE_TOLERANCE,
            };
            outcome = self.solve_level(depth, tolerance, search)?;
            let is_new = self.earlier.is_empty() || outcome.first_residual > LEAST_NEWS;
            self.levels[depth].has_news = is_new;
            self.levels[depth].is_found = outcome.converged;
        }
        if outcome.converged {
            let is_at_rest = self.levels[0].traction.iter().all(|p| *p == 0.0);
            if is_at_rest { self.earlier.clear() } else { self.remember(problem.kinematics) }
        } else {
            self.earlier.clear();
        }
        Ok(outcome)
    }

    /// Whether the motion is nearer to pure rolling than to that of the last solution.
    fn is_nearer_rest(&self) -> bool {
        let at = self.problem.kinematics;
        let rest = Kinematics { creepage_x: 0.0, creepage_y: 0.0, spin: 0.0, ..at };
        let square = |from: &Kinematics| {
            let way = self.way(from, &at);
            dot(&way, &way)
        };
        self.earlier.first().is_some_and(|last| square(last) > square(&rest))
    }

    /// Whether the guess from earlier solutions is worse than none, on the coarsest level.
    fn is_misled(&mut self, ahead: f64, search: &mut Search) -> bool {
        let coarsest = self.levels.len() - 1;
        self.levels[coarsest].set_problem(&self.problem);
        self.guess(coarsest, ahead);
        search.work.operator_products += self.part_of_product(coarsest);
        let guess = std::mem::take(&mut self.levels[coarsest].traction);
        let mut system = SteadyState::new(&self.problem, &mut self.levels[coarsest..]);
        let mut response = vec![0.0; system.response_size()];
        let mut residual = vec![0.0; system.size()];
        let none = vec![0.0; system.size()];
        system.residual(&none, &response, &mut residual);
        let without = norm(&residual);
        system.compliance_product(&guess, &mut response);
        system.residual(&guess, &response, &mut residual);
        self.levels[coarsest].traction = guess;
        norm(&residual) > without
    }

    /// Newton's method for the present problem on one level, from its initial guess.
    pub fn solve_level(
        &mut self,
        depth: usize,
        tolerance: f64,
        search: &mut Search,
    ) -> Result<Outcome, Error> {
        let Search { options, newton, work, watch } = search;
        let problem = &self.problem;
        let limits = Limits {
            tolerance,
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
        let outcome = solved.outcome;
        work.newton_iterations += outcome.iterations;
        work.operator_products += self.part_of_product(depth) * outcome.products as f64;
        Ok(outcome)
    }

    /// Cells of a level over those of the finest, dimensionless: a product counts by its cells.
    pub fn part_of_product(&self, depth: usize) -> f64 {
        self.levels[depth].strips.len() as f64 / self.levels[0].strips.len() as f64
    }

    /// Follows the creepage to a problem from high slip and from low slip, the requested branch
    /// last. Returns the state on it, with a warning if the other one differs; if a branch is lost,
    /// whichever state is found, with a warning to that effect.
    pub fn follow_branches(
        &mut self,
        problem: &Problem,
        search: &mut Search,
    ) -> Result<(Outcome, Option<Warning>), Error> {
        let options = search.options;
        let other = match options.branch {
            Branch::LowSlip => Branch::HighSlip,
            Branch::HighSlip => Branch::LowSlip,
        };
        let elsewhere = self.follow(problem, other, search)?;
        let here_found = self.follow(problem, options.branch, search)?;
        let (Some((outcome, force)), Some((_, other))) = (here_found, elsewhere) else {
            self.earlier.clear();
            return Ok((self.find(problem, search)?, Some(Warning::BranchLost {})));
        };
        let normal = &self.levels[0].contact.normal;
        let limit = problem.friction.cold_coefficient() * normal.load;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        let change = force.plus(-1.0, &other).scaled(1.0, lever.recip());
        let apart = change.tangential().hypot(change.moment_z.unwrap_or(0.0));
        let warning = (apart > branches::DISTINCT * options.tolerance * limit).then(|| {
            let tangential = |force: Resultant| [force.x, force.y];
            Warning::SeveralStates {
                from_low_slip: options.branch == Branch::LowSlip,
                force: tangential(force),
                other_force: tangential(other),
            }
        });
        Ok((outcome, warning))
    }

    /// The end of a branch with its forces; `None` if the branch is lost.
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

    /// The initial guess on a level: the extrapolation along the earlier solutions, plus the part
    /// of the next coarser solution that the extrapolation did not predict.
    pub fn guess(&mut self, depth: usize, ahead: f64) {
        let (levels, coarser) = self.levels.split_at_mut(depth + 1);
        let level = &mut levels[depth];
        let is_alone = self.earlier.is_empty() || !level.friction.is_coupled;
        if is_alone && !level.contact.compliance.couples_cells() {
            level.guess_uncoupled(&self.problem);
            return;
        }
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
        level.predicted.copy_from_slice(&level.traction);
        if let (Some(Descent { transfer, carried, .. }), Some(next)) =
            (&mut level.descent, coarser.first().filter(|next| next.has_news))
        {
            let pairs = next.traction.iter().zip(&next.predicted);
            for (news, (found, predicted)) in carried.iter_mut().zip(pairs) {
                *news = found - predicted;
            }
            transfer.add_prolonged(carried, &mut level.traction);
            level.clip();
        }
    }

    pub fn remember(&mut self, kinematics: Kinematics) {
        for level in &mut self.levels {
            level.earlier.swap(0, 1);
            level.earlier[0].copy_from_slice(&level.traction);
        }
        self.earlier.truncate(1);
        self.earlier.insert(0, kinematics);
    }

    /// Distance of a motion ahead on the line through the last two, as a multiple of the distance
    /// between them; zero if it is not on that line.
    fn extrapolation(&self, problem: &Problem) -> f64 {
        let [last, before] = self.earlier.as_slice() else { return 0.0 };
        let (made, next) = (self.way(before, last), self.way(last, &problem.kinematics));
        let squared = dot(&made, &made);
        if squared == 0.0 {
            return 0.0;
        }
        let ahead = dot(&made, &next) / squared;
        let aside: f64 = (0..3).map(|c| (next[c] - ahead * made[c]).powi(2)).sum();
        if aside > 1e-6 * dot(&next, &next) { 0.0 } else { ahead.clamp(-1.0, FARTHEST) }
    }

    /// From one motion to another; the spin with √(ab), dimensionless.
    fn way(&self, from: &Kinematics, to: &Kinematics) -> [f64; 3] {
        let normal = &self.levels[0].contact.normal;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        [
            to.creepage_x - from.creepage_x,
            to.creepage_y - from.creepage_y,
            lever * (to.spin - from.spin),
        ]
    }

    /// All results.
    pub fn solution(
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
        let mut relative = vec![0.0; traction.len()];
        made.at_entries(&mut relative);
        for (entry, u) in relative.iter_mut().zip(&now.displacement) {
            *entry = u - *entry;
        }
        let mut change = vec![0.0; traction.len()];
        made.change_in_passing(&mut change);
        work.operator_products += 1.0;
        friction.evaluate(problem, &contact.patch, traction, &change);
        now.slip.copy_from_slice(&friction.slip);
        strips.take_slip(response, problem.kinematics.speed, &mut now.slip);
        now.friction_power.copy_from_slice(&friction.power);
        now.scaled_rise.copy_from_slice(&friction.scaled_rise);
        now.friction.copy_from_slice(friction.coefficients());
        strips.complete_friction(&mut now.friction);
        let mut elements = if options.keeps_state {
            strips.elements(&contact.patch, traction, &relative)
        } else {
            Vec::new()
        };
        for (k, element) in elements.iter_mut().enumerate() {
            element.slip_speed = speed_of(friction.slip[k]);
            element.scaled_rise = friction.scaled_rise[k];
            element.friction_on_leaving = friction.lag.on_leaving(k);
            element.plastic_way = friction.flowed_on_leaving(k);
        }
        let patch = &contact.patch;
        if options.keeps_state && problem.heat.model.is_some() {
            for strip in &patch.strips {
                let shared = friction.heat.records_on_leaving(strip);
                for (element, k) in elements[strip.cells.clone()].iter_mut().zip(1..) {
                    element.heat = HeatRecord::without(strip.cells.len() - k, &shared);
                }
            }
        }
        let exits = patch.strips.iter().map(|strip| friction.heat.scaled_exit_rise(strip));
        now.scaled_exit_rise = exits.collect();
        now.surfaces = friction.surfaces(patch);
        let is_found =
            outcome.converged && now.surfaces.as_ref().is_none_or(|surfaces| surfaces.is_found);
        let mut warnings = warnings(problem, options, contact, &now);
        let forces = summary::force(&contact.patch, &now);
        let extrapolation = if options.extrapolate && is_found {
            self.extrapolated(problem, &forces)
        } else {
            None
        };
        if options.extrapolate && is_found && extrapolation.is_none() {
            warnings.push(Warning::NoExtrapolation {});
        }
        let Level { contact, .. } = &self.levels[0];
        let view = View { normal: &contact.normal, patch: &contact.patch, now: &now };
        let whole = Outcome { iterations: work.newton_iterations, ..*outcome };
        let account = summary::SolverReport {
            method: Method::Full,
            status: if is_found { Status::Converged } else { Status::NotConverged },
            residual: outcome.residual,
            history: vec![summary::instant(view, [0.0; 2], &whole)],
            field_history: Vec::new(),
            warnings,
            sensitivity: None,
            work,
            state: State { grid: contact.patch.grid, time: 0.0, elements },
        };
        let solution = summary::solution(problem, options, view, account);
        Solution { extrapolation, ..solution }
    }

    /// Forces for cells of no size, from those on the finest grid and on the next coarser one, if
    /// there is one that is coarser in both directions.
    fn extrapolated(&self, problem: &Problem, force: &Resultant) -> Option<Extrapolation> {
        let [fine, coarse, ..] = self.levels.as_slice() else { return None };
        let (grid, coarser) = (&fine.contact.patch.grid, &coarse.contact.patch.grid);
        let ratios = [coarser.spacing_x / grid.spacing_x, coarser.spacing_y / grid.spacing_y];
        if !coarse.is_found || ratios.iter().any(|ratio| *ratio < LEAST_COARSER) {
            return None;
        }
        let on_coarse = summary::resultant(&coarse.contact.patch, &coarse.traction);
        let share = (ratios[0] * ratios[1] - 1.0).recip();
        let error = on_coarse.plus(-1.0, force).scaled(share, share);
        let force = force.plus(-1.0, &error);
        let normalised = summary::normalised(problem, &fine.contact.normal, &force);
        Some(Extrapolation { force, normalised, error })
    }
}
