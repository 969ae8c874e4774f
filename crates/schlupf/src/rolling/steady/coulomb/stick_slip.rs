//! Stick and slip along the strips of a patch.
//!
//! With γ the stiffness of a cell and s = D − b the sliding at a cell over the way into it, the law
//! is one equation, p = P(p + γ s), where P reduces what exceeds μ pₙ to it: in stick s = 0, in slip
//! p = μ pₙ along s. Its derivative is that of stick or of slip (semismooth Newton: Alart and Curnier
//! 1991; Hüeber, Stadler and Wohlmuth 2008).

use crate::error::Error;
use crate::normal::NormalContact;
use crate::patch::{Cell, Patch};
use crate::problem::Problem;
use crate::rolling::shared::cell::{inverse_2x2, times};
use crate::rolling::shared::contact::DiscreteContact;
use crate::rolling::shared::passage::pair;
use crate::rolling::steady::steady_friction::SteadyFriction;
use crate::rolling::steady::strip_law::{Cause, Changed, StripLaw};
use crate::state::Element;

use super::calibration::{Calibration, Missing};
use super::slip_stencil::SlipStencil;
use super::slivers::Slivers;

/// Coulomb's law along the strips of a patch, and its tangent at the last residual.
pub(in crate::rolling::steady) struct StickSlip {
    gamma: f64,
    /// μ pₙ of each cell, in Pa.
    bound: Vec<f64>,
    slivers: Slivers,
    stencils: Vec<SlipStencil>,
    /// Whether a cell is the first of its strip.
    is_first: Vec<bool>,
    calibration: Calibration,
    /// What replaces B in the preconditioner, before the slip is taken, in m/Pa.
    local: Vec<Matrix>,
    /// Rigid sliding over the way into each cell, in m.
    rigid: Vec<f64>,
    tangents: Vec<Tangent>,
    /// Displacements (in m) and changes of the heat flux (in W/m²) during a pass of the
    /// preconditioner down the strips.
    displaced: Vec<f64>,
    flux_changes: Vec<f64>,
}

type Matrix = [[f64; 2]; 2];

/// What a cell does at the last residual.
#[derive(Clone, Copy, Default)]
struct Tangent {
    /// ∂P/∂q, dimensionless.
    by_pull: Matrix,
    /// ∂P/∂(μ pₙ), the direction of sliding; zero in stick.
    by_bound: [f64; 2],
    /// Inverse of the local Jacobian of the cell.
    inverse: Matrix,
}

/// Largest part of the cell's own compliance by which a calibration reduces it in the
/// preconditioner, dimensionless.
const MOST_REDUCED: f64 = 0.3;

