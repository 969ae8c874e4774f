//! The steady state at once: an element's history is what lies upstream of it in its own strip.
//!
//! With b = B p the change of A p, relative to that at the leading edge, from cell to cell, and D the
//! rigid slip on the way, every cell slides by D − b, and the contact law carries the traction on from
//! its upstream neighbour. As in a time step the law is evaluated together with γ s
//! (see [`super::time_step`]), now from cell to cell down the strip.

use crate::equilibrium::{self, Equilibrium};
use crate::interface::contact_law::{ContactLaw, Response, Slide};
use crate::kinematics::Kinematics;
use crate::patch::Cell;
use crate::state::Element;

use super::cell::{CellSolver, inverse_2x2, times};
use super::contact::DiscreteContact;
use super::turn::{Way, with_turn};

/// The steady equilibrium of a patch.
pub(super) struct SteadyState<'a> {
    contact: &'a mut DiscreteContact,
    kinematics: Kinematics,
    cell: CellSolver<'a>,
    /// μ pₙ of each cell, in Pa.
    bound: Vec<f64>,
    ways: Vec<Way>,
    /// Whether a cell is the first of its strip.
    is_first: Vec<bool>,
    /// Slide and answer of each cell at the last evaluation.
    slides: Vec<Slide>,
    responses: Vec<Response>,
    /// s of each cell at the last residual.
    sliding: Vec<[f64; 2]>,
    /// (∂(μ pₙ law)/∂s + γ)⁻¹ of each cell at the last residual, in m/Pa.
    softness: Vec<[[f64; 2]; 2]>,
    at_entry: Vec<f64>,
}

/// What a cell hands on to the next one downstream.
#[derive(Clone, Copy, Default)]
struct Handed {
    traction: [f64; 2],
    distance: [f64; 2],
    increment: [f64; 2],
}

impl Handed {
    /// What is handed on when this is handed, and the traction and the sliding change a little.
    fn changed(&self, traction: [f64; 2], increment: [f64; 2]) -> Self {
        let distance = [0, 1].map(|c| self.distance[c] + increment[c]);
        Self { traction, distance, increment }
    }
}

impl<'a> SteadyState<'a> {
    pub fn new(
        contact: &'a mut DiscreteContact,
        law: &'a dyn ContactLaw,
        kinematics: Kinematics,
        bound: Vec<f64>,
    ) -> Self {
        let cells = contact.patch.len();
        let gamma = contact.cell_stiffness();
        let way = |cell: &Cell| Way {
            distance: cell.way_in.distance,
            rigid: cell.way_in.rigid_slip(&kinematics),
        };
        let ways = contact.patch.cells.iter().map(way).collect();
        let mut is_first = vec![false; cells];
        for strip in &contact.patch.strips {
            is_first[strip.cells.start] = true;
        }
        Self {
            contact,
            kinematics,
            cell: CellSolver { law, gamma },
            bound,
            ways,
            is_first,
            slides: vec![Slide::default(); cells],
            responses: vec![Response::default(); cells],
            sliding: vec![[0.0; 2]; cells],
            softness: vec![[[0.0; 2]; 2]; cells],
            at_entry: vec![0.0; 2 * cells],
        }
    }

    /// The elements of the steady state with the traction p, without their heat.
    pub fn elements(&self, p: &[f64]) -> Vec<Element> {
        let element = |(k, cell): (usize, &Cell)| {
            let (slide, way) = (&self.slides[k], &self.ways[k]);
            Element {
                index: cell.index,
                traction: [p[2 * k], p[2 * k + 1]],
                saturation: self.responses[k].traction,
                sliding: [0, 1].map(|c| slide.distance[c] + slide.increment[c]),
                stretch: [0, 1].map(|c| (slide.increment[c] - way.rigid[c]) / way.distance),
                ..Element::default()
            }
        };
        self.contact.patch.cells.iter().enumerate().map(element).collect()
    }

    /// The history of a cell from what its upstream neighbour hands on.
    fn slide(&self, k: usize, handed: &Handed) -> Slide {
        let slide =
            Slide { traction: handed.traction, distance: handed.distance, ..Slide::default() };
        let upstream = (!self.is_first[k]).then(|| {
            let before = &self.ways[k - 1];
            let stretch = [0, 1].map(|c| (handed.increment[c] - before.rigid[c]) / before.distance);
            (before.distance, stretch)
        });
        with_turn(slide, &self.kinematics, &self.ways[k], upstream)
    }

    /// What cell `k` hands on after the last evaluation.
    fn hand_on(&self, k: usize) -> Handed {
        let slide = &self.slides[k];
        Handed {
            traction: self.responses[k].traction,
            distance: [0, 1].map(|c| slide.distance[c] + slide.increment[c]),
            increment: slide.increment,
        }
    }

