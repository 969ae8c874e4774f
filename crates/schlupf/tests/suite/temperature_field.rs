//! Temperatures below the surface and behind the contact.

use crate::common::{self, cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::analysis::temperature_field::{Side, TemperatureField};
use schlupf::bodies::{Body, Material};
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::{Problem, Solution, Status, unwatched};
use std::f64::consts::FRAC_2_PI;
use std::sync::Arc;

/// Sliding on the half-space with friction that falls with the temperature.
fn hot(partition: Partition) -> Problem {
    let mut hot = problem(rolling(0.02, 0.002, 0.0));
    hot.interface.elasticity = half_space();
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition };
    hot
}

fn solve(problem: &Problem) -> (Solution, TemperatureField) {
    let solution = schlupf::solver::solve(problem, &cells(40), &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged);
    let field = TemperatureField::new(problem, &solution).unwrap();
    (solution, field)
}

/// ∫ ρc (T − T_bulk) dz below a point, in J/m².
fn stored(field: &TemperatureField, side: Side, body: &Body, [x, y]: [f64; 2]) -> f64 {
    const DEPTH: f64 = 3e-3;
    const LAYERS: u32 = 6_000;
    let layer = DEPTH / f64::from(LAYERS);
    let rise = |k: u32| field.at(side, x, y, (f64::from(k) + 0.5) * layer) - body.bulk_temperature;
    let capacity = body.material.density * body.material.specific_heat;
    capacity * layer * (0..LAYERS).map(rise).sum::<f64>()
}

/// On the surface in the contact the field is the temperature of the cells, for both bodies, with
/// different bulk temperatures.
#[test]
fn the_surface_is_that_of_the_cells() {
    let mut warm = hot(Partition::Velocity);
    warm.interface.wheel.bulk_temperature = 140.0;
    warm.interface.rail.material = Material { conductivity: 30.0, ..Material::STEEL };
    let (solution, field) = solve(&warm);
    let fields = &solution.fields;
    let largest = fields.temperature_rise_rail.iter().copied().fold(0.0, f64::max);
    for k in (0..fields.len()).filter(|k| fields.covered[*k] == 1.0) {
        let (x, y) = (fields.x[k], fields.y[k]);
        let wheel = field.at(Side::Wheel, x, y, 0.0) - 140.0;
        let rail = field.at(Side::Rail, x, y, 0.0) - 20.0;
        assert!((wheel - fields.temperature_rise_wheel[k]).abs() < 0.01 * largest, "{x} {y}");
        assert!((rail - fields.temperature_rise_rail[k]).abs() < 0.01 * largest, "{x} {y}");
    }
}

/// What is stored below a point is what it has received: in the contact, at its end, and behind it,
/// where it spreads but stays.
#[test]
fn heat_is_conserved() {
    let (solution, field) = solve(&hot(Partition::Given(0.3)));
    let y = 0.1e-3;
    let row = |k: &usize| (solution.fields.y[*k] - y).abs() < 0.13e-3;
    let cells: Vec<usize> = (0..solution.fields.len()).filter(row).collect();
    let last = *cells.last().unwrap();
    let heat = &solution.state.elements[last].heat;
    let received: f64 = heat.iter().map(|step| step.flux * step.duration).sum();
    for x in [-6.01e-3, -9e-3, -20e-3] {
        let wheel = stored(&field, Side::Wheel, &Body::STEEL, [x, y]);
        let rail = stored(&field, Side::Rail, &Body::STEEL, [x, y]);
        assert_relative_eq!(wheel, 0.3 * received, max_relative = 2e-3);
        assert_relative_eq!(rail, 0.7 * received, max_relative = 2e-3);
    }
    let ahead = field.at(Side::Wheel, 7e-3, 0.0, 0.0);
    assert_eq!(ahead, Body::STEEL.bulk_temperature);
    // With equal heat the body that has more of it is hotter, deeper down it is colder.
    let at = |side, depth| field.at(side, -6e-3, y, depth);
    assert!(at(Side::Rail, 0.0) > at(Side::Wheel, 0.0));
    assert!(at(Side::Rail, 0.0) > at(Side::Rail, 20e-6));
}

/// Heat that both bodies carry away from the contact every second, in W: what is stored below the
/// wake, times the speed of the material and the width of its strip.
fn carried_away(problem: &Problem, solution: &Solution, field: &TemperatureField) -> [f64; 2] {
    const LAYER: f64 = 4e-6;
    const LAYERS: u32 = 300;
    let grid = solution.state.grid;
    let conduction = problem.interface.conduction(&solution.kinematics);
    let speeds = conduction.contact_times().map(|time| 30.0 / time);
    let bodies = [(Side::Wheel, problem.interface.wheel), (Side::Rail, problem.interface.rail)];
    [0, 1].map(|k| {
        let (side, body) = bodies[k];
        let capacity = body.material.density * body.material.specific_heat;
        let rise = |y: f64, layer: u32| {
            let depth = (f64::from(layer) + 0.5) * LAYER;
            field.at(side, -6.1e-3, y, depth) - body.bulk_temperature
        };
        let below = |j: usize| (0..LAYERS).map(|layer| rise(grid.y(j), layer)).sum::<f64>();
        let sum: f64 = (0..grid.rows).map(below).sum();
        capacity * LAYER * sum * speeds[k] * grid.spacing_y
    })
}

