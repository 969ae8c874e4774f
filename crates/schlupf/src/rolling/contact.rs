//! The discretised contact: a patch and the compliance of its cells.

use crate::elasticity::Compliance;
use crate::error::Error;
use crate::grid::{Grid, VectorField};
use crate::interface::contact_law::Slide;
use crate::normal::{NormalContact, NormalSummary};
use crate::numerics::vector::{dot, norm};
use crate::patch::{Interpolation, Patch};
use crate::problem::Problem;

/// A patch with the compliance between its cells.
pub(super) struct DiscreteContact {
    pub normal: NormalSummary,
    pub patch: Patch,
    pub compliance: Box<dyn Compliance>,
    interpolation: Interpolation,
    traction: VectorField,
    /// A p on the whole grid, of the last product.
    pub displacement: VectorField,
    /// Differences of the displacement in passing.
    passing: VectorField,
    /// μ0 k_c, in 1/m: times the pressure, the stiffness of the contact law at the start.
    bristles: f64,
    /// Infinite between rigid bodies.
    cell_stiffness: f64,
    estimates: Option<Estimates>,
}

/// Which field a material point passes within a time step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Passing {
    AtEnd,
    OnAverage,
}

/// A patch that a changing load has replaced by another one on the same grid.
#[derive(Debug)]
pub(super) struct Former {
    pub patch: Patch,
    interpolation: Interpolation,
}

/// What marching must know of the compliance of the whole patch.
#[derive(Debug, Clone, Copy)]
struct Estimates {
    stand_in: [f64; 2],
    safe_stiffness: f64,
}

/// Stiffness of the bristles over that of a cell up to which the interpolation is cubic, and from
/// which on it is linear; dimensionless.
const CUBIC_RANGE: [f64; 2] = [250.0, 1250.0];

impl DiscreteContact {
    /// A normal contact of a problem on a grid that spans it.
    pub fn new(problem: &Problem, normal: &NormalContact, grid: Grid) -> Result<Self, Error> {
        let compliance = problem.elasticity.compliance(&grid)?;
        let patch = touching_patch(normal, grid)?;
        let zeros = VectorField::zeros(grid.len());
        let mut contact = Self {
            interpolation: Interpolation::uncoupled(&patch),
            normal: normal.summary,
            patch,
            compliance,
            traction: zeros.clone(),
            passing: zeros.clone(),
            displacement: zeros,
            bristles: bristles(problem),
            cell_stiffness: 0.0,
            estimates: None,
        };
        contact.settle();
        Ok(contact)
    }

    /// Another normal contact on the same grid; returns the patch that it replaces. The displacement
    /// field stays that of the last product: the history of the elements hangs on it.
    pub fn set_normal(&mut self, normal: &NormalContact) -> Result<Former, Error> {
        let patch = touching_patch(normal, self.patch.grid)?;
        let patch = std::mem::replace(&mut self.patch, patch);
        let interpolation = self.interpolation.clone();
        self.normal = normal.summary;
        let displacement = self.displacement.clone();
        self.settle();
        self.displacement = displacement;
        Ok(Former { patch, interpolation })
    }

    /// The same contact with other laws of friction and contact.
    pub fn set_laws(&mut self, problem: &Problem) {
        let bristles = bristles(problem);
        if bristles != self.bristles {
            self.bristles = bristles;
            self.interpolate();
        }
    }

    /// Weights and stiffness of a new patch.
    fn settle(&mut self) {
        self.interpolation = Interpolation::uncoupled(&self.patch);
        self.estimates = None;
        self.cell_stiffness = self.measure_cell_stiffness();
        self.interpolate();
    }

    fn interpolate(&mut self) {
        if self.compliance.couples_cells() {
            self.interpolation = Interpolation::new(&self.patch, self.cubic_share());
        }
    }

    /// How much of the interpolation at the leading edge is cubic.
    ///
    /// Where the bristles of the contact law are so much stiffer than a cell that it sticks as a
    /// whole, the displacement has a kink at the edge, and negative weights would let neighbouring
    /// strips swing against each other. Linear interpolation cannot; it is half as exact on softer
    /// bristles.
    fn cubic_share(&self) -> f64 {
        let stiffness = self.bristles * self.normal.peak_pressure / self.cell_stiffness();
        let [all, none] = CUBIC_RANGE;
        ((none / stiffness).ln() / (none / all).ln()).clamp(0.0, 1.0)
    }

    /// Change of that share with the logarithm of the stiffness of the bristles over a cell's,
    /// dimensionless.
    pub fn cubic_share_by_stiffness(&self) -> f64 {
        let [all, none] = CUBIC_RANGE;
        let share = self.cubic_share();
        if share > 0.0 && share < 1.0 && self.compliance.couples_cells() {
            -(none / all).ln().recip()
        } else {
            0.0
        }
    }

