//! The discretised contact: a patch and the compliance of its cells.

use crate::elasticity::{Compliance, PressureCoupling};
use crate::normal::patch::{Interpolation, Patch};
use crate::normal::{Grid, NormalContact, NormalSummary, VectorField};
use crate::numerics::vector::{add_scaled, dot};
use crate::problem::Problem;
use crate::reporting::{Error, Quantity};
use crate::solver::settings;

/// A patch with the compliance between its cells.
pub(crate) struct DiscreteContact {
    pub normal: NormalSummary,
    pub patch: Patch,
    pub compliance: Box<dyn Compliance>,
    /// Displacement of the layer between the surfaces over its traction, in m/Pa.
    pub layer_compliance: f64,
    pub interpolation: Interpolation,
    coupling: Option<PressureCoupling>,
    /// Displacement under the pressure on the whole grid, rail minus wheel like A p, in m; of
    /// unlike bodies.
    pub pressed: Option<VectorField>,
    /// Buffers for the fields of a product.
    workspace: Workspace,
    /// μ0 k_c, in 1/m: times the pressure, the initial stiffness of the contact law.
    bristles: f64,
    /// Infinite for rigid bodies.
    cell_stiffness: f64,
    /// See [`Self::row_compliances`]; without regard to where in the cell its point is.
    row: Row,
}

/// Displacement of the cells at a distance of 0, 1, … columns in a row under a unit traction on one
/// of them, in each direction, in m/Pa.
pub(crate) type Row = [[f64; 2]; 6];

/// Displacement at a distance of some columns (not a whole number of them) in a row, linear between
/// the cells, in m/Pa; nothing beyond the last one.
pub(in crate::solver::rolling) fn at_distance(row: &[[f64; 2]], columns: f64) -> [f64; 2] {
    let near = columns as usize;
    let share = columns - near as f64;
    let of = |n: usize| row.get(n).copied().unwrap_or_default();
    [0, 1].map(|c| (1.0 - share) * of(near)[c] + share * of(near + 1)[c])
}

struct Workspace {
    traction: VectorField,
    /// That of the bodies.
    displacement: VectorField,
    /// The same with that of the layer between the surfaces, if there is one.
    with_layer: Option<VectorField>,
    /// Differences of the displacement along the passage.
    passing: VectorField,
}

/// The result of a product: the displacement A p under a traction p.
pub(crate) struct Displaced<'a> {
    patch: &'a Patch,
    interpolation: &'a Interpolation,
    workspace: &'a mut Workspace,
}

/// A patch replaced by another one on the same grid when the load changed.
#[derive(Debug)]
pub(crate) struct Former {
    pub patch: Patch,
    pub interpolation: Interpolation,
}

impl DiscreteContact {
    /// The normal contact of a problem on a grid that covers it.
    pub fn new(problem: &Problem, normal: &NormalContact, grid: Grid) -> Result<Self, Error> {
        let elasticity = &problem.interface.elasticity;
        if elasticity.assumes_ellipse() {
            normal.refuse_line(Quantity::Elasticity)?;
        }
        let compliance = elasticity.compliance(&grid)?;
        let patch = touching_patch(normal, grid)?;
        let zeros = || VectorField::zeros(grid.len());
        let with_layer = problem.interface.layer.map(|_| zeros());
        let fields = [zeros(), zeros(), zeros()];
        let [traction, displacement, passing] = fields;
        let mut contact = Self {
            interpolation: Interpolation::uncoupled(&patch),
            coupling: problem.interface.elasticity.pressure_coupling(),
            pressed: None,
            normal: normal.summary,
            patch,
            compliance,
            layer_compliance: problem.interface.layer_compliance(),
            workspace: Workspace { traction, displacement, with_layer, passing },
            bristles: bristles(problem),
            cell_stiffness: 0.0,
            row: Row::default(),
        };
        contact.settle();
        Ok(contact)
    }

    /// Sets another normal contact on the same grid; returns the patch that it replaces.
    pub fn set_normal(&mut self, normal: &NormalContact) -> Result<Former, Error> {
        let patch = touching_patch(normal, self.patch.grid)?;
        let patch = std::mem::replace(&mut self.patch, patch);
        let interpolation = self.interpolation.clone();
        self.normal = normal.summary;
        self.settle();
        Ok(Former { patch, interpolation })
    }

