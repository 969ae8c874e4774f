//! The nested grids on which steady states with the same normal contact and elasticity are found,
//! and Newton's method from the coarsest to the finest.

use std::sync::Arc;

use crate::bodies::Kinematics;
use crate::normal::Grid;
use crate::numerics::vector::{dot, norm};
use crate::problem::{Options, Problem};
use crate::reporting::{Error, Watch};
use crate::solution::Work;
use crate::solver::equilibrium::{Equilibrium, Limits, Newton, Outcome};
use crate::solver::prescribed::{self, ForceGoal};
use crate::solver::settings;

use super::branches;
use super::goal::{Goal, Unsolved};
use super::level::{self, Descent, Level};
use super::steady_state::SteadyState;

/// Parameters of a search, and its work.
pub(super) struct Search<'a> {
    pub options: &'a Options,
    pub newton: &'a mut Newton,
    pub work: Work,
    pub watch: Watch<'a>,
}

/// The grids, and the solutions on them from which later ones start.
pub(super) struct NestedGrids {
    /// The problem solved last.
    pub problem: Problem,
    /// The finest first.
    pub levels: Vec<Level>,
    /// Motions of the solutions stored in the levels, the latest first.
    pub earlier: Vec<Kinematics>,
    /// What Newton's method has not reached.
    pub unsolved: Vec<Unsolved>,
}

impl NestedGrids {
    pub fn new(
        problem: &Problem,
        finest: Option<Grid>,
        options: &Options,
        watch: Watch,
    ) -> Result<Self, Error> {
        let normal = problem.normal.normal_contact(None)?;
        let across = || Grid::across(&normal.extent(), options.cells_x, options.cells_y);
        let finest = finest.unwrap_or_else(across);
        let levels = level::nested(problem, (&normal, finest), options, watch)?;
        Ok(Self { problem: problem.clone(), levels, earlier: Vec::new(), unsolved: Vec::new() })
    }

    /// Whether a problem is one of these grids.
    pub fn fits(&self, problem: &Problem) -> bool {
        Arc::ptr_eq(&self.problem.normal, &problem.normal)
            && Arc::ptr_eq(&self.problem.interface.elasticity, &problem.interface.elasticity)
            && self.problem.interface.layer == problem.interface.layer
            && std::mem::discriminant(&self.problem.interface.contact_law)
                == std::mem::discriminant(&problem.interface.contact_law)
    }

    /// Newton's method from the coarsest grid to the finest, each starting from the earlier
    /// solutions and the next coarser one. On success the present problem has the motion found;
    /// otherwise the earlier solutions remain.
    pub fn solve(&mut self, goal: Goal, search: &mut Search) -> Result<Outcome, Error> {
        search.work.cells = self.levels[0].contact.patch.len();
        search.work.outer_iterations = 1;
        let Goal { problem, forces, tolerance } = goal;
        let ahead = if forces.is_none() { self.extrapolation(problem) } else { 0.0 };
        let none = ForceGoal::default();
        self.problem = problem.clone();
        let mut outcome = Outcome::default();
        for depth in (0..self.levels.len()).rev() {
            self.levels[depth].set_problem(&self.problem);
            self.guess(depth, ahead);
            let is_coarsest = depth + 1 == self.levels.len();
            if !forces.is_none() && is_coarsest && self.earlier.is_empty() {
                // Tractions at the guessed motion: from none at all the creepages would first grow
                // as if everything stuck.
                self.solve_level(depth, settings::coarse_tolerance(), (&none, search))?;
            }
            let is_extrapolated = search.options.extrapolate && forces.is_none();
            let is_result = depth == 0 || (depth == 1 && is_extrapolated);
            let enough = if is_result { tolerance } else { settings::coarse_tolerance() };
            outcome = self.solve_level(depth, enough, (forces, search))?;
            let level = &mut self.levels[depth];
            level.corrects = self.earlier.is_empty()
                || outcome.first_residual > 1.5 * settings::coarse_tolerance();
            level.is_found = outcome.converged;
        }
        if outcome.converged {
            let is_at_rest = self.levels[0].traction.iter().all(|p| *p == 0.0);
            if is_at_rest { self.earlier.clear() } else { self.remember() }
        }
        Ok(outcome)
    }

    /// Newton's method on one level, for the tractions and the free creepages of the present
    /// problem, from its initial guess.
    fn solve_level(
        &mut self,
        depth: usize,
        tolerance: f64,
        (forces, search): (&ForceGoal, &mut Search),
    ) -> Result<Outcome, Error> {
        let limits = Limits {
            tolerance,
            max_iterations: search.options.max_iterations,
            is_monotone: branches::may_be_several(&self.problem, &self.levels[depth..], false),
        };
        let mut traction = std::mem::take(&mut self.levels[depth].traction);
        let mut motion = self.problem.kinematics;
        let mut system = SteadyState::new(&self.problem, &mut self.levels[depth..]);
        let (newton, goal) = (&mut *search.newton, (forces, &mut motion));
        let how = (&limits, search.watch);
        let solved = prescribed::solve(newton, &mut system, goal, &mut traction, how);
        let level = &mut self.levels[depth];
        level.traction = traction;
        let outcome = solved?;
        level.response.clear();
        let response = search.newton.response();
        level.response.extend_from_slice(&response[..response.len() - forces.count()]);
        search.work.newton_iterations += outcome.iterations;
        search.work.operator_products += self.part_of_product(depth) * outcome.products as f64;
        if !forces.is_none() {
            self.problem.kinematics = motion;
            let level = &mut self.levels[depth];
            if !level.friction.is_coupled {
                level.friction.set_problem(&self.problem, &level.contact);
            }
        }
        Ok(outcome)
    }

