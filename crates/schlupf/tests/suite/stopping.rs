//! Whoever watches may stop whatever takes long.

use crate::common::{cells, problem, rolling};
use approx::assert_relative_eq;
use schlupf::analysis::bulk_temperature::{Cooling, bulk_temperature};
use schlupf::analysis::calibration::{CalibrationOptions, calibrate};
use schlupf::analysis::creep_curve::{Creepages, Path, Sampling, trace};
use schlupf::analysis::identification::roughness::DEFAULT_GAMMA;
use schlupf::analysis::identification::{
    Component, Condition, DataPoint, Parameter, PolachModel, RollingContactModel, fit,
};
use schlupf::interface::friction::FrictionConstant;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::problem::{AreaReduction, FastMethod};
use schlupf::reporting::Watch;
use schlupf::solver::{self, SteadySolver, march, shift};
use schlupf::surface::{HeightMap, Lattice};
use schlupf::{Error, Method, Options, Problem, Solver, Transient, unwatched};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How often the work asks, and what comes of it if it is told to stop at that question.
fn watched<R>(
    stop_at: usize,
    work: impl FnOnce(Watch) -> Result<R, Error>,
) -> (usize, Result<R, Error>) {
    let asked = AtomicUsize::new(0);
    let result = work(&|_| {
        let is_over = asked.fetch_add(1, Ordering::Relaxed) + 1 >= stop_at;
        if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    (asked.into_inner(), result)
}

/// At the first question, in the middle and at the last one the work stops, and says so.
fn stops<R>(what: &str, work: impl Fn(Watch) -> Result<R, Error>) {
    let (questions, result) = watched(usize::MAX, &work);
    assert!(result.is_ok() && questions > 0, "{what}: {:?}", result.err());
    for last in [1, questions.div_ceil(2), questions] {
        let (_, result) = watched(last, &work);
        assert!(matches!(result, Err(Error::Stopped {})), "{what}, question {last}/{questions}");
    }
}

fn hot() -> Problem {
    let mut hot = problem(rolling(0.01, 0.0, 0.0));
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    hot
}

fn data() -> Vec<DataPoint> {
    let point = |(creepage_x, force_ratio)| {
        let condition = Condition { kinematics: rolling(creepage_x, 0.0, 0.0), load: None };
        let component = Component::Longitudinal;
        DataPoint { condition, component, force_ratio, standard_deviation: None }
    };
    [(5e-4, 0.14), (2e-3, 0.3), (8e-3, 0.34), (2e-2, 0.35)].map(point).to_vec()
}

#[test]
fn rolling_stops() {
    let (hot, options) = (hot(), cells(10));
    stops("steady", |watch| solver::solve(&hot, &options, watch));
    stops("marching", |watch| march(&Transient::to_steady_state(&hot), &options, watch));
    stops("shift", |watch| shift(&hot, [1e-6, 0.0], &options, watch));
    let fast = Method::Fast(FastMethod::ShenHedrickElkins);
    stops("fast", |watch| fast.clone().solver(&options).solve(&hot, watch));
}

/// On large grids whoever watches is asked before each product, also of the derivatives.
#[test]
fn large_grids_and_their_derivatives_stop() {
    let hot = hot();
    let plain = cells(84);
    let (questions, result) = watched(usize::MAX, |watch| solver::solve(&hot, &plain, watch));
    let products = result.unwrap().work.operator_products;
    assert!(questions as f64 > 0.5 * products, "{questions} questions, {products} products");
    let options = Options { sensitivity: true, ..plain };
    let (with_derivatives, result) =
        watched(usize::MAX, |watch| solver::solve(&hot, &options, watch));
    let work = result.unwrap().work;
    let asked = with_derivatives - questions;
    assert!(2 * asked > work.sensitivity_products, "{asked} questions, {work:?}");
    stops("derivatives", |watch| solver::solve(&hot, &options, watch));
}

#[test]
fn whatever_solves_again_and_again_stops() {
    let (hot, options) = (hot(), cells(8));
    let own = Creepages::of(&hot.kinematics);
    let path = Path::new(Creepages { x: 0.0, ..own }, Creepages { x: 0.02, ..own }).unwrap();
    let sampling = Sampling::Even(5);
    stops("creep curve", |watch| {
        trace(&mut SteadySolver::new(&options), &hot, &path, &sampling, watch)
    });
    let cooling = Cooling { film_coefficient: 40.0, area: 1.5, air_temperature: 10.0 };
    stops("bulk temperature", |watch| {
        bulk_temperature(&hot, &mut SteadySolver::new(&options), &cooling, watch)
    });
    let coarse = CalibrationOptions { cells: 8, ..CalibrationOptions::default() };
    stops("calibration", |watch| calibrate(1.0, 0.28, &coarse, watch));
}

#[test]
fn fits_stop() {
    let parameters = [Parameter::Friction(FrictionConstant::ColdCoefficient)];
    let (problem, options) = (problem(rolling(0.0, 0.0, 0.0)), cells(8));
    stops("fit", |watch| {
        let model = RollingContactModel::new(&problem, &options, &parameters, DEFAULT_GAMMA);
        fit(&mut model.unwrap(), &data(), 20, watch)
    });
    stops("fit by Polach's method", |watch| {
        let reduction = AreaReduction { area_adhesion: 1.0, area_slip: 1.0 };
        fit(&mut PolachModel::new(&problem, reduction, &parameters).unwrap(), &data(), 20, watch)
    });
}

#[test]
fn a_rough_contact_stops() {
    let distance = HeightMap::from_fn(Lattice::square(16, 0.02), |x, y| x * x + y * y).unwrap();
    stops("rough contact", |watch| {
        let mut contact = RoughContact::new(distance.clone(), 115e9, Boundary::Free)?;
        contact.solve(8e4, &RoughContactOptions::default(), watch)
    });
}

/// What a solver that was stopped leaves behind does not change what it finds next.
#[test]
fn a_stopped_solver_goes_on() {
    let (hot, options) = (hot(), cells(16));
    let expected = solver::solve(&hot, &options, &unwatched).unwrap();
    let mut solver = SteadySolver::new(&options);
    let mut stops = 0;
    while watched(stops + 1, |watch| solver.solve(&hot, watch)).1.is_err() {
        solver.forget();
        stops += 1;
    }
    assert!(stops > 3, "{stops} stops");
    solver.forget();
    let again = solver.solve(&hot, &unwatched).unwrap();
    assert_eq!(again.force, expected.force);
    let mut warm = SteadySolver::new(&options);
    let other = Problem { kinematics: rolling(0.002, 0.001, 0.0), ..hot.clone() };
    warm.solve(&other, &unwatched).unwrap();
    assert!(watched(2, |watch| warm.solve(&hot, watch)).1.is_err());
    let again = warm.solve(&hot, &unwatched).unwrap();
    assert_relative_eq!(again.force.x, expected.force.x, max_relative = 10.0 * options.tolerance);
}
