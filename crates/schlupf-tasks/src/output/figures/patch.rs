//! The contact patch as used by the figures.

use schlupf::solution::{Fields, Solution};

/// A solution with the patch data needed by all figures.
#[derive(Debug)]
pub(crate) struct Patch<'a> {
    /// The solution.
    pub solution: &'a Solution,
    /// Title of the case.
    pub title: &'a str,
    /// Whether the pressure is Hertz's semi-ellipsoid; if so, the rim of the patch is known exactly
    /// and the figures end there.
    pub elliptic: bool,
    /// Cold coefficient of friction μ0, dimensionless; one if unknown.
    pub cold_friction: f64,
    /// Contact cell at each position of the grid.
    cell_at: Vec<Option<usize>>,
}

impl<'a> Patch<'a> {
    /// The patch of a solution; `None` if it has no cells or no size.
    pub(crate) fn new(title: &'a str, solution: &'a Solution) -> Option<Self> {
        let fields = &solution.fields;
        let grid = &fields.grid;
        let normal = &solution.normal;
        let sizes = [grid.spacing_x, grid.spacing_y, normal.semi_axis_x, normal.semi_axis_y];
        let sized = sizes.iter().all(|size| size.is_finite() && *size > 0.0)
            && grid.origin_x.is_finite()
            && grid.origin_y.is_finite();
        if fields.is_empty() || !sized {
            return None;
        }
        let mut cell_at = vec![None; grid.len()];
        for (cell, &[column, row]) in fields.cell.iter().enumerate() {
            *cell_at.get_mut(grid.index(column, row))? = Some(cell);
        }
        Some(Self {
            solution,
            title,
            elliptic: is_elliptic(solution),
            cold_friction: cold_friction(solution),
            cell_at,
        })
    }

    /// The fields.
    pub(crate) fn fields(&self) -> &'a Fields {
        &self.solution.fields
    }

    /// The bulk temperatures of wheel and rail, in degC, if they are known to differ.
    pub(crate) fn different_bulks(&self) -> Option<[f64; 2]> {
        /// Difference that counts as none, in K.
        const NONE: f64 = 1e-6;
        let temperature = self.solution.temperature?;
        let wheel = temperature.max_wheel - temperature.max_rise_wheel;
        let rail = temperature.max_rail - temperature.max_rise_rail;
        ((wheel - rail).abs() > NONE).then_some([wheel, rail])
    }

    /// Of wheel and rail in every contact cell: temperatures in degC if the bulk temperatures
    /// differ, otherwise rises in K.
    pub(crate) fn surface_temperatures(&self) -> [Vec<f64>; 2] {
        let fields = self.fields();
        let [wheel, rail] = self.different_bulks().unwrap_or_default();
        let above = |field: &[f64], bulk: f64| field.iter().map(|rise| bulk + rise).collect();
        [above(&fields.temperature_rise_wheel, wheel), above(&fields.temperature_rise_rail, rail)]
    }

    /// Whether the wheel rolls: it does not while it is shifted at rest.
    pub(crate) fn is_rolling(&self) -> bool {
        self.solution.kinematics.speed != 0.0
    }

    /// Semi-axes a and b, in m.
    pub(crate) fn semi_axes(&self) -> [f64; 2] {
        self.solution.normal.semi_axes()
    }

    /// The contact cell in a column and row of the grid.
    pub(crate) fn cell(&self, column: usize, row: usize) -> Option<usize> {
        let grid = &self.fields().grid;
        if column >= grid.columns || row >= grid.rows {
            return None;
        }
        self.cell_at[grid.index(column, row)]
    }

    /// Values averaged with those of the eight cells around, so that a surface has no teeth where
    /// the stick–slip boundary crosses the rows of cells. What vanishes at the rim is averaged as
    /// its ratio to the pressure.
    pub(crate) fn smoothed(&self, values: &[f64], vanishes_at_rim: bool) -> Vec<f64> {
        let Fields { cell, pressure, covered, .. } = self.fields();
        let scale = |at: usize| if vanishes_at_rim { pressure[at] } else { 1.0 };
        let mean = |at: usize| {
            let [column, row] = cell[at];
            let (mut sum, mut weights) = (0.0, 0.0);
            for (i, along) in [1.0, 2.0, 1.0].into_iter().enumerate() {
                for (j, across) in [1.0, 2.0, 1.0].into_iter().enumerate() {
                    let near = (column + i).checked_sub(1).zip((row + j).checked_sub(1));
                    let near = near.and_then(|(column, row)| self.cell(column, row));
                    let Some(near) = near.filter(|near| scale(*near) > 0.0) else { continue };
                    let weight = along * across * covered[near];
                    sum += weight * values[near] / scale(near);
                    weights += weight;
                }
            }
            if weights > 0.0 && scale(at) > 0.0 { scale(at) * sum / weights } else { values[at] }
        };
        (0..values.len()).map(mean).collect()
    }

    /// Whether a point (in m) is in contact; where the rim is not known exactly, whether half of
    /// its cell is.
    pub(crate) fn contains(&self, [x, y]: [f64; 2]) -> bool {
        if self.elliptic {
            let [a, b] = self.semi_axes();
            return Self::ellipsoid([x / a, y / b]) > 0.0;
        }
        let grid = &self.fields().grid;
        let column = (x - grid.origin_x) / grid.spacing_x;
        let row = (y - grid.origin_y) / grid.spacing_y;
        let is_covered = |cell: usize| self.fields().covered[cell] >= 0.5;
        column >= 0.0
            && row >= 0.0
            && self.cell(column as usize, row as usize).is_some_and(is_covered)
    }

    /// √(1 − x²/a² − y²/b²), the shape of the Hertzian pressure; zero outside. Dimensionless; the
    /// position is normalised by a and b.
    pub(crate) fn ellipsoid(position: [f64; 2]) -> f64 {
        let [x, y] = position;
        (1.0 - x * x - y * y).max(0.0).sqrt()
    }
}

/// The cold coefficient of friction, by which the solver normalised the force; from the field if
/// there is no force.
fn cold_friction(solution: &Solution) -> f64 {
    let force = solution.force.x.hypot(solution.force.y);
    let normalised = solution.normalised.x.hypot(solution.normalised.y);
    let friction = force / (normalised * solution.normal.load);
    if friction.is_finite() && friction > 0.0 {
        return friction;
    }
    let field = &solution.fields.friction_coefficient;
    let largest = field.iter().copied().filter(|mu| mu.is_finite()).fold(0.0, f64::max);
    if largest > 0.0 { largest } else { 1.0 }
}

/// Whether the cells cover the ellipse, and those inside it carry Hertz's pressure. The tolerance
/// allows for the difference between the mean over a cell and the value at its centre.
fn is_elliptic(solution: &Solution) -> bool {
    let Solution { fields, normal, .. } = solution;
    let covered: f64 = fields.covered.iter().sum::<f64>() * fields.grid.cell_area();
    let ellipse = std::f64::consts::PI * normal.semi_axis_x * normal.semi_axis_y;
    let same_area = (covered / ellipse - 1.0).abs() < 0.02;
    let hertzian = (0..fields.len()).filter(|&cell| fields.covered[cell] > 0.999).all(|cell| {
        let position = [fields.x[cell] / normal.semi_axis_x, fields.y[cell] / normal.semi_axis_y];
        let pressure = fields.pressure[cell] / normal.peak_pressure;
        (pressure - Patch::ellipsoid(position)).abs() < 0.1
    });
    same_area && hertzian
}
