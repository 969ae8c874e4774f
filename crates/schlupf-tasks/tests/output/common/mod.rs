//! A made-up solution: an ellipse of Hertz whose strips slide like Carter's (1926).

#![allow(dead_code, reason = "each test file uses its part of it")]

use schlupf::bodies::{Kinematics, ReferencePoint};
use schlupf::normal::{Extent, Grid, NormalSummary};
use schlupf::problem::State;
use schlupf::solution::{
    Area, Fields, Instant, Power, Resultant, Sensitivity, Solution, Strategy, TGamma, Temperature,
    Work,
};
use schlupf::{Method, Status};

pub const FRICTION: f64 = 0.4;
const PEAK: f64 = 770e6;

/// How the made-up solution looks.
#[derive(Debug, Clone, Copy)]
pub struct Recipe {
    pub semi_axes: [f64; 2],
    pub cells: usize,
    /// Direction of sliding, in rad.
    pub direction: f64,
    /// Share of each chord that sticks.
    pub stick: f64,
}

pub const RECIPE: Recipe =
    Recipe { semi_axes: [5.88e-3, 10.54e-3], cells: 24, direction: 0.0, stick: 0.4 };

pub fn solution(recipe: Recipe) -> Solution {
    let [a, b] = recipe.semi_axes;
    let extent = Extent { x: [-a, a], y: [-b, b] };
    let grid = Grid::across(&extent, recipe.cells, recipe.cells);
    let mut fields = Fields { grid, ..Fields::default() };
    for row in 0..grid.rows {
        for column in (0..grid.columns).rev() {
            push_cell(&mut fields, recipe, [column, row]);
        }
    }
    let load = 2.0 / 3.0 * std::f64::consts::PI * a * b * PEAK;
    let sum = |field: &[f64]| field.iter().sum::<f64>() * grid.cell_area();
    let force = Resultant::new(sum(&fields.traction_x), sum(&fields.traction_y), 3.0);
    let scale = FRICTION * load;
    let hottest = fields.temperature_rise_wheel.iter().copied().fold(0.0, f64::max);
    Solution {
        method: Method::Full,
        status: Status::Converged,
        residual: 3.2e-7,
        normal: NormalSummary {
            origin: None,
            parts: 1,
            load,
            semi_axis_x: a,
            semi_axis_y: b,
            peak_pressure: PEAK,
            approach: Some(7.65e-5),
        },
        reference: ReferencePoint::Patch,
        kinematics: kinematics(recipe),
        force,
        normalised: Resultant::new(force.x / scale, force.y / scale, 0.01),
        traction_coefficient: force.x.hypot(force.y) / load,
        power: Some(Power {
            friction: sum(&fields.friction_power),
            creep: 6.1e3,
            returned: 1.2,
            into_wheel: 3e3,
            into_rail: 3.1e3,
            exchanged: Some(0.0),
        }),
        t_gamma: TGamma { without_spin: 210.0, with_spin: Some(210.0), rows: [0.0; 2] },
        temperature: Some(Temperature {
            max_rise: hottest,
            max_rise_wheel: hottest,
            max_rise_rail: hottest,
            max_wheel: 20.0 + hottest,
            max_rail: 20.0 + hottest,
            x: -a,
            y: 0.0,
        }),
        peclet: [2.5e3, 2.6e3],
        area: Area { contact: 194.7e-6, stick: Some(60e-6), slip: Some(134.7e-6) },
        field_history: Vec::new(),
        history: history(recipe, force, hottest),
        extrapolation: None,
        sensitivity: Some(Sensitivity {
            creepage_x: Resultant::new(-2.5e6, 1e3, -3.0),
            load: None,
            friction_coefficient: Resultant::new(-1.2e4, 0.0, 0.0),
            ..Sensitivity::default()
        }),
        warnings: Vec::new(),
        work: Work {
            strategy: Some(Strategy::March),
            newton_iterations: 97,
            operator_products: 512.5,
            sensitivity_products: 96,
            outer_iterations: 40,
            steps: 40,
            cells: fields.len(),
        },
        state: State { grid, time: 0.0, elements: Vec::new(), motion: None },
        fields,
    }
}

