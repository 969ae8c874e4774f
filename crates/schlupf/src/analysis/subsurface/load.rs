//! Loads on the surface of a body.

use crate::analysis::temperature_field::Side;
use crate::normal::patch::Patch;
use crate::normal::{BORDER, Grid};
use crate::problem::Problem;
use crate::reporting::{Error, Quantity, require_finite};
use crate::solution::Solution;

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

/// Fewest pieces across the patch, as long as a cell has no more than the most pieces each way.
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

    /// The loads of a solution on one of the bodies, in so many pieces of every cell each way. A
    /// piece has the mean pressure of its own part, that of the normal contact, whatever bounds the
    /// traction of a fast method, times a traction over pressure that is linear between cells; the
    /// tractions of all pieces of a cell have the sum of the cell.
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
        let tractions = [&fields.traction_x, &fields.traction_y];
        let saturation = tractions.map(|traction| Saturation::new(solution, traction));
        let zero = || vec![0.0; finer.len()];
        let mut load = Self { pressure: zero(), traction_x: zero(), traction_y: zero() };
        for (k, [column, row]) in fields.cell.iter().enumerate() {
            let parts: Vec<Part> = (0..pieces * pieces)
                .map(|p| {
                    let [i, j] = [p % pieces, p / pieces];
                    let at = finer.index(column * pieces + i, row * pieces + j);
                    let place = [i, j].map(|k| (k as f64 + 0.5) / pieces as f64 - 0.5);
                    Part { at, place, pressure: shape[at] }
                })
                .collect();
            let [along, across] = [0, 1].map(|c| {
                let ratio = |place| sign * saturation[c].at([*column, *row], place);
                distributed(&parts, sign * tractions[c][k], ratio)
            });
            for (p, part) in parts.iter().enumerate() {
                load.pressure[part.at] = part.pressure;
                load.traction_x[part.at] = along[p];
                load.traction_y[part.at] = across[p];
            }
        }
        Ok((load, pieces))
    }
}

/// A piece of a cell.
struct Part {
    /// Its place in a field.
    at: usize,
    /// Its middle, from that of the cell and in sizes of the cell.
    place: [f64; 2],
    /// Its mean pressure, in Pa.
    pressure: f64,
}

/// The load of a cell on its pieces, where it is proportional to the pressure times a ratio, up to
/// a constant times the pressure that gives the right sum.
fn distributed(parts: &[Part], load: f64, ratio: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
    let mean = parts.iter().map(|part| part.pressure).sum::<f64>() / parts.len() as f64;
    if mean <= 0.0 {
        return vec![load; parts.len()];
    }
    let ratios: Vec<f64> = parts.iter().map(|part| ratio(part.place)).collect();
    let products = parts.iter().zip(&ratios).map(|(part, ratio)| ratio * part.pressure);
    let missing = load / mean - products.sum::<f64>() / parts.len() as f64 / mean;
    let pairs = parts.iter().zip(&ratios);
    pairs.map(|(part, ratio)| (ratio + missing) * part.pressure).collect()
}

/// Traction over pressure, linear between the middles of neighbouring cells, so that it has no
/// steps where the pieces have none.
struct Saturation {
    grid: Grid,
    /// In every cell of the grid; `None` outside of the contact.
    ratios: Vec<Option<f64>>,
}

impl Saturation {
    fn new(solution: &Solution, traction: &[f64]) -> Self {
        let fields = &solution.fields;
        let grid = fields.grid;
        let mut ratios = vec![None; grid.len()];
        for (k, [column, row]) in fields.cell.iter().enumerate() {
            let pressure = fields.pressure[k];
            ratios[grid.index(*column, *row)] = (pressure > 0.0).then(|| traction[k] / pressure);
        }
        Self { grid, ratios }
    }

    /// At a place from the middle of a cell, in sizes of the cell; where a neighbour is not in
    /// contact, the cell's own value takes its place.
    fn at(&self, cell: [usize; 2], place: [f64; 2]) -> f64 {
        let own = self.ratios[self.grid.index(cell[0], cell[1])].unwrap_or(0.0);
        let counts = [self.grid.columns, self.grid.rows];
        let next = |c: usize| {
            let to = if place[c] < 0.0 { cell[c].checked_sub(1) } else { Some(cell[c] + 1) };
            to.filter(|to| *to < counts[c])
        };
        let of = |column: Option<usize>, row: Option<usize>| {
            let at = column.zip(row).map(|(column, row)| self.grid.index(column, row));
            at.and_then(|at| self.ratios[at]).unwrap_or(own)
        };
        let [x, y] = place.map(f64::abs);
        let [beside, beyond] = [next(0), next(1)];
        let here = [cell[0], cell[1]].map(Some);
        let along = own * (1.0 - x) + of(beside, here[1]) * x;
        let further = of(here[0], beyond) * (1.0 - x) + of(beside, beyond) * x;
        along * (1.0 - y) + further * y
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
