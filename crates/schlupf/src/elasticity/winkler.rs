//! The Winkler bedding, u = t/c: the uncoupled point contacts of Sextro (2007) and of FASTSIM
//! (Kalker 1982).

use super::{Compliance, Elasticity};
use crate::error::{Error, require_positive};
use crate::grid::{Grid, VectorField};

/// Springs from every point to the rigid wheel, none between the points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Winkler {
    bedding: [f64; 2],
}

impl Winkler {
    /// Bedding stiffnesses c along and across rolling, in N/m³.
    pub fn new(bedding_x: f64, bedding_y: f64) -> Result<Self, Error> {
        require_positive("elasticity.bedding_x", bedding_x, "N/m^3")?;
        require_positive("elasticity.bedding_y", bedding_y, "N/m^3")?;
        Ok(Self { bedding: [bedding_x, bedding_y] })
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
        _traction: &VectorField,
        displacement: &mut VectorField,
    ) -> bool {
        displacement.clear();
        true
    }

    fn couples_cells(&self) -> bool {
        false
    }

    fn is_short_ranged(&self) -> bool {
        true
    }
}