    /// Sets other friction and contact laws on the same contact.
    pub fn set_laws(&mut self, problem: &Problem) {
        self.bristles = bristles(problem);
    }

    /// Sets weights and stiffness for a new patch.
    fn settle(&mut self) {
        self.interpolation = Interpolation::uncoupled(&self.patch);
        self.row = self.measure_row();
        let [x, y] = self.row[0];
        self.cell_stiffness = if x + y > 0.0 { 2.0 / (x + y) } else { f64::INFINITY };
        self.interpolate();
        self.pressed = self.coupling.map(|coupling| {
            let mut pressure = vec![0.0; self.patch.grid.len()];
            for cell in &self.patch.cells {
                pressure[cell.index] = cell.pressure;
            }
            coupling.displacement(&self.patch.grid, &pressure)
        });
    }

    /// Displacements under the pressure at the cells, relative to those where their material
    /// entered, in m; of unlike bodies.
    pub fn pressed_since_entry(&self) -> Option<Vec<f64>> {
        let pressed = self.pressed.as_ref()?;
        let mut relative = vec![0.0; 2 * self.patch.len()];
        let mut at_entry = relative.clone();
        self.interpolation.gather(pressed, &mut relative);
        self.interpolation.gather_at_entries(pressed, &mut at_entry);
        add_scaled(&mut relative, -1.0, &at_entry);
        Some(relative)
    }

    /// Adds the displacements under the pressure at the cells, in m.
    pub fn add_pressed(&self, u: &mut [f64]) {
        if let Some(pressed) = &self.pressed {
            let mut at_cells = vec![0.0; u.len()];
            self.interpolation.gather(pressed, &mut at_cells);
            add_scaled(u, 1.0, &at_cells);
        }
    }

    /// Change of the displacement under the pressure while a material point passes each cell, in m;
    /// of unlike bodies.
    pub fn pressed_in_passing(&self) -> Option<Vec<f64>> {
        let pressed = self.pressed.as_ref()?;
        let mut passing = VectorField::zeros(self.patch.grid.len());
        differences(pressed, self.patch.grid.columns, &mut passing);
        let mut change = vec![0.0; 2 * self.patch.len()];
        self.interpolation.gather_means(&passing, &mut change);
        Some(change)
    }

    /// Power (in W) of a traction on the rail (in Pa) with the displacement under the pressure, at
    /// a rolling speed in m/s.
    pub fn pressed_power(&self, traction: &[f64], speed: f64) -> f64 {
        let grid = &self.patch.grid;
        let work = self.pressed_in_passing().map_or(0.0, |change| -dot(traction, &change));
        work * grid.cell_area() * speed / grid.spacing_x
    }

    fn interpolate(&mut self) {
        if self.compliance.couples_cells() {
            self.interpolation = Interpolation::new(&self.patch);
        }
    }

    /// Whether the equations of the grid have solutions.
    ///
    /// # Errors
    /// Too few cells across.
    pub fn require_rows(&self) -> Result<(), Error> {
        match self.fewest_rows() {
            Some(fewest) => Err(Error::TooFewAcross {
                fewest,
                columns: self.patch.grid.columns_within(),
                count: self.patch.grid.rows,
            }),
            None => Ok(()),
        }
    }

    /// Number of rows that they need, if the grid has fewer.
    fn fewest_rows(&self) -> Option<usize> {
        if !self.compliance.couples_cells() {
            return None;
        }
        let grid = &self.patch.grid;
        let cell = grid.spacing_y / grid.spacing_x;
        let ratio = |[columns, rows]: [usize; 2]| cell * columns as f64 / rows as f64;
        // A single row has no edge along rolling.
        let parts = self.patch.sizes_of_parts().into_iter().filter(|[_, rows]| *rows > 1);
        let largest = parts.map(ratio).fold(0.0, f64::max);
        let fewest =
            (grid.rows as f64 * (largest / settings::widest_cells()).sqrt()).ceil() as usize;
        (grid.rows < fewest).then_some(fewest)
    }

