//! A layer between the surfaces that flows: with rigid bodies every point is a sheared element of
//! its own, with a closed form.

mod common;

use std::sync::Arc;

use approx::assert_relative_eq;
use common::{cells, follow, half_space, problem, rolling, solve};
use schlupf::elasticity::Elasticity;
use schlupf::elasticity::rigid::Rigid;
use schlupf::heat::{Heat, duhamel::Duhamel, partition::Partition};
use schlupf::interface::contact_law::{ContactLaw, Coulomb, Incremental};
use schlupf::interface::friction::temperature_linear::TemperatureLinear;
use schlupf::interface::third_body::{ThirdBodyLayer, YieldLimit};
use schlupf::kinematics::Kinematics;
use schlupf::method::{Brush, FastMethod, Flexibilities, Method, TractionBound};
use schlupf::rolling::marching::march;
use schlupf::warning::Warning;
use schlupf::{Options, Problem, Solution, Status, Transient, unwatched};

/// G/h, in Pa/m: so soft that the half-space is rigid against it.
const STIFFNESS: f64 = 1e11;

/// Semi-axes (in m), p0 (in Pa) and μ of the contact of the tests.
const SEMI_AXES: [f64; 2] = [6e-3, 5e-3];
const PEAK: f64 = 1e9;
const FRICTION: f64 = 0.4;

/// τ_c0 in Pa and k_τ in Pa/m.
const LIMITS: [[f64; 2]; 4] = [[2e8, 0.0], [1.5e8, 2e10], [2.5e8, -1e10], [1e8, 2e11]];

fn layer([stress, hardening]: [f64; 2]) -> ThirdBodyLayer {
    let layer = ThirdBodyLayer::new(1e-3, 1e-3 * STIFFNESS).unwrap();
    layer.with_yield(YieldLimit { stress, hardening }).unwrap()
}

fn contact(limit: [f64; 2], elasticity: Arc<dyn Elasticity>, creepage_x: f64) -> Problem {
    let mut contact = problem(rolling(creepage_x, 0.0, 0.0));
    contact.elasticity = elasticity;
    contact.contact_law = Arc::new(Coulomb);
    contact.layer = Some(layer(limit));
    contact
}

