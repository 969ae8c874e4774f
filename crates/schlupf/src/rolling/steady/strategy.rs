//! The search for a steady state. What is tried, in this order, until it leads to a state:
//!
//! 1. [`Strategy::Warm`], if the solver has solved a problem with this contact before,
//! 2. [`Strategy::Cold`],
//! 3. [`Strategy::Continuation`], which also tells which of several states is found,
//! 4. [`Strategy::March`], if all creepages are given and no derivatives are needed.
//!
//! All but the last are Newton's method on nested grids from different initial guesses. Where
//! forces are prescribed, the creepages that they cause are unknown, too.

use crate::equilibrium::Outcome;
use crate::error::Error;
use crate::problem::{Branch, Options, Problem};
use crate::progress::Watch;
use crate::rolling::marching::march;
use crate::settings;
use crate::solution::{Resultant, Solution, Strategy, Work};
use crate::summary;
use crate::transient::Transient;
use crate::warning::Warning;

use super::branches;
use super::nested::{Goal, NestedGrids, Search};

/// How far Newton's method got, and a warning about the branch of the state.
#[derive(Debug, Clone, Default)]
pub(super) struct Found {
    pub outcome: Outcome,
    pub warning: Option<Warning>,
}

impl NestedGrids {
    /// The state by Newton's method, unless it is known not to be found that way.
    pub fn find(&mut self, goal: Goal, search: &mut Search) -> Result<Found, Error> {
        let unsolved = self.unsolved.as_ref().filter(|(problem, _)| goal.is_of(problem));
        if let Some((_, outcome)) = unsolved {
            return Ok(Found { outcome: *outcome, warning: None });
        }
        let mut found = Found::default();
        let mut may_be_several = false;
        for strategy in [Strategy::Warm, Strategy::Cold, Strategy::Continuation] {
            found = match strategy {
                Strategy::Warm if self.earlier.is_empty() => continue,
                // The state is found, but there may be others.
                Strategy::Cold if found.outcome.converged => continue,
                Strategy::Continuation => self.follow_motions(goal, may_be_several, search)?,
                _ => {
                    if strategy == Strategy::Cold {
                        self.earlier.clear();
                    }
                    Found { outcome: self.solve(goal, search)?, warning: None }
                }
            };
            search.work.strategy = Some(strategy);
            let converged = found.outcome.converged;
            let is_followed = strategy == Strategy::Continuation || !goal.drives.is_empty();
            let Goal { problem, .. } = goal;
            may_be_several =
                !is_followed && branches::may_be_several(problem, &self.levels[0], converged);
            if converged && !may_be_several {
                return Ok(found);
            }
        }
        if goal.drives.is_empty() {
            self.unsolved = Some((goal.problem.clone(), found.outcome));
        }
        Ok(found)
    }

    /// Along motions to the state: if forces are prescribed from that of the guessed motion, and
    /// else along the branch that is asked for. Where there may be several states, the other one is
    /// followed, too, and a warning tells whether they differ; if one is lost, the state is
    /// whichever is found.
    fn follow_motions(
        &mut self,
        goal: Goal,
        may_be_several: bool,
        search: &mut Search,
    ) -> Result<Found, Error> {
        if !goal.drives.is_empty() {
            self.earlier.clear();
            let guessed = Goal { drives: &goal.drives.without(), ..goal };
            let mut outcome = self.solve(guessed, search)?;
            if outcome.converged {
                outcome = self.solve(goal, search)?;
            }
            return Ok(Found { outcome, warning: None });
        }
        if !may_be_several {
            let followed = self.follow(goal, Branch::HighSlip, search)?;
            let outcome = followed.map_or_else(Outcome::default, |(outcome, _)| outcome);
            return Ok(Found { outcome, warning: None });
        }
        let branch = search.options.branch;
        let other = match branch {
            Branch::LowSlip => Branch::HighSlip,
            Branch::HighSlip => Branch::LowSlip,
        };
        let there = self.follow(goal, other, search)?;
        let here = self.follow(goal, branch, search)?;
        let (Some((outcome, force)), Some((_, other))) = (here, there) else {
            self.earlier.clear();
            let outcome = self.solve(goal, search)?;
            return Ok(Found { outcome, warning: Some(Warning::BranchLost {}) });
        };
        let normal = &self.levels[0].contact.normal;
        let limit = goal.problem.friction.cold_coefficient() * normal.load;
        let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
        let change = force.plus(-1.0, &other).scaled(1.0, lever.recip());
        let apart = change.tangential().hypot(change.moment_z.unwrap_or(0.0));
        let warning = (apart > settings::distinct_states() * search.options.tolerance * limit)
            .then(|| {
                let tangential = |force: Resultant| [force.x, force.y];
                Warning::SeveralStates {
                    from_low_slip: branch == Branch::LowSlip,
                    force: tangential(force),
                    other_force: tangential(other),
                }
            });
        Ok(Found { outcome, warning })
    }

    /// The end of a branch with its forces; `None` if the state there is not found.
    fn follow(
        &mut self,
        goal: Goal,
        branch: Branch,
        search: &mut Search,
    ) -> Result<Option<(Outcome, Resultant)>, Error> {
        self.earlier.clear();
        let mut end = None;
        for kinematics in branches::motions_to(&goal.problem.kinematics, branch) {
            let problem = &Problem { kinematics, ..goal.problem.clone() };
            let next = Goal { problem, ..goal };
            let mut outcome = self.solve(next, search)?;
            if !outcome.converged && !self.earlier.is_empty() {
                // Where the branch ends, the state jumps.
                self.earlier.clear();
                outcome = self.solve(next, search)?;
            }
            end = Some(outcome).filter(|outcome| outcome.converged);
        }
        let force = summary::resultant(&self.levels[0].contact.patch, &self.levels[0].traction);
        Ok(end.map(|outcome| (outcome, force)))
    }
}

impl Found {
    /// Marches to the state that Newton's method has not found with some work, and warns of it.
    pub fn march(
        self,
        problem: &Problem,
        (options, work): (&Options, &Work),
        watch: Watch,
    ) -> Result<Solution, Error> {
        let mut marched = march(&Transient::to_steady_state(problem), options, watch)?;
        marched.work.newton_iterations += work.newton_iterations;
        marched.work.operator_products += work.operator_products;
        let Outcome { residual, iterations: newton_steps, .. } = self.outcome;
        marched.warnings.push(Warning::Marched { residual, newton_steps });
        marched.warnings.extend(self.warning);
        Ok(marched)
    }
}
