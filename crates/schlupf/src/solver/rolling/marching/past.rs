//! Record of the patch at the previous instant, after the material has moved on.

use crate::normal::VectorField;
use crate::normal::patch::{Patch, Strip};
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::passage::pair;

/// State in which the material leaves a cell.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Departure {
    /// A p in the cell, in m.
    pub displacement: [f64; 2],
    /// A p where the material of the cell entered, in m.
    pub at_entry: [f64; 2],
    /// Centroid of its covered part along rolling, in m.
    pub x: f64,
    /// Position of the leading edge, averaged over that part, in m.
    pub entry_x: f64,
    /// Middle of its strip along rolling, in m.
    pub middle: f64,
}

/// The patch at the previous instant.
#[derive(Debug, Default)]
pub(super) struct Past {
    /// For each cell of the grid that was in contact: the index of its element, and the state in
    /// which the material leaves the cell.
    pub cells: Vec<Option<(usize, Departure)>>,
    /// Its strips.
    pub reaches: Vec<Reach>,
}

impl Past {
    /// The record of an instant with a displacement, and that of the bodies alone.
    pub fn of(contact: &DiscreteContact, [field, of_bodies]: [&VectorField; 2]) -> Self {
        let patch = &contact.patch;
        let mut displacement = vec![0.0; 2 * patch.len()];
        let mut at_entry = displacement.clone();
        contact.interpolation.gather(field, &mut displacement);
        contact.interpolation.gather_at_entries(of_bodies, &mut at_entry);
        let mut cells = vec![None; patch.grid.len()];
        let reaches: Vec<Reach> = patch.strips.iter().map(|s| Reach::of(patch, s)).collect();
        let strips = patch.strips.iter().zip(&reaches);
        let middles = strips.flat_map(|(strip, reach)| strip.cells.clone().map(|_| reach.middle));
        for (k, middle) in middles.enumerate() {
            let cell = &patch.cells[k];
            let departure = Departure {
                displacement: pair(&displacement, k),
                at_entry: pair(&at_entry, k),
                x: cell.x,
                entry_x: cell.entry_x(),
                middle,
            };
            cells[cell.index] = Some((k, departure));
        }
        Self { cells, reaches }
    }

    /// The state in which the material left a cell of the grid, if that was in contact.
    pub fn at(&self, index: usize) -> Option<&Departure> {
        self.cells[index].as_ref().map(|(_, departure)| departure)
    }
}

/// A run of contact cells in a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    pub row: usize,
    /// First and last column.
    columns: [usize; 2],
    /// Its middle along rolling, in m.
    pub middle: f64,
}

impl Reach {
    pub fn of(patch: &Patch, strip: &Strip) -> Self {
        let cells = &patch.cells[strip.cells.clone()];
        let column = |index: usize| index % patch.grid.columns;
        let (first, last) = (&cells[0], &cells[cells.len() - 1]);
        Self {
            row: strip.row,
            columns: [column(last.index), column(first.index)],
            middle: 0.5 * (first.entry_x() + patch.exit(strip)),
        }
    }

    pub fn overlaps(&self, other: &Self) -> bool {
        self.columns[0] <= other.columns[1] && other.columns[0] <= self.columns[1]
    }

    /// Whether there is a strip on both sides of it, so that its row is covered over its full
    /// width.
    pub fn is_inside(&self, strips: &[Self]) -> bool {
        let has = |row: Option<usize>| {
            row.is_some_and(|row| strips.iter().any(|s| s.row == row && s.overlaps(self)))
        };
        has(self.row.checked_sub(1)) && has(Some(self.row + 1))
    }
}
