//! The search for a steady state. What is tried, in this order, until it leads to a state:
//!
//! 1. [`Strategy::Warm`], if the solver has solved a problem with this contact before,
//! 2. [`Strategy::Cold`],
//! 3. [`Strategy::Continuation`], which also tells which of several states is found,
//! 4. [`Strategy::March`], if all creepages are given; a march has no derivatives.
//!
//! All but the last are Newton's method on nested grids from different initial guesses. Where
//! forces are prescribed, their creepages are free, too, and the continuation is that from the
//! state of the guessed motion, or the path of forces ([`crate::solver::prescribed`]): where
//! friction depends on slip or heat, and where all else fails.

use crate::normal::Grid;
use crate::problem::{Branch, Options, Problem, State, Transient};
use crate::reporting::{Error, Warning, Watch};
use crate::solution::{Resultant, Solution, Strategy, Work};
use crate::solver::equilibrium::Outcome;
use crate::solver::prescribed::ForceGoal;
use crate::solver::rolling::marching::march;
use crate::solver::{settings, summary};

use super::branches;
use super::goal::{Found, Goal, Unsolved};
use super::nested::{NestedGrids, Search};

impl NestedGrids {
    /// The state by Newton's method. What was not found before with the same laws and the same
    /// motion or forces is not tried again.
    pub fn find(&mut self, goal: Goal, search: &mut Search) -> Result<Found, Error> {
        if let Some(unsolved) = self.unsolved.iter().find(|one| one.is(&goal)) {
            return Ok(unsolved.found.clone());
        }
        self.drop_useless_start(goal, search);
        let mut found = Found::default();
        let mut may_be_several = false;
        for strategy in [Strategy::Warm, Strategy::Cold, Strategy::Continuation] {
            match strategy {
                Strategy::Warm if self.earlier.is_empty() => continue,
                // The state is found, but there may be others.
                Strategy::Cold if found.outcome.converged => continue,
                Strategy::Cold => self.earlier.clear(),
                _ => {}
            }
            search.work.strategy = Some(strategy);
            if strategy == Strategy::Continuation {
                found = self.follow_motions(goal, may_be_several, search)?;
                break;
            }
            found = Found { outcome: self.solve(goal, search)?, warning: None };
            let converged = found.outcome.converged;
            // Without creepage there is no branch to follow.
            may_be_several = goal.forces.is_none()
                && !goal.problem.kinematics.is_pure_rolling()
                && branches::may_be_several(goal.problem, &self.levels, converged);
            if converged && !may_be_several {
                break;
            }
        }
        if !found.outcome.converged {
            self.unsolved.push(Unsolved::new(goal, &found));
        }
        Ok(found)
    }

    /// Along motions to the state: if forces are prescribed, from that of the guessed motion, and
    /// otherwise along the branch that is asked for. Where there may be several states, the other
    /// one is followed, too, and a warning tells whether they differ or one is lost. If it is the
    /// one that is asked for, the state is whichever is found from no traction.
    fn follow_motions(
        &mut self,
        goal: Goal,
        may_be_several: bool,
        search: &mut Search,
    ) -> Result<Found, Error> {
        if !goal.forces.is_none() {
            self.earlier.clear();
            let guessed = Goal { forces: &ForceGoal::default(), ..goal };
            let mut outcome = self.solve(guessed, search)?;
            if outcome.converged {
                outcome = self.solve(goal, search)?;
            }
            return Ok(Found { outcome, warning: None });
        }
        if !may_be_several {
            let (outcome, _) = self.follow(goal, Branch::HighSlip, search)?;
            return Ok(Found { outcome, warning: None });
        }
        let branch = goal.problem.branch;
        let other = match branch {
            Branch::LowSlip => Branch::HighSlip,
            Branch::HighSlip => Branch::LowSlip,
        };
        let (elsewhere, other_force) = self.follow(goal, other, search)?;
        let (mut outcome, force) = self.follow(goal, branch, search)?;
        if !(outcome.converged && elsewhere.converged) {
            if !outcome.converged {
                self.earlier.clear();
                outcome = self.solve(goal, search)?;
                search.work.strategy = Some(Strategy::Cold);
            }
            return Ok(Found { outcome, warning: Some(Warning::BranchLost {}) });
        }
        let normal = &self.levels[0].contact.normal;
        let limit = goal.problem.interface.friction.cold_coefficient() * normal.load;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        let change = force.plus(-1.0, &other_force).scaled(1.0, lever.recip());
        let apart = change.tangential().hypot(change.moment_z.unwrap_or(0.0));
        let distinct = settings::distinct_states() * search.options.tolerance * limit;
        let warning = (apart > distinct).then(|| Warning::SeveralStates {
            from_low_slip: branch == Branch::LowSlip,
            force: [force.x, force.y],
            other_force: [other_force.x, other_force.y],
        });
        Ok(Found { outcome, warning })
    }

    /// The end of a branch, and the forces there.
    fn follow(
        &mut self,
        goal: Goal,
        branch: Branch,
        search: &mut Search,
    ) -> Result<(Outcome, Resultant), Error> {
        self.earlier.clear();
        let mut outcome = Outcome::default();
        for kinematics in branches::motions_to(&goal.problem.kinematics, branch) {
            let problem = &Problem { kinematics, ..goal.problem.clone() };
            let is_last = kinematics == goal.problem.kinematics;
            let passing = goal.tolerance.max(settings::coarse_tolerance());
            let tolerance = if is_last { goal.tolerance } else { passing };
            let next = Goal { problem, tolerance, ..goal };
            outcome = self.solve(next, search)?;
            if !outcome.converged && !self.earlier.is_empty() {
                // Where the branch ends, the state jumps.
                self.earlier.clear();
                outcome = self.solve(next, search)?;
            }
        }
        let level = &self.levels[0];
        Ok((outcome, summary::resultant(&level.contact.patch, &level.traction)))
    }
}

impl Found {
    /// Marches to the state that Newton's method has not found with some work, on a grid if it is
    /// given, and warns of it.
    pub fn march(
        self,
        (problem, grid): (&Problem, Option<Grid>),
        (options, work): (&Options, &Work),
        watch: Watch,
    ) -> Result<Solution, Error> {
        let initial_state = grid.map(State::without_tractions);
        let transient = Transient { initial_state, ..Transient::to_steady_state(problem) };
        let mut marched = march(&transient, options, watch)?;
        marched.work.newton_iterations += work.newton_iterations;
        marched.work.operator_products += work.operator_products;
        let Outcome { residual, iterations: newton_steps, .. } = self.outcome;
        marched.warnings.push(Warning::Marched { residual, newton_steps });
        marched.warnings.extend(self.warning);
        Ok(marched)
    }
}
