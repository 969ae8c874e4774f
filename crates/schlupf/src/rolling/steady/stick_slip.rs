//! Coulomb's law along the strips of a patch in steady rolling: p = P(p + γ s) for every cell, with
//! s = D − b the sliding at the cell over the way into it; less what stretches the bristles of a
//! law in which they are stiff.

use crate::error::Error;
use crate::normal::NormalContact;
use crate::patch::{Cell, Patch};
use crate::problem::Problem;
use crate::rolling::shared::cell::{inverse_2x2, times};
use crate::rolling::shared::contact::DiscreteContact;
use crate::rolling::shared::coulomb::{
    CoulombContact, Discretisation, SlipStencil, Slope, reduced, saturation, slide,
};
use crate::rolling::shared::passage::pair;
use crate::state::{Element, Places, TrackPoint};

use super::steady_friction::SteadyFriction;
use super::stretching::{Cells, Stretching};
use super::strip_factors::StripFactors;
use super::strip_law::{Cause, Changed, StripLaw};

/// Coulomb's law along the strips of a patch, and its tangent at the last residual.
pub(super) struct StickSlip {
    gamma: f64,
    /// μ pₙ of each cell, in Pa.
    bound: Vec<f64>,
    contact: CoulombContact,
    stencils: Vec<SlipStencil>,
    /// The bristles in series with the slider, if there are any.
    stretching: Option<Stretching>,
    factors: StripFactors,
    /// Whether factors and inverses are those of the last residual.
    is_factorised: bool,
    /// Whether a cell is the first of its strip.
    is_first: Vec<bool>,
    /// Rigid sliding since entry, and over the way into each cell, in m.
    rigid_since_entry: Vec<f64>,
    rigid: Vec<f64>,
    slopes: Vec<Slope>,
    /// Inverse of the local Jacobian of each cell.
    inverses: Vec<Matrix>,
    /// Changes of the heat flux (in W/m²) during a pass of the preconditioner down the strips.
    flux_changes: Vec<f64>,
}

type Matrix = [[f64; 2]; 2];

impl StickSlip {
    /// The strips of a patch; [`StripLaw::set_problem`] sets motion and friction.
    ///
    /// # Errors
    /// Those of [`CoulombContact::new`].
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        discrete: &mut DiscreteContact,
        discretisation: Discretisation,
    ) -> Result<Self, Error> {
        CoulombContact::interpolate(problem, discrete);
        let contact = CoulombContact::new(problem, normal, discrete, discretisation)?;
        let row = discrete.row_compliances();
        let patch = &discrete.patch;
        let ratio = normal.summary.semi_axis_x / normal.summary.semi_axis_y;
        let stencils = SlipStencil::of(patch, &contact.slivers.kept, ratio, discretisation);
        let cells = patch.len();
        let mut is_first = vec![false; cells];
        for strip in &patch.strips {
            is_first[strip.cells.start] = true;
        }
        Ok(Self {
            gamma: 0.0,
            bound: vec![0.0; cells],
            factors: StripFactors::new(patch, &contact, &stencils, &row),
            stencils,
            stretching: None,
            is_factorised: false,
            is_first,
            rigid_since_entry: vec![0.0; 2 * cells],
            rigid: vec![0.0; 2 * cells],
            slopes: vec![Slope::default(); cells],
            inverses: vec![Matrix::default(); cells],
            flux_changes: vec![0.0; cells],
            contact,
        })
    }

    /// Sliding at a cell over the way into it, without what stretches bristles, in m.
    fn sliding(&self, b: &[f64], k: usize) -> [f64; 2] {
        let stretching = self.stretching.as_ref().map_or([0.0; 2], |s| pair(&s.sliding, k));
        [0, 1].map(|c| self.rigid[2 * k + c] - b[2 * k + c] - stretching[c])
    }

    fn cells(&self) -> Cells<'_> {
        Cells { kept: &self.contact.slivers.kept, stencils: &self.stencils }
    }

    /// q = p + γ s, in Pa.
    fn pull(&self, p: &[f64], b: &[f64], k: usize) -> [f64; 2] {
        let sliding = self.sliding(b, k);
        [0, 1].map(|c| p[2 * k + c] + self.gamma * sliding[c])
    }

    fn inverse(&self, k: usize) -> Matrix {
        let weight = self.stencils[k].own();
        let stretching =
            self.stretching.as_ref().map_or_else(Matrix::default, |s| s.block(k, self.cells()));
        let local = &self.contact.local[k];
        let slip = |r: usize, c: usize| self.gamma * (weight * local[r][c] + stretching[r][c]);
        let stiffening = [0, 1].map(|r| [0, 1].map(|c| slip(r, c)));
        inverse_2x2(self.slopes[k].jacobian(&stiffening))
    }

    /// The places of the path of an element to a cell of a strip from which the next slip follows,
    /// the latest first, with the sliding since entry up to each cell, in m. Slivers at the leading
    /// edge are none of them.
    fn track(&self, patch: &Patch, slid: &[f64], p: &[f64], at: (usize, usize)) -> Places {
        let (strip, k) = at;
        let kept = self.contact.slivers.kept[strip].clone();
        let here = patch.cells[k].since_entry.distance;
        let entry = TrackPoint { distance: here, ..TrackPoint::default() };
        let cells = (kept.start..=k).rev().filter(|cell| kept.contains(cell) || *cell == k);
        let cells = cells.map(|j| TrackPoint {
            distance: here - patch.cells[j].since_entry.distance,
            sliding: pair(slid, j),
            saturation: saturation(pair(p, j), self.bound[j]),
        });
        cells.chain([entry]).collect()
    }
}

