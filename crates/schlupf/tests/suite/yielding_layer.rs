//! A layer between the surfaces that flows: with rigid bodies every point is a sheared element of
//! its own, with a closed form.

use std::sync::Arc;

use crate::common::{cells, follow, half_space, problem, rolling, solve};
use approx::assert_relative_eq;
use schlupf::analysis::identification::{
    Component, Condition, DataPoint, Parameter, RollingContactModel, fit,
};
use schlupf::bodies::Kinematics;
use schlupf::elasticity::{Elasticity, Rigid};
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental, ThirdBodyLayer, YieldLimit};
use schlupf::problem::{Brush, FastMethod, Flexibilities, History, Method, TractionBound};
use schlupf::reporting::Warning;
use schlupf::solver::march;
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
    contact.interface.elasticity = elasticity;
    contact.interface.contact_law = ContactLaw::Coulomb;
    contact.interface.layer = Some(layer(limit));
    contact
}

fn found_by(method: &Method, problem: &Problem, options: &Options) -> Solution {
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
            let steady = found_by(&Method::Full, &rigid, &cells(40));
            let options = cells(40);
            let transient = Transient::to_steady_state(&rigid);
            let marched = march(&transient, &options, &unwatched).unwrap();
            assert_eq!(marched.status, Status::Converged, "{:?}", marched.warnings);
            let soft = contact(limit, half_space(), creepage);
            let on_half_space = found_by(&Method::Full, &soft, &cells(40));
            let fast = found_by(&fastsim.clone(), &soft, &cells(40));
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

/// A point of the layer under a bound of friction: elastic, flowing, sliding.
#[derive(Clone, Copy, Default)]
struct Sheared {
    plastic: f64,
    way: f64,
}

impl Sheared {
    /// The traction at a displacement.
    fn traction(&mut self, displacement: f64, [stress, hardening]: [f64; 2], bound: f64) -> f64 {
        let elastic = STIFFNESS * (displacement - self.plastic);
        let limit = (stress + hardening * self.way).max(0.0);
        if elastic.abs() <= limit.min(bound) {
            return elastic;
        }
        if limit < bound {
            let flow = (elastic.abs() - limit) / (STIFFNESS + hardening);
            let until = if hardening > 0.0 { (bound - limit) / hardening } else { f64::INFINITY };
            self.way += flow.min(until);
        }
        let size = (stress + hardening * self.way).max(0.0).min(bound);
        self.plastic = displacement - elastic.signum() * size / STIFFNESS;
        elastic.signum() * size
    }
}

/// Creepage that turns round while material passes, and stays.
const TURNING: [[f64; 2]; 4] = [[0.0, 0.4], [0.5e-3, 0.4], [0.6e-3, -0.4], [1.4e-3, -0.4]];

/// Fx over time (time and force) of independent points that travel at `speed`, under a creepage
/// that turns round.
fn turned(limit: [f64; 2], speed: f64, turning: [[f64; 2]; 4]) -> Vec<[f64; 2]> {
    const ROWS: usize = 60;
    const STEPS: usize = 120;
    let [a, b] = SEMI_AXES;
    let creepage = |time: f64| {
        let after = turning.iter().position(|point| point[0] > time).unwrap_or(turning.len() - 1);
        let [from, to] = [turning[after - 1], turning[after]];
        from[1] + (to[1] - from[1]) * ((time - from[0]) / (to[0] - from[0])).min(1.0)
    };
    let step = 2.0 * a / STEPS as f64;
    let count = (turning[3][0] * speed / step) as usize;
    let mut forces = vec![0.0; count];
    for row in 0..ROWS {
        let y = b * ((row as f64 + 0.5) / ROWS as f64 * 2.0 - 1.0);
        let length = a * (1.0 - (y / b).powi(2)).sqrt();
        // From the trailing to the leading edge of the ellipse; at rest at first.
        let mut points = vec![(Sheared::default(), 0.0); STEPS];
        for (k, force) in forces.iter_mut().enumerate() {
            let time = (k as f64 + 0.5) * step / speed;
            points.remove(0);
            points.push((Sheared::default(), 0.0));
            for (i, (point, displacement)) in points.iter_mut().enumerate() {
                let x = a * ((i as f64 + 0.5) / STEPS as f64 * 2.0 - 1.0);
                if x.abs() < length {
                    // Half a step since it entered, where that was in this step.
                    let way = (length - x).min(step);
                    *displacement += creepage(time) * way;
                    let ellipse: f64 = 1.0 - (x / a).powi(2) - (y / b).powi(2);
                    let bound = FRICTION * PEAK * ellipse.max(0.0).sqrt();
                    let traction = point.traction(*displacement, limit, bound);
                    *force -= traction * step * 2.0 * b / ROWS as f64;
                }
            }
        }
    }
    forces.iter().enumerate().map(|(k, f)| [(k as f64 + 1.0) * step / speed, *f]).collect()
}

/// Largest difference (in N) of a march with rigid bodies from [`turned`].
fn farthest_from_turned(limit: [f64; 2], turning: [[f64; 2]; 4], across: usize) -> f64 {
    let mut problem = contact(limit, Arc::new(Rigid), 0.4);
    let speed = problem.kinematics.speed;
    let history = History {
        time: turning.iter().map(|point| point[0]).collect(),
        creepage_x: Some(turning.iter().map(|point| point[1]).collect()),
        ..History::default()
    };
    problem.kinematics.creepage_x = 0.0;
    let transient = Transient { problem, history, initial_state: None };
    let marched = march(&transient, &cells(across), &unwatched).unwrap();
    assert_eq!(marched.status, Status::Converged, "{:?}", marched.warnings);
    let expected = turned(limit, speed, turning);
    let mut largest = 0.0_f64;
    for instant in marched.history.iter().filter(|instant| instant.time > 0.2e-3) {
        let after = expected.iter().position(|[time, _]| *time >= instant.time);
        let Some(after) = after.filter(|after| *after > 0) else { continue };
        let ([t0, f0], [t1, f1]) = (expected[after - 1], expected[after]);
        let force = f0 + (f1 - f0) * (instant.time - t0) / (t1 - t0);
        largest = largest.max((instant.force.x - force).abs());
    }
    largest
}

/// A creepage that turns round within a fraction of a step, at the end of one: what sticks from
/// then on does not slide on. On 40 cells forces are off by 0.5 % of the range that they go
/// through; sliding that goes on for half a step makes it 9 %.
#[test]
fn material_sticks_from_a_sudden_turn_on() {
    let sudden = [[0.0, 0.4], [0.5e-3, 0.4], [0.5001e-3, -0.4], [1.4e-3, -0.4]];
    let limit = [3e7, 0.0];
    let range = 2.0 * limit[0] * std::f64::consts::PI * SEMI_AXES[0] * SEMI_AXES[1];
    let off = [20, 40].map(|across| farthest_from_turned(limit, sudden, across) / range);
    println!("{off:?}");
    assert!(off[0] < 0.015 && off[1] < 0.006, "{off:?}");
}

/// Loading, unloading and reversing while material passes, against points that are sheared one by
/// one; rigid bodies.
#[test]
fn material_unloads_and_reverses() {
    let limit_force = FRICTION * PEAK * 2.0 / 3.0 * std::f64::consts::PI * 6e-3 * 5e-3;
    for limit in LIMITS {
        let largest = farthest_from_turned(limit, TURNING, 40) / limit_force;
        println!("{limit:?}: {largest:.4}");
        // Hardening twice as steep as the layer is stiff.
        let bound = if limit[1] > STIFFNESS { 0.008 } else { 0.003 };
        assert!(largest < bound, "{limit:?}: {largest}");
    }
}

/// Layers of Hou et al. (1997) on the half-space: G/h in Pa/m, τ_c0 in Pa, k_τ in Pa/m.
const HOU: [[f64; 3]; 4] =
    [[8e12, 560e6, 0.0], [5e12, 200e6, 4.348e11], [8e12, 400e6, -1.951e11], [1e12, 20e6, 2.041e10]];

/// Friction power is the power of the creep forces, with the plastic work; both heat. Steady
/// rolling is the end of marching.
#[test]
fn plastic_work_is_dissipated_and_heats() {
    let laws: [ContactLaw; 2] = [ContactLaw::Coulomb, Incremental::new(5e6).unwrap().into()];
    for ([stiffness, stress, hardening], law) in
        HOU.iter().flat_map(|hou| laws.iter().map(move |law| (*hou, law)))
    {
        let mut hot = contact([stress, 0.0], half_space(), 0.02);
        let layer = ThirdBodyLayer::new(1e-3, 1e-3 * stiffness).unwrap();
        hot.interface.layer = Some(layer.with_yield(YieldLimit { stress, hardening }).unwrap());
        hot.interface.contact_law = *law;
        hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.6, 700.0, 0.0).unwrap());
        hot.interface.heat =
            Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
        let found = [found_by(&Method::Full, &hot, &cells(20)), solve(&hot, &cells(20))];
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
            found_by(&Method::Full, &Problem { kinematics, ..contact.clone() }, &options)
        };
        let found = at(0.3).sensitivity.unwrap().creepage_x.x;
        let step = 1e-8;
        let difference = (at(0.3 + step).force.x - at(0.3 - step).force.x) / (2.0 * step);
        println!("{limit:?}: {found} {difference}");
        assert_relative_eq!(found, difference, max_relative = 1e-3);
    }
}

