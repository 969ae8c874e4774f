//! What the interface of wheel and rail demands along the strips of a patch in steady rolling.
//!
//! For every cell p = R(p + γ v), see
//! [`Resolvent`](crate::solver::rolling::shared::strip::Resolvent): v is the sliding over the path
//! into the cell, and what the material brings along is what it has done upstream in its strip.

mod material;
mod uncoupled;

use std::ops::Range;

use crate::interface::ContactLaw;
use crate::normal::NormalContact;
use crate::normal::patch::{Cell, Patch};
use crate::numerics::vector::{add_scaled, norm};
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solver::rolling::shared::cell::{inverse_2x2, times};
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::passage::pair;
use crate::solver::rolling::shared::strip::{
    BristleState, Calibrated, Calibration, Displaced, Interface, Matrix, Resolvent, SlipStencil,
    StripContact, StripFactors, Upstream, UpstreamValues, slide,
};

use super::steady_friction::SteadyFriction;

/// The equations F(p) = 0 of the cells, given b = B p: the linear response of the bodies to the
/// traction p on the rail. Vectors have the x and y component of each cell in turn.
pub(super) struct StripLaw {
    law: ContactLaw,
    gamma: f64,
    /// μ pₙ of each cell, in Pa, and its inverse; both zero where there is none.
    bound: Vec<f64>,
    over_bound: Vec<f64>,
    contact: StripContact,
    /// Of the slip, and of what the bristles do.
    stencils: Vec<SlipStencil>,
    factors: StripFactors,
    /// Whether tangents are exact, for derivatives of a solution; see [`BristleState::is_exact`].
    pub is_exact: bool,
    /// Whether factors and inverses are those of the last residual.
    is_factorised: bool,
    /// Whether a cell is the first of its strip.
    is_first: Vec<bool>,
    /// Rigid sliding since entry, and over the path into each cell, in m; with that due to the
    /// pressure.
    rigid_since_entry: Vec<f64>,
    rigid: Vec<f64>,
    /// p/(μ pₙ) at the last residual, dimensionless.
    saturation: Vec<f64>,
    resolvents: Vec<Resolvent>,
    /// Inverse of the local Jacobian of each cell.
    inverses: Vec<Matrix>,
    /// Changes of the heat flux (in W/m²) during a pass of the preconditioner down the strips.
    flux_changes: Vec<f64>,
}

/// Small changes of the arguments of F.
#[derive(Clone, Copy)]
pub(super) struct Changed<'a> {
    /// Of p, in Pa.
    pub traction: &'a [f64],
    /// Of b, in m.
    pub response: &'a [f64],
    /// Of μ pₙ, in Pa, if it changes.
    pub bound: Option<&'a [f64]>,
}

/// Small changes of the data of the law, cell by cell (x then y); in the order of the cells.
#[derive(Debug, Clone, Default)]
pub(super) struct Cause {
    /// Of the rigid slip D along the path into each cell, in m.
    pub rigid: Vec<f64>,
    /// Relative change of k_c, dimensionless.
    pub stiffness: f64,
}

