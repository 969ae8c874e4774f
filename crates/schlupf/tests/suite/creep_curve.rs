//! Creep curves: slope, maximum, saturation and what is refused.

use crate::common::{self, cells, problem, rolling};
use approx::assert_relative_eq;
use schlupf::analysis::creep_curve::{
    Abscissa, CreepCurve, Creepages, PLATEAU, Path, Sampling, VariedForce, trace,
};
use schlupf::bodies::Material;
use schlupf::elasticity::{HalfSpace, Winkler};
use schlupf::interface::Incremental;
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::Ellipse;
use schlupf::reporting::Stage;
use schlupf::solver::kalker_coefficients::creep_coefficients;
use schlupf::solver::reference::winkler_strip;
use schlupf::solver::{MarchingSolver, SteadySolver};
use schlupf::{Error, Method, Options, Problem, Quantity, Solver, Status, unwatched};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

const BEDDING: f64 = 1e13;

/// Full friction without bristles on a Winkler bedding.
fn winkler() -> Problem {
    let mut winkler = problem(rolling(0.0, 0.0, 0.0));
    winkler.interface.elasticity = Arc::new(Winkler::new(BEDDING, BEDDING).unwrap());
    winkler.interface.contact_law = Incremental::new(1e10).unwrap().into();
    winkler
}

/// Friction that falls with the temperature.
fn hot() -> Problem {
    let mut hot = problem(rolling(0.0, 0.0, 0.0));
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    hot
}

/// Over ξ, the other creepages being those of the problem.
fn over_x(problem: &Problem, [from, to]: [f64; 2]) -> Path {
    let own = Creepages::of(&problem.kinematics);
    Path::new(Creepages { x: from, ..own }, Creepages { x: to, ..own }).unwrap()
}

fn curve(problem: &Problem, options: &Options, path: &Path, points: usize) -> CreepCurve {
    curve_by(&mut SteadySolver::new(options), problem, path, points)
}

fn curve_by(solver: &mut dyn Solver, problem: &Problem, path: &Path, points: usize) -> CreepCurve {
    let sampling = Sampling::Refined(points);
    let done = AtomicUsize::new(0);
    let curve = trace(solver, problem, path, &sampling, &|progress| {
        let before = done.swap(progress.done, Ordering::Relaxed);
        assert!(progress.done == before || progress.done == before + 1);
        assert_eq!((progress.stage, progress.total), (Stage::Curve, Some(points)));
        ControlFlow::Continue(())
    });
    let curve = curve.unwrap();
    assert_eq!((done.into_inner(), curve.points.len()), (points, points));
    curve
}

fn refused(problem: &Problem, path: &Path) -> Error {
    let mut solver = SteadySolver::new(&cells(8));
    trace(&mut solver, problem, path, &Sampling::default(), &|_| panic!("solved")).unwrap_err()
}

/// The closed form of FASTSIM's limit: with κ = cξa/(μp0) forces, slope 4/π dκ/dξ, and saturation
/// where F = (1 − 10⁻³) μN. Forces keep within 0.3 % of μN of it on 24 cells; the error of the
/// slope, at which all that counts are the edges, falls with the cell's size.
#[test]
fn winkler_strips_have_their_closed_form() {
    let kappa_per_creepage = BEDDING * 6e-3 / (0.4 * 1e9);
    let strips = winkler();
    let path = over_x(&strips, [0.0, 0.2]);
    let coarse = curve(&strips, &cells(24), &path, 31);
    assert!(coarse.is_converged() && coarse.warnings.is_empty(), "{:?}", coarse.warnings);
    for point in &coarse.points {
        let exact = winkler_strip::force_over_limit(kappa_per_creepage * point.abscissa);
        assert!((point.normalised.x + exact).abs() < 3e-3, "{} {exact}", point.normalised.x);
    }
    let saturation = coarse.maximum().unwrap();
    assert!(saturation.is_saturated);
    let around = over_x(&strips, [0.98 * saturation.abscissa, saturation.abscissa]);
    let [below, at] = &curve(&strips, &cells(24), &around, 2).points[..] else { panic!() };
    let level = (1.0 - PLATEAU) * saturation.traction_coefficient;
    assert!(below.traction_coefficient < level && at.traction_coefficient >= level);
    assert_relative_eq!(saturation.traction_coefficient, 0.4, max_relative = 1e-3);
    assert_eq!(saturation.kinematics.creepage_x, saturation.abscissa);

    let fine = curve(&strips, &cells(48), &path, 2);
    let [coarse_slope, fine_slope] = [&coarse, &fine].map(|c| c.initial_slope.unwrap());
    let exact = -4.0 / std::f64::consts::PI * kappa_per_creepage;
    let slopes = [coarse_slope, fine_slope].map(|slope| slope.normalised.x / exact);
    assert!(slopes[0] < 1.06 && slopes[1] < 1.035, "{slopes:?}");
    assert_relative_eq!(2.0 * slopes[1] - slopes[0], 1.0, max_relative = 0.01);
    let force = coarse_slope.normalised.x * 0.4 * coarse.normal.load;
    assert_relative_eq!(coarse_slope.force.x, force, max_relative = 1e-12);
}

