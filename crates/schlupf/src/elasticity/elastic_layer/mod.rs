//! The elastic layer of Neuhaus and Sextro (2014, Figure 2): point elements with springs to the
//! rigid wheel and to each other, on the contact area and its surroundings; Eqs. (4)–(7).
//!
//! Per unit area the lattice is c u − g_x δ²u/Δx² − g_y δ²u/Δy² = t with free edges, where u_x and
//! u_y have separate c and g. Along x a cosine transform (DCT-II) diagonalises it exactly, both
//! components together; along y a tridiagonal system remains for each wave number. Rows outside the
//! contact carry no traction, so they are condensed beforehand into the stiffness of the outermost
//! contact rows: this is the static condensation (6), (7) of the paper, done once. A product costs
//! O(n log n).

mod tridiagonal;
mod compliance;

use compliance::LayerCompliance;

use super::{Compliance, Elasticity};
use crate::normal::{BORDER, Grid};
use crate::numerics::fourier::smooth_from;
use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// Stiffnesses per area of the layer for one displacement component.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LayerStiffness {
    /// Bedding c: ratio of traction to displacement, in N/m³.
    pub bedding: f64,
    /// Coupling g between neighbours along rolling, in N/m.
    pub coupling_along_x: f64,
    /// Coupling g between neighbours across rolling, in N/m.
    pub coupling_along_y: f64,
}

impl LayerStiffness {
    /// Decay lengths √(g/c) along and across rolling, in m.
    pub fn decay_lengths(&self) -> [f64; 2] {
        [self.coupling_along_x, self.coupling_along_y].map(|g| (g / self.bedding).sqrt())
    }
}

/// The paper's discrete springs for one displacement component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// From an element to the wheel, Δc, in N/m.
    pub bedding: f64,
    /// From an element to each of its four neighbours, Δc_k, in N/m.
    pub coupling: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Stiffness {
    PerArea([LayerStiffness; 2]),
    Discrete([Springs; 2]),
}

/// The coupled elastic layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticLayer {
    stiffness: Stiffness,
    margin: Option<f64>,
}

/// Default margin in decay lengths √(g/c).
const DEFAULT_MARGIN: f64 = 8.0;

/// Maximum number of cells of the layer in one direction: contact and surroundings.
const MAX_LAYER_CELLS: f64 = 16384.0;

impl ElasticLayer {
    /// A layer with stiffnesses per area for the displacements along and across rolling, with at
    /// least `margin` (in m) of surroundings on each side; default: eight decay lengths √(g/c).
    ///
    /// ```
    /// use schlupf::Problem;
    /// use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
    ///
    /// let same =
    ///     LayerStiffness { bedding: 1e13, coupling_along_x: 3.24e7, coupling_along_y: 3.24e7 };
    /// let problem = Problem::builder().elasticity(ElasticLayer::new(same, same, None)?).build()?;
    /// assert!(problem.check().is_ok());
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(x: LayerStiffness, y: LayerStiffness, margin: Option<f64>) -> Result<Self, Error> {
        for ([bedding, along, across], s) in [
            ([Quantity::BeddingX, Quantity::CouplingX, Quantity::CouplingXAcross], x),
            ([Quantity::BeddingY, Quantity::CouplingY, Quantity::CouplingYAcross], y),
        ] {
            require_positive(bedding, s.bedding)?;
            require(along, Requirement::NotNegative, s.coupling_along_x)?;
            require(across, Requirement::NotNegative, s.coupling_along_y)?;
        }
        Self::checked(Stiffness::PerArea([x, y]), margin)
    }

    /// A layer with the paper's discrete springs. Its physics depends on the grid.
    pub fn from_springs(x: Springs, y: Springs, margin: Option<f64>) -> Result<Self, Error> {
        for (names, s) in [
            ([Quantity::SpringX, Quantity::SpringCouplingX], x),
            ([Quantity::SpringY, Quantity::SpringCouplingY], y),
        ] {
            require_positive(names[0], s.bedding)?;
            require(names[1], Requirement::NotNegative, s.coupling)?;
        }
        Self::checked(Stiffness::Discrete([x, y]), margin)
    }

    fn checked(stiffness: Stiffness, margin: Option<f64>) -> Result<Self, Error> {
        if let Some(margin) = margin {
            require(Quantity::Margin, Requirement::NotNegative, margin)?;
        }
        Ok(Self { stiffness, margin })
    }

