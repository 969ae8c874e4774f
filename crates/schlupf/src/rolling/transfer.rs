//! From a grid to a coarser one and back: tractions over the normal pressure.

use crate::grid::Grid;
use crate::patch::{Cell, Patch};

/// Weights between the cells of a fine and a coarse patch of the same contact.
///
/// What is carried is the traction over the pressure, bilinear between the cells of the coarse
/// patch, and as a weighted mean the other way.
#[derive(Debug)]
pub(super) struct Transfer {
    stencils: Vec<Stencil>,
    /// Pressures of both patches, in Pa.
    fine_pressure: Vec<f64>,
    coarse_pressure: Vec<f64>,
    /// Sum of the weights of each coarse cell.
    total: Vec<f64>,
}

#[derive(Debug, Clone, Copy, Default)]
struct Stencil {
    cell: [usize; 4],
    weight: [f64; 4],
}

impl Transfer {
    pub fn new(fine: &Patch, coarse: &Patch) -> Self {
        let mut numbers = vec![None; coarse.grid.len()];
        for (k, cell) in coarse.cells.iter().enumerate() {
            numbers[cell.index] = Some(k);
        }
        let stencil = |cell: &Cell| stencil(&fine.grid, cell, coarse, &numbers);
        let stencils: Vec<Stencil> = fine.cells.iter().map(stencil).collect();
        let mut total = vec![0.0; coarse.len()];
        for stencil in &stencils {
            for (cell, weight) in stencil.cell.iter().zip(stencil.weight) {
                total[*cell] += weight;
            }
        }
        let pressure = |patch: &Patch| patch.cells.iter().map(|cell| cell.pressure).collect();
        Self { stencils, fine_pressure: pressure(fine), coarse_pressure: pressure(coarse), total }
    }

    /// Adds to fine tractions what coarse ones are over the pressure, times the fine pressure.
    pub fn add_prolonged(&self, coarse: &[f64], fine: &mut [f64]) {
        for (k, stencil) in self.stencils.iter().enumerate() {
            let mut sum = [0.0; 2];
            for (cell, weight) in stencil.cell.iter().zip(stencil.weight) {
                let share = weight * over(self.coarse_pressure[*cell]);
                sum[0] += share * coarse[2 * cell];
                sum[1] += share * coarse[2 * cell + 1];
            }
            fine[2 * k] += self.fine_pressure[k] * sum[0];
            fine[2 * k + 1] += self.fine_pressure[k] * sum[1];
        }
    }

    /// Overwrites coarse tractions with the means of fine ones over the pressure, times the coarse
    /// pressure.
    pub fn restrict(&self, fine: &[f64], coarse: &mut [f64]) {
        coarse.fill(0.0);
        for (k, stencil) in self.stencils.iter().enumerate() {
            let share = over(self.fine_pressure[k]);
            for (cell, weight) in stencil.cell.iter().zip(stencil.weight) {
                coarse[2 * cell] += weight * share * fine[2 * k];
                coarse[2 * cell + 1] += weight * share * fine[2 * k + 1];
            }
        }
        for (k, total) in self.total.iter().enumerate() {
            let factor = if *total > 0.0 { self.coarse_pressure[k] / total } else { 0.0 };
            coarse[2 * k] *= factor;
            coarse[2 * k + 1] *= factor;
        }
    }
}

/// 1/p, and nothing for no pressure.
fn over(pressure: f64) -> f64 {
    if pressure > 0.0 { pressure.recip() } else { 0.0 }
}

/// Bilinear weights at the centre of a fine cell, among coarse cells in contact.
fn stencil(fine: &Grid, cell: &Cell, coarse: &Patch, numbers: &[Option<usize>]) -> Stencil {
    let grid = &coarse.grid;
    let (i, j) = (cell.index % fine.columns, cell.index / fine.columns);
    let along = (fine.x(i) - grid.x(0)) / grid.spacing_x;
    let across = (fine.y(j) - grid.y(0)) / grid.spacing_y;
    let (column, row) = (along.floor(), across.floor());
    let (wx, wy) = (along - column, across - row);
    let mut stencil = Stencil::default();
    let mut total = 0.0;
    let corners = [(0, 0), (1, 0), (0, 1), (1, 1)];
    let weights = [(1.0 - wx) * (1.0 - wy), wx * (1.0 - wy), (1.0 - wx) * wy, wx * wy];
    for (n, ((di, dj), weight)) in corners.into_iter().zip(weights).enumerate() {
        let (i, j) = (column as isize + di, row as isize + dj);
        let inside = (0..grid.columns as isize).contains(&i) && (0..grid.rows as isize).contains(&j);
        let number = if inside { numbers[grid.index(i as usize, j as usize)] } else { None };
        if let Some(number) = number {
            stencil.cell[n] = number;
            stencil.weight[n] = weight;
            total += weight;
        }
    }
    if total > 0.0 {
        stencil.weight = stencil.weight.map(|weight| weight / total);
        return stencil;
    }
    let distance = |k: &usize| {
        let other = &coarse.cells[*k];
        (other.x - cell.x).hypot(other.y - cell.y)
    };
    let nearest = (0..coarse.len()).min_by(|k, l| distance(k).total_cmp(&distance(l)));
    Stencil { cell: [nearest.unwrap_or(0); 4], weight: [1.0, 0.0, 0.0, 0.0] }
}
