//! Bristles neither soft nor stiff against a cell: F is a mean of that of [`Bristles`] and that of
//! [`StickSlip`], which are discretised differently, so that forces do not jump where one takes
//! over from the other.

use crate::error::Error;
use crate::normal::NormalContact;
use crate::numerics::vector::norm;
use crate::patch::{Cell, Patch};
use crate::problem::Problem;
use crate::rolling::shared::contact::{DiscreteContact, StickShare};
use crate::rolling::shared::coulomb::{Discretisation, saturation};
use crate::rolling::shared::passage::pair;
use crate::state::Element;

use super::bristles::Bristles;
use super::steady_friction::SteadyFriction;
use super::stick_slip::StickSlip;
use super::strip_law::{Cause, Changed, StripLaw};

/// ‖p‖₂ over ‖μ pₙ‖₂ below which hardly a cell slides, dimensionless.
const STUCK: f64 = 0.03;

/// Both laws along the strips of a patch.
pub(super) struct Blend {
    bristles: Bristles,
    stick_slip: StickSlip,
    /// Stiffness of a cell of the finest grid, in Pa/m.
    finest_cell: f64,
    /// In Pa.
    peak_pressure: f64,
    share: StickShare,
    /// Whether all but the edges stuck at the last residual.
    is_stuck: bool,
    /// F of both at the last residual, in Pa.
    residuals: [Vec<f64>; 2],
}

impl Blend {
    /// The strips of a patch; [`StripLaw::set_problem`] sets motion and laws. The share goes by the
    /// stiffness of a cell of the finest grid, in Pa/m.
    ///
    /// # Errors
    /// Those of [`StickSlip::new`].
    pub fn new(
        problem: &Problem,
        normal: &NormalContact,
        contact: &mut DiscreteContact,
        (discretisation, finest_cell): (Discretisation, f64),
    ) -> Result<Self, Error> {
        let zeros = || vec![0.0; 2 * contact.patch.len()];
        Ok(Self {
            bristles: Bristles::new(problem, &contact.patch),
            finest_cell,
            peak_pressure: normal.summary.peak_pressure,
            share: StickShare::of(problem, normal.summary.peak_pressure, finest_cell),
            is_stuck: true,
            residuals: [zeros(), zeros()],
            stick_slip: StickSlip::new(problem, normal, contact, discretisation)?,
        })
    }

    /// The response of each law to a traction, from the displacements relative to the entry.
    fn responses(&self, p: &[f64], relative: &[f64]) -> [Vec<f64>; 2] {
        let relative = &relative[..p.len()];
        let mut of_bristles = relative.to_vec();
        self.bristles.relate(p, &mut of_bristles);
        let mut of_stick_slip = Vec::new();
        if self.has_slider() {
            of_stick_slip.extend_from_slice(relative);
            self.stick_slip.relate(p, &mut of_stick_slip);
        }
        [of_bristles, of_stick_slip]
    }

    /// The mean of what both laws give, in place of the first.
    fn mean(&self, values: &mut [f64], of_stick_slip: &[f64]) {
        let share = self.share.value;
        for (value, other) in values.iter_mut().zip(of_stick_slip) {
            *value = (1.0 - share) * *value + share * other;
        }
    }

    /// Whether the bristles count: under Coulomb's law they would be infinitely stiff.
    fn has_bristles(&self) -> bool {
        self.share.value < 1.0
    }

    /// Whether stick and slip count, at least for the preconditioner.
    fn has_slider(&self) -> bool {
        self.share.value > 0.0 || self.is_stuck
    }
}

impl StripLaw for Blend {
    fn set_problem(&mut self, problem: &Problem, patch: &Patch, gamma: f64) {
        self.share = StickShare::of(problem, self.peak_pressure, self.finest_cell);
        self.bristles.set_problem(problem, patch, gamma);
        self.stick_slip.set_problem(problem, patch, gamma);
    }

    fn bound(&self) -> &[f64] {
        self.bristles.bound()
    }

