//! The equilibrium of a time step.

use crate::numerics::vector::{add_scaled, norm};
use crate::problem::{Element, Places};
use crate::reporting::{Error, Watch, within};
use crate::solver::equilibrium::{Limits, Outcome, measure};
use crate::solver::prescribed::ForceGoal;
use crate::solver::rolling::marching::arrival::{Arrival, places_passed};
use crate::solver::rolling::marching::change::relative_change;
use crate::solver::rolling::marching::forces_over_time::Start;
use crate::solver::rolling::marching::moved::Moved;
use crate::solver::rolling::marching::step::Step;
use crate::solver::rolling::marching::step_response::Known;
use crate::solver::rolling::marching::time_step::Track;
use crate::solver::summary;

use super::March;

impl March<'_> {
    /// The equilibrium at the end of a step of rolling, or of a shift, with the creepages that
    /// prescribed forces cause.
    pub(super) fn find_equilibrium(
        &mut self,
        arrivals: &[Arrival],
        is_at_rest: bool,
        watch: Watch,
    ) -> Result<(), Error> {
        let bound = self.now.bound(&self.contact.patch);
        let old_traction = self.now.traction.clone();
        self.outcome = Outcome::default();
        let mut forces = std::mem::take(&mut self.forces);
        forces.begin(&self.history, self.place, self.contact.normal.load);
        let mut moved = Vec::new();
        let mut is_missed = false;
        let mut tried = None;
        for Start { motion, goal, goes_on } in forces.starts(&self.now.over_step) {
            let mut traction = old_traction.clone();
            if goes_on {
                add_scaled(&mut traction, 1.0, &self.trend);
            }
            let start = Some((traction.clone(), motion, goal.is_none()));
            if tried == start {
                continue;
            }
            tried = start;
            (self.now.traction, self.now.over_step) = (traction, motion);
            let known = Known::of(arrivals, is_at_rest);
            moved = self.balance((arrivals, &known), (&bound, &goal), watch)?;
            is_missed = goal.is_none() && !forces.goal.is_none();
            if self.outcome.converged {
                break;
            }
        }
        let creepages = forces.goal.creepages(&self.now.over_step);
        self.now.kinematics = forces.goal.motion(&self.now.kinematics, creepages.as_slice());
        self.now.conduction = self.problem.interface.conduction(&self.now.over_step);
        self.displace();
        self.largest_traction = self.largest_traction.max(norm(&self.now.traction));
        let scale = measure(norm(&bound), self.largest_traction);
        self.change = relative_change(&old_traction, &self.now.traction, scale);
        let element = |(k, moved): (usize, &Moved)| Element {
            index: self.contact.patch.cells[k].index,
            traction: self.now.traction_at(k),
            saturation: moved.saturation,
            sliding: moved.sliding,
            track: moved.track,
            ..Element::default()
        };
        let goes_on = self.outcome.converged && !is_missed && self.change > self.options.tolerance;
        self.trend.fill(0.0);
        if goes_on {
            self.trend.clone_from(&self.now.traction);
            add_scaled(&mut self.trend, -1.0, &old_traction);
        }
        if is_missed {
            let force = summary::resultant(&self.contact.patch, &self.now.traction);
            let missing = forces.goal.forces(&force).map(|has| (has - &forces.goal.target).norm());
            self.outcome.residual = self.outcome.residual.max(missing.unwrap_or(0.0));
            let quantity = forces.goal.prescribed().first();
            self.missed = self.missed.or(quantity.map(|force| (force, self.time)));
        }
        forces.note(&self.now.over_step, (is_missed, goes_on));
        self.forces = forces;
        self.elements = moved.iter().enumerate().map(element).collect();
        self.past = self.record();
        self.moved = moved;
        Ok(())
    }

    /// Newton–Raphson on Eq. (13).
    fn balance(
        &mut self,
        (arrivals, known): (&[Arrival], &Known),
        (bound, goal): (&[f64], &ForceGoal),
        watch: Watch,
    ) -> Result<Vec<Moved>, Error> {
        let places = self.places(arrivals);
        let moved = self.step((arrivals, known), &places, (bound, goal), watch)?;
        let found = self.places(arrivals);
        let is_same = places.iter().map(|of| of.len()).eq(found.iter().map(|of| of.len()));
        if is_same || !self.outcome.converged {
            return Ok(moved);
        }
        // With the creepages that were found other places count.
        self.step((arrivals, known), &found, (bound, goal), watch)
    }

    /// The places of the material that count with the present motion.
    fn places(&self, arrivals: &[Arrival]) -> Vec<Places> {
        let motions = [&self.motion_before, &self.now.over_step];
        places_passed(&self.contact.patch, arrivals, motions)
    }

    fn step(
        &mut self,
        (arrivals, known): (&[Arrival], &Known),
        places: &[Places],
        (bound, goal): (&[f64], &ForceGoal),
        watch: Watch,
    ) -> Result<Vec<Moved>, Error> {
        let (limits, watch) = (self.limits(), within(watch, self.progress()));
        let step = Step {
            contact: &mut self.contact,
            law: &mut self.law,
            bound,
            known,
            tracks: arrivals.iter().zip(places.iter().copied()).map(Track::of).collect(),
            largest: self.largest_traction,
        };
        let (goal, traction) = ((goal, &mut self.now.over_step), &mut self.now.traction);
        let (outcome, moved) = step.solve(&mut self.newton, traction, goal, (&limits, &watch))?;
        let Outcome { iterations, products, .. } = self.outcome;
        self.outcome = Outcome {
            iterations: iterations + outcome.iterations,
            products: products + outcome.products,
            ..outcome
        };
        Ok(moved)
    }

    pub(super) fn limits(&self) -> Limits {
        Limits {
            // Below the tolerance of the steady state, so that solver noise does not hide the end
            // of the transient.
            tolerance: 0.1 * self.options.tolerance,
            max_iterations: self.options.max_iterations,
            is_monotone: false,
        }
    }

    /// A p of the present traction and the displacement under the pressure, on the whole grid and
    /// in the cells.
    pub(super) fn displace(&mut self) {
        let made = self.contact.product(&self.now.traction);
        made.at_cells(&mut self.now.displacement);
        self.now.stored_energy = made.stored_energy();
        self.displacement.clone_from(made.field());
        self.displacement_of_bodies.clone_from(made.field_of_bodies());
        self.work.operator_products += 1.0;
        let contact = &self.contact;
        contact.add_pressed(&mut self.now.displacement);
        self.now.pressed_power =
            contact.pressed_power(&self.now.traction, self.now.kinematics.speed);
        if let Some(pressed) = &contact.pressed {
            for field in [&mut self.displacement, &mut self.displacement_of_bodies] {
                add_scaled(&mut field.x, 1.0, &pressed.x);
                add_scaled(&mut field.y, 1.0, &pressed.y);
            }
        }
    }
}