impl StripLaw for StickSlip {
    fn set_problem(&mut self, problem: &Problem, patch: &Patch, gamma: f64) {
        self.gamma = gamma;
        let since_entry =
            patch.cells.iter().flat_map(|cell| cell.rigid_slip_since_entry(&problem.kinematics));
        self.rigid_since_entry = since_entry.collect();
        self.rigid.copy_from_slice(&self.rigid_since_entry);
        slide(&self.stencils, &mut self.rigid);
        self.stretching = Stretching::of(problem, patch.len());
    }

    fn bound(&self) -> &[f64] {
        &self.bound
    }

    fn set_bound(&mut self, cells: &[Cell], coefficient: &[f64]) {
        for (bound, (cell, coefficient)) in self.bound.iter_mut().zip(cells.iter().zip(coefficient))
        {
            *bound = coefficient * cell.pressure;
        }
        self.contact.slivers.complete_scalar(&mut self.bound);
    }

    fn relate(&self, p: &[f64], b: &mut [f64]) {
        self.contact.calibration.add(p, b);
        slide(&self.stencils, b);
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

    /// With the bristles stretched as at the last residual.
    fn defect(&self, p: &[f64], b: &[f64]) -> f64 {
        let square = |k: usize| {
            let onto = reduced(self.pull(p, b, k), self.bound[k]);
            (p[2 * k] - onto[0]).powi(2) + (p[2 * k + 1] - onto[1]).powi(2)
        };
        self.contact.kept().map(square).sum::<f64>().sqrt()
    }

    fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]) {
        residual.fill(0.0);
        if let Some(stretching) = &mut self.stretching {
            let kept = &self.contact.slivers.kept;
            stretching.evaluate(p, &self.bound, Cells { kept, stencils: &self.stencils });
        }
        for strip in 0..self.contact.slivers.kept.len() {
            for k in self.contact.slivers.kept[strip].clone() {
                let q = self.pull(p, b, k);
                let onto = reduced(q, self.bound[k]);
                self.slopes[k] = Slope::at(q, self.bound[k]);
                for c in 0..2 {
                    residual[2 * k + c] = p[2 * k + c] - onto[c];
                }
            }
        }
        self.is_factorised = false;
    }

    fn tangent(&self, change: &Changed, cause: Option<&Cause>, product: &mut [f64]) {
        product.fill(0.0);
        for cells in &self.contact.slivers.kept {
            let pairs = 2 * cells.start..2 * cells.end;
            let tractions = change.traction[pairs.clone()].chunks_exact(2);
            let responses = change.response[pairs.clone()].chunks_exact(2);
            let products = product[pairs].chunks_exact_mut(2);
            let data = tractions.zip(responses).zip(&self.slopes[cells.clone()]);
            for (product, ((p, u), slope)) in products.zip(data) {
                let moved =
                    times(&slope.by_pull, [p[0] - self.gamma * u[0], p[1] - self.gamma * u[1]]);
                product.copy_from_slice(&[p[0] - moved[0], p[1] - moved[1]]);
            }
        }
        if let Some(bound) = change.bound {
            for k in self.contact.kept() {
                for c in 0..2 {
                    product[2 * k + c] -= bound[k] * self.slopes[k].by_bound[c];
                }
            }
        }
        for slid in self.rigid_change(cause).into_iter().chain(self.less_stretched(change, cause)) {
            for k in self.contact.kept() {
                let moved = times(&self.slopes[k].by_pull, pair(&slid, k));
                for c in 0..2 {
                    product[2 * k + c] -= self.gamma * moved[c];
                }
            }
        }
    }

    /// Strip by strip, and then what friction that depends on the heat from upstream adds in each
    /// cell, without what this does to its neighbours.
    fn precondition(&mut self, v: &mut [f64], friction: Option<&SteadyFriction>) {
        if !self.is_factorised {
            self.factorise(friction.is_some());
        }
        self.factors.solve(&self.contact.slivers.kept, v);
        if let Some(friction) = friction {
            self.flux_changes.fill(0.0);
            for k in self.contact.kept() {
                let by_bound = times(&self.inverses[k], self.slopes[k].by_bound);
                let traction = pair(v, k);
                let raised = friction.raised_bound(k, &self.flux_changes, traction, by_bound);
                let traction = [0, 1].map(|c| traction[c] + raised * by_bound[c]);
                self.flux_changes[k] = friction.flux_change(k, traction);
                v[2 * k..2 * k + 2].copy_from_slice(&traction);
            }
        }
        self.contact.slivers.complete(v);
    }

    fn elements(&self, patch: &Patch, p: &[f64], b: &[f64], relative: &[f64]) -> Vec<Element> {
        let mut displaced = relative.to_vec();
        self.contact.calibration.add(p, &mut displaced);
        let pairs = self.rigid_since_entry.iter().zip(&displaced);
        let slid: Vec<f64> = pairs.map(|(rigid, displaced)| rigid - displaced).collect();
        let mut elements = Vec::with_capacity(self.len());
        for (number, strip) in patch.strips.iter().enumerate() {
            for k in strip.cells.clone() {
                elements.push(Element {
                    index: patch.cells[k].index,
                    traction: pair(p, k),
                    saturation: saturation(pair(p, k), self.bound[k]),
                    sliding: pair(&slid, k),
                    stretch: pair(b, k).map(|b| -b / patch.cells[k].path_in.distance),
                    track: self.track(patch, &slid, p, (number, k)),
                    ..Element::default()
                });
            }
        }
        elements
    }

    fn stick_share(&self) -> f64 {
        1.0
    }

    fn complete(&self, p: &mut [f64]) {
        self.contact.slivers.complete(p);
    }

    /// Exactly zero where a cell sticks without bristles: the friction power, from mean slips over
    /// the cells, is not.
    fn take_slip(&self, b: &[f64], speed: f64, slip: &mut [[f64; 2]]) {
        for k in self.contact.kept() {
            let per_way = speed / self.stencils[k].way;
            let sliding = if self.slopes[k].is_sliding() { self.sliding(b, k) } else { [0.0; 2] };
            let stretching = self.stretching.as_ref().map_or([0.0; 2], |s| pair(&s.sliding, k));
            slip[k] = [0, 1].map(|c| per_way * (sliding[c] + stretching[c]));
        }
        self.contact.slivers.copy(slip);
    }

    fn complete_friction(&self, coefficient: &mut [f64]) {
        self.contact.slivers.copy(coefficient);
    }
}