/// All constants of a layer that yields are found from forces of independent points, which share
/// nothing with the solver. Cases without a layer or a limit are refused.
#[test]
fn the_constants_of_a_layer_are_fitted() {
    let parameters =
        [Parameter::LayerYieldStress, Parameter::LayerHardening, Parameter::LayerShearModulus];
    let on = |layer: Option<ThirdBodyLayer>| {
        let start = contact(LIMITS[0], Arc::new(Rigid), 0.1)
            .with_interface(|interface| interface.layer = layer);
        RollingContactModel::new(&start, &cells(40), &parameters, 0.45)
    };
    let load = contact(LIMITS[0], Arc::new(Rigid), 0.1).normal.normal_contact(None).unwrap();
    for (truth, [stress, hardening, shear_modulus]) in [
        (LIMITS[0], [3e8, 1e10, 0.5e8]),
        (LIMITS[1], [0.8e8, 0.0, 2e8]),
        (LIMITS[2], [2e8, 1e10, 0.7e8]),
    ] {
        let data = [0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8].map(|creepage_x| {
            let kinematics = rolling(creepage_x, 0.0, 0.0);
            DataPoint {
                condition: Condition { kinematics, load: None },
                component: Component::Longitudinal,
                force_ratio: -exact(truth, creepage_x) / load.summary.load,
                standard_deviation: None,
            }
        });
        let layer = ThirdBodyLayer::new(1e-3, shear_modulus).unwrap();
        let start = layer.with_yield(YieldLimit { stress, hardening }).unwrap();
        let mut model = on(Some(start)).unwrap();
        let found = fit(&mut model, &data, 50, &unwatched).unwrap();
        let [limit, slope, modulus] = [0, 1, 2].map(|k| found.estimates[k].value);
        println!("{truth:?}: {limit:.4e} {slope:.4e} {modulus:.4e} in {}", found.iterations);
        assert_eq!(found.status, Status::Converged);
        assert_relative_eq!(limit, truth[0], max_relative = 5e-3);
        assert_relative_eq!(slope, truth[1], max_relative = 1e-2, epsilon = 2e8);
        assert_relative_eq!(modulus, 1e-3 * STIFFNESS, max_relative = 5e-3);
        assert!(found.iterations < 15, "{}", found.iterations);
    }
    let message = |layer| on(layer).err().unwrap().to_string();
    assert!(message(None).contains("layer_yield_stress: there is no layer"));
    let refused = message(Some(ThirdBodyLayer::new(1e-3, 5e9).unwrap()));
    assert!(refused.contains("layer_yield_stress: the layer is elastic"), "{refused}");
}