    /// Traction of 1 Pa in both directions on the middle cell, and the index of that cell.
    fn lone_cell(&self) -> (Vec<f64>, usize) {
        let strip = &self.patch.strips[self.patch.strips.len() / 2].cells;
        let middle = usize::midpoint(strip.start, strip.end);
        let mut p = vec![0.0; 2 * self.patch.len()];
        (p[2 * middle], p[2 * middle + 1]) = (1.0, 1.0);
        (p, middle)
    }

    /// Displacement of the cells at a distance of 0, 1, … columns in a row under a unit traction in
    /// each direction, in m/Pa.
    pub fn row_compliances(&mut self) -> Row {
        let (_, middle) = self.lone_cell();
        if self.patch.cells[middle].is_covered() { self.row } else { self.measure_row() }
    }

    fn measure_row(&mut self) -> Row {
        let (p, middle) = self.lone_cell();
        let index = self.patch.cells[middle].index;
        let mut u = vec![0.0; p.len()];
        let made = self.product(&p);
        made.at_cells(&mut u);
        let field = made.field();
        let at = |values: &[f64], back: usize| {
            index.checked_sub(back).and_then(|index| values.get(index)).copied().unwrap_or(0.0)
        };
        let mut row = std::array::from_fn(|back| [at(&field.x, back), at(&field.y, back)]);
        row[0] = [u[2 * middle], u[2 * middle + 1]];
        row
    }

    /// A p, with the traction given in each cell.
    pub fn product(&mut self, p: &[f64]) -> Displaced<'_> {
        self.interpolation.spread(p, &mut self.workspace.traction);
        let Workspace { traction, displacement, .. } = &mut self.workspace;
        self.compliance.displacement(traction, displacement);
        self.shear_layer();
        self.displaced()
    }

    /// The part of A p that is the shear of the layer between the surfaces, if there is one.
    pub fn product_of_layer(&mut self, p: &[f64]) -> Option<Displaced<'_>> {
        self.workspace.with_layer.as_ref()?;
        let Workspace { traction, displacement, .. } = &mut self.workspace;
        self.interpolation.spread(p, traction);
        displacement.x.fill(0.0);
        displacement.y.fill(0.0);
        self.shear_layer();
        Some(self.displaced())
    }

    /// Adds the shear of the layer under the present traction to the present displacement.
    fn shear_layer(&mut self) {
        let layer = self.layer_compliance;
        let Workspace { traction, displacement, with_layer, .. } = &mut self.workspace;
        if let Some(with_layer) = with_layer {
            for (both, (u, t)) in [
                (&mut with_layer.x, (&displacement.x, &traction.x)),
                (&mut with_layer.y, (&displacement.y, &traction.y)),
            ] {
                for (both, (u, t)) in both.iter_mut().zip(u.iter().zip(t)) {
                    *both = u + layer * t;
                }
            }
        }
    }

    /// The derivative of A p with respect to the logarithm of the patch size, if the elasticity
    /// knows it.
    pub fn product_by_size(&mut self, p: &[f64]) -> Option<Displaced<'_>> {
        let Workspace { traction, displacement, with_layer, .. } = &mut self.workspace;
        self.interpolation.spread(p, traction);
        let is_known = self.compliance.displacement_by_size(traction, displacement);
        if let Some(with_layer) = with_layer {
            // The shear of the layer does not depend on the size of the patch.
            with_layer.clone_from(displacement);
        }
        is_known.then(|| self.displaced())
    }

    fn displaced(&mut self) -> Displaced<'_> {
        Displaced {
            patch: &self.patch,
            interpolation: &self.interpolation,
            workspace: &mut self.workspace,
        }
    }

    /// Ratio of the displacement at the outer edge of the modelled surface to the largest one,
    /// dimensionless.
    pub fn edge_displacement(&mut self, p: &[f64]) -> f64 {
        self.interpolation.spread(p, &mut self.workspace.traction);
        self.compliance.edge_displacement(&self.workspace.traction)
    }

    /// Displacement of bristles under p = pₙ, 1/(μ0 k_c), in m; zero without any.
    pub fn bristle_deflection(&self) -> f64 {
        self.bristles.recip()
    }

    /// Ratio of traction to displacement of the middle cell under its own traction, in Pa/m. For
    /// rigid bodies it is so large that only the bristles are compliant.
    pub fn cell_stiffness(&self) -> f64 {
        if self.cell_stiffness.is_finite() { self.cell_stiffness } else { self.like_rigid() }
    }

    fn like_rigid(&self) -> f64 {
        settings::rigidity() * self.bristles * self.normal.peak_pressure
    }

    /// Largest displacement where all of the patch has a traction of one, in m/Pa: about the most
    /// that tractions of at most one cause.
    pub fn patch_compliance(&mut self) -> f64 {
        let in_direction = |direction: [f64; 2]| {
            let traction = direction.repeat(self.patch.len());
            let made = self.product(&traction);
            let VectorField { x, y, .. } = made.field();
            x.iter().chain(y).fold(0.0_f64, |most, u| most.max(u.abs()))
        };
        [[1.0, 0.0], [0.0, 1.0]].map(in_direction).into_iter().fold(0.0, f64::max)
    }

    /// Ratio of displacement to traction of that cell, in m/Pa; zero for rigid bodies.
    pub fn cell_compliance(&self) -> f64 {
        self.cell_stiffness.recip()
    }
}

