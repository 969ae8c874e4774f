//! Surfaces: heights on a regular lattice, measured or synthetic.
//!
//! Heights are positive out of the material. They are given at the centres of rectangular cells;
//! the first row contains the cells along x with the smallest y.

pub mod form;
pub mod ring_spectrum;
pub mod spectrum;
pub mod synthesis;
mod line_spectrum;
mod profile;
mod filter;
mod holes;
mod resampling;
mod statistics;

pub use holes::{Holes, require_few};
pub use line_spectrum::LineSpectrum;
pub use profile::Profile;
pub use statistics::Statistics;

use crate::reporting::{
    Error, Place, Quantity, Requirement, SurfaceError, require, require_at, require_positive,
};

/// A regular lattice of rectangular cells.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Lattice {
    /// Number of cells along x.
    pub columns: usize,
    /// Number of cells along y.
    pub rows: usize,
    /// Cell size Δx, in m.
    pub spacing_x: f64,
    /// Cell size Δy, in m.
    pub spacing_y: f64,
}

impl Lattice {
    /// `cells` × `cells` square cells on a square of the given side, in m.
    pub fn square(cells: usize, side: f64) -> Self {
        let spacing = side / cells as f64;
        Self { columns: cells, rows: cells, spacing_x: spacing, spacing_y: spacing }
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.columns * self.rows
    }

    /// Whether there are no cells.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Length along x, in m.
    pub fn length_x(&self) -> f64 {
        self.columns as f64 * self.spacing_x
    }

    /// Length along y, in m.
    pub fn length_y(&self) -> f64 {
        self.rows as f64 * self.spacing_y
    }

    /// Area of a cell, in m².
    pub fn cell_area(&self) -> f64 {
        self.spacing_x * self.spacing_y
    }

    /// Area of all cells, in m².
    pub fn area(&self) -> f64 {
        self.length_x() * self.length_y()
    }

    /// Centre of column `i` (in m), relative to the centre of the lattice.
    pub fn x(&self, i: usize) -> f64 {
        (i as f64 + 0.5 - 0.5 * self.columns as f64) * self.spacing_x
    }

    /// Centre of row `j` (in m), relative to the centre of the lattice.
    pub fn y(&self, j: usize) -> f64 {
        (j as f64 + 0.5 - 0.5 * self.rows as f64) * self.spacing_y
    }

    /// Centres of all cells, row after row, in m.
    pub fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        let lattice = *self;
        (0..self.rows)
            .flat_map(move |j| (0..lattice.columns).map(move |i| [lattice.x(i), lattice.y(j)]))
    }

    /// Checks that there are at least two cells in each direction, of positive size.
    pub fn check(&self) -> Result<(), Error> {
        let counts = [(Quantity::Columns, self.columns), (Quantity::Rows, self.rows)];
        for (quantity, count) in counts {
            require(quantity, Requirement::Between(2.0, LARGEST as f64), count as f64)?;
        }
        let (columns, rows, most) = (self.columns, self.rows, LARGEST_TOGETHER);
        if columns.checked_mul(rows).is_none_or(|cells| cells > most) {
            return Err(Error::TooManyCells { columns, rows, most });
        }
        require_positive(Quantity::SpacingX, self.spacing_x)?;
        require_positive(Quantity::SpacingY, self.spacing_y)
    }
}

/// Maximum number of cells in one direction, limited by memory and transforms.
const LARGEST: usize = 1 << 20;

/// Maximum number of cells, whose transforms, twice as long in each direction and complex, must fit
/// into the address space: 2²⁴ on a 32-bit machine.
const LARGEST_TOGETHER: usize = 1 << (usize::BITS - 8);

/// Heights on a lattice, all finite.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HeightMap {
    lattice: Lattice,
    heights: Vec<f64>,
    is_periodic: bool,
}

impl HeightMap {
    /// A map from heights (in m), row after row.
    ///
    /// # Errors
    /// A lattice without cells, a wrong number of heights, a height that is not finite: holes must
    /// be filled beforehand (see [`Holes`]).
    pub fn new(lattice: Lattice, heights: Vec<f64>) -> Result<Self, Error> {
        lattice.check()?;
        require_count(&lattice, heights.len())?;
        for (cell, height) in heights.iter().enumerate() {
            let place = Place::Cell { row: cell / lattice.columns, column: cell % lattice.columns };
            require_at(Quantity::Heights, Requirement::Finite, *height, place)?;
        }
        Ok(Self { lattice, heights, is_periodic: false })
    }

    /// A single row of heights (in m), which are finite: a line contact.
    pub(crate) fn row(lattice: Lattice, heights: Vec<f64>) -> Self {
        Self { lattice, heights, is_periodic: false }
    }

