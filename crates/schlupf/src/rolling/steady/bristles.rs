//! A contact law with bristles along the strips of a patch, starting from the leading edge.
//!
//! With b = B p the change of A p, relative to that at the leading edge, from cell to cell, and D
//! the rigid slip along the path, every cell slides by D − b, and the contact law continues the
//! traction of its upstream neighbour. As in a time step the law is evaluated together with γ s
//! (see `rolling/marching/time_step.rs`), here from cell to cell down the strip.

use std::sync::Arc;

use crate::interface::contact_law::{ContactLaw, Response, Slide};
use crate::patch::{Cell, Patch};
use crate::problem::Problem;
use crate::rolling::shared::cell::{CellSolver, inverse_2x2, times};
use crate::rolling::shared::turn::{Way, with_turn};
use crate::state::Element;

use super::steady_friction::SteadyFriction;
use super::strip_law::{Cause, Changed, StripLaw};

/// The contact law of a patch in steady rolling, and its tangent at the last residual.
pub(super) struct Bristles {
    law: Arc<dyn ContactLaw>,
    gamma: f64,
    /// μ pₙ of each cell, in Pa.
    bound: Vec<f64>,
    ways: Vec<Way>,
    /// Whether a cell is the first of its strip.
    is_first: Vec<bool>,
    /// Slide and response of each cell at the last residual, and p + γ (D − b) there, in Pa.
    slides: Vec<Slide>,
    targets: Vec<[f64; 2]>,
    responses: Vec<Response>,
    tangents: Vec<Tangent>,
    /// Whether the law depends on the distance since entry.
    remembers_distance: bool,
    /// Changes of the heat flux of each cell during a pass of the preconditioner down the strips.
    flux_changes: Vec<f64>,
}

/// Derivatives of a cell at the last residual, in the order in which a pass down the strip needs
/// them.
#[derive(Clone, Copy, Default)]
struct Tangent {
    /// ∂law/∂(previous traction), dimensionless.
    kept: f64,
    /// ∂law/∂(increment of the upstream neighbour) through the turn, in 1/m.
    by_upstream: Matrix,
    /// (∂(μ pₙ law)/∂s + γ)⁻¹, in m/Pa.
    softness: Matrix,
    /// ∂law/∂s (∂(μ pₙ law)/∂s + γ)⁻¹, in 1/Pa.
    yielding: Matrix,
}

type Matrix = [[f64; 2]; 2];

/// State that a cell passes on to the next one downstream.
#[derive(Clone, Copy, Default)]
struct Handed {
    traction: [f64; 2],
    distance: [f64; 2],
    increment: [f64; 2],
}

impl Handed {
    /// State that a cell passes on after it has slid.
    fn after(slide: &Slide, response: &Response) -> Self {
        Self {
            traction: response.traction,
            distance: [0, 1].map(|c| slide.distance[c] + slide.increment[c]),
            increment: slide.increment,
        }
    }

    /// The difference from the state passed on before.
    fn since(&self, before: &Self) -> Self {
        let difference = |now: [f64; 2], then: [f64; 2]| [now[0] - then[0], now[1] - then[1]];
        Self {
            traction: difference(self.traction, before.traction),
            distance: difference(self.distance, before.distance),
            increment: difference(self.increment, before.increment),
        }
    }

    /// The state passed on when this one is received, and the traction and the sliding change
    /// slightly.
    #[inline]
    fn changed(&self, traction: [f64; 2], increment: [f64; 2]) -> Self {
        let distance = [self.distance[0] + increment[0], self.distance[1] + increment[1]];
        Self { traction, distance, increment }
    }
}

