//! Powers over a time step, and the energy that the bodies store.
//!
//! Over a step the traction is the mean of that at its two ends, and the displacement changes by its
//! difference, both in place. With a symmetric compliance the elastic part of the work is then exactly
//! the change of the stored energy ½ Σ p·(A p) ΔA, whatever the step, and what the material carries
//! through the patch cancels, so that
//!
//! power of the creep forces = friction power + change of the stored energy over the duration.

use crate::grid::VectorField;
use crate::patch::Patch;
use crate::solution::Resultant;
use crate::summary::{self, snapshot::Snapshot};

use super::contact::{DiscreteContact, Former};

/// The last instant, as far as the powers of the step after it depend on it.
#[derive(Debug)]
pub(super) struct Start {
    displacement: VectorField,
    traction: Vec<f64>,
    force: Resultant,
    /// The patch of that instant, where the step has another one.
    pub former: Option<Former>,
}

impl Start {
    /// The present instant, before the material moves on.
    pub fn of(contact: &DiscreteContact, now: &Snapshot) -> Self {
        Self {
            displacement: contact.displacement.clone(),
            traction: now.traction.clone(),
            force: summary::force(&contact.patch, now),
            former: None,
        }
    }
}

/// Slip velocity and friction power of every cell, means over the step that began with `start` and
/// has ended in an equilibrium; and the power of the creep forces.
///
/// Each cell's friction power is that of its traction with the mean slip over the cell, so rigid slip
/// works with the whole force. The half of a cell that the patch has left counts as departed.
pub(super) fn set_powers(now: &mut Snapshot, contact: &mut DiscreteContact, start: &Start) {
    let mut change = vec![0.0; now.traction.len()];
    contact.change_over_step(&start.displacement, None, &mut change);
    let patch = &contact.patch;
    now.slip = slip(now, patch, &change);
    let at_end = half_power(&now.traction, &now.slip);
    let mut power = vec![0.0; patch.grid.len()];
    for (cell, half) in patch.cells.iter().zip(at_end) {
        power[cell.index] += half;
    }
    change.resize(start.traction.len(), 0.0);
    contact.change_over_step(&start.displacement, start.former.as_ref(), &mut change);
    let before = start.former.as_ref().map_or(&contact.patch, |former| &former.patch);
    let at_start = half_power(&start.traction, &slip(now, before, &change));
    for (cell, half) in before.cells.iter().zip(at_start) {
        power[cell.index] += half;
    }
    let patch = &contact.patch;
    for (cell, power_here) in patch.cells.iter().zip(&mut now.friction_power) {
        *power_here = std::mem::take(&mut power[cell.index]);
    }
    now.departed_power = power.iter().sum::<f64>() * patch.grid.cell_area();
    let force = summary::force(patch, now).mean(&start.force);
    now.creep_power = Some(summary::creep_power(&now.over_step, &force));
}

/// Slip velocity of every cell (in m/s) from the change of A p on the way through it (in m).
fn slip(now: &Snapshot, patch: &Patch, change: &[f64]) -> Vec<[f64; 2]> {
    let spacing = patch.grid.spacing_x;
    let per_length = now.over_step.speed / spacing;
    let cells = patch.cells.iter().zip(change.chunks_exact(2));
    cells
        .map(|(cell, change)| {
            let rigid = now.over_step.rigid_slip(cell.x, cell.y);
            [0, 1].map(|c| per_length * (rigid[c] * spacing - change[c]))
        })
        .collect()
}

/// Half of p·slip in every cell, in W/m².
fn half_power<'a>(traction: &'a [f64], slip: &'a [[f64; 2]]) -> Vec<f64> {
    let cells = traction.chunks_exact(2).zip(slip);
    cells.map(|(p, slip)| 0.5 * (p[0] * slip[0] + p[1] * slip[1])).collect()
}
