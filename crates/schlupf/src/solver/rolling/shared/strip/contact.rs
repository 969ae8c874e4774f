//! What the law of a strip needs to know of a discretised contact.

use crate::normal::NormalContact;
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solver::rolling::shared::contact::{DiscreteContact, Row, at_distance};
use crate::solver::settings;

use super::calibration::{Calibrated, Calibration, Missing, Symmetric};
use super::resolvent::Matrix;
use super::slaved_cells::{Determinacy, SlavedCells};

/// The slaved cells and the calibration of a contact.
pub(in crate::solver::rolling) struct StripContact {
    pub slaved: SlavedCells,
    pub calibration: Calibration,
    /// Compliance of each cell under its own traction, in m/Pa.
    pub local: Vec<Matrix>,
    missing: Missing,
    /// Displacement of the bristles under p = pₙ (in m) for which cells are slaved.
    deflection: f64,
    /// Compliance of cells at a distance of 0, 1, … columns, in m/Pa.
    pub row: Row,
}

impl StripContact {
    /// Of a problem, on its discretised contact.
    ///
    /// # Errors
    /// Rigid bodies, for which nothing determines the traction where they stick.
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        contact: &mut DiscreteContact,
    ) -> Result<Self, Error> {
        let row = contact.row_compliances();
        let [own, ..] = row;
        let is_rigid = own[0] <= 0.0 || own[1] <= 0.0;
        if is_rigid && problem.interface.contact_law.is_coulomb() {
            return Err(Error::CoulombOfRigidBodies {});
        }
        let missing = Missing::new(problem, normal, contact, Calibrated::Displacement)?;
        let missing = missing.unwrap_or_else(|| Missing::nothing(contact.patch.len()));
        let slaved = slaved(contact, &missing, &row);
        let calibration = Calibration::new(&missing, &contact.patch, &slaved.kept);
        let mut alone = own.repeat(contact.patch.len());
        if !contact.compliance.couples_cells() {
            // Partly covered cells, too.
            contact.product(&vec![1.0; alone.len()]).at_cells(&mut alone);
        }
        let local = calibration.at_cells.iter().zip(alone.chunks_exact(2)).map(|(missing, own)| {
            let [xx, yy, xy] = missing;
            let along = |own: f64, missing: f64| own + missing.max(-settings::most_reduced() * own);
            [[along(own[0], *xx), *xy], [*xy, along(own[1], *yy)]]
        });
        let deflection = contact.bristle_deflection();
        Ok(Self { local: local.collect(), slaved, calibration, missing, deflection, row })
    }

    /// Follows a change of the laws of the contact, of which only bristles bear on which cells are
    /// slaved; returns whether these are others now.
    pub fn settle(&mut self, contact: &DiscreteContact) -> bool {
        let before = std::mem::replace(&mut self.deflection, contact.bristle_deflection());
        if before == self.deflection {
            return false;
        }
        let slaved = slaved(contact, &self.missing, &self.row);
        let is_other = slaved.kept != self.slaved.kept;
        if is_other {
            self.calibration = Calibration::new(&self.missing, &contact.patch, &slaved.kept);
            self.slaved = slaved;
        }
        is_other
    }

    /// A part or a derivative of the calibration, if the elasticity knows it.
    ///
    /// # Errors
    /// Those of the compliance on a finer grid.
    pub fn calibration_of(
        &self,
        what: Calibrated,
        (problem, normal): (&Problem, &NormalContact),
        contact: &mut DiscreteContact,
    ) -> Result<Option<Calibration>, Error> {
        let missing = Missing::new(problem, normal, contact, what)?;
        Ok(missing.map(|missing| Calibration::new(&missing, &contact.patch, &self.slaved.kept)))
    }

    /// The cells with equations of their own.
    pub fn kept(&self) -> impl Iterator<Item = usize> {
        self.slaved.kept.iter().flat_map(Clone::clone)
    }
}

/// The slaved cells of a contact; none where cells are not coupled.
fn slaved(contact: &DiscreteContact, missing: &Missing, row: &Row) -> SlavedCells {
    if !contact.compliance.couples_cells() {
        return SlavedCells::none(&contact.patch);
    }
    let determinacy = (0..contact.patch.len()).map(|k| determinacy(k, contact, missing, row));
    SlavedCells::new(&contact.patch, &determinacy.collect::<Vec<Determinacy>>())
}

/// How well the equation of cell `k` determines its traction, for the direction in which it does
/// so less.
fn determinacy(k: usize, contact: &DiscreteContact, missing: &Missing, row: &Row) -> Determinacy {
    let patch = &contact.patch;
    let cell = &patch.cells[k];
    let [own, ..] = row;
    let at_entry = at_distance(row, cell.since_entry.distance / patch.grid.spacing_x);
    let smaller = |of: [f64; 2]| of[0].min(of[1]);
    let over = |missing: &[Symmetric], c: usize| missing[k][c] / (own[c] * cell.pressure);
    Determinacy {
        missing: smaller([0, 1].map(|c| over(&missing.at_cells, c))),
        sliding: smaller([0, 1].map(|c| {
            1.0 + over(&missing.at_cells, c) - at_entry[c] / own[c] - over(&missing.at_entries, c)
        })),
        bristles: contact.bristle_deflection() / own[0].max(own[1]),
    }
}
