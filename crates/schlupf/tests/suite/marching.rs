//! The marching driver: transient rolling, states, patches that change, honest status.

use crate::common::{cells, follow, from_state, problem, rolling, solve, solve_over};
use approx::assert_relative_eq;
use schlupf::elasticity::Winkler;
use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
use schlupf::interface::Incremental;
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::{PressureTable, Tabulated};
use schlupf::problem::History;
use schlupf::reporting::StateError;
use schlupf::solver::march;
use schlupf::solver::reference::winkler_strip;
use schlupf::{Options, Quantity, Status, Transient, unwatched};
use std::sync::Arc;

/// Kalker 1982 in the limit of an exact integration: Winkler bedding, Coulomb friction, elliptic
/// bound.
#[test]
fn kalker_1982_winkler_strips_with_coulomb_friction() {
    for creepage in [0.0005, 0.001, 0.003] {
        let mut stiff = problem(rolling(creepage, 0.0, 0.0));
        stiff.interface.elasticity = Arc::new(Winkler::new(2e13, 2e13).unwrap());
        stiff.interface.contact_law = Incremental::new(1e9).unwrap().into();
        let force = solve(&stiff, &cells(40)).normalised.x;
        let ratio = 2e13 * creepage * 6e-3 / (0.4 * 1e9);
        let exact = winkler_strip::force_over_limit(ratio);
        assert!((force + exact).abs() < 5e-3, "ξ {creepage}: {force}, exactly −{exact}");
    }
}

/// A layer without coupling is a Winkler bedding.
#[test]
fn winkler_is_the_layer_without_coupling() {
    let mut one = problem(rolling(0.002, 0.001, 0.3));
    let mut two = one.clone();
    let uncoupled =
        |bedding| LayerStiffness { bedding, coupling_along_x: 0.0, coupling_along_y: 0.0 };
    let layer = ElasticLayer::new(uncoupled(2e13), uncoupled(1.5e13), None).unwrap();
    one.interface.elasticity = Arc::new(layer);
    two.interface.elasticity = Arc::new(Winkler::new(2e13, 1.5e13).unwrap());
    let (one, two) = (solve(&one, &cells(20)).force, solve(&two, &cells(20)).force);
    assert_relative_eq!(one.x, two.x, max_relative = 1e-5);
    assert_relative_eq!(one.y, two.y, max_relative = 1e-5);
    assert_relative_eq!(one.moment_z.unwrap(), two.moment_z.unwrap(), max_relative = 1e-4);
}

/// Fields over time are those of the steps that the history has, the last step always among them.
#[test]
fn fields_over_time_add_up_to_the_forces_of_their_steps() {
    let options = Options { fields_every: 7, max_steps: 40, ..cells(12) };
    let moving = Transient::to_steady_state(&problem(rolling(0.001, 0.0005, 0.2)));
    let solution = march(&moving, &options, &unwatched).unwrap();
    let steps: Vec<usize> = solution.field_history.iter().map(|at| at.step).collect();
    let mut expected: Vec<usize> = (7..=solution.work.steps).step_by(7).collect();
    if !solution.work.steps.is_multiple_of(7) {
        expected.push(solution.work.steps);
    }
    assert_eq!(steps, expected);
    for at in &solution.field_history {
        let instant = &solution.history[at.step - 1];
        assert_eq!(at.time, instant.time);
        let force = at.fields.traction_x.iter().sum::<f64>() * at.fields.grid.cell_area();
        assert_relative_eq!(force, instant.force.x, max_relative = 1e-12);
    }
    let last = &solution.field_history.last().unwrap().fields;
    assert_eq!(last.traction_y, solution.fields.traction_y);
    assert_eq!(last.slip_x, solution.fields.slip_x);
}

/// From rest the force grows, and is steady after about one passage of the patch.
#[test]
fn rolling_from_rest_is_steady_after_a_passage() {
    let solution = solve(&problem(rolling(0.001, 0.0, 0.0)), &cells(20));
    let forces: Vec<f64> = solution.history.iter().map(|i| -i.force.x).collect();
    assert!(forces[0] > 0.0 && forces[0] < 0.3 * forces[19]);
    let last = forces[forces.len() - 1];
    // One passage is 20 steps; the elastic surroundings take a little longer.
    assert_relative_eq!(forces[24], last, max_relative = 0.03);
    assert_relative_eq!(forces[49], last, max_relative = 1e-3);
    let step = 12e-3 / 20.0 / 30.0;
    assert_relative_eq!(solution.history[9].time, 10.0 * step, max_relative = 1e-12);
}

