//! The Winkler bedding, u = t/c: the uncoupled point contacts of Sextro (2007) and of FASTSIM
//! (Kalker 1982).

use super::{Compliance, Elasticity};
use crate::normal::{Grid, VectorField};
use crate::reporting::{Error, Quantity, require_positive};

/// Springs from every point to the rigid wheel, none between the points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Winkler {
    bedding: [f64; 2],
    size_exponent: f64,
}

impl Winkler {
    /// Bedding stiffnesses c along and across rolling, in N/m³.
    ///
    /// ```
    /// use schlupf::elasticity::Winkler;
    ///
    /// assert!(Winkler::new(1e13, 1e13).is_ok() && Winkler::new(0.0, 1e13).is_err());
    /// ```
    pub fn new(bedding_x: f64, bedding_y: f64) -> Result<Self, Error> {
        require_positive(Quantity::BeddingX, bedding_x)?;
        require_positive(Quantity::BeddingY, bedding_y)?;
        Ok(Self { bedding: [bedding_x, bedding_y], size_exponent: 0.0 })
    }

    /// The same for stiffnesses that belong to this patch size, so that displacements scale with
    /// the patch as those of the half-space do.
    pub(crate) fn growing_with_the_patch(self) -> Self {
        Self { size_exponent: 1.0, ..self }
    }

    /// Bedding stiffnesses c along and across rolling, in N/m³.
    pub fn bedding(&self) -> [f64; 2] {
        self.bedding
    }
}

impl Elasticity for Winkler {
    fn compliance(&self, _grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        Ok(Box::new(*self))
    }
}

impl Compliance for Winkler {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        let divide = |t: &[f64], u: &mut [f64], c: f64| {
            for (u, t) in u.iter_mut().zip(t) {
                *u = t / c;
            }
        };
        divide(&traction.x, &mut displacement.x, self.bedding[0]);
        divide(&traction.y, &mut displacement.y, self.bedding[1]);
    }

    fn displacement_by_size(
        &mut self,
        traction: &VectorField,
        displacement: &mut VectorField,
    ) -> bool {
        self.displacement(traction, displacement);
        for u in displacement.x.iter_mut().chain(&mut displacement.y) {
            *u *= self.size_exponent;
        }
        true
    }

    fn couples_cells(&self) -> bool {
        false
    }
}
