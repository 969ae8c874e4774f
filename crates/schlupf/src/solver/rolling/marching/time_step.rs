//! A time step: for every cell p = R(p + γ s) as in steady rolling, with s the sliding at the end
//! of the step along the path of its material, and known what the material has done upstream.
//!
//! s is the derivative of the sliding since entry along the path, by the polynomial through its
//! present value and those at up to three earlier steps. It is thus of third order once the
//! material has been in contact for three steps, of lower order after entry and after a shift. The
//! end of a march is the steady state of the direct solver.

use crate::bodies::Kinematics;
use crate::interface::ContactLaw;
use crate::normal::NormalContact;
use crate::normal::patch::{Cell, Patch};
use crate::numerics::vector::{add_scaled, norm};
use crate::problem::{Places, Problem, TrackPoint};
use crate::reporting::Error;
use crate::solver::equilibrium::{self, Directions, Equilibrium};
use crate::solver::prescribed::MovedEquilibrium;
use crate::solver::rolling::shared::cell::times;
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::passage::pair;
use crate::solver::rolling::shared::strip::{
    BristleState, Displaced, Interface, LoneCell, Resolvent, StripContact, StripFactors, order,
    reduced, saturation, through,
};

use super::arrival::Arrival;
use super::moved::Moved;
use super::past::Past;
use super::step_response::{Known, StepResponse};

/// Stick and slip on a patch, kept from step to step.
pub(super) struct TimeStepLaw {
    pub contact: StripContact,
    interface: ContactLaw,
    directions: Directions,
    /// λ of the cells, and which material entered in place: the linear response of the directions.
    of: (Vec<f64>, Vec<bool>),
    /// Factors of the strips, and of which displacements.
    factors: Option<(Vec<Displaced>, StripFactors)>,
}

impl TimeStepLaw {
    /// Of a problem.
    pub fn of(
        problem: &Problem,
        normal: &NormalContact,
        contact: &mut DiscreteContact,
    ) -> Result<Self, Error> {
        Ok(Self {
            contact: StripContact::new(problem, normal, contact)?,
            interface: problem.interface.contact_law,
            directions: Directions::default(),
            of: Default::default(),
            factors: None,
        })
    }

    /// An admissible traction near the given one, in place.
    pub fn admit(&self, p: &mut [f64], bound: &[f64]) {
        for k in self.contact.kept() {
            let onto = reduced(pair(p, k), bound[k]);
            p[2 * k..2 * k + 2].copy_from_slice(&onto);
        }
        self.contact.slaved.complete(p);
    }

    /// Replaces the slip velocity of the cells by that of the last step, at a rolling speed in m/s.
    pub fn take_slip(&self, moved: &[Moved], speed: f64, slip: &mut [[f64; 2]]) {
        if matches!(self.interface, ContactLaw::TotalDisplacement(_)) {
            return;
        }
        for k in self.contact.kept() {
            slip[k] = moved[k].slip.map(|s| speed * s);
        }
        self.contact.slaved.copy(slip);
    }
}

/// How the sliding at a cell follows from its change in the step: weight · change + known. What
/// the bristles do follows in the same way from the saturation.
#[derive(Debug, Clone, Default)]
struct PathSlip {
    /// Dimensionless.
    weight: f64,
    /// In m.
    known: [f64; 2],
    bristles: BristleState,
    /// Path from the nearest place, in m.
    path: f64,
}

/// From a single node with p/(μ pₙ).
fn from(saturation: [f64; 2]) -> BristleState {
    BristleState { own: 1.0, upstream: saturation.map(|q| -q), order: 1, ..BristleState::default() }
}

/// Earlier places of the path of the material in a cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Track {
    /// Sliding since entry before the step, in m.
    pub sliding: [f64; 2],
    /// Traction on the rail over μ pₙ before the step, dimensionless.
    pub saturation: [f64; 2],
    /// Places with their distances from the cell, the latest first.
    pub places: Places,
}