impl Bristles {
    /// The strips of a patch; [`Self::set_problem`] sets motion and laws.
    pub fn new(problem: &Problem, patch: &Patch) -> Self {
        let cells = patch.len();
        let mut is_first = vec![false; cells];
        for strip in &patch.strips {
            is_first[strip.cells.start] = true;
        }
        Self {
            law: Arc::clone(&problem.contact_law),
            gamma: 0.0,
            bound: vec![0.0; cells],
            ways: Vec::with_capacity(cells),
            is_first,
            slides: vec![Slide::default(); cells],
            targets: vec![[0.0; 2]; cells],
            responses: vec![Response::default(); cells],
            tangents: vec![Tangent::default(); cells],
            remembers_distance: false,
            flux_changes: vec![0.0; cells],
        }
    }

    /// The history of a cell from the state passed on by its upstream neighbour.
    fn slide(&self, k: usize, handed: &Handed) -> Slide {
        let slide =
            Slide { traction: handed.traction, distance: handed.distance, ..Slide::default() };
        let upstream = (!self.is_first[k]).then(|| {
            let before = &self.ways[k - 1];
            let stretch = [0, 1].map(|c| (handed.increment[c] - before.rigid[c]) / before.distance);
            (before.distance, stretch)
        });
        with_turn(slide, &self.ways[k], upstream)
    }

    /// Lets every cell slide by D − b, and passes on each slide and the law's response.
    fn follow(&self, b: &[f64], mut visit: impl FnMut(usize, &Slide, &Response)) {
        let mut handed = Handed::default();
        for k in 0..self.len() {
            if self.is_first[k] {
                handed = Handed::default();
            }
            let increment = [0, 1].map(|c| self.ways[k].rigid[c] - b[2 * k + c]);
            let slide = Slide { increment, ..self.slide(k, &handed) };
            let response = self.law.respond(&slide);
            visit(k, &slide, &response);
            handed = Handed::after(&slide, &response);
        }
    }

    /// Sliding of a cell, to first order, when its target and the state passed to it differ from
    /// those of the last residual.
    fn predicted(&self, k: usize, target: [f64; 2], change: &Handed) -> [f64; 2] {
        let gain = self.gain(k, change);
        let rest = [0, 1].map(|c| target[c] - self.targets[k][c] - self.bound[k] * gain[c]);
        let more = times(&self.tangents[k].softness, rest);
        [0, 1].map(|c| self.slides[k].increment[c] + more[c])
    }

    fn tangent_of(&self, k: usize, slide: &Slide, response: &Response) -> Tangent {
        let cell = CellSolver { law: self.law.as_ref(), gamma: self.gamma };
        let softness = inverse_2x2(cell.stiffness(response, self.bound[k]));
        let share = slide.turn_by_increment;
        let ratio = if share == 0.0 {
            0.0
        } else {
            share * self.ways[k].distance / self.ways[k - 1].distance
        };
        Tangent {
            kept: response.by_traction,
            by_upstream: response.by_turn.map(|row| row.map(|by_turn| -ratio * by_turn)),
            softness,
            yielding: product_2x2(&response.by_increment, &softness),
        }
    }

    /// Change of a cell's traction due to small changes of the state passed to it, dimensionless.
    #[inline]
    fn gain(&self, k: usize, handed: &Handed) -> [f64; 2] {
        let tangent = &self.tangents[k];
        let turned = times(&tangent.by_upstream, handed.increment);
        let gain = [
            tangent.kept * handed.traction[0] + turned[0],
            tangent.kept * handed.traction[1] + turned[1],
        ];
        if !self.remembers_distance {
            return gain;
        }
        let come = times(&self.responses[k].by_distance, handed.distance);
        [gain[0] + come[0], gain[1] + come[1]]
    }

