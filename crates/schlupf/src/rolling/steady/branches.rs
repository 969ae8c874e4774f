//! Multiple steady states for one motion. Where friction falls faster with slip than the bodies
//! relax, a part of the patch may either stick or slide. The state of a wheel depends on its
//! history, so the creepage is followed: from low slip, and from high slip.

use crate::kinematics::Kinematics;
use crate::problem::{Branch, Problem};

use super::level::Level;

/// Feedback above which there may be several states, dimensionless: the slip that follows from the
/// decrease of friction due to a small slip, for a single cell. It is an estimate: of 8000 random
/// contacts with steep friction none below it had two states.
const STRONG: f64 = 1.0;

/// Largest slip speeds at which the law is sampled, relative to the present ones, and how densely.
const SAMPLED: f64 = 10.0;
const SAMPLES: usize = 60;

/// Number of speeds at which each cell is sampled.
const SPEEDS: usize = 4;

/// Number of steps of the motion along which the low branch is followed.
const STEPS_UP: u32 = 16;

/// The same for the high branch, starting from this multiple of the motion.
const STEPS_DOWN: u32 = 10;
const HIGHEST: f64 = 6.0;

/// Number of those steps where there is only one state.
const FEWEST_STEPS: u32 = 3;

/// Fraction of the largest multiple of the motion with which the wheel still rolls forwards.
const ROLLING: f64 = 0.95;

/// Difference of the forces over μ0 N above which two states are distinct, in tolerances.
pub(super) const DISTINCT: f64 = 30.0;

/// Whether the feedback of friction on slip is so strong that there may be several steady states;
/// `has_state` tells whether the slip is that of a steady state.
pub(super) fn may_be_several(problem: &Problem, level: &Level, has_state: bool) -> bool {
    level.friction.is_coupled && feedback(problem, level, has_state) > STRONG
}

/// Ratio of the slip speed that follows elastically to the one that caused it, dimensionless. Heat
/// is not included: it comes from upstream, so it affects the slip that generated it only through
/// the elasticity of the whole patch; no contact with several states due to heat was found.
fn feedback(problem: &Problem, level: &Level, has_state: bool) -> f64 {
    let Level { contact, friction, .. } = level;
    let loosening =
        contact.cell_compliance() * problem.kinematics.speed / contact.patch.grid.spacing_x;
    // If no state was found the slip is arbitrary and may hide the steep part of the law: the rigid
    // slip is used.
    let rigid = contact.patch.cells.iter().map(|cell| cell.rigid_slip(&problem.kinematics));
    let rigid = rigid.map(|v| problem.kinematics.speed * v[0].hypot(v[1])).fold(0.0, f64::max);
    let fastest = friction.slip.iter().map(|v| v[0].hypot(v[1])).fold(0.0, f64::max);
    let fastest = if has_state { fastest } else { rigid };
    // Every cell at its y and its temperature, each at another speed: neighbouring cells complement
    // each other.
    let cells = contact.patch.cells.iter().zip(&friction.scaled_rise).enumerate();
    let fall = cells.map(|(k, (cell, scaled_rise))| {
        let falls = (0..SPEEDS).map(|n| {
            let part = ((k * SPEEDS + n) % SAMPLES + 1) as f64 / SAMPLES as f64;
            let speed = SAMPLED * fastest * part.powi(3);
            -problem
                .friction_response(&friction.conduction, *scaled_rise, speed, cell.y)
                .by_slip_speed
        });
        cell.pressure * falls.fold(0.0, f64::max)
    });
    loosening * fall.fold(0.0, f64::max)
}

/// The motions along which a branch is followed, the given one last. Fewer steps do where there is
/// only one state.
pub(super) fn motions_to(
    kinematics: &Kinematics,
    branch: Branch,
    may_be_several: bool,
) -> Vec<Kinematics> {
    let part = |share: f64| Kinematics {
        creepage_x: share * kinematics.creepage_x,
        creepage_y: share * kinematics.creepage_y,
        spin: share * kinematics.spin,
        ..*kinematics
    };
    match branch {
        Branch::LowSlip => {
            let share = |n: u32| (f64::from(n) / f64::from(STEPS_UP)).powi(2);
            (1..=STEPS_UP).map(share).map(part).collect()
        }
        Branch::HighSlip => {
            let steps = if may_be_several { STEPS_DOWN } else { FEWEST_STEPS };
            let rolls = |share: f64| part(share / ROLLING).check().is_ok();
            let shares =
                (0..=steps).rev().map(|n| HIGHEST.powf(f64::from(n) / f64::from(steps)));
            let highest = shares.into_iter().find(|share| rolls(*share)).unwrap_or(1.0);
            let share = |n: u32| highest.powf(f64::from(n) / f64::from(steps));
            (0..=steps).rev().map(share).map(part).collect()
        }
    }
}
