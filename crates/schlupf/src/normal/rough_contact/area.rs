//! Real contact area on a lattice.

use super::Boundary;
use crate::surface::Lattice;

/// (π − 1 + ln 2)/24, dimensionless: the excess area of a cell on the edge of a spot, per edge.
const EDGE_SHARE: f64 = (std::f64::consts::PI - 1.0 + std::f64::consts::LN_2) / 24.0;

/// Area of all cells in contact, and the same without the excess of the cells on the edge of the
/// spots; in m².
///
/// The correction is S Δ (π − 1 + ln 2)/24 with the perimeter S of the spots along the edges of the
/// cells (Yastrebov, Anciaux and Molinari 2017, Tribology International 114, 161).
pub(super) fn contact_area(
    lattice: &Lattice,
    is_contact: impl Fn(usize) -> bool,
    boundary: Boundary,
) -> [f64; 2] {
    let cells = (0..lattice.len()).filter(|cell| is_contact(*cell)).count() as f64;
    let edges = edges(lattice, is_contact, boundary) as f64;
    [cells * lattice.cell_area(), (cells - EDGE_SHARE * edges) * lattice.cell_area()]
}

/// Edges between a cell in contact and one that is not.
fn edges(lattice: &Lattice, is_contact: impl Fn(usize) -> bool, boundary: Boundary) -> usize {
    let Lattice { columns, rows, .. } = *lattice;
    let mut count = 0;
    for cell in 0..lattice.len() {
        let (i, j) = (cell % columns, cell / columns);
        let next = [
            (i + 1 == columns, cell + 1 - if i + 1 == columns { columns } else { 0 }),
            (j + 1 == rows, (cell + columns) % lattice.len()),
        ];
        let here = is_contact(cell);
        for (wraps, neighbour) in next {
            let there = is_contact(neighbour);
            count += match boundary {
                Boundary::Free if wraps => usize::from(here) + usize::from(there),
                _ => usize::from(here != there),
            };
        }
    }
    count
}

/// Whether a cell in contact is at the edge of the lattice; a single row is that of a line, which
/// ends along rolling only.
pub(super) fn touches_edge(lattice: &Lattice, is_contact: impl Fn(usize) -> bool) -> bool {
    let Lattice { columns, rows, .. } = *lattice;
    let ends = (0..rows).flat_map(|j| [j * columns, (j + 1) * columns - 1]);
    let across = if rows == 1 { 0..0 } else { 0..columns };
    let sides = across.flat_map(|i| [i, (rows - 1) * columns + i]);
    ends.chain(sides).any(is_contact)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const LATTICE: Lattice = Lattice { columns: 4, rows: 3, spacing_x: 2.0, spacing_y: 1.0 };

    #[test]
    fn edges_are_counted_across_the_boundary() {
        let block = |cell: usize| [0, 1, 4].contains(&cell);
        assert_eq!(edges(&LATTICE, block, Boundary::Periodic), 8);
        assert_eq!(edges(&LATTICE, block, Boundary::Free), 8);
        let row = |cell: usize| cell < 4;
        assert_eq!(edges(&LATTICE, row, Boundary::Periodic), 8);
        assert_eq!(edges(&LATTICE, row, Boundary::Free), 10);
        assert!(touches_edge(&LATTICE, block) && !touches_edge(&LATTICE, |cell| cell == 5));
    }

    /// A square of 20 by 20 cells has a perimeter of 80.
    #[test]
    fn yastrebov_2017_perimeter_of_a_square() {
        let lattice = Lattice::square(200, 200.0);
        let is_inside = |k: usize| (90..110).contains(&k);
        let square = |cell: usize| is_inside(cell % 200) && is_inside(cell / 200);
        let [cells, corrected] = contact_area(&lattice, square, Boundary::Periodic);
        assert_eq!(cells, 400.0);
        assert_relative_eq!(corrected, 400.0 - 80.0 * 2.834_739_8 / 24.0, max_relative = 1e-7);
    }
}
