//! Correction of the displacement by that under a traction for which it is known.
//!
//! Constant tractions in the cells do not represent the root-like traction at the edge of a patch
//! well: the displacement there is that of an edge shifted by a part of a cell. Under p = pₙ it is
//! known exactly, or at least much better on a finer grid. As p/pₙ is smooth at the edge, what is
//! missing of the displacement under any p is, to leading order, what is missing under pₙ times
//! p/pₙ of the cell itself, and at the entry times that of the first cell of the strip.

use std::ops::Range;

use crate::elasticity::EllipsoidalTraction;
use crate::normal::patch::{Interpolation, Patch};
use crate::normal::{Grid, NormalContact, Pressure, VectorField};
use crate::numerics::interpolation::cubic;
use crate::problem::{MAX_CELLS_TOGETHER, Problem};
use crate::reporting::Error;
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::settings;

/// Displacement of a point under tractions along both axes: xx, yy and xy, in m or in m/Pa.
pub(in crate::solver::rolling) type Symmetric = [f64; 3];

/// What is missing of the displacement under p = pₙ, in m.
pub(in crate::solver::rolling) struct Missing {
    pub at_cells: Vec<Symmetric>,
    pub at_entries: Vec<Symmetric>,
}

/// The same over the pressure of the cell, or of the first one of the strip that is kept; in m/Pa.
pub(in crate::solver::rolling) struct Calibration {
    pub at_cells: Vec<Symmetric>,
    pub at_entries: Vec<Symmetric>,
    /// The first cell of the strip of each cell.
    first: Vec<usize>,
}

/// What is calibrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solver::rolling) enum Calibrated {
    /// The displacement.
    Displacement,
    /// Its derivative with respect to the logarithm of the patch size, at the same pressure.
    BySize,
    /// Its part that is the shear of the layer between the surfaces.
    OfLayer,
}

impl Missing {
    /// In none of some cells.
    pub fn nothing(cells: usize) -> Self {
        let nothing = vec![[0.0; 3]; cells];
        Self { at_cells: nothing.clone(), at_entries: nothing }
    }

    /// Of the contact of a problem: against the exact displacement if it is known, and otherwise
    /// that on a finer grid. Nothing is missing if cells are not coupled. `None` if the
    /// elasticity does not know the derivative.
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        contact: &mut DiscreteContact,
        of: Calibrated,
    ) -> Result<Option<Self>, Error> {
        if !contact.compliance.couples_cells() {
            return Ok(Some(Self::nothing(contact.patch.len())));
        }
        let Some(exact) = Exact::of(problem, normal, &contact.patch.grid, of)? else {
            return Ok(None);
        };
        let Some([mut at_cells, mut at_entries]) = discrete(contact, of) else { return Ok(None) };
        // The layer is sheared by the traction of the point above it, whatever the patch size.
        let layer = if of == Calibrated::BySize { 0.0 } else { contact.layer_compliance };
        for (k, cell) in contact.patch.cells.iter().enumerate() {
            let known = [[cell.x, cell.y], [cell.entry_x(), cell.y]].map(|at| exact.at(at));
            for (missing, known) in [&mut at_cells[k], &mut at_entries[k]].into_iter().zip(known) {
                *missing = std::array::from_fn(|c| known[c] - missing[c]);
            }
            let sheared = layer * cell.pressure_where_covered();
            at_cells[k][0] += sheared;
            at_cells[k][1] += sheared;
        }
        Ok(Some(Self { at_cells, at_entries }))
    }
}

impl Calibration {
    /// For the cells of a patch of which `kept` carry tractions of their own.
    pub fn new(missing: &Missing, patch: &Patch, kept: &[Range<usize>]) -> Self {
        let mut first: Vec<usize> = (0..patch.len()).collect();
        for cells in kept {
            first[cells.clone()].fill(cells.start);
        }
        let over = |missing: &Symmetric, k: usize| missing.map(|u| u / patch.cells[k].pressure);
        let own = missing.at_cells.iter().enumerate();
        let entries = missing.at_entries.iter().zip(&first);
        Self {
            at_cells: own.map(|(k, missing)| over(missing, k)).collect(),
            at_entries: entries.map(|(missing, first)| over(missing, *first)).collect(),
            first,
        }
    }

    /// Adds what is missing of the displacements at the cells under p.
    pub fn add_at_cells(&self, p: &[f64], u: &mut [f64]) {
        for (k, u) in u.chunks_exact_mut(2).enumerate() {
            let own = product(&self.at_cells[k], p, k);
            u[0] += own[0];
            u[1] += own[1];
        }
    }

    /// Adds what is missing of those where the material of each cell entered.
    pub fn add_at_entries(&self, p: &[f64], u: &mut [f64]) {
        for (k, u) in u.chunks_exact_mut(2).enumerate() {
            let entry = product(&self.at_entries[k], p, self.first[k]);
            u[0] += entry[0];
            u[1] += entry[1];
        }
    }

    /// Adds what is missing of the displacements relative to those at the entries.
    pub fn add(&self, p: &[f64], relative: &mut [f64]) {
        for (k, relative) in relative.chunks_exact_mut(2).enumerate() {
            let own = product(&self.at_cells[k], p, k);
            let entry = product(&self.at_entries[k], p, self.first[k]);
            relative[0] += own[0] - entry[0];
            relative[1] += own[1] - entry[1];
        }
    }
}

