//! The rectangular patch of a line contact: exact means over each cell.

use crate::normal::{Grid, NormalSummary};

use super::Patch;
use super::coverage::{Chord, Integrals, append_strips};
use super::elliptic::add_chord;

/// The patch |x| < a, |y| < b under p0 √(1 − x²/a²).
pub(super) fn patch(contact: &NormalSummary, grid: Grid) -> Patch {
    let mut patch = Patch::empty(grid);
    let [a, b] = contact.semi_axes();
    for row in 0..grid.rows {
        let [low, high] = [row, row + 1].map(|edge| grid.edge_y(edge).clamp(-b, b));
        let (y, width) = (0.5 * (low + high), high - low);
        let chord = Chord { y, width, trailing_edge: -a, leading_edge: a };
        let mut columns = vec![Integrals::default(); grid.columns];
        add_chord(&mut columns, &grid, contact.peak_pressure / a, &chord);
        append_strips(&mut patch, row, &columns);
    }
    patch
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::{Extent, Line, PressureSource};

    /// Σ pₙ ΔA = N and Σ covered ΔA = 2 a L on any grid, one that is larger than the patch, too,
    /// and material enters at x = a.
    #[test]
    fn pressure_and_area_add_up_exactly() {
        let line = Line::new([0.5, f64::INFINITY], 0.02, 114e9, 10e3).unwrap();
        let contact = line.normal_contact(None).unwrap();
        let [a, b] = contact.summary.semi_axes();
        let wide = Extent { x: [-1.3 * a, 1.3 * a], y: [-1.1 * b, 1.1 * b] };
        for (extent, [nx, ny]) in [(contact.extent(), [24, 1]), (wide, [25, 7])] {
            let patch = Patch::new(&contact, Grid::across(&extent, nx, ny));
            assert_eq!(patch.strips.len(), ny);
            assert_relative_eq!(patch.load(), 10e3, max_relative = 1e-12);
            let area: f64 = patch.cells.iter().map(|c| c.covered * patch.grid.cell_area()).sum();
            assert_relative_eq!(area, 4.0 * a * b, max_relative = 1e-12);
            for cell in &patch.cells {
                assert_relative_eq!(cell.entry_x(), a, max_relative = 1e-12);
            }
        }
    }
}