    /// Change of the logarithm of a cell's stiffness with that of the size of the patch,
    /// dimensionless; if the elasticity knows it.
    pub fn cell_stiffness_by_size(&mut self) -> Option<f64> {
        let (p, middle) = self.lone_cell();
        let mut u = vec![0.0; p.len()];
        let is_known = self.product_by_size(&p, &mut u);
        let grown = 0.5 * (u[2 * middle] + u[2 * middle + 1]);
        is_known.then_some(-grown * self.cell_stiffness())
    }

    /// Traction of 1 Pa in both directions on the cell in the middle, and its number.
    fn lone_cell(&self) -> (Vec<f64>, usize) {
        let strip = &self.patch.strips[self.patch.strips.len() / 2].cells;
        let middle = usize::midpoint(strip.start, strip.end);
        let mut p = vec![0.0; 2 * self.patch.len()];
        (p[2 * middle], p[2 * middle + 1]) = (1.0, 1.0);
        (p, middle)
    }

    /// u = A p at the cells' points; the displacement of the whole grid is left in the field.
    pub fn product(&mut self, p: &[f64], u: &mut [f64]) {
        self.interpolation.spread(p, &mut self.traction);
        self.compliance.displacement(&self.traction, &mut self.displacement);
        self.interpolation.gather(&self.displacement, u);
    }

    /// The same for the change of A p with the logarithm of the size of the patch; whether the
    /// elasticity knows it.
    pub fn product_by_size(&mut self, p: &[f64], u: &mut [f64]) -> bool {
        self.interpolation.spread(p, &mut self.traction);
        let is_known = self.compliance.displacement_by_size(&self.traction, &mut self.displacement);
        self.interpolation.gather(&self.displacement, u);
        is_known
    }

    /// Elastic energy ½ Σ p·(A p) ΔA of the last product, in J.
    pub fn stored_energy(&self) -> f64 {
        let (p, u) = (&self.traction, &self.displacement);
        0.5 * (dot(&p.x, &u.x) + dot(&p.y, &u.y)) * self.patch.grid.cell_area()
    }

    /// The displacement field of the last product at the cells' points.
    pub fn displacement_at_cells(&self, u: &mut [f64]) {
        self.interpolation.gather(&self.displacement, u);
    }

    /// The displacement field of the last product where the material of each cell entered.
    pub fn displacement_at_entries(&self, u: &mut [f64]) {
        self.interpolation.gather_at_entries(&self.displacement, u);
    }

    /// What those gain with the share to which the interpolation at the leading edge is cubic.
    pub fn displacement_at_entries_by_share(&self, u: &mut [f64]) {
        self.interpolation.gather_at_entries_by_share(&self.displacement, u);
    }

    /// By how much the displacement of the last product changes while a material point passes a
    /// cell: the difference of its neighbours' values over two cells.
    ///
    /// A symmetric compliance that is the same everywhere does no work on such changes in total,
    /// Σ p·change = 0 exactly: elasticity returns what it takes.
    pub fn change_in_passing(&mut self, change: &mut [f64]) {
        let columns = self.patch.grid.columns;
        differences(&self.displacement.x, columns, &mut self.passing.x);
        differences(&self.displacement.y, columns, &mut self.passing.y);
        self.interpolation.gather_means(&self.passing, change);
    }

    /// By how much A p changes while a material point passes a cell within a time step that began with
    /// the field `before`: what it changes in passing the field at the end of the step, or on the
    /// average of both ends, and what changes in place; in the cells of the patch, or of its former one.
    pub fn change_over_step(
        &mut self,
        before: &VectorField,
        former: Option<&Former>,
        (passing, change): (Passing, &mut [f64]),
    ) {
        let columns = self.patch.grid.columns;
        let interpolation = former.map_or(&self.interpolation, |former| &former.interpolation);
        let (end, start) = match passing {
            Passing::AtEnd => (1.0, 0.0),
            Passing::OnAverage => (0.5, 0.5),
        };
        let passed = combined(&self.displacement, end, before, start);
        let gained = combined(&self.displacement, 1.0, before, -1.0);
        differences(&passed.x, columns, &mut self.passing.x);
        differences(&passed.y, columns, &mut self.passing.y);
        interpolation.gather_means(&self.passing, change);
        let mut in_place = vec![0.0; change.len()];
        interpolation.gather_means(&gained, &mut in_place);
        for (change, in_place) in change.iter_mut().zip(in_place) {
            *change += in_place;
        }
    }

    /// Displacement at the outer edge of the modelled surface over the largest one, dimensionless.
    pub fn edge_displacement(&mut self, p: &[f64]) -> f64 {
        self.interpolation.spread(p, &mut self.traction);
        self.compliance.edge_displacement(&self.traction)
    }

    /// Displacement over traction of the patch as a whole, for each component, in m/Pa.
    pub fn stand_in(&mut self) -> [f64; 2] {
        self.estimates().stand_in
    }