/// A steady state goes on unchanged in time: the plastic displacement belongs to its state.
#[test]
fn marching_goes_on_from_a_steady_state_with_flow() {
    let contact = contact([1.5e8, 2e10], half_space(), 0.1);
    let options = Options { tolerance: 1e-9, ..cells(20) };
    let steady = found_by(&Method::Full, &contact, &options);
    let goes_on = Transient {
        initial_state: Some(steady.state.clone()),
        ..Transient::to_steady_state(&contact)
    };
    let marched = follow(&goes_on, &options);
    assert_relative_eq!(marched.force.x, steady.force.x, max_relative = 1e-6);
    println!("{} steps", marched.work.steps);
    let longest = steady.state.elements.iter().map(|element| element.plastic_displacement);
    assert!(longest.fold(0.0, f64::max) > 1e-4);
}

/// Methods without fields take the layer to be elastic, and say so.
#[test]
fn methods_without_fields_tell_that_they_do_not_know_the_limit() {
    let contact = contact([1e8, 0.0], half_space(), 0.1);
    for method in [FastMethod::KalkerLinear, FastMethod::ShenHedrickElkins] {
        let warnings = found_by(&Method::Fast(method.clone()), &contact, &cells(20)).warnings;
        assert!(warnings.contains(&Warning::NoYield { method: method.name() }), "{warnings:?}");
    }
    let elastic = ThirdBodyLayer::new(1e-3, 1e8).unwrap();
    let contact = contact.with_interface(|interface| interface.layer = Some(elastic));
    let warnings = found_by(&Method::Fast(FastMethod::ShenHedrickElkins), &contact, &cells(20));
    assert!(!warnings.warnings.iter().any(|warning| matches!(warning, Warning::NoYield { .. })));
}

