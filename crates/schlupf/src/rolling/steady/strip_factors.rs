//! Jacobians of single strips, factorised.
//!
//! Along a strip a cell is displaced by its own traction and by those of two neighbours on either
//! side, compared with the displacement at the entry. With the slip taken of that, the Jacobian of
//! a strip is banded, with blocks of both components.

use std::ops::Range;

use crate::patch::Patch;
use crate::rolling::shared::cell::{inverse_2x2, times};
use crate::rolling::shared::coulomb::{CoulombContact, Matrix, SlipStencil, Slope, product_2x2};
use crate::rolling::shared::passage::pair;

/// Number of neighbours on either side that displace a cell.
const NEIGHBOURS: usize = 2;

/// Displacement of a neighbour relative to that of a cell itself, dimensionless, above which
/// neighbours are left out: those farther away then displace a cell nearly as much. So it is where
/// cells are much narrower than wide, and on fine grids of an elastic layer.
const MOST_ALIKE: f64 = 0.5;

/// Blocks to the left and to the right of the diagonal.
const LOWER: usize = 5;
const UPPER: usize = 3;
const WIDTH: usize = LOWER + 1 + UPPER;

/// Blocks of a row, from the left.
type Row = [Matrix; WIDTH];

/// The slip at every cell due to the tractions of its neighbourhood, and the factors of the
/// Jacobian made of it.
pub(super) struct StripFactors {
    /// In m/Pa.
    slips: Vec<Row>,
    rows: Vec<Row>,
    /// Inverse of the diagonal blocks of the upper factor.
    pivots: Vec<Matrix>,
}

impl StripFactors {
    /// Of a patch, where `row` is the compliance of cells at a distance of 0, 1, … columns, in
    /// m/Pa.
    pub fn new(
        patch: &Patch,
        contact: &CoulombContact,
        stencils: &[SlipStencil],
        row: &[[f64; 2]],
    ) -> Self {
        let mut slips = vec![Row::default(); patch.len()];
        let is_alike = |c: usize| row[1][c] > MOST_ALIKE * row[0][c];
        let has_neighbours = !is_alike(0) && !is_alike(1);
        let local = Local { patch, contact, row, has_neighbours };
        for cells in &contact.slivers.kept {
            for k in cells.clone() {
                for (j, weight) in stencils[k].cells(k) {
                    local.add(cells, j, weight, (k, &mut slips[k]));
                }
            }
        }
        Self {
            slips,
            rows: vec![Row::default(); patch.len()],
            pivots: vec![Matrix::default(); patch.len()],
        }
    }

    /// Factorises the Jacobian of a strip, with γ in Pa/m.
    pub fn factorise(&mut self, cells: &Range<usize>, slopes: &[Slope], gamma: f64) {
        for k in cells.clone() {
            let slope = &slopes[k];
            for (block, slip) in self.rows[k].iter_mut().zip(&self.slips[k]) {
                *block = product_2x2(&slope.by_pull, &slip.map(|row| row.map(|s| gamma * s)));
            }
            let diagonal = &mut self.rows[k][LOWER];
            subtract(diagonal, &slope.by_pull);
            subtract(diagonal, &[[-1.0, 0.0], [0.0, -1.0]]);
        }
        for k in cells.clone() {
            self.pivots[k] = inverse_2x2(self.rows[k][LOWER]);
            let pivot_row = self.rows[k];
            for i in k + 1..cells.end.min(k + LOWER + 1) {
                let row = &mut self.rows[i];
                let at = LOWER + k - i;
                let factor = product_2x2(&row[at], &self.pivots[k]);
                row[at] = factor;
                for right in 1..=UPPER {
                    subtract(
                        &mut row[at + right],
                        &product_2x2(&factor, &pivot_row[LOWER + right]),
                    );
                }
            }
        }
    }

    /// Solves for a strip, in place.
    pub fn solve(&self, cells: &Range<usize>, v: &mut [f64]) {
        for k in cells.clone() {
            let mut rest = pair(v, k);
            for j in k.saturating_sub(LOWER).max(cells.start)..k {
                let known = times(&self.rows[k][LOWER + j - k], pair(v, j));
                rest = [rest[0] - known[0], rest[1] - known[1]];
            }
            v[2 * k..2 * k + 2].copy_from_slice(&rest);
        }
        for k in cells.clone().rev() {
            let mut rest = pair(v, k);
            for j in k + 1..cells.end.min(k + UPPER + 1) {
                let known = times(&self.rows[k][LOWER + j - k], pair(v, j));
                rest = [rest[0] - known[0], rest[1] - known[1]];
            }
            let solved = times(&self.pivots[k], rest);
            v[2 * k..2 * k + 2].copy_from_slice(&solved);
        }
    }
}

