//! One time step: the material moves on by a cell and finds a new equilibrium, Eqs. (8), (13)–(16).
//!
//! A stiff contact law makes p − μ pₙ law(D − A p) nearly discontinuous, and Newton's method slow.
//! The equation is therefore reformulated: for any γ > 0, p solves it exactly when
//!
//! F(p) = p − μ pₙ law(s) = 0,  where s solves  μ pₙ law(s) + γ s = p + γ (D − A p)
//!
//! for each cell separately. The law appears only together with γ s, and F stays smooth from the
//! softest law to Coulomb's. With γ ≤ 1/‖A‖ the step p ← p − F(p) is a forward–backward splitting
//! (Lions and Mercier 1979) of 0 = A p − D + law⁻¹(p), which never leads away from the solution.

use crate::equilibrium::{self, Equilibrium, Limits, Newton, Outcome};
use crate::error::Error;
use crate::interface::contact_law::{ContactLaw, Response, Slide};
use crate::numerics::vector::norm;
use crate::progress::Watch;
use crate::rolling::shared::cell::{CellSolver, inverse_2x2, solve_2x2, times};
use crate::rolling::shared::contact::DiscreteContact;

/// Known data of a time step, cell by cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Prescribed {
    /// D: sliding of each cell if the displacement were zero now, x and y in turn, in m.
    pub sliding: Vec<f64>,
    /// λ: fraction of the step that its material has spent in contact, dimensionless.
    pub in_contact: Vec<f64>,
    /// Whether its material came into contact in place, not over the leading edge.
    pub in_place: Vec<bool>,
}

/// The equilibrium of one instant: p = μ pₙ law(D − B p), where each cell has its own history.
///
/// Material that came into contact within the step is compared with the displacement where and when
/// it entered: B = A − diag(1 − λ) A_lead, where A_lead p is the present displacement at its place
/// of entry: at the leading edge, or, if it came into contact in place, the displacement caused
/// there by the tractions of the other cells.
pub(super) struct TimeStep<'a> {
    contact: &'a mut DiscreteContact,
    cell: CellSolver<'a>,
    /// μ pₙ of each cell, in Pa.
    bound: &'a [f64],
    prescribed: &'a Prescribed,
    /// History of each cell; the increment is that of the last evaluation.
    pub slides: Vec<Slide>,
    /// Response of each cell at the last evaluation.
    pub responses: Vec<Response>,
    /// s of each cell.
    sliding: Vec<[f64; 2]>,
    /// ∂(μ pₙ law)/∂(p + γ (D − A p)) of each cell.
    yielding: Vec<[[f64; 2]; 2]>,
    /// Ratio of displacement to traction of the patch as a whole, for each component, in m/Pa.
    patch_compliance: [f64; 2],
    /// Whether entering material is displaced by the material in contact.
    is_coupled: bool,
    /// A p where the material of each cell entered, in m.
    at_entry: Vec<f64>,
    /// Largest ‖p‖₂ of the previous steps, in Pa.
    largest: f64,
}

impl<'a> TimeStep<'a> {
    pub fn new(
        contact: &'a mut DiscreteContact,
        law: &'a dyn ContactLaw,
        bound: &'a [f64],
        prescribed: &'a Prescribed,
        slides: Vec<Slide>,
    ) -> Self {
        let cells = slides.len();
        let (gamma, patch_compliance) = (contact.safe_stiffness(), contact.patch_compliance());
        let is_coupled = contact.compliance.couples_cells();
        Self {
            contact,
            cell: CellSolver { law, gamma },
            bound,
            prescribed,
            slides,
            is_coupled,
            at_entry: vec![0.0; 2 * cells],
            responses: vec![Response::default(); cells],
            sliding: vec![[0.0; 2]; cells],
            yielding: vec![[[0.0; 2]; 2]; cells],
            patch_compliance,
            largest: 0.0,
        }
    }

    /// Measures residuals relative to a traction (‖p‖₂ in Pa) if that of this step is smaller: a
    /// decaying traction need not be known more accurately than it was.
    pub fn measured_against(self, largest: f64) -> Self {
        Self { largest, ..self }
    }