/// Shifts forwards, back and forwards again between rigid bodies: the force is the sum of points
/// that are sheared one by one; within 0.2 % of the largest.
#[test]
fn a_layer_flows_in_shifts() {
    let [a, b] = SEMI_AXES;
    let shifts = [3.0, 2.0, -1.0, -6.0, 8.0].map(|share| share * 1e-6);
    for limit in LIMITS {
        let problem = contact(limit, Arc::new(Rigid), 0.0);
        let history = History {
            time: vec![0.0; shifts.len()],
            shift_x: Some(shifts.to_vec()),
            ..History::default()
        };
        let transient = Transient { problem, history, initial_state: None };
        let marched = march(&transient, &cells(40), &unwatched).unwrap();
        assert_eq!(marched.status, Status::Converged, "{:?}", marched.warnings);
        let mut expected = vec![0.0; shifts.len()];
        let count = 2000;
        for k in 0..count {
            // Rings of the ellipse.
            let radius = (f64::from(k) + 0.5) / f64::from(count);
            let bound = FRICTION * PEAK * (1.0 - radius * radius).sqrt();
            let area = 2.0 * std::f64::consts::PI * a * b * radius / f64::from(count);
            let (mut point, mut displacement) = (Sheared::default(), 0.0);
            for (force, shift) in expected.iter_mut().zip(shifts) {
                displacement += shift;
                *force -= point.traction(displacement, limit, bound) * area;
            }
        }
        let largest = expected.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        for (instant, expected) in marched.history.iter().zip(&expected) {
            println!("{limit:?} {} {expected}", instant.force.x);
            assert!((instant.force.x - expected).abs() < 2e-3 * largest);
        }
    }
}

/// A layer that hardens as steeply as it is stiff, on bodies that take up its growth cell by cell
/// and all together: time steps end in the steady state, with and without spin.
#[test]
fn steep_hardening_settles_in_time() {
    let bodies = [half_space(), Arc::new(Rigid)];
    for (elasticity, [x, spin]) in bodies.into_iter().zip([[4e-4, 0.0], [2e-3, 0.2]]) {
        let mut steep = problem(rolling(x, 0.0, spin));
        steep.interface.elasticity = elasticity;
        steep.interface.contact_law = ContactLaw::Coulomb;
        let thin = ThirdBodyLayer::new(10e-6, 4.6e9).unwrap();
        let limit = YieldLimit { stress: 43e6, hardening: 4e14 };
        steep.interface.layer = Some(thin.with_yield(limit).unwrap());
        let speed = steep.kinematics.speed;
        let force = |passages: f64| {
            let time = vec![0.0, passages * 2.0 * SEMI_AXES[0] / speed];
            let history = History { time, ..History::default() };
            let transient = Transient { problem: steep.clone(), history, initial_state: None };
            let found = march(&transient, &cells(16), &unwatched).unwrap();
            assert_eq!(found.status, Status::Converged, "{:?}", found.warnings);
            found.force.x
        };
        let [before, after] = [20.0, 20.0 + 1.0 / 16.0].map(force);
        assert_relative_eq!(before, after, max_relative = 1e-5);
        assert_relative_eq!(solve(&steep, &cells(16)).force.x, after, max_relative = 1e-4);
    }
}
