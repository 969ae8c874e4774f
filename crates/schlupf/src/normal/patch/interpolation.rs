//! Interpolation from the centres of the grid's cells to points of the patch, and the transpose.

use crate::normal::{Grid, VectorField};
use crate::numerics::interpolation::{bilinear, cubic};

use super::{Cell, Patch};

/// Interpolation to the points of the cells and to the leading edge of the patch.
///
/// In a fully covered cell the point is the centre. In others it is the centroid of the covered
/// part, with bilinear interpolation between four centres; forces are spread by the transpose, so
/// that they act at the centroid and a symmetric compliance stays symmetric. At the leading edge,
/// where the displacement changes rapidly, the interpolation along rolling is cubic.
#[derive(Debug, Clone)]
pub struct Interpolation {
    index: Vec<usize>,
    /// Factor by which the displacement of each partly covered cell exceeds that under its mean
    /// traction, because the traction acts on the covered part only; for cells that do not displace
    /// each other.
    concentrated: Vec<(usize, f64)>,
    partial: Vec<(usize, Stencil<4>)>,
    /// Entry point of the material of each cell, as an index into `entries`.
    entry_of: Vec<usize>,
    entries: Vec<Stencil<8>>,
}

/// A weighted sum of values on the grid.
#[derive(Debug, Clone, Copy)]
struct Stencil<const N: usize> {
    index: [usize; N],
    weight: [f64; N],
}

impl<const N: usize> Stencil<N> {
    fn sum(&self, field: &VectorField) -> [f64; 2] {
        let of = |values: &[f64]| {
            self.index.iter().zip(self.weight).map(|(i, w)| w * values[*i]).sum::<f64>()
        };
        [of(&field.x), of(&field.y)]
    }
}

/// Covered fraction below which the displacement of a cell no longer increases: a nearly empty cell
/// would be too compliant for the solver, and bears next to nothing.
const LEAST_COVERED: f64 = 0.1;

/// Offsets below this fraction of the spacing are rounding error.
const CENTRED: f64 = 1e-9;

impl Interpolation {
    /// The weights of a patch.
    pub fn new(patch: &Patch) -> Self {
        let grid = &patch.grid;
        let mut entries = Vec::new();
        let mut entry_of = Vec::with_capacity(patch.len());
        for strip in &patch.strips {
            let mut last = f64::NAN;
            for cell in &patch.cells[strip.cells.clone()] {
                let x = cell.entry_x();
                let is_new = (x - last).abs() > CENTRED * grid.spacing_x || last.is_nan();
                if is_new {
                    entries.push(at_edge(grid, strip.row, [x, cell.y]));
                    last = x;
                }
                entry_of.push(entries.len() - 1);
            }
        }
        let partial = patch.cells.iter().enumerate();
        Self {
            index: patch.cells.iter().map(|c| c.index).collect(),
            concentrated: Vec::new(),
            partial: partial.filter_map(|(k, cell)| Some((k, centroid(grid, cell)?))).collect(),
            entry_of,
            entries,
        }
    }

    /// Values of each cell over its covered part, and zero at the edges: for bodies whose cells do
    /// not displace each other.
    pub fn uncoupled(patch: &Patch) -> Self {
        let cells = patch.cells.iter().enumerate();
        let partly = cells.filter(|(_, cell)| !cell.is_covered());
        Self {
            index: patch.cells.iter().map(|c| c.index).collect(),
            concentrated: partly
                .map(|(k, cell)| (k, cell.covered.max(LEAST_COVERED).recip()))
                .collect(),
            partial: Vec::new(),
            entry_of: Vec::new(),
            entries: Vec::new(),
        }
    }

    /// Displacements (x then y component of each cell) at the cells' points.
    pub fn gather(&self, field: &VectorField, values: &mut [f64]) {
        self.gather_means(field, values);
        for (k, factor) in &self.concentrated {
            values[2 * k] *= factor;
            values[2 * k + 1] *= factor;
        }
    }

    /// The same regardless of where in a partly covered cell the traction acts: the transpose of
    /// [`Self::spread`].
    pub fn gather_means(&self, field: &VectorField, values: &mut [f64]) {
        for (k, &index) in self.index.iter().enumerate() {
            values[2 * k] = field.x[index];
            values[2 * k + 1] = field.y[index];
        }
        for (k, stencil) in &self.partial {
            values[2 * k..2 * k + 2].copy_from_slice(&stencil.sum(field));
        }
    }

    /// The transpose of [`Self::gather_means`]; overwrites the field.
    pub fn spread(&self, values: &[f64], field: &mut VectorField) {
        field.clear();
        for (k, &index) in self.index.iter().enumerate() {
            field.x[index] = values[2 * k];
            field.y[index] = values[2 * k + 1];
        }
        // The value of a cell is already there; if it belongs to other cells too, it is
        // distributed.
        for (k, stencil) in &self.partial {
            let value = [values[2 * k], values[2 * k + 1]];
            field.x[self.index[*k]] -= value[0];
            field.y[self.index[*k]] -= value[1];
            for (index, weight) in stencil.index.iter().zip(stencil.weight) {
                field.x[*index] += weight * value[0];
                field.y[*index] += weight * value[1];
            }
        }
    }

