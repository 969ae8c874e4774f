//! The elliptic patch with Hertzian pressure: exact means over the covered part of each cell.

use crate::normal::{Grid, NormalSummary};
use crate::numerics::quadrature;

use super::Patch;
use super::coverage::{Chord, Integrals, append_strips, cover, cut};

/// Largest interval of the rule, in rad: the pressure of a strip varies as cos³, which eight nodes
/// then integrate to rounding error.
const LONGEST_INTERVAL: f64 = 0.4;

/// The patch x²/a² + y²/b² < 1 under p0 √(1 − x²/a² − y²/b²).
pub(super) fn patch(contact: &NormalSummary, grid: Grid) -> Patch {
    let mut patch = Patch::empty(grid);
    let is_symmetric = (grid.edge_y(0) + grid.edge_y(grid.rows)).abs() <= 1e-12 * grid.spacing_y;
    let apart = if is_symmetric { grid.rows.div_ceil(2) } else { grid.rows };
    let half: Vec<Vec<Integrals>> =
        (0..apart).map(|row| integrate_row(contact, &grid, row)).collect();
    for row in 0..grid.rows {
        if let Some(columns) = half.get(row) {
            append_strips(&mut patch, row, columns);
        } else {
            let columns = half[grid.rows - 1 - row].iter().map(Integrals::mirrored);
            append_strips(&mut patch, row, &columns.collect::<Vec<_>>());
        }
    }
    patch
}

/// Integrals of every column in a row. Along x they are exact; along y a Gauss rule in the angle θ,
/// y = b sin θ, is applied between the points where the ellipse crosses from one column to the
/// next. All columns share the nodes, so the sum of a strip is as accurate as the integral over its
/// whole chord.
fn integrate_row(contact: &NormalSummary, grid: &Grid, row: usize) -> Vec<Integrals> {
    let (a, b) = (contact.semi_axis_x, contact.semi_axis_y);
    let angle = |y: f64| (y / b).clamp(-1.0, 1.0).asin();
    let (low, high) = (angle(grid.edge_y(row)), angle(grid.edge_y(row + 1)));
    let mut breaks = vec![low, high];
    for i in 0..=grid.columns {
        let crossing = (grid.edge_x(i) / a).abs();
        if crossing < 1.0 {
            let theta = crossing.acos();
            breaks.extend([theta, -theta].into_iter().filter(|t| *t > low && *t < high));
        }
    }
    breaks.sort_unstable_by(f64::total_cmp);
    let mut columns = vec![Integrals::default(); grid.columns];
    for pair in breaks.windows(2) {
        let parts = ((pair[1] - pair[0]) / LONGEST_INTERVAL).ceil().max(1.0);
        let half = 0.5 * (pair[1] - pair[0]) / parts;
        for part in 0..parts as usize {
            let middle = pair[0] + (2 * part + 1) as f64 * half;
            for (node, weight) in quadrature::EIGHT {
                for theta in [middle - node * half, middle + node * half] {
                    let edge = a * theta.cos();
                    let chord = Chord {
                        y: b * theta.sin(),
                        width: weight * half * b * theta.cos(),
                        trailing_edge: -edge,
                        leading_edge: edge,
                    };
                    add_chord(&mut columns, grid, contact.peak_pressure / a, &chord);
                }
            }
        }
    }
    columns
}

/// Adds a chord and its pressure p0/a √(h² − x²), where h is half the chord.
pub(super) fn add_chord(columns: &mut [Integrals], grid: &Grid, slope: f64, chord: &Chord) {
    cover(columns, grid, chord);
    let half = chord.leading_edge;
    // ∫ √(h² − x²) dx
    let primitive = |x: f64| {
        let s = (x / half).clamp(-1.0, 1.0);
        0.5 * half * half * (s * (1.0 - s * s).sqrt() + s.asin())
    };
    let mut below = primitive(-half);
    cut(chord, grid, |i, _, high| {
        let above = primitive(high);
        columns[i].force += chord.width * slope * (above - below);
        below = above;
    });
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::{Ellipse, PressureSource};

    fn ellipse(a: f64, b: f64, cells_x: usize, cells_y: usize) -> (Patch, NormalSummary) {
        let source = Ellipse::from_peak_pressure(a, b, 1e9).unwrap();
        let contact = source.normal_contact(None).unwrap();
        let grid = Grid::across(&contact.extent(), cells_x, cells_y);
        (Patch::new(&contact, grid), contact.summary)
    }

    /// Σ pₙ ΔA = N and Σ covered ΔA = π a b on any grid.
    #[test]
    fn pressure_and_area_add_up_exactly() {
        for (a, b) in [(6e-3, 5e-3), (1e-3, 10e-3), (20e-3, 1e-3)] {
            for (nx, ny) in [(2, 1), (2, 2), (3, 7), (24, 24), (25, 40), (81, 13)] {
                let (patch, contact) = ellipse(a, b, nx, ny);
                assert_relative_eq!(patch.load(), contact.load, max_relative = 1e-12);
                let area: f64 =
                    patch.cells.iter().map(|c| c.covered * patch.grid.cell_area()).sum();
                let exact = std::f64::consts::PI * a * b;
                assert_relative_eq!(area, exact, max_relative = 1e-11);
            }
        }
    }

    /// Mean of the leading edge over a row, by plain summation.
    fn mean_edge(grid: &Grid, row: usize, a: f64, b: f64) -> f64 {
        let edge = |k: usize| {
            let y = grid.edge_y(row) + (f64::from(k as u32) + 0.5) * grid.spacing_y / 2000.0;
            a * (1.0 - (y / b).powi(2)).sqrt()
        };
        (0..2000).map(edge).sum::<f64>() / 2000.0
    }

    /// Inside, the mean of a cell is the pressure at its centre to second order, and the distance
    /// since entry is that from the mean edge of the row.
    #[test]
    fn inner_cells_are_plain() {
        let (patch, contact) = ellipse(6e-3, 5e-3, 60, 60);
        let (a, b) = (contact.semi_axis_x, contact.semi_axis_y);
        for strip in &patch.strips {
            for k in strip.cells.clone() {
                let cell = &patch.cells[k];
                let square = (cell.x / a).powi(2) + (cell.y / b).powi(2);
                if square < 0.7 {
                    let centre = contact.peak_pressure * (1.0 - square).sqrt();
                    assert_relative_eq!(cell.pressure, centre, max_relative = 2e-3);
                    let edge = mean_edge(&patch.grid, strip.row, a, b);
                    assert_relative_eq!(cell.entry_x(), edge, max_relative = 1e-6);
                }
            }
        }
    }

    /// Every path into a cell has positive length, and entry and exit mirror each other.
    #[test]
    fn material_always_moves_downstream() {
        for (nx, ny) in [(20, 20), (7, 30), (30, 7), (80, 80)] {
            let (patch, _) = ellipse(5e-3, 5e-3, nx, ny);
            for strip in &patch.strips {
                for k in strip.cells.clone() {
                    assert!(patch.cells[k].path_in.distance > 0.0);
                }
                let first = patch.cells[strip.cells.start].since_entry;
                assert_relative_eq!(first.distance, strip.exit.distance, max_relative = 1e-9);
                assert_relative_eq!(first.moment_x, -strip.exit.moment_x, max_relative = 1e-9);
            }
        }
    }
}
