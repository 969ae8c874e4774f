//! Heat and friction at high slip.

use std::path::Path;
use std::sync::Arc;

use crate::common::{half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::elasticity::Rigid;
use schlupf::interface::Incremental;
use schlupf::interface::friction::{
    Constant, FrictionLaw, TemperatureLinear, TemperaturePiecewiseLinear,
};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::Ellipse;
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solution, Solver, Status, unwatched};

/// Uniform slip of 1 m/s at 30 m/s of rigid bodies, a = 5.88 mm, b = 10.54 mm, N = 100 kN;
/// temperatures count from 0 degC.
fn uniform_slip(law: Arc<dyn FrictionLaw>, reference: f64) -> Problem {
    let mut slide = problem(rolling(1.0 / 30.0, 0.0, 0.0));
    slide.normal = Arc::new(Ellipse::from_load(5.88e-3, 10.54e-3, 100e3).unwrap());
    slide.interface.elasticity = Arc::new(Rigid);
    slide.interface.contact_law = Incremental::new(1e9).unwrap().into();
    slide.interface.friction.law = law;
    slide.interface.friction.reference_temperature = reference;
    slide.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    slide.interface.wheel.bulk_temperature = 0.0;
    slide.interface.rail.bulk_temperature = 0.0;
    slide
}

fn solve(problem: &Problem, cells_x: usize) -> Solution {
    let options = Options { cells_x, cells_y: 61, ..Options::default() };
    let solution = schlupf::solver::solve(problem, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0, "marched");
    solution
}

/// μ = 0.3 − 0.18 T/400 K: T_max = 126.84 K and Fx = 0.8796 μ0 N on any grid.
#[test]
fn linear_friction_under_uniform_slip() {
    let law = Arc::new(TemperatureLinear::new(0.3, 0.3 * 400.0 / 0.18, 0.12).unwrap());
    for cells_x in [59, 118, 236, 472] {
        let solution = solve(&uniform_slip(law.clone(), 0.0), cells_x);
        println!("{cells_x}: {} {}", solution.temperature.unwrap().max_rise, solution.normalised.x);
        assert_relative_eq!(solution.temperature.unwrap().max_rise, 126.84, epsilon = 0.15);
        assert_relative_eq!(solution.normalised.x, -0.8796, epsilon = 5e-4);
    }
}

/// 0.30 → 0.12 between 100 and 130 degC, where iterations between heat and traction cycle for ever:
/// T_max = 117.34 degC and Fx = 0.901 μ0 N on any grid.
#[test]
fn steeply_falling_friction_under_uniform_slip() {
    let law = Arc::new(TemperaturePiecewiseLinear::new(0.3, 0.12, 30.0).unwrap());
    for cells_x in [20, 59, 118, 236] {
        let solution = solve(&uniform_slip(law.clone(), 100.0), cells_x);
        println!("{cells_x}: {} {}", solution.temperature.unwrap().max_rise, solution.normalised.x);
        assert_relative_eq!(solution.temperature.unwrap().max_wheel, 117.34, epsilon = 0.1);
        assert_relative_eq!(solution.normalised.x, -0.901, epsilon = 1e-3);
        assert!(solution.work.newton_iterations < 60, "{:?}", solution.work);
    }
}

/// Curves of `data/eurosprinter.csv`: friction, and its points (ξ, force in N).
fn curves() -> Vec<(String, Vec<(f64, f64)>)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/eurosprinter.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let mut curves: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for record in reader.records() {
        let record = record.unwrap();
        let point = (record[1].parse().unwrap(), record[2].parse().unwrap());
        match curves.last_mut() {
            Some((friction, points)) if friction == &record[0] => points.push(point),
            _ => curves.push((record[0].to_owned(), vec![point])),
        }
    }
    curves
}

/// A locomotive wheel, R = 625 mm, N = 106.7 kN, a/b = 0.5, at 10 m/s.
fn locomotive(law: Arc<dyn FrictionLaw>) -> Problem {
    let mut wheel = problem(rolling(0.0, 0.0, 0.0));
    wheel.kinematics.speed = 10.0;
    wheel.normal = Arc::new(Ellipse::from_load(6.304e-3, 12.61e-3, 106.7e3).unwrap());
    wheel.interface.elasticity = half_space();
    wheel.interface.contact_law = Incremental::new(1e8).unwrap().into();
    wheel.interface.friction.law = law;
    wheel.interface.friction.reference_temperature = 0.0;
    wheel.interface.wheel.bulk_temperature = 0.0;
    wheel.interface.rail.bulk_temperature = 0.0;
    wheel.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    wheel
}

/// Vollebregt 2022, Eurosprinter: creep forces with constant, falling and rising friction within
/// 1.5 % of N. (Its temperatures, and so its changes of friction, are some 10 % too large.)
#[test]
fn vollebregt_2022_eurosprinter() {
    for (friction, points) in curves() {
        let law: Arc<dyn FrictionLaw> = match friction.as_str() {
            "-0.19 per 1200 C" => {
                Arc::new(TemperaturePiecewiseLinear::new(0.33, 0.14, 1200.0).unwrap())
            }
            "-0.19 per 400 C" => {
                Arc::new(TemperaturePiecewiseLinear::new(0.33, 0.14, 400.0).unwrap())
            }
            "+0.19 per 1200 C" => {
                Arc::new(TemperaturePiecewiseLinear::new(0.33, 0.52, 1200.0).unwrap())
            }
            constant => {
                assert!(constant.starts_with("constant 0.33"), "{constant}");
                Arc::new(Constant::new(0.33).unwrap())
            }
        };
        let mut wheel = locomotive(law);
        let options = Options { cells_x: 32, cells_y: 32, ..Options::default() };
        let mut solver = SteadySolver::new(&options);
        let mut largest = 0.0_f64;
        for (creepage, force) in points {
            wheel.kinematics.creepage_x = creepage;
            let solution = solver.solve(&wheel, &unwatched).unwrap();
            assert_eq!(solution.status, Status::Converged);
            largest = largest.max((-solution.force.x - force).abs() / 106.7e3);
        }
        println!("{friction}: {largest:.4}");
        assert!(largest < 0.015, "{friction}: {largest}");
    }
}

/// μ0 = 0.33, T_E = 2084 K: at 10 % Fx = 32.8 kN, and falling beyond.
#[test]
fn eurosprinter_falls_beyond_its_maximum() {
    let mut wheel = locomotive(Arc::new(TemperatureLinear::new(0.33, 2084.0, 0.0).unwrap()));
    let options = Options { cells_x: 32, cells_y: 32, ..Options::default() };
    let forces = [0.1, 0.15, 0.2].map(|creepage| {
        wheel.kinematics.creepage_x = creepage;
        -schlupf::solver::solve(&wheel, &options, &unwatched).unwrap().force.x
    });
    println!("{forces:?}");
    assert_relative_eq!(forces[0], 32.8e3, epsilon = 300.0);
    assert!(forces[1] < forces[0] && forces[2] < forces[1]);
}
