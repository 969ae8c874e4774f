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
pub(crate) struct DiscreteContact {
    pub normal: NormalSummary,
    pub patch: Patch,
    pub compliance: Box<dyn Compliance>,
    pub interpolation: Interpolation,
    /// Room for the fields of a product, to be overwritten.
    room: Room,
    /// μ0 k_c, in 1/m: times the pressure, the stiffness of the contact law at the start.
    bristles: f64,
    /// Infinite between rigid bodies.
    cell_stiffness: f64,
    estimates: Option<Estimates>,
}

struct Room {
    traction: VectorField,
    displacement: VectorField,
    /// Differences of the displacement in passing.
    passing: VectorField,
}

/// What a product makes: the displacement A p under a traction p.
pub(crate) struct Displaced<'a> {
    patch: &'a Patch,
    interpolation: &'a Interpolation,
    room: &'a mut Room,
}

/// A patch that a changing load has replaced by another one on the same grid.
#[derive(Debug)]
pub(crate) struct Former {
    pub patch: Patch,
    pub interpolation: Interpolation,
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
        let zeros = || VectorField::zeros(grid.len());
        let mut contact = Self {
            interpolation: Interpolation::uncoupled(&patch),
            normal: normal.summary,
            patch,
            compliance,
            room: Room { traction: zeros(), displacement: zeros(), passing: zeros() },
            bristles: bristles(problem),
            cell_stiffness: 0.0,
            estimates: None,
        };
        contact.settle();
        Ok(contact)
    }

    /// Another normal contact on the same grid; returns the patch that it replaces.
    pub fn set_normal(&mut self, normal: &NormalContact) -> Result<Former, Error> {
        let patch = touching_patch(normal, self.patch.grid)?;
        let patch = std::mem::replace(&mut self.patch, patch);
        let interpolation = self.interpolation.clone();
        self.normal = normal.summary;
        self.settle();
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
        let grown = self.product_by_size(&p)?.mean_of_cell(middle, &p);
        Some(-grown * self.cell_stiffness())
    }

    /// Traction of 1 Pa in both directions on the cell in the middle, and its number.
    fn lone_cell(&self) -> (Vec<f64>, usize) {
        let strip = &self.patch.strips[self.patch.strips.len() / 2].cells;
        let middle = usize::midpoint(strip.start, strip.end);
        let mut p = vec![0.0; 2 * self.patch.len()];
        (p[2 * middle], p[2 * middle + 1]) = (1.0, 1.0);
        (p, middle)
    }

    /// A p, the traction being given in each cell.
    pub fn product(&mut self, p: &[f64]) -> Displaced<'_> {
        self.interpolation.spread(p, &mut self.room.traction);
        self.compliance.displacement(&self.room.traction, &mut self.room.displacement);
        self.displaced()
    }

    /// The change of A p with the logarithm of the size of the patch, if the elasticity knows it.
    pub fn product_by_size(&mut self, p: &[f64]) -> Option<Displaced<'_>> {
        let Room { traction, displacement, .. } = &mut self.room;
        self.interpolation.spread(p, traction);
        let is_known = self.compliance.displacement_by_size(traction, displacement);
        is_known.then(|| self.displaced())
    }

    fn displaced(&mut self) -> Displaced<'_> {
        Displaced { patch: &self.patch, interpolation: &self.interpolation, room: &mut self.room }
    }

    /// Displacement at the outer edge of the modelled surface over the largest one, dimensionless.
    pub fn edge_displacement(&mut self, p: &[f64]) -> f64 {
        self.interpolation.spread(p, &mut self.room.traction);
        self.compliance.edge_displacement(&self.room.traction)
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

    /// Traction over displacement of a cell in the middle under its own traction, in Pa/m. Between
    /// rigid bodies it is one beside which the bristles give way alone.
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
        let own = self.product(&p).mean_of_cell(middle, &p);
        if own > 0.0 { own.recip() } else { f64::INFINITY }
    }

    /// Under tractions like the pressure.
    fn estimate_stand_in(&mut self) -> [f64; 2] {
        let p: Vec<f64> = self.patch.cells.iter().flat_map(|c| [c.pressure; 2]).collect();
        let mut u = vec![0.0; p.len()];
        self.product(&p).at_cells(&mut u);
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
            self.product(&v).at_cells(&mut u);
            largest = norm(&u);
            if largest == 0.0 {
                return f64::INFINITY;
            }
            std::mem::swap(&mut v, &mut u);
        }
        (SAFETY * largest).recip()
    }
}

impl Displaced<'_> {
    /// On the whole grid, in m.
    pub fn field(&self) -> &VectorField {
        &self.room.displacement
    }

    /// At the cells' points, in m.
    pub fn at_cells(&self, u: &mut [f64]) {
        self.interpolation.gather(&self.room.displacement, u);
    }

    /// Where the material of each cell entered, in m.
    pub fn at_entries(&self, u: &mut [f64]) {
        self.interpolation.gather_at_entries(&self.room.displacement, u);
    }

    /// What those gain with the share to which the interpolation at the leading edge is cubic.
    pub fn at_entries_by_share(&self, u: &mut [f64]) {
        self.interpolation.gather_at_entries_by_share(&self.room.displacement, u);
    }

    /// Mean of both components in a cell, in m.
    fn mean_of_cell(&self, k: usize, like: &[f64]) -> f64 {
        let mut u = vec![0.0; like.len()];
        self.at_cells(&mut u);
        0.5 * (u[2 * k] + u[2 * k + 1])
    }

    /// Elastic energy ½ Σ p·(A p) ΔA, in J.
    pub fn stored_energy(&self) -> f64 {
        let (p, u) = (&self.room.traction, &self.room.displacement);
        0.5 * (dot(&p.x, &u.x) + dot(&p.y, &u.y)) * self.patch.grid.cell_area()
    }

    /// By how much it changes while a material point passes a cell: the difference of its
    /// neighbours' values over two cells.
    ///
    /// A symmetric compliance that is the same everywhere does no work on such changes in total,
    /// Σ p·change = 0 exactly: elasticity returns what it takes.
    pub fn change_in_passing(&mut self, change: &mut [f64]) {
        let Room { displacement, passing, .. } = &mut *self.room;
        differences(displacement, self.patch.grid.columns, passing);
        self.interpolation.gather_means(passing, change);
    }
}

/// Half the difference of the neighbours' values along rolling, downstream less upstream; the
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

const POWER_ITERATIONS: usize = 10;

/// The power iteration comes from below.
const SAFETY: f64 = 1.1;

/// Stiffness of rigid bodies over that of the bristles at the start, dimensionless: what they leave
/// of the rigid slip is then an explicit recursion down the strips, to the tolerance of a Newton
/// step.
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
