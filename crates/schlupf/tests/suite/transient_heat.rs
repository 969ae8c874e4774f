//! Marching carries the heat that each element has received: what is switched on heats from then
//! on.
//!
//! Set-up: rigid bodies, uniform slip, Coulomb friction; the creepage jumps from zero to 1/30 (or
//! back) while the wheel rolls. All elements then slide with 1 m/s from that instant on, and each
//! carries its own transient.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::{cells, follow, problem, rolling};
use approx::assert_relative_eq;
use schlupf::bodies::Material;
use schlupf::elasticity::Rigid;
use schlupf::interface::Incremental;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::{Ellipse, PressureSource, PressureTable, Tabulated};
use schlupf::problem::History;
use schlupf::{Solution, Transient};

const SPEED: f64 = 30.0;
const FRICTION: f64 = 0.3;
/// A sliding of 1 m/s.
const CREEPAGE: f64 = 1.0 / 30.0;

/// Rigid bodies that begin, or cease, to slide with 1 m/s at an instant (in s), some time before
/// the end.
fn switched(
    normal: Arc<dyn PressureSource>,
    [from, to]: [f64; 2],
    [instant, end]: [f64; 2],
) -> Transient {
    let mut switched = problem(rolling(0.0, 0.0, 0.0));
    switched.normal = normal;
    switched.interface.elasticity = Arc::new(Rigid);
    switched.interface.contact_law = Incremental::new(1e9).unwrap().into();
    switched.interface.friction.law = Arc::new(Constant::new(FRICTION).unwrap());
    switched.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    let history = History {
        time: vec![0.0, instant, instant * (1.0 + 1e-9), end],
        creepage_x: Some(vec![from, from, to, to]),
        ..History::default()
    };
    Transient { history, ..Transient::to_steady_state(&switched) }
}

/// Whole cells of a row next to y = 0, from the leading edge on.
fn middle_row(solution: &Solution) -> Vec<usize> {
    let fields = &solution.fields;
    let middle = fields.grid.rows / 2;
    (0..fields.len())
        .filter(|k| fields.cell[*k][1] == middle && fields.covered[*k] > 1.0 - 1e-9)
        .collect()
}

const ALONG: usize = 40;
const PRESSURE: f64 = 800e6;

/// Uniform pressure on a rectangle, its length, and how long a time step lasts on it.
fn uniform_pressure() -> (Arc<dyn PressureSource>, f64, f64) {
    let axis: Vec<f64> = (-20..=20).map(|k| 6e-3 * f64::from(k) / 20.0).collect();
    let table = PressureTable::new(&axis, &axis, vec![PRESSURE; axis.len() * axis.len()]).unwrap();
    let normal = Arc::new(Tabulated::new(table, None).unwrap());
    let [from, to] = normal.normal_contact(None).unwrap().extent().x;
    (normal, to - from, (to - from) / ALONG as f64 / SPEED)
}

/// The solution a number of time steps after the creepage has changed, and how long ago (in s) that
/// was. An element passes its cell from half a step before an instant until half a step after it,
/// and heats up with the slip of the instant: so the change counts from the middle of its step on.
fn after_switching(
    (normal, step): (&Arc<dyn PressureSource>, f64),
    creepage: [f64; 2],
    (steps, along): (u32, usize),
) -> (Solution, f64) {
    const BEFORE: f64 = 49.0;
    let instant = (BEFORE + 0.49) * step;
    let end = (BEFORE + f64::from(steps)) * step;
    let problem = switched(Arc::clone(normal), creepage, [instant, end]);
    (follow(&problem, &cells(along)), (f64::from(steps) - 0.5) * step)
}