    /// What a cell's traction gains from small changes of what it was handed, dimensionless.
    fn gain(&self, k: usize, handed: &Handed) -> [f64; 2] {
        let response = &self.responses[k];
        let by_distance = times(&response.by_distance, handed.distance);
        let mut gain = [0, 1].map(|c| response.by_traction * handed.traction[c] + by_distance[c]);
        let share = self.slides[k].turn_by_increment;
        if share != 0.0 {
            let ratio = share * self.ways[k].distance / self.ways[k - 1].distance;
            let by_turn = times(&response.by_turn, handed.increment);
            gain = [0, 1].map(|c| gain[c] - ratio * by_turn[c]);
        }
        gain
    }
}

impl Equilibrium for SteadyState<'_> {
    fn size(&self) -> usize {
        2 * self.slides.len()
    }

    fn scale(&self) -> f64 {
        equilibrium::norm(&self.bound)
    }

    /// b = B p.
    fn compliance_product(&mut self, p: &[f64], b: &mut [f64]) {
        self.contact.product(p, b);
        self.contact.displacement_at_entries(&mut self.at_entry);
        equilibrium::add_scaled(b, -1.0, &self.at_entry);
        for k in (0..self.slides.len()).rev() {
            if !self.is_first[k] {
                b[2 * k] -= b[2 * k - 2];
                b[2 * k + 1] -= b[2 * k - 1];
            }
        }
    }

    fn defect(&mut self, p: &[f64], b: &[f64]) -> f64 {
        let mut squares = 0.0;
        let mut handed = Handed::default();
        for k in 0..self.slides.len() {
            if self.is_first[k] {
                handed = Handed::default();
            }
            let increment = [0, 1].map(|c| self.ways[k].rigid[c] - b[2 * k + c]);
            self.slides[k] = Slide { increment, ..self.slide(k, &handed) };
            self.responses[k] = self.cell.law.respond(&self.slides[k]);
            handed = self.hand_on(k);
            let traction = self.responses[k].traction.map(|q| self.bound[k] * q);
            squares += (p[2 * k] - traction[0]).powi(2) + (p[2 * k + 1] - traction[1]).powi(2);
        }
        squares.sqrt()
    }

    fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]) {
        let mut handed = Handed::default();
        for k in 0..self.slides.len() {
            if self.is_first[k] {
                handed = Handed::default();
            }
            let target = [0, 1]
                .map(|c| p[2 * k + c] + self.cell.gamma * (self.ways[k].rigid[c] - b[2 * k + c]));
            let mut slide = Slide { increment: self.sliding[k], ..self.slide(k, &handed) };
            let response = self.cell.solve(&mut slide, self.bound[k], target);
            self.sliding[k] = slide.increment;
            self.slides[k] = slide;
            self.responses[k] = response;
            self.softness[k] = inverse_2x2(self.cell.stiffness(&response, self.bound[k]));
            handed = self.hand_on(k);
            for c in 0..2 {
                residual[2 * k + c] = p[2 * k + c] - self.bound[k] * response.traction[c];
            }
        }
    }

    fn tangent_product(&self, v: &[f64], compliance_v: &[f64], product: &mut [f64]) {
        let mut handed = Handed::default();
        for k in 0..self.slides.len() {
            if self.is_first[k] {
                handed = Handed::default();
            }
            let gain = self.gain(k, &handed);
            let rest = [0, 1].map(|c| {
                v[2 * k + c] - self.cell.gamma * compliance_v[2 * k + c] - self.bound[k] * gain[c]
            });
            let increment = times(&self.softness[k], rest);
            let grown = times(&self.responses[k].by_increment, increment);
            let traction = [0, 1].map(|c| grown[c] + gain[c]);
            handed = handed.changed(traction, increment);
            for c in 0..2 {
                product[2 * k + c] = v[2 * k + c] - self.bound[k] * traction[c];
            }
        }
    }

    /// With B replaced by 1/γ times the difference to the upstream neighbour, the Jacobian is
    /// triangular: one pass down every strip.
    fn precondition(&self, v: &mut [f64]) {
        let mut handed = Handed::default();
        let mut upstream = [0.0; 2];
        for k in 0..self.slides.len() {
            if self.is_first[k] {
                handed = Handed::default();
                upstream = [0.0; 2];
            }
            let gain = self.gain(k, &handed);
            let rest = [0, 1].map(|c| upstream[c] - self.bound[k] * gain[c]);
            let increment = times(&self.softness[k], rest);
            let grown = times(&self.responses[k].by_increment, increment);
            let traction = [0, 1].map(|c| grown[c] + gain[c]);
            handed = handed.changed(traction, increment);
            upstream = [0, 1].map(|c| v[2 * k + c] + self.bound[k] * traction[c]);
            v[2 * k..2 * k + 2].copy_from_slice(&upstream);
        }
    }
}