    /// 1/‖A‖ or somewhat less, in Pa/m; of rigid bodies as [`Self::cell_stiffness`].
    pub fn safe_stiffness(&mut self) -> f64 {
        let stiffness = self.estimates().safe_stiffness;
        if stiffness.is_finite() { stiffness } else { self.like_rigid() }
    }

    fn estimates(&mut self) -> Estimates {
        let estimates = self.estimates.unwrap_or_else(|| Estimates {
            stand_in: self.estimate_stand_in(),
            safe_stiffness: self.estimate_safe_stiffness(),
        });
        self.estimates = Some(estimates);
        estimates
    }

    /// Whether displacements fade within the patch.
    pub fn is_short_ranged(&self) -> bool {
        self.compliance.is_short_ranged()
    }

    /// Traction over displacement of a cell in the middle under its own traction, in Pa/m. Between rigid
    /// bodies it is one beside which the bristles give way alone.
    pub fn cell_stiffness(&self) -> f64 {
        if self.cell_stiffness.is_finite() { self.cell_stiffness } else { self.like_rigid() }
    }

    fn like_rigid(&self) -> f64 {
        (RIGID * self.bristles * self.normal.peak_pressure).max(LEAST_RIGID)
    }

    /// Displacement over traction of that cell, in m/Pa; zero between rigid bodies.
    pub fn cell_looseness(&self) -> f64 {
        self.cell_stiffness.recip()
    }

    fn measure_cell_stiffness(&mut self) -> f64 {
        let (p, middle) = self.lone_cell();
        let mut u = vec![0.0; p.len()];
        self.product(&p, &mut u);
        let own = 0.5 * (u[2 * middle] + u[2 * middle + 1]);
        if own > 0.0 { own.recip() } else { f64::INFINITY }
    }

    /// Under tractions like the pressure.
    fn estimate_stand_in(&mut self) -> [f64; 2] {
        let p: Vec<f64> = self.patch.cells.iter().flat_map(|c| [c.pressure; 2]).collect();
        let mut u = vec![0.0; p.len()];
        self.product(&p, &mut u);
        [0, 1].map(|c| {
            let of = |v: &[f64], w: &[f64]| -> f64 {
                v.iter().zip(w).skip(c).step_by(2).map(|(v, w)| v * w).sum()
            };
            of(&p, &u) / of(&p, &p)
        })
    }

    /// By power iteration.
    fn estimate_safe_stiffness(&mut self) -> f64 {
        let mut v: Vec<f64> = self.patch.cells.iter().flat_map(|c| [c.pressure; 2]).collect();
        let mut u = v.clone();
        let mut largest = 0.0;
        for _ in 0..POWER_ITERATIONS {
            let length = norm(&v);
            for v in &mut v {
                *v /= length;
            }
            self.product(&v, &mut u);
            largest = norm(&u);
            if largest == 0.0 {
                return f64::INFINITY;
            }
            std::mem::swap(&mut v, &mut u);
        }
        (SAFETY * largest).recip()
    }
}

/// Half the difference of the neighbours' values along rolling, downstream less upstream; the border
/// keeps its values.
fn differences(from: &[f64], columns: usize, to: &mut [f64]) {
    for (from, to) in from.chunks_exact(columns).zip(to.chunks_exact_mut(columns)) {
        for i in 1..columns - 1 {
            to[i] = 0.5 * (from[i - 1] - from[i + 1]);
        }
    }
}

/// A sum of multiples of two fields.
fn combined(one: &VectorField, share: f64, other: &VectorField, rest: f64) -> VectorField {
    let sum = |(p, q): (&f64, &f64)| share * p + rest * q;
    VectorField {
        x: one.x.iter().zip(&other.x).map(sum).collect(),
        y: one.y.iter().zip(&other.y).map(sum).collect(),
    }
}

const POWER_ITERATIONS: usize = 10;

/// The power iteration comes from below.
const SAFETY: f64 = 1.1;

/// Stiffness of rigid bodies over that of the bristles at the start, dimensionless: what they leave of
/// the rigid slip is then an explicit recursion down the strips, to the tolerance of a Newton step.
const RIGID: f64 = 1e8;

/// The same in Pa/m, where there are no bristles: that of steel in a patch of some millimetres.
const LEAST_RIGID: f64 = 1e13;

/// The patch, which must touch the grid somewhere.
fn touching_patch(normal: &NormalContact, grid: Grid) -> Result<Patch, Error> {
    let patch = Patch::new(normal, grid);
    let load = patch.load();
    if !patch.is_empty() && load > 0.0 && load.is_finite() {
        return Ok(patch);
    }
    let NormalSummary { load, semi_axis_x, semi_axis_y, .. } = normal.summary;
    Err(Error::NoPressure { load, semi_axes: [semi_axis_x, semi_axis_y] })
}

/// Cold coefficient of friction times the slope of the contact law at rest, in 1/m.
fn bristles(problem: &Problem) -> f64 {
    let slope = problem.contact_law.respond(&Slide::default()).by_increment[0][0];
    problem.friction.cold_coefficient() * slope
}