    /// Stiffnesses per area on a grid: c = Δc/(Δx Δy), g = Δc_k Δx/Δy along x, Δc_k Δy/Δx along y.
    pub fn per_area(&self, grid: &Grid) -> [LayerStiffness; 2] {
        match self.stiffness {
            Stiffness::PerArea(stiffness) => stiffness,
            Stiffness::Discrete(springs) => springs.map(|s| LayerStiffness {
                bedding: s.bedding / grid.cell_area(),
                coupling_along_x: s.coupling * grid.spacing_x / grid.spacing_y,
                coupling_along_y: s.coupling * grid.spacing_y / grid.spacing_x,
            }),
        }
    }

    /// Number of surrounding cells beyond the grid on each side, along x and along y. The number of
    /// columns is rounded up to an efficient length of the transform.
    pub fn surroundings(&self, grid: &Grid) -> Result<Surroundings, Error> {
        let stiffness = self.per_area(grid);
        let margin = |direction: usize| {
            let decay = stiffness.iter().map(|s| s.decay_lengths()[direction]).fold(0.0, f64::max);
            self.margin.unwrap_or(DEFAULT_MARGIN * decay)
        };
        let [margin_x, margin_y] = [0, 1].map(margin);
        let cells_x = (margin_x / grid.spacing_x).ceil();
        let cells_y = (margin_y / grid.spacing_y).ceil();
        let largest = 2.0 * cells_x.max(cells_y) + grid.columns.max(grid.rows) as f64;
        if largest > MAX_LAYER_CELLS {
            let (margin, most) = (margin_x.max(margin_y), MAX_LAYER_CELLS);
            return Err(Error::LayerTooLarge { margin, cells: largest, most });
        }
        let columns = smooth_from(grid.columns + 2 * cells_x as usize);
        let ahead = (columns - grid.columns) / 2;
        Ok(Surroundings { columns, first_column: ahead, rows_beyond: cells_y as usize })
    }
}

/// The total area A_total around a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Surroundings {
    /// Columns of the total area.
    pub columns: usize,
    /// Column of the total area at which the grid starts.
    pub first_column: usize,
    /// Rows of the total area on each side of the grid.
    pub rows_beyond: usize,
}

impl Surroundings {
    /// The same area around a finer grid.
    fn refined(self, grid: &Grid, finer: &Grid) -> Self {
        let along = finer.columns_within() / grid.columns_within();
        Self {
            columns: along * self.columns,
            first_column: along * (self.first_column + BORDER) - BORDER,
            rows_beyond: finer.rows / grid.rows * self.rows_beyond,
        }
    }
}

impl Elasticity for ElasticLayer {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        self.compliance_on_finer(grid, grid)
    }

    /// Springs are those of the cells of `grid`, and the layer ends where it does there.
    fn compliance_on_finer(&self, grid: &Grid, finer: &Grid) -> Result<Box<dyn Compliance>, Error> {
        let layer = self.on_finer(grid, finer)?;
        Ok(match self.stiffness {
            Stiffness::PerArea(_) => Box::new(layer),
            // All stiffnesses per area are proportional to the inverse square of the size.
            Stiffness::Discrete(_) => Box::new(layer.growing(2.0)),
        })
    }
}

impl ElasticLayer {
    /// The layer of a grid on a finer one.
    pub(super) fn on_finer(&self, grid: &Grid, finer: &Grid) -> Result<LayerCompliance, Error> {
        let surroundings = self.surroundings(grid)?.refined(grid, finer);
        Ok(LayerCompliance::new(&self.per_area(grid), surroundings, *finer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::Extent;
    use approx::assert_relative_eq;

    /// The paper's springs on a grid equal the layer's stiffnesses per area on that grid.
    #[test]
    fn neuhaus_sextro_2014_discrete_springs() {
        let grid = Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-5e-3, 5e-3] }, 12, 9);
        let area = grid.cell_area();
        let springs = Springs { bedding: 1e13 * area, coupling: 3e7 };
        let layer = ElasticLayer::from_springs(springs, springs, None).unwrap().per_area(&grid);
        assert_relative_eq!(layer[0].bedding, 1e13, max_relative = 1e-14);
        let ratio = grid.spacing_x / grid.spacing_y;
        assert_relative_eq!(layer[1].coupling_along_x, 3e7 * ratio, max_relative = 1e-14);
        assert_relative_eq!(layer[1].coupling_along_y, 3e7 / ratio, max_relative = 1e-14);
    }
}
