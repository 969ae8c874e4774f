//! The steady driver: the whole steady state at once.

use crate::common::{self, at_once, cells, from_state, half_space, problem, rolling, solve};
use approx::assert_relative_eq;
use schlupf::elasticity::{Elasticity, Rigid, Winkler};
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental, TotalDisplacement};
use schlupf::normal::{PressureTable, Tabulated};
use schlupf::solution::Resultant;
use schlupf::solver::{SteadySolver, march};
use schlupf::{Options, Problem, Solver, Status, unwatched};
use std::sync::Arc;

/// Steady and marched solve the same discrete equations: they agree to ten times the tolerance, for
/// every elasticity and both contact laws, with spin.
#[test]
fn the_steady_state_is_the_end_of_marching() {
    let elasticities: [Arc<dyn Elasticity>; 4] = [
        common::layer(),
        half_space(),
        Arc::new(Winkler::new(2e13, 2e13).unwrap()),
        Arc::new(Rigid),
    ];
    let laws: [ContactLaw; 2] =
        [Incremental::new(5e6).unwrap().into(), TotalDisplacement::new(5e6).unwrap().into()];
    for elasticity in &elasticities {
        for law in &laws {
            let mut both = problem(rolling(0.001, 0.0015, 0.3));
            both.interface.elasticity = Arc::clone(elasticity);
            both.interface.contact_law = *law;
            let options = Options { tolerance: 1e-8, ..cells(16) };
            let (steady, marched) = (at_once(&both, &options), solve(&both, &options));
            let (one, two) = (steady.normalised, marched.normalised);
            let differs = (one.x - two.x)
                .hypot(one.y - two.y)
                .hypot(one.moment_z.unwrap() - two.moment_z.unwrap());
            assert!(differs < 10.0 * options.tolerance, "{elasticity:?} {law:?}: {differs:e}");
            assert_eq!(steady.fields.sliding, marched.fields.sliding);
        }
    }
}

/// The same with friction that falls with the temperature.
#[test]
fn the_hot_steady_state_is_the_end_of_marching() {
    let mut hot = problem(rolling(0.02, 0.003, 0.3));
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    let options = Options { tolerance: 1e-8, ..cells(16) };
    let (steady, marched) = (at_once(&hot, &options), solve(&hot, &options));
    assert_relative_eq!(steady.force.x, marched.force.x, max_relative = 1e-6);
    assert_relative_eq!(steady.force.y, marched.force.y, max_relative = 1e-6);
    let (one, two) = (steady.temperature.unwrap().max_rise, marched.temperature.unwrap().max_rise);
    assert_relative_eq!(one, two, max_relative = 1e-6);
    assert_relative_eq!(
        steady.power.unwrap().friction,
        steady.power.unwrap().creep,
        max_relative = 1e-6
    );
    assert!(steady.work.outer_iterations < 25, "{:?}", steady.work);
}

/// Motions that a creep force law is made of.
const MOTIONS: [(f64, f64, f64); 7] = [
    (0.0005, 0.0, 0.0),
    (0.002, 0.0, 0.0),
    (0.0, 0.001, 0.0),
    (0.002, 0.002, 0.0),
    (0.0, 0.0, 1.0),
    (0.0, 0.001, 0.4),
    (0.003, 0.001, 0.2),
];

/// Products with A of a cold solution do not depend on the grid.
#[test]
#[ignore = "long: cargo xtask long"]
fn cold_work_does_not_grow_with_the_grid() {
    for (elasticity, allowed) in [(common::layer(), 40.0), (half_space(), 30.0)] {
        for cells_across in [20, 40, 80, 160] {
            for (xi, eta, spin) in MOTIONS {
                let mut cold = problem(rolling(xi, eta, spin));
                cold.interface.elasticity = Arc::clone(&elasticity);
                let work = at_once(&cold, &cells(cells_across)).work;
                assert!(work.operator_products < allowed, "{elasticity:?} {work:?}");
                // Those on the coarser grids count too.
                assert!(work.newton_iterations <= 20, "{work:?}");
            }
        }
    }
}

/// Heat that lowers friction costs no more products: it is part of the same equilibrium.
#[test]
fn heat_costs_no_products() {
    for (xi, eta, spin) in MOTIONS {
        let mut hot = problem(rolling(xi, eta, spin));
        hot.interface.elasticity = half_space();
        hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
        hot.interface.heat =
            Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
        let work = at_once(&hot, &cells(24)).work;
        assert!(work.operator_products < 30.0, "{work:?}");
    }
}

