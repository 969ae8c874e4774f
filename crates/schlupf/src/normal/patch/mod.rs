//! The contact patch on a grid: strips of cells from the leading to the trailing edge, with mean
//! pressures and with the distances travelled by the material since the true leading edge.
//!
//! Every cell touched by the patch belongs to the contact. It carries the mean of the pressure over
//! the whole cell, so that Σ pₙ ΔA = N; its sliding is the mean over its covered part, its
//! displacement is taken at the centroid of that part, and the traction acts there.

mod coverage;
mod elliptic;
mod line;
mod interpolation;
mod parts;
mod tabulated;

use std::ops::Range;
use std::sync::Arc;

use crate::bodies::{Kinematics, RowMotion, StripSlip};
use crate::normal::{Grid, NormalContact, Pressure};

#[doc(hidden)]
pub use interpolation::Interpolation;

/// A discretised contact patch.
///
/// Cells are numbered strip by strip, each strip from the leading to the trailing edge, so the
/// upstream neighbour of a cell precedes it.
#[derive(Debug, Clone)]
pub struct Patch {
    /// The grid.
    pub grid: Grid,
    /// Runs of contact cells in a row.
    pub strips: Vec<Strip>,
    /// The contact cells.
    pub cells: Vec<Cell>,
    /// How its rows slip beyond the motion of the plane.
    pub rows: Option<Arc<RowMotion>>,
}

/// A run of contact cells in a row of the grid, with its own leading and trailing edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Row of the grid.
    pub row: usize,
    /// Its cells in [`Patch::cells`], from the leading to the trailing edge.
    pub cells: Range<usize>,
    /// Path from the last cell to the trailing edge.
    pub exit: Travel,
}

/// A part of a cell below this fraction is rounding error.
const WHOLE: f64 = 1e-9;

/// A contact cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// Position in a field on the grid.
    pub index: usize,
    /// Mean pressure over the whole cell, in Pa.
    pub pressure: f64,
    /// Covered part of the cell, dimensionless.
    pub covered: f64,
    /// Centroid of the covered part along rolling, in m.
    pub x: f64,
    /// Centroid of the covered part across rolling, in m.
    pub y: f64,
    /// Path from the leading edge to the cell.
    pub since_entry: Travel,
    /// Path into the cell: from the leading edge if it is the first of its strip, otherwise from
    /// its upstream neighbour.
    pub path_in: Travel,
    /// What the rigid slip of its strip has in addition to that of the plane.
    pub row: StripSlip,
}

/// Path of a material point along x between two positions: integrals along the path, averaged over
/// the covered part of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Travel {
    /// ⟨∫ dx⟩, in m.
    pub distance: f64,
    /// ⟨∫ x dx⟩, in m².
    pub moment_x: f64,
    /// ⟨∫ y dx⟩, in m².
    pub moment_y: f64,
}

impl Travel {
    /// The path from the end of `upstream` to the end of this one, both from the same start.
    pub(crate) fn after(&self, upstream: &Self) -> Self {
        Self {
            distance: self.distance - upstream.distance,
            moment_x: self.moment_x - upstream.moment_x,
            moment_y: self.moment_y - upstream.moment_y,
        }
    }

    /// The same with all lengths multiplied by `factor`.
    fn rescaled(&self, factor: f64) -> Self {
        Self {
            distance: factor * self.distance,
            moment_x: factor * factor * self.moment_x,
            moment_y: factor * factor * self.moment_y,
        }
    }

    /// Rigid slip distance of the wheel over the rail along this path, in m: ∫ (ξ − φ y, η + φ x)
    /// dx.
    pub fn rigid_slip(&self, kinematics: &Kinematics) -> [f64; 2] {
        [
            kinematics.creepage_x * self.distance - kinematics.spin * self.moment_y,
            kinematics.creepage_y * self.distance + kinematics.spin * self.moment_x,
        ]
    }

    /// What a strip adds to that, in m.
    fn row_slip(&self, row: &StripSlip) -> [f64; 2] {
        let StripSlip { creepages, by_y, spin } = row;
        let [along, across] =
            [0, 1].map(|c| creepages[c] * self.distance + by_y[c] * self.moment_y);
        [along, across + spin * self.moment_x]
    }

    /// The rigid slip distance in a strip, in m.
    pub fn rigid_slip_in_row(&self, kinematics: &Kinematics, row: &StripSlip) -> [f64; 2] {
        sum(self.rigid_slip(kinematics), self.row_slip(row))
    }
}

fn sum(one: [f64; 2], other: [f64; 2]) -> [f64; 2] {
    [one[0] + other[0], one[1] + other[1]]
}

impl Cell {
    /// Whether the patch covers all of it.
    pub(crate) fn is_covered(&self) -> bool {
        self.covered > 1.0 - WHOLE
    }

    /// Rigid slip of the wheel over the rail at the cell, divided by the speed; dimensionless.
    pub fn rigid_slip(&self, kinematics: &Kinematics) -> [f64; 2] {
        sum(kinematics.rigid_slip(self.x, self.y), self.row.at([self.x, self.y]))
    }

    /// Rigid slip distance along the path into the cell, in m.
    pub fn rigid_slip_in(&self, kinematics: &Kinematics) -> [f64; 2] {
        self.path_in.rigid_slip_in_row(kinematics, &self.row)
    }

    /// Rigid slip distance along the path from the leading edge, in m.
    pub fn rigid_slip_since_entry(&self, kinematics: &Kinematics) -> [f64; 2] {
        self.since_entry.rigid_slip_in_row(kinematics, &self.row)
    }