/// Kalker 1967: on the half-space without bristles the slopes are C11, C22, C23 and C33, here of
/// `kalker_coefficients`, which are exact to 0.9 %; they tend there with the cell's size.
#[test]
fn kalker_1967_initial_slopes() {
    let mut smooth = problem(rolling(0.0, 0.0, 0.0));
    smooth.normal = Arc::new(Ellipse::from_peak_pressure(5e-3, 5e-3, 1e9).unwrap());
    smooth.interface.elasticity =
        Arc::new(HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap());
    smooth.interface.contact_law = Incremental::new(1e10).unwrap().into();
    let exact = creep_coefficients(1.0, Material::STEEL.poisson_ratio).unwrap();
    let on = |cells_across: usize, end: Creepages| {
        let path = Path::new(Creepages::default(), end).unwrap();
        let curve = curve(&smooth, &cells(cells_across), &path, 2);
        let kalker = curve.initial_slope.unwrap().kalker.unwrap();
        [kalker.x, kalker.y, kalker.moment_z.unwrap()]
    };
    let extrapolated = |end: Creepages| {
        let [coarse, fine] = [on(16, end), on(32, end)];
        [0, 1, 2].map(|component| 2.0 * fine[component] - coarse[component])
    };
    let [x, y, moment] = extrapolated(Creepages { x: 1e-3, ..Creepages::default() });
    assert_relative_eq!(x, exact.c11, max_relative = 0.02);
    assert!(y.abs() < 1e-3 && moment.abs() < 1e-3);
    let [_, y, moment] = extrapolated(Creepages { y: 1e-3, ..Creepages::default() });
    assert_relative_eq!(y, exact.c22, max_relative = 0.02);
    assert_relative_eq!(moment, -exact.c23, max_relative = 0.02);
    // With spin the error of the grid is larger, and falls with the square of the cell's size.
    let [_, y, moment] = on(64, Creepages { spin: 0.1, ..Creepages::default() });
    assert_relative_eq!(y, exact.c23, max_relative = 0.07);
    assert_relative_eq!(moment, exact.c33, max_relative = 0.04);
}

/// The slope is the difference quotient of a curve that is fine enough, also where another creepage
/// makes the patch slide already.
#[test]
fn the_slope_is_that_of_the_curve() {
    for (lateral, is_at_rest) in [(0.0, true), (0.004, false)] {
        let sliding = problem(rolling(0.0, lateral, 0.0));
        let options = Options { tolerance: 1e-9, ..cells(16) };
        let curve = curve(&sliding, &options, &over_x(&sliding, [-2e-6, 2e-6]), 3);
        let [first, last] = [&curve.points[0], &curve.points[2]];
        let quotient = (last.force.x - first.force.x) / 4e-6;
        let slope = curve.initial_slope.unwrap();
        assert_relative_eq!(slope.force.x, quotient, max_relative = 2e-3);
        assert_eq!(slope.kalker.is_some(), is_at_rest);
        assert!(slope.force.y.abs() < 1e-3 * slope.force.x.abs());
    }
}

/// The maximum of falling friction is where dense sampling has it, from however few points.
#[test]
fn the_maximum_is_where_dense_sampling_has_it() {
    let (hot, options) = (hot(), cells(12));
    let even = Sampling::Even(1001);
    let (mut solver, path) = (SteadySolver::new(&options), over_x(&hot, [0.004, 0.014]));
    let dense = trace(&mut solver, &hot, &path, &even, &unwatched).unwrap();
    let higher = |i: &&schlupf::analysis::creep_curve::Point,
                  k: &&schlupf::analysis::creep_curve::Point| {
        i.traction_coefficient.total_cmp(&k.traction_coefficient)
    };
    let highest = dense.points.iter().max_by(higher).unwrap();
    assert!(highest.abscissa > 0.005 && highest.abscissa < 0.013, "{}", highest.abscissa);
    for (range, points) in [
        ([0.0, 0.05], 41),
        ([0.0, 0.05], 2),
        ([0.9, 0.0], 3),
        ([0.0, highest.abscissa * 1.2], 2),
        ([0.8 * highest.abscissa, 0.9], 2),
    ] {
        let found = curve(&hot, &options, &over_x(&hot, range), points);
        let maximum = found.maximum().unwrap_or_else(|| panic!("{range:?} {points}"));
        assert!((maximum.abscissa - highest.abscissa).abs() < 1.5e-4, "{range:?} {maximum:?}");
        let value = maximum.traction_coefficient;
        assert_relative_eq!(value, highest.traction_coefficient, max_relative = 1e-5);
        assert!(!maximum.is_saturated);
    }
}

