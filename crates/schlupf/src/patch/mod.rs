//! The contact patch on a grid: strips of cells from the leading to the trailing edge, with mean
//! pressures and with the distances that the material has travelled since the true leading edge.
//!
//! A cell that the patch touches belongs to the contact. It carries the mean of the pressure over
//! the whole cell, so that Σ pₙ ΔA = N; its sliding is that of the mean over its covered part, its
//! displacement is taken at the centroid of that part, and the traction acts there.

mod coverage;
mod elliptic;
mod interpolation;
mod tabulated;

use std::ops::Range;

use crate::grid::Grid;
use crate::kinematics::Kinematics;
use crate::normal::{NormalContact, Pressure};

pub use interpolation::Interpolation;

/// A discretised contact patch.
///
/// Cells are numbered strip by strip, each strip from the leading to the trailing edge, so the
/// upstream neighbour of a cell is the one before it.
#[derive(Debug, Clone)]
pub struct Patch {
    /// The grid.
    pub grid: Grid,
    /// Runs of contact cells in a row.
    pub strips: Vec<Strip>,
    /// The contact cells.
    pub cells: Vec<Cell>,
}

/// A run of contact cells in a row of the grid, with its own leading and trailing edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Row of the grid.
    pub row: usize,
    /// Its cells in [`Patch::cells`], from the leading to the trailing edge.
    pub cells: Range<usize>,
    /// From the last cell to the trailing edge.
    pub exit: Travel,
}

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
    /// From the leading edge to the cell.
    pub since_entry: Travel,
    /// Into the cell: from the leading edge if it is the first of its strip, else from its upstream
    /// neighbour.
    pub way_in: Travel,
}

/// What a material point travels along x between two places: integrals over the way, averaged
/// over the covered part of a cell.
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
    /// The way from the end of `upstream` to the end of this one, both from the same start.
    pub(crate) fn after(&self, upstream: &Self) -> Self {
        Self {
            distance: self.distance - upstream.distance,
            moment_x: self.moment_x - upstream.moment_x,
            moment_y: self.moment_y - upstream.moment_y,
        }
    }

    /// The same where all lengths are `factor` times as long.
    fn rescaled(&self, factor: f64) -> Self {
        Self {
            distance: factor * self.distance,
            moment_x: factor * factor * self.moment_x,
            moment_y: factor * factor * self.moment_y,
        }
    }

    /// Rigid slip distance of the wheel over the rail on this way, in m:
    /// ∫ (ξ − φ y, η + φ x) dx.
    pub fn rigid_slip(&self, kinematics: &Kinematics) -> [f64; 2] {
        [
            kinematics.creepage_x * self.distance - kinematics.spin * self.moment_y,
            kinematics.creepage_y * self.distance + kinematics.spin * self.moment_x,
        ]
    }
}

impl Cell {
    /// Where the material of the cell entered the contact (in m), on the mean over its covered
    /// part.
    pub fn entry_x(&self) -> f64 {
        self.x + self.since_entry.distance
    }
}

impl Patch {
    /// The patch of a normal contact on a grid that spans it.
    pub fn new(contact: &NormalContact, grid: Grid) -> Self {
        match &contact.pressure {
            Pressure::Elliptic => elliptic::patch(&contact.summary, grid),
            Pressure::Tabulated(table, factor) => tabulated::patch(table, *factor, grid),
        }
    }

    /// Takes over another size and pressure: all lengths and all pressures times a factor each
    /// (dimensionless).
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
            cell.way_in = cell.way_in.rescaled(length);
        }
        for strip in &mut self.strips {
            strip.exit = strip.exit.rescaled(length);
        }
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

    /// Where the material of a strip leaves the contact (in m): behind the centroid of the last
    /// cell by the distance that is left.
    pub fn exit(&self, strip: &Strip) -> f64 {
        self.cells[strip.cells.end - 1].x - strip.exit.distance
    }
}