    fn set_bound(&mut self, cells: &[Cell], coefficient: &[f64]) {
        self.bristles.set_bound(cells, coefficient);
        self.stick_slip.set_bound(cells, coefficient);
    }

    /// Each law has its own response, so b remains the relative displacement.
    fn relate(&self, _p: &[f64], _b: &mut [f64]) {}

    fn rigid_saturation(&self) -> Vec<[f64; 2]> {
        self.stick_slip.rigid_saturation()
    }

    /// ‖F‖₂ of the last residual (in Pa), unless only bristles count.
    fn defect(&self, p: &[f64], b: &[f64]) -> f64 {
        if self.share.value == 0.0 {
            let mut of_bristles = b[..p.len()].to_vec();
            self.bristles.relate(p, &mut of_bristles);
            return self.bristles.defect(p, &of_bristles);
        }
        let [of_bristles, of_stick_slip] = &self.residuals;
        let mut residual = of_bristles.clone();
        self.mean(&mut residual, of_stick_slip);
        norm(&residual)
    }

    fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]) {
        self.is_stuck = norm(p) < STUCK * norm(self.bristles.bound());
        let [of_bristles, of_stick_slip] = self.responses(p, b);
        let (has_bristles, has_slider) = (self.has_bristles(), self.has_slider());
        let [first, second] = &mut self.residuals;
        first.fill(0.0);
        if has_bristles {
            self.bristles.residual(p, &of_bristles, first);
        }
        if has_slider {
            self.stick_slip.residual(p, &of_stick_slip, second);
            self.stick_slip.depart(p, second);
        }
        residual.copy_from_slice(first);
        self.mean(residual, &self.residuals[1]);
    }

    fn tangent(&self, change: &Changed, cause: Option<&Cause>, product: &mut [f64]) {
        let [of_bristles, of_stick_slip] = self.responses(change.traction, change.response);
        product.fill(0.0);
        if self.has_bristles() {
            let change = Changed { response: &of_bristles, ..*change };
            self.bristles.tangent(&change, cause, product);
        }
        if self.share.value == 0.0 {
            return;
        }
        let mut other = vec![0.0; product.len()];
        let change = Changed { response: &of_stick_slip, ..*change };
        self.stick_slip.tangent(&change, cause, &mut other);
        self.stick_slip.depart(change.traction, &mut other);
        self.mean(product, &other);
        let more = cause.map_or(0.0, |cause| self.share.by_stiffness * cause.over_cells);
        let [first, second] = &self.residuals;
        for (product, (first, second)) in product.iter_mut().zip(first.iter().zip(second)) {
            *product += more * (second - first);
        }
    }

    /// The mean of both approximations; where all sticks that of stick and slip alone, which knows
    /// how the cells of a strip move each other. A sliver has an equation of its own here, so what
    /// its part of v demands is added to what follows from the others.
    fn precondition(&mut self, v: &mut [f64], friction: Option<&SteadyFriction>) {
        let mut other = Vec::new();
        if self.has_slider() {
            other.extend_from_slice(v);
            self.stick_slip.precondition(&mut other, friction);
            self.stick_slip.add_to_slivers(v, &mut other);
        }
        if self.is_stuck {
            v.copy_from_slice(&other);
            return;
        }
        if self.has_bristles() {
            self.bristles.precondition(v, friction);
        }
        if self.share.value > 0.0 {
            self.mean(v, &other);
        }
    }

    fn elements(&self, patch: &Patch, p: &[f64], b: &[f64], relative: &[f64]) -> Vec<Element> {
        let [of_bristles, _] = self.responses(p, b);
        let mut elements = self.bristles.elements(patch, p, &of_bristles, relative);
        if self.share.value == 0.0 {
            return elements;
        }
        for (k, element) in elements.iter_mut().enumerate() {
            element.saturation = saturation(pair(p, k), self.bound()[k]);
        }
        elements
    }

    fn stick_share(&self) -> f64 {
        self.share.value
    }
}