/// At an end of the range, nothing is known of what is beyond.
#[test]
fn a_force_that_rises_or_falls_throughout_has_no_maximum() {
    let (hot, options) = (hot(), cells(12));
    for (range, points) in [([0.0, 0.003], 11), ([0.0, 0.003], 2), ([0.03, 0.2], 5)] {
        let curve = curve(&hot, &options, &over_x(&hot, range), points);
        assert!(curve.maxima.is_empty() && curve.maximum().is_none(), "{:?}", curve.maxima);
    }
    // Driving rises throughout, braking has its maximum, and the lower one is none of the whole.
    let both = curve(&hot, &options, &over_x(&hot, [-0.003, 0.1]), 21);
    assert_eq!(both.maxima.len(), 1);
    assert!(both.maximum().is_some());
    let mostly_driving = curve(&hot, &options, &over_x(&hot, [-0.4, 0.012]), 21);
    assert!(mostly_driving.maxima[0].abscissa < 0.0);
}

/// Driving and braking are mirror images where both bodies take the same heat.
#[test]
fn a_curve_through_zero_is_symmetric() {
    let (hot, options) = (hot(), cells(12));
    let curve = curve(&hot, &options, &over_x(&hot, [0.05, -0.05]), 21);
    assert_eq!(curve.points[0].abscissa, 0.05);
    assert_eq!(curve.points[10].abscissa, 0.0);
    for (braking, driving) in curve.points.iter().zip(curve.points.iter().rev()) {
        assert_relative_eq!(braking.force.x, -driving.force.x, max_relative = 1e-5);
    }
    let [braking, driving] = &curve.maxima[..] else { panic!("{:?}", curve.maxima) };
    assert!(braking.abscissa > 0.0);
    assert_relative_eq!(braking.abscissa, -driving.abscissa, max_relative = 2e-3);
}

/// A fixed direction on an isotropic contact pulls along it.
#[test]
fn a_fixed_direction_is_followed() {
    let direction = 30_f64.to_radians();
    let mut strips = winkler();
    strips.kinematics.spin = 0.4;
    let path = Path::in_direction([0.0, 0.01], direction, [0.0; 2]).unwrap();
    assert_eq!(path.abscissa(), Some(Abscissa::Total { direction }));
    let curve = curve(&strips, &cells(12), &path, 5);
    for point in &curve.points[1..] {
        assert_eq!(point.kinematics.spin, 0.0);
        assert_relative_eq!(point.force.y / point.force.x, direction.tan(), max_relative = 1e-6);
        let total = point.kinematics.creepage_x.hypot(point.kinematics.creepage_y);
        assert_relative_eq!(total, point.abscissa, max_relative = 1e-12);
    }
}

/// Forces of a curve, prescribed along another one, have its creepages, whatever the other
/// creepages are.
#[test]
fn creepages_over_a_force_are_those_that_cause_it() {
    let mut problem = problem(rolling(0.001, -0.0005, 0.3));
    problem.interface.elasticity = common::half_space();
    let (options, own) = (cells(12), Creepages::of(&problem.kinematics));
    let end = Creepages { x: 0.002, ..own };
    let path = Path::new(Creepages { x: 0.0005, ..own }, end).unwrap();
    let sampling = Sampling::Even(4);
    let mut solver = SteadySolver::new(&options);
    let given = trace(&mut solver, &problem, &path, &sampling, &unwatched).unwrap();
    let load = given.normal.load;
    let forces = given.points.iter().map(|point| point.force.x);
    let mut solver = Method::Full.solver(&options);
    for (force, prescribed) in given.points.iter().zip(forces) {
        for (varied, value) in
            [(VariedForce::X, prescribed), (VariedForce::OverLoad, -prescribed / load)]
        {
            let path = Path::over_force(varied, [0.5 * value, value], own).unwrap();
            let sampling = Sampling::Even(2);
            let found = trace(&mut *solver, &problem, &path, &sampling, &unwatched).unwrap();
            assert!(found.is_converged() && found.maxima.is_empty());
            assert!(found.initial_slope.is_none());
            let [_, last] = &found.points[..] else { panic!("{:?}", found.points) };
            assert_eq!(last.abscissa, value);
            let (here, there) = (last.kinematics, force.kinematics);
            assert_relative_eq!(here.creepage_x, there.creepage_x, max_relative = 2e-5);
            assert_eq!((here.creepage_y, here.spin), (there.creepage_y, there.spin));
            assert_relative_eq!(last.force.y, force.force.y, max_relative = 2e-5);
        }
    }
    let beyond = Path::over_force(VariedForce::Y, [0.0, -load], own).unwrap();
    let error = trace(&mut *solver, &problem, &beyond, &sampling, &unwatched).unwrap_err();
    assert_eq!(error.quantity(), Quantity::ForceY, "{error}");
}

