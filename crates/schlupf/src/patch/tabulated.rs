//! A patch from a table of pressures, possibly of several separate parts.

use std::ops::RangeInclusive;

use crate::grid::{BORDER, Grid};
use crate::normal::tabulated::{Axis, PressureTable, Run, hat_integral, positive_runs};

use super::{Cell, Patch, Strip, Travel, with_ways};

/// The patch of `table` × `factor`: cell means of its linear interpolant, and in each row a strip
/// for each run of positive pressure. What the interpolant holds beyond the edges of a strip goes
/// to its outermost cells, so that the load is kept.
pub(super) fn patch(table: &PressureTable, factor: f64, grid: Grid) -> Patch {
    let mut patch = Patch { grid, strips: Vec::new(), cells: Vec::new() };
    for row in 0..grid.rows {
        let low = if row == 0 { f64::NEG_INFINITY } else { grid.edge_y(row) };
        let high = if row + 1 == grid.rows { f64::INFINITY } else { grid.edge_y(row + 1) };
        let mut samples = table.mean_over(low, high, grid.spacing_y);
        samples.iter_mut().for_each(|p| *p *= factor);
        let line = Line { samples: &samples, axis: table.axis_x(), row };
        for part in line.parts(&grid).into_iter().rev() {
            line.append_strip(&mut patch, &part);
        }
    }
    patch
}

/// Pressure along x, mean over a row.
struct Line<'a> {
    samples: &'a [f64],
    axis: &'a Axis,
    row: usize,
}

/// One or more runs of samples that together make a strip.
struct Part {
    run: Run,
    columns: RangeInclusive<usize>,
}

impl Line<'_> {
    /// Runs that share a cell or have no free cell between them are one strip.
    fn parts(&self, grid: &Grid) -> Vec<Part> {
        let column = |x: f64| {
            let position = ((x - grid.origin_x) / grid.spacing_x).floor().max(0.0) as usize;
            position.clamp(BORDER, grid.columns - 1 - BORDER)
        };
        let mut parts: Vec<Part> = Vec::new();
        for run in positive_runs(self.samples, self.axis) {
            // An edge that lies on a cell's boundary does not touch the cell beyond it.
            let inset = 1e-9 * grid.spacing_x;
            let columns = column(run.edges[0] + inset)..=column(run.edges[1] - inset);
            match parts.last_mut() {
                Some(previous) if *columns.start() <= previous.columns.end() + 1 => {
                    previous.run.last = run.last;
                    previous.run.edges[1] = run.edges[1];
                    previous.columns = *previous.columns.start()..=*columns.end();
                }
                _ => parts.push(Part { run, columns }),
            }
        }
        parts
    }

    fn append_strip(&self, patch: &mut Patch, part: &Part) {
        let grid = patch.grid;
        let [trailing_edge, leading_edge] = part.run.edges;
        let y = grid.y(self.row);
        let cell = |i: usize| {
            let (first, last) = (i == *part.columns.end(), i == *part.columns.start());
            let low = if last { f64::NEG_INFINITY } else { grid.edge_x(i) };
            let high = if first { f64::INFINITY } else { grid.edge_x(i + 1) };
            let force = self.force_up_to(high, &part.run) - self.force_up_to(low, &part.run);
            let inner = [low.max(trailing_edge), high.min(leading_edge)];
            Cell {
                index: grid.index(i, self.row),
                pressure: force / grid.spacing_x,
                covered: (inner[1] - inner[0]) / grid.spacing_x,
                x: 0.5 * (inner[0] + inner[1]),
                y,
                since_entry: mean_travel_from(leading_edge, inner, y),
                way_in: Travel::default(),
            }
        };
        let cells = with_ways(part.columns.clone().rev().map(cell).collect());
        let Some(last) = cells.last() else {
            return;
        };
        let exit = Travel {
            distance: last.x - trailing_edge,
            moment_x: 0.5 * (last.x.powi(2) - trailing_edge.powi(2)),
            moment_y: y * (last.x - trailing_edge),
        };
        let start = patch.cells.len();
        patch.cells.extend(cells);
        let cells = start..patch.cells.len();
        patch.strips.push(Strip { row: self.row, cells, leading_edge, trailing_edge, exit });
    }

    /// ∫ p dx up to x, of a run's own samples, in N/m.
    fn force_up_to(&self, x: f64, run: &Run) -> f64 {
        let share = |k: usize| hat_integral((x - self.axis.at(k)) / self.axis.spacing);
        (run.first..=run.last).map(|k| self.samples[k] * share(k)).sum::<f64>() * self.axis.spacing
    }
}

/// Mean over `inner` of the way from `edge` to there.
fn mean_travel_from(edge: f64, inner: [f64; 2], y: f64) -> Travel {
    let [low, high] = inner;
    let distance = edge - 0.5 * (low + high);
    let mean_square = (low * low + low * high + high * high) / 3.0;
    Travel { distance, moment_x: 0.5 * (edge * edge - mean_square), moment_y: y * distance }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
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

    /// The load of the table is kept on any grid, and its cells are those of the ellipse.
    #[test]
    fn a_hertzian_table_gives_the_elliptic_patch() {
        let (a, b) = (6e-3_f64, 5e-3_f64);
        let hertz = |x: f64, y: f64| {
            1e9 * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt()
        };
        let contact = contact(&axis(1.2 * a, 145), &axis(1.2 * b, 145), hertz);
        for cells in [5, 24, 60] {
            let grid = Grid::across(&contact.extent(), cells, cells);
            let patch = Patch::new(&contact, grid);
            assert_relative_eq!(patch.load(), contact.summary.load, max_relative = 1e-12);
            for strip in &patch.strips {
                let y = grid.y(strip.row);
                let edge = a * (1.0 - (y / b).powi(2)).sqrt();
                if y.abs() < 0.8 * b {
                    assert_relative_eq!(strip.leading_edge, edge, max_relative = 0.02);
                    assert_relative_eq!(strip.trailing_edge, -edge, max_relative = 0.02);
                }
                for k in strip.cells.clone() {
                    assert!(patch.cells[k].way_in.distance > 0.0);
                }
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
        assert!(patch.strips[0].trailing_edge > 0.0 && patch.strips[1].leading_edge < 0.0);
        assert_relative_eq!(patch.load(), contact.summary.load, max_relative = 1e-12);
    }
}