impl StickSlip {
    /// Puts in place of what belongs to slivers by how much their traction is not that which
    /// follows from the others, in the unit of the traction.
    pub fn depart(&self, p: &[f64], departure: &mut [f64]) {
        self.contact.slivers.depart(p, departure);
    }

    /// Adds the values of the slivers among some given ones.
    pub fn add_to_slivers(&self, values: &[f64], to: &mut [f64]) {
        self.contact.slivers.add(values, to);
    }

    /// Change of the rigid sliding over the way into each cell, in m.
    fn rigid_change(&self, cause: Option<&Cause>) -> Option<Vec<f64>> {
        let mut slid = self.since_entry(&cause?.rigid);
        slide(&self.stencils, &mut slid);
        Some(slid)
    }

    /// Change of the sliding (in m) because the bristles are stretched.
    fn less_stretched(&self, change: &Changed, cause: Option<&Cause>) -> Option<Vec<f64>> {
        let mut slid = self.stretching.as_ref()?.change(change, cause, self.cells());
        for slid in &mut slid {
            *slid = -*slid;
        }
        Some(slid)
    }

    fn factorise(&mut self, is_coupled: bool) {
        let cells = Cells { kept: &self.contact.slivers.kept, stencils: &self.stencils };
        let stretching = self.stretching.as_ref().map(|stretching| (stretching, cells));
        self.factors.factorise(cells.kept, &self.slopes, self.gamma, stretching);
        if is_coupled {
            for k in self.contact.slivers.kept.iter().flat_map(Clone::clone) {
                self.inverses[k] = self.inverse(k);
            }
        }
        self.is_factorised = true;
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
