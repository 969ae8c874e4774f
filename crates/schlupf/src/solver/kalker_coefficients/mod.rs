//! Kalker's creep coefficients: rolling of an elliptic contact on the half-space without sliding,
//! solved as a linear problem (Kalker 1990).
//!
//! In full adhesion the displacement of a point on the rail, relative to where it entered, equals
//! the rigid slip along its path: A p − (A p)_lead = D. The patch is cut into strips along rolling,
//! narrow towards the tips (y = b sin θ), and each strip into cells that become short towards its
//! two edges (x = h cos φ), where the traction rises steeply. There are no partly covered cells,
//! and the remaining error decreases regularly with the grid, so it is removed by extrapolation.

mod table;
mod interpolated;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::DMatrix;

use crate::bodies::Material;
use crate::elasticity::HalfSpace;
use crate::reporting::{Error, Place, Quantity, Requirement, require, require_positive};
use crate::solver::reference::CreepCoefficients;

pub use interpolated::interpolated_coefficients;

pub(crate) use interpolated::is_tabulated;

/// Computes the creep coefficients of an ellipse with the axis ratio a/b (dimensionless, a along
/// rolling) for the combined Poisson's ratio ν (dimensionless). For a/b from 0.1 to 10 they are
/// exact to 0.5 %, C33 to 0.9 %.
///
/// C23 is computed from the moment under lateral creepage, which equals the force under spin.
///
/// ```
/// use schlupf::solver::kalker_coefficients::{creep_coefficients, interpolated_coefficients};
///
/// let exact = creep_coefficients(1.0, 0.25)?;
/// // Kalker 1967.
/// assert!((exact.c11 - 4.12).abs() < 0.03);
/// assert!((interpolated_coefficients(1.0, 0.25)?.c11 / exact.c11 - 1.0).abs() < 1e-3);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn creep_coefficients(axis_ratio: f64, poisson_ratio: f64) -> Result<CreepCoefficients, Error> {
    check(axis_ratio, poisson_ratio)?;
    require(Quantity::AxisRatio, SOLVABLE, axis_ratio)?;
    let [coarse, fine] = GRIDS;
    let on = |across| -> Result<[f64; 4], Error> {
        let values = Stick::new(axis_ratio, poisson_ratio, across)?.coefficients();
        values.ok_or(Error::Invalid {
            quantity: Quantity::AxisRatio,
            requirement: SOLVABLE,
            value: axis_ratio,
            place: Place::Only,
        })
    };
    let (coarse_values, fine_values) = (on(coarse)?, on(fine)?);
    let weight = 1.0 / ((fine as f64 / coarse as f64).powf(ORDER) - 1.0);
    let extrapolated = |c: usize| fine_values[c] + weight * (fine_values[c] - coarse_values[c]);
    Ok(CreepCoefficients {
        c11: extrapolated(0),
        c22: extrapolated(1),
        c23: extrapolated(2),
        c33: extrapolated(3),
    })
}

fn check(axis_ratio: f64, poisson_ratio: f64) -> Result<(), Error> {
    require_positive(Quantity::AxisRatio, axis_ratio)?;
    require(Quantity::PoissonRatio, Requirement::Between(0.0, 0.5), poisson_ratio)
}

/// Cells along and strips across the patch, for the two grids used.
const GRIDS: [usize; 2] = [24, 32];

/// Axis ratios of which the tractions are computed.
const SOLVABLE: Requirement = Requirement::Between(1e-6, 1e6);

/// Order of the error in the cell size: between 1.4 and 1.8, as measured on grids of 8 to 48 cells.
const ORDER: f64 = 1.5;

/// A cell, in units of √(ab).
struct Cell {
    middle: [f64; 2],
    size: [f64; 2],
    /// The leading edge of its strip.
    entry: f64,
}

/// The contact in full adhesion, in units of √(ab) and G: the half y > 0 of the patch.
struct Stick {
    bodies: HalfSpace,
    cells: Vec<Cell>,
}

/// Continuation of a traction to y < 0.
#[derive(Clone, Copy)]
enum Parity {
    /// t_x even, t_y odd: longitudinal creepage.
    Longitudinal,
    /// t_x odd, t_y even: lateral creepage and spin.
    Lateral,
}

impl Stick {
    fn new(axis_ratio: f64, poisson_ratio: f64, across: usize) -> Result<Self, Error> {
        let (a, b) = (axis_ratio.sqrt(), axis_ratio.sqrt().recip());
        // G = 1.
        let young_modulus = 2.0 * (1.0 + poisson_ratio);
        let material = Material { young_modulus, poisson_ratio, ..Material::STEEL };
        let bodies = HalfSpace::new(&material, &material)?;
        let strips = across / 2;
        let mut cells = Vec::with_capacity(strips * across);
        for strip in 0..strips {
            let angle = |k: usize| FRAC_PI_2 * k as f64 / strips as f64;
            let (low, high) = (angle(strip), angle(strip + 1));
            let width = b * (high.sin() - low.sin());
            let y = 0.5 * b * (high.sin() + low.sin());
            // The mean of a cos θ over the strip: the area is that of the ellipse.
            let area = 0.5 * (high - low) + 0.25 * ((2.0 * high).sin() - (2.0 * low).sin());
            let half_length = a * b * area / width;
            let edge = |k: usize| half_length * (PI * k as f64 / across as f64).cos();
            for k in 0..across {
                let (ahead, behind) = (edge(k), edge(k + 1));
                let middle = [0.5 * (ahead + behind), y];
                cells.push(Cell { middle, size: [ahead - behind, width], entry: half_length });
            }
        }
        Ok(Self { bodies, cells })
    }

