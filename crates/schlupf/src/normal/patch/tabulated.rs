//! A patch from a table of pressures, possibly with several separate parts.
//!
//! Between the samples the square of the pressure is linear, as at the edge of a contact, and a
//! cell carries the mean of its root along the chords that cover it. Were the load beyond the edge
//! given to the nearest cell, that cell would have more than the largest pressure where it is
//! covered, and its equation under Coulomb's law no solution.

use crate::normal::{Grid, PressureTable, positive_runs};

use super::Patch;
use super::coverage::{Chord, Integrals, append_strips, cover, cut};

/// Minimum number of chords in a row of cells.
const CHORDS: f64 = 8.0;

/// The patch of `table` × `factor`: cell means of its interpolant, scaled to the load of the table.
pub(super) fn patch(table: &PressureTable, factor: f64, grid: Grid) -> Patch {
    let mut patch = Patch::empty(grid);
    for row in 0..grid.rows {
        append_strips(&mut patch, row, &columns(table, &grid, row));
    }
    let scale = factor * table.load() / patch.load();
    patch.cells.iter_mut().for_each(|cell| cell.pressure *= scale);
    patch
}

/// The columns of a row, covered and pressed along lines through it that end at the edges of the
/// positive pressure. Gaps of less than a cell are closed.
fn columns(table: &PressureTable, grid: &Grid, row: usize) -> Vec<Integrals> {
    let mut columns = vec![Integrals::default(); grid.columns];
    let count = (2.0 * grid.spacing_y / table.axis_y().spacing).ceil().max(CHORDS) as usize;
    let width = grid.spacing_y / count as f64;
    for line in 0..count {
        let y = grid.edge_y(row) + (line as f64 + 0.5) * width;
        let mut chords: Vec<Chord> = Vec::new();
        for run in positive_runs(&table.line_at(y), table.axis_x()) {
            let [trailing_edge, leading_edge] = run.edges();
            let chord = Chord { y, width, trailing_edge, leading_edge };
            cut(&chord, grid, |i, low, high| columns[i].force += width * run.integral(low, high));
            match chords.last_mut() {
                Some(previous) if trailing_edge - previous.leading_edge < grid.spacing_x => {
                    previous.leading_edge = leading_edge;
                }
                _ => chords.push(chord),
            }
        }
        for chord in chords {
            cover(&mut columns, grid, &chord);
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::Cell;
    use super::*;
    use crate::normal::{Ellipse, NormalContact, PressureSource, Tabulated};

    fn contact(x: &[f64], y: &[f64], pressure: impl Fn(f64, f64) -> f64) -> NormalContact {
        let values = y.iter().flat_map(|y| x.iter().map(|x| pressure(*x, *y))).collect();
        let table = PressureTable::new(x, y, values).unwrap();
        Tabulated::new(table, None).unwrap().normal_contact(None).unwrap()
    }

    fn axis(half: f64, count: usize) -> Vec<f64> {
        (0..count).map(|k| half * (2.0 * k as f64 / (count - 1) as f64 - 1.0)).collect()
    }

    /// The load of the table is preserved on any grid, and its cells are those of the ellipse.
    #[test]
    fn a_hertzian_table_gives_the_elliptic_patch() {
        let (a, b) = (6e-3_f64, 5e-3_f64);
        let hertz =
            |x: f64, y: f64| 1e9 * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt();
        let contact = contact(&axis(1.2 * a, 145), &axis(1.2 * b, 145), hertz);
        for cells in [5, 24, 60] {
            let grid = Grid::across(&contact.extent(), cells, cells);
            let patch = Patch::new(&contact, grid);
            assert_relative_eq!(patch.load(), contact.summary.load, max_relative = 1e-12);
            for strip in &patch.strips {
                for cell in &patch.cells[strip.cells.clone()] {
                    assert!(cell.path_in.distance > 0.0);
                }
            }
            let hertz = Ellipse::from_load(a, b, contact.summary.load).unwrap();
            let exact = hertz.normal_contact(None).unwrap();
            let exact = Patch::new(&exact, Grid::across(&exact.extent(), cells, cells));
            let middle = |patch: &Patch| {
                let strip = &patch.strips[cells / 2];
                [patch.cells[strip.cells.start].entry_x(), patch.exit(strip)]
            };
            for (tabulated, exact) in middle(&patch).iter().zip(middle(&exact)) {
                assert_relative_eq!(*tabulated, exact, max_relative = 5e-3);
            }
            let moment = |patch: &Patch| -> f64 {
                patch.cells.iter().map(|c| c.pressure * (c.x.powi(2) + c.y.powi(2))).sum()
            };
            assert_relative_eq!(moment(&patch), moment(&exact), max_relative = 0.02);
        }
    }

    /// Where the patch covers a cell only in part, the pressure on that part is no more than the
    /// largest of the table, on whatever grid: on grids finer than the table, too.
    #[test]
    fn cells_at_the_edge_are_not_overloaded() {
        let root = |square: f64| 1e9 * (1.0 - square).max(0.0).sqrt();
        let shapes: [&dyn Fn(f64, f64) -> f64; 2] =
            [&|x, y| root((x / 6e-3).powi(2) + (y / 4e-3).powi(2)), &|x, y| {
                root((x / 6e-3).abs().powi(4) + (y / 4e-3).abs().powi(4) * (1.0 + 60.0 * x))
            }];
        for shape in shapes {
            let contact = contact(&axis(6.6e-3, 24), &axis(4.5e-3, 31), shape);
            for cells in [10, 24, 36, 50] {
                let patch = Patch::new(&contact, Grid::across(&contact.extent(), cells, cells));
                let most = patch.cells.iter().map(Cell::pressure_where_covered).fold(0.0, f64::max);
                assert!(most < 1.01 * contact.summary.peak_pressure, "{cells}: {most}");
            }
        }
    }

    /// Two parts in a row each have their own leading edge.
    #[test]
    fn separate_parts_are_separate_strips() {
        let two = |x: f64, _: f64| if (2e-3..4e-3).contains(&x.abs()) { 1e8 } else { 0.0 };
        let contact = contact(&axis(6e-3, 61), &axis(3e-3, 11), two);
        let patch = Patch::new(&contact, Grid::across(&contact.extent(), 40, 6));
        assert_eq!(patch.strips.len(), 12);
        let [one, two] = [&patch.strips[0], &patch.strips[1]];
        assert!(patch.exit(one) > 0.0 && patch.cells[two.cells.start].entry_x() < 0.0);
        assert_relative_eq!(patch.load(), contact.summary.load, max_relative = 1e-12);
    }
}
