//! Two bodies at rest that are pressed together and shifted tangentially.

use crate::common::{cells, follow, from_state, problem, rolling};
use approx::assert_relative_eq;
use schlupf::bodies::Material;
use schlupf::elasticity::{HalfSpace, Rigid, Winkler};
use schlupf::interface::Incremental;
use schlupf::interface::friction::{Constant, TemperatureLinear};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::Ellipse;
use schlupf::solution::{Power, TGamma};
use schlupf::solver::reference::CattaneoMindlin;
use schlupf::solver::shift;
use schlupf::{Options, Problem, Solution, Status, solver, unwatched};
use std::f64::consts::PI;
use std::sync::Arc;

const RADIUS: f64 = 5e-3;

/// Two spheres of steel but for Poisson's ratio, under 50 kN and μ = 0.3.
fn exact(poisson_ratio: f64) -> CattaneoMindlin {
    let material = Material { poisson_ratio, ..Material::STEEL };
    CattaneoMindlin {
        radius: RADIUS,
        load: 50e3,
        friction_coefficient: 0.3,
        shear_modulus: material.shear_modulus(),
        poisson_ratio,
    }
}

/// The same as a problem, with nearly rigid bristles.
fn spheres(poisson_ratio: f64) -> Problem {
    let material = Material { poisson_ratio, ..Material::STEEL };
    let mut spheres = problem(rolling(0.0, 0.0, 0.0));
    spheres.normal = Arc::new(Ellipse::from_load(RADIUS, RADIUS, 50e3).unwrap());
    spheres.interface.elasticity = Arc::new(HalfSpace::new(&material, &material).unwrap());
    spheres.interface.contact_law = Incremental::new(1e9).unwrap().into();
    spheres.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    spheres
}

