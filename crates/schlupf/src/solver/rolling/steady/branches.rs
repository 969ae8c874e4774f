//! Multiple steady states for one motion. Where friction falls faster with slip than the bodies
//! relax, a part of the patch may either stick or slide. The state of a wheel depends on its
//! history, so the creepage is followed: from low slip, and from high slip.

use crate::bodies::Kinematics;
use crate::problem::{Branch, Problem};
use crate::solver::settings;

use super::level::Level;

/// Whether the feedback of friction on slip is so strong that there may be several steady states
/// on one of some nested grids; `has_state` tells whether their slip is that of a steady state.
/// Friction with memory hardly follows the slip within a small cell, but it does within those of a
/// coarse grid.
pub(super) fn may_be_several(problem: &Problem, levels: &[Level], has_state: bool) -> bool {
    let exceeds = |level: &Level| {
        feedback(problem, level, has_state && level.is_found) > settings::several_states()
    };
    levels[0].friction.is_coupled && levels.iter().any(exceeds)
}

/// Ratio of the slip speed that follows elastically to the one that caused it, dimensionless. Heat
/// is not included: it comes from upstream, so it affects the slip that generated it only through
/// the elasticity of the whole patch; no contact with several states due to heat was found.
fn feedback(problem: &Problem, level: &Level, has_state: bool) -> f64 {
    let Level { contact, friction, .. } = level;
    let passage = contact.patch.grid.spacing_x / problem.kinematics.speed;
    // If no state was found the slip is arbitrary and may hide the steep part of the law: the rigid
    // slip is used.
    let rigid = contact.patch.cells.iter().map(|cell| cell.rigid_slip(&problem.kinematics));
    let rigid = rigid.map(|v| problem.kinematics.speed * v[0].hypot(v[1])).fold(0.0, f64::max);
    let fastest = friction.slip.iter().map(|v| v[0].hypot(v[1])).fold(0.0, f64::max);
    let fastest = if has_state { fastest } else { rigid };
    // Every cell at its y and its temperature, each at other speeds: neighbouring cells complement
    // each other, and the golden ratio leaves no gaps.
    let (samples, golden) = (settings::samples_of_cell(), 0.5 * (5_f64.sqrt() - 1.0));
    let cells = contact.patch.cells.iter().enumerate();
    let fall = cells.filter(|(k, _)| !(has_state && friction.yields(*k))).map(|(k, cell)| {
        let falls = (0..samples).map(|n| {
            let part = (golden * (k * samples + n + 1) as f64).fract();
            let speed = settings::fastest_sample() * fastest * part.powi(3);
            friction.fall(problem, (k, cell.y), speed, 0.5 * passage)
        });
        cell.pressure * falls.fold(0.0, f64::max)
    });
    contact.cell_compliance() / passage * fall.fold(0.0, f64::max)
}

/// The motions along which a branch is followed, the given one last.
pub(super) fn motions_to(kinematics: &Kinematics, branch: Branch) -> Vec<Kinematics> {
    let part = |share: f64| Kinematics {
        creepage_x: share * kinematics.creepage_x,
        creepage_y: share * kinematics.creepage_y,
        spin: share * kinematics.spin,
        ..*kinematics
    };
    match branch {
        Branch::LowSlip => {
            let share = |n: usize| (n as f64 / settings::steps_of_branch() as f64).powi(2);
            (1..=settings::steps_of_branch()).map(share).map(part).collect()
        }
        Branch::HighSlip => {
            let steps = settings::steps_of_branch();
            let rolls = |share: f64| part(share / settings::locking()).check().is_ok();
            let share = |highest: f64, n: usize| highest.powf(n as f64 / steps as f64);
            let mut shares = (0..=steps).rev().map(|n| share(settings::highest_slip(), n));
            let highest = shares.find(|share| rolls(*share)).unwrap_or(1.0);
            let steps = if highest > 1.0 { steps } else { 0 };
            (0..=steps).rev().map(|n| share(highest, n)).map(part).collect()
        }
    }
}
