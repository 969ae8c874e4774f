//! The elliptic patch with Hertzian pressure: exact means over the covered part of each cell.

use crate::grid::{BORDER, Grid};
use crate::normal::NormalSummary;

use super::{Cell, Patch, Strip, Travel, with_ways};

/// Nodes and weights of the 8-point Gauss–Legendre rule on [−1, 1], positive half.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Largest interval of the rule, in rad: the pressure of a strip goes as cos³, which eight nodes
/// then integrate to rounding.
const LONGEST_INTERVAL: f64 = 0.4;

/// Integrals over the covered part of a cell.
#[derive(Debug, Clone, Copy, Default)]
struct Integrals {
    area: f64,
    force: f64,
    x: f64,
    y: f64,
    entry: Travel,
    exit: Travel,
}

impl Integrals {
    fn mean(&self, integral: &Travel) -> Travel {
        Travel {
            distance: integral.distance / self.area,
            moment_x: integral.moment_x / self.area,
            moment_y: integral.moment_y / self.area,
        }
    }
}

/// The patch x²/a² + y²/b² < 1 under p0 √(1 − x²/a² − y²/b²).
pub(super) fn patch(contact: &NormalSummary, grid: Grid) -> Patch {
    let mut patch = Patch { grid, strips: Vec::new(), cells: Vec::new() };
    for row in 0..grid.rows {
        let columns = integrate_row(contact, &grid, row);
        append_strip(&mut patch, row, &columns, contact);
    }
    patch
}

/// Integrals of every column in a row. Along x they are exact; along y a Gauss rule in the angle
/// θ, y = b sin θ, runs between the places where the ellipse crosses from one column to the next.
/// All columns share the nodes, so a strip's sum is as exact as the integral over its whole chord.
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
    breaks.sort_by(f64::total_cmp);
    let mut columns = vec![Integrals::default(); grid.columns];
    for pair in breaks.windows(2) {
        let parts = ((pair[1] - pair[0]) / LONGEST_INTERVAL).ceil().max(1.0);
        let half = 0.5 * (pair[1] - pair[0]) / parts;
        for part in 0..parts as usize {
            let middle = pair[0] + (2 * part + 1) as f64 * half;
            for (node, weight) in GAUSS {
                for theta in [middle - node * half, middle + node * half] {
                    let dy = weight * half * b * theta.cos();
                    let chord = Chord { y: b * theta.sin(), half: a * theta.cos(), dy };
                    add_chord(&mut columns, grid, contact.peak_pressure / a, &chord);
                }
            }
        }
    }
    columns
}

/// The part of the line y = const inside the ellipse, −half < x < half, with its weight.
struct Chord {
    y: f64,
    half: f64,
    dy: f64,
}

fn add_chord(columns: &mut [Integrals], grid: &Grid, slope: f64, chord: &Chord) {
    let Chord { y, half, dy } = *chord;
    let column = |x: f64| ((x - grid.origin_x) / grid.spacing_x).floor() as usize;
    let last = grid.columns - 1 - BORDER;
    let (first, end) = (column(-half).clamp(BORDER, last), column(half).clamp(BORDER, last));
    // ∫ √(h² − x²) dx
    let primitive = |x: f64| {
        let s = (x / half).clamp(-1.0, 1.0);
        0.5 * half * half * (s * (1.0 - s * s).sqrt() + s.asin())
    };
    let mut low = -half;
    let mut below = primitive(low);
    for i in first..=end {
        let high = if i == end { half } else { grid.edge_x(i + 1) };
        let above = primitive(high);
        let length = high - low;
        let square = 0.5 * (high * high - low * low);
        let cube = 0.5 * (half * half * length - (high.powi(3) - low.powi(3)) / 3.0);
        let (entry, exit) = (half * length - square, half * length + square);
        let sums = &mut columns[i];
        sums.area += dy * length;
        sums.force += dy * slope * (above - below);
        sums.x += dy * square;
        sums.y += dy * y * length;
        add_travel(&mut sums.entry, dy, entry, cube, y);
        add_travel(&mut sums.exit, dy, exit, -cube, y);
        low = high;
        below = above;
    }
}

fn add_travel(sum: &mut Travel, dy: f64, distance: f64, moment_x: f64, y: f64) {
    sum.distance += dy * distance;
    sum.moment_x += dy * moment_x;
    sum.moment_y += dy * y * distance;
}

fn append_strip(patch: &mut Patch, row: usize, columns: &[Integrals], contact: &NormalSummary) {
    let grid = patch.grid;
    let touched =
        (0..grid.columns).rev().filter(|i| columns[*i].area > SLIVER * grid.cell_area());
    let cells = with_ways(touched.clone().map(|i| cell(&grid, [i, row], &columns[i])).collect());
    let Some(last) = touched.last() else {
        return;
    };
    let area: f64 = columns.iter().map(|c| c.area).sum();
    let height = grid.edge_y(row + 1).min(contact.semi_axis_y)
        - grid.edge_y(row).max(-contact.semi_axis_y);
    let half_chord = 0.5 * area / height;
    let start = patch.cells.len();
    patch.cells.extend(cells);
    patch.strips.push(Strip {
        row,
        cells: start..patch.cells.len(),
        leading_edge: half_chord,
        trailing_edge: -half_chord,
        exit: columns[last].mean(&columns[last].exit),
    });
}

fn cell(grid: &Grid, [i, row]: [usize; 2], sums: &Integrals) -> Cell {
    Cell {
        index: grid.index(i, row),
        pressure: sums.force / grid.cell_area(),
        covered: (sums.area / grid.cell_area()).min(1.0),
        x: sums.x / sums.area,
        y: sums.y / sums.area,
        since_entry: sums.mean(&sums.entry),
        way_in: Travel::default(),
    }
}

/// A cell covered by less than this part is touched by rounding only.
const SLIVER: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::ellipse::Ellipse;
    use crate::normal::PressureSource;

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

    /// Inside, a cell's mean is its centre's pressure to second order, and the distance since
    /// entry is that from the mean edge of the row.
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
                    let distance = strip.leading_edge - cell.x;
                    assert_relative_eq!(cell.since_entry.distance, distance, max_relative = 1e-9);
                }
            }
        }
    }

    /// Every way into a cell is positive, and entry and exit mirror each other.
    #[test]
    fn material_always_moves_downstream() {
        for (nx, ny) in [(20, 20), (7, 30), (30, 7), (80, 80)] {
            let (patch, _) = ellipse(5e-3, 5e-3, nx, ny);
            for strip in &patch.strips {
                for k in strip.cells.clone() {
                    assert!(patch.cells[k].way_in.distance > 0.0);
                }
                let first = patch.cells[strip.cells.start].since_entry;
                assert_relative_eq!(first.distance, strip.exit.distance, max_relative = 1e-9);
                assert_relative_eq!(first.moment_x, -strip.exit.moment_x, max_relative = 1e-9);
            }
        }
    }
}
