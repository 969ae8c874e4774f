//! Rigid bodies, u = 0: the slip is prescribed. For studies of heat and friction alone.

use super::{Compliance, Elasticity};
use crate::normal::{Grid, VectorField};
use crate::reporting::Error;

/// Bodies that do not deform tangentially.
///
/// ```
/// use schlupf::elasticity::Rigid;
/// use schlupf::{solver, Options, Problem, unwatched};
///
/// let problem = Problem::builder().creepage_x(0.05).elasticity(Rigid).build()?;
/// let solution = solver::solve(&problem, &Options::default(), &unwatched)?;
/// assert!(solution.normalised.x < -0.6);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rigid;

impl Elasticity for Rigid {
    fn compliance(&self, _grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        Ok(Box::new(Self))
    }

    fn is_scale_free(&self) -> bool {
        true
    }
}

impl Compliance for Rigid {
    fn displacement(&mut self, _traction: &VectorField, displacement: &mut VectorField) {
        displacement.clear();
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
}