fn product([xx, yy, xy]: &Symmetric, p: &[f64], k: usize) -> [f64; 2] {
    let [px, py] = [p[2 * k], p[2 * k + 1]];
    [xx * px + xy * py, xy * px + yy * py]
}

/// The displacement under p = pₙ at the cells and at their entries, as it is computed; in m.
fn discrete(contact: &mut DiscreteContact, of: Calibrated) -> Option<[Vec<Symmetric>; 2]> {
    let mut found = [0, 1].map(|_| vec![[0.0; 3]; contact.patch.len()]);
    let mut u = vec![0.0; 2 * contact.patch.len()];
    for direction in 0..2 {
        let along = |c: usize| if c == direction { 1.0 } else { 0.0 };
        let cells = contact.patch.cells.iter();
        let p: Vec<f64> = cells.flat_map(|cell| [0, 1].map(|c| along(c) * cell.pressure)).collect();
        let made = match of {
            Calibrated::Displacement => contact.product(&p),
            Calibrated::BySize => contact.product_by_size(&p)?,
            Calibrated::OfLayer => contact.product_of_layer(&p)?,
        };
        for (place, found) in found.iter_mut().enumerate() {
            if place == 0 {
                made.at_cells(&mut u);
            } else {
                made.at_entries(&mut u);
            }
            for (found, u) in found.iter_mut().zip(u.chunks_exact(2)) {
                found[direction] = u[direction];
                found[2] = u[1 - direction];
            }
        }
    }
    Some(found)
}

/// What is taken for the exact displacement under p = pₙ.
enum Exact {
    Nothing,
    Ellipsoid(EllipsoidalTraction, f64),
    Finer { grid: Grid, under: [VectorField; 2] },
}

impl Exact {
    fn of(
        problem: &Problem,
        normal: &NormalContact,
        grid: &Grid,
        of: Calibrated,
    ) -> Result<Option<Self>, Error> {
        if of == Calibrated::OfLayer {
            return Ok(Some(Self::Nothing));
        }
        let summary = &normal.summary;
        let semi_axes = summary.semi_axes();
        if let Pressure::Elliptic = normal.pressure
            && let Some(known) = problem.interface.elasticity.under_ellipsoid(semi_axes)
        {
            // At the same pressure it is proportional to the size.
            return Ok(Some(Self::Ellipsoid(known, summary.peak_pressure)));
        }
        // Less where so many cells would take too much memory.
        let parts = (1..=settings::refinement())
            .rev()
            .find(|parts| parts * parts * grid.len() <= 4 * MAX_CELLS_TOGETHER);
        let parts = parts.unwrap_or(1);
        // Nothing changes across a line contact in one row; elsewhere cubics need four rows.
        let is_plane = normal.is_line() && grid.rows == 1;
        let across = if is_plane { 1 } else { parts.max(4_usize.div_ceil(grid.rows)) };
        let rows = grid.rows * across;
        let finer = Grid::across(&grid.extent(), parts * grid.columns_within(), rows);
        let patch = Patch::new(normal, finer);
        let mut compliance = problem.interface.elasticity.compliance_on_finer(grid, &finer)?;
        let spread = Interpolation::new(&patch);
        let mut traction = VectorField::zeros(finer.len());
        let mut under = [0, 1].map(|_| VectorField::zeros(finer.len()));
        for (direction, displacement) in under.iter_mut().enumerate() {
            let along = |pressure: f64| [0, 1].map(|c| if c == direction { pressure } else { 0.0 });
            let p: Vec<f64> = patch.cells.iter().flat_map(|cell| along(cell.pressure)).collect();
            spread.spread(&p, &mut traction);
            if of == Calibrated::Displacement {
                compliance.displacement(&traction, displacement);
            } else if !compliance.displacement_by_size(&traction, displacement) {
                return Ok(None);
            }
        }
        Ok(Some(Self::Finer { grid: finer, under }))
    }

    /// At a point (in m).
    fn at(&self, point: [f64; 2]) -> Symmetric {
        match self {
            Self::Nothing => [0.0; 3],
            Self::Ellipsoid(known, peak) => known.displacement(*peak, point),
            Self::Finer { grid, under: [along, across] } => {
                let at = |values: &[f64]| interpolated(grid, values, point);
                [at(&along.x), at(&across.y), at(&along.y)]
            }
        }
    }
}

/// A field at a point (in m), by cubics between the cells of its grid.
fn interpolated(grid: &Grid, values: &[f64], [x, y]: [f64; 2]) -> f64 {
    let (column, along) = cubic((x - grid.x(0)) / grid.spacing_x, grid.columns);
    let of_row = |row: usize| -> f64 {
        let row = &values[grid.index(column, row)..];
        along.iter().zip(row).map(|(weight, value)| weight * value).sum()
    };
    if grid.rows == 1 {
        return of_row(0);
    }
    let (row, across) = cubic((y - grid.y(0)) / grid.spacing_y, grid.rows);
    across.iter().enumerate().map(|(j, weight)| weight * of_row(row + j)).sum()
}