    /// Solves for the traction on the rail p, starting from the given one.
    pub fn solve(
        &mut self,
        newton: &mut Newton,
        p: &mut [f64],
        limits: &Limits,
        watch: Watch,
    ) -> Result<Outcome, Error> {
        Ok(newton.solve(self, p, limits, watch)?.outcome)
    }
}

impl Equilibrium for TimeStep<'_> {
    fn size(&self) -> usize {
        self.prescribed.sliding.len()
    }

    fn scale(&self, p: &[f64]) -> f64 {
        equilibrium::measure(norm(self.bound), norm(p).max(self.largest))
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        let made = self.contact.product(p);
        made.at_cells(u);
        made.at_entries(&mut self.at_entry);
        let own = self.contact.cell_compliance();
        let Prescribed { in_contact, in_place, .. } = self.prescribed;
        for (at, u) in u.iter_mut().enumerate() {
            let k = at / 2;
            let is_moved = in_place[k] && self.is_coupled;
            let entry = if is_moved { *u - own * p[at] } else { self.at_entry[at] };
            *u -= (1.0 - in_contact[k]) * entry;
        }
    }

    fn defect(&mut self, p: &[f64], u: &[f64]) -> f64 {
        let mut squares = 0.0;
        for k in 0..self.slides.len() {
            self.slides[k].increment =
                [0, 1].map(|c| self.prescribed.sliding[2 * k + c] - u[2 * k + c]);
            self.responses[k] = self.cell.law.respond(&self.slides[k]);
            let traction = self.responses[k].traction.map(|q| self.bound[k] * q);
            squares += (p[2 * k] - traction[0]).powi(2) + (p[2 * k + 1] - traction[1]).powi(2);
        }
        squares.sqrt()
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        let gamma = self.cell.gamma;
        for k in 0..self.slides.len() {
            let increment = [0, 1].map(|c| self.prescribed.sliding[2 * k + c] - u[2 * k + c]);
            let target = [0, 1].map(|c| p[2 * k + c] + gamma * increment[c]);
            self.slides[k].increment = self.sliding[k];
            let response = self.cell.solve(&mut self.slides[k], self.bound[k], target);
            self.sliding[k] = self.slides[k].increment;
            for c in 0..2 {
                residual[2 * k + c] = p[2 * k + c] - self.bound[k] * response.traction[c];
            }
            // ∂(μ pₙ law)/∂target = I − γ (∂(μ pₙ law)/∂s + γ)⁻¹
            let [[xx, xy], [yx, yy]] = inverse_2x2(self.cell.stiffness(&response, self.bound[k]));
            self.yielding[k] = [[1.0 - gamma * xx, -gamma * xy], [-gamma * yx, 1.0 - gamma * yy]];
        }
    }

    fn tangent_product(&mut self, v: &[f64], compliance_v: &[f64], product: &mut [f64]) {
        for (k, yielding) in self.yielding.iter().enumerate() {
            let target = [0, 1].map(|c| v[2 * k + c] - self.cell.gamma * compliance_v[2 * k + c]);
            let answer = times(yielding, target);
            for c in 0..2 {
                product[2 * k + c] = v[2 * k + c] - answer[c];
            }
        }
    }

    /// Each cell separately, on a bedding as stiff as the patch as a whole.
    fn precondition(&mut self, v: &mut [f64]) {
        for (k, [[xx, xy], [yx, yy]]) in self.yielding.iter().enumerate() {
            let share = if self.is_coupled { self.prescribed.in_contact[k] } else { 1.0 };
            let bedding = self.cell.gamma * share;
            let [wx, wy] = self.patch_compliance.map(|a| 1.0 - bedding * a);
            let matrix = [[1.0 - xx * wx, -xy * wy], [-yx * wx, 1.0 - yy * wy]];
            let solved = solve_2x2(matrix, [v[2 * k], v[2 * k + 1]]);
            v[2 * k..2 * k + 2].copy_from_slice(&solved);
        }
    }
}
