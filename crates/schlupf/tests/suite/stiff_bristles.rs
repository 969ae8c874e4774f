//! Contacts that Newton's method found late or not at all: bristles almost as stiff as Coulomb's
//! friction, very high slip. Found by random search; the work is what is asserted.

use crate::common::{at_once, cells, half_space, layer, problem, rolling};
use schlupf::bodies::Kinematics;
use schlupf::elasticity::Elasticity;
use schlupf::interface::friction::{
    Constant, Exponential, FrictionMemory, SlipTerms, TemperatureLinear,
};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental, TotalDisplacement};
use schlupf::normal::Ellipse;
use schlupf::solution::Work;
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solver, unwatched};
use std::sync::Arc;

fn heated(mut problem: Problem, coefficient: f64) -> Problem {
    problem.interface.friction.law =
        Arc::new(TemperatureLinear::new(coefficient, 700.0, 0.0).unwrap());
    problem.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    problem
}

/// Steel on the half-space: a, b (in m), p0 (in Pa), k_c (in 1/m).
fn steel(kinematics: Kinematics, [a, b, p0]: [f64; 3], law: ContactLaw) -> Problem {
    let mut steel = problem(kinematics);
    steel.normal = Arc::new(Ellipse::from_peak_pressure(a, b, p0).unwrap());
    steel.interface.elasticity = half_space();
    steel.interface.contact_law = law;
    steel
}

fn incremental(stiffness: f64) -> ContactLaw {
    Incremental::new(stiffness).unwrap().into()
}

fn total(stiffness: f64) -> ContactLaw {
    TotalDisplacement::new(stiffness).unwrap().into()
}

/// A wheel that spins up to ten thousand times too fast. Friction has all but vanished where the
/// material has entered; the interpolated solution of a coarser grid is too hot everywhere, and the
/// state of rigid bodies is a better first guess. It is the solution, nearly, so no Newton step is
/// left; heat moves friction from one step to the next only where the bodies yield.
#[test]
fn any_creepage_is_found_at_once() {
    for elasticity in [layer(), half_space()] {
        for creepage in [-1.0, -10.0, -100.0, -1e3, -1e4] {
            for stiffness in [5e6, 1e9] {
                let mut spinning = heated(problem(rolling(creepage, 0.0, 0.0)), 0.3);
                spinning.interface.elasticity = Arc::<dyn Elasticity>::clone(&elasticity);
                spinning.interface.contact_law = incremental(stiffness);
                let Work { newton_iterations, operator_products, .. } =
                    at_once(&spinning, &cells(24)).work;
                assert!(newton_iterations <= 6, "{creepage}: {newton_iterations}");
                assert!(operator_products < 14.0, "{creepage}: {operator_products}");
            }
        }
    }
}

/// Friction that follows its law over a sliding distance, k_c from 2e10/m to 8e11/m: each marched
/// for seconds.
#[test]
fn stiff_bristles_with_friction_memory() {
    let at = |speed, x, y| Kinematics {
        creepage_x: x,
        creepage_y: y,
        ..Kinematics::free_rolling(speed)
    };
    let falling = |mut problem: Problem, coefficient: f64, half_speed: f64| {
        let terms = SlipTerms::new(coefficient, 0.5 * coefficient, half_speed, None).unwrap();
        problem.interface.friction.law = Arc::new(Exponential(terms));
        problem
    };
    let remembering = |mut problem: Problem, distance: f64, least_speed: f64| {
        problem.interface.friction.memory =
            Some(FrictionMemory::new(distance, least_speed).unwrap());
        problem
    };
    let axes = [[4.9e-3, 5.96e-3, 3.13e8], [2.45e-3, 1e-2, 1.27e9], [4.89e-3, 1.18e-2, 1.53e9]];
    let sliding = steel(at(94.0, 2.78e-4, 7.39e-4), axes[0], total(8.07e11));
    let hot = steel(at(72.2, 5.13e-3, 0.0), axes[1], total(7.47e11));
    let slow = steel(at(4.08, 4.07e-3, 3.09e-3), axes[2], total(1.96e10));
    let turning =
        steel(at(35.7, -3.69e-3, 1.32e-3), [5.04e-3, 6.73e-3, 1.01e9], incremental(5.5e11));
    let cases = [
        remembering(falling(sliding, 0.2, 1.0), 5.8e-6, 2.6e-3),
        remembering(heated(hot, 0.49), 7.2e-5, 8.7e-4),
        remembering(falling(slow, 0.24, 1.0), 6.3e-5, 1.3e-3),
        remembering(falling(turning, 0.28, 1.0), 3.7e-5, 0.0),
    ];
    for case in &cases {
        let work = at_once(case, &cells(12)).work;
        println!("{work:?}");
        assert!(work.newton_iterations <= 150, "{work:?} {case:?}");
    }
}