fn subtract(from: &mut Matrix, what: &Matrix) {
    for r in 0..2 {
        for c in 0..2 {
            from[r][c] -= what[r][c];
        }
    }
}

/// Adds a symmetric block times a weight at a place of a row, if it is one.
fn add_block(row: &mut Row, at: usize, weight: f64, [xx, yy, xy]: [f64; 3]) {
    if let Some(block) = row.get_mut(at) {
        for (r, c, value) in [(0, 0, xx), (1, 1, yy), (0, 1, xy), (1, 0, xy)] {
            block[r][c] += weight * value;
        }
    }
}

/// Displacements of the cells of a strip relative to the entry.
struct Local<'a> {
    patch: &'a Patch,
    contact: &'a CoulombContact,
    row: &'a [[f64; 2]],
    has_neighbours: bool,
}

impl Local<'_> {
    /// Adds the displacement of cell `j` times a weight to the row of cell `k`.
    fn add(&self, cells: &Range<usize>, j: usize, weight: f64, (k, row): (usize, &mut Row)) {
        if !self.has_neighbours {
            let [[xx, xy], [_, yy]] = self.contact.local[j];
            add_block(row, (LOWER + j).wrapping_sub(k), weight, [xx, yy, xy]);
            return;
        }
        let mut put = |to: usize, symmetric: [f64; 3]| {
            add_block(row, (LOWER + to).wrapping_sub(k), weight, symmetric);
        };
        for to in j.saturating_sub(NEIGHBOURS).max(cells.start)..cells.end.min(j + NEIGHBOURS + 1) {
            let [xx, yy] = self.row[to.abs_diff(j)];
            put(to, [xx, yy, 0.0]);
        }
        put(j, self.contact.calibration.at_cells[j]);
        put(cells.start, self.contact.calibration.at_entries[j].map(|u| -u));
        let entry = self.patch.cells[j].entry_x();
        for to in cells.start..cells.end.min(cells.start + NEIGHBOURS + 1) {
            let [xx, yy] = self.at(entry, to);
            put(to, [-xx, -yy, 0.0]);
        }
    }

    /// Displacement at a place along the strip (in m) due to a cell, linear between columns.
    fn at(&self, x: f64, k: usize) -> [f64; 2] {
        let grid = &self.patch.grid;
        let columns =
            ((x - grid.x(self.patch.cells[k].index % grid.columns)) / grid.spacing_x).abs();
        let near = columns as usize;
        let share = columns - near as f64;
        let of = |n: usize| self.row.get(n).copied().unwrap_or_default();
        [0, 1].map(|c| (1.0 - share) * of(near)[c] + share * of(near + 1)[c])
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// The factors solve the banded system, strip by strip, in stick and in slip.
    #[test]
    fn factors_solve_the_jacobian() {
        let cells = 2..13;
        let entry = |k: usize, at: usize, c: usize| ((7 * k + 3 * at + 5 * c) % 11) as f64 - 5.0;
        let block = |k: usize, at: usize| {
            let own = if at == LOWER { 20.0 } else { 0.0 };
            [[own + entry(k, at, 0), entry(k, at, 1)], [entry(k, at, 2), own + entry(k, at, 3)]]
        };
        let slips: Vec<Row> = (0..14)
            .map(|k| std::array::from_fn(|at| block(k, at).map(|r| r.map(|s| 1e-2 * s))))
            .collect();
        let slopes: Vec<Slope> =
            (0..14).map(|k| Slope::at([0.3 * f64::from(k), 1.0], 2.0)).collect();
        let mut factors = StripFactors {
            slips: slips.clone(),
            rows: vec![Row::default(); 14],
            pivots: vec![Matrix::default(); 14],
        };
        factors.factorise(&cells, &slopes, 3.0);
        let right: Vec<f64> = (0..28).map(|n| f64::from((5 * n) % 9) - 4.0).collect();
        let mut v = right.clone();
        factors.solve(&cells, &mut v);
        for k in cells.clone() {
            let own = pair(&v, k);
            let mut slid = [0.0; 2];
            for j in k.saturating_sub(LOWER).max(cells.start)..cells.end.min(k + UPPER + 1) {
                let by = times(&slips[k][LOWER + j - k], pair(&v, j));
                slid = [slid[0] + 3.0 * by[0], slid[1] + 3.0 * by[1]];
            }
            let moved = times(&slopes[k].by_pull, [own[0] - slid[0], own[1] - slid[1]]);
            for c in 0..2 {
                assert_relative_eq!(own[c] - moved[c], right[2 * k + c], epsilon = 1e-11);
            }
        }
    }
}