    /// Change of a cell's traction due to a cause at given sliding, dimensionless.
    fn gain_from(&self, k: usize, cause: &Cause) -> [f64; 2] {
        let (slide, response) = (&self.slides[k], &self.responses[k]);
        let pair = |values: &[f64], k: usize| [values[2 * k], values[2 * k + 1]];
        let mut turn = pair(&cause.turn, k);
        let share = slide.turn_by_increment;
        if share != 0.0 {
            let ratio = self.ways[k].distance / self.ways[k - 1].distance;
            let (here, before) = (pair(&cause.rigid, k), pair(&cause.rigid, k - 1));
            turn = [0, 1].map(|c| turn[c] - share * (here[c] - ratio * before[c]));
        }
        // The law depends on k_c times lengths, so a stiffer law is equivalent to longer lengths.
        let longer = [0, 1].map(|c| turn[c] + cause.stiffness * slide.turn[c]);
        let turned = times(&response.by_turn, longer);
        let slid = times(&response.by_increment, slide.increment);
        let come = times(&response.by_distance, slide.distance);
        [0, 1].map(|c| turned[c] + cause.stiffness * (slid[c] + come[c]))
    }

    /// Changes of the traction over μ pₙ and of the increment of a cell on which `pull` acts (in
    /// Pa) in addition to the gain.
    #[inline]
    fn moved(&self, k: usize, pull: [f64; 2], gain: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let (tangent, bound) = (&self.tangents[k], self.bound[k]);
        let rest = [pull[0] - bound * gain[0], pull[1] - bound * gain[1]];
        let grown = times(&tangent.yielding, rest);
        ([grown[0] + gain[0], grown[1] + gain[1]], times(&tangent.softness, rest))
    }
}

impl StripLaw for Bristles {
    fn set_problem(&mut self, problem: &Problem, patch: &Patch, gamma: f64) {
        self.gamma = gamma;
        self.law = Arc::clone(&problem.contact_law);
        self.remembers_distance = self.law.respond(&Slide::default()).by_distance != [[0.0; 2]; 2];
        let way = |cell: &Cell| Way {
            distance: cell.path_in.distance,
            rigid: cell.rigid_slip_in(&problem.kinematics),
            turn: cell.half_turn(&problem.kinematics, cell.path_in.distance),
        };
        self.ways.clear();
        self.ways.extend(patch.cells.iter().map(way));
    }

    fn bound(&self) -> &[f64] {
        &self.bound
    }

    fn set_bound(&mut self, cells: &[Cell], coefficient: &[f64]) {
        for (bound, (cell, coefficient)) in self.bound.iter_mut().zip(cells.iter().zip(coefficient))
        {
            *bound = coefficient * cell.pressure;
        }
    }

    fn relate(&self, _p: &[f64], b: &mut [f64]) {
        for k in (0..self.len()).rev() {
            if !self.is_first[k] {
                b[2 * k] -= b[2 * k - 2];
                b[2 * k + 1] -= b[2 * k - 1];
            }
        }
    }

    fn rigid_saturation(&self) -> Vec<[f64; 2]> {
        let mut saturation = Vec::with_capacity(self.len());
        let nothing = vec![0.0; 2 * self.len()];
        self.follow(&nothing, |_, _, response| saturation.push(response.traction));
        saturation
    }

    /// ‖p − μ pₙ law(D − b)‖₂, in Pa.
    fn defect(&self, p: &[f64], b: &[f64]) -> f64 {
        let mut squares = 0.0;
        self.follow(b, |k, _, response| {
            for c in 0..2 {
                squares += (p[2 * k + c] - self.bound[k] * response.traction[c]).powi(2);
            }
        });
        squares.sqrt()
    }

