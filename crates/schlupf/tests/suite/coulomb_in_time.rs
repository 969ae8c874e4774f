//! Coulomb's law in time: marching, histories and shifts.

use std::sync::Arc;

use crate::common::transients::{
    self, LIMIT, LOAD, constant, contact, force_at, largest_difference, swinging,
};
use crate::common::{
    at_once, cells, follow, from_state, half_space, layer, problem, rolling, solve, solve_over,
};
use approx::assert_relative_eq;
use schlupf::bodies::Material;
use schlupf::elasticity::{Elasticity, HalfSpace, Rigid, Winkler};
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::{Constant, TemperatureLinear};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::Ellipse;
use schlupf::problem::History;
use schlupf::solver::reference::CattaneoMindlin;
use schlupf::solver::{march, shift};
use schlupf::{Error, Options, Problem, Solution, Status, Transient, unwatched};

fn reference() -> Problem {
    transients::reference(ContactLaw::Coulomb)
}

fn run(history: History, across: usize) -> Solution {
    solve_over(&reference(), history, &cells(across))
}

fn coulomb(elasticity: Arc<dyn Elasticity>, [xi, eta, spin]: [f64; 3]) -> Problem {
    problem(rolling(xi, eta, spin)).with_interface(|interface| {
        interface.elasticity = elasticity;
        interface.contact_law = ContactLaw::Coulomb;
    })
}

fn hot(mut problem: Problem) -> Problem {
    problem.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    problem.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    problem
}

fn assert_equal_forces(one: &Solution, two: &Solution, allowed: f64) {
    let (one, two) = (one.normalised, two.normalised);
    let moment = one.moment_z.unwrap() - two.moment_z.unwrap();
    let gap = (one.x - two.x).hypot(one.y - two.y).hypot(moment);
    assert!(gap < allowed, "{one:?} {two:?}");
}

/// Steady and marched solve the same discrete equations: they agree to ten times the tolerance, for
/// every elasticity, from nearly all stick to nearly all slip, and with heat.
#[test]
fn the_steady_state_is_the_end_of_marching() {
    let options = Options { tolerance: 1e-8, ..cells(16) };
    for elasticity in [half_space(), layer(), Arc::new(Winkler::new(2e13, 2e13).unwrap())] {
        for motion in [[5e-4, 0.0, 0.0], [3e-3, 0.0, 0.0], [1e-3, 1.5e-3, 0.3], [0.02, 0.0, 0.5]] {
            let both = coulomb(Arc::clone(&elasticity), motion);
            let (steady, marched) = (at_once(&both, &options), solve(&both, &options));
            assert_equal_forces(&steady, &marched, 10.0 * options.tolerance);
            assert_eq!(steady.fields.sliding, marched.fields.sliding);
            let products = of_a_step(&marched);
            assert!(products < 20.0, "{elasticity:?} {motion:?}: {products}");
        }
    }
    let both = hot(coulomb(half_space(), [0.01, 0.002, 0.3]));
    let (steady, marched) = (at_once(&both, &options), solve(&both, &options));
    assert_equal_forces(&steady, &marched, 10.0 * options.tolerance);
}