impl StripLaw {
    /// The strips of a patch; [`Self::set_problem`] sets motion and laws.
    ///
    /// # Errors
    /// Those of [`StripContact::new`].
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        discrete: &mut DiscreteContact,
    ) -> Result<Self, Error> {
        let contact = StripContact::new(problem, normal, discrete)?;
        let patch = &discrete.patch;
        let (stencils, factors) = discretised(problem.interface.contact_law, patch, &contact);
        let cells = patch.len();
        let mut is_first = vec![false; cells];
        for strip in &patch.strips {
            is_first[strip.cells.start] = true;
        }
        Ok(Self {
            law: problem.interface.contact_law,
            gamma: 0.0,
            bound: vec![0.0; cells],
            over_bound: vec![0.0; cells],
            factors,
            stencils,
            is_exact: false,
            is_factorised: false,
            is_first,
            rigid_since_entry: vec![0.0; 2 * cells],
            rigid: vec![0.0; 2 * cells],
            saturation: vec![0.0; 2 * cells],
            resolvents: vec![Resolvent::default(); cells],
            inverses: vec![Matrix::default(); cells],
            flux_changes: vec![0.0; cells],
            contact,
        })
    }

    /// Switches to another motion and to the laws, of the same kind, of the contact; returns
    /// whether the linear response is another now.
    pub fn set_problem(&mut self, problem: &Problem, contact: &DiscreteContact) -> bool {
        let patch = &contact.patch;
        self.gamma = contact.cell_stiffness();
        self.law = problem.interface.contact_law;
        let is_other = self.contact.settle(contact);
        if is_other {
            (self.stencils, self.factors) = discretised(self.law, patch, &self.contact);
        }
        let since_entry =
            patch.cells.iter().flat_map(|cell| cell.rigid_slip_since_entry(&problem.kinematics));
        self.rigid_since_entry = since_entry.collect();
        if let Some(pressed) = contact.pressed_since_entry() {
            add_scaled(&mut self.rigid_since_entry, -1.0, &pressed);
        }
        self.rigid.copy_from_slice(&self.rigid_since_entry);
        // What was solved before leaves no trace, not even in the last digit.
        self.resolvents.fill(Resolvent::default());
        slide(&self.stencils, &mut self.rigid);
        is_other
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.bound.len()
    }

    /// The cells of each strip that have equations of their own.
    pub fn kept(&self) -> &[Range<usize>] {
        &self.contact.slaved.kept
    }

    /// ‖μ pₙ‖₂, in Pa.
    pub fn scale(&self) -> f64 {
        norm(&self.bound)
    }

    /// μ pₙ of each cell, in Pa.
    pub fn bound(&self) -> &[f64] {
        &self.bound
    }

    /// Sets μ pₙ from the coefficient of friction (dimensionless) of each cell.
    pub fn set_bound(&mut self, cells: &[Cell], coefficient: &[f64]) {
        for (bound, (cell, coefficient)) in self.bound.iter_mut().zip(cells.iter().zip(coefficient))
        {
            *bound = coefficient * cell.pressure;
        }
        self.contact.slaved.complete_scalar(&mut self.bound);
        for (over, bound) in self.over_bound.iter_mut().zip(&self.bound) {
            *over = if *bound > 0.0 { bound.recip() } else { 0.0 };
        }
    }

    /// Converts displacements at the cells under the traction p, relative to those where their
    /// material entered, into b, in place; both in m.
    pub fn relate(&self, p: &[f64], b: &mut [f64]) {
        self.relate_with(&self.contact.calibration, p, b);
    }

    fn relate_with(&self, calibration: &Calibration, p: &[f64], b: &mut [f64]) {
        calibration.add(p, b);
        slide(&self.stencils, b);
    }

    /// The same for a part or a derivative of the displacement; returns whether the elasticity
    /// knows it.
    pub fn relate_part(
        &self,
        what: Calibrated,
        of: (&Problem, &NormalContact),
        contact: &mut DiscreteContact,
        (p, b): (&[f64], &mut [f64]),
    ) -> Result<bool, Error> {
        let calibration = self.contact.calibration_of(what, of, contact)?;
        if let Some(calibration) = &calibration {
            self.relate_with(calibration, p, b);
        }
        Ok(calibration.is_some())
    }

    /// Sliding at a cell over the path into it, in m.
    fn sliding(&self, b: &[f64], k: usize) -> [f64; 2] {
        [0, 1].map(|c| self.rigid[2 * k + c] - b[2 * k + c])
    }

    /// The resolvent of a cell at a trial traction with a γ, and to p/(μ pₙ) of the cells upstream;
    /// with a guess of m, in Pa.
    fn resolvent(
        &self,
        (trial, gamma): ([f64; 2], f64),
        saturation: &UpstreamValues,
        (k, guess): (usize, f64),
    ) -> Resolvent {
        let compliance = gamma / self.law.stiffness();
        let bristles = if compliance > 0.0 {
            let bristles = self.stencils[k].bristles(compliance, saturation);
            BristleState { is_exact: self.is_exact, guess, ..bristles }
        } else {
            BristleState::default()
        };
        Resolvent::at(trial, self.bound[k], &bristles)
    }

    /// F(p), in Pa; prepares the tangent.
    pub fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]) {
        residual.fill(0.0);
        for strip in 0..self.contact.slaved.kept.len() {
            let mut upstream = UpstreamValues::default();
            for k in self.contact.slaved.kept[strip].clone() {
                let (traction, sliding) = (pair(p, k), self.sliding(b, k));
                let trial = [0, 1].map(|c| traction[c] + self.gamma * sliding[c]);
                let guess = self.resolvents[k].sliding;
                let resolvent = self.resolvent((trial, self.gamma), &upstream, (k, guess));
                for c in 0..2 {
                    residual[2 * k + c] = traction[c] - resolvent.traction[c];
                }
                self.resolvents[k] = resolvent;
                if self.remembers() {
                    let saturation = self.saturated(p, k);
                    self.saturation[2 * k..2 * k + 2].copy_from_slice(&saturation);
                    upstream.advance(saturation);
                }
            }
        }
        self.is_factorised = false;
    }

    /// p/(μ pₙ) of a cell, dimensionless.
    fn saturated(&self, p: &[f64], k: usize) -> [f64; 2] {
        pair(p, k).map(|p| self.over_bound[k] * p)
    }

    /// Change of F due to small changes.
    pub fn tangent(&self, change: &Changed, cause: Option<&Cause>, product: &mut [f64]) {
        product.fill(0.0);
        let remembers = self.remembers();
        for cells in &self.contact.slaved.kept {
            let mut upstream = UpstreamValues::default();
            for k in cells.clone() {
                let resolvent = &self.resolvents[k];
                let (p, u) = (pair(change.traction, k), pair(change.response, k));
                let moved = times(&resolvent.by_trial, [0, 1].map(|c| p[c] - self.gamma * u[c]));
                let mut left = [p[0] - moved[0], p[1] - moved[1]];
                let mut relative = p;
                if let Some(bound) = change.bound {
                    let saturation = pair(&self.saturation, k);
                    for c in 0..2 {
                        left[c] -= bound[k] * resolvent.by_bound[c];
                        relative[c] -= bound[k] * saturation[c];
                    }
                }
                if remembers {
                    let of_upstream = self.stencils[k].of_upstream(&upstream);
                    let inherited = times(&resolvent.by_upstream, of_upstream);
                    left = [left[0] - inherited[0], left[1] - inherited[1]];
                    upstream.advance(relative.map(|change| self.over_bound[k] * change));
                }
                product[2 * k..2 * k + 2].copy_from_slice(&left);
            }
        }
        let Some(cause) = cause else { return };
        let mut slid = self.since_entry(&cause.rigid);
        slide(&self.stencils, &mut slid);
        for k in self.contact.kept() {
            let resolvent = &self.resolvents[k];
            let moved = times(&resolvent.by_trial, pair(&slid, k));
            for c in 0..2 {
                product[2 * k + c] -=
                    self.gamma * moved[c] + cause.stiffness * resolvent.by_stiffness[c];
            }
        }
    }

    fn is_total(&self) -> bool {
        matches!(self.law, ContactLaw::TotalDisplacement(_))
    }

    /// Whether a cell depends on p/(μ pₙ) upstream.
    fn remembers(&self) -> bool {
        matches!(self.law, ContactLaw::Incremental(_))
    }

    /// Replaces v by an approximation to the inverse Jacobian times v: strip by strip, and then
    /// what friction that depends on the heat from upstream adds in each cell, without what this
    /// does to its neighbours.
    pub fn precondition(&mut self, v: &mut [f64], friction: Option<&SteadyFriction>) {
        if !self.is_factorised {
            self.factorise(friction.is_some());
        }
        self.factors.solve(&self.contact.slaved.kept, v);
        if let Some(friction) = friction {
            self.flux_changes.fill(0.0);
            for k in self.contact.kept() {
                let by_bound = times(&self.inverses[k], self.resolvents[k].by_bound);
                let traction = pair(v, k);
                let raised = friction.raised_bound(k, &self.flux_changes, traction, by_bound);
                let traction = [0, 1].map(|c| traction[c] + raised * by_bound[c]);
                self.flux_changes[k] = friction.flux_change(k, traction);
                v[2 * k..2 * k + 2].copy_from_slice(&traction);
            }
        }
        self.contact.slaved.complete(v);
    }

    fn factorise(&mut self, is_coupled: bool) {
        let interface = Interface {
            kept: &self.contact.slaved.kept,
            resolvents: &self.resolvents,
            gamma: self.gamma,
            bristles: self
                .remembers()
                .then_some(Upstream { stencils: &self.stencils, over_bound: &self.over_bound }),
        };
        self.factors.factorise(&interface);
        if is_coupled {
            for k in self.contact.kept() {
                let weight = self.gamma * self.stencils[k].own();
                let stiffening = self.contact.local[k].map(|row| row.map(|local| weight * local));
                self.inverses[k] = inverse_2x2(self.resolvents[k].jacobian(&stiffening));
            }
        }
        self.is_factorised = true;
    }

    /// Gives the cells that have no equation of their own the traction that follows from the
    /// others, in place.
    pub fn complete(&self, p: &mut [f64]) {
        self.contact.slaved.complete(p);
    }
}

/// The stencils of the cells, and the factors of their strips.
fn discretised(
    law: ContactLaw,
    patch: &Patch,
    contact: &StripContact,
) -> (Vec<SlipStencil>, StripFactors) {
    let kept = &contact.slaved.kept;
    let stencils = match law {
        ContactLaw::Coulomb | ContactLaw::Incremental(_) => SlipStencil::of(patch, kept),
        ContactLaw::TotalDisplacement(_) => SlipStencil::since_entry(patch, kept),
    };
    let factors = StripFactors::new(patch, contact, |k| {
        let of = |(cell, weight)| Displaced { cell, weight, entered: weight, alone: 0.0 };
        stencils[k].cells(k).map(of)
    });
    (stencils, factors)
}