    /// F(p) = p − μ pₙ law(s) with μ pₙ law(s) + γ s = p + γ (D − b), in Pa.
    fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]) {
        let law = Arc::clone(&self.law);
        let cell = CellSolver { law: law.as_ref(), gamma: self.gamma };
        let mut handed = Handed::default();
        let mut change = Handed::default();
        for k in 0..self.len() {
            if self.is_first[k] {
                (handed, change) = (Handed::default(), Handed::default());
            }
            let target =
                [0, 1].map(|c| p[2 * k + c] + self.gamma * (self.ways[k].rigid[c] - b[2 * k + c]));
            let before = (self.slides[k], self.responses[k]);
            let increment = self.predicted(k, target, &change);
            let mut slide = Slide { increment, ..self.slide(k, &handed) };
            let response = cell.solve(&mut slide, self.bound[k], target);
            self.tangents[k] = self.tangent_of(k, &slide, &response);
            handed = Handed::after(&slide, &response);
            change = handed.since(&Handed::after(&before.0, &before.1));
            self.slides[k] = slide;
            self.targets[k] = target;
            self.responses[k] = response;
            for c in 0..2 {
                residual[2 * k + c] = p[2 * k + c] - self.bound[k] * response.traction[c];
            }
        }
    }

    fn tangent(&self, change: &Changed, cause: Option<&Cause>, product: &mut [f64]) {
        let Changed { traction: p, response: b, bound } = *change;
        let mut handed = Handed::default();
        for k in 0..self.len() {
            if self.is_first[k] {
                handed = Handed::default();
            }
            let response = &self.responses[k];
            let mut gain = self.gain(k, &handed);
            let raised = bound.map_or(0.0, |bound| bound[k]);
            let mut rest = [0, 1]
                .map(|c| p[2 * k + c] - self.gamma * b[2 * k + c] - raised * response.traction[c]);
            if let Some(cause) = cause {
                let more = self.gain_from(k, cause);
                gain = [0, 1].map(|c| gain[c] + more[c]);
                rest = [0, 1].map(|c| rest[c] + self.gamma * cause.rigid[2 * k + c]);
            }
            let (traction, increment) = self.moved(k, rest, gain);
            handed = handed.changed(traction, increment);
            for c in 0..2 {
                product[2 * k + c] =
                    p[2 * k + c] - raised * response.traction[c] - self.bound[k] * traction[c];
            }
        }
    }

    /// With B replaced by 1/γ times the difference to the upstream neighbour, the Jacobian is
    /// triangular: one pass down every strip. If `friction` depends on the heat from upstream, this
    /// is included.
    fn precondition(&mut self, v: &mut [f64], friction: Option<&SteadyFriction>) {
        let mut handed = Handed::default();
        let mut upstream = [0.0; 2];
        for k in 0..self.len() {
            if self.is_first[k] {
                handed = Handed::default();
                upstream = [0.0; 2];
            }
            let gain = self.gain(k, &handed);
            let arrived = upstream;
            let (mut traction, mut increment) = self.moved(k, arrived, gain);
            let bound = self.bound[k];
            upstream = [v[2 * k] + bound * traction[0], v[2 * k + 1] + bound * traction[1]];
            if let Some(friction) = friction {
                // An increase of the bound changes the traction by γ (∂(μ pₙ law)/∂s + γ)⁻¹ law per
                // Pa.
                let law = self.responses[k].traction;
                let by_bound = times(&self.tangents[k].softness, law).map(|t| self.gamma * t);
                let raised = friction.raised_bound(k, &self.flux_changes, upstream, by_bound);
                upstream = [0, 1].map(|c| upstream[c] + raised * by_bound[c]);
                let rest = [0, 1].map(|c| arrived[c] - raised * law[c]);
                (traction, increment) = self.moved(k, rest, gain);
                self.flux_changes[k] = friction.flux_change(k, upstream);
            }
            handed = handed.changed(traction, increment);
            v[2 * k..2 * k + 2].copy_from_slice(&upstream);
        }
    }

    fn elements(&self, patch: &Patch, p: &[f64], b: &[f64], _relative: &[f64]) -> Vec<Element> {
        let mut elements = Vec::with_capacity(self.len());
        self.follow(b, |k, slide, response| {
            let way = &self.ways[k];
            elements.push(Element {
                index: patch.cells[k].index,
                traction: [p[2 * k], p[2 * k + 1]],
                saturation: response.traction,
                sliding: [0, 1].map(|c| slide.distance[c] + slide.increment[c]),
                stretch: [0, 1].map(|c| (slide.increment[c] - way.rigid[c]) / way.distance),
                ..Element::default()
            });
        });
        elements
    }
}

fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}
