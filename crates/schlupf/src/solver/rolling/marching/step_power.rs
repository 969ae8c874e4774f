//! Slip and friction power at an instant, the powers over the preceding time step, and the stored
//! elastic energy.
//!
//! Over a step the traction is the mean of that at its two ends, and the displacement changes by
//! its difference, both in place. With a symmetric compliance the elastic part of the work is then
//! exactly the change in the stored energy ½ Σ p·(A p) ΔA, whatever the step, and the contributions
//! of the material transport through the patch cancel, so that
//!
//! power of the creep forces = friction power + change in the stored energy over the duration.
//!
//! Heat follows from the friction power at the instant, when an element is in the middle of its
//! cell.

use crate::bodies::Kinematics;
use crate::normal::VectorField;
use crate::normal::patch::{Cell, Interpolation, Patch};
use crate::solution::Resultant;
use crate::solver::rolling::shared::contact::{DiscreteContact, Former, differences};
use crate::solver::rolling::shared::passage::{power, rigid_velocity, slip};
use crate::solver::summary::snapshot::Snapshot;
use crate::solver::summary::{self};

/// The previous instant, as needed for the powers of the following step.
#[derive(Debug)]
pub(super) struct Start {
    displacement: VectorField,
    traction: Vec<f64>,
    force: Resultant,
    /// Power over the speed with what the rows slip beyond the plane, in N.
    row_power: f64,
    /// The patch at that instant, if the step has a different one.
    pub former: Option<Former>,
}

/// Means over a time step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StepPower {
    /// Friction power, in W.
    pub friction: f64,
    /// Power of the creep forces, in W, if their moment is known.
    pub creep: Option<f64>,
}

impl Start {
    /// The present instant, with its displacement, before the material moves on.
    pub fn of(displacement: &VectorField, patch: &Patch, now: &Snapshot) -> Self {
        Self {
            displacement: displacement.clone(),
            traction: now.traction.clone(),
            force: summary::force(patch, now),
            row_power: patch.row_power(&now.traction),
            former: None,
        }
    }

    /// Slip velocity and friction power of every cell at the end of a step. Each cell multiplies
    /// its traction by the mean slip over the cell, so rigid slip works with the whole force.
    pub fn set_friction_power(
        &self,
        now: &mut Snapshot,
        contact: &DiscreteContact,
        displacement: &VectorField,
    ) {
        let interpolation = &contact.interpolation;
        let change = self.change(interpolation, &contact.patch, displacement, displacement);
        now.slip = slips(&now.kinematics, &contact.patch, &change);
        now.friction_power = powers(&now.traction, &now.slip);
    }

    /// Powers over the completed step, including the cells that the patch has left within it.
    pub fn powers_until(
        &self,
        now: &Snapshot,
        contact: &DiscreteContact,
        displacement: &VectorField,
    ) -> StepPower {
        let half = |traction: &[f64], patch: &Patch, interpolation: &Interpolation| {
            let passed = combined(displacement, 0.5, &self.displacement, 0.5);
            let change = self.change(interpolation, patch, displacement, &passed);
            let slip = slips(&now.over_step, patch, &change);
            0.5 * powers(traction, &slip).iter().sum::<f64>() * patch.grid.cell_area()
        };
        let (patch, interpolation) = (&contact.patch, &contact.interpolation);
        let (before, interpolation_before) = match &self.former {
            Some(former) => (&former.patch, &former.interpolation),
            None => (patch, interpolation),
        };
        let friction = half(&now.traction, patch, interpolation)
            + half(&self.traction, before, interpolation_before);
        let force = summary::force(&contact.patch, now).plus(1.0, &self.force).scaled(0.5, 0.5);
        let rows = 0.5 * (contact.patch.row_power(&now.traction) + self.row_power);
        let creep = summary::creep_power(&now.over_step, &force);
        StepPower { friction, creep: creep.map(|creep| creep + now.over_step.speed * rows) }
    }

    /// Change of A p while a material point passes each cell of a patch within the step: the change
    /// due to moving through the field, plus the change in place up to the displacement at the end
    /// of the step.
    fn change(
        &self,
        interpolation: &Interpolation,
        patch: &Patch,
        displacement: &VectorField,
        passed: &VectorField,
    ) -> Vec<f64> {
        // The border of the grid, where there are no cells, keeps its values.
        let mut passing = VectorField::zeros(patch.grid.len());
        differences(passed, patch.grid.columns, &mut passing);
        let gained = combined(displacement, 1.0, &self.displacement, -1.0);
        let mut change = vec![0.0; 2 * patch.len()];
        let mut in_place = change.clone();
        interpolation.gather_means(&passing, &mut change);
        interpolation.gather_means(&gained, &mut in_place);
        for (change, in_place) in change.iter_mut().zip(in_place) {
            *change += in_place;
        }
        change
    }
}

/// A linear combination of two fields.
fn combined(one: &VectorField, share: f64, other: &VectorField, rest: f64) -> VectorField {
    let sum = |(p, q): (&f64, &f64)| share * p + rest * q;
    VectorField {
        x: one.x.iter().zip(&other.x).map(sum).collect(),
        y: one.y.iter().zip(&other.y).map(sum).collect(),
    }
}

/// Slip velocity of every cell (in m/s) from the change of A p along the path through it (in m).
fn slips(motion: &Kinematics, patch: &Patch, change: &[f64]) -> Vec<[f64; 2]> {
    let cells = patch.cells.iter().zip(change.chunks_exact(2));
    let rate = motion.speed / patch.grid.spacing_x;
    let of_cell = |(cell, change): (&Cell, &[f64])| {
        slip(rigid_velocity(motion, cell), rate, [change[0], change[1]])
    };
    cells.map(of_cell).collect()
}

/// Friction power over area in every cell, in W/m².
fn powers(traction: &[f64], slip: &[[f64; 2]]) -> Vec<f64> {
    let cells = traction.chunks_exact(2).zip(slip);
    cells.map(|(p, slip)| power([p[0], p[1]], *slip)).collect()
}
