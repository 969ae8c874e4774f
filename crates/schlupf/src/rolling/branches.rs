//! Several steady states at one motion. Where friction falls faster with the slip than the bodies
//! relax, a part of the patch may stick as well as slide. Which state a wheel is in depends on where it
//! comes from, so this follows the creepage: from low slip, and from high slip.

use crate::equilibrium::Outcome;
use crate::kinematics::Kinematics;
use crate::problem::{Branch, Problem};

use super::level::Level;

/// Feedback from which on there may be several states, dimensionless: how much slip follows from
/// the fall of friction by a little slip, as a cell alone would answer. With less there is one state.
const STRONG: f64 = 1.0;

/// Largest slip speeds at which the law is sampled over the present ones, and how densely.
const SAMPLED: f64 = 10.0;
const SAMPLES: u32 = 60;

/// Parts of the motion along which the low branch is followed.
const STEPS_UP: u32 = 16;

/// The same for the high one, from this many times the motion on.
const STEPS_DOWN: u32 = 10;
const HIGHEST: f64 = 6.0;

/// Largest creepage along rolling on the way, so that the wheel still rolls forwards.
const LARGEST_CREEPAGE: f64 = 0.95;

/// Difference of the forces over μ0 N from which on two states are two, dimensionless.
pub(super) const DISTINCT: f64 = 1e-3;

/// What is said where a branch could not be followed.
pub(super) const LOST: &str = "friction falls so fast that there may be several steady states; they \
    could not be followed along the creepage, so it is open which one this is";

/// Whether friction feeds back on the slip so strongly that there may be several steady states, or that
/// none was found.
pub(super) fn may_be_several(problem: &Problem, level: &Level, outcome: &Outcome) -> bool {
    level.friction.is_coupled && (!outcome.converged || feedback(problem, level) > STRONG)
}

/// Slip speed that follows elastically, over the one that caused it, dimensionless. Heat does not count:
/// it comes from upstream, where nothing depends on what follows.
fn feedback(problem: &Problem, level: &Level) -> f64 {
    let contact = &level.contact;
    let loosening =
        contact.cell_looseness() * problem.kinematics.speed / contact.patch.grid.spacing_x;
    loosening * contact.normal.peak_pressure * steepest_fall(problem, level)
}

/// Largest fall of the law with the slip speed at any speed that the motion may reach, in s/m.
fn steepest_fall(problem: &Problem, level: &Level) -> f64 {
    let friction = &level.friction;
    let fastest = friction.slip.iter().map(|v| v[0].hypot(v[1])).fold(0.0, f64::max);
    let sampled = (0..=SAMPLES).map(|n| {
        let speed = SAMPLED * fastest * (f64::from(n) / f64::from(SAMPLES)).powi(3);
        -problem.friction_response(&friction.conduction, 0.0, speed, 0.0).by_slip_speed
    });
    sampled.fold(0.0, f64::max)
}

/// The motions along which a branch is followed, the given one last.
pub(super) fn way_to(kinematics: &Kinematics, branch: Branch) -> Vec<Kinematics> {
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
            let highest = HIGHEST.min(LARGEST_CREEPAGE / kinematics.creepage_x.max(0.0)).max(1.0);
            let share = |n: u32| highest.powf(f64::from(n) / f64::from(STEPS_DOWN));
            (0..=STEPS_DOWN).rev().map(share).map(part).collect()
        }
    }
}
