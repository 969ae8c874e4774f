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

use crate::equilibrium::{self, Equilibrium};
use crate::interface::contact_law::{ContactLaw, Response, Slide};
use crate::numerics::vector::norm;
use crate::rolling::shared::cell::{CellSolver, inverse_2x2, solve_2x2, times};

use super::moved::Moved;
use super::step_response::StepResponse;

/// The equilibrium of one instant: p = μ pₙ law(D − B p), where each cell has its own history.
pub(super) struct TimeStep<'a> {
    response: StepResponse<'a>,
    cell: CellSolver<'a>,
    /// μ pₙ of each cell, in Pa.
    bound: &'a [f64],
    /// History of each cell; the increment is that of the last evaluation.
    slides: Vec<Slide>,
    /// Response of each cell at the last evaluation.
    responses: Vec<Response>,
    /// s of each cell.
    sliding: Vec<[f64; 2]>,
    /// ∂(μ pₙ law)/∂(p + γ (D − A p)) of each cell.
    yielding: Vec<[[f64; 2]; 2]>,
    /// Ratio of displacement to traction of the patch as a whole, for each component, in m/Pa.
    patch_compliance: [f64; 2],
    /// Largest ‖p‖₂ of the previous steps, in Pa.
    largest: f64,
}

impl<'a> TimeStep<'a> {
    pub fn new(
        response: StepResponse<'a>,
        law: &'a dyn ContactLaw,
        bound: &'a [f64],
        slides: Vec<Slide>,
    ) -> Self {
        let cells = slides.len();
        let contact = &mut *response.contact;
        let (gamma, patch_compliance) = (contact.safe_stiffness(), contact.patch_compliance());
        Self {
            response,
            cell: CellSolver { law, gamma },
            bound,
            slides,
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

    /// What the material of the cells has done, at the last evaluation.
    pub fn moved(&self) -> Vec<Moved> {
        let moved = |(slide, response): (&Slide, &Response)| Moved {
            saturation: response.traction,
            sliding: [0, 1].map(|c| slide.distance[c] + slide.increment[c]),
            increment: slide.increment,
            ..Moved::default()
        };
        self.slides.iter().zip(&self.responses).map(moved).collect()
    }
}

impl Equilibrium for TimeStep<'_> {
    fn size(&self) -> usize {
        2 * self.slides.len()
    }

    fn scale(&self, p: &[f64]) -> f64 {
        equilibrium::measure(norm(self.bound), norm(p).max(self.largest))
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        self.response.product(None, p, u);
    }

    fn defect(&mut self, p: &[f64], u: &[f64]) -> f64 {
        let mut squares = 0.0;
        for k in 0..self.slides.len() {
            self.slides[k].increment =
                [0, 1].map(|c| self.response.prescribed.sliding[2 * k + c] - u[2 * k + c]);
            self.responses[k] = self.cell.law.respond(&self.slides[k]);
            let traction = self.responses[k].traction.map(|q| self.bound[k] * q);
            squares += (p[2 * k] - traction[0]).powi(2) + (p[2 * k + 1] - traction[1]).powi(2);
        }
        squares.sqrt()
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        let gamma = self.cell.gamma;
        for k in 0..self.slides.len() {
            let increment =
                [0, 1].map(|c| self.response.prescribed.sliding[2 * k + c] - u[2 * k + c]);
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
            let share =
                if self.response.is_coupled { self.response.prescribed.in_contact[k] } else { 1.0 };
            let bedding = self.cell.gamma * share;
            let [wx, wy] = self.patch_compliance.map(|a| 1.0 - bedding * a);
            let matrix = [[1.0 - xx * wx, -xy * wy], [-yx * wx, 1.0 - yy * wy]];
            let solved = solve_2x2(matrix, [v[2 * k], v[2 * k + 1]]);
            v[2 * k..2 * k + 2].copy_from_slice(&solved);
        }
    }
}
