//! Transfer between a grid and a coarser one: tractions divided by the normal pressure.

use crate::normal::Grid;
use crate::normal::patch::{Cell, Patch};

/// Weights between the cells of a fine and a coarse patch of the same contact.
///
/// The transferred quantity is the traction divided by the pressure: bilinear between the cells of
/// the coarse patch in one direction, and as a weighted mean in the other. (With weights in single
/// precision mirror images would differ by more than rounding.)
#[derive(Debug)]
pub(super) struct Transfer {
    /// Stencil of each fine cell in the coarse ones: prolongation.
    stencils: Vec<Stencil>,
    /// Weights of each coarse cell in the fine ones, one cell after another: restriction.
    shares: Vec<(u32, f64)>,
    /// End of the shares of each coarse cell.
    ends: Vec<usize>,
}

#[derive(Debug, Clone, Copy, Default)]
struct Stencil {
    cell: [u32; 4],
    weight: [f64; 4],
}

impl Transfer {
    pub fn new(fine: &Patch, coarse: &Patch) -> Self {
        let mut numbers = vec![None; coarse.grid.len()];
        for (k, cell) in coarse.cells.iter().enumerate() {
            numbers[cell.index] = Some(k);
        }
        let bilinear = |cell: &Cell| bilinear(&fine.grid, cell, coarse, &numbers);
        let corners: Vec<[(usize, f64); 4]> = fine.cells.iter().map(bilinear).collect();
        let mut rows = vec![Vec::new(); coarse.len()];
        for (k, corners) in corners.iter().enumerate() {
            for (cell, weight) in corners.iter().filter(|(_, weight)| *weight > 0.0) {
                rows[*cell].push((k, weight * over(fine.cells[k].pressure)));
            }
        }
        let pairs = corners.iter().zip(&fine.cells);
        let stencils = pairs.map(|(corners, cell)| Stencil {
            cell: corners.map(|(to, _)| to as u32),
            weight: corners
                .map(|(to, weight)| weight * cell.pressure * over(coarse.cells[to].pressure)),
        });
        let mut transfer =
            Self { stencils: stencils.collect(), shares: Vec::new(), ends: Vec::new() };
        for (row, cell) in rows.iter().zip(&coarse.cells) {
            let total: f64 = row.iter().map(|(k, share)| share * fine.cells[*k].pressure).sum();
            let factor = cell.pressure * over(total);
            let shares = row.iter().map(|(k, share)| (*k as u32, factor * share));
            transfer.shares.extend(shares);
            transfer.ends.push(transfer.shares.len());
        }
        transfer
    }

    /// Adds coarse tractions, divided by the coarse pressure and multiplied by the fine pressure,
    /// to fine ones.
    pub fn add_prolonged(&self, coarse: &[f64], fine: &mut [f64]) {
        for (stencil, fine) in self.stencils.iter().zip(fine.chunks_exact_mut(2)) {
            for (cell, weight) in stencil.cell.iter().zip(stencil.weight) {
                let from = &coarse[2 * *cell as usize..][..2];
                fine[0] += weight * from[0];
                fine[1] += weight * from[1];
            }
        }
    }

    /// Overwrites coarse tractions with the means of fine ones divided by the pressure, multiplied
    /// by the coarse pressure.
    pub fn restrict(&self, fine: &[f64], coarse: &mut [f64]) {
        let mut start = 0;
        for (end, coarse) in self.ends.iter().zip(coarse.chunks_exact_mut(2)) {
            let mut sum = [0.0; 2];
            for (k, share) in &self.shares[start..*end] {
                let from = &fine[2 * *k as usize..][..2];
                sum[0] += share * from[0];
                sum[1] += share * from[1];
            }
            coarse.copy_from_slice(&sum);
            start = *end;
        }
    }
}

/// 1/x, and zero for zero.
fn over(x: f64) -> f64 {
    if x > 0.0 { x.recip() } else { 0.0 }
}

/// Coarse cells in contact about the centre of a fine one, with their bilinear weights.
fn bilinear(
    fine: &Grid,
    cell: &Cell,
    coarse: &Patch,
    numbers: &[Option<usize>],
) -> [(usize, f64); 4] {
    let grid = &coarse.grid;
    let (i, j) = (cell.index % fine.columns, cell.index / fine.columns);
    let along = (fine.x(i) - grid.x(0)) / grid.spacing_x;
    let across = (fine.y(j) - grid.y(0)) / grid.spacing_y;
    let (column, row) = (along.floor(), across.floor());
    let (wx, wy) = (along - column, across - row);
    let mut found = [(0, 0.0); 4];
    let mut total = 0.0;
    let corners = [(0, 0), (1, 0), (0, 1), (1, 1)];
    let weights = [(1.0 - wx) * (1.0 - wy), wx * (1.0 - wy), (1.0 - wx) * wy, wx * wy];
    for (n, ((di, dj), weight)) in corners.into_iter().zip(weights).enumerate() {
        let (i, j) = (column as isize + di, row as isize + dj);
        let inside =
            (0..grid.columns as isize).contains(&i) && (0..grid.rows as isize).contains(&j);
        let number = if inside { numbers[grid.index(i as usize, j as usize)] } else { None };
        if let Some(number) = number {
            found[n] = (number, weight);
            total += weight;
        }
    }
    if total > 0.0 {
        return found.map(|(number, weight)| (number, weight / total));
    }
    let distance = |k: &usize| {
        let other = &coarse.cells[*k];
        (other.x - cell.x).hypot(other.y - cell.y)
    };
    let nearest = (0..coarse.len()).min_by(|k, l| distance(k).total_cmp(&distance(l)));
    [1.0, 0.0, 0.0, 0.0].map(|weight| (nearest.unwrap_or(0), weight))
}
