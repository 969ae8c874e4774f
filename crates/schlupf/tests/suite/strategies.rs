//! What leads to a steady state, as `work.strategy` says it.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::common::{cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::elasticity::Winkler;
use schlupf::interface::friction::{Exponential, FrictionMemory, Linear, Polach, SlipTerms};
use schlupf::interface::{ContactLaw, Incremental, ThirdBodyLayer};
use schlupf::normal::Ellipse;
use schlupf::problem::{FastMethod, LongitudinalForce, PrescribedForces};
use schlupf::solution::{Strategy, Work};
use schlupf::solver::SteadySolver;
use schlupf::{Method, Options, Problem, Solution, Solver, Status, Warning, unwatched};

fn coulomb() -> Problem {
    problem(rolling(1e-3, 0.0, 0.0)).with_interface(|interface| {
        interface.contact_law = ContactLaw::Coulomb;
        interface.elasticity = half_space();
    })
}

/// The same contact with another creepage.
fn at(base: &Problem, creepage_x: f64) -> Problem {
    Problem { kinematics: rolling(creepage_x, 0.0, 0.0), ..base.clone() }
}

fn solve(solver: &mut dyn Solver, problem: &Problem) -> Solution {
    let solution = solver.solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

fn strategy(solver: &mut dyn Solver, problem: &Problem) -> Option<Strategy> {
    solve(solver, problem).work.strategy
}

/// The first solution is cold, the next one warm; a motion so much slower that the solution before
/// is a worse start than none is cold again, as are cells that are solved one by one.
#[test]
fn earlier_solutions_are_used_where_they_help() {
    let mut solver = SteadySolver::new(&cells(16));
    let base = coulomb();
    assert_eq!(strategy(&mut solver, &at(&base, 1e-3)), Some(Strategy::Cold));
    assert_eq!(strategy(&mut solver, &at(&base, 1.1e-3)), Some(Strategy::Warm));
    assert_eq!(strategy(&mut solver, &at(&base, 5e-2)), Some(Strategy::Warm));
    assert_eq!(strategy(&mut solver, &at(&base, 1e-6)), Some(Strategy::Cold));
    let bed = base.with_interface(|interface| {
        interface.elasticity = Arc::new(Winkler::new(1e13, 1e13).unwrap());
        interface.contact_law = Incremental::new(5e6).unwrap().into();
    });
    for creepage in [1e-3, 1.1e-3] {
        assert_eq!(strategy(&mut solver, &at(&bed, creepage)), Some(Strategy::Cold));
    }
    let fast = &mut *Method::Fast(FastMethod::KalkerLinear).solver(&cells(16));
    assert_eq!(strategy(fast, &coulomb()), None);
}

/// Where friction falls so steeply that there may be several states, branches are followed.
#[test]
fn branches_are_a_continuation() {
    let law = Linear(SlipTerms::new(0.4, 0.05, 0.004, None).unwrap());
    let mut several = problem(rolling(9.875e-4, 0.0, 0.0));
    several.kinematics.speed = 15.0;
    several.interface.contact_law = Incremental::new(1e9).unwrap().into();
    several.interface.friction.law = Arc::new(law);
    let found = solve(&mut SteadySolver::new(&cells(8)), &several);
    assert_eq!(found.work.strategy, Some(Strategy::Continuation));
    assert!(found.warnings.iter().any(|of| matches!(of, Warning::SeveralStates { .. })));
}

/// Friction that falls steeply, but with a memory that the cells resolve, on a locomotive's patch
/// with a layer: one state, as cheap on a fine grid.
#[test]
fn memory_leaves_one_state_on_fine_grids() {
    let mut problem = coulomb();
    problem.kinematics.speed = 10.0;
    problem.kinematics.creepage_x = 6e-3;
    problem.normal = Arc::new(Ellipse::from_load(8.5e-3, 5.5e-3, 106.7e3).unwrap());
    problem.interface.layer = Some(ThirdBodyLayer::new(1.25e-3, 8.2e9).unwrap());
    problem.interface.friction.law =
        Arc::new(Exponential(SlipTerms::new(0.33, 0.14, 1.25, None).unwrap()));
    problem.interface.friction.memory = Some(FrictionMemory::new(3e-6, 1e-3).unwrap());
    for count in [24, 48, 140] {
        let Work { strategy, operator_products, .. } =
            solve(&mut SteadySolver::new(&cells(count)), &problem).work;
        assert_eq!(strategy, Some(Strategy::Cold), "{count} cells");
        assert!(operator_products < 40.0, "{operator_products} products on {count} cells");
    }
}

/// Prescribed forces are found with the tractions, cold and warm; along a path of forces where
/// friction falls.
#[test]
fn prescribed_forces_say_what_led_to_them() {
    let forced = |force: f64| {
        let x = Some(LongitudinalForce::Force(force));
        Problem { prescribed: PrescribedForces { x, ..Default::default() }, ..coulomb() }
    };
    let base = forced(-8e3);
    let mut solver = Method::Full.solver(&cells(16));
    assert_eq!(strategy(&mut *solver, &base), Some(Strategy::Cold));
    let x = Some(LongitudinalForce::Force(-8.2e3));
    let next = Problem { prescribed: PrescribedForces { x, ..Default::default() }, ..base.clone() };
    assert_eq!(strategy(&mut *solver, &next), Some(Strategy::Warm));
    let mut falling = base;
    falling.interface.friction.law = Arc::new(Polach::new(0.4, 0.4, 0.5).unwrap());
    assert_eq!(strategy(&mut *solver, &falling), Some(Strategy::Continuation));
}

/// What Newton's method does not find is marched to, with the residual at which it stopped. It is
/// not tried again, not even after another state that is not found, and the result is the same.
/// There are no derivatives.
#[test]
fn what_is_not_found_is_marched_to() {
    let options = Options { max_iterations: 3, tolerance: 1e-4, ..cells(12) };
    let mut base = coulomb();
    base.kinematics.spin = 0.5;
    let mut solver = SteadySolver::new(&options);
    let first = solve(&mut solver, &base);
    let other = Problem { kinematics: rolling(1.1e-3, 0.0, 0.5), ..base.clone() };
    assert_ne!(solver.solve(&other, &unwatched).unwrap().work.strategy, Some(Strategy::Cold));
    let second = solve(&mut solver, &base);
    for found in [&first, &second] {
        assert_eq!(found.work.strategy, Some(Strategy::March));
        let [Warning::Marched { residual, newton_steps }] = found.warnings[..] else {
            panic!("{:?}", found.warnings)
        };
        assert!(residual > options.tolerance && newton_steps == 3, "{residual} {newton_steps}");
    }
    assert_eq!((first.force, &first.warnings), (second.force, &second.warnings));
    assert!(first.work.newton_iterations > second.work.newton_iterations);
    assert!(solver.solve_with_derivatives(&base, &unwatched).unwrap().is_none());
}

/// A solver that was stopped goes on as if it had not been asked.
#[test]
fn a_solver_that_was_stopped_keeps_its_solutions() {
    let base = coulomb();
    let (near, far) = (at(&base, 1e-3), at(&base, 1.2e-3));
    let mut solver = SteadySolver::new(&cells(16));
    solve(&mut solver, &near);
    let asked = AtomicUsize::new(0);
    let stopping = |_| match asked.fetch_add(1, Ordering::Relaxed) {
        0 | 1 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    solver.solve(&far, &stopping).unwrap_err();
    let found = solve(&mut solver, &far);
    assert_eq!(found.work.strategy, Some(Strategy::Warm));
    let expected = solve(&mut SteadySolver::new(&cells(16)), &far);
    assert_relative_eq!(found.force.x, expected.force.x, max_relative = 1e-5);
}

/// Derivatives are found, however loose the tolerance.
#[test]
fn derivatives_are_found_at_any_tolerance() {
    let solve = |tolerance: f64| {
        let options = Options { tolerance, sensitivity: true, ..cells(16) };
        let mut solver = SteadySolver::new(&options);
        solver.solve(&coulomb(), &unwatched).unwrap()
    };
    for tolerance in [1e-8, 1e-2, 0.1] {
        let found = solve(tolerance);
        assert!(found.sensitivity.is_some(), "{tolerance}: {:?}", found.warnings);
    }
}
