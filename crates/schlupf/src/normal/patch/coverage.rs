//! Coverage of the cells of a row by a patch, and the mean distance travelled by the material over
//! the covered part of each cell: integrals over chords, the lines along x inside the patch.

use crate::normal::{BORDER, Grid};

use super::{Cell, Patch, Strip, Travel};
use crate::bodies::StripSlip;

/// The part of a line y = const inside the patch, and the width across it that it represents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chord {
    /// Position, in m.
    pub y: f64,
    /// Width that it represents, in m.
    pub width: f64,
    /// Its end at smaller x, in m.
    pub trailing_edge: f64,
    /// Its end at larger x, in m.
    pub leading_edge: f64,
}

/// Integrals over the covered part of a cell.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Integrals {
    area: f64,
    x: f64,
    y: f64,
    entry: Travel,
    exit: Travel,
    /// ∫ p dA, in N.
    pub force: f64,
}

/// A cell covered by less than this fraction is touched only due to rounding error.
const SLIVER: f64 = 1e-12;

impl Integrals {
    pub fn is_touched(&self, grid: &Grid) -> bool {
        self.area > SLIVER * grid.cell_area()
    }

    /// The same on the other side of y = 0.
    pub fn mirrored(&self) -> Self {
        let mirrored = |travel: &Travel| Travel { moment_y: -travel.moment_y, ..*travel };
        Self { y: -self.y, entry: mirrored(&self.entry), exit: mirrored(&self.exit), ..*self }
    }

    /// Adds the part of a chord from `low` to `high`.
    fn add(&mut self, chord: &Chord, low: f64, high: f64) {
        let length = high - low;
        let square = 0.5 * (high * high - low * low);
        let cube = (high.powi(3) - low.powi(3)) / 3.0;
        self.area += chord.width * length;
        self.x += chord.width * square;
        self.y += chord.width * chord.y * length;
        // ∫ (x_e − x) dx and ∫ ½ (x_e² − x²) dx, and the same to the trailing edge.
        let (lead, trail) = (chord.leading_edge, chord.trailing_edge);
        let entry = [lead * length - square, 0.5 * (lead * lead * length - cube)];
        let exit = [square - trail * length, 0.5 * (cube - trail * trail * length)];
        for (sum, [distance, moment]) in [(&mut self.entry, entry), (&mut self.exit, exit)] {
            sum.distance += chord.width * distance;
            sum.moment_x += chord.width * moment;
            sum.moment_y += chord.width * chord.y * distance;
        }
    }

    fn mean(&self, integral: &Travel) -> Travel {
        Travel {
            distance: integral.distance / self.area,
            moment_x: integral.moment_x / self.area,
            moment_y: integral.moment_y / self.area,
        }
    }

    fn cell(&self, grid: &Grid, index: usize) -> Cell {
        Cell {
            index,
            pressure: self.force / grid.cell_area(),
            covered: (self.area / grid.cell_area()).min(1.0),
            x: self.x / self.area,
            y: self.y / self.area,
            since_entry: self.mean(&self.entry),
            path_in: Travel::default(),
            row: StripSlip::default(),
        }
    }
}

/// Cuts a chord at the column edges: calls `visit(column, low, high)` for each piece.
pub(super) fn cut(chord: &Chord, grid: &Grid, mut visit: impl FnMut(usize, f64, f64)) {
    let last = grid.columns - 1 - BORDER;
    let column = |x: f64| {
        let position = ((x - grid.origin_x) / grid.spacing_x).floor().max(0.0) as usize;
        position.clamp(BORDER, last)
    };
    let (first, end) = (column(chord.trailing_edge), column(chord.leading_edge));
    let mut low = chord.trailing_edge;
    for i in first..=end {
        let high = if i == end { chord.leading_edge } else { grid.edge_x(i + 1) };
        visit(i, low, high);
        low = high;
    }
}

/// Adds a chord to the integrals of the columns.
pub(super) fn cover(columns: &mut [Integrals], grid: &Grid, chord: &Chord) {
    cut(chord, grid, |i, low, high| columns[i].add(chord, low, high));
}

/// Appends the strips of a row: runs of touched cells from their leading to their trailing edge.
/// Where the material would move upstream from one cell to the next, another part of the patch
/// starts.
pub(super) fn append_strips(patch: &mut Patch, row: usize, columns: &[Integrals]) {
    let grid = patch.grid;
    let mut start = patch.cells.len();
    let mut upstream = Travel::default();
    let mut exit = Travel::default();
    let mut close = |patch: &mut Patch, exit: Travel| {
        let end = patch.cells.len();
        if end > start {
            patch.strips.push(Strip { row, cells: start..end, exit });
        }
        start = end;
    };
    for i in (0..columns.len()).rev() {
        let sums = &columns[i];
        if !sums.is_touched(&grid) {
            close(patch, exit);
            upstream = Travel::default();
            continue;
        }
        let mut cell = sums.cell(&grid, grid.index(i, row));
        cell.path_in = cell.since_entry.after(&upstream);
        if cell.path_in.distance <= 0.0 {
            close(patch, exit);
            cell.path_in = cell.since_entry;
        }
        upstream = cell.since_entry;
        exit = sums.mean(&sums.exit);
        patch.cells.push(cell);
    }
    close(patch, exit);
}
