//! Stiff bristles in series with stick and slip, in time: marching, histories and states.

use std::sync::Arc;

use crate::common::transients::{self, LIMIT, LOAD, constant, swinging};
use crate::common::{
    at_once, cells, follow, from_state, half_space, layer, problem, rolling, solve, solve_over,
};
use approx::assert_relative_eq;
use schlupf::elasticity::{Elasticity, Winkler};
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental};
use schlupf::normal::Ellipse;
use schlupf::problem::{Element, History};
use schlupf::reporting::StateError;
use schlupf::solver::march;
use schlupf::{Error, Options, Problem, Solution, Status, Transient, unwatched};

fn bristly(elasticity: Arc<dyn Elasticity>, stiffness: f64, motion: [f64; 3]) -> Problem {
    let [xi, eta, spin] = motion;
    let contact_law = Incremental::new(stiffness).unwrap().into();
    problem(rolling(xi, eta, spin)).with_interface(|interface| {
        interface.elasticity = elasticity;
        interface.contact_law = contact_law;
    })
}

fn hot(mut problem: Problem) -> Problem {
    problem.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    problem.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    problem
}

fn gap(one: &Solution, two: &Solution) -> f64 {
    let (one, two) = (one.normalised, two.normalised);
    let moment = one.moment_z.unwrap() - two.moment_z.unwrap();
    (one.x - two.x).hypot(one.y - two.y).hypot(moment)
}

/// Steady and marched solve the same discrete equations: they agree to ten times the tolerance,
/// from nearly all stick to nearly all slip, and with heat.
#[test]
fn the_steady_state_is_the_end_of_marching() {
    let options = Options { tolerance: 1e-8, ..cells(16) };
    for elasticity in [half_space(), layer()] {
        for stiffness in [2e8, 1e10] {
            for motion in [[5e-4, 0.0, 0.0], [1e-3, 1.5e-3, 0.3], [0.02, 0.0, 0.5]] {
                let both = bristly(Arc::clone(&elasticity), stiffness, motion);
                let off = gap(&at_once(&both, &options), &solve(&both, &options));
                assert!(off < 10.0 * options.tolerance, "{stiffness:e} {motion:?}: {off:e}");
            }
        }
    }
    let both = hot(bristly(half_space(), 2e8, [0.01, 0.002, 0.3]));
    let off = gap(&at_once(&both, &options), &solve(&both, &options));
    assert!(off < 10.0 * options.tolerance, "{off:e}");
}

/// Cells of a bedding are solved one by one, however unlike its stiffnesses are: Newton's method
/// for all of them together has little left to do.
#[test]
fn a_bedding_of_unlike_stiffnesses_is_marched_cell_by_cell() {
    for stiffness in [[1e12, 1e14], [1e14, 1e12]] {
        let [x, y] = stiffness;
        let bedding: Arc<dyn Elasticity> = Arc::new(Winkler::new(x, y).unwrap());
        for motion in [[1e-3, 0.0, 0.0], [5e-4, 1e-3, 0.4], [3e-4, 2e-3, -0.2]] {
            for law in [ContactLaw::Coulomb, Incremental::new(5e6).unwrap().into()] {
                let elasticity = Arc::clone(&bedding);
                let [xi, eta, spin] = motion;
                let rolling = problem(rolling(xi, eta, spin));
                let both = rolling.with_interface(|interface| {
                    interface.elasticity = elasticity;
                    interface.contact_law = law;
                });
                let (steady, marched) = (at_once(&both, &cells(20)), solve(&both, &cells(20)));
                assert!(gap(&steady, &marched) < 1e-5, "{stiffness:?} {motion:?} {law:?}");
                let work = marched.work;
                assert!(work.newton_iterations <= work.steps, "{stiffness:?} {motion:?} {work:?}");
            }
        }
    }
}

/// The same while the motion turns: what the step before left is far from the next traction.
#[test]
fn a_bedding_follows_a_motion_that_turns() {
    let turning = History {
        time: vec![0.0, 1e-4, 1.2e-4, 3e-4],
        creepage_x: Some(vec![2e-3, 2e-3, -1e-3, -1e-3]),
        creepage_y: Some(vec![1e-3, 1e-3, 2e-3, -2e-3]),
        spin: Some(vec![0.4, 0.4, -0.4, 0.4]),
        ..History::default()
    };
    let bedding = Arc::new(Winkler::new(1e12, 3e12).unwrap());
    let still = problem(rolling(0.0, 0.0, 0.0));
    let turned = still.with_interface(|interface| {
        interface.elasticity = bedding;
        interface.contact_law = ContactLaw::Coulomb;
    });
    let work = solve_over(&turned, turning, &cells(40)).work;
    assert!(work.newton_iterations <= work.steps, "{work:?}");
}

/// A history of creepages is judged by the largest of them, not by that of the case: it ends where
/// one that begins there ends.
#[test]
fn a_history_is_judged_by_its_largest_creepage() {
    let options = Options { tolerance: 1e-8, ..cells(16) };
    let at = |xi: f64| hot(bristly(half_space(), 2e8, [xi, 0.0, 0.0]));
    let history = |time: Vec<f64>, creepages: Vec<f64>| History {
        time,
        creepage_x: Some(creepages),
        ..History::default()
    };
    let times = vec![0.0, 4e-4, 4e-3];
    let end = |of_case: f64, creepages: [f64; 3]| {
        let transient = Transient {
            problem: at(of_case),
            history: history(times.clone(), creepages.to_vec()),
            initial_state: None,
        };
        let solution = march(&transient, &options, &unwatched).unwrap();
        assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
        solution
    };
    let steady = at_once(&at(0.7), &options);
    let off = gap(&steady, &end(0.0, [0.0, 0.7, 0.7]));
    assert!(off < 10.0 * options.tolerance, "{off:e}");
    let off = gap(&steady, &end(0.7, [0.7, 0.7, 0.7]));
    assert!(off < 10.0 * options.tolerance, "{off:e}");
}

