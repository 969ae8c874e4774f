//! Cells in which nothing was measured: NaN or infinite heights.

use super::{HeightMap, Lattice, require_count};
use crate::error::Error;

/// What becomes of holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Holes {
    /// They are an error.
    #[default]
    Refuse,
    /// They are filled smoothly from their edges.
    Fill,
}

/// At most this part of the cells may be holes, dimensionless.
const LARGEST_SHARE: f64 = 0.5;

/// Sweeps over the holes; a change below this part of the range of heights ends them earlier.
const SWEEPS: usize = 5000;
const SETTLED: f64 = 1e-7;

/// Over-relaxation, dimensionless.
const OVER_RELAXATION: f64 = 1.8;

impl HeightMap {
    /// From heights (in m) row after row with holes, which are filled with the solution of Laplace's
    /// equation: no summits or pits of their own, no step at their edges.
    ///
    /// # Errors
    /// As [`HeightMap::new`] where holes are refused; holes in more than half of the cells.
    pub fn with_holes(lattice: Lattice, heights: Vec<f64>, holes: Holes) -> Result<Self, Error> {
        if holes == Holes::Refuse {
            return Self::new(lattice, heights);
        }
        lattice.check()?;
        require_count(&lattice, heights.len())?;
        let missing: Vec<usize> =
            (0..heights.len()).filter(|cell| !heights[*cell].is_finite()).collect();
        if missing.len() as f64 > LARGEST_SHARE * heights.len() as f64 {
            return Err(Error::Contradiction {
                quantity: "surface.heights",
                reason: format!(
                    "at most half of the cells may be holes, but {} of {} are",
                    missing.len(),
                    heights.len()
                ),
            });
        }
        let mut heights = heights;
        close_in(&lattice, &mut heights, &missing);
        relax(&lattice, &mut heights, &missing);
        Self::new(lattice, heights)
    }
}

/// Neighbours of a cell that share an edge with it.
fn neighbours(lattice: &Lattice, cell: usize) -> impl Iterator<Item = usize> {
    let Lattice { columns, rows, .. } = *lattice;
    let (i, j) = (cell % columns, cell / columns);
    [
        (i > 0).then(|| cell - 1),
        (i + 1 < columns).then(|| cell + 1),
        (j > 0).then(|| cell - columns),
        (j + 1 < rows).then(|| cell + columns),
    ]
    .into_iter()
    .flatten()
}

/// Gives the cells at the edge of the holes the mean of their neighbours, and so on inwards.
fn close_in(lattice: &Lattice, heights: &mut [f64], missing: &[usize]) {
    let mut open = missing.to_vec();
    while !open.is_empty() {
        let mean = |cell: &usize| {
            let known = neighbours(lattice, *cell).map(|n| heights[n]).filter(|h| h.is_finite());
            let (count, sum) = known.fold((0.0, 0.0), |(count, sum), h| (count + 1.0, sum + h));
            sum / count
        };
        let ring: Vec<(usize, f64)> = open.iter().map(|cell| (*cell, mean(cell))).collect();
        let closed = ring.iter().filter(|(_, height)| height.is_finite());
        closed.for_each(|(cell, height)| heights[*cell] = *height);
        let still_open = ring.into_iter().filter(|(_, height)| !height.is_finite());
        open = still_open.map(|(cell, _)| cell).collect();
    }
}

/// Solves Laplace's equation in the holes; where a hole reaches the edge of the map, without slope
/// across it.
fn relax(lattice: &Lattice, heights: &mut [f64], missing: &[usize]) {
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    for _ in 0..SWEEPS {
        let mut largest: f64 = 0.0;
        for &cell in missing {
            let (count, sum) = neighbours(lattice, cell)
                .fold((0.0, 0.0), |(count, sum), n| (count + 1.0, sum + heights[n]));
            let change = OVER_RELAXATION * (sum / count - heights[cell]);
            heights[cell] += change;
            largest = largest.max(change.abs());
        }
        if largest <= SETTLED * (high - low) {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// x² − y² solves Laplace's equation, also with differences of neighbours: a hole in it is filled
    /// with it.
    #[test]
    fn a_harmonic_surface_is_restored() {
        let lattice = Lattice { columns: 40, rows: 30, spacing_x: 1.0, spacing_y: 1.0 };
        let saddle = HeightMap::from_fn(lattice, |x, y| x * x - y * y).unwrap();
        let mut heights = saddle.heights().to_vec();
        for (row, column) in (8..20).flat_map(|j| (10..26).map(move |i| (j, i))) {
            heights[row * 40 + column] = f64::NAN;
        }
        let filled = HeightMap::with_holes(lattice, heights, Holes::Fill).unwrap();
        for (value, expected) in filled.heights().iter().zip(saddle.heights()) {
            assert_relative_eq!(*value, *expected, epsilon = 1e-3);
        }
    }

    #[test]
    fn holes_are_refused_unless_asked_for_and_never_all_of_it() {
        let lattice = Lattice::square(3, 1.0);
        let mut heights = vec![1.0; 9];
        heights[3] = f64::NAN;
        let refused = HeightMap::with_holes(lattice, heights.clone(), Holes::Refuse).unwrap_err();
        assert!(refused.to_string().contains("row 1, column 0"), "{refused}");
        let filled = HeightMap::with_holes(lattice, heights.clone(), Holes::Fill).unwrap();
        assert_eq!(filled.heights(), [1.0; 9]);
        heights[..6].fill(f64::NAN);
        let refused = HeightMap::with_holes(lattice, heights, Holes::Fill).unwrap_err();
        assert!(refused.to_string().contains("but 6 of 9 are"), "{refused}");
    }
}