fn kinematics(recipe: Recipe) -> Kinematics {
    let slip = 0.008;
    Kinematics {
        creepage_x: slip * recipe.direction.cos(),
        creepage_y: slip * recipe.direction.sin(),
        ..Kinematics::free_rolling(30.0)
    }
}

/// One cell by 8 × 8 points, or nothing outside the ellipse.
fn push_cell(fields: &mut Fields, recipe: Recipe, [column, row]: [usize; 2]) {
    const POINTS: usize = 8;
    let grid = fields.grid;
    let mut sum = [0.0; 6];
    for point in 0..POINTS * POINTS {
        let u = ((point % POINTS) as f64 + 0.5) / POINTS as f64;
        let v = ((point / POINTS) as f64 + 0.5) / POINTS as f64;
        let x = grid.edge_x(column) + u * grid.spacing_x;
        let y = grid.edge_y(row) + v * grid.spacing_y;
        if let Some([pressure, traction, slip]) = strip(recipe, [x, y]) {
            let values = [1.0, x, y, pressure, traction, slip];
            sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
    }
    let [inside, x, y, pressure, traction, slip] = sum;
    if inside == 0.0 {
        return;
    }
    let all = (POINTS * POINTS) as f64;
    let [along, across] = [recipe.direction.cos(), recipe.direction.sin()];
    let [pressure, traction, slip] = [pressure / all, traction / all, slip / inside];
    let ahead = recipe.semi_axes[0] - x / inside;
    fields.cell.push([column, row]);
    fields.x.push(x / inside);
    fields.y.push(y / inside);
    fields.covered.push(inside / all);
    fields.pressure.push(pressure);
    fields.traction_x.push(-traction * along);
    fields.traction_y.push(-traction * across);
    fields.displacement_x.push(-1e-5 * along);
    fields.displacement_y.push(-1e-5 * across);
    fields.slip_x.push(slip * along);
    fields.slip_y.push(slip * across);
    fields.friction_coefficient.push(FRICTION);
    fields.friction_power.push(traction * slip);
    fields.temperature_rise_wheel.push(slip * 700.0 * ahead.sqrt());
    fields.temperature_rise_rail.push(slip * 700.0 * ahead.sqrt());
    fields.sliding.push(traction >= 0.95 * FRICTION * pressure);
}

/// Pressure, traction on the rail and slip speed at a point.
fn strip(recipe: Recipe, [x, y]: [f64; 2]) -> Option<[f64; 3]> {
    let [a, b] = recipe.semi_axes;
    let chord = 1.0 - (y / b).powi(2);
    let shape = chord - (x / a).powi(2);
    if shape <= 0.0 {
        return None;
    }
    let half = a * chord.sqrt();
    let half_stick = recipe.stick * a - (a - half);
    let pressure = PEAK * shape.sqrt();
    let from_middle = x - (half - half_stick.max(0.0));
    let inner = (half_stick.max(0.0).powi(2) - from_middle.powi(2)).max(0.0).sqrt() / a;
    let behind = (half - 2.0 * half_stick.max(0.0) - x).max(0.0);
    Some([pressure, FRICTION * (pressure - PEAK * inner), 0.24 * (behind / (2.0 * a)).sqrt()])
}

fn history(recipe: Recipe, force: Resultant, hottest: f64) -> Vec<Instant> {
    (1..=40)
        .map(|step| {
            let time = f64::from(step) * 1.6e-5;
            let grown = 1.0 - (-f64::from(step) / 6.0).exp();
            Instant {
                time,
                distance: kinematics(recipe).speed * time,
                kinematics: kinematics(recipe),
                shift: None,
                load: 80e3,
                force: Resultant::new(force.x * grown, force.y * grown, grown),
                friction_power: Some(5e3 * grown),
                creep_power: Some(5e3 * grown),
                stored_energy: Some(1e-2 * grown),
                max_rise: Some(hottest * grown),
                newton_iterations: 3,
                residual: 1e-8,
            }
        })
        .collect()
}
