//! The passage of the material through a cell: path lengths, slip, and frictional heat, which is
//! released uniformly along the path; Eqs. (17), (18).

use crate::bodies::Kinematics;
use crate::normal::patch::{Cell, Patch, Strip};

/// Path of the material through a cell.
pub(crate) struct Passage {
    /// Position of the cell across rolling, in m.
    pub y: f64,
    /// See [`paths_through`]; in m.
    pub paths: [f64; 2],
    /// See [`flux_over_heat`]; dimensionless.
    pub flux_over_heat: f64,
}

impl Passage {
    /// The passage through a cell of a strip.
    pub fn of(patch: &Patch, strip: &Strip, k: usize) -> Self {
        let paths = paths_through(patch, strip, k);
        let flux_over_heat = flux_over_heat(patch.grid.spacing_x, paths);
        Self { y: patch.cells[k].y, paths, flux_over_heat }
    }
}

/// The paths of the material in a cell, before and after the cell's point (in m): half of those to
/// its neighbours, and the full path to an edge.
pub(crate) fn paths_through(patch: &Patch, strip: &Strip, k: usize) -> [f64; 2] {
    let path_in = patch.cells[k].path_in.distance;
    let before = if k == strip.cells.start { path_in } else { 0.5 * path_in };
    let after = if k + 1 == strip.cells.end {
        strip.exit.distance
    } else {
        0.5 * patch.cells[k + 1].path_in.distance
    };
    [before, after]
}

/// x and y component of a cell.
#[inline]
pub(crate) fn pair(values: &[f64], k: usize) -> [f64; 2] {
    [values[2 * k], values[2 * k + 1]]
}

/// Rigid slip velocity in a cell, in m/s.
pub(crate) fn rigid_velocity(motion: &Kinematics, cell: &Cell) -> [f64; 2] {
    cell.rigid_slip(motion).map(|slip| motion.speed * slip)
}

/// Slip velocity (in m/s) from the rigid one, the number of cells that the material passes per
/// second, and the change of A p along the path through the cell (in m).
#[inline]
pub(crate) fn slip(rigid: [f64; 2], cells_a_second: f64, change: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|c| rigid[c] - cells_a_second * change[c])
}

/// Slip speed (in m/s) of a slip velocity, in m/s.
#[inline]
pub(crate) fn speed_of([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Friction power over area (in W/m²) of a traction (in Pa) under a slip velocity, in m/s.
#[inline]
pub(crate) fn power(traction: [f64; 2], slip: [f64; 2]) -> f64 {
    traction[0] * slip[0] + traction[1] * slip[1]
}

/// Heat released by a friction power per unit area (in W/m² both): power returned by the bristles
/// of the contact law does not cool.
#[inline]
pub(crate) fn heat(power: f64) -> f64 {
    power.max(0.0)
}

/// Ratio of the heat flux along the path through a cell to the heat released in it, dimensionless:
/// the latter is a mean over a whole cell of the given size along rolling, in m.
pub(crate) fn flux_over_heat(spacing: f64, [before, after]: [f64; 2]) -> f64 {
    spacing / (before + after)
}
