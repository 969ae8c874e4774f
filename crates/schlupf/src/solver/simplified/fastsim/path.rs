//! Paths of the material from one cell to the next.

use wide::f64x4;

use crate::bodies::{Kinematics, StripSlip};
use crate::normal::patch::{Cell, Patch, Travel};
use crate::numerics::lanes::{FOUR, Lanes};

/// A path of the material, and what its strip adds to the motion of the plane: see [`Travel`] and
/// [`StripSlip`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Path<T> {
    /// In m, and its inverse.
    pub distance: T,
    pub per_distance: T,
    /// In m².
    pub moment_x: T,
    /// In m².
    pub moment_y: T,
    /// Dimensionless.
    creepages: [T; 2],
    /// In 1/m.
    by_y: [T; 2],
    /// In 1/m.
    pub spin: T,
}

impl Path<f64> {
    /// A path in a strip.
    pub fn of(way: &Travel, row: &StripSlip) -> Self {
        let Travel { distance, moment_x, moment_y } = *way;
        let StripSlip { creepages, by_y, spin } = *row;
        let per_distance = distance.recip();
        Self { distance, per_distance, moment_x, moment_y, creepages, by_y, spin }
    }

    /// The path into a cell.
    pub fn into_cell(cell: &Cell) -> Self {
        Self::of(&cell.path_in, &cell.row)
    }
}

impl Path<f64x4> {
    /// The paths into four cells; standing still where there is none.
    pub fn into_cells(patch: &Patch, cells: [Option<usize>; FOUR]) -> Self {
        let still =
            Path { per_distance: 0.0, ..Path::of(&Travel::default(), &StripSlip::default()) };
        let paths = cells.map(|k| k.map_or(still, |k| Path::into_cell(&patch.cells[k])));
        let lanes = |part: fn(&Path<f64>) -> f64| f64x4::from(paths.map(|path| part(&path)));
        Self {
            distance: lanes(|path| path.distance),
            per_distance: lanes(|path| path.per_distance),
            moment_x: lanes(|path| path.moment_x),
            moment_y: lanes(|path| path.moment_y),
            creepages: [lanes(|path| path.creepages[0]), lanes(|path| path.creepages[1])],
            by_y: [lanes(|path| path.by_y[0]), lanes(|path| path.by_y[1])],
            spin: lanes(|path| path.spin),
        }
    }
}

impl<T: Lanes> Path<T> {
    /// What the strip adds to the rigid slip distance with the spin of the plane, in m.
    #[inline]
    pub fn of_row(&self) -> [T; 2] {
        [0, 1].map(|c| self.creepages[c] * self.distance + self.by_y[c] * self.moment_y)
    }

    /// Rigid slip distance, in m.
    #[inline]
    pub fn rigid_slip(&self, motion: &Kinematics) -> [T; 2] {
        let [along, across] = self.of_row();
        let spin = T::from(motion.spin);
        [
            T::from(motion.creepage_x) * self.distance - spin * self.moment_y + along,
            T::from(motion.creepage_y) * self.distance
                + (spin + self.spin) * self.moment_x
                + across,
        ]
    }
}
