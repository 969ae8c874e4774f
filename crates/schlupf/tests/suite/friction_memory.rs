//! Friction that follows its law over a sliding distance.

use crate::common::{at_once, cells, from_state, half_space, problem, rolling, solve};
use approx::assert_relative_eq;
use schlupf::elasticity::Rigid;
use schlupf::interface::Incremental;
use schlupf::interface::friction::{
    Exponential, FrictionMemory, Polach, Product, SlipTerms, TemperatureLinear,
};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::problem::Element;
use schlupf::solver::march;
use schlupf::{Options, Problem, unwatched};
use std::sync::Arc;

fn remembering(problem: Problem, distance: f64, least_speed: f64) -> Problem {
    let mut remembering = problem;
    remembering.interface.friction.memory =
        Some(FrictionMemory::new(distance, least_speed).unwrap());
    remembering
}

/// Rigid bodies that slide at v0 ξ = 0.6 m/s everywhere: 2^(−2) of the fall is left.
fn sliding() -> Problem {
    let mut sliding = problem(rolling(0.02, 0.0, 0.0));
    sliding.interface.elasticity = Arc::new(Rigid);
    sliding.interface.contact_law = Incremental::new(1e9).unwrap().into();
    sliding.interface.friction.law =
        Arc::new(Exponential(SlipTerms::new(0.4, 0.2, 0.3, None).unwrap()));
    sliding
}

/// What falls with the temperature and the slip speed, at a creepage with spin.
fn hot(creepage: f64) -> Problem {
    let mut hot = problem(rolling(creepage, 0.3 * creepage, 0.2));
    hot.interface.elasticity = half_space();
    let by_heat = TemperatureLinear::new(0.4, 700.0, 0.05).unwrap();
    let polach = Polach::new(0.4, 0.4, 0.6).unwrap();
    hot.interface.friction.law =
        Arc::new(Product::new(Arc::new(by_heat), Arc::new(polach)).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    hot
}

/// Rice and Ruina 1983: at a constant slip speed μ relaxes exponentially over the distance slid,
/// which is ξ times the distance from the leading edge: μ = μ_s + (μ0 − μ_s) e^(−ξ (x_e − x)/d_c).
/// In every cell, and so in the force, with μ_s = 0.2 + 0.2/4 by hand.
#[test]
fn rice_ruina_1983_constant_slip_speed() {
    let distance = 4e-5;
    let solution = at_once(&remembering(sliding(), distance, 0.0), &cells(24));
    let (a, b) = (6e-3, 5e-3);
    let (fields, grid) = (&solution.fields, &solution.state.grid);
    for k in 0..fields.x.len() {
        let edge = a * (1.0 - (fields.y[k] / b).powi(2)).max(0.0).sqrt();
        let is_cut = edge - fields.x[k].abs() < grid.spacing_x || fields.y[k].abs() > 0.8 * b;
        if !is_cut {
            let slid = 0.02 * (edge - fields.x[k]);
            let expected = 0.25 + 0.15 * (-slid / distance).exp();
            let error = (fields.friction_coefficient[k] - expected).abs();
            // The mean leading edge of a strip is not quite that of its middle.
            assert!(error < 2e-3, "{k}: {} {expected}", fields.friction_coefficient[k]);
        }
    }
    // ∫ p μ dA over the ellipse, by a midpoint sum in strips.
    let (mut force, mut load) = (0.0, 0.0);
    let n = 400;
    for j in 0..n {
        let y = -1.0 + (2.0 * f64::from(j) + 1.0) / f64::from(n);
        let half = (1.0 - y * y).sqrt();
        for i in 0..n {
            let x = half * (-1.0 + (2.0 * f64::from(i) + 1.0) / f64::from(n));
            let share = half * (1.0 - x * x - y * y).max(0.0).sqrt();
            let slid = 0.02 * a * (half - x);
            load += share;
            force += share * (0.25 + 0.15 * (-slid / distance).exp());
        }
    }
    assert_relative_eq!(solution.traction_coefficient, force / load, max_relative = 1e-3);
}

/// A short memory is none, and a long one is friction that does not change on the way.
#[test]
fn short_and_long_memories() {
    let options = cells(16);
    let force = |problem: &Problem| at_once(problem, &options).traction_coefficient;
    assert_relative_eq!(force(&remembering(sliding(), 1e-9, 0.0)), 0.25, max_relative = 1e-6);
    assert_relative_eq!(force(&remembering(sliding(), 1e2, 0.0)), 0.4, max_relative = 1e-5);
    for creepage in [0.002, 0.02] {
        let (short, none) = (remembering(hot(creepage), 1e-12, 1e-3), hot(creepage));
        assert_relative_eq!(force(&short), force(&none), max_relative = 1e-5);
    }
    // Far below the least speed it relaxes over a time.
    let slow = remembering(sliding(), 4e-5, 6.0);
    let as_fast = remembering(sliding(), 4e-6, 0.0);
    assert_relative_eq!(force(&slow), force(&as_fast), max_relative = 1e-9);
}

/// Steady and marched solve the same discrete equations.
#[test]
fn the_steady_state_is_the_end_of_marching() {
    for creepage in [0.002, 0.02] {
        for distance in [5e-6, 5e-5] {
            let hot = remembering(hot(creepage), distance, 1e-3);
            let options = Options { tolerance: 1e-8, ..cells(16) };
            let (steady, marched) = (at_once(&hot, &options), solve(&hot, &options));
            assert!(steady.work.operator_products < 60.0, "{:?}", steady.work);
            assert_relative_eq!(steady.force.x, marched.force.x, max_relative = 1e-6);
            assert_relative_eq!(steady.force.y, marched.force.y, max_relative = 1e-6);
            let (one, two) =
                (steady.temperature.unwrap().max_rise, marched.temperature.unwrap().max_rise);
            assert_relative_eq!(one, two, max_relative = 1e-6);
        }
    }
}

/// A march goes on from a steady state without a change: the state holds what friction remembers.
#[test]
fn a_state_remembers_its_friction() {
    let hot = remembering(hot(0.02), 5e-5, 1e-3);
    let steady = at_once(&hot, &Options { tolerance: 1e-8, ..cells(16) });
    let on = march(&from_state(&hot, steady.state.clone()), &cells(16), &unwatched).unwrap();
    for instant in &on.history {
        assert_relative_eq!(instant.force.x, steady.force.x, max_relative = 1e-6);
    }
}

/// A state that cannot be is refused, and does not keep a march busy for ever.
#[test]
fn an_impossible_state_is_refused() {
    let hot = remembering(hot(0.02), 5e-5, 1e-3);
    let state = at_once(&hot, &cells(12)).state;
    let spoilt: [fn(&mut Element); 4] = [
        |element| element.heat[0].duration = -1.0,
        |element| element.heat[0].flux = f64::NAN,
        |element| element.friction_on_leaving = Some(-5.0),
        |element| element.slip_speed = -1e300,
    ];
    for spoil in spoilt {
        let mut state = state.clone();
        spoil(&mut state.elements[20]);
        let spoilt = from_state(&hot, state);
        let error = march(&spoilt, &cells(12), &unwatched).unwrap_err().to_string();
        assert!(error.contains("initial_state"), "{error}");
    }
}