/// Extrapolation tells the error of every point by the cells, as it does for a single solution.
#[test]
fn points_know_their_error_by_the_cells() {
    let mut problem = problem(rolling(0.0, 0.0, 0.0));
    problem.interface.elasticity = common::half_space();
    let options = Options { extrapolate: true, ..cells(20) };
    let curve = curve(&problem, &options, &over_x(&problem, [0.0, 0.002]), 3);
    let point = &curve.points[2];
    let there = Problem { kinematics: point.kinematics, ..problem };
    let alone = SteadySolver::new(&options).solve(&there, &unwatched).unwrap();
    let [error, expected] = [point.error.unwrap().x, alone.extrapolation.unwrap().error.x];
    assert!(error.abs() > 1e-5 * alone.force.x.abs());
    assert_relative_eq!(error, expected, max_relative = 1e-2);
}

/// A curve costs about as much as its points, which are some 50 products each from a cold start.
#[test]
fn work_is_that_of_the_points() {
    let (hot, options) = (hot(), cells(20));
    let curve = curve(&hot, &options, &over_x(&hot, [0.0, 0.05]), 41);
    let of_points: f64 = curve.points.iter().map(|point| point.work.operator_products).sum();
    let all = curve.work.operator_products;
    assert!(of_points < 41.0 * 55.0, "{of_points}");
    assert!(all > of_points && all < 1.35 * of_points, "{all} {of_points}");
}

/// Points that did not converge stay, are named, and are trusted for nothing.
#[test]
fn what_did_not_converge_is_kept_and_named() {
    let hot = hot();
    let mut solver = MarchingSolver::new(&Options { max_steps: 3, ..cells(8) });
    let curve = curve_by(&mut solver, &hot, &over_x(&hot, [0.0, 0.05]), 4);
    let statuses: Vec<bool> =
        curve.points.iter().map(|point| point.status == Status::Converged).collect();
    assert_eq!(statuses, [false; 4]);
    assert!(!curve.is_converged());
    assert!(curve.maxima.is_empty());
    // The slope is that of the steady equations, which know nothing of time steps.
    assert!(curve.initial_slope.is_some());
    let warnings = curve
        .warnings
        .iter()
        .map(|warning| warning.message(&schlupf::reporting::Names).text)
        .collect::<Vec<_>>()
        .join("\n");
    assert!(warnings.starts_with("4 of 4 points"), "{warnings}");
    assert_eq!(warnings.matches("after 3 time steps").count(), 1, "{warnings}");
}

/// Where points around the highest one failed, a maximum among the others means nothing.
#[test]
fn a_maximum_beside_failed_points_is_none() {
    let hot = hot();
    let mut solver = MarchingSolver::new(&Options { max_steps: 24, ..cells(8) });
    let curve = curve_by(&mut solver, &hot, &over_x(&hot, [0.0, 0.1]), 21);
    let converged =
        curve.points.iter().filter(|p| p.status == Status::Converged && p.abscissa > 0.0);
    let fails = curve.points.iter().filter(|p| p.status == Status::NotConverged);
    let steps: Vec<_> = curve.points.iter().map(|p| (p.abscissa, p.status)).collect();
    assert!(converged.count() > 2 && fails.count() > 2, "{steps:?}");
    assert!(curve.maxima.is_empty(), "{:?}", curve.maxima);
}

/// All of it before the first solution.
#[test]
fn what_is_no_curve_of_steady_rolling_is_refused() {
    let still = problem(rolling(0.0, 0.0, 0.0));
    let path = over_x(&still, [0.0, 0.01]);
    let locked = refused(&still, &over_x(&still, [0.0, 1.2])).to_string();
    assert!(locked.contains("does not at creepage_x = 1"), "{locked}");
    let slow = problem(schlupf::bodies::Kinematics { speed: -1.0, ..rolling(0.0, 0.0, 0.0) });
    assert!(refused(&slow, &path).quantity() == Quantity::Speed);
    let one = Sampling::Even(1);
    assert!(trace(&mut SteadySolver::new(&cells(8)), &still, &path, &one, &unwatched).is_err());
}
