//! Friction power in the cells and the temperatures that follow from it; Eqs. (17)–(22).
//!
//! Each cell's friction power is that of its traction with the mean slip over the cell, so rigid
//! slip works with the whole force, and the elastic parts cancel in the steady state: the integral
//! of the friction power is the power of the creep forces. The heat is released on the way through
//! the cell, evenly.

use crate::heat::{Heat, HeatStep};
use crate::patch::{Patch, Strip};

use super::snapshot::Snapshot;

/// Slip velocity and friction power of every cell. `change` is by how much the displacement A p
/// changes while a material point passes each cell, in m.
pub(super) fn set_friction_power(now: &mut Snapshot, patch: &Patch, change: &[f64]) {
    let spacing = patch.grid.spacing_x;
    let per_length = now.kinematics.speed / spacing;
    for (k, cell) in patch.cells.iter().enumerate() {
        let rigid = now.kinematics.rigid_slip(cell.x, cell.y);
        now.slip[k] = [0, 1].map(|c| per_length * (rigid[c] * spacing - change[2 * k + c]));
        let p = now.traction_at(k);
        now.friction_power[k] = p[0] * now.slip[k][0] + p[1] * now.slip[k][1];
    }
}

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

/// The temperature of an element in a cell, and its record when it leaves.
fn pass_cell(
    now: &mut Snapshot,
    patch: &Patch,
    heat: &Heat,
    (strip, k): (&Strip, usize),
    record: &mut Vec<HeatStep>,
) {
    let [before, after] = ways_through(patch, strip, k);
    // The friction power is a mean over a whole cell; it is released on the way inside.
    let energy = now.friction_power[k] * patch.grid.spacing_x;
    // What the bristles of the contact law return does not cool.
    let flux = energy.max(0.0) / (before + after);
    let step = |way: f64| HeatStep { flux, duration: way / now.kinematics.speed };
    record.insert(0, step(before));
    now.rise[k] = heat.rise_times_effusivity(record);
    record[0] = step(before + after);
}

/// The ways of the material in a cell, before and after the cell's point (in m): half of those to
/// its neighbours, and all of those to an edge.
pub(super) fn ways_through(patch: &Patch, strip: &Strip, k: usize) -> [f64; 2] {
    let way_in = patch.cells[k].way_in.distance;
    let before = if k == strip.cells.start { way_in } else { 0.5 * way_in };
    let after = if k + 1 == strip.cells.end {
        strip.exit.distance
    } else {
        0.5 * patch.cells[k + 1].way_in.distance
    };
    [before, after]
}
