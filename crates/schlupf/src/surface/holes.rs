//! Cells without a measured height: NaN or infinite heights.

use super::{HeightMap, Lattice, require_count};
use crate::numerics::interpolation::bilinear;
use crate::numerics::vector::{add_scaled, dot, norm};
use crate::reporting::{Error, SurfaceError};

/// Treatment of holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Holes {
    /// They are an error.
    #[default]
    Refuse,
    /// They are filled smoothly from their edges.
    Fill,
}

/// Largest admissible fraction of cells or points that are holes, dimensionless.
const LARGEST_SHARE: f64 = 0.5;

/// Residual of a cell (root mean square) relative to the range of heights, dimensionless; and more
/// iterations than are needed to reach it.
const SETTLED: f64 = 1e-8;
const ITERATIONS: usize = 20_000;

/// Lattices with fewer cells than this along a side are not coarsened along it.
const COARSEST: usize = 8;

/// Rejects heights of which too many are missing.
pub fn require_few(heights: &[f64]) -> Result<(), Error> {
    let missing = heights.iter().filter(|height| !height.is_finite()).count();
    if missing as f64 <= LARGEST_SHARE * heights.len() as f64 {
        return Ok(());
    }
    let count = heights.len();
    Err(SurfaceError::TooManyHoles { holes: missing, count }.into())
}

impl HeightMap {
    /// A map from heights (in m) row after row with holes, which are filled with the solution of
    /// Laplace's equation: it has no summits or pits of its own, and no step at the edges of the
    /// holes. Filled cells are smoother than the surface, so the more there are, the smoother the
    /// result.
    ///
    /// # Errors
    /// As [`HeightMap::new`] if holes are to be rejected; holes in more than half of the cells.
    pub fn with_holes(lattice: Lattice, heights: Vec<f64>, holes: Holes) -> Result<Self, Error> {
        if holes == Holes::Refuse {
            return Self::new(lattice, heights);
        }
        lattice.check()?;
        require_count(&lattice, heights.len())?;
        require_few(&heights)?;
        let mut heights = heights;
        fill(&lattice, &mut heights)?;
        Self::new(lattice, heights)
    }
}

/// Solves Laplace's equation in the holes, first on a lattice of half as many cells along the sides
/// that are long enough. Where a hole reaches the edge of the map, the slope normal to the edge is
/// zero.
fn fill(lattice: &Lattice, heights: &mut [f64]) -> Result<(), Error> {
    let missing: Vec<usize> =
        (0..heights.len()).filter(|cell| !heights[*cell].is_finite()).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let by = [lattice.columns, lattice.rows].map(|count| if count < COARSEST { 1 } else { 2 });
    if by == [1, 1] {
        let known = heights.iter().filter(|height| height.is_finite());
        let mean = known.sum::<f64>() / (heights.len() - missing.len()) as f64;
        for cell in &missing {
            heights[*cell] = mean;
        }
    } else {
        let (coarse, mut means) = coarser(lattice, heights, by);
        fill(&coarse, &mut means)?;
        for cell in &missing {
            let place = [cell % lattice.columns, cell / lattice.columns];
            heights[*cell] = between(&coarse, &means, place, by);
        }
    }
    Laplace::new(lattice, &missing, heights).solve(heights)
}

/// The means of blocks of cells, over the known heights.
fn coarser(lattice: &Lattice, heights: &[f64], by: [usize; 2]) -> (Lattice, Vec<f64>) {
    let columns = lattice.columns.div_ceil(by[0]);
    let coarse = Lattice {
        columns,
        rows: lattice.rows.div_ceil(by[1]),
        spacing_x: by[0] as f64 * lattice.spacing_x,
        spacing_y: by[1] as f64 * lattice.spacing_y,
    };
    let mut sums = vec![[0.0; 2]; coarse.len()];
    for (cell, height) in heights.iter().enumerate().filter(|(_, height)| height.is_finite()) {
        let (i, j) = (cell % lattice.columns / by[0], cell / lattice.columns / by[1]);
        let sum = &mut sums[j * columns + i];
        *sum = [sum[0] + height, sum[1] + 1.0];
    }
    (coarse, sums.iter().map(|[sum, count]| sum / count).collect())
}

/// The height of a fine cell, interpolated linearly between the nearest coarse ones.
fn between(coarse: &Lattice, heights: &[f64], place: [usize; 2], by: [usize; 2]) -> f64 {
    let near = |at: usize, by: usize, count: usize| {
        if by == 1 {
            return ([at; 2], 0.0);
        }
        let inner = at / 2;
        let outer = if at.is_multiple_of(2) { inner.saturating_sub(1) } else { inner + 1 };
        ([inner, outer.min(count - 1)], 0.25)
    };
    let (columns, to_outer_x) = near(place[0], by[0], coarse.columns);
    let (rows, to_outer_y) = near(place[1], by[1], coarse.rows);
    let corners = rows.into_iter().flat_map(|j| columns.map(|i| heights[j * coarse.columns + i]));
    bilinear([to_outer_x, to_outer_y]).iter().zip(corners).map(|(w, height)| w * height).sum()
}

