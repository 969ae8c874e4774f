//! What Coulomb's law needs to know of a discretised contact.

use crate::error::Error;
use crate::normal::NormalContact;
use crate::problem::Problem;
use crate::rolling::shared::contact::DiscreteContact;

use super::calibration::{Calibration, Missing};
use super::reduction::Matrix;
use super::slivers::Slivers;

/// Largest part of the cell's own compliance by which a calibration reduces it in the
/// preconditioner, dimensionless.
const MOST_REDUCED: f64 = 0.3;

/// The slivers and the calibration of a contact.
pub(in crate::rolling) struct CoulombContact {
    pub slivers: Slivers,
    pub calibration: Calibration,
    /// Compliance of each cell under its own traction, in m/Pa.
    pub local: Vec<Matrix>,
}

impl CoulombContact {
    /// Makes a contact interpolate as the calibration of its displacement requires, whose numbers
    /// are those of one interpolation. Where there are bristles, they keep adjacent strips from
    /// oscillating against each other.
    pub fn interpolate(problem: &Problem, contact: &mut DiscreteContact) {
        if !problem.contact_law.is_coulomb() {
            contact.fix_interpolation(1.0);
        }
    }

    /// Of a problem, on a contact that interpolates as [`Self::interpolate`] makes it.
    ///
    /// # Errors
    /// Rigid bodies, for which nothing determines the traction where they stick.
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        contact: &mut DiscreteContact,
    ) -> Result<Self, Error> {
        let own = contact.cell_compliances();
        if own[0] <= 0.0 || own[1] <= 0.0 {
            return Err(Error::CoulombOfRigidBodies {});
        }
        let missing = Missing::new(problem, normal, contact)?;
        let patch = &contact.patch;
        let smaller: Vec<f64> = missing.at_cells.iter().map(|u| u[0].min(u[1])).collect();
        let slivers = Slivers::new(patch, &smaller, 0.5 * (own[0] + own[1]));
        let calibration = Calibration::new(&missing, patch, &slivers.kept);
        let local = calibration.at_cells.iter().map(|[xx, yy, xy]| {
            let along = |own: f64, missing: f64| own + missing.max(-MOST_REDUCED * own);
            [[along(own[0], *xx), *xy], [*xy, along(own[1], *yy)]]
        });
        Ok(Self { local: local.collect(), slivers, calibration })
    }

    /// The cells with equations of their own.
    pub fn kept(&self) -> impl Iterator<Item = usize> {
        self.slivers.kept.iter().flat_map(Clone::clone)
    }
}