impl Track {
    /// Of material that has arrived, with the places from which its slip follows.
    pub fn of((arrival, places): (&Arrival, Places)) -> Self {
        Self { sliding: arrival.sliding, saturation: arrival.saturation, places }
    }

    fn slip(&self) -> PathSlip {
        let Self { sliding, places, .. } = self;
        let weights = through(places.iter().map(|place| place.distance));
        let Some(nearest) = places.first() else {
            // All of the change is in the step.
            let bristles = from(self.saturation);
            return PathSlip { weight: 1.0, bristles, ..PathSlip::default() };
        };
        let known = sliding.map(|s| weights[0] * s);
        let path = nearest.distance;
        let bristles =
            BristleState { own: weights[0], order: order(&weights), ..BristleState::default() };
        let mut slip = PathSlip { weight: weights[0], known, bristles, path };
        for (weight, place) in weights[1..].iter().zip(places.iter()) {
            for c in 0..2 {
                slip.known[c] += weight * place.sliding[c];
                slip.bristles.upstream[c] += weight * place.saturation[c];
            }
        }
        slip
    }
}

/// The equilibrium of one instant with stick and slip.
pub(super) struct TimeStepEquilibrium<'a> {
    response: StepResponse<'a>,
    law: &'a mut TimeStepLaw,
    gamma: f64,
    /// Rigid slip of each cell in the step less the present displacement under the pressure, x and
    /// y in turn, in m.
    rigid: Vec<f64>,
    /// μ pₙ of each cell, in Pa.
    bound: Vec<f64>,
    tracks: Vec<Track>,
    slips: Vec<PathSlip>,
    resolvents: Vec<Resolvent>,
    /// Whether the factors are those of the last residual.
    is_factorised: bool,
    /// Largest ‖p‖₂ of the previous steps, in Pa.
    largest: f64,
}

impl<'a> TimeStepEquilibrium<'a> {
    /// Without motion; with residuals measured relative to a traction (‖p‖₂ in Pa) if that of this
    /// step is smaller.
    pub fn new(
        response: StepResponse<'a>,
        law: &'a mut TimeStepLaw,
        bound: &[f64],
        tracks: Vec<Track>,
        largest: f64,
    ) -> Self {
        let Known { in_contact, in_place, .. } = response.known;
        if law.of.0 != *in_contact || law.of.1 != *in_place {
            law.directions = Directions::default();
            law.of = (in_contact.clone(), in_place.clone());
        }
        let mut bound = bound.to_vec();
        law.contact.slaved.complete_scalar(&mut bound);
        let mut equilibrium = Self {
            gamma: response.contact.cell_stiffness(),
            rigid: vec![0.0; 2 * tracks.len()],
            slips: tracks.iter().map(Track::slip).collect(),
            resolvents: vec![Resolvent::default(); tracks.len()],
            is_factorised: false,
            response,
            law,
            bound,
            tracks,
            largest,
        };
        equilibrium.prepare();
        equilibrium
    }

    /// Whether a cell is displaced by the tractions of others.
    pub fn is_coupled(&self) -> bool {
        self.response.is_coupled
    }

    /// Sliding at a cell, in m.
    fn sliding(&self, u: &[f64], k: usize) -> [f64; 2] {
        let PathSlip { known, weight, .. } = &self.slips[k];
        let change = self.change(u, k);
        [0, 1].map(|c| weight * change[c] + known[c])
    }

    /// Change of the sliding since entry in the step, in m.
    fn change(&self, u: &[f64], k: usize) -> [f64; 2] {
        let (rigid, displacement) = (&self.rigid, &self.response.known.displacement);
        [2 * k, 2 * k + 1].map(|at| rigid[at] + displacement[at] - u[at])
    }

    /// What the law of a cell takes for its sliding, in m.
    fn effective_sliding(&self, u: &[f64], k: usize) -> [f64; 2] {
        match self.law.interface {
            ContactLaw::TotalDisplacement(_) => {
                let change = self.change(u, k);
                [0, 1].map(|c| self.tracks[k].sliding[c] + change[c])
            }
            ContactLaw::Coulomb | ContactLaw::Incremental(_) => self.sliding(u, k),
        }
    }

