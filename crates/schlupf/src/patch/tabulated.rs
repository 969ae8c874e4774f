//! A patch from a table of pressures, possibly with several separate parts.

use crate::grid::Grid;
use crate::normal::tabulated::{PressureTable, hat_integral, positive_runs};

use super::Patch;
use super::coverage::{Chord, Integrals, append_strips, cover};

/// Minimum number of chords in a row of cells.
const CHORDS: f64 = 8.0;

/// The patch of `table` × `factor`: cell means of its linear interpolant. The part of the
/// interpolant beyond the edges of the patch is assigned to the nearest cell of the row, so that
/// the load is preserved.
pub(super) fn patch(table: &PressureTable, factor: f64, grid: Grid) -> Patch {
    let mut patch = Patch::empty(grid);
    for row in 0..grid.rows {
        let mut columns = vec![Integrals::default(); grid.columns];
        for chord in chords(table, &grid, row) {
            cover(&mut columns, &grid, &chord);
        }
        press(&mut columns, &row_force(table, &grid, row), factor, &grid);
        append_strips(&mut patch, row, &columns);
    }
    // A row reached only by the tails of the interpolant has no cell to take its force.
    let kept = patch.load();
    let scale = factor * table.load() / kept;
    patch.cells.iter_mut().for_each(|cell| cell.pressure *= scale);
    patch
}

/// Lines through a row, cut at the edges of the positive pressure. Gaps of less than a cell are
/// closed.
fn chords(table: &PressureTable, grid: &Grid, row: usize) -> Vec<Chord> {
    let count = (2.0 * grid.spacing_y / table.axis_y().spacing).ceil().max(CHORDS) as usize;
    let width = grid.spacing_y / count as f64;
    let mut chords: Vec<Chord> = Vec::new();
    for line in 0..count {
        let y = grid.edge_y(row) + (line as f64 + 0.5) * width;
        let first = chords.len();
        for run in positive_runs(&table.line_at(y), table.axis_x()) {
            let [trailing_edge, leading_edge] = run.edges;
            match chords[first..].last_mut() {
                Some(previous) if trailing_edge - previous.leading_edge < grid.spacing_x => {
                    previous.leading_edge = leading_edge;
                }
                _ => chords.push(Chord { y, width, trailing_edge, leading_edge }),
            }
        }
    }
    chords
}

/// Force per column of a row, before scaling, in N. Force beyond the grid is assigned to its edge.
fn row_force(table: &PressureTable, grid: &Grid, row: usize) -> Vec<f64> {
    let low = if row == 0 { f64::NEG_INFINITY } else { grid.edge_y(row) };
    let high = if row + 1 == grid.rows { f64::INFINITY } else { grid.edge_y(row + 1) };
    let samples = table.integral_over(low, high);
    let axis = table.axis_x();
    let force_up_to = |x: f64| -> f64 {
        let share = |k: usize| hat_integral((x - axis.at(k)) / axis.spacing);
        (0..samples.len()).map(|k| samples[k] * share(k)).sum::<f64>() * axis.spacing
    };
    let edge = |i: usize| match i {
        0 => f64::NEG_INFINITY,
        i if i == grid.columns => f64::INFINITY,
        i => grid.edge_x(i),
    };
    let cumulated: Vec<f64> = (0..=grid.columns).map(|i| force_up_to(edge(i))).collect();
    cumulated.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

/// Assigns every column's force to the nearest touched column.
fn press(columns: &mut [Integrals], force: &[f64], factor: f64, grid: &Grid) {
    let touched: Vec<usize> = (0..columns.len()).filter(|i| columns[*i].is_touched(grid)).collect();
    for (i, force) in force.iter().enumerate().filter(|(_, force)| **force != 0.0) {
        if let Some(&nearest) = touched.iter().min_by_key(|t| t.abs_diff(i)) {
            columns[nearest].force += factor * force;
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::ellipse::Ellipse;
    use crate::normal::tabulated::Tabulated;
    use crate::normal::{NormalContact, PressureSource};

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