/// Mean and largest number of products for a point of a creep curve in a direction (ξ, η, φ).
fn along_a_curve(base: &Problem, options: &Options, direction: [f64; 3]) -> [f64; 2] {
    const POINTS: u32 = 30;
    let mut solver = SteadySolver::new(options);
    let (mut total, mut largest) = (0.0, 0.0_f64);
    for point in 1..=POINTS {
        let size = 0.008 * f64::from(point).powf(1.5) / f64::from(POINTS).powf(1.5);
        let [xi, eta, spin] = direction.map(|d| d * size);
        let problem = Problem { kinematics: rolling(xi, eta, spin), ..base.clone() };
        let solution = solver.solve(&problem, &unwatched).unwrap();
        assert_eq!(solution.work.steps, 0, "marched");
        total += solution.work.operator_products;
        largest = largest.max(solution.work.operator_products);
    }
    [total / f64::from(POINTS), largest]
}

/// Points of a creep curve start from the points before.
#[test]
#[ignore = "long: cargo xtask long"]
fn warm_work_along_a_creep_curve() {
    let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 200.0], [0.8, 0.4, 50.0]];
    for (elasticity, allowed) in [(common::layer(), [25.0, 34.0]), (half_space(), [18.0, 27.0])] {
        let mut base = problem(rolling(0.0, 0.0, 0.0));
        base.interface.elasticity = elasticity;
        for cells_across in [20, 40, 80] {
            let counts = directions.map(|d| along_a_curve(&base, &cells(cells_across), d));
            println!("{:?} {cells_across}: {counts:.1?}", base.interface.elasticity);
            for [mean, largest] in counts {
                assert!(mean < allowed[0] && largest < allowed[1], "{mean} {largest}");
            }
        }
    }
}

/// Products of four solutions by one solver, each with a motion larger by a part of the first one.
fn of_four_solutions(base: &Problem, options: &Options, growth: f64) -> [f64; 4] {
    let mut solver = SteadySolver::new(options);
    [0.0, 1.0, 2.0, 3.0].map(|point| {
        let part = 1.0 + growth * point;
        let [xi, eta, spin] =
            [base.kinematics.creepage_x, base.kinematics.creepage_y, base.kinematics.spin]
                .map(|motion| part * motion);
        let moved = Problem { kinematics: rolling(xi, eta, spin), ..base.clone() };
        let solution = solver.solve(&moved, &unwatched).unwrap();
        assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
        solution.work.operator_products
    })
}

/// The same state again costs next to nothing, also the second time: what a cold solution leaves
/// undone on the coarse grids is made up for first. Nor does it count as a change where the motion
/// hardly changes.
#[test]
fn the_second_solution_is_as_warm_as_the_third() {
    let bristles = |stiffness: f64| -> ContactLaw { Incremental::new(stiffness).unwrap().into() };
    let laws: [ContactLaw; 3] = [bristles(5e6), bristles(1e8), ContactLaw::Coulomb];
    for (elasticity, laws) in [(common::layer(), &laws[..2]), (half_space(), &laws[..])] {
        for (law, across) in laws.iter().flat_map(|law| [(law, 20), (law, 40)]) {
            for (xi, eta, spin) in MOTIONS {
                let base = problem(rolling(xi, eta, spin)).with_interface(|interface| {
                    interface.elasticity = Arc::clone(&elasticity);
                    interface.contact_law = *law;
                });
                let [first, second, third, fourth] = of_four_solutions(&base, &cells(across), 0.0);
                assert!(second < 0.25 * first, "{law:?} {across}: {second} of {first}");
                assert!(third < 2.5 && fourth < 2.5, "{law:?} {across}: {third} {fourth}");
                let near = of_four_solutions(&base, &cells(across), 1e-4);
                assert!(near[1] < 0.75 * first && near[3] < 0.75 * first, "{law:?} {near:?}");
            }
        }
    }
}

/// What a solver has solved before changes its results by no more than the tolerance.
#[test]
fn a_warm_start_leaves_no_trace() {
    let options = cells(20);
    let mut solver = SteadySolver::new(&options);
    let base = problem(rolling(0.001, 0.0, 0.0));
    for (xi, eta, spin) in MOTIONS {
        let now = Problem { kinematics: rolling(xi, eta, spin), ..base.clone() };
        let warm = solver.solve(&now, &unwatched).unwrap().normalised;
        let cold = at_once(&now, &options).normalised;
        let differs = (warm.x - cold.x)
            .hypot(warm.y - cold.y)
            .hypot(warm.moment_z.unwrap() - cold.moment_z.unwrap());
        assert!(differs < 4.0 * options.tolerance, "{differs:e}");
    }
}

/// The state of the steady driver is one that marching goes on from without a change.
#[test]
fn marching_goes_on_from_a_steady_state() {
    let mut hot = problem(rolling(0.01, 0.002, 0.3));
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    let options = Options { tolerance: 1e-8, ..cells(16) };
    let steady = at_once(&hot, &options);
    let transient = from_state(&hot, steady.state.clone());
    let on = march(&transient, &Options { tolerance: 1e-6, ..options }, &unwatched).unwrap();
    for instant in &on.history {
        assert_relative_eq!(instant.force.x, steady.force.x, max_relative = 1e-6);
    }
}

