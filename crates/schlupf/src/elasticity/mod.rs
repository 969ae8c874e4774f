//! How the two bodies deform under tangential traction, u = A t.

pub mod calibrated_layer;
mod calibration_table;
pub mod elastic_layer;
pub mod half_space;
pub mod rigid;
pub mod winkler;

use std::fmt::Debug;

use crate::error::Error;
use crate::grid::{Grid, VectorField};
use crate::warning::Warning;

/// A model of elasticity. Extension point.
pub trait Elasticity: Debug + Send + Sync {
    /// The compliance on the cells of a grid.
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error>;

    /// What the model leaves out for the bodies at hand, if the reader of results must know.
    fn caveat(&self) -> Option<Warning> {
        None
    }

    /// The same for a patch of several separate parts, where the model is made for one.
    fn caveat_of_parts(&self, _parts: usize) -> Option<Warning> {
        None
    }
}

/// Displacement from traction on the cells of one grid; symmetric and not negative.
pub trait Compliance: Debug + Send + Sync {
    /// Displacement difference u, wheel minus rail (in m), of every cell of the grid under the
    /// traction t on the wheel (in Pa).
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField);

    /// Change of the displacement (in m) with the logarithm of the size of the grid, all lengths
    /// growing alike. Whether the model knows it; if not, nothing is written.
    fn displacement_by_size(
        &mut self,
        _traction: &VectorField,
        _displacement: &mut VectorField,
    ) -> bool {
        false
    }

    /// Whether a loaded cell moves its neighbours. If not, nothing moves ahead of the leading edge.
    fn couples_cells(&self) -> bool;

    /// Whether the displacement falls exponentially with the distance from a loaded cell. Then a
    /// grid of a few cells still tells how the whole patch gives way.
    fn is_short_ranged(&self) -> bool {
        false
    }

    /// Largest displacement at the outer edge of the modelled surface over the largest one
    /// anywhere, dimensionless; zero where the model has no outer edge.
    fn edge_displacement(&mut self, _traction: &VectorField) -> f64 {
        0.0
    }
}
