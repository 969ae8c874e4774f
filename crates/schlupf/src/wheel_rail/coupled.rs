//! Contacts whose tractions change their pressure.

use super::equilibrium::{Lowered, Tractions};
use super::opening::Opening;
use super::turning::Turning;
use crate::problem::Problem;
use crate::reporting::Unconverged;
use crate::solution::Solution;
use crate::solver::unlike_bodies::finished;

/// Contacts with tractions that belong to their pressure.
pub(super) struct Coupled {
    pub lowered: Lowered,
    pub turning: Turning,
    pub tractions: Vec<Tractions>,
}

impl Turning {
    /// Tells of contacts whose pressure and tractions belong together, or missed it.
    pub fn told(&mut self, missed: Option<&Unconverged>) {
        for (_, problem, solution) in &mut self.contacts {
            finish(problem, solution, missed);
        }
    }
}

/// Tells of a contact whose pressure and tractions belong together, or missed it.
pub(super) fn finish(problem: &Problem, solution: &mut Solution, missed: Option<&Unconverged>) {
    let coupling = problem.interface.elasticity.pressure_coupling();
    if let Some(coupling) = coupling.filter(|coupling| coupling.is_mutual) {
        *solution = finished(solution.clone(), missed.cloned(), coupling.constant);
    }
}

/// Largest change of an opening where there is pressure, over the approach; dimensionless.
pub(super) fn change(lowered: &Lowered, tractions: &[Tractions]) -> f64 {
    let mut largest = 0.0_f64;
    for pressed in &lowered.contacts {
        let found = tractions.iter().find(|found| found.origin == pressed.plane.origin);
        let opening = found.and_then(|found| found.opening.as_deref());
        let Some(now) = opening.map(|opening: &Opening| opening.sample(&pressed.x, &pressed.s))
        else {
            continue;
        };
        let loaded = now.iter().zip(&pressed.pressure).enumerate().filter(|(_, (_, p))| **p > 0.0);
        let before = |k: usize| pressed.opening.get(k).copied().unwrap_or(0.0);
        let changes = loaded.map(|(k, (now, _))| (now - before(k)).abs() / pressed.approach);
        largest = changes.fold(largest, f64::max);
    }
    largest
}
