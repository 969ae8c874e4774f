//! Loads on the surface of a body.

use crate::error::{Error, require_finite};
use crate::grid::{BORDER, Grid};
use crate::patch::Patch;
use crate::problem::Problem;
use crate::quantity::Quantity;
use crate::solution::Solution;
use crate::temperature_field::Side;

/// Loads on the surface of a body, in the cells of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceLoad {
    /// Pressure, in Pa.
    pub pressure: Vec<f64>,
    /// Traction on the body along rolling, in Pa.
    pub traction_x: Vec<f64>,
    /// Traction on the body across rolling, in Pa.
    pub traction_y: Vec<f64>,
}

/// Pieces across the patch up to which cells are divided, and most pieces of one cell.
const PIECES_ACROSS: usize = 72;
const MOST_PIECES: usize = 9;

impl SurfaceLoad {
    /// Pressure and tractions with their quantities.
    pub(super) fn fields(&self) -> [(Quantity, &[f64]); 3] {
        [
            (Quantity::Pressure, &self.pressure),
            (Quantity::TractionX, &self.traction_x),
            (Quantity::TractionY, &self.traction_y),
        ]
    }

    /// Checks that there is one finite number for every cell.
    pub(super) fn check(&self, grid: &Grid) -> Result<(), Error> {
        for (quantity, values) in self.fields() {
            if values.len() != grid.len() {
                let (expected, count) = (grid.len(), values.len());
                return Err(Error::WrongCount { quantity, expected, count });
            }
            values.iter().try_for_each(|value| require_finite(quantity, *value))?;
        }
        Ok(())
    }

    /// The loads of a solution on one of the bodies, in so many pieces of every cell each way: the
    /// load of a cell is distributed as the pressure is, so a piece has the mean pressure of its
    /// own part, and the traction that is the same part of it as in the cell.
    pub(super) fn of_solution(
        problem: &Problem,
        solution: &Solution,
        side: Side,
    ) -> Result<(Self, usize), Error> {
        let fields = &solution.fields;
        let grid = &fields.grid;
        let across = grid.rows.min(grid.columns.saturating_sub(2 * BORDER)).max(1);
        // An odd number, so that the middle of a cell is that of a piece.
        let pieces = (PIECES_ACROSS.div_ceil(across) | 1).min(MOST_PIECES);
        let finer = divided(grid, pieces);
        let normal = problem.normal.normal_contact(Some(solution.normal.load))?;
        let mut shape = vec![0.0; finer.len()];
        for cell in &Patch::new(&normal, finer).cells {
            shape[cell.index] = cell.pressure;
        }
        let sign = match side {
            Side::Wheel => 1.0,
            Side::Rail => -1.0,
        };
        let zero = || vec![0.0; finer.len()];
        let mut load = Self { pressure: zero(), traction_x: zero(), traction_y: zero() };
        for (k, [column, row]) in fields.cell.iter().enumerate() {
            let part =
                |p: usize| finer.index(column * pieces + p % pieces, row * pieces + p / pieces);
            let mean = (0..pieces * pieces).map(|p| shape[part(p)]).sum::<f64>()
                / (pieces * pieces) as f64;
            for at in (0..pieces * pieces).map(part) {
                let weight = if mean > 0.0 { shape[at] / mean } else { 1.0 };
                load.pressure[at] = weight * fields.pressure[k];
                load.traction_x[at] = sign * weight * fields.traction_x[k];
                load.traction_y[at] = sign * weight * fields.traction_y[k];
            }
        }
        Ok((load, pieces))
    }
}

/// A grid with every cell divided into so many pieces each way.
pub(super) fn divided(grid: &Grid, pieces: usize) -> Grid {
    Grid {
        columns: grid.columns * pieces,
        rows: grid.rows * pieces,
        spacing_x: grid.spacing_x / pieces as f64,
        spacing_y: grid.spacing_y / pieces as f64,
        ..*grid
    }
}
