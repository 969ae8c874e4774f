//! The state that is sought, and what has become of it.

use crate::problem::Problem;
use crate::reporting::Warning;
use crate::solver::equilibrium::Outcome;
use crate::solver::prescribed::ForceGoal;

/// The state that is sought.
#[derive(Clone, Copy)]
pub(super) struct Goal<'a> {
    /// Creepages whose force is prescribed are a first guess.
    pub problem: &'a Problem,
    /// The prescribed forces; none if all creepages are given.
    pub forces: &'a ForceGoal,
    /// Residual of the state at most, dimensionless.
    pub tolerance: f64,
}

/// How far Newton's method got, and a warning about the branch of the state.
#[derive(Debug, Clone, Default)]
pub(super) struct Found {
    pub outcome: Outcome,
    pub warning: Option<Warning>,
}

/// A goal that Newton's method has not reached, and where it ended.
pub(super) struct Unsolved {
    problem: Problem,
    forces: ForceGoal,
    pub found: Found,
}

impl Unsolved {
    pub fn new(Goal { problem, forces, .. }: Goal, found: &Found) -> Self {
        Self { problem: problem.clone(), forces: forces.clone(), found: found.clone() }
    }

    /// Whether it is a goal of the same contact.
    pub fn is(&self, goal: &Goal) -> bool {
        let kinematics = &self.problem.kinematics;
        let (one, other) = (&self.problem.interface, &goal.problem.interface);
        *kinematics == goal.problem.kinematics
            && self.problem.branch == goal.problem.branch
            && (one.contact_law, one.wheel, one.rail)
                == (other.contact_law, other.wheel, other.rail)
            && one.friction.is_same(&other.friction)
            && one.heat.is_same(&other.heat)
            && self.forces == *goal.forces
    }
}
