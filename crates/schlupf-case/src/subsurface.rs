//! Where a case asks for stresses below the surface.

use schlupf::analysis::temperature_field::Side;
use schlupf::normal::{Grid, NormalSummary};

/// A box below the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SubsurfaceRequest {
    /// In which body.
    pub side: Side,
    /// Depth of the deepest layer, in m; by default twice the larger semi-axis.
    pub depth: Option<f64>,
    /// Number of layers, at least two.
    pub layers: usize,
    /// Surroundings of the patch on each side, in m; by default half of its size each way.
    pub margin: Option<f64>,
}

impl SubsurfaceRequest {
    /// Most points of all layers together: their stresses take some hundreds of megabytes.
    pub const MOST_POINTS: usize = 5_000_000;

    /// Most points of the lattice on which a layer is computed: some 800 megabytes.
    pub const MOST_LATTICE_POINTS: usize = 4_000_000;

    /// The depths of the layers below a contact, in m.
    pub fn depths(&self, normal: &NormalSummary) -> Vec<f64> {
        let deepest = self.depth.unwrap_or(2.0 * normal.semi_axis_x.max(normal.semi_axis_y));
        let last = self.layers.max(2) - 1;
        (0..=last).map(|k| deepest * k as f64 / last as f64).collect()
    }

    /// The margin in columns and rows of the grid of a contact.
    pub fn margin(&self, normal: &NormalSummary, grid: &Grid) -> [usize; 2] {
        let lengths = normal.semi_axes();
        let spacings = [grid.spacing_x, grid.spacing_y];
        std::array::from_fn(|c| (self.margin.unwrap_or(lengths[c]) / spacings[c]).ceil() as usize)
    }

    /// Number of points of all layers together, dimensionless: it may be beyond any whole number.
    pub fn points(&self, normal: &NormalSummary, grid: &Grid) -> f64 {
        let [columns, rows] = self.margin(normal, grid).map(|margin| 2.0 * margin as f64);
        (columns + grid.columns as f64) * (rows + grid.rows as f64) * self.layers as f64
    }
}