/// A march that is interrupted and taken up again ends where an unbroken one does.
#[test]
fn a_state_can_be_taken_up_again() {
    let mut hot = problem(rolling(0.01, 0.002, 0.0));
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    let unbroken = solve(&hot, &cells(16));
    let short = Options { max_steps: 11, ..cells(16) };
    let half = march(&Transient::to_steady_state(&hot), &short, &unwatched).unwrap();
    assert_eq!(half.status, Status::NotConverged);
    let half = from_state(&hot, half.state);
    let rest = follow(&half, &cells(16));
    // Both look for the end once in a passage of 16 steps.
    assert!(11 + rest.work.steps <= unbroken.work.steps + 16);
    assert_relative_eq!(rest.force.x, unbroken.force.x, max_relative = 1e-6);
    assert_relative_eq!(
        rest.temperature.unwrap().max_rise,
        unbroken.temperature.unwrap().max_rise,
        max_relative = 1e-6
    );
    let other = march(&half, &cells(18), &unwatched).unwrap_err();
    assert!(other.quantity() == Quantity::InitialState);
}

/// Creepages that grow from zero and stay: the transient ends in the steady state.
#[test]
fn a_history_ends_in_the_steady_state_of_its_last_values() {
    let steady = solve(&problem(rolling(0.002, 0.001, 0.2)), &cells(16));
    let history = History {
        time: vec![0.0, 2e-4, 2e-3],
        creepage_x: Some(vec![0.0, 0.002, 0.002]),
        creepage_y: Some(vec![0.0, 0.001, 0.001]),
        spin: Some(vec![0.0, 0.2, 0.2]),
        ..History::default()
    };
    let end = solve_over(&problem(rolling(0.0, 0.0, 0.0)), history, &cells(16));
    assert_relative_eq!(end.force.x, steady.force.x, max_relative = 1e-4);
    assert_relative_eq!(end.force.y, steady.force.y, max_relative = 1e-4);
    assert_eq!(end.kinematics.creepage_x, 0.002);
    assert!(end.history[0].force.x.abs() < 0.1 * end.force.x.abs());
}

/// A load that grows and falls: the patch breathes on one grid, and when the load has stayed for
/// some passages the state is that of steady rolling under it.
#[test]
fn the_patch_follows_a_changing_load() {
    let rolling = problem(rolling(0.002, 0.0, 0.0));
    let full = rolling.normal.normal_contact(None).unwrap().summary.load;
    let history = History {
        time: vec![0.0, 1e-3, 2e-3, 4e-3],
        load: Some(vec![0.5 * full, full, 0.5 * full, 0.5 * full]),
        ..History::default()
    };
    let breathing = solve_over(&rolling, history, &cells(24));
    assert_relative_eq!(breathing.normal.load, 0.5 * full, max_relative = 1e-12);
    let largest = breathing.history.iter().map(|i| i.load).fold(0.0, f64::max);
    assert!(largest > 0.98 * full);
    let history = History {
        time: vec![0.0, 4e-3],
        load: Some(vec![0.5 * full, 0.5 * full]),
        ..History::default()
    };
    // The same patch on its own grid: they differ by the error of the grid.
    let steady = solve_over(&rolling, history, &cells(24));
    assert_relative_eq!(breathing.force.x, steady.force.x, max_relative = 3e-3);
    let load: f64 =
        breathing.fields.pressure.iter().sum::<f64>() * breathing.fields.grid.cell_area();
    assert_relative_eq!(load, 0.5 * full, max_relative = 1e-12);
}

