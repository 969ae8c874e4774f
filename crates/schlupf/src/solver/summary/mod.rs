//! Forces, powers and all other reported results from the fields of an instant.

pub(crate) mod snapshot;
pub(crate) mod caveats;

use crate::bodies::{Kinematics, ReferencePoint};
use crate::normal::NormalSummary;
use crate::normal::patch::{Patch, Strip};
use crate::problem::{Method, Options, Problem, State};
use crate::reporting::Warning;
use crate::solution::{
    Area, Fields, FieldsAt, Instant, Power, Resultant, Sensitivity, Solution, Status, TGamma,
    Temperature, Work,
};
use crate::solver::equilibrium::Outcome;

use snapshot::{Snapshot, View};

/// What a driver knows in addition to the fields.
pub(crate) struct SolverReport {
    pub method: Method,
    pub status: Status,
    /// Relative residual, dimensionless.
    pub residual: f64,
    pub history: Vec<Instant>,
    pub field_history: Vec<FieldsAt>,
    pub warnings: Vec<Warning>,
    pub sensitivity: Option<Sensitivity>,
    pub work: Work,
    pub state: State,
}

/// All results of an instant.
pub(crate) fn solution(
    problem: &Problem,
    options: &Options,
    View { normal, patch, now }: View,
    report: SolverReport,
) -> Solution {
    let force = force(patch, now);
    Solution {
        method: report.method,
        status: report.status,
        residual: report.residual,
        normal: *normal,
        reference: ReferencePoint::Patch,
        kinematics: now.kinematics,
        force,
        normalised: normalised(problem, normal, &force),
        traction_coefficient: force.tangential() / normal.load,
        power: power(patch, now, &force)
            .map(|power| Power { exchanged: Some(exchanged(problem, patch, now)), ..power }),
        t_gamma: t_gamma(&now.kinematics, &force, patch.row_powers(&now.traction)),
        temperature: problem.interface.heat.model.as_ref().map(|_| temperature(patch, now)),
        peclet: problem.interface.peclet(&now.kinematics, normal.semi_axes()).numbers,
        area: area(patch, now, options.slip_threshold),
        fields: fields(patch, now, options.slip_threshold),
        history: report.history,
        field_history: report.field_history,
        warnings: report.warnings,
        sensitivity: report.sensitivity,
        extrapolation: None,
        work: report.work,
        state: report.state,
    }
}

/// F/(μ0 N) and Mz/(μ0 N √(ab)), dimensionless.
pub(crate) fn normalised(
    problem: &Problem,
    normal: &NormalSummary,
    force: &Resultant,
) -> Resultant {
    let limit = problem.interface.friction.cold_coefficient() * normal.load;
    let lever = (normal.semi_axis_x * normal.semi_axis_y).sqrt();
    force.scaled(limit.recip(), (limit * lever).recip())
}

/// Forces and moment on the wheel.
pub(crate) fn force(patch: &Patch, now: &Snapshot) -> Resultant {
    resultant(patch, &now.traction)
}

/// Forces and moment on the wheel for a traction on the rail.
pub(crate) fn resultant(patch: &Patch, traction: &[f64]) -> Resultant {
    let area = patch.grid.cell_area();
    let [mut x, mut y, mut moment_z] = [0.0; 3];
    for (k, cell) in patch.cells.iter().enumerate() {
        let [px, py] = [traction[2 * k], traction[2 * k + 1]];
        x -= px * area;
        y -= py * area;
        moment_z -= (cell.x * py - cell.y * px) * area;
    }
    Resultant::new(x, y, moment_z)
}

pub(crate) fn power(patch: &Patch, now: &Snapshot, force: &Resultant) -> Option<Power> {
    let area = patch.grid.cell_area();
    let friction = now.friction_power.iter().sum::<f64>() * area;
    let returned = now.friction_power.iter().map(|q| (-q).max(0.0)).sum::<f64>() * area;
    let shared = || now.conduction.shares().map(|share| share * (friction + returned));
    let [into_wheel, into_rail] = now.surfaces.as_ref().map_or_else(shared, |found| found.into);
    let rows = now.kinematics.speed * patch.row_power(&now.traction);
    let creep = creep_power(&now.kinematics, force)? + rows + now.pressed_power;
    Some(Power { friction, creep, returned, into_wheel, into_rail, exchanged: None })
}

/// The record of an instant at a time (in s) and after a distance (in m), with its own powers.
pub(crate) fn instant(
    View { normal, patch, now }: View,
    [time, distance]: [f64; 2],
    outcome: &Outcome,
) -> Instant {
    let force = force(patch, now);
    let power = power(patch, now, &force);
    Instant {
        time,
        distance,
        kinematics: now.kinematics,
        shift: None,
        load: normal.load,
        force,
        friction_power: power.map(|power| power.friction),
        creep_power: power.map(|power| power.creep),
        stored_energy: Some(now.stored_energy),
        max_rise: Some(temperature(patch, now).max_rise),
        newton_iterations: outcome.iterations,
        residual: outcome.residual,
    }
}

/// Heat from the wheel into the rail (in W) because their bulk temperatures differ.
fn exchanged(problem: &Problem, patch: &Patch, now: &Snapshot) -> f64 {
    if let Some(surfaces) = &now.surfaces {
        return surfaces.exchanged;
    }
    let conduction = &now.conduction;
    let step = conduction.bulk_temperatures()[0] - conduction.entry_temperature;
    chill(problem, patch, now.kinematics.speed / conduction.contact_times()[0]) * step
}