fn found_by(method: Method, problem: &Problem, options: &Options) -> Solution {
    let solution = method.solver(options).solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

/// Fx of independent points that are sheared by ξ s after a way s: elastic, then at τ_c with the
/// slope k_τ G/h/(k_τ + G/h), and never beyond μ p; integrated by the midpoint rule.
fn exact([stress, hardening]: [f64; 2], creepage: f64) -> f64 {
    let ([a, b], n) = (SEMI_AXES, 400);
    let share = 1.0 + hardening / STIFFNESS;
    let mut sum = 0.0;
    for j in 0..n {
        let y = b * ((f64::from(j) + 0.5) / f64::from(n) * 2.0 - 1.0);
        let length = a * (1.0 - (y / b).powi(2)).sqrt();
        for i in 0..n {
            let x = length * ((f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0);
            let sheared = creepage * (length - x);
            let pressure = PEAK * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt();
            let flowing = ((stress + hardening * sheared) / share).max(0.0);
            let traction = (STIFFNESS * sheared).min(flowing).min(FRICTION * pressure);
            sum += traction * length;
        }
    }
    -sum * 4.0 * b / f64::from(n * n)
}

/// The closed form with rigid bodies, steady and over time, and nearly with the half-space and with
/// FASTSIM, whose springs hardly count.
#[test]
fn every_point_follows_the_law_of_the_layer() {
    let brush = Brush { flexibilities: Flexibilities::Three, bound: TractionBound::Elliptic };
    let fastsim = Method::Fast(FastMethod::Fastsim(brush));
    for limit in LIMITS {
        for creepage in [0.05, 0.2, 0.6] {
            let exact = exact(limit, creepage);
            let rigid = contact(limit, Arc::new(Rigid), creepage);
            let off = |force: f64| (force - exact).abs() / exact.abs();
            let steady = found_by(Method::Full, &rigid, &cells(40));
            let options = cells(40);
            let transient = Transient::to_steady_state(&rigid);
            let marched = march(&transient, &options, &unwatched).unwrap();
            assert_eq!(marched.status, Status::Converged, "{:?}", marched.warnings);
            let soft = contact(limit, half_space(), creepage);
            let on_half_space = found_by(Method::Full, &soft, &cells(40));
            let fast = found_by(fastsim, &soft, &cells(40));
            let all = [&steady, &marched, &on_half_space, &fast].map(|found| off(found.force.x));
            println!(
                "{limit:?} {creepage}: {exact:.1} {all:.4?} products {} {} newton {} {}",
                steady.work.operator_products,
                on_half_space.work.operator_products,
                steady.work.newton_iterations,
                on_half_space.work.newton_iterations
            );
            for off in all {
                assert!(off < 0.012, "{limit:?} {creepage}: {all:?}");
            }
        }
    }
}

/// Layers of Hou et al. (1997) on the half-space: G/h in Pa/m, τ_c0 in Pa, k_τ in Pa/m.
const HOU: [[f64; 3]; 4] =
    [[8e12, 560e6, 0.0], [5e12, 200e6, 4.348e11], [8e12, 400e6, -1.951e11], [1e12, 20e6, 2.041e10]];

/// Friction power is the power of the creep forces, with the plastic work; both heat. Steady
/// rolling is the end of marching.
#[test]
fn plastic_work_is_dissipated_and_heats() {
    let laws: [Arc<dyn ContactLaw>; 2] =
        [Arc::new(Coulomb), Arc::new(Incremental::new(5e6).unwrap())];
    for ([stiffness, stress, hardening], law) in
        HOU.iter().flat_map(|hou| laws.iter().map(move |law| (*hou, law)))
    {
        let mut hot = contact([stress, 0.0], half_space(), 0.02);
        let layer = ThirdBodyLayer::new(1e-3, 1e-3 * stiffness).unwrap();
        hot.layer = Some(layer.with_yield(YieldLimit { stress, hardening }).unwrap());
        hot.contact_law = Arc::clone(law);
        hot.friction.law = Arc::new(TemperatureLinear::new(0.6, 700.0, 0.0).unwrap());
        hot.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
        let found = [found_by(Method::Full, &hot, &cells(20)), solve(&hot, &cells(20))];
        for solution in &found {
            let power = solution.power.unwrap();
            assert_relative_eq!(power.friction, power.creep, max_relative = 1e-3);
            assert!(solution.temperature.unwrap().max_rise > 10.0);
        }
        let [steady, marched] = found.map(|solution| solution.force.x);
        println!("{stress:e} {hardening:e}: {steady} {marched}");
        assert_relative_eq!(steady, marched, max_relative = 1e-3);
    }
}

/// Derivatives by the creepage, against central differences.
#[test]
fn derivatives_with_a_layer_that_flows() {
    for limit in LIMITS {
        let contact = contact(limit, half_space(), 0.3);
        let options = Options { sensitivity: true, tolerance: 1e-11, ..cells(16) };
        let at = |creepage_x: f64| {
            let kinematics = Kinematics { creepage_x, ..contact.kinematics };
            found_by(Method::Full, &Problem { kinematics, ..contact.clone() }, &options)
        };
        let found = at(0.3).sensitivity.unwrap().creepage_x.x;
        let step = 1e-8;
        let difference = (at(0.3 + step).force.x - at(0.3 - step).force.x) / (2.0 * step);
        println!("{limit:?}: {found} {difference}");
        assert_relative_eq!(found, difference, max_relative = 1e-3);
    }
}

/// A steady state goes on unchanged in time: the plastic way belongs to its state.
#[test]
fn marching_goes_on_from_a_steady_state_with_flow() {
    let contact = contact([1.5e8, 2e10], half_space(), 0.1);
    let options = Options { tolerance: 1e-9, ..cells(20) };
    let steady = found_by(Method::Full, &contact, &options);
    let goes_on = Transient {
        initial_state: Some(steady.state.clone()),
        ..Transient::to_steady_state(&contact)
    };
    let marched = follow(&goes_on, &options);
    assert_relative_eq!(marched.force.x, steady.force.x, max_relative = 1e-6);
    println!("{} steps", marched.work.steps);
    let longest = steady.state.elements.iter().map(|element| element.plastic_way);
    assert!(longest.fold(0.0, f64::max) > 1e-4);
}

/// Methods without fields take the layer to be elastic, and say so.
#[test]
fn methods_without_fields_tell_that_they_do_not_know_the_limit() {
    let contact = contact([1e8, 0.0], half_space(), 0.1);
    for method in [FastMethod::KalkerLinear, FastMethod::ShenHedrickElkins] {
        let warnings = found_by(Method::Fast(method), &contact, &cells(20)).warnings;
        assert!(warnings.contains(&Warning::NoYield { method: method.name() }), "{warnings:?}");
    }
    let elastic = ThirdBodyLayer::new(1e-3, 1e8).unwrap();
    let contact = Problem { layer: Some(elastic), ..contact };
    let warnings = found_by(Method::Fast(FastMethod::ShenHedrickElkins), &contact, &cells(20));
    assert!(!warnings.warnings.iter().any(|warning| matches!(warning, Warning::NoYield { .. })));
}