    /// The resolvent of a cell at a trial traction (in Pa) with a γ.
    fn resolvent(&self, trial: [f64; 2], gamma: f64, k: usize) -> Resolvent {
        let compliance = gamma / self.law.interface.stiffness();
        let bristles = match self.law.interface {
            ContactLaw::TotalDisplacement(_) => from([0.0; 2]),
            ContactLaw::Coulomb | ContactLaw::Incremental(_) => self.slips[k].bristles,
        };
        Resolvent::at(trial, self.bound[k], &BristleState { compliance, ..bristles })
    }

    /// The tractions of cells that are not coupled, in place: exactly, cell by cell.
    pub fn solve_uncoupled(&self, p: &mut [f64]) {
        let nothing = vec![0.0; p.len()];
        for k in 0..self.bound.len() {
            let [[x, _], [_, y]] = self.law.contact.local[k];
            let own = [x, y].map(|own| self.weight(k) * own);
            let mean = 0.5 * (own[0] + own[1]);
            let gamma = if mean > 0.0 { mean.recip() } else { self.gamma };
            let cell = LoneCell {
                sliding: self.effective_sliding(&nothing, k).map(|s| gamma * s),
                stiffening: own.map(|own| gamma * own),
                bound: self.bound[k],
            };
            cell.solve(&mut p[2 * k..2 * k + 2], |trial| self.resolvent(trial, gamma, k));
        }
    }

    /// Weight of the change of a cell in what its law sees, dimensionless.
    fn weight(&self, k: usize) -> f64 {
        match self.law.interface {
            ContactLaw::TotalDisplacement(_) => 1.0,
            ContactLaw::Coulomb | ContactLaw::Incremental(_) => self.slips[k].weight,
        }
    }

    /// The displacement that is a part of what the law of a cell sees; see [`StepResponse`].
    fn displaced(&self, cell: usize) -> Displaced {
        let Known { in_contact, in_place, .. } = self.response.known;
        let whole = self.weight(cell);
        let entered = (1.0 - in_contact[cell]) * whole;
        if in_place[cell] && self.response.is_coupled {
            Displaced { cell, weight: whole - entered, entered: 0.0, alone: entered }
        } else {
            Displaced { cell, weight: whole, entered, alone: 0.0 }
        }
    }

    /// Makes the factors anew where the displacements differ from those of the last step.
    fn prepare(&mut self) {
        let cells = 0..self.bound.len();
        let displaced: Vec<Displaced> = cells.map(|cell| self.displaced(cell)).collect();
        let Self { law, response, .. } = self;
        if law.factors.as_ref().is_none_or(|(of, _)| *of != displaced) {
            let of_cell = |k: usize| std::iter::once(displaced[k]);
            let factors = StripFactors::new(&response.contact.patch, &law.contact, of_cell);
            law.factors = Some((displaced, factors));
        }
    }

    fn factorise(&mut self) {
        let Self { law, resolvents, gamma, .. } = self;
        let Some((_, factors)) = &mut law.factors else { return };
        factors.factorise(&Interface {
            kept: &law.contact.slaved.kept,
            resolvents,
            gamma: *gamma,
            bristles: None,
        });
        self.is_factorised = true;
    }

    /// What the material of the cells has done in the step that ends with the traction p.
    pub fn moved(&self, p: &[f64], u: &[f64]) -> Vec<Moved> {
        let moved = |(k, track): (usize, &Track)| {
            let increment = self.change(u, k);
            let sliding = [0, 1].map(|c| track.sliding[c] + increment[c]);
            let saturation = saturation(pair(p, k), self.bound[k]);
            let here = TrackPoint { distance: 0.0, sliding, saturation };
            // Slaved cells at the leading edge have no equation of their own.
            let here = (!self.law.contact.slaved.leads[k]).then_some(here);
            let path = self.slips[k].path;
            let slides = self.resolvents[k].is_sliding();
            let slip = if slides && path > 0.0 { self.sliding(u, k) } else { [0.0; 2] };
            Moved {
                saturation,
                sliding,
                track: here.into_iter().chain(track.places.iter().copied()).collect(),
                slip: slip.map(|s| if s == 0.0 { 0.0 } else { s / path }),
            }
        };
        self.tracks.iter().enumerate().map(moved).collect()
    }
}