/// Heat flow through the contact divided by the step from the wheel's bulk temperature to its
/// contact temperature (in W/K), for a surface of the wheel that moves at a speed in m/s. A surface
/// held at T_w − T_m below its bulk temperature absorbs 2 β_w (T_w − T_m) √(t/π) per unit area in a
/// time t (Carslaw and Jaeger 1959, §2.5), which is L/v_w in the contact, and v_w dy of it passes
/// every second.
pub(crate) fn chill(problem: &Problem, patch: &Patch, wheel_speed: f64) -> f64 {
    let of_strip = |strip: &Strip| {
        let covered: f64 = patch.cells[strip.cells.clone()].iter().map(|c| c.covered).sum();
        (wheel_speed * covered * patch.grid.spacing_x / std::f64::consts::PI).sqrt()
    };
    let sum: f64 = patch.strips.iter().map(of_strip).sum();
    2.0 * problem.interface.wheel.material.effusivity() * patch.grid.spacing_y * sum
}

/// −v0 (ξ Fx + η Fy + φ Mz), in W, if the moment is known or there is no spin.
pub(crate) fn creep_power(motion: &Kinematics, force: &Resultant) -> Option<f64> {
    let along = motion.creepage_x * force.x + motion.creepage_y * force.y;
    Some(-motion.speed * (along + turning(motion, force)?))
}

/// φ Mz, in N. Without spin the moment is irrelevant, even if unknown.
fn turning(motion: &Kinematics, force: &Resultant) -> Option<f64> {
    if motion.spin == 0.0 { Some(0.0) } else { Some(motion.spin * force.moment_z?) }
}

/// Tγ with the parts of the rows (in N): see [`TGamma`].
pub(crate) fn t_gamma(motion: &Kinematics, force: &Resultant, rows: [f64; 2]) -> TGamma {
    let [lateral, by_spin] = rows;
    let y = lateral - motion.creepage_y * force.y;
    let without_spin = (motion.creepage_x * force.x).abs() + y.abs();
    let with_spin = turning(motion, force).map(|turning| without_spin + (by_spin - turning).abs());
    TGamma { without_spin, with_spin, rows }
}

/// Largest temperatures, in the cells and at the trailing edges.
pub(crate) fn temperature(patch: &Patch, now: &Snapshot) -> Temperature {
    let bulk = now.conduction.bulk_temperatures();
    // Both surfaces follow from the rise, with less rounding error, or are found separately.
    let key = |rise: f64, surfaces: [f64; 2]| {
        if now.surfaces.is_some() { surfaces } else { [rise; 2] }
    };
    let cells = patch.cells.iter().enumerate().map(|(k, cell)| {
        let surfaces = now.surface_temperatures(k);
        (key(now.scaled_rise[k], surfaces), surfaces, cell.x, cell.y)
    });
    let exits =
        now.scaled_exit_rise.iter().zip(&patch.strips).enumerate().map(|(k, (rise, strip))| {
            let surfaces = now.exit_temperatures(k);
            (key(*rise, surfaces), surfaces, patch.exit(strip), patch.cells[strip.cells.end - 1].y)
        });
    let places: Vec<_> = cells.chain(exits).collect();
    let hottest = |body: usize| {
        places.iter().reduce(|p, q| if q.0[body] > p.0[body] { q } else { p }).copied()
    };
    let (Some((_, wheel, ..)), Some((_, rail, ..))) = (hottest(0), hottest(1)) else {
        return Temperature::default();
    };
    let [rise_wheel, rise_rail] = [wheel[0] - bulk[0], rail[1] - bulk[1]];
    let place = hottest(usize::from(rise_rail > rise_wheel));
    let (x, y) = place.map_or((0.0, 0.0), |(_, _, x, y)| (x, y));
    Temperature {
        max_rise: rise_wheel.max(rise_rail),
        max_rise_wheel: rise_wheel,
        max_rise_rail: rise_rail,
        max_wheel: wheel[0],
        max_rail: rail[1],
        x,
        y,
    }
}

fn is_sliding(patch: &Patch, now: &Snapshot, k: usize, threshold: f64) -> bool {
    let [px, py] = now.traction_at(k);
    px.hypot(py) >= threshold * now.friction[k] * patch.cells[k].pressure
}

fn area(patch: &Patch, now: &Snapshot, threshold: f64) -> Area {
    let [mut stick, mut slip] = [0.0; 2];
    for (k, cell) in patch.cells.iter().enumerate() {
        let part = if is_sliding(patch, now, k, threshold) { &mut slip } else { &mut stick };
        *part += cell.covered * patch.grid.cell_area();
    }
    Area { contact: stick + slip, stick: Some(stick), slip: Some(slip) }
}

pub(crate) fn fields(patch: &Patch, now: &Snapshot, threshold: f64) -> Fields {
    let grid = patch.grid;
    let cells = &patch.cells;
    let component = |values: &[f64], c: usize, sign: f64| -> Vec<f64> {
        values.iter().skip(c).step_by(2).map(|v| sign * v).collect()
    };
    let bulk = now.conduction.bulk_temperatures();
    let rises = (0..cells.len()).map(|k| {
        let surfaces = now.surface_temperatures(k);
        [surfaces[0] - bulk[0], surfaces[1] - bulk[1]]
    });
    let rises: Vec<[f64; 2]> = rises.collect();
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