impl Displaced<'_> {
    /// On the whole grid, in m.
    pub fn field(&self) -> &VectorField {
        self.workspace.with_layer.as_ref().unwrap_or(&self.workspace.displacement)
    }

    /// The same of the bodies alone, without the shear of a layer between the surfaces.
    pub fn field_of_bodies(&self) -> &VectorField {
        &self.workspace.displacement
    }

    /// At the cells' points, in m.
    pub fn at_cells(&self, u: &mut [f64]) {
        self.interpolation.gather(self.field(), u);
    }

    /// Where the material of each cell entered, in m. The layer enters unsheared.
    pub fn at_entries(&self, u: &mut [f64]) {
        self.interpolation.gather_at_entries(&self.workspace.displacement, u);
    }

    /// Elastic energy ½ Σ p·(A p) ΔA, in J.
    pub fn stored_energy(&self) -> f64 {
        let (p, u) = (&self.workspace.traction, self.field());
        0.5 * (dot(&p.x, &u.x) + dot(&p.y, &u.y)) * self.patch.grid.cell_area()
    }

    /// Change of the displacement while a material point passes a cell: the difference of the
    /// neighbouring values over two cells.
    ///
    /// A symmetric, translation-invariant compliance does no net work on such changes, Σ p·change =
    /// 0 exactly: elasticity is conservative.
    pub fn change_in_passing(&mut self, change: &mut [f64]) {
        let Workspace { displacement, with_layer, passing, .. } = &mut *self.workspace;
        differences(with_layer.as_ref().unwrap_or(displacement), self.patch.grid.columns, passing);
        self.interpolation.gather_means(passing, change);
    }
}

/// Half the difference of the neighbouring values along rolling, downstream minus upstream; the
/// border keeps its values.
pub(crate) fn differences(from: &VectorField, columns: usize, to: &mut VectorField) {
    for (from, to) in [(&from.x, &mut to.x), (&from.y, &mut to.y)] {
        for (from, to) in from.chunks_exact(columns).zip(to.chunks_exact_mut(columns)) {
            for i in 1..columns - 1 {
                to[i] = 0.5 * (from[i - 1] - from[i + 1]);
            }
        }
    }
}

/// The patch, which must contain at least one cell of the grid.
fn touching_patch(normal: &NormalContact, grid: Grid) -> Result<Patch, Error> {
    let patch = Patch::new(normal, grid);
    let load = patch.load();
    if !patch.is_empty() && load > 0.0 && load.is_finite() {
        return Ok(patch);
    }
    let NormalSummary { load, semi_axis_x, semi_axis_y, .. } = normal.summary;
    Err(Error::NoPressure { load, semi_axes: [semi_axis_x, semi_axis_y] })
}

/// Cold coefficient of friction times the initial slope of the contact law, in 1/m; infinite for
/// Coulomb's law.
fn bristles(problem: &Problem) -> f64 {
    problem.interface.friction.cold_coefficient() * problem.interface.contact_law.stiffness()
}
