//! Temperatures that follow from the friction power in the cells; Eqs. (17)–(22). The heat is released on
//! the way through a cell, evenly.

use crate::heat::{Heat, HeatStep};
use crate::numerics::root::fixed_point;
use crate::patch::{Patch, Strip};
use crate::problem::Problem;
use crate::rolling::shared::passage::{self, flux_over_heat, ways_through};
use crate::summary::snapshot::Snapshot;

use super::arrival::Arrival;

/// Temperatures of all cells. `records` holds the heat that each cell's element has received before
/// it came in; on return, what it has when it leaves.
pub(super) fn set_temperatures(
    now: &mut Snapshot,
    patch: &Patch,
    heat: &Heat,
    records: &mut [Vec<HeatStep>],
) {
    now.exit_rise.clear();
    for strip in &patch.strips {
        for k in strip.cells.clone() {
            pass_cell(now, patch, heat, (strip, k), &mut records[k]);
        }
        now.exit_rise.push(heat.rise_times_effusivity(&records[strip.cells.end - 1]));
    }
}

/// What was rubbed in a place last.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Rubbing {
    /// Coefficient of friction, dimensionless.
    pub friction: f64,
    /// Friction power over area, in W/m².
    pub power: f64,
    /// Pressure times slip speed, in W/m²: the power where friction was one and all slid.
    pub bound_power: f64,
    /// Slip speed, in m/s.
    pub slip_speed: f64,
}

impl Rubbing {
    /// The coefficient of friction (dimensionless) in a cell to which an element with a heat record
    /// has come: the root of μ = law(T(μ)), the friction power going with μ. From the leading edge
    /// on there is one where μ falls with T.
    pub fn coefficient(
        &self,
        problem: &Problem,
        now: &Snapshot,
        (patch, strip, k): (&Patch, &Strip, usize),
        arrived: &Arrival,
    ) -> f64 {
        let [before, after] = ways_through(patch, strip, k);
        let at = |rise: f64| {
            let state = (rise, self.slip_speed);
            lagging(problem, now, (arrived.friction, patch.cells[k].y), state, before)
        };
        if problem.heat.model.is_none() || problem.friction.law.is_constant() {
            return at(0.0);
        }
        let per_friction =
            if self.friction > 0.0 { self.power / self.friction } else { self.bound_power };
        let per_power = flux_over_heat(patch.grid.spacing_x, [before, after]);
        let mut record = Vec::with_capacity(arrived.heat.len() + 1);
        record.push(HeatStep { flux: 0.0, duration: before / now.over_step.speed });
        record.extend_from_slice(&arrived.heat);
        fixed_point(self.friction, |tried| {
            record[0].flux = passage::heat(tried * per_friction) * per_power;
            at(problem.heat.rise_times_effusivity(&record))
        })
    }
}

/// Coefficient of friction (dimensionless) at y (in m) after a way (in m) at a temperature rise times
/// effusivity (in W √s/m²) and a slip speed (in m/s), of material that `arrived` with a coefficient or
/// enters the contact.
pub(super) fn lagging(
    problem: &Problem,
    now: &Snapshot,
    (arrived, y): (Option<f64>, f64),
    (rise, slip_speed): (f64, f64),
    way: f64,
) -> f64 {
    let law = problem.friction_response(&now.conduction, rise, slip_speed, y).coefficient;
    let Some(memory) = problem.friction_memory() else { return law };
    let arrived = arrived.unwrap_or_else(|| problem.entry_friction(&now.conduction, y).coefficient);
    law + (arrived - law) * memory.kept(slip_speed, way / now.over_step.speed).part
}

/// The temperature of an element in a cell, and its record when it leaves.
fn pass_cell(
    now: &mut Snapshot,
    patch: &Patch,
    heat: &Heat,
    (strip, k): (&Strip, usize),
    record: &mut Vec<HeatStep>,
) {
    let [before, after] = ways_through(patch, strip, k);
    let released = passage::heat(now.friction_power[k]);
    let flux = released * flux_over_heat(patch.grid.spacing_x, [before, after]);
    let step = |way: f64| HeatStep { flux, duration: way / now.over_step.speed };
    record.insert(0, step(before));
    now.rise[k] = heat.rise_times_effusivity(record);
    record[0] = step(before + after);
}