    /// Values where the material of each cell entered the contact (x then y component).
    pub fn gather_at_entries(&self, field: &VectorField, values: &mut [f64]) {
        values.fill(0.0);
        let mut last = None;
        for (value, &entry) in values.chunks_exact_mut(2).zip(&self.entry_of) {
            // Neighbours mostly share their entry.
            let at = match last {
                Some((number, at)) if number == entry => at,
                _ => self.entries[entry].sum(field),
            };
            last = Some((entry, at));
            value.copy_from_slice(&at);
        }
    }
}

/// The row next to `row` in the direction of the offset (in spacings), and its weight.
fn beside(row: usize, offset: f64, count: usize) -> (usize, f64) {
    let next = if offset < 0.0 { row.checked_sub(1) } else { Some(row + 1) };
    next.filter(|n| *n < count).map_or((row, 0.0), |n| (n, offset.abs()))
}

/// Bilinear weights at the centroid of a cell, unless that is its centre.
fn centroid(grid: &Grid, cell: &Cell) -> Option<Stencil<4>> {
    let (i, j) = (cell.index % grid.columns, cell.index / grid.columns);
    let offset_x = (cell.x - grid.x(i)) / grid.spacing_x;
    let offset_y = (cell.y - grid.y(j)) / grid.spacing_y;
    if offset_x.abs() < CENTRED && offset_y.abs() < CENTRED {
        return None;
    }
    let (ni, wx) = beside(i, offset_x, grid.columns);
    let (nj, wy) = beside(j, offset_y, grid.rows);
    Some(Stencil {
        index: [grid.index(i, j), grid.index(ni, j), grid.index(i, nj), grid.index(ni, nj)],
        weight: bilinear([wx, wy]),
    })
}

/// Weights at a point of the leading edge: cubic (Lagrange) along x, linear along y.
fn at_edge(grid: &Grid, row: usize, [x, y]: [f64; 2]) -> Stencil<8> {
    let position = (x - grid.x(0)) / grid.spacing_x;
    let (first, smooth) = cubic(position, grid.columns);
    let (other, weight) = beside(row, (y - grid.y(row)) / grid.spacing_y, grid.rows);
    Stencil {
        index: std::array::from_fn(|k| grid.index(first + k % 4, if k < 4 { row } else { other })),
        weight: std::array::from_fn(|k| smooth[k % 4] * if k < 4 { 1.0 - weight } else { weight }),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::{Ellipse, Extent, PressureSource};
    use crate::numerics::vector::dot;

    fn patch() -> Patch {
        let source = Ellipse::from_peak_pressure(6e-3, 4e-3, 1e9).unwrap();
        let contact = source.normal_contact(None).unwrap();
        let extent: Extent = contact.extent();
        Patch::new(&contact, Grid::across(&extent, 11, 8))
    }

    /// A field that is linear in x and y is interpolated exactly at every point, and spreading is
    /// the transpose.
    #[test]
    fn linear_fields_are_exact_and_spreading_is_the_transpose() {
        let patch = patch();
        let grid = patch.grid;
        let interpolation = Interpolation::new(&patch);
        let mut field = VectorField::zeros(grid.len());
        for j in 0..grid.rows {
            for i in 0..grid.columns {
                field.x[grid.index(i, j)] = 3.0 * grid.x(i) - 2.0 * grid.y(j);
                field.y[grid.index(i, j)] = grid.x(i).powi(2);
            }
        }
        let mut values = vec![0.0; 2 * patch.len()];
        interpolation.gather(&field, &mut values);
        let mut at_entries = vec![0.0; 2 * patch.len()];
        interpolation.gather_at_entries(&field, &mut at_entries);
        for (k, cell) in patch.cells.iter().enumerate() {
            let exact = 3.0 * cell.x - 2.0 * cell.y;
            assert_relative_eq!(values[2 * k], exact, epsilon = 1e-15, max_relative = 1e-12);
            let exact = 3.0 * cell.entry_x() - 2.0 * cell.y;
            assert_relative_eq!(at_entries[2 * k], exact, epsilon = 1e-15, max_relative = 1e-9);
            let square = cell.entry_x().powi(2);
            assert_relative_eq!(at_entries[2 * k + 1], square, max_relative = 1e-9);
        }
        let p: Vec<f64> = (0..2 * patch.len()).map(|k| ((k * 7) % 11) as f64 - 4.0).collect();
        let mut spread = VectorField::zeros(grid.len());
        interpolation.spread(&p, &mut spread);
        let there = dot(&spread.x, &field.x) + dot(&spread.y, &field.y);
        assert_relative_eq!(dot(&p, &values), there, max_relative = 1e-12);
    }
}
