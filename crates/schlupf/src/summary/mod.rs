//! From the fields of an instant to forces, powers and everything else that is reported.

pub(crate) mod snapshot;

use crate::kinematics::{Kinematics, ReferencePoint};
use crate::method::Method;
use crate::normal::NormalSummary;
use crate::patch::Patch;
use crate::problem::{Options, Problem};
use crate::solution::{
    Area, Fields, Instant, Power, Resultant, Sensitivity, Solution, Status, TGamma, Temperature,
    Work,
};
use crate::state::State;

use snapshot::Snapshot;

/// What a driver knows beside the fields.
pub(crate) struct Account {
    pub method: Method,
    pub status: Status,
    /// Relative residual, dimensionless.
    pub residual: f64,
    pub history: Vec<Instant>,
    pub warnings: Vec<String>,
    pub sensitivity: Option<Sensitivity>,
    pub work: Work,
    pub state: State,
}

/// All results of an instant.
pub(crate) fn solution(
    problem: &Problem,
    options: &Options,
    (normal, patch, now): (&NormalSummary, &Patch, &Snapshot),
    account: Account,
) -> Solution {
    let force = force(patch, now);
    Solution {
        method: account.method,
        status: account.status,
        residual: account.residual,
        normal: *normal,
        reference: ReferencePoint::Patch,
        kinematics: now.kinematics,
        force,
        normalised: normalised(problem, normal, &force),
        traction_coefficient: force.x.hypot(force.y) / normal.load,
        power: power(patch, now, &force),
        t_gamma: t_gamma(&now.kinematics, &force),
        temperature: temperature(patch, now),
        area: area(patch, now, options.slip_threshold),
        fields: fields(patch, now, options.slip_threshold),
        history: account.history,
        warnings: account.warnings,
        sensitivity: account.sensitivity,
        work: account.work,
        state: account.state,
    }
}

/// F/(μ0 N) and Mz/(μ0 N √(ab)), dimensionless.
pub(crate) fn normalised(
    problem: &Problem,
    normal: &NormalSummary,
    force: &Resultant,
) -> Resultant {
    let limit = problem.friction.cold_coefficient() * normal.load;
    let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
    Resultant { x: force.x / limit, y: force.y / limit, moment_z: force.moment_z / (limit * lever) }
}

/// Forces and moment on the wheel.
pub(crate) fn force(patch: &Patch, now: &Snapshot) -> Resultant {
    resultant(patch, &now.traction)
}

/// Forces and moment on the wheel of a traction on the rail.
pub(crate) fn resultant(patch: &Patch, traction: &[f64]) -> Resultant {
    let area = patch.grid.cell_area();
    let mut sum = Resultant::default();
    for (k, cell) in patch.cells.iter().enumerate() {
        let [px, py] = [traction[2 * k], traction[2 * k + 1]];
        sum.x -= px * area;
        sum.y -= py * area;
        sum.moment_z -= (cell.x * py - cell.y * px) * area;
    }
    sum
}

pub(crate) fn power(patch: &Patch, now: &Snapshot, force: &Resultant) -> Power {
    let area = patch.grid.cell_area();
    let friction = now.friction_power.iter().sum::<f64>() * area + now.departed_power;
    let returned = now.friction_power.iter().map(|q| (-q).max(0.0)).sum::<f64>() * area;
    let [into_wheel, into_rail] =
        now.conduction.shares().map(|share| share * (friction + returned));
    let creep = now.creep_power.unwrap_or_else(|| creep_power(&now.kinematics, force));
    Power { friction, creep, returned, into_wheel, into_rail }
}

/// What is kept of an instant at a time (in s) and after a distance (in m).
pub(crate) fn instant(
    (normal, patch, now): (&NormalSummary, &Patch, &Snapshot),
    [time, distance]: [f64; 2],
    (newton_iterations, residual): (usize, f64),
) -> Instant {
    let force = force(patch, now);
    let power = power(patch, now, &force);
    Instant {
        time,
        distance,
        kinematics: now.kinematics,
        load: normal.load,
        force,
        friction_power: power.friction,
        creep_power: power.creep,
        stored_energy: now.stored_energy,
        max_rise: temperature(patch, now).max_rise,
        newton_iterations,
        residual,
    }
}

