//! Prescribed forces over time: the goal of every step, and the free creepages that its search
//! begins with.

use nalgebra::DVector;

use crate::bodies::Kinematics;
use crate::normal::NormalSummary;
use crate::problem::{History, PrescribedForces, Problem, Stretch};
use crate::reporting::Error;
use crate::solver::prescribed::ForceGoal;

/// The forces, and the free creepages of the last step that ended with its forces; without forces
/// all creepages are given.
#[derive(Debug, Clone, Default)]
pub(super) struct ForcesOverTime {
    /// The goal of the present step.
    pub goal: ForceGoal,
    reached: DVector<f64>,
    /// Their change over that step, if it was more than noise and the step before was one, too.
    trend: DVector<f64>,
    has_reached: bool,
}

/// What a step begins with.
pub(super) struct Start {
    /// Over the step, at the centre of the patch.
    pub motion: Kinematics,
    pub goal: ForceGoal,
    /// Whether the tractions go on to change as in the last step.
    pub goes_on: bool,
}

impl ForcesOverTime {
    /// Those of a problem and a history, about a reference point at a place (x and y in m).
    ///
    /// # Errors
    /// Forces beyond friction, if that is the same everywhere, and those of Kalker's coefficients.
    pub fn new(
        problem: &Problem,
        (prescribed, stretches): (&PrescribedForces, &[Stretch]),
        (normal, place): (&NormalSummary, [f64; 2]),
    ) -> Result<Self, Error> {
        let prescribed = stretches.first().map_or(*prescribed, |Stretch { rolling, .. }| {
            rolling.prescribed(rolling.span()[0], prescribed)
        });
        let goal = ForceGoal::new(problem, &prescribed, (normal, place))?;
        let [reached, trend] = [(); 2].map(|()| DVector::zeros(goal.count()));
        let mut forces = Self { goal, reached, trend, has_reached: false };
        let has_limit = problem.uniform_friction(normal.semi_axis_y).is_some();
        let instants = stretches.iter().flat_map(|Stretch { rolling, .. }| {
            rolling.time.iter().map(move |time| (rolling, time))
        });
        for (history, time) in instants.filter(|_| has_limit && !prescribed.is_none()) {
            forces.begin(history, *time, history.load(*time).unwrap_or(normal.load));
            let at_time = |error| Error::AtTime { error: Box::new(error), time: *time };
            forces.goal.refuse_beyond_friction().map_err(at_time)?;
        }
        Ok(forces)
    }

    /// Sets the goal of a step that ends at a time (in s) under a load, in N.
    pub fn begin(&mut self, history: &History, time: f64, load: f64) {
        let prescribed = history.prescribed(time, self.goal.prescribed());
        self.goal = self.goal.with(&prescribed, load);
    }

    /// What is tried in turn from a motion at the centre of the patch, until a state is found: that
    /// the creepages go on to change; from free creepages of zero, where not everything slides; and
    /// without the forces, with the last creepages that had them.
    pub fn starts(&self, given: &Kinematics) -> Vec<Start> {
        let start = |goal: &ForceGoal, creepages: &DVector<f64>, goes_on| {
            let motion = self.goal.motion(given, creepages.as_slice());
            Start { motion, goal: goal.clone(), goes_on }
        };
        let mut ahead = start(&self.goal, &(&self.reached + &self.trend), true);
        if ahead.motion.check().is_err() {
            ahead = start(&self.goal, &self.reached, true);
        }
        let at_rest = start(&self.goal, &(&self.reached * 0.0), false);
        let without = start(&ForceGoal::default(), &self.reached, false);
        vec![ahead, at_rest, without]
    }

    /// Forgets the free creepages: those of rolling are not those of shifts.
    pub fn forget(&mut self) {
        self.reached.fill(0.0);
        self.trend.fill(0.0);
        self.has_reached = false;
    }

    /// Notes the motion of a step at the centre of the patch, whether it has missed its forces, and
    /// whether it is to go on to change.
    pub fn note(&mut self, motion: &Kinematics, (is_missed, goes_on): (bool, bool)) {
        let found = self.goal.creepages(motion);
        self.trend = &found - &self.reached;
        if !goes_on || !self.has_reached {
            self.trend.fill(0.0);
        }
        (self.reached, self.has_reached) = (found, !is_missed);
    }
}