/// The Hertzian pressure as a table gives the forces of the ellipse.
#[test]
fn a_table_of_hertzian_pressure_rolls_like_the_ellipse() {
    let exact = problem(rolling(0.002, 0.001, 0.0));
    let (a, b) = (6e-3_f64, 5e-3_f64);
    let axis = |half: f64| -> Vec<f64> { (-32..=32).map(|k| half * f64::from(k) / 30.0).collect() };
    let (x, y) = (axis(a), axis(b));
    let value = |x: f64, y: f64| 1e9 * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt();
    let pressure = y.iter().flat_map(|y| x.iter().map(|x| value(*x, *y))).collect();
    let load = exact.normal.normal_contact(None).unwrap().summary.load;
    let table = PressureTable::new(&x, &y, pressure).unwrap();
    let mut tabulated = exact.clone();
    tabulated.normal = Arc::new(Tabulated::new(table, Some(load)).unwrap());
    let (exact, tabulated) = (solve(&exact, &cells(20)), solve(&tabulated, &cells(20)));
    assert!((exact.normalised.x - tabulated.normalised.x).abs() < 5e-3);
    assert!((exact.normalised.y - tabulated.normalised.y).abs() < 5e-3);
}

/// What did not converge says so, and how far off it is.
#[test]
fn an_unfinished_march_is_not_called_converged() {
    let slow = Transient::to_steady_state(&problem(rolling(0.001, 0.0, 0.0)));
    let options = Options { max_steps: 5, ..cells(16) };
    let solution = march(&slow, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::NotConverged);
    assert!(solution.residual > options.tolerance);
    assert!(solution.warnings[0].to_string().starts_with("the march ends after 5 time steps"));
    let options = Options { max_iterations: 1, max_steps: 3, ..cells(16) };
    let solution = march(&slow, &options, &unwatched).unwrap();
    assert!(solution.warnings[0].to_string().contains("equilibrium"), "{:?}", solution.warnings);
}

/// A margin that is too narrow is mentioned.
#[test]
fn a_narrow_margin_warns() {
    let mut narrow = problem(rolling(0.002, 0.0, 0.0));
    let s = LayerStiffness { bedding: 1e13, coupling_along_x: 3.24e7, coupling_along_y: 3.24e7 };
    narrow.interface.elasticity = Arc::new(ElasticLayer::new(s, s, Some(1e-3)).unwrap());
    let warnings = solve(&narrow, &cells(16)).warnings;
    assert!(warnings[0].to_string().starts_with("margin"), "{warnings:?}");
    assert!(solve(&problem(rolling(0.002, 0.0, 0.0)), &cells(16)).warnings.is_empty());
}

/// From sticking to Coulomb: even a very stiff law converges at every step.
#[test]
fn stiff_contact_laws_converge() {
    for stiffness in [1e4, 1e6, 1e8, 1e10] {
        let mut stiff = problem(rolling(0.002, 0.001, 0.8));
        stiff.interface.contact_law = Incremental::new(stiffness).unwrap().into();
        let solution = solve(&stiff, &cells(16));
        let per_step = solution.work.newton_iterations as f64 / solution.work.steps as f64;
        assert!(per_step < 12.0, "k_c {stiffness}: {:?}", solution.work);
    }
}

/// At very high slip friction and temperature of a cell hang on each other so strongly that they
/// must be found together: the march ends where the steady driver does, and is as cold.
#[test]
fn very_high_slip_marches_to_the_steady_state() {
    let mut sliding = problem(rolling(0.5, 0.0, 0.0));
    sliding.kinematics.speed = 50.0;
    sliding.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    sliding.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    for across in [24, 25] {
        let steady = schlupf::solver::solve(&sliding, &cells(across), &unwatched).unwrap();
        let marched = solve(&sliding, &cells(across));
        assert!(marched.temperature.unwrap().max_rise < 700.0);
        assert!((marched.normalised.x - steady.normalised.x).abs() < 1e-5);
    }
}

/// A solution without a state is told from one at rest: nothing goes on from it.
#[test]
fn a_solution_without_a_state_is_refused() {
    let problem = problem(rolling(0.002, 0.0, 0.0));
    let options = Options { keeps_state: false, ..cells(12) };
    let without = schlupf::solver::solve(&problem, &options, &unwatched).unwrap();
    let with = schlupf::solver::solve(&problem, &cells(12), &unwatched).unwrap();
    assert_eq!(without.force, with.force);
    assert!(without.state.elements.is_empty());
    let error = march(&from_state(&problem, without.state), &cells(12), &unwatched).unwrap_err();
    assert!(matches!(error, schlupf::Error::State { error: StateError::NotKept {} }), "{error}");
}
