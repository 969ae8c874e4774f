//! Temperatures due to the friction power in the cells; Eqs. (17)–(22). The heat is released
//! uniformly along the path through a cell.

use crate::interface::heat::{Heat, HeatStep};
use crate::normal::patch::Patch;
use crate::numerics::root::fixed_point;
use crate::problem::{Element, Problem};
use crate::solver::rolling::shared::passage::{Passage, heat, paths_through};
use crate::solver::summary::snapshot::Snapshot;

use super::arrival::Arrival;

/// Temperatures of all cells. On entry `records` holds the heat that each cell's element has
/// received before arriving; on return, the heat when it leaves.
pub(super) fn set_temperatures(
    now: &mut Snapshot,
    patch: &Patch,
    heat: &Heat,
    records: &mut [Vec<HeatStep>],
) {
    now.scaled_exit_rise.clear();
    for strip in &patch.strips {
        for k in strip.cells.clone() {
            pass_cell(now, heat, k, &Passage::of(patch, strip, k), &mut records[k]);
        }
        now.scaled_exit_rise.push(heat.rise_times_effusivity(&records[strip.cells.end - 1]));
    }
}

/// Friction at a place at the last evaluation.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FrictionPoint {
    /// Coefficient of friction, dimensionless.
    pub friction: f64,
    /// Friction power per unit area, in W/m².
    pub power: f64,
    /// Pressure times slip speed, in W/m²: the power for a coefficient of one in full sliding.
    pub bound_power: f64,
    /// Slip speed, in m/s.
    pub slip_speed: f64,
}

impl FrictionPoint {
    /// What bounds the traction in a cell over the pressure (in Pa) on its covered part,
    /// dimensionless: the coefficient of friction, or less where the layer between the surfaces
    /// flows. With the compliance of the whole patch, in m/Pa.
    pub fn coefficient(
        &self,
        problem: &Problem,
        now: &Snapshot,
        passage: &Passage,
        arrived: &Arrival,
        (pressure, compliance): (f64, f64),
    ) -> f64 {
        let friction = self.of_friction(problem, now, passage, arrived);
        let Some(layer) = &problem.interface.layer else { return friction };
        let slip = self.slip_speed * passage.paths[0] / now.over_step.speed;
        let flow = layer.pass(friction * pressure, arrived.plastic_displacement, [slip; 2]);
        let found = flow.bound / pressure;
        // The slip is that of the step before. A bound that grows takes some of it up, as shear of
        // the layer and of the bodies, at most what it takes where it grows all over the patch.
        // Without this a layer that hardens steeply would go up and down with each step.
        let share = (1.0 + layer.hardening() * compliance).recip();
        if flow.yields[0] && self.friction > 0.0 {
            self.friction + share * (found - self.friction)
        } else {
            found
        }
    }

    /// The coefficient of friction (dimensionless) in a cell into which an element with a heat
    /// record has come: the root of μ = law(T(μ)), where the friction power is proportional to μ.
    /// If μ decreases with T, it is unique.
    fn of_friction(
        &self,
        problem: &Problem,
        now: &Snapshot,
        passage: &Passage,
        arrived: &Arrival,
    ) -> f64 {
        let [before, _] = passage.paths;
        let at = |scaled_rise: f64| {
            let input = FrictionInput {
                y: passage.y,
                path: before,
                scaled_rise,
                slip_speed: self.slip_speed,
            };
            lagging(problem, now, arrived.friction, &input)
        };
        if problem.interface.heat.model.is_none() || problem.interface.friction.law.is_constant() {
            return at(0.0);
        }
        let per_friction =
            if self.friction > 0.0 { self.power / self.friction } else { self.bound_power };
        let mut record = Vec::with_capacity(arrived.heat.len() + 1);
        record.push(HeatStep { flux: 0.0, duration: before / now.over_step.speed });
        record.extend_from_slice(&arrived.heat);
        fixed_point(self.friction, |tried| {
            record[0].flux = heat(tried * per_friction) * passage.flux_over_heat;
            at(problem.interface.heat.rise_times_effusivity(&record))
        })
    }
}

/// Material after friction along its path through a cell, or a part of it.
pub(super) struct FrictionInput {
    /// Position of the cell across rolling, in m.
    pub y: f64,
    /// The path length, in m.
    pub path: f64,
    /// Temperature rise times effusivity, in W √s/m².
    pub scaled_rise: f64,
    /// Slip speed, in m/s.
    pub slip_speed: f64,
}

/// Coefficient of friction (dimensionless) of material that `arrived` with a coefficient or enters
/// the contact.
pub(super) fn lagging(
    problem: &Problem,
    now: &Snapshot,
    arrived: Option<f64>,
    &FrictionInput { y, path, scaled_rise, slip_speed }: &FrictionInput,
) -> f64 {
    let law = problem
        .interface
        .friction_response(&now.conduction, scaled_rise, slip_speed, y)
        .coefficient;
    let Some(memory) = problem.interface.friction_memory() else { return law };
    let arrived =
        arrived.unwrap_or_else(|| problem.interface.entry_friction(&now.conduction, y).coefficient);
    law + (arrived - law) * memory.kept(slip_speed, path / now.over_step.speed).part
}

/// The coefficients of friction and the plastic displacements with which the elements leave their
/// cells.
pub(super) fn remember(
    problem: &Problem,
    now: &Snapshot,
    patch: &Patch,
    elements: &mut [Element],
    arrivals: &[Arrival],
) {
    let yields = problem.interface.layer.filter(|layer| layer.yield_limit().is_some());
    if problem.interface.friction_memory().is_none() && yields.is_none() {
        return;
    }
    for strip in &patch.strips {
        for k in strip.cells.clone() {
            let (element, cell, before) = (&mut elements[k], &patch.cells[k], &arrivals[k]);
            let paths = paths_through(patch, strip, k);
            let after = |path: f64| FrictionInput {
                y: cell.y,
                path,
                scaled_rise: element.scaled_rise,
                slip_speed: element.slip_speed,
            };
            let through = paths[0] + paths[1];
            let [here, leaving] = [paths[0], through]
                .map(|path| lagging(problem, now, before.friction, &after(path)));
            if problem.interface.friction_memory().is_some() {
                element.friction_on_leaving = Some(leaving);
            }
            if let Some(layer) = &yields {
                let slips =
                    [paths[0], through].map(|path| element.slip_speed * path / now.over_step.speed);
                let friction = here * cell.pressure_where_covered();
                element.plastic_displacement =
                    layer.pass(friction, before.plastic_displacement, slips).left;
            }
        }
    }
}

/// The temperature of an element in a cell, and its record when it leaves.
fn pass_cell(
    now: &mut Snapshot,
    model: &Heat,
    k: usize,
    passage: &Passage,
    record: &mut Vec<HeatStep>,
) {
    let [before, after] = passage.paths;
    let flux = heat(now.friction_power[k]) * passage.flux_over_heat;
    let step = |path: f64| HeatStep { flux, duration: path / now.over_step.speed };
    record.insert(0, step(before));
    now.scaled_rise[k] = model.rise_times_effusivity(record);
    record[0] = step(before + after);
}