/// Energy: the heat that wheel and rail carry away is the friction power, each body its part; and
/// where they meet with different temperatures, what one loses the other gains (Ertz and Knothe
/// 2002).
#[test]
fn wheel_and_rail_carry_away_the_friction_power() {
    for (partition, bulk) in [
        (Partition::Given(0.3), 20.0),
        (Partition::Velocity, 20.0),
        (Partition::Velocity, 120.0),
        (Partition::Given(0.5), 120.0),
    ] {
        let mut sliding = hot(partition.clone());
        sliding.interface.rail.material = Material { conductivity: 40.0, ..Material::STEEL };
        sliding.interface.wheel.bulk_temperature = bulk;
        let (solution, field) = solve(&sliding);
        let [wheel, rail] = carried_away(&sliding, &solution, &field);
        let power = solution.power.unwrap();
        assert_relative_eq!(power.into_wheel + power.into_rail, power.friction + power.returned);
        assert_relative_eq!(power.friction, power.creep, max_relative = 1e-5);
        println!("{partition:?} {bulk}: {wheel} {rail} {power:?}");
        assert_relative_eq!(wheel + rail, power.friction, max_relative = 2e-3);
        let exchanged = power.into_wheel - wheel;
        if bulk == 20.0 {
            assert!(exchanged.abs() < 2e-3 * power.friction, "{exchanged}");
        } else {
            // 2 β_w (T_w − T_m) ∫ √(v_w L/π) dy, ∫ √L dy = √(2a) b B(½, 5/4) on the ellipse.
            let conduction = sliding.interface.conduction(&solution.kinematics);
            let beta = 1.772_453_850_905_516 * 0.906_402_477_055_477 / 0.919_062_526_848_883;
            let width = (2.0 * 6e-3_f64).sqrt() * 5e-3 * beta;
            let root = (30.0 / conduction.contact_times()[0] / std::f64::consts::PI).sqrt();
            let step = bulk - conduction.entry_temperature;
            let exact = 2.0 * sliding.interface.wheel.material.effusivity() * step * root * width;
            assert_relative_eq!(exchanged, exact, max_relative = 5e-3);
        }
    }
}

/// Rail chill: a hot wheel that rolls without sliding gives the rail what it loses, meets it at the
/// mean temperature, and behind the contact the surface goes back to its own bulk temperature as
/// (2/π) asin √(t_c/t).
#[test]
fn a_hot_wheel_on_a_cold_rail() {
    let mut chill = hot(Partition::Given(0.5));
    chill.kinematics = rolling(0.0, 0.0, 0.0);
    chill.interface.wheel.bulk_temperature = 150.0;
    chill.interface.rail.bulk_temperature = 0.0;
    chill.interface.friction.reference_temperature = 0.0;
    let (_, field) = solve(&chill);
    let y = 0.1e-3;
    assert_relative_eq!(field.at(Side::Wheel, 0.0, y, 0.0), 75.0, max_relative = 1e-12);
    assert_relative_eq!(field.at(Side::Rail, -5e-3, y, 0.0), 75.0, max_relative = 1e-12);
    let [wheel, rail] = [(Side::Wheel, chill.interface.wheel), (Side::Rail, chill.interface.rail)]
        .map(|(side, body)| stored(&field, side, &body, [-8e-3, y]));
    assert_relative_eq!(wheel, -rail, max_relative = 1e-9);
    // ∫ ΔT β/√(πt) dt = 2 ΔT β √(t_c/π) in the contact of 12 mm at 30 m/s.
    let time: f64 = 12e-3 / 30.0;
    let exchanged =
        2.0 * 75.0 * Material::STEEL.effusivity() * (time / std::f64::consts::PI).sqrt();
    assert_relative_eq!(rail, exchanged, max_relative = 3e-3);
    let behind = field.at(Side::Rail, -18e-3, y, 0.0);
    assert_relative_eq!(behind, 75.0 * FRAC_2_PI * 0.5_f64.sqrt().asin(), max_relative = 2e-3);
    assert!(field.at(Side::Rail, -1.0, y, 0.0) < 0.08 * 75.0);
}

/// What the field spans is told.
#[test]
fn the_line_of_a_point_has_its_edges() {
    let problem = hot(Partition::Given(0.5));
    let (_, field) = solve(&problem);
    let [low, high] = field.width();
    assert_relative_eq!(low, -5e-3, max_relative = 1e-9);
    assert_relative_eq!(high, 5e-3, max_relative = 1e-9);
    let middle = field.passages(0.1e-3);
    assert_eq!(middle.len(), 1);
    assert_relative_eq!(middle[0][0], 6e-3, max_relative = 2e-3);
    assert_relative_eq!(middle[0][1], -6e-3, max_relative = 2e-3);
    assert!(field.passages(6e-3).is_empty());
    let mut cold = problem;
    cold.interface.heat.model = None;
    let marched = common::solve(&cold, &cells(12));
    let field = TemperatureField::new(&cold, &marched).unwrap();
    assert_eq!(field.at(Side::Rail, -5e-3, 0.1e-3, 0.0), 20.0);
}