    /// Drops earlier solutions where no traction is a better start: if nothing slides, if every
    /// cell can be solved by itself, or if the motion is nearer to pure rolling than to that of the
    /// last solution and, on the coarsest grid, the residual is smaller without them.
    pub fn drop_useless_start(&mut self, goal: Goal, search: &mut Search) {
        let (Goal { problem, forces, .. }, coarsest) = (goal, self.levels.len() - 1);
        let Some(last) = self.earlier.first() else { return };
        let level = &mut self.levels[coarsest];
        level.set_problem(problem);
        let moves_alone = level.contact.patch.rows.is_some() || level.contact.pressed.is_some();
        let is_at_rest = problem.kinematics.is_pure_rolling() && !moves_alone && forces.is_none();
        let is_uncoupled = !level.contact.compliance.couples_cells() && !level.friction.is_coupled;
        let rest = Kinematics { creepage_x: 0.0, creepage_y: 0.0, spin: 0.0, ..*last };
        let square = |from: &Kinematics| {
            let apart = self.between(from, &problem.kinematics);
            dot(&apart, &apart)
        };
        let is_nearer_rest = square(last) > square(&rest);
        if is_at_rest || is_uncoupled || (is_nearer_rest && self.is_worse_than_rest(goal, search)) {
            self.earlier.clear();
        }
    }

    /// Whether the guess from earlier solutions is worse than no traction, on the coarsest level.
    fn is_worse_than_rest(&mut self, Goal { problem, .. }: Goal, search: &mut Search) -> bool {
        let coarsest = self.levels.len() - 1;
        self.guess(coarsest, self.extrapolation(problem));
        search.work.operator_products += self.part_of_product(coarsest);
        let guess = std::mem::take(&mut self.levels[coarsest].traction);
        let mut system = SteadyState::new(problem, &mut self.levels[coarsest..]);
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

    /// Cells of a level over those of the finest, dimensionless: a product counts by its cells.
    fn part_of_product(&self, depth: usize) -> f64 {
        self.levels[depth].strips.len() as f64 / self.levels[0].strips.len() as f64
    }

    /// The initial guess on a level: the extrapolation along the earlier solutions, plus the part
    /// of the next coarser solution that the extrapolation did not predict.
    fn guess(&mut self, depth: usize, ahead: f64) {
        let (levels, coarser) = self.levels.split_at_mut(depth + 1);
        let level = &mut levels[depth];
        if self.earlier.is_empty() && !level.contact.compliance.couples_cells() {
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
            (&mut level.descent, coarser.first().filter(|next| next.corrects))
        {
            let pairs = next.traction.iter().zip(&next.predicted);
            for (correction, (found, predicted)) in carried.iter_mut().zip(pairs) {
                *correction = found - predicted;
            }
            transfer.add_prolonged(carried, &mut level.traction);
            level.clip();
        }
    }

    fn remember(&mut self) {
        for level in &mut self.levels {
            level.earlier.swap(0, 1);
            level.earlier[0].copy_from_slice(&level.traction);
        }
        self.earlier.truncate(1);
        self.earlier.insert(0, self.problem.kinematics);
    }

    /// Distance of a motion ahead on the line through the last two, as a multiple of the distance
    /// between them; zero if it is not on that line.
    fn extrapolation(&self, problem: &Problem) -> f64 {
        let [last, before] = self.earlier.as_slice() else { return 0.0 };
        let (made, next) = (self.between(before, last), self.between(last, &problem.kinematics));
        let squared = dot(&made, &made);
        if squared == 0.0 {
            return 0.0;
        }
        let ahead = dot(&made, &next) / squared;
        let aside: f64 = (0..3).map(|c| (next[c] - ahead * made[c]).powi(2)).sum();
        if aside > 1e-6 * dot(&next, &next) {
            0.0
        } else {
            ahead.clamp(-1.0, settings::farthest_extrapolation())
        }
    }

    /// Difference of two motions; the spin with √(ab), dimensionless.
    fn between(&self, from: &Kinematics, to: &Kinematics) -> [f64; 3] {
        let normal = &self.levels[0].contact.normal;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        [
            to.creepage_x - from.creepage_x,
            to.creepage_y - from.creepage_y,
            lever * (to.spin - from.spin),
        ]
    }
}