    /// [C11, C22, C23, C33] on this grid; `None` if the compliance is singular to machine accuracy.
    fn coefficients(&self) -> Option<[f64; 4]> {
        let longitudinal = self.tractions(Parity::Longitudinal, |_, distance| [[distance, 0.0]])?;
        let lateral = self.tractions(Parity::Lateral, |cell, distance| {
            let moment = 0.5 * (cell.entry.powi(2) - cell.middle[0].powi(2));
            [[0.0, distance], [-cell.middle[1] * distance, moment]]
        })?;
        // Both halves of the patch contribute equally to what does not vanish.
        let sum = |traction: &DMatrix<f64>, column: usize, weights: &dyn Fn(&Cell) -> [f64; 2]| {
            let share = |(k, cell): (usize, &Cell)| {
                let [x, y] = weights(cell);
                let force = x * traction[(2 * k, column)] + y * traction[(2 * k + 1, column)];
                2.0 * force * cell.size[0] * cell.size[1]
            };
            self.cells.iter().enumerate().map(share).sum::<f64>()
        };
        let moment = |cell: &Cell| [-cell.middle[1], cell.middle[0]];
        Some([
            sum(&longitudinal, 0, &|_| [1.0, 0.0]),
            sum(&lateral, 0, &|_| [0.0, 1.0]),
            -sum(&lateral, 0, &moment),
            sum(&lateral, 1, &moment),
        ])
    }

    /// Tractions in full adhesion under the rigid slips of each cell, one column per slip; `None`
    /// if the compliance is singular to machine accuracy.
    fn tractions<const N: usize>(
        &self,
        parity: Parity,
        rigid_slips: impl Fn(&Cell, f64) -> [[f64; 2]; N],
    ) -> Option<DMatrix<f64>> {
        let size = 2 * self.cells.len();
        let mut slips = DMatrix::zeros(size, N);
        for (k, cell) in self.cells.iter().enumerate() {
            for (column, slip) in rigid_slips(cell, cell.entry - cell.middle[0]).iter().enumerate()
            {
                slips[(2 * k, column)] = slip[0];
                slips[(2 * k + 1, column)] = slip[1];
            }
        }
        self.compliance(parity).lu().solve(&slips)
    }

    /// A − A_lead.
    fn compliance(&self, parity: Parity) -> DMatrix<f64> {
        let size = 2 * self.cells.len();
        let mut matrix = DMatrix::zeros(size, size);
        for (s, source) in self.cells.iter().enumerate() {
            let mut at_entry = [[0.0; 2]; 2];
            let mut entered_y = f64::NAN;
            for (k, cell) in self.cells.iter().enumerate() {
                if cell.middle[1] != entered_y {
                    entered_y = cell.middle[1];
                    at_entry = self.influence(source, [cell.entry, entered_y], parity);
                }
                let here = self.influence(source, cell.middle, parity);
                for row in 0..2 {
                    for column in 0..2 {
                        matrix[(2 * k + row, 2 * s + column)] =
                            here[row][column] - at_entry[row][column];
                    }
                }
            }
        }
        matrix
    }

    /// Displacement of a point due to unit tractions on a cell and on its mirror image in y.
    fn influence(&self, source: &Cell, [x, y]: [f64; 2], parity: Parity) -> [[f64; 2]; 2] {
        let along = x - source.middle[0];
        let of = |across| self.bodies.influence_of(source.size, [along, across]);
        let ([xx, yy, xy], image) = (of(y - source.middle[1]), of(y + source.middle[1]));
        let sign = match parity {
            Parity::Longitudinal => 1.0,
            Parity::Lateral => -1.0,
        };
        [[xx + sign * image[0], xy - sign * image[2]], [xy + sign * image[2], yy - sign * image[1]]]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// The cells cover the half of an ellipse of area π (a b = 1).
    #[test]
    fn cells_have_the_area_of_the_ellipse() {
        for axis_ratio in [0.1, 1.0, 10.0] {
            let stick = Stick::new(axis_ratio, 0.25, 16).unwrap();
            let area: f64 = stick.cells.iter().map(|c| c.size[0] * c.size[1]).sum();
            assert_relative_eq!(area, FRAC_PI_2, max_relative = 1e-12);
        }
    }

    /// For zero Poisson's ratio a circle has the same coefficient in both directions, C11 = C22
    /// (Kalker 1990, Table E.3): along and across rolling, two different systems.
    #[test]
    fn kalker_1990_no_lateral_contraction() {
        let [c11, c22, ..] = Stick::new(1.0, 0.0, 12).unwrap().coefficients().unwrap();
        assert_relative_eq!(c11, c22, max_relative = 1e-12);
    }

    #[test]
    fn illegal_ratios_are_named() {
        let text = |result: Result<CreepCoefficients, Error>| result.unwrap_err().to_string();
        assert!(text(creep_coefficients(-1.0, 0.3)).starts_with("axis_ratio"));
        assert!(text(creep_coefficients(f64::NAN, 0.3)).starts_with("axis_ratio"));
        assert!(text(creep_coefficients(1.0, 0.6)).starts_with("poisson_ratio"));
    }
}