/// The same without memory, with constant friction and with heat.
#[test]
fn stiff_bristles() {
    let at = |speed, x, y| Kinematics {
        creepage_x: x,
        creepage_y: y,
        ..Kinematics::free_rolling(speed)
    };
    let constant = |mut problem: Problem, coefficient: f64| {
        problem.interface.friction.law = Arc::new(Constant::new(coefficient).unwrap());
        problem
    };
    let narrow = steel(at(90.6, -3.375e-3, 1.1e-5), [3.92e-3, 3.3e-3, 7.29e8], total(6.9e11));
    let small = steel(at(4.7, 3.04e-4, 8.35e-4), [3.16e-3, 2.19e-3, 6.89e8], incremental(1.37e11));
    let long = steel(at(54.6, -2.13e-3, 0.0), [1.05e-2, 2.89e-3, 9.94e8], incremental(3.56e9));
    let across = steel(at(23.4, 0.0, 2.35e-3), [3.39e-3, 4.71e-3, 9.78e8], incremental(2.37e11));
    let cases =
        [constant(narrow, 0.42), constant(small, 0.21), heated(long, 0.27), heated(across, 0.2)];
    for case in &cases {
        let work = at_once(case, &cells(12)).work;
        println!("{work:?}");
        assert!(work.newton_iterations <= 150, "{work:?} {case:?}");
    }
}

/// Where Newton's method fails although friction does not fall with the slip speed, that is what is
/// said, not that there may be several steady states.
#[test]
fn a_failure_is_not_several_states() {
    let hot = heated(problem(rolling(0.004, 0.002, 0.3)), 0.4);
    let options = Options { max_iterations: 1, max_steps: 30, ..cells(8) };
    let solution = schlupf::solver::solve(&hot, &options, &unwatched).unwrap();
    let says = |what: &str| solution.warnings.iter().any(|text| text.to_string().contains(what));
    assert!(says("was not found directly"), "{:?}", solution.warnings);
    assert!(!says("several"), "{:?}", solution.warnings);
}

/// From full sliding to a motion at which nearly all sticks: the earlier solutions say nothing, and
/// a step along F is no way out of them. What is found is what is found without them, at about the
/// same cost.
#[test]
fn from_sliding_to_sticking() {
    const STATE: [f64; 3] = [5e-3, 5e-3, 1e9];
    let sliding = [rolling(0.03, 0.0, 0.0), rolling(0.0, 0.03, 0.0), rolling(0.01, 0.01, 2.0)];
    let sticking = [rolling(1e-5, 0.0, 0.0), rolling(0.0, -1e-4, 0.0), rolling(0.0, 0.0, 0.002)];
    let laws: [ContactLaw; 4] =
        [ContactLaw::Coulomb, incremental(1e9), incremental(1e8), incremental(5e6)];
    for law in laws {
        for at in sliding {
            for next in sticking {
                let of = |kinematics| steel(kinematics, STATE, law);
                let mut solver = SteadySolver::new(&cells(40));
                for part in [0.5, 1.0] {
                    let Kinematics { creepage_x, creepage_y, spin, .. } = at;
                    let on_the_way = rolling(part * creepage_x, part * creepage_y, part * spin);
                    solver.solve(&of(on_the_way), &unwatched).unwrap();
                }
                let warm = solver.solve(&of(next), &unwatched).unwrap();
                let cold = at_once(&of(next), &cells(40));
                let [x, y] = [warm.force.x - cold.force.x, warm.force.y - cold.force.y];
                let off = x.hypot(y) / cold.force.tangential();
                let products = [&warm, &cold].map(|solution| solution.work.operator_products);
                println!("{law:?} {at:?} {next:?}: {products:.1?}, {off:e}");
                assert!(off < 1e-4, "{law:?} {at:?} {next:?}: {off:e}");
                assert!(products[0] < products[1] + 2.0, "{law:?} {at:?} {next:?}: {products:?}");
            }
        }
    }
}

/// Bristles between soft and stiff on fine grids, under motions so slow that all but the edges
/// sticks: hundreds to thousands of products if the preconditioner does not know how the cells of a
/// strip move each other.
#[test]
fn a_patch_that_sticks() {
    for (stiffness, count, most) in
        [(2e7, 40, 60.0), (4e7, 80, 80.0), (5e7, 60, 40.0), (7e7, 80, 40.0), (1e8, 80, 40.0)]
    {
        for spin in [1e-3, 1e-2] {
            let problem = steel(rolling(0.0, 0.0, spin), [5e-3, 5e-3, 1e9], incremental(stiffness));
            let products = at_once(&problem, &cells(count)).work.operator_products;
            println!("{stiffness:e}, {count} cells, {spin}/m: {products:.1}");
            assert!(products < most, "{stiffness:e}, {count} cells, {spin}/m: {products}");
        }
    }
}