/// They agree on a patch twice as long as wide, too.
#[test]
fn on_long_patches_marching_ends_in_the_steady_state() {
    for motion in [[1e-3, 0.0, 0.0], [1e-3, 1e-3, 0.3], [0.0, 0.0, 0.5]] {
        let mut both = bristly(half_space(), 2e8, motion);
        both.normal = Arc::new(Ellipse::from_load(8e-3, 4e-3, 80e3).unwrap());
        let options = Options { tolerance: 1e-8, ..cells(20) };
        let off = gap(&at_once(&both, &options), &solve(&both, &options));
        assert!(off < 10.0 * options.tolerance, "{motion:?}: {off:e}");
    }
}

/// The state of the direct solver is one that marching goes on from without a change, slip
/// included.
#[test]
fn marching_goes_on_from_a_steady_state() {
    for motion in [[1e-3, 1.5e-3, 0.3], [0.01, 0.002, 0.3]] {
        let both = hot(bristly(half_space(), 2e8, motion));
        let steady = at_once(&both, &Options { tolerance: 1e-9, ..cells(16) });
        let on = follow(&from_state(&both, steady.state.clone()), &cells(16));
        for instant in &on.history {
            assert_relative_eq!(instant.force.x, steady.force.x, max_relative = 1e-6);
            assert_relative_eq!(instant.force.y, steady.force.y, max_relative = 1e-6);
        }
        let fastest = steady.fields.slip_x.iter().fold(0.0, |most: f64, slip| most.max(slip.abs()));
        for (one, two) in steady.fields.slip_x.iter().zip(&on.fields.slip_x) {
            assert!((one - two).abs() < 1e-4 * fastest, "{one} {two}");
        }
    }
}

/// From rest, and under a load that swings so fast that edges move as the wheel rolls, a time step
/// takes hardly more products than under Coulomb's law.
#[test]
fn time_steps_take_no_more_work_than_under_coulombs_law() {
    let products = |law: ContactLaw, is_fast: bool| {
        let history = if is_fast { swinging(0.7, 12e-3, 15e-3) } else { constant(12e-3) };
        let work = solve_over(&transients::reference(law), history, &cells(40)).work;
        work.operator_products / work.steps as f64
    };
    for is_fast in [false, true] {
        let coulomb = products(ContactLaw::Coulomb, is_fast);
        for stiffness in [1e8, 1e10] {
            let stiff = products(Incremental::new(stiffness).unwrap().into(), is_fast);
            println!("{is_fast} {stiffness:e}: {stiff:.1} products a step, Coulomb {coulomb:.1}");
            assert!(stiff < 1.3 * coulomb, "{is_fast} {stiffness:e}: {stiff} {coulomb}");
        }
    }
}

/// On a layer, whose surface ends at a distance from the grid, a load falls to a half, so that the
/// patch leaves most of the grid, and stays there: the end is the steady state on a grid of its
/// own, to the error of the grid.
#[test]
fn a_layer_on_a_grid_that_the_patch_leaves() {
    let laws: [ContactLaw; 2] = [ContactLaw::Coulomb, Incremental::new(2e8).unwrap().into()];
    for law in laws {
        let falling =
            transients::reference(law).with_interface(|interface| interface.elasticity = layer());
        let history = History {
            time: vec![0.0, 12e-3, 40e-3],
            load: Some(vec![LOAD, 0.5 * LOAD, 0.5 * LOAD]),
            ..History::default()
        };
        let over = solve_over(&falling, history, &cells(30));
        let products = over.work.operator_products / over.work.steps as f64;
        assert!(products < 40.0, "{products}");
        let half = falling.normal.normal_contact(Some(0.5 * LOAD)).unwrap().summary;
        let normal = Ellipse::from_load(half.semi_axis_x, half.semi_axis_y, 0.5 * LOAD).unwrap();
        let small = Problem { normal: Arc::new(normal), ..falling.clone() };
        let steady = at_once(&small, &cells(30));
        let off = (over.force.x - steady.force.x).abs() / (0.5 * LIMIT);
        assert!(off < 2e-3, "{off}");
    }
}

/// A state with places that no material can have passed is refused.
#[test]
fn impossible_tracks_are_refused() {
    let both = bristly(half_space(), 2e8, [1e-3, 0.0, 0.0]);
    let steady = at_once(&both, &cells(12));
    let refused = |spoil: fn(&mut Element)| {
        let mut state = steady.state.clone();
        let middle = state.elements.len() / 2;
        spoil(&mut state.elements[middle]);
        march(&from_state(&both, state), &cells(12), &unwatched).unwrap_err()
    };
    for error in [
        refused(|element| element.track[0].saturation = [1e6, 0.0]),
        refused(|element| element.track[0].sliding[1] = f64::NAN),
        refused(|element| element.track[1].distance = -1e-3),
        refused(|element| element.track.swap(0, 1)),
    ] {
        assert!(matches!(error, Error::State { error: StateError::Impossible {} }), "{error}");
    }
}