    /// Derivatives with respect to the logarithm of all lengths of what the strip adds: to the slip
    /// distance along the path into the cell (in m), and to the slip over the speed
    /// (dimensionless). `change` is that of the strip.
    pub(crate) fn row_by_size(&self, change: &StripSlip) -> [[f64; 2]; 2] {
        let Self { row, path_in, .. } = self;
        let longer = Travel {
            distance: path_in.distance,
            moment_x: 2.0 * path_in.moment_x,
            moment_y: 2.0 * path_in.moment_y,
        };
        let way = sum(longer.row_slip(row), path_in.row_slip(change));
        let moved = StripSlip { creepages: [0.0; 2], ..*row }.at([self.x, self.y]);
        [way, sum(moved, change.at([self.x, self.y]))]
    }

    /// The same cell, moving with the plane.
    pub(crate) fn on_plane(&self) -> Self {
        Self { row: StripSlip::default(), ..*self }
    }

    /// Pressure on the covered part, in Pa.
    pub(crate) fn pressure_where_covered(&self) -> f64 {
        self.pressure / self.covered
    }

    /// Entry position of the material of the cell (in m), averaged over its covered part.
    pub fn entry_x(&self) -> f64 {
        self.x + self.since_entry.distance
    }
}

impl Patch {
    /// The patch of a normal contact on a grid that covers it.
    pub fn new(contact: &NormalContact, grid: Grid) -> Self {
        let patch = match &contact.pressure {
            Pressure::Elliptic => elliptic::patch(&contact.summary, grid),
            Pressure::Line => line::patch(&contact.summary, grid),
            Pressure::Tabulated(table, factor) => tabulated::patch(table, *factor, grid),
        };
        let mut patch = Self { rows: contact.rows.clone(), ..patch };
        patch.set_rows();
        patch
    }

    /// Without contact.
    fn empty(grid: Grid) -> Self {
        Self { grid, strips: Vec::new(), cells: Vec::new(), rows: None }
    }

    /// Gives the cells of every strip its motion, so that their paths add up.
    fn set_rows(&mut self) {
        let Some(rows) = &self.rows else { return };
        for strip in &self.strips {
            let row = rows.strip(middle(&self.cells[strip.cells.clone()]));
            for cell in &mut self.cells[strip.cells.clone()] {
                cell.row = row;
            }
        }
    }

    /// Derivatives of what the strips add with respect to the logarithm of all lengths, for each
    /// cell; `None` if all move with the plane.
    pub(crate) fn strips_by_size(&self) -> Option<Vec<StripSlip>> {
        let rows = self.rows.as_ref()?;
        let of_strip = |strip: &Strip| {
            let change = rows.strip_by_size(middle(&self.cells[strip.cells.clone()]));
            std::iter::repeat_n(change, strip.cells.len())
        };
        Some(self.strips.iter().flat_map(of_strip).collect())
    }

    /// Switches to another size and pressure: multiplies all lengths and all pressures by a factor
    /// each (dimensionless).
    pub(crate) fn rescale(&mut self, length: f64, pressure: f64) {
        let grid = &mut self.grid;
        for size in
            [&mut grid.spacing_x, &mut grid.spacing_y, &mut grid.origin_x, &mut grid.origin_y]
        {
            *size *= length;
        }
        for cell in &mut self.cells {
            cell.pressure *= pressure;
            cell.x *= length;
            cell.y *= length;
            cell.since_entry = cell.since_entry.rescaled(length);
            cell.path_in = cell.path_in.rescaled(length);
        }
        for strip in &mut self.strips {
            strip.exit = strip.exit.rescaled(length);
        }
        self.set_rows();
    }

    /// Power over the speed (in N) of a traction on the rail (in Pa, x and y of each cell in turn)
    /// with what the rows slip beyond the plane.
    pub(crate) fn row_power(&self, traction: &[f64]) -> f64 {
        self.row_powers(traction).iter().sum()
    }

    /// Its parts, in N: with the lateral creepage of the rows, and with their spin, to which their
    /// longitudinal slip belongs.
    pub(crate) fn row_powers(&self, traction: &[f64]) -> [f64; 2] {
        if self.rows.is_none() {
            return [0.0; 2];
        }
        let cells = self.cells.iter().zip(traction.chunks_exact(2));
        let powers = cells.map(|(cell, p)| {
            let StripSlip { creepages, by_y, spin } = cell.row;
            let [along, across] = [0, 1].map(|c| p[c] * (creepages[c] + by_y[c] * cell.y));
            [across, along + p[1] * spin * cell.x]
        });
        let sum = powers.fold([0.0; 2], |sum, power| [0, 1].map(|k| sum[k] + power[k]));
        sum.map(|power| power * self.grid.cell_area())
    }

    /// Number of contact cells.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether no cell is in contact.
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Normal load Σ pₙ ΔA, in N.
    pub fn load(&self) -> f64 {
        self.cells.iter().map(|c| c.pressure).sum::<f64>() * self.grid.cell_area()
    }

    /// Exit position of the material of a strip (in m): behind the centroid of the last cell by the
    /// remaining distance.
    pub fn exit(&self, strip: &Strip) -> f64 {
        self.cells[strip.cells.end - 1].x - strip.exit.distance
    }
}

/// y of the middle of the covered part of a strip, in m.
fn middle(cells: &[Cell]) -> f64 {
    let covered: f64 = cells.iter().map(|cell| cell.covered).sum();
    cells.iter().map(|cell| cell.covered * cell.y).sum::<f64>() / covered
}
