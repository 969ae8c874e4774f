//! The regular grid of cells on which a patch is discretised.

/// An axis-parallel rectangle in the contact frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Smallest and largest x, in m.
    pub x: [f64; 2],
    /// Smallest and largest y, in m.
    pub y: [f64; 2],
}

impl Extent {
    /// The smallest rectangle that contains both.
    pub fn union(&self, other: &Self) -> Self {
        let join = |p: [f64; 2], q: [f64; 2]| [p[0].min(q[0]), p[1].max(q[1])];
        Self { x: join(self.x, other.x), y: join(self.y, other.y) }
    }
}

/// Equidistant positions along a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// First position, in m.
    pub start: f64,
    /// Distance between positions, in m.
    pub spacing: f64,
    /// Number of positions.
    pub count: usize,
}

impl Axis {
    /// Position number `k`, in m.
    pub fn at(&self, k: usize) -> f64 {
        self.start + k as f64 * self.spacing
    }

    /// Index of the position nearest to a given one (in m), within the axis.
    pub fn nearest(&self, position: f64) -> usize {
        ((position - self.start) / self.spacing).round() as usize
    }

    /// All positions, in m.
    pub fn positions(&self) -> Vec<f64> {
        (0..self.count).map(|k| self.at(k)).collect()
    }
}

/// A regular grid of rectangular cells; cell (i, j) has column i along x and row j along y.
///
/// The first and the last [`BORDER`] columns are never in contact; they are needed to interpolate
/// the displacement just ahead of the leading edge.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Grid {
    /// Number of cells along x, border included.
    pub columns: usize,
    /// Number of cells along y.
    pub rows: usize,
    /// Cell size Δx, in m.
    pub spacing_x: f64,
    /// Cell size Δy, in m.
    pub spacing_y: f64,
    /// Lower x of the first column, in m.
    pub origin_x: f64,
    /// Lower y of the first row, in m.
    pub origin_y: f64,
}

/// Number of border columns on each side.
pub const BORDER: usize = 2;

impl Grid {
    /// A grid with exactly `cells_x` × `cells_y` cells across `extent`, plus the border.
    pub fn across(extent: &Extent, cells_x: usize, cells_y: usize) -> Self {
        let spacing_x = (extent.x[1] - extent.x[0]) / cells_x as f64;
        let spacing_y = (extent.y[1] - extent.y[0]) / cells_y as f64;
        Self {
            columns: cells_x + 2 * BORDER,
            rows: cells_y,
            spacing_x,
            spacing_y,
            origin_x: extent.x[0] - BORDER as f64 * spacing_x,
            origin_y: extent.y[0],
        }
    }

    /// The rectangle of its cells without the border.
    pub fn extent(&self) -> Extent {
        Extent {
            x: [self.edge_x(BORDER), self.edge_x(self.columns - BORDER)],
            y: [self.edge_y(0), self.edge_y(self.rows)],
        }
    }

    /// Half the length and half the width of its cells without the border, in m.
    pub fn semi_axes(&self) -> [f64; 2] {
        let half = |cells: usize, spacing: f64| 0.5 * cells as f64 * spacing;
        [half(self.columns_within(), self.spacing_x), half(self.rows, self.spacing_y)]
    }

    /// Number of cells along x without the border.
    pub fn columns_within(&self) -> usize {
        self.columns - 2 * BORDER
    }

    /// Number of cells, border included.
    pub fn len(&self) -> usize {
        self.columns * self.rows
    }

    /// Whether there are no cells.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Index of cell (i, j) in a field: rows along x, one after another.
    pub fn index(&self, i: usize, j: usize) -> usize {
        j * self.columns + i
    }

    /// Centre of column `i`, in m.
    pub fn x(&self, i: usize) -> f64 {
        self.edge_x(i) + 0.5 * self.spacing_x
    }

    /// Centre of row `j`, in m.
    pub fn y(&self, j: usize) -> f64 {
        self.edge_y(j) + 0.5 * self.spacing_y
    }

    /// Lower x of column `i`, in m.
    pub fn edge_x(&self, i: usize) -> f64 {
        self.origin_x + i as f64 * self.spacing_x
    }

    /// Lower y of row `j`, in m.
    pub fn edge_y(&self, j: usize) -> f64 {
        self.origin_y + j as f64 * self.spacing_y
    }

    /// Area of a cell, in m².
    pub fn cell_area(&self) -> f64 {
        self.spacing_x * self.spacing_y
    }
}

/// A tangential vector in every cell of a grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct VectorField {
    /// Component along rolling, in Pa or in m.
    pub x: Vec<f64>,
    /// Component across rolling, in Pa or in m.
    pub y: Vec<f64>,
}

impl VectorField {
    /// Zero in all `len` cells.
    pub fn zeros(len: usize) -> Self {
        Self { x: vec![0.0; len], y: vec![0.0; len] }
    }

    /// Sets every vector to zero.
    pub fn clear(&mut self) {
        self.x.fill(0.0);
        self.y.fill(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn cells_span_the_extent_exactly_and_the_border_lies_outside() {
        let extent = Extent { x: [-3.0, 3.0], y: [-2.0, 2.0] };
        let grid = Grid::across(&extent, 6, 4);
        assert_eq!((grid.columns, grid.rows), (6 + 2 * BORDER, 4));
        assert_relative_eq!(grid.edge_x(BORDER), -3.0);
        assert_relative_eq!(grid.edge_x(6 + BORDER), 3.0);
        assert_relative_eq!(grid.x(BORDER), -2.5);
        assert_relative_eq!(grid.y(3), 1.5);
    }
}