impl StickSlip {
    /// The strips of a patch; [`StripLaw::set_problem`] sets motion and friction.
    ///
    /// # Errors
    /// Rigid bodies, for which nothing determines the traction where they stick.
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        contact: &mut DiscreteContact,
    ) -> Result<Self, Error> {
        let own = contact.cell_compliances();
        if own[0] <= 0.0 || own[1] <= 0.0 {
            return Err(Error::CoulombOfRigidBodies {});
        }
        let missing = Missing::new(problem, normal, contact)?;
        let patch = &contact.patch;
        let smaller: Vec<f64> = missing.at_cells.iter().map(|u| u[0].min(u[1])).collect();
        let slivers = Slivers::new(patch, &smaller, 0.5 * (own[0] + own[1]));
        let calibration = Calibration::new(&missing, patch, &slivers.kept);
        let local = calibration.at_cells.iter().map(|[xx, yy, xy]| {
            let along = |own: f64, missing: f64| own + missing.max(-MOST_REDUCED * own);
            [[along(own[0], *xx), *xy], [*xy, along(own[1], *yy)]]
        });
        let cells = patch.len();
        let mut is_first = vec![false; cells];
        for strip in &patch.strips {
            is_first[strip.cells.start] = true;
        }
        Ok(Self {
            gamma: 0.0,
            bound: vec![0.0; cells],
            stencils: SlipStencil::of(patch, &slivers.kept),
            is_first,
            local: local.collect(),
            rigid: vec![0.0; 2 * cells],
            tangents: vec![Tangent::default(); cells],
            displaced: vec![0.0; 2 * cells],
            flux_changes: vec![0.0; cells],
            slivers,
            calibration,
        })
    }

    /// The cells with equations of their own.
    fn kept(&self) -> impl Iterator<Item = usize> {
        self.slivers.kept.iter().flat_map(Clone::clone)
    }

    /// Sliding at a cell over the way into it, in m.
    fn sliding(&self, b: &[f64], k: usize) -> [f64; 2] {
        [0, 1].map(|c| self.rigid[2 * k + c] - b[2 * k + c])
    }

    /// q = p + γ s, in Pa.
    fn pull(&self, p: &[f64], b: &[f64], k: usize) -> [f64; 2] {
        let sliding = self.sliding(b, k);
        [0, 1].map(|c| p[2 * k + c] + self.gamma * sliding[c])
    }

    /// P(q), in Pa.
    fn reduced(&self, q: [f64; 2], k: usize) -> [f64; 2] {
        let length = q[0].hypot(q[1]);
        if length > self.bound[k] { q.map(|q| q * (self.bound[k] / length)) } else { q }
    }

    fn tangent_of(&self, q: [f64; 2], k: usize) -> Tangent {
        let (length, bound) = (q[0].hypot(q[1]), self.bound[k]);
        let (by_pull, by_bound) = if length > bound {
            let n = q.map(|q| q / length);
            let across = bound / length;
            let mixed = -across * n[0] * n[1];
            let by_pull = [[across * n[1] * n[1], mixed], [mixed, across * n[0] * n[0]]];
            (by_pull, n)
        } else {
            ([[1.0, 0.0], [0.0, 1.0]], [0.0; 2])
        };
        let weight = self.gamma * self.stencils[k].weight[0];
        let [[xx, xy], [yx, yy]] = product_2x2(&by_pull, &self.local[k]);
        let jacobian = [
            [1.0 - by_pull[0][0] + weight * xx, weight * xy - by_pull[0][1]],
            [weight * yx - by_pull[1][0], 1.0 - by_pull[1][1] + weight * yy],
        ];
        Tangent { by_pull, by_bound, inverse: inverse_2x2(jacobian) }
    }

    /// Sliding at a cell due to the displacements of the cells that the preconditioner has passed;
    /// its own is still zero. In m.
    fn slid_upstream(&self, k: usize) -> [f64; 2] {
        self.stencils[k].apply(k, &self.displaced)
    }
}

impl StripLaw for StickSlip {
    fn set_problem(&mut self, problem: &Problem, patch: &Patch, gamma: f64) {
        self.gamma = gamma;
        let since_entry =
            patch.cells.iter().flat_map(|cell| cell.since_entry.rigid_slip(&problem.kinematics));
        let since_entry: Vec<f64> = since_entry.collect();
        self.rigid = self.slid(&since_entry);
    }

    fn bound(&self) -> &[f64] {
        &self.bound
    }

    fn set_bound(&mut self, cells: &[Cell], coefficient: &[f64]) {
        for (bound, (cell, coefficient)) in self.bound.iter_mut().zip(cells.iter().zip(coefficient))
        {
            *bound = coefficient * cell.pressure;
        }
        self.slivers.complete_scalar(&mut self.bound);
    }

    fn relate(&self, p: &[f64], b: &mut [f64]) {
        self.calibration.add(p, b);
        let slid = self.slid(b);
        b.copy_from_slice(&slid);
    }

    /// The direction of the rigid slip.
    fn rigid_saturation(&self) -> Vec<[f64; 2]> {
        let direction = |k: usize| {
            let s = pair(&self.rigid, k);
            let length = s[0].hypot(s[1]);
            if length > 0.0 { s.map(|s| s / length) } else { s }
        };
        (0..self.len()).map(direction).collect()
    }

    fn defect(&self, p: &[f64], b: &[f64]) -> f64 {
        let square = |k: usize| {
            let reduced = self.reduced(self.pull(p, b, k), k);
            (p[2 * k] - reduced[0]).powi(2) + (p[2 * k + 1] - reduced[1]).powi(2)
        };
        self.kept().map(square).sum::<f64>().sqrt()
    }

    fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]) {
        residual.fill(0.0);
        for strip in 0..self.slivers.kept.len() {
            for k in self.slivers.kept[strip].clone() {
                let q = self.pull(p, b, k);
                let reduced = self.reduced(q, k);
                self.tangents[k] = self.tangent_of(q, k);
                for c in 0..2 {
                    residual[2 * k + c] = p[2 * k + c] - reduced[c];
                }
            }
        }
    }

    fn tangent(&self, change: &Changed, cause: Option<&Cause>, product: &mut [f64]) {
        let rigid = cause.map(|cause| self.slid(&self.since_entry(&cause.rigid)));
        product.fill(0.0);
        for k in self.kept() {
            let pulled = [0, 1].map(|c| {
                let slid = rigid.as_ref().map_or(0.0, |rigid| rigid[2 * k + c]);
                change.traction[2 * k + c] + self.gamma * (slid - change.response[2 * k + c])
            });
            let Tangent { by_pull, by_bound, .. } = &self.tangents[k];
            let moved = times(by_pull, pulled);
            let raised = change.bound.map_or(0.0, |bound| bound[k]);
            for c in 0..2 {
                product[2 * k + c] = change.traction[2 * k + c] - moved[c] - raised * by_bound[c];
            }
        }
    }

    fn precondition(&mut self, v: &mut [f64], friction: Option<&SteadyFriction>) {
        self.displaced.fill(0.0);
        self.flux_changes.fill(0.0);
        for strip in 0..self.slivers.kept.len() {
            for k in self.slivers.kept[strip].clone() {
                let slid = times(&self.tangents[k].by_pull, self.slid_upstream(k));
                let rest = [0, 1].map(|c| v[2 * k + c] - self.gamma * slid[c]);
                let Tangent { inverse, by_bound, .. } = &self.tangents[k];
                let mut traction = times(inverse, rest);
                if let Some(friction) = friction {
                    let by_bound = times(inverse, *by_bound);
                    let raised = friction.raised_bound(k, &self.flux_changes, traction, by_bound);
                    traction = [0, 1].map(|c| traction[c] + raised * by_bound[c]);
                    self.flux_changes[k] = friction.flux_change(k, traction);
                }
                let displaced = times(&self.local[k], traction);
                self.displaced[2 * k..2 * k + 2].copy_from_slice(&displaced);
                v[2 * k..2 * k + 2].copy_from_slice(&traction);
            }
        }
        self.slivers.complete(v);
    }

    fn elements(&self, patch: &Patch, p: &[f64], b: &[f64]) -> Vec<Element> {
        let mut elements = Vec::with_capacity(self.len());
        for strip in &patch.strips {
            let mut sliding = [0.0; 2];
            for k in strip.cells.clone() {
                let cell = &patch.cells[k];
                let slid = self.sliding(b, k);
                sliding = [0, 1].map(|c| sliding[c] + slid[c]);
                let over = if self.bound[k] > 0.0 { self.bound[k].recip() } else { 0.0 };
                elements.push(Element {
                    index: cell.index,
                    traction: pair(p, k),
                    saturation: pair(p, k).map(|p| over * p),
                    sliding,
                    stretch: pair(b, k).map(|b| -b / cell.path_in.distance),
                    ..Element::default()
                });
            }
        }
        elements
    }

    fn complete(&self, p: &mut [f64]) {
        self.slivers.complete(p);
    }

    /// Exactly zero where a cell sticks: the friction power, from mean slips over the cells, is
    /// not.
    fn take_slip(&self, b: &[f64], speed: f64, slip: &mut [[f64; 2]]) {
        for k in self.kept() {
            let per_way = speed / self.stencils[k].way;
            let is_sliding = self.tangents[k].by_bound != [0.0; 2];
            let sliding = if is_sliding { self.sliding(b, k) } else { [0.0; 2] };
            slip[k] = sliding.map(|s| per_way * s);
        }
        self.slivers.copy(slip);
    }

    fn complete_friction(&self, coefficient: &mut [f64]) {
        self.slivers.copy(coefficient);
    }
}

impl StickSlip {
    /// The sliding at the cells from what they have slid since entry, in m.
    fn slid(&self, since_entry: &[f64]) -> Vec<f64> {
        let stencils = self.stencils.iter().enumerate();
        stencils.flat_map(|(k, stencil)| stencil.apply(k, since_entry)).collect()
    }

    /// Sums along the strips of something that happens on the way into each cell.
    fn since_entry(&self, on_the_way: &[f64]) -> Vec<f64> {
        let mut sums = on_the_way.to_vec();
        for k in 1..self.len() {
            if !self.is_first[k] {
                sums[2 * k] += sums[2 * k - 2];
                sums[2 * k + 1] += sums[2 * k - 1];
            }
        }
        sums
    }
}

fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}
