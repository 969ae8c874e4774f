//! Creepages and moment at the origin of the file of the normal contact, in place of the middle of
//! the patch.

use crate::common::{self, cells, half_space, problem, rolling, solve_over};
use approx::assert_relative_eq;
use schlupf::analysis::bulk_temperature::{Cooling, bulk_temperature};
use schlupf::analysis::creep_curve::{Creepages, Path, Sampling, trace};
use schlupf::bodies::{Kinematics, ReferencePoint};
use schlupf::interface::InterfaceConstant;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::profile::{Profile, UndeformedDistance};
use schlupf::normal::{PressureSource, PressureTable, Tabulated};
use schlupf::problem::{
    AreaReduction, Brush, FastMethod, Flexibilities, History, SlopeReduction, TractionBound,
};
use schlupf::solution::Resultant;
use schlupf::solver::SteadySolver;
use schlupf::solver::simplified::FastContact;
use schlupf::{Method, Options, Problem, Solution, Status, solver, unwatched};
use std::sync::Arc;

/// Where the middle of the patch lies in the file, in m.
const ORIGIN: [f64; 2] = [2.5e-3, -11e-3];

/// ξ, η, φ at the middle of the patch.
const MOTION: [f64; 3] = [0.0015, -0.0008, 0.35];

fn options() -> Options {
    Options { cells_x: 14, cells_y: 14, ..Options::default() }
}

fn exact() -> Options {
    Options { tolerance: 1e-10, ..options() }
}

/// Hertz's pressure with a = 6 mm, b = 5 mm, p0 = 1 GPa on a lattice whose origin is such that the
/// middle of the patch lies at `middle` (in m).
fn table(middle: [f64; 2]) -> Arc<dyn PressureSource> {
    let count = 41;
    let line = |half: f64, middle: f64| -> Vec<f64> {
        let at = |k: i32| middle + half * 1.1 * f64::from(2 * k - count + 1) / f64::from(count - 1);
        (0..count).map(at).collect()
    };
    let (x, y) = (line(6e-3, middle[0]), line(5e-3, middle[1]));
    let pressure = |x: f64, y: f64| {
        let [s, t] = [(x - middle[0]) / 6e-3, (y - middle[1]) / 5e-3];
        1e9 * (1.0 - s * s - t * t).max(0.0).sqrt()
    };
    let values = y.iter().flat_map(|y| x.iter().map(|x| pressure(*x, *y))).collect();
    Arc::new(Tabulated::new(PressureTable::new(&x, &y, values).unwrap(), None).unwrap())
}

/// The creepages at the origin of the file with which the middle of the patch has (ξ, η, φ), by
/// hand: the slip of a rigid body is (ξ − φ y, η + φ x).
fn at_file([xi, eta, spin]: [f64; 3]) -> Kinematics {
    let [x0, y0] = ORIGIN;
    rolling(xi + spin * y0, eta - spin * x0, spin)
}

/// The same contact twice: with its creepages at the middle of the patch, in a file that has its
/// origin there, and at the origin of a file from which the patch is displaced.
fn both(motion: [f64; 3]) -> [Problem; 2] {
    let [xi, eta, spin] = motion;
    let base = problem(rolling(xi, eta, spin));
    let patch = Problem { normal: table([0.0; 2]), ..base.clone() }
        .with_interface(|interface| interface.elasticity = half_space());
    let file = Problem {
        normal: table(ORIGIN),
        kinematics: at_file(motion),
        reference: ReferencePoint::File,
        ..patch.clone()
    };
    [patch, file]
}

/// A motion from another one and a step.
type Step = fn(Kinematics, f64) -> Kinematics;

