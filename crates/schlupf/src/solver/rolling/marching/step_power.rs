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
    /// The part of it under the pressure, in m; of unlike bodies.
    pressed: Option<VectorField>,
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
    pub fn of(displacement: &VectorField, contact: &DiscreteContact, now: &Snapshot) -> Self {
        let patch = &contact.patch;
        Self {
            displacement: displacement.clone(),
            pressed: contact.pressed.clone(),
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
        let gained = combined(displacement, 1.0, &self.displacement, -1.0);
        let change = change(interpolation, &contact.patch, &gained, displacement);
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
        let friction = self.friction(now, contact, [&self.displacement, displacement]);
        let pressed = self.pressed.as_ref().zip(contact.pressed.as_ref());
        let pressed = pressed.map_or(0.0, |(before, after)| {
            let before = combined(&self.displacement, 1.0, before, -1.0);
            let after = combined(displacement, 1.0, after, -1.0);
            friction - self.friction(now, contact, [&before, &after])
        });
        let force = summary::force(&contact.patch, now).plus(1.0, &self.force).scaled(0.5, 0.5);
        let rows = 0.5 * (contact.patch.row_power(&now.traction) + self.row_power);
        let creep = summary::creep_power(&now.over_step, &force);
        let work = now.over_step.speed * rows + pressed;
        StepPower { friction, creep: creep.map(|creep| creep + work) }
    }

    /// Friction power over the step (in W) with displacements before and after it, in m.
    fn friction(
        &self,
        now: &Snapshot,
        contact: &DiscreteContact,
        [before, after]: [&VectorField; 2],
    ) -> f64 {
        let passed = combined(after, 0.5, before, 0.5);
        let gained = combined(after, 1.0, before, -1.0);
        let half = |traction: &[f64], patch: &Patch, interpolation: &Interpolation| {
            let change = change(interpolation, patch, &gained, &passed);
            let slip = slips(&now.over_step, patch, &change);
            0.5 * powers(traction, &slip).iter().sum::<f64>() * patch.grid.cell_area()
        };
        let (patch, interpolation) = (&contact.patch, &contact.interpolation);
        let (former, interpolation_before) = match &self.former {
            Some(former) => (&former.patch, &former.interpolation),
            None => (patch, interpolation),
        };
        half(&now.traction, patch, interpolation)
            + half(&self.traction, former, interpolation_before)
    }
}

/// Change of the displacement while a material point passes each cell of a patch within the step:
/// the change due to moving through the field, plus that `gained` in place.
fn change(
    interpolation: &Interpolation,
    patch: &Patch,
    gained: &VectorField,
    passed: &VectorField,
) -> Vec<f64> {
    // The border of the grid, where there are no cells, keeps its values.
    let mut passing = VectorField::zeros(patch.grid.len());
    differences(passed, patch.grid.columns, &mut passing);
    let mut change = vec![0.0; 2 * patch.len()];
    let mut in_place = change.clone();
    interpolation.gather_means(&passing, &mut change);
    interpolation.gather_means(gained, &mut in_place);
    for (change, in_place) in change.iter_mut().zip(in_place) {
        *change += in_place;
    }
    change
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