/// The state of the direct solver is one that marching goes on from without a change, slip
/// included.
#[test]
fn marching_goes_on_from_a_steady_state() {
    for motion in [[1e-3, 1.5e-3, 0.3], [0.01, 0.002, 0.3]] {
        let both = hot(coulomb(half_space(), motion));
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

/// Two spheres of steel but for Poisson's ratio of zero, where Cattaneo and Mindlin are exact,
/// under 50 kN and μ = 0.3.
fn spheres() -> (Problem, CattaneoMindlin) {
    const RADIUS: f64 = 5e-3;
    let material = Material { poisson_ratio: 0.0, ..Material::STEEL };
    let elasticity = Arc::new(HalfSpace::new(&material, &material).unwrap());
    let mut spheres = coulomb(elasticity, [0.0; 3]);
    spheres.normal = Arc::new(Ellipse::from_load(RADIUS, RADIUS, 50e3).unwrap());
    spheres.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    let exact = CattaneoMindlin {
        radius: RADIUS,
        load: 50e3,
        friction_coefficient: 0.3,
        shear_modulus: material.shear_modulus(),
        poisson_ratio: 0.0,
    };
    (spheres, exact)
}

/// Cattaneo 1938, Mindlin 1949: the force within 0.01 % on 100 cells and 0.15 % on 20, and μN
/// beyond full sliding, where a shift much farther is not at all harder.
#[test]
fn cattaneo_1938_mindlin_1949() {
    let (spheres, exact) = spheres();
    for (across, allowed) in [(20, 1.5e-3), (40, 3e-4), (100, 1e-4)] {
        for share in [0.2, 0.4, 0.6, 0.8, 0.9, 1.02, 10.0] {
            let by = share * exact.full_sliding_shift();
            let solution = shift(&spheres, [by, 0.0], &cells(across), &unwatched).unwrap();
            assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
            let expected = exact.force_over_limit(by).min(1.0);
            let off = -solution.normalised.x / expected - 1.0;
            println!("{across} cells, {share}: {off:+.6}, {:?}", solution.work.operator_products);
            assert!(off.abs() < allowed, "{across} {share}: {off}");
            assert!(solution.work.operator_products < 60.0, "{:?}", solution.work);
        }
    }
}

/// From rest (T1) and under a load that swings by 30 % over 36 mm (T4): CONTACT on 80 cells, which
/// is itself 0.003 to 0.004 of μN below the limit of fine grids: on 80 cells the differences are
/// 0.0036 and 0.0042.
#[test]
fn vollebregt_contact_transients() {
    for (across, allowed) in [(20, 4.1e-3), (40, 3.8e-3)] {
        let rest = run(constant(23.7e-3), across);
        let off = largest_difference(&rest, &contact("T1"));
        assert!(off < allowed, "T1 on {across}: {off}");
        let products = of_a_step(&rest);
        assert!(products < 18.0, "T1 on {across}: {products}");
    }
    let swung = run(swinging(0.3, 36e-3, 36e-3), 40);
    let off = largest_difference(&swung, &contact("T4"));
    assert!(off < 4.3e-3, "T4: {off}");
    let products = of_a_step(&swung);
    assert!(products < 24.0, "T4: {products}");
}

/// To the steady state on the half-space, and under a load that swings by a half.
#[test]
fn time_steps_take_few_products() {
    for across in [20, 40] {
        let steady = coulomb(half_space(), [1e-3, 0.0, 0.0]);
        let products = of_a_step(&solve(&steady, &cells(across)));
        assert!(products < 9.0, "{across}: {products}");
        let products = of_a_step(&run(swinging(0.5, 36e-3, 36e-3), across));
        assert!(products < 24.0, "swinging load, {across}: {products}");
    }
}

/// Products of a time step.
fn of_a_step(marched: &Solution) -> f64 {
    let products = marched.work.operator_products / marched.work.steps as f64;
    println!("{products:.1} products");
    products
}

/// While the force builds up from rest, it is within 0.1 % of μN on 20 cells and converges at an
/// order of at least 1.4, which the material in contact at the start, with a single earlier place,
/// limits; the differences of grids twice as fine, at each mm.
#[test]
#[ignore = "long: cargo xtask long"]
fn transients_converge() {
    let [coarse, middle, fine] = [20, 40, 80].map(|across| run(constant(12e-3), across));
    let largest = |one: &Solution, other: &Solution| {
        let at = (1..=12).map(|mm| 1e-3 * f64::from(mm));
        at.map(|s| (force_at(one, s) - force_at(other, s)).abs()).fold(0.0, f64::max)
    };
    let (first, second) = (largest(&coarse, &middle), largest(&middle, &fine));
    assert!(first < 1e-3 && (first / second).log2() > 1.4, "{first} {second}");
}

/// The Winkler bedding c = 2e13 N/m³ under a load that swings by 70 % over 12 mm, so that edges
/// move about as fast as the wheel rolls: q ← min(q + cξ ds, μp) for every point of the material,
/// summed over 1600 × 200 points in an independent computation (as in `transient.rs`).
#[test]
fn winkler_bedding_under_a_load_that_changes_fast() {
    let exact = [0.38131, 0.50067, 0.24630, 0.40144, 0.62465, 0.53773, 0.24630, 0.40144];
    let largest = |across: usize| {
        let mut bedded = reference();
        bedded.interface.elasticity = Arc::new(Winkler::new(2e13, 2e13).unwrap());
        let solution = solve_over(&bedded, swinging(0.7, 12e-3, 24e-3), &cells(across));
        let at = (1..=8).map(|k| 3e-3 * f64::from(k)).zip(exact);
        at.map(|(s, force)| (force_at(&solution, s) - force).abs()).fold(0.0, f64::max)
    };
    let [coarse, fine] = [20, 40].map(largest);
    assert!(coarse < 0.012 && fine < 0.6 * coarse, "{coarse} {fine}");
}

/// A load that grows from 24 to 136 kN within 3 mm from rest, so that the edge runs as fast as the
/// wheel rolls: root mean square of the differences to grids twice as fine at each quarter mm; they
/// fall at first order.
#[test]
fn half_space_under_a_load_that_rises_at_rolling_speed() {
    let ramp = || History {
        time: vec![0.0, 3e-3, 4e-3],
        load: Some(vec![24e3, 136e3, 136e3]),
        ..History::default()
    };
    let [coarse, middle, fine] = [20, 40, 80].map(|across| run(ramp(), across));
    let off = |one: &Solution, other: &Solution| {
        let at = (1..=16).map(|quarter| 0.25e-3 * f64::from(quarter));
        let squares = at.map(|s| (force_at(one, s) - force_at(other, s)).powi(2));
        (squares.sum::<f64>() / 16.0).sqrt()
    };
    let (first, second) = (off(&coarse, &middle), off(&middle, &fine));
    assert!(first < 2e-3 && second < 0.6 * first, "{first} {second}");
}

/// Cattaneo (1938) and Mindlin (1949), then rolling: after a shift of 0.015 mm CONTACT has Fx =
/// −0.6530 μN; the force goes over into that of rolling without a jump and ends in the steady
/// state.
#[test]
fn a_history_starts_with_a_shift() {
    let history = History { shift_x: Some(vec![0.015e-3, 0.0]), ..constant(60e-3) };
    let solution = run(history, 40);
    let force = |k: usize| -solution.history[k].force.x / LIMIT;
    assert!((force(0) - 0.6530).abs() < 1e-3, "{}", force(0));
    assert!((force(1) - force(0)).abs() < 0.05, "{} {}", force(0), force(1));
    let steady = at_once(&reference(), &cells(40));
    assert_relative_eq!(solution.normalised.x, steady.normalised.x, epsilon = 2e-4);
}

/// A patch that shrinks faster than the wheel rolls and grows again converges at every step and
/// carries no more than friction allows.
#[test]
fn edges_faster_than_the_wheel() {
    let history = History {
        time: vec![0.0, 2e-3, 3e-3, 4e-3, 10e-3],
        load: Some(vec![LOAD, LOAD, 0.1 * LOAD, 2.0 * LOAD, 2.0 * LOAD]),
        ..History::default()
    };
    let solution = run(history, 30);
    let fields = &solution.fields;
    for k in 0..fields.len() {
        let traction = fields.traction_x[k].hypot(fields.traction_y[k]);
        assert!(traction <= 0.3 * fields.pressure[k] * (1.0 + 1e-5));
    }
}

/// Nothing but elasticity determines the traction where bodies stick, so rigid ones are refused.
#[test]
fn rigid_bodies_are_refused() {
    let rigid = coulomb(Arc::new(Rigid), [1e-3, 0.0, 0.0]);
    let marched = march(&Transient::to_steady_state(&rigid), &cells(8), &unwatched);
    assert_eq!(marched.unwrap_err(), Error::CoulombOfRigidBodies {});
}