fn solve(problem: &Problem, options: &Options) -> Solution {
    let solution = solver::solve(problem, options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

/// Forces are the same, the moment is taken about the origin of the file: Mz + x0 Fy − y0 Fx.
fn assert_displaced(file: &Resultant, patch: &Resultant, scale: f64) {
    let [x0, y0] = ORIGIN;
    assert_relative_eq!(file.x, patch.x, epsilon = scale);
    assert_relative_eq!(file.y, patch.y, epsilon = scale);
    if let Some(moment) = patch.moment_z {
        let moment = moment + x0 * patch.y - y0 * patch.x;
        assert_relative_eq!(file.moment_z.unwrap(), moment, epsilon = 5e-3 * scale);
    }
}

fn assert_same_contact(file: &Solution, patch: &Solution) {
    let scale = 1e-7 * 0.4 * patch.normal.load;
    assert_displaced(&file.force, &patch.force, scale);
    if let (Some(one), Some(other)) = (file.power, patch.power) {
        assert_relative_eq!(one.creep, other.creep, max_relative = 1e-6);
        assert_relative_eq!(one.friction, other.friction, max_relative = 1e-6);
    }
    // Power about the origin of the file, with its own creepages and its own moment.
    let Kinematics { speed, creepage_x, creepage_y, spin, .. } = file.kinematics;
    if let Resultant { x, y, moment_z: Some(moment_z) } = file.force {
        let power = -speed * (creepage_x * x + creepage_y * y + spin * moment_z);
        assert_relative_eq!(power, patch.power.unwrap().creep, max_relative = 1e-6);
    }
    assert_eq!(file.temperature.is_some(), patch.temperature.is_some());
    if let (Some(one), Some(other)) = (file.temperature, patch.temperature) {
        assert_relative_eq!(one.max_rise_wheel, other.max_rise_wheel, max_relative = 1e-6);
    }
    assert_eq!((file.reference, patch.reference), (ReferencePoint::File, ReferencePoint::Patch));
    // Each tells the other one.
    let (motion, force) = file.seen_from(ReferencePoint::Patch).unwrap();
    assert_relative_eq!(motion.creepage_x, patch.kinematics.creepage_x, epsilon = 1e-12);
    assert_relative_eq!(motion.creepage_y, patch.kinematics.creepage_y, epsilon = 1e-12);
    if let (Some(at_patch), Some(at_file)) = (patch.force.moment_z, file.force.moment_z) {
        assert_relative_eq!(force.moment_z.unwrap(), at_patch, epsilon = 5e-3 * scale);
        let lever = (patch.normal.semi_axis_x * patch.normal.semi_axis_y).sqrt();
        let moment = at_file / (0.4 * patch.normal.load * lever);
        assert_relative_eq!(file.normalised.moment_z.unwrap(), moment, max_relative = 1e-9);
    }
    let Kinematics { creepage_x, creepage_y, spin, .. } = file.kinematics;
    let expected = (creepage_x * file.force.x).abs() + (creepage_y * file.force.y).abs();
    assert_relative_eq!(file.t_gamma.without_spin, expected, max_relative = 1e-9);
    if let Some(moment) = file.force.moment_z {
        let whole = expected + (spin * moment).abs();
        assert_relative_eq!(file.t_gamma.with_spin.unwrap(), whole, max_relative = 1e-9);
    }
}

/// Goal: a contact displaced in its file has the forces, powers and temperatures of the same
/// contact in the middle.
/// Set-up: steady, marched, and by every fast method; with heat whose partition depends on the
/// wheel's speed.
/// Source: kinematics of a rigid body, by hand.
#[test]
fn a_displaced_table_is_the_same_contact() {
    let bristles = |flexibilities| Brush { flexibilities, bound: TractionBound::Elliptic };
    let methods = [
        Method::Full,
        Method::Fast(FastMethod::KalkerLinear),
        Method::Fast(FastMethod::ShenHedrickElkins),
        Method::Fast(FastMethod::Polach(AreaReduction::DRY)),
        Method::Fast(FastMethod::Fastsim(bristles(Flexibilities::Three))),
        Method::Fast(FastMethod::Fastsim(bristles(Flexibilities::One))),
        Method::Fast(FastMethod::ModifiedFastsim(
            bristles(Flexibilities::Three),
            SlopeReduction::DRY,
        )),
    ];
    for motion in [MOTION, [0.0, 0.0, 0.6], [0.002, 0.001, 0.0]] {
        let mut pair = both(motion);
        for problem in &mut pair {
            problem.interface.heat =
                Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
        }
        for method in &methods {
            let [patch, file] = pair
                .each_ref()
                .map(|problem| method.solver(&exact()).solve(problem, &unwatched).unwrap());
            if method.has_fields() {
                assert_same_contact(&file, &patch);
            } else {
                assert_displaced(&file.force, &patch.force, 1e-7 * 0.4 * patch.normal.load);
            }
            if let Method::Fast(method) = method {
                let [still, displaced] = pair.each_ref().map(|problem| {
                    let mut contact = FastContact::new(problem, method.clone(), &exact()).unwrap();
                    contact.force(&problem.kinematics).unwrap()
                });
                assert_displaced(&displaced, &still, 1e-7 * 0.4 * patch.normal.load);
            }
        }
    }
    let [patch, file] = both(MOTION).map(|problem| common::solve(&problem, &exact()));
    assert_same_contact(&file, &patch);
}

/// Goal: the same with creepages and spin that change in time, at every instant.
#[test]
fn a_history_is_that_of_the_same_body() {
    let [patch, file] = both(MOTION);
    let time = vec![0.0, 2e-4, 6e-4];
    let (xi, spin) = (vec![0.0, 0.002, 0.001], vec![0.5, -0.3, 0.4]);
    let [x0, y0] = ORIGIN;
    let along = xi.iter().zip(&spin).map(|(xi, spin)| xi + spin * y0).collect();
    let across = spin.iter().map(|spin| MOTION[1] - spin * x0).collect();
    let own = History { time, spin: Some(spin), ..History::default() };
    let displaced = History { creepage_x: Some(along), creepage_y: Some(across), ..own.clone() };
    let patch = solve_over(&patch, History { creepage_x: Some(xi), ..own }, &exact());
    let file = solve_over(&file, displaced, &exact());
    assert_same_contact(&file, &patch);
    assert_eq!(file.history.len(), patch.history.len());
    assert!(file.history.len() > 10);
    for (file, patch) in file.history.iter().zip(&patch.history) {
        assert_displaced(&file.force, &patch.force, 1e-6 * 0.4 * patch.load);
        let there = at_file([
            patch.kinematics.creepage_x,
            patch.kinematics.creepage_y,
            patch.kinematics.spin,
        ]);
        assert_relative_eq!(file.kinematics.creepage_x, there.creepage_x, epsilon = 1e-14);
        assert_relative_eq!(file.kinematics.creepage_y, there.creepage_y, epsilon = 1e-14);
    }
}

/// Goal: derivatives are those by the creepages at the origin of the file, of the moment about it,
/// within 2·10⁻⁶ of μ0 N of central differences of whole solutions.
#[test]
fn derivatives_are_those_of_central_differences() {
    let [_, file] = both(MOTION);
    let options = Options { sensitivity: true, tolerance: 1e-11, ..options() };
    let exact = solve(&file, &options).sensitivity.unwrap();
    let limit = 0.4 * file.normal.normal_contact(None).unwrap().summary.load;
    let at =
        |kinematics: Kinematics| solve(&Problem { kinematics, ..file.clone() }, &options).force;
    let own = file.kinematics;
    let (h, scale) = (1e-7, 1e-3);
    let steps: [Step; 3] = [
        |own, h| Kinematics { creepage_x: own.creepage_x + h, ..own },
        |own, h| Kinematics { creepage_y: own.creepage_y + h, ..own },
        |own, h| Kinematics { spin: own.spin + 1e2 * h, ..own },
    ];
    let derivatives = [(exact.creepage_x, scale), (exact.creepage_y, scale), (exact.spin, 0.2)];
    let differences = derivatives.into_iter().zip(steps);
    for (k, ((exact, scale), moved)) in differences.enumerate() {
        let step = if k == 2 { 1e2 * h } else { h };
        let [plus, minus] = [at(moved(own, h)), at(moved(own, -h))];
        for (exact, plus, minus, unit) in [
            (exact.x, plus.x, minus.x, 1.0),
            (exact.y, plus.y, minus.y, 1.0),
            (exact.moment_z.unwrap(), plus.moment_z.unwrap(), minus.moment_z.unwrap(), 5e-3),
        ] {
            let error = (exact - (plus - minus) / (2.0 * step)) * scale / (limit * unit);
            assert!(error.abs() < 2e-6, "{k}: {error:e}");
        }
    }
}

/// Goal: forces and derivatives by μ0, as identification takes them, are those of the same contact.
#[test]
fn derivatives_by_constants_are_about_the_origin_of_the_file() {
    let constants = [InterfaceConstant::ContactStiffness];
    let [patch, file] = both(MOTION).map(|problem| {
        let mut solver = SteadySolver::new(&exact());
        solver.solve_with_derivatives_by(&problem, &constants, &unwatched).unwrap().unwrap()
    });
    assert_displaced(&file.0.force, &patch.0.force, 1e-7 * 0.4 * patch.0.normal.load);
    assert_displaced(&file.1[0], &patch.1[0], 1e-5 * patch.1[0].x.abs());
}

/// Goal: the long-term bulk temperature of the wheel is that of the same contact.
#[test]
fn bulk_temperature_is_that_of_the_same_contact() {
    let cooling = Cooling { film_coefficient: 30.0, area: 2.0, air_temperature: 15.0 };
    let [patch, file] = both(MOTION).map(|mut problem| {
        problem.interface.heat =
            Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
        bulk_temperature(&problem, &mut SteadySolver::new(&exact()), &cooling, &unwatched).unwrap()
    });
    assert_relative_eq!(file.temperature, patch.temperature, max_relative = 1e-6);
    assert_same_contact(&file.solution, &patch.solution);
}

/// Goal: creep curves over the creepages at the origin of the file; over ξ alone, which is the same
/// everywhere, the initial slope is still Kalker's coefficient of the patch, over spin there is
/// none.
#[test]
fn creep_curves_are_over_the_creepages_of_the_file() {
    let [patch, file] = both([0.0; 3]);
    let sampling = Sampling::Even(4);
    let over = |problem: &Problem, end: Creepages| {
        let path = Path::new(Creepages::default(), end).unwrap();
        trace(&mut SteadySolver::new(&exact()), problem, &path, &sampling, &unwatched).unwrap()
    };
    let along = Creepages { x: 0.003, ..Creepages::default() };
    let [still, displaced] = [&patch, &file].map(|problem| over(problem, along));
    let [one, other] = [&still, &displaced].map(|curve| curve.initial_slope.unwrap());
    assert_displaced(&other.force, &one.force, 1e-6 * one.force.x.abs());
    let [one, other] = [one.kalker.unwrap(), other.kalker.unwrap()];
    assert_relative_eq!(one.x, other.x, max_relative = 1e-6);
    assert_relative_eq!(one.moment_z.unwrap(), other.moment_z.unwrap(), epsilon = 1e-6);
    for (still, displaced) in still.points.iter().zip(&displaced.points) {
        assert_eq!(still.abscissa, displaced.abscissa);
        assert_displaced(&displaced.force, &still.force, 1e-6 * 0.4 * 60e3);
    }
    // Over spin about the origin of the file the patch has creepages as well.
    let spin = Creepages { spin: 0.5, ..Creepages::default() };
    let curve = over(&file, spin);
    let slope = curve.initial_slope.unwrap();
    assert!(slope.kalker.is_none());
    let [x0, y0] = ORIGIN;
    let there = Creepages { x: -0.5 * y0, y: 0.5 * x0, spin: 0.5 };
    let end = over(&patch, there);
    let last = [&curve, &end].map(|curve| curve.points.last().unwrap().force);
    assert_displaced(&last[0], &last[1], 1e-6 * 0.4 * 60e3);
}

/// Goal: the same of a profile: a wheel 11 mm off the file's origin.
#[test]
fn a_displaced_profile_is_the_same_contact() {
    let pressed = |middle: f64| -> Arc<dyn PressureSource> {
        let y: Vec<f64> = (-100..=100).map(|k| middle + 5e-4 * f64::from(k)).collect();
        let distance = y.iter().map(|y| 0.5 * (y - middle).powi(2) / 0.3).collect();
        let distance = UndeformedDistance::across(y, distance, 0.46).unwrap();
        Arc::new(Profile::new(distance, 115e9, 80e3, 64).unwrap())
    };
    let [xi, eta, spin] = MOTION;
    let base = problem(rolling(xi, eta, spin))
        .with_interface(|interface| interface.elasticity = half_space());
    let patch = solve(&Problem { normal: pressed(0.0), ..base.clone() }, &cells(20));
    let file = Problem {
        normal: pressed(ORIGIN[1]),
        kinematics: rolling(xi + spin * ORIGIN[1], eta, spin),
        reference: ReferencePoint::File,
        ..base
    };
    let file = solve(&file, &cells(20));
    let scale = 1e-4 * 0.4 * patch.normal.load;
    assert_relative_eq!(file.normal.origin.unwrap()[1], ORIGIN[1], epsilon = 1e-6);
    assert_relative_eq!(file.force.x, patch.force.x, epsilon = scale);
    assert_relative_eq!(file.force.y, patch.force.y, epsilon = scale);
    let moment = patch.force.moment_z.unwrap() - ORIGIN[1] * patch.force.x;
    assert_relative_eq!(file.force.moment_z.unwrap(), moment, epsilon = 0.01 * scale);
    assert_relative_eq!(file.power.unwrap().creep, patch.power.unwrap().creep, max_relative = 1e-3);
}

/// Goal: where no file has an origin, asking for it is an error that names the field.
#[test]
fn without_a_file_there_is_no_other_origin() {
    let hertzian = Problem { reference: ReferencePoint::File, ..problem(rolling(0.001, 0.0, 0.1)) };
    for method in [Method::Full, Method::Fast(FastMethod::KalkerLinear)] {
        let error = method.solver(&options()).solve(&hertzian, &unwatched).unwrap_err().to_string();
        assert!(error.contains("reference") && error.contains("file"), "{error}");
    }
}
