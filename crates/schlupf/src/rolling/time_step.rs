//! One time step: the material moves on by a cell and finds a new equilibrium, Eqs. (8), (13)–(16).

use crate::equilibrium::{self, Equilibrium, Limits, Outcome};
use crate::interface::contact_law::{ContactLaw, Response, Slide};

use super::contact::DiscreteContact;

/// The equilibrium of one instant: p = μ pₙ law(D − A p), each cell with its own history.
pub(super) struct TimeStep<'a> {
    contact: &'a mut DiscreteContact,
    law: &'a dyn ContactLaw,
    /// μ pₙ of each cell, in Pa.
    bound: &'a [f64],
    /// D: what each cell would slide if its displacement were zero now, in m.
    prescribed: &'a [f64],
    /// History of each cell; the increment is that of the last residual.
    pub slides: Vec<Slide>,
    /// Answer of each cell at the last residual.
    pub responses: Vec<Response>,
    /// Displacement over traction of the patch as a whole, for each component, in m/Pa.
    stand_in: [f64; 2],
}

impl<'a> TimeStep<'a> {
    pub fn new(
        contact: &'a mut DiscreteContact,
        law: &'a dyn ContactLaw,
        bound: &'a [f64],
        prescribed: &'a [f64],
        slides: Vec<Slide>,
        stand_in: [f64; 2],
    ) -> Self {
        let responses = vec![Response::default(); slides.len()];
        Self { contact, law, bound, prescribed, slides, responses, stand_in }
    }

    /// Solves for the traction on the rail p, from the given one.
    pub fn solve(&mut self, p: &mut [f64], limits: &Limits) -> Outcome {
        equilibrium::solve(self, p, limits)
    }

    fn respond(&mut self, k: usize, increment: [f64; 2]) {
        self.slides[k].increment = increment;
        self.responses[k] = self.law.respond(&self.slides[k]);
    }
}

impl Equilibrium for TimeStep<'_> {
    fn size(&self) -> usize {
        self.prescribed.len()
    }

    fn scale(&self) -> f64 {
        equilibrium::norm(self.bound)
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        self.contact.product(p, u);
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        for k in 0..self.slides.len() {
            let increment = [0, 1].map(|c| self.prescribed[2 * k + c] - u[2 * k + c]);
            self.respond(k, increment);
            for c in 0..2 {
                residual[2 * k + c] = p[2 * k + c] - self.bound[k] * self.responses[k].traction[c];
            }
        }
    }

    fn tangent_product(&self, v: &[f64], compliance_v: &[f64], product: &mut [f64]) {
        for (k, response) in self.responses.iter().enumerate() {
            let u = [compliance_v[2 * k], compliance_v[2 * k + 1]];
            for (c, row) in response.by_increment.iter().enumerate() {
                let eased = row[0] * u[0] + row[1] * u[1];
                product[2 * k + c] = v[2 * k + c] + self.bound[k] * eased;
            }
        }
    }

    /// Each cell on its own, on a bedding as stiff as the patch as a whole.
    fn precondition(&self, v: &mut [f64]) {
        for (k, response) in self.responses.iter().enumerate() {
            let [[xx, xy], [yx, yy]] = response.by_increment;
            let [ax, ay] = self.stand_in.map(|a| a * self.bound[k]);
            let matrix = [[1.0 + xx * ax, xy * ay], [yx * ax, 1.0 + yy * ay]];
            let solved = solve_2x2(matrix, [v[2 * k], v[2 * k + 1]]);
            v[2 * k..2 * k + 2].copy_from_slice(&solved);
        }
    }

    /// Forward–backward splitting (Lions and Mercier 1979) of 0 = A p − D + law⁻¹(p): a forward
    /// step on the linear part, then for each cell the sliding s with μ pₙ law(s) + γ s = p + γ (D − A p).
    fn safe_step(&mut self, p: &mut [f64], u: &[f64]) {
        let norm = self.contact.norm();
        if norm == 0.0 {
            return;
        }
        let gamma = norm.recip();
        for k in 0..self.slides.len() {
            let prescribed = [self.prescribed[2 * k], self.prescribed[2 * k + 1]];
            let forward: [f64; 2] =
                std::array::from_fn(|c| p[2 * k + c] + gamma * (prescribed[c] - u[2 * k + c]));
            self.backward(k, forward, gamma);
            for c in 0..2 {
                p[2 * k + c] = self.bound[k] * self.responses[k].traction[c];
            }
        }
    }
}

/// Newton steps of a cell on its own.
const CELL_ITERATIONS: usize = 60;

impl TimeStep<'_> {
    /// Finds the sliding s of cell `k` with μ pₙ law(s) + γ s = `target`; its response stays behind.
    fn backward(&mut self, k: usize, target: [f64; 2], gamma: f64) {
        let bound = self.bound[k];
        let mut s = self.slides[k].increment;
        let excess = |this: &mut Self, s: [f64; 2]| -> [f64; 2] {
            this.respond(k, s);
            let q = this.responses[k].traction;
            std::array::from_fn(|c| bound * q[c] + gamma * s[c] - target[c])
        };
        let mut rest = excess(self, s);
        let enough = 1e-12 * (bound + target[0].hypot(target[1]));
        for _ in 0..CELL_ITERATIONS {
            let length = rest[0].hypot(rest[1]);
            if length <= enough {
                return;
            }
            let [[xx, xy], [yx, yy]] = self.responses[k].by_increment.map(|r| r.map(|d| bound * d));
            let step = solve_2x2([[gamma + xx, xy], [yx, gamma + yy]], rest);
            let mut fraction = 1.0;
            loop {
                let trial: [f64; 2] = std::array::from_fn(|c| s[c] - fraction * step[c]);
                let trial_rest = excess(self, trial);
                if trial_rest[0].hypot(trial_rest[1]) < length || fraction < 1e-6 {
                    (s, rest) = (trial, trial_rest);
                    break;
                }
                fraction *= 0.5;
            }
        }
    }
}

/// Solution of a 2 × 2 system.
fn solve_2x2(matrix: [[f64; 2]; 2], right: [f64; 2]) -> [f64; 2] {
    let [[a, b], [c, d]] = matrix;
    let determinant = a * d - b * c;
    [(d * right[0] - b * right[1]) / determinant, (a * right[1] - c * right[0]) / determinant]
}