/// Kalker's linear regime: as ξ → 0 all sticks. The force over ξ settles with the grid, hardly
/// depends on a stiff contact law, and never drives while braking.
#[test]
fn kalker_1967_full_stick_is_well_posed() {
    for elasticity in [common::layer(), half_space()] {
        let slope = |stiffness: f64, cells_across: usize| {
            let mut sticking = problem(rolling(3e-6, 0.0, 0.0));
            sticking.interface.elasticity = Arc::clone(&elasticity);
            sticking.interface.contact_law = Incremental::new(stiffness).unwrap().into();
            let solution = at_once(&sticking, &cells(cells_across));
            assert!(solution.power.unwrap().friction > 0.0);
            -solution.normalised.x / 3e-6
        };
        let stiffest = slope(1e11, 32);
        for stiffness in [1e8, 1e9, 1e10, 1e11] {
            let fine = slope(stiffness, 32);
            // k_c = 1e8/m gives way by some 5 % more than one without bristles.
            assert!((fine / stiffest - 1.0).abs() < 0.07, "{stiffness:e}: {fine} {stiffest}");
            for (cells_across, allowed) in [(8, 0.1), (12, 0.05), (16, 0.05), (24, 0.02)] {
                let error = slope(stiffness, cells_across) / fine - 1.0;
                assert!(error.abs() < allowed, "{stiffness:e} {cells_across}: {error}");
            }
        }
    }
}

/// ∫ q dA = −v0 (ξFx + ηFy + φMz), also with heat, with the paper's contact law, without coupling,
/// on the half-space, and with pressure from a table.
#[test]
fn the_power_balance_always_closes() {
    let base = problem(rolling(0.004, 0.002, 0.5));
    let mut hot = base.clone();
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    let mut total = base.clone();
    total.interface.contact_law = TotalDisplacement::new(5e6).unwrap().into();
    let mut uncoupled = base.clone();
    uncoupled.interface.elasticity = Arc::new(Winkler::new(2e13, 2e13).unwrap());
    let mut half = base.clone();
    half.interface.elasticity = half_space();
    let mut table = base.clone();
    let axis: Vec<f64> = (-10..=10).map(|k| 0.6e-3 * f64::from(k)).collect();
    let value = |x: f64, y: f64| 1e9 * (1.0 - (x / 5e-3).powi(4) - (y / 5.5e-3).powi(2)).max(0.0);
    let pressure = axis.iter().flat_map(|y| axis.iter().map(|x| value(*x, *y))).collect();
    let pressure = PressureTable::new(&axis, &axis, pressure).unwrap();
    table.normal = Arc::new(Tabulated::new(pressure, None).unwrap());
    for case in [base, hot, total, uncoupled, half, table] {
        let power = at_once(&case, &cells(20)).power.unwrap();
        assert_relative_eq!(power.friction, power.creep, max_relative = 1e-5);
    }
}

/// Friction that vanishes within a few hundred kelvin, at very high slip: temperature and friction
/// of each cell are found together, so the loop around them converges.
#[test]
fn high_slip_converges() {
    for (speed, creepage) in [(16.7, 0.5), (55.0, 0.3), (60.0, 0.9)] {
        let mut hot = problem(rolling(creepage, 0.0, 0.0));
        hot.kinematics.speed = speed;
        hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
        hot.interface.heat =
            Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
        let solution = at_once(&hot, &cells(20));
        assert!(solution.temperature.unwrap().max_rise < 700.0);
        assert!(solution.work.outer_iterations < 60, "{:?}", solution.work);
    }
}

/// Beddings that are up to a thousand times stiffer along than across are solved cell by cell,
/// exactly: no Newton step is left. Forces are extrapolated from two grids there, too.
#[test]
fn beddings_of_unequal_stiffness_are_solved_cell_by_cell() {
    let bristles = Incremental::new(1e8).unwrap().into();
    for law in [ContactLaw::Coulomb, bristles, TotalDisplacement::new(1e8).unwrap().into()] {
        for (along, across) in [(1e15, 1e12), (4e13, 1e13)] {
            let mut bedded = problem(rolling(1e-4, 1e-4, 0.3));
            bedded.interface.elasticity = Arc::new(Winkler::new(along, across).unwrap());
            bedded.interface.contact_law = law;
            let options = Options { extrapolate: true, tolerance: 1e-10, ..cells(40) };
            let solution = at_once(&bedded, &options);
            assert_eq!(solution.work.newton_iterations, 0, "{:?}", solution.work);
            let finer = at_once(&bedded, &cells(160)).normalised;
            let off = |force: Resultant| (force.x - finer.x).hypot(force.y - finer.y);
            let extrapolated = off(solution.extrapolation.unwrap().normalised);
            let found = off(solution.normalised);
            // On the coarser grid the stiff direction slides within a cell.
            assert!(found < 1e-3 && extrapolated < 5e-3, "{found} {extrapolated}");
        }
    }
}