/// −v0 (ξ Fx + η Fy + φ Mz), in W. Without spin the moment does not count, not even an unknown one.
pub(crate) fn creep_power(motion: &Kinematics, force: &Resultant) -> f64 {
    let turning = if motion.spin == 0.0 { 0.0 } else { motion.spin * force.moment_z };
    -motion.speed * (motion.creepage_x * force.x + motion.creepage_y * force.y + turning)
}

pub(crate) fn t_gamma(motion: &Kinematics, force: &Resultant) -> TGamma {
    let without_spin = (motion.creepage_x * force.x).abs() + (motion.creepage_y * force.y).abs();
    let turning = if motion.spin == 0.0 { 0.0 } else { (motion.spin * force.moment_z).abs() };
    TGamma { without_spin, with_spin: without_spin + turning }
}

/// Largest temperatures, in the cells and at the trailing edges.
pub(crate) fn temperature(patch: &Patch, now: &Snapshot) -> Temperature {
    let cells = patch.cells.iter().zip(&now.rise).map(|(cell, rise)| (*rise, cell.x, cell.y));
    let exits = patch
        .strips
        .iter()
        .zip(&now.exit_rise)
        .map(|(strip, rise)| (*rise, patch.exit(strip), patch.cells[strip.cells.end - 1].y));
    let hottest = cells.chain(exits).reduce(|p, q| if q.0 > p.0 { q } else { p });
    let Some((rise, x, y)) = hottest else {
        return Temperature::default();
    };
    let [rise_wheel, rise_rail] = now.conduction.rises(rise);
    let [wheel, rail] = now.conduction.surface_temperatures(rise);
    Temperature {
        max_rise: rise_wheel.max(rise_rail),
        max_rise_wheel: rise_wheel,
        max_rise_rail: rise_rail,
        max_wheel: wheel,
        max_rail: rail,
        x,
        y,
    }
}

fn is_sliding(patch: &Patch, now: &Snapshot, k: usize, threshold: f64) -> bool {
    let [px, py] = now.traction_at(k);
    px.hypot(py) >= threshold * now.friction[k] * patch.cells[k].pressure
}

fn area(patch: &Patch, now: &Snapshot, threshold: f64) -> Area {
    let mut area = Area::default();
    for (k, cell) in patch.cells.iter().enumerate() {
        let covered = cell.covered * patch.grid.cell_area();
        area.contact += covered;
        if is_sliding(patch, now, k, threshold) {
            area.slip += covered;
        } else {
            area.stick += covered;
        }
    }
    area
}

fn fields(patch: &Patch, now: &Snapshot, threshold: f64) -> Fields {
    let grid = patch.grid;
    let cells = &patch.cells;
    let component = |values: &[f64], c: usize, sign: f64| -> Vec<f64> {
        values.iter().skip(c).step_by(2).map(|v| sign * v).collect()
    };
    let rises: Vec<[f64; 2]> = now.rise.iter().map(|r| now.conduction.rises(*r)).collect();
    Fields {
        grid,
        cell: cells.iter().map(|c| [c.index % grid.columns, c.index / grid.columns]).collect(),
        x: cells.iter().map(|c| c.x).collect(),
        y: cells.iter().map(|c| c.y).collect(),
        covered: cells.iter().map(|c| c.covered).collect(),
        pressure: cells.iter().map(|c| c.pressure).collect(),
        traction_x: component(&now.traction, 0, -1.0),
        traction_y: component(&now.traction, 1, -1.0),
        displacement_x: component(&now.displacement, 0, -1.0),
        displacement_y: component(&now.displacement, 1, -1.0),
        slip_x: now.slip.iter().map(|s| s[0]).collect(),
        slip_y: now.slip.iter().map(|s| s[1]).collect(),
        friction_coefficient: now.friction.clone(),
        friction_power: now.friction_power.clone(),
        temperature_rise_wheel: rises.iter().map(|r| r[0]).collect(),
        temperature_rise_rail: rises.iter().map(|r| r[1]).collect(),
        sliding: (0..cells.len()).map(|k| is_sliding(patch, now, k, threshold)).collect(),
    }
}