/// Laplace's equation in some cells: Σ w (h − h of the neighbour) = 0, where w is the length of the
/// common edge divided by the distance.
struct Laplace<'a> {
    missing: &'a [usize],
    /// Indices of the missing neighbours of each missing cell.
    neighbours: Vec<[u32; 4]>,
    weights: [f64; 4],
    /// Sums of the weights.
    diagonal: Vec<f64>,
    /// Contribution of the known neighbours of each missing cell, in m.
    known: Vec<f64>,
}

/// Marks the absence of a missing cell.
const NONE: u32 = u32::MAX;

impl<'a> Laplace<'a> {
    fn new(lattice: &Lattice, missing: &'a [usize], heights: &[f64]) -> Self {
        let mut numbers = vec![NONE; lattice.len()];
        for (number, cell) in (0..).zip(missing) {
            numbers[*cell] = number;
        }
        let ratio = lattice.spacing_y / lattice.spacing_x;
        let weights = [ratio, ratio, ratio.recip(), ratio.recip()];
        let mut equations = Self {
            missing,
            neighbours: Vec::with_capacity(missing.len()),
            weights,
            diagonal: Vec::with_capacity(missing.len()),
            known: Vec::with_capacity(missing.len()),
        };
        for cell in missing {
            let (mut diagonal, mut known) = (0.0, 0.0);
            let near = neighbours(lattice, *cell);
            for (near, w) in near.iter().zip(weights).filter_map(|(near, w)| Some(((*near)?, w))) {
                diagonal += w;
                known += if numbers[near] == NONE { w * heights[near] } else { 0.0 };
            }
            equations.diagonal.push(diagonal);
            equations.known.push(known);
            equations.neighbours.push(near.map(|near| near.map_or(NONE, |near| numbers[near])));
        }
        equations
    }

    /// Solves by conjugate gradients with the diagonal as preconditioner, starting from the present
    /// heights.
    fn solve(&self, heights: &mut [f64]) -> Result<(), Error> {
        let mut found: Vec<f64> = self.missing.iter().map(|cell| heights[*cell]).collect();
        let mut image = vec![0.0; found.len()];
        self.apply(&found, &mut image);
        let mut residual: Vec<f64> = self.known.iter().zip(&image).map(|(b, a)| b - a).collect();
        // The origin of heights is arbitrary: convergence is measured relative to their range.
        let differ = spread(heights);
        let limit = SETTLED * differ * (found.len() as f64).sqrt();
        let mut direction = vec![0.0; found.len()];
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            if norm(&residual) <= limit {
                self.missing.iter().zip(&found).for_each(|(cell, height)| heights[*cell] = *height);
                return Ok(());
            }
            let scaled = || residual.iter().zip(&self.diagonal).map(|(r, d)| r / d);
            let square: f64 = scaled().zip(&residual).map(|(z, r)| z * r).sum();
            let turn = if last.is_finite() { square / last } else { 0.0 };
            direction.iter_mut().zip(scaled()).for_each(|(p, z)| *p = z + turn * *p);
            last = square;
            self.apply(&direction, &mut image);
            let step = square / dot(&direction, &image);
            add_scaled(&mut found, step, &direction);
            add_scaled(&mut residual, -step, &image);
        }
        Err(SurfaceError::HolesNotFilled { iterations: ITERATIONS }.into())
    }

    fn apply(&self, values: &[f64], image: &mut [f64]) {
        let cells = self.neighbours.iter().zip(&self.diagonal).zip(values);
        for (image, ((near, diagonal), value)) in image.iter_mut().zip(cells) {
            let others = near.iter().zip(self.weights).filter(|(near, _)| **near != NONE);
            let sum: f64 = others.map(|(near, w)| w * values[*near as usize]).sum();
            *image = diagonal * value - sum;
        }
    }
}

/// Range of heights, in m.
fn spread(heights: &[f64]) -> f64 {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = heights.iter().fold(start, |[low, high], h| [low.min(*h), high.max(*h)]);
    // Rounding error of equal heights counts as converged, too.
    (high - low).max(1e-6 * high.abs().max(low.abs()))
}

/// Cells that share an edge with a cell: left, right, below and above.
fn neighbours(lattice: &Lattice, cell: usize) -> [Option<usize>; 4] {
    let Lattice { columns, rows, .. } = *lattice;
    let (i, j) = (cell % columns, cell / columns);
    [
        (i > 0).then(|| cell - 1),
        (i + 1 < columns).then(|| cell + 1),
        (j > 0).then(|| cell - columns),
        (j + 1 < rows).then(|| cell + columns),
    ]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// x² − y² solves Laplace's equation, also in its discrete form: a hole in it is filled
    /// exactly.
    #[test]
    fn a_harmonic_surface_is_restored() {
        let lattice = Lattice { columns: 40, rows: 30, spacing_x: 1.0, spacing_y: 1.5 };
        let saddle = HeightMap::from_fn(lattice, |x, y| x * x - y * y).unwrap();
        let mut heights = saddle.heights().to_vec();
        for (row, column) in (8..20).flat_map(|j| (10..26).map(move |i| (j, i))) {
            heights[row * 40 + column] = f64::NAN;
        }
        let filled = HeightMap::with_holes(lattice, heights, Holes::Fill).unwrap();
        for (value, expected) in filled.heights().iter().zip(saddle.heights()) {
            assert_relative_eq!(*value, *expected, epsilon = 1e-5);
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
