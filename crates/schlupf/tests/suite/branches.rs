//! Several steady states at one motion, where friction falls fast with the slip speed.

use std::sync::Arc;

use crate::common::{at_once, cells, problem, rolling};
use approx::assert_relative_eq;
use schlupf::interface::Incremental;
use schlupf::interface::friction::{Across, Linear, SlipTerms, Variation};
use schlupf::problem::Branch;
use schlupf::solution::Strategy;
use schlupf::{Problem, Solution, Warning};

/// Friction that has fallen from 0.4 to 0.05 at twice the half speed (in m/s).
fn falling(creepage: f64, half_speed: f64) -> Problem {
    let mut falling = problem(rolling(creepage, 0.0, 0.0));
    falling.kinematics.speed = 15.0;
    falling.interface.contact_law = Incremental::new(1e9).unwrap().into();
    let law = Linear(SlipTerms::new(0.4, 0.05, half_speed, None).unwrap());
    falling.interface.friction.law = Arc::new(law);
    falling
}

fn on_branch(problem: &Problem, branch: Branch) -> Solution {
    at_once(&Problem { branch, ..problem.clone() }, &cells(8))
}

/// Friction that is gone at 8 mm/s, where the wheel slips by 15 mm/s: some cells can stick as well
/// as slide. The result says which state it is and that there is another one, which is what the
/// other branch gives.
#[test]
fn the_branch_is_said() {
    let several = falling(9.875e-4, 0.004);
    let low = on_branch(&several, Branch::LowSlip);
    let high = on_branch(&several, Branch::HighSlip);
    let limit = 0.4 * low.normal.load;
    assert!((low.force.x - high.force.x).abs() > 1e-3 * limit, "{:?} {:?}", low.force, high.force);
    for (solution, is_low, other) in [(&low, true, &high), (&high, false, &low)] {
        let several = solution.warnings.iter().find_map(|warning| match warning {
            Warning::SeveralStates { from_low_slip, force, other_force } => {
                Some((*from_low_slip, *force, *other_force))
            }
            _ => None,
        });
        let force = |of: &Solution| [of.force.x, of.force.y];
        let (from_low_slip, here, there) = several.unwrap();
        assert_eq!((from_low_slip, here), (is_low, force(solution)));
        assert_relative_eq!(there[0], force(other)[0], max_relative = 1e-5);
    }
}

/// Steep friction is seen wherever in the patch it is: here as a hundredth of it with a factor of a
/// hundred over y, which is one only where there are no cells.
#[test]
fn a_factor_over_y_hides_no_branch() {
    let several = falling(9.875e-4, 0.004);
    let mut written = several.clone();
    let law = Linear(SlipTerms::new(0.004, 0.0005, 0.004, None).unwrap());
    let y = vec![-1e-5, 0.0, 1e-5];
    let across = Across::new(Arc::new(law), Variation::over_y(y, vec![100.0, 1.0, 100.0]).unwrap());
    written.interface.friction.law = Arc::new(across);
    let low = on_branch(&written, Branch::LowSlip);
    assert_eq!(low.work.strategy, Some(Strategy::Continuation), "{:?}", low.work);
}

/// Larger creepages on the way from high slip are still those of a wheel that rolls forwards.
#[test]
fn the_way_from_high_slip_rolls_forwards() {
    let mut wild = falling(0.7, 0.02);
    wild.kinematics.creepage_y = 0.5;
    let high = on_branch(&wild, Branch::HighSlip);
    let low = on_branch(&wild, Branch::LowSlip);
    assert_relative_eq!(low.force.x, high.force.x, max_relative = 1e-5);
}

/// With a fall that the bodies can follow both branches are one state, no branch is followed, and
/// nothing is said.
#[test]
fn one_state_has_no_branches() {
    let single = falling(0.002, 1.0);
    let low = on_branch(&single, Branch::LowSlip);
    let high = on_branch(&single, Branch::HighSlip);
    assert_relative_eq!(low.force.x, high.force.x, max_relative = 1e-12);
    assert!(
        !low.warnings.iter().any(|warning| matches!(warning, Warning::SeveralStates { .. })),
        "{:?}",
        low.warnings
    );
    assert!(low.work.newton_iterations < 40, "{:?}", low.work);
}

/// Where the fall is steep but the branches meet, they are followed and found to be one.
#[test]
fn steep_friction_with_one_state() {
    let steep = falling(0.003, 0.01);
    let low = on_branch(&steep, Branch::LowSlip);
    let high = on_branch(&steep, Branch::HighSlip);
    assert_relative_eq!(low.force.x, high.force.x, max_relative = 1e-5);
    assert_eq!(low.work.strategy, Some(Strategy::Continuation), "{:?}", low.work);
    assert!(
        !low.warnings.iter().any(|warning| matches!(warning, Warning::SeveralStates { .. })),
        "{:?}",
        low.warnings
    );
}