impl Equilibrium for TimeStepEquilibrium<'_> {
    fn size(&self) -> usize {
        2 * self.bound.len()
    }

    fn scale(&self, p: &[f64]) -> f64 {
        equilibrium::measure(norm(&self.bound), norm(p).max(self.largest))
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        self.response.product(&self.law.contact.calibration, p, u);
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        residual.fill(0.0);
        self.is_factorised = false;
        for strip in 0..self.law.contact.slaved.kept.len() {
            for k in self.law.contact.slaved.kept[strip].clone() {
                let sliding = self.effective_sliding(u, k);
                let trial = [0, 1].map(|c| p[2 * k + c] + self.gamma * sliding[c]);
                self.resolvents[k] = self.resolvent(trial, self.gamma, k);
                for c in 0..2 {
                    residual[2 * k + c] = p[2 * k + c] - self.resolvents[k].traction[c];
                }
            }
        }
    }

    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]) {
        product.fill(0.0);
        for k in self.law.contact.kept() {
            let weight = self.gamma * self.weight(k);
            let tried = [0, 1].map(|c| v[2 * k + c] - weight * response[2 * k + c]);
            let resolvent = times(&self.resolvents[k].by_trial, tried);
            for c in 0..2 {
                product[2 * k + c] = v[2 * k + c] - resolvent[c];
            }
        }
    }

    fn directions(&mut self) -> Option<&mut Directions> {
        Some(&mut self.law.directions)
    }

    /// Strip by strip, without what a strip does to the others.
    fn precondition(&mut self, v: &mut [f64]) {
        if !self.is_factorised {
            self.factorise();
        }
        if let Some((_, factors)) = &mut self.law.factors {
            factors.solve(&self.law.contact.slaved.kept, v);
        }
        self.law.contact.slaved.complete(v);
    }
}

impl MovedEquilibrium for TimeStepEquilibrium<'_> {
    fn patch(&self) -> &Patch {
        &self.response.contact.patch
    }

    fn set_motion(&mut self, motion: &Kinematics) {
        let StepResponse { contact, known, .. } = &self.response;
        self.rigid = known.rigid(&contact.patch.cells, motion);
        if let Some(pressed) = self.response.pressed() {
            add_scaled(&mut self.rigid, -1.0, &pressed);
        }
    }

    fn change_by_motion(&mut self, change: &Kinematics, of_residual: &mut [f64]) {
        let StepResponse { contact, known, .. } = &self.response;
        let cells = contact.patch.cells.iter().map(Cell::on_plane);
        let slips = known.rigid(&cells.collect::<Vec<_>>(), change);
        let back: Vec<f64> = slips.iter().map(|slip| -slip).collect();
        self.tangent_product(&vec![0.0; back.len()], &back, of_residual);
    }
}

/// The record of an instant with the displacements calibrated.
pub(super) fn calibrate(past: &mut Past, law: &TimeStepLaw, patch: &Patch, p: &[f64]) {
    let calibration = &law.contact.calibration;
    let zeros = || vec![0.0; p.len()];
    let (mut at_cells, mut at_entries) = (zeros(), zeros());
    calibration.add_at_cells(p, &mut at_cells);
    calibration.add_at_entries(p, &mut at_entries);
    for (k, cell) in patch.cells.iter().enumerate() {
        if let Some((_, departure)) = &mut past.cells[cell.index] {
            for c in 0..2 {
                departure.displacement[c] += at_cells[2 * k + c];
                departure.at_entry[c] += at_entries[2 * k + c];
            }
        }
    }
}
