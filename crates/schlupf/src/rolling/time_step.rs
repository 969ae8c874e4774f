//! One time step: the material moves on by a cell and finds a new equilibrium, Eqs. (8), (13)–(16).
//!
//! A stiff contact law makes p − μ pₙ law(D − A p) nearly discontinuous, and Newton's method slow.
//! So the equation is put differently: with any γ > 0, p solves it exactly when
//!
//! F(p) = p − μ pₙ law(s) = 0,  where s solves  μ pₙ law(s) + γ s = p + γ (D − A p)
//!
//! for each cell on its own. The law appears only together with γ s, and F stays smooth from the
//! softest law to Coulomb's. With γ ≤ 1/‖A‖ the step p ← p − F(p) is a forward–backward splitting
//! (Lions and Mercier 1979) of 0 = A p − D + law⁻¹(p), which never leads away from the solution.

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
    /// History of each cell; the increment is that of the last evaluation.
    pub slides: Vec<Slide>,
    /// Answer of each cell at the last evaluation.
    pub responses: Vec<Response>,
    /// s of each cell.
    sliding: Vec<[f64; 2]>,
    /// ∂(μ pₙ law)/∂(p + γ (D − A p)) of each cell.
    yielding: Vec<[[f64; 2]; 2]>,
    /// γ, in Pa/m.
    gamma: f64,
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
    ) -> Self {
        let cells = slides.len();
        let (gamma, stand_in) = (contact.safe_stiffness(), contact.stand_in());
        Self {
            contact,
            law,
            bound,
            prescribed,
            slides,
            responses: vec![Response::default(); cells],
            sliding: vec![[0.0; 2]; cells],
            yielding: vec![[[0.0; 2]; 2]; cells],
            gamma,
            stand_in,
        }
    }

    /// Solves for the traction on the rail p, from the given one.
    pub fn solve(&mut self, p: &mut [f64], limits: &Limits) -> Outcome {
        equilibrium::solve(self, p, limits)
    }

    fn respond(&mut self, k: usize, increment: [f64; 2]) -> [f64; 2] {
        self.slides[k].increment = increment;
        self.responses[k] = self.law.respond(&self.slides[k]);
        self.responses[k].traction.map(|q| self.bound[k] * q)
    }

    /// μ pₙ law(s) + γ s − target.
    fn excess(&mut self, k: usize, s: [f64; 2], target: [f64; 2]) -> [f64; 2] {
        let traction = self.respond(k, s);
        [0, 1].map(|c| traction[c] + self.gamma * s[c] - target[c])
    }

    /// ∂(μ pₙ law)/∂s + γ at the last evaluation.
    fn local_stiffness(&self, k: usize) -> [[f64; 2]; 2] {
        let [[xx, xy], [yx, yy]] =
            self.responses[k].by_increment.map(|r| r.map(|d| self.bound[k] * d));
        [[xx + self.gamma, xy], [yx, yy + self.gamma]]
    }

    /// The sliding s of a cell with μ pₙ law(s) + γ s = `target`: Newton's method with a line
    /// search. The equation is strongly monotone, so there is one.
    fn slide_locally(&mut self, k: usize, target: [f64; 2]) {
        let (mut s, mut rest) = self.first_guess(k, target);
        let enough = ROUNDING * (self.bound[k] + target[0].hypot(target[1]));
        for _ in 0..CELL_ITERATIONS {
            let length = rest[0].hypot(rest[1]);
            if length <= enough {
                break;
            }
            let step = solve_2x2(self.local_stiffness(k), rest);
            let mut fraction = 1.0;
            loop {
                let trial = [0, 1].map(|c| s[c] - fraction * step[c]);
                let trial_rest = self.excess(k, trial, target);
                if trial_rest[0].hypot(trial_rest[1]) < length || fraction < SHORTEST {
                    (s, rest) = (trial, trial_rest);
                    break;
                }
                fraction *= 0.5;
            }
        }
        self.sliding[k] = s;
    }

    /// The better of where the cell slid last and where it would with Coulomb friction.
    fn first_guess(&mut self, k: usize, target: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let length = target[0].hypot(target[1]);
        let share = if length > self.bound[k] { 1.0 - self.bound[k] / length } else { 0.0 };
        let coulomb = target.map(|t| share * t / self.gamma);
        let of_coulomb = self.excess(k, coulomb, target);
        let last = self.sliding[k];
        let of_last = self.excess(k, last, target);
        if of_last[0].hypot(of_last[1]) <= of_coulomb[0].hypot(of_coulomb[1]) {
            (last, of_last)
        } else {
            (coulomb, self.excess(k, coulomb, target))
        }
    }
}

/// Newton steps of a cell on its own.
const CELL_ITERATIONS: usize = 100;

/// Shortest part of such a step that is tried.
const SHORTEST: f64 = 1e-9;

/// Relative accuracy of a cell on its own.
const ROUNDING: f64 = 1e-15;

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

    fn defect(&mut self, p: &[f64], u: &[f64]) -> f64 {
        let mut squares = 0.0;
        for k in 0..self.slides.len() {
            let increment = [0, 1].map(|c| self.prescribed[2 * k + c] - u[2 * k + c]);
            let traction = self.respond(k, increment);
            squares += (p[2 * k] - traction[0]).powi(2) + (p[2 * k + 1] - traction[1]).powi(2);
        }
        squares.sqrt()
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        for k in 0..self.slides.len() {
            let increment = [0, 1].map(|c| self.prescribed[2 * k + c] - u[2 * k + c]);
            let target = [0, 1].map(|c| p[2 * k + c] + self.gamma * increment[c]);
            self.slide_locally(k, target);
            for c in 0..2 {
                residual[2 * k + c] = p[2 * k + c] - self.bound[k] * self.responses[k].traction[c];
            }
            // ∂(μ pₙ law)/∂target = I − γ (∂(μ pₙ law)/∂s + γ)⁻¹
            let inverse = inverse_2x2(self.local_stiffness(k));
            self.yielding[k] = [
                [1.0 - self.gamma * inverse[0][0], -self.gamma * inverse[0][1]],
                [-self.gamma * inverse[1][0], 1.0 - self.gamma * inverse[1][1]],
            ];
        }
    }

    fn tangent_product(&self, v: &[f64], compliance_v: &[f64], product: &mut [f64]) {
        for (k, yielding) in self.yielding.iter().enumerate() {
            let target = [0, 1].map(|c| v[2 * k + c] - self.gamma * compliance_v[2 * k + c]);
            for (c, row) in yielding.iter().enumerate() {
                product[2 * k + c] = v[2 * k + c] - row[0] * target[0] - row[1] * target[1];
            }
        }
    }

    /// Each cell on its own, on a bedding as stiff as the patch as a whole.
    fn precondition(&self, v: &mut [f64]) {
        let [wx, wy] = self.stand_in.map(|a| 1.0 - self.gamma * a);
        for (k, [[xx, xy], [yx, yy]]) in self.yielding.iter().enumerate() {
            let matrix = [[1.0 - xx * wx, -xy * wy], [-yx * wx, 1.0 - yy * wy]];
            let solved = solve_2x2(matrix, [v[2 * k], v[2 * k + 1]]);
            v[2 * k..2 * k + 2].copy_from_slice(&solved);
        }
    }
}

fn inverse_2x2(matrix: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [[a, b], [c, d]] = matrix;
    let determinant = a * d - b * c;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

fn solve_2x2(matrix: [[f64; 2]; 2], right: [f64; 2]) -> [f64; 2] {
    inverse_2x2(matrix).map(|row| row[0] * right[0] + row[1] * right[1])
}
