//! Lattices that the points of a table lie on.

use super::columns::Columns;
use crate::error::CaseError;

/// Positions may differ from the lattice by this part of a spacing: text has few digits.
const ROUNDING: f64 = 0.01;

/// Equidistant positions.
#[derive(Debug)]
pub struct Axis {
    /// The lowest, in m.
    pub first: f64,
    /// In m.
    pub spacing: f64,
    /// How many there are.
    pub count: usize,
}

impl Axis {
    /// The lattice that positions in any order lie on.
    pub fn of(name: &str, positions: &[f64], columns: &Columns) -> Result<Self, CaseError> {
        let mut sorted = positions.to_vec();
        sorted.sort_by(f64::total_cmp);
        let widest = sorted.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        let (Some(&first), Some(&last)) = (sorted.first(), sorted.last()) else {
            let file = columns.field();
            let message =
                format!("{file} must have at least two values of {name}, but has no rows");
            return Err(columns.error(columns.header_line, message));
        };
        if widest <= 0.0 {
            let message =
                format!("{name} must have at least two values, but is the same everywhere");
            return Err(columns.error(columns.header_line, message));
        }
        let steps = ((last - first) / widest).round();
        let axis = Self { first, spacing: (last - first) / steps, count: 1 + steps as usize };
        let stray = positions.iter().position(|x| !axis.holds(*x) || !steps.is_finite());
        match stray {
            None => Ok(axis),
            Some(row) => {
                let message = format!(
                    "{name} must be equidistant, but {} mm lies between the multiples of the spacing {} mm",
                    rounded(positions[row] * 1e3),
                    rounded(axis.spacing * 1e3)
                );
                Err(columns.error(columns.lines[row], message))
            }
        }
    }

    /// Which one a position is.
    pub fn index(&self, position: f64) -> usize {
        ((position - self.first) / self.spacing).round() as usize
    }

    /// Where one is, in m.
    pub fn position(&self, index: usize) -> f64 {
        self.first + self.spacing * index as f64
    }

    /// Where all are, in m.
    pub fn positions(&self) -> Vec<f64> {
        (0..self.count).map(|index| self.position(index)).collect()
    }

    fn holds(&self, position: f64) -> bool {
        (position - self.position(self.index(position))).abs() <= ROUNDING * self.spacing
    }
}

/// A length in mm without the digits that conversion adds.
pub fn rounded(length: f64) -> f64 {
    (length * 1e6).round() / 1e6
}