    /// Heights given by a function of x and y (in m), relative to the centre of the lattice.
    ///
    /// ```
    /// use schlupf::surface::{HeightMap, Lattice, Statistics};
    ///
    /// let wave = |x: f64| 1e-6 * (std::f64::consts::TAU * x / 1e-3).sin();
    /// let surface = HeightMap::from_fn(Lattice::square(64, 1e-3), |x, _| wave(x))?;
    /// let height = Statistics::of(&surface)?.root_mean_square_height;
    /// assert!((height * 2.0_f64.sqrt() - 1e-6).abs() < 1e-9);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn from_fn(lattice: Lattice, height: impl Fn(f64, f64) -> f64) -> Result<Self, Error> {
        lattice.check()?;
        Self::new(lattice, lattice.points().map(|[x, y]| height(x, y)).collect())
    }

    /// The same surface, marked as continuing periodically without a jump, like synthetic ones.
    pub fn into_periodic(self) -> Self {
        Self { is_periodic: true, ..self }
    }

    /// Whether the surface is known to continue periodically without a jump. Otherwise a window is
    /// needed before its spectrum is computed (see [`spectrum::Window::of`]).
    pub fn is_periodic(&self) -> bool {
        self.is_periodic
    }

    /// The lattice of the heights.
    pub fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// Heights row after row, in m.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Mean height, in m.
    pub fn mean(&self) -> f64 {
        self.heights.iter().sum::<f64>() / self.heights.len() as f64
    }

    /// Smallest and largest height, in m.
    pub fn range(&self) -> [f64; 2] {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        self.heights.iter().fold(start, |[low, high], h| [low.min(*h), high.max(*h)])
    }

    /// The same surface with heights relative to its mean height.
    pub fn about_its_mean(&self) -> Self {
        let mean = self.mean();
        self.with_heights(|height| height - mean)
    }

    /// The same surface with all heights multiplied by a factor (dimensionless).
    pub fn scaled(&self, factor: f64) -> Self {
        self.with_heights(|height| factor * height)
    }

    /// Undeformed distance between this surface and a plane that rests on its summit.
    pub fn distance_to_plane(&self) -> Self {
        let [_, summit] = self.range();
        self.with_heights(|height| summit - height)
    }

    /// Undeformed distance between two surfaces that touch at one point: both heights are positive
    /// out of their own body, and cells with the same index face each other.
    pub fn distance_to(&self, other: &Self) -> Result<Self, Error> {
        Ok(self.plus(other)?.distance_to_plane())
    }

    /// The sum of the heights of two surfaces: their combined roughness.
    pub fn plus(&self, other: &Self) -> Result<Self, Error> {
        if self.lattice != other.lattice {
            let both = [&self.lattice, &other.lattice];
            let cells = both.map(|lattice| [lattice.columns, lattice.rows]);
            let spacings = both.map(|lattice| [lattice.spacing_x, lattice.spacing_y]);
            return Err(SurfaceError::LatticesDiffer { cells, spacings }.into());
        }
        let pairs = self.heights.iter().zip(&other.heights);
        let heights = pairs.map(|(a, b)| a + b).collect();
        let is_periodic = self.is_periodic && other.is_periodic;
        Ok(Self { lattice: self.lattice, heights, is_periodic })
    }

    /// Rejects a surface without roughness: one whose heights differ, relative to its size, only by
    /// rounding error.
    pub fn require_rough(&self) -> Result<(), Error> {
        let [low, high] = self.range();
        let rounding = 1e-13 * low.abs().max(high.abs());
        if high - low > rounding {
            return Ok(());
        }
        Err(SurfaceError::Flat { height: Some(low) }.into())
    }

    fn with_heights(&self, change: impl Fn(f64) -> f64) -> Self {
        let heights = self.heights.iter().map(|height| change(*height)).collect();
        Self { heights, ..*self }
    }
}

fn require_count(lattice: &Lattice, count: usize) -> Result<(), Error> {
    if count == lattice.len() {
        return Ok(());
    }
    Err(Error::WrongCount { quantity: Quantity::Heights, expected: lattice.len(), count })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice() -> Lattice {
        Lattice { columns: 3, rows: 2, spacing_x: 1e-6, spacing_y: 2e-6 }
    }

    #[test]
    fn each_defect_is_named() {
        let good = vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        let mut holes = good.clone();
        holes[4] = f64::NAN;
        let cases = [
            (Lattice { columns: 1, ..lattice() }, good.clone(), "columns must be between"),
            (Lattice { spacing_y: 0.0, ..lattice() }, good.clone(), "spacing_y must be"),
            (lattice(), good[..5].to_vec(), "heights needs 6 values, got 5"),
            (lattice(), holes, "but is NaN m in row 1, column 1"),
        ];
        for (lattice, heights, expected) in cases {
            let message = HeightMap::new(lattice, heights).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
        assert!(HeightMap::new(lattice(), good).unwrap().require_rough().is_ok());
    }

    #[test]
    fn a_flat_surface_is_not_rough() {
        let flat = HeightMap::new(lattice(), vec![2e-6; 6]).unwrap();
        let message = flat.require_rough().unwrap_err().to_string();
        assert!(message.contains("must not be flat"), "{message}");
    }

    #[test]
    fn two_surfaces_touch_at_their_highest_sum() {
        let first = HeightMap::new(lattice(), vec![0.0, 1.0, 0.0, 0.0, 0.0, 0.0]).unwrap();
        let second = HeightMap::new(lattice(), vec![0.0, 1.0, 0.0, 0.0, 1.5, 0.0]).unwrap();
        let distance = first.distance_to(&second).unwrap();
        assert_eq!(distance.heights(), [2.0, 0.0, 2.0, 2.0, 0.5, 2.0]);
        let other = HeightMap::from_fn(Lattice::square(2, 1.0), |x, _| x).unwrap();
        let message = first.plus(&other).unwrap_err().to_string();
        assert!(message.contains("must have the same lattice"), "{message}");
    }
}
