//! The linear response of the bodies in a time step.

use crate::bodies::Kinematics;
use crate::normal::patch::Cell;
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::strip::Calibration;

use super::arrival::{Arrival, rigid_slip};

/// Known data of a time step, cell by cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Known {
    /// Sliding of each cell if neither the wheel moved nor the displacement were other than zero
    /// now, x and y in turn, in m.
    pub displacement: Vec<f64>,
    /// Path of its material in contact, in m.
    pub path: Vec<f64>,
    /// λ: fraction of the step that its material has spent in contact, dimensionless.
    pub in_contact: Vec<f64>,
    /// Whether its material came into contact in place, not over the leading edge.
    pub in_place: Vec<bool>,
    /// Whether the wheel does not roll.
    pub is_at_rest: bool,
}

impl Known {
    /// What is known when the elements have arrived.
    pub fn of(arrivals: &[Arrival], is_at_rest: bool) -> Self {
        Self {
            is_at_rest,
            displacement: arrivals.iter().flat_map(|arrival| arrival.displacement).collect(),
            path: arrivals.iter().map(|arrival| arrival.path).collect(),
            in_contact: arrivals.iter().map(|arrival| arrival.in_contact).collect(),
            in_place: arrivals.iter().map(|arrival| arrival.in_place).collect(),
        }
    }

    /// Rigid slip of each cell in the step under a motion, or a shift, x and y in turn, in m; rows
    /// that move otherwise than the plane do so in rolling only.
    pub fn rigid(&self, cells: &[Cell], motion: &Kinematics) -> Vec<f64> {
        let of = |(cell, path): (&Cell, &f64)| {
            if self.is_at_rest {
                motion.rigid_slip(cell.x, cell.y).map(|slip| path * slip)
            } else {
                rigid_slip(cell, *path, motion)
            }
        };
        cells.iter().zip(&self.path).flat_map(of).collect()
    }
}

/// B = A − diag(1 − λ) A_lead: material that came into contact within the step is compared with the
/// displacement where and when it entered. A_lead p is the present displacement at its place of
/// entry: at the leading edge, or, if it came into contact in place, the displacement caused there
/// by the tractions of the other cells.
pub(super) struct StepResponse<'a> {
    pub contact: &'a mut DiscreteContact,
    pub known: &'a Known,
    /// Whether entering material is displaced by the material in contact.
    pub is_coupled: bool,
    /// A p where the material of each cell entered, in m.
    at_entry: Vec<f64>,
}

impl<'a> StepResponse<'a> {
    pub fn new(contact: &'a mut DiscreteContact, known: &'a Known) -> Self {
        let is_coupled = contact.compliance.couples_cells();
        let at_entry = vec![0.0; known.displacement.len()];
        Self { contact, known, is_coupled, at_entry }
    }

    /// The same of the displacement under the pressure, in m; of unlike bodies.
    pub fn pressed(&self) -> Option<Vec<f64>> {
        let DiscreteContact { pressed, interpolation, .. } = &*self.contact;
        let pressed = pressed.as_ref()?;
        let mut u = vec![0.0; self.known.displacement.len()];
        let mut at_entry = u.clone();
        interpolation.gather(pressed, &mut u);
        interpolation.gather_at_entries(pressed, &mut at_entry);
        let Known { in_contact, in_place, .. } = self.known;
        for (at, u) in u.iter_mut().enumerate() {
            let entry = if in_place[at / 2] { *u } else { at_entry[at] };
            *u -= (1.0 - in_contact[at / 2]) * entry;
        }
        Some(u)
    }

    /// u = B p, with the displacements calibrated.
    pub fn product(&mut self, calibration: &Calibration, p: &[f64], u: &mut [f64]) {
        let made = self.contact.product(p);
        made.at_cells(u);
        made.at_entries(&mut self.at_entry);
        let own = self.contact.cell_compliance();
        let Known { in_contact, in_place, .. } = self.known;
        calibration.add_at_entries(p, &mut self.at_entry);
        for (at, u) in u.iter_mut().enumerate() {
            let k = at / 2;
            let is_moved = in_place[k] && self.is_coupled;
            let entry = if is_moved { *u - own * p[at] } else { self.at_entry[at] };
            *u -= (1.0 - in_contact[k]) * entry;
        }
        calibration.add_at_cells(p, u);
    }
}