/// Carslaw and Jaeger 1959, §2.9 (7): a constant source q switched on at t = 0 heats a surface to
/// 2q√(t/π)/β. Under uniform pressure every element that was in contact then has the same
/// temperature wherever it is; those that have come since are as hot as in steady sliding, q having
/// acted from the leading edge on.
#[test]
fn carslaw_jaeger_1959_constant_source_switched_on() {
    let (normal, length, step) = uniform_pressure();
    let scale = 2.0 * 0.5 * FRICTION * PRESSURE / (PI.sqrt() * Material::STEEL.effusivity());
    for steps in [1, 5, 15, 30] {
        let (solution, since_switch) =
            after_switching((&normal, step), [0.0, CREEPAGE], (steps, ALONG));
        let rises = &solution.fields.temperature_rise_wheel;
        let mut earlier = 0;
        for k in middle_row(&solution) {
            let since_entry = (0.5 * length - solution.fields.x[k]) / SPEED;
            let exact = scale * since_entry.min(since_switch).sqrt();
            assert_relative_eq!(rises[k], exact, max_relative = 1e-9);
            earlier += usize::from(since_entry > since_switch + 0.1 * step);
        }
        assert_eq!(earlier, ALONG - steps as usize);
        let last = *middle_row(&solution).last().unwrap();
        let steady = scale * ((length - 0.5 * step * SPEED) / SPEED).sqrt();
        assert!(rises[last] < 0.9 * steady, "the steady formula: {} {steady}", rises[last]);
    }
}

/// The same source switched off: what had slid for a time t₁ cools as 2q(√(t₁ + t) − √t)/(β√π);
/// what comes later stays cold.
#[test]
fn carslaw_jaeger_1959_constant_source_switched_off() {
    let (normal, length, step) = uniform_pressure();
    let scale = 2.0 * 0.5 * FRICTION * PRESSURE / (PI.sqrt() * Material::STEEL.effusivity());
    for steps in [1, 10, 25] {
        let (solution, since_switch) =
            after_switching((&normal, step), [CREEPAGE, 0.0], (steps, ALONG));
        for k in middle_row(&solution) {
            let since_entry = (0.5 * length - solution.fields.x[k]) / SPEED;
            let exact = scale * (since_entry.max(since_switch).sqrt() - since_switch.sqrt());
            let rise = solution.fields.temperature_rise_rail[k];
            assert_relative_eq!(rise, exact, max_relative = 1e-9, epsilon = 1e-6);
        }
    }
}

/// Knothe and Liebelt 1995, transient: under Hertz's pressure an element at x has received μ p₀ w
/// √(1 − x'²/a²) on its way from x' = min(x_e, x + v t) on, t since the switch. Duhamel's integral
/// over that way, by a midpoint rule in √(x' − x), to 0.5 % of the largest rise in the whole cells
/// of a grid of 40, and half of that on 80.
#[test]
fn knothe_liebelt_1995_transient_under_hertz() {
    const NODES: u32 = 20_000;
    let (a, b, peak) = (5.88e-3, 10.54e-3, 770.4e6);
    let normal: Arc<dyn PressureSource> =
        Arc::new(Ellipse::from_peak_pressure(a, b, peak).unwrap());
    for (steps, along, allowed) in
        [(8, 40, 5e-3), (24, 40, 5e-3), (16, 80, 2.5e-3), (48, 80, 2.5e-3)]
    {
        let step = 2.0 * a / along as f64 / SPEED;
        let (solution, since_switch) =
            after_switching((&normal, step), [0.0, CREEPAGE], (steps, along));
        let fields = &solution.fields;
        let exact = |k: usize| {
            let (x, chord) = (fields.x[k], 1.0 - (fields.y[k] / b).powi(2));
            let way = (a * chord.sqrt() - x).min(SPEED * since_switch);
            let width = way.sqrt() / f64::from(NODES);
            let shape = |n: u32| {
                let root = (f64::from(n) + 0.5) * width;
                (chord - ((x + root * root) / a).powi(2)).max(0.0).sqrt()
            };
            let sum: f64 = (0..NODES).map(shape).sum();
            let flux = 0.5 * FRICTION * peak;
            2.0 * flux * sum * width / (Material::STEEL.effusivity() * (PI * SPEED).sqrt())
        };
        let row = middle_row(&solution);
        let largest = row.iter().map(|k| exact(*k)).fold(0.0, f64::max);
        let error = |k: &usize| (fields.temperature_rise_wheel[*k] - exact(*k)).abs();
        let worst = row.iter().map(error).fold(0.0, f64::max) / largest;
        println!("{steps} steps on {along} cells: {worst}");
        assert!(worst < allowed, "{steps} steps on {along} cells: {worst}");
    }
}