fn shifted(problem: &Problem, by: [f64; 2], options: &Options) -> Solution {
    let solution = shift(problem, by, options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert!(solution.residual <= options.tolerance);
    assert!(solution.work.newton_iterations <= 30, "{:?}", solution.work);
    solution
}

/// Stick radius c from the traction in the cells that stick, where Cattaneo 1938 has
/// (1 − t/(μ p))² (a² − r²) = c² − r².
fn stick_radius(solution: &Solution) -> f64 {
    let fields = &solution.fields;
    let sticking = (0..fields.len()).filter(|k| !fields.sliding[*k]);
    let squares: Vec<f64> = sticking
        .map(|k| {
            let square = fields.x[k].powi(2) + fields.y[k].powi(2);
            let rest = 1.0 + fields.traction_x[k] / (0.3 * fields.pressure[k]);
            square + rest.powi(2) * (RADIUS * RADIUS - square)
        })
        .collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Cattaneo 1938, Mindlin 1949, where they are exact, ν = 0: the force within 0.1 %, the stick
/// radius within 1 % from the area of the cells below 0.95 μp and within 0.2 % from their traction,
/// no traction across.
#[test]
fn cattaneo_1938_mindlin_1949() {
    let (spheres, exact) = (spheres(0.0), exact(0.0));
    for share in [0.2, 0.4, 0.6, 0.8, 0.9] {
        let by = share * exact.full_sliding_shift();
        let solution = shifted(&spheres, [by, 0.0], &cells(100));
        let expected = exact.force_over_limit(by);
        let radius = exact.stick_radius(expected);
        let force = -solution.normalised.x / expected - 1.0;
        let by_area = (solution.area.stick.unwrap() / PI).sqrt() / radius - 1.0;
        let by_traction = stick_radius(&solution) / radius - 1.0;
        println!("{share}: force {force:+.5}, stick radius {by_area:+.5}, {by_traction:+.5}");
        assert!(force.abs() < 1e-3, "{share}: {force}");
        assert!(by_area.abs() < 0.01, "{share}: {by_area}");
        assert!(by_traction.abs() < 2e-3, "{share}: {by_traction}");
        let across = solution.fields.traction_y.iter().fold(0.0, |most: f64, t| most.max(t.abs()));
        assert!(across < 1e-4 * 0.3 * solution.normal.peak_pressure, "{across}");
    }
}

/// The bodies stick where the elastic displacement undoes the shift; without rolling there is no
/// power.
#[test]
fn cattaneo_1938_displacement_and_power() {
    let by = 0.5 * exact(0.0).full_sliding_shift();
    let solution = shifted(&spheres(0.0), [by, 0.0], &cells(40));
    let fields = &solution.fields;
    let middle = (0..fields.len()).filter(|k| fields.x[*k].hypot(fields.y[*k]) < 0.5 * RADIUS);
    for k in middle {
        assert!(!fields.sliding[k]);
        assert_relative_eq!(fields.displacement_x[k], -by, max_relative = 2e-3);
    }
    let power = Power { exchanged: Some(0.0), ..Power::default() };
    let t_gamma = TGamma { without_spin: 0.0, with_spin: Some(0.0), rows: [0.0; 2] };
    assert_eq!((solution.power, solution.t_gamma), (Some(power), t_gamma));
    // Without heat nothing is known of temperatures.
    assert_eq!((solution.kinematics.speed, solution.temperature), (0.0, None));
    let slips = fields.slip_x.iter().chain(&fields.slip_y).chain(&fields.friction_power);
    assert!(slips.copied().all(|slip| slip == 0.0));
}

/// Mindlin 1949 for steel, where the small traction across is neglected: within 0.5 %, in any
/// direction.
#[test]
fn mindlin_1949_any_direction() {
    let (spheres, exact) = (spheres(0.28), exact(0.28));
    for (share, angle) in [(0.05, 0.0_f64), (0.3, 0.6), (0.5, 1.2), (0.7, -2.0), (0.9, 3.0)] {
        let by = share * exact.full_sliding_shift();
        let direction = [angle.cos(), angle.sin()];
        let force = shifted(&spheres, direction.map(|d| by * d), &cells(40)).normalised;
        let expected = exact.force_over_limit(by);
        println!("{share}: {:+.5}", force.x.hypot(force.y) / expected - 1.0);
        assert_relative_eq!(force.x, -expected * direction[0], epsilon = 5e-3 * expected);
        assert_relative_eq!(force.y, -expected * direction[1], epsilon = 5e-3 * expected);
    }
}

/// Beyond full sliding the force is μN and stays there.
#[test]
fn coulomb_beyond_full_sliding() {
    let full = exact(0.0).full_sliding_shift();
    for [x, y] in [[1.02, 0.0], [1.5, 0.0], [0.0, -3.0], [30.0, 40.0]] {
        let force = shifted(&spheres(0.0), [x * full, y * full], &cells(20)).normalised;
        let length = f64::hypot(x, y);
        assert_relative_eq!(force.x, -x / length, epsilon = 1e-6);
        assert_relative_eq!(force.y, -y / length, epsilon = 1e-6);
    }
}

/// Neuhaus and Sextro 2014, Eq. (8): between rigid bodies the force follows the bristles,
/// F/μN = 1 − exp(−k_c D).
#[test]
fn neuhaus_sextro_2014_rigid_bodies() {
    let mut rigid = problem(rolling(0.0, 0.0, 0.0));
    rigid.interface.elasticity = Arc::new(Rigid);
    for by in [1e-9, 1e-7, 1e-6] {
        let force = shifted(&rigid, [0.0, by], &cells(12)).normalised;
        assert_relative_eq!(force.y, (-5e6 * by).exp_m1(), epsilon = 1e-6);
        assert_eq!(force.x.abs(), 0.0);
    }
}

/// Winkler bedding c and Coulomb friction: each point carries the lesser of c D and μ p, so with
/// s = c D/(μ p0) the force is F/μN = (3/2) s − ½ s³; within 0.5 % of μN.
#[test]
fn winkler_bedding_with_coulomb_friction() {
    let mut bedded = problem(rolling(0.0, 0.0, 0.0));
    bedded.interface.elasticity = Arc::new(Winkler::new(2e13, 2e13).unwrap());
    bedded.interface.contact_law = Incremental::new(1e9).unwrap().into();
    for s in [0.1, 0.5, 0.9] {
        let force = shifted(&bedded, [-s * 0.4 * 1e9 / 2e13, 0.0], &cells(40)).normalised.x;
        assert_relative_eq!(force, 1.5 * s - 0.5 * s * s * s, epsilon = 5e-3);
    }
}

/// Rolling goes on from a shifted state, and forgets it: it ends in the steady state.
#[test]
fn rolling_goes_on_from_a_shift() {
    let problem = problem(rolling(0.001, 0.0, 0.0));
    let shifted = shifted(&problem, [0.0, 2e-5], &cells(16));
    let steady = solver::solve(&problem, &cells(16), &unwatched).unwrap().normalised;
    let rolled = follow(&from_state(&problem, shifted.state.clone()), &cells(16));
    let first = &rolled.history[0].force;
    assert!(first.y.abs() > 0.7 * shifted.force.y.abs(), "{first:?} {:?}", shifted.force);
    assert_relative_eq!(rolled.normalised.x, steady.x, epsilon = 1e-4);
    assert_relative_eq!(rolled.normalised.y, steady.y, epsilon = 1e-4);
}

/// Friction is that of the temperature with which the bodies meet: rolling and creepages play no
/// part.
#[test]
fn friction_of_bodies_that_meet_warm() {
    let mut warm = spheres(0.0);
    warm.interface.friction.law = Arc::new(TemperatureLinear::new(0.3, 700.0, 0.0).unwrap());
    warm.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    warm.interface.wheel.bulk_temperature = 160.0;
    let full = exact(0.0).full_sliding_shift();
    for kinematics in [rolling(0.0, 0.0, 0.0), rolling(0.5, 0.1, 1.0)] {
        warm.kinematics = kinematics;
        let solution = shifted(&warm, [2.0 * full, 0.0], &cells(12));
        // Half of 140 K over the reference.
        assert_relative_eq!(solution.normalised.x, -0.9, max_relative = 1e-12);
    }
}

#[test]
fn what_is_no_shift_from_rest_is_refused() {
    let options = cells(8);
    let rest = problem(rolling(0.001, 0.0, 0.0));
    let refuse =
        |problem: &Problem, by: [f64; 2]| shift(problem, by, &options, &unwatched).unwrap_err();
    assert!(refuse(&rest, [0.0, f64::NAN]).to_string().contains("shift_y_history must be finite"));
}

/// Two Newton steps are not enough, and the solution says so.
#[test]
fn an_equilibrium_that_is_not_reached_is_not_converged() {
    let options = Options { max_iterations: 2, ..cells(16) };
    let by = 0.5 * exact(0.0).full_sliding_shift();
    let solution = shift(&spheres(0.0), [by, 0.0], &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::NotConverged);
    assert!(solution.residual > options.tolerance);
    assert!(solution.warnings[0].to_string().starts_with("after 2 Newton steps"));
}
