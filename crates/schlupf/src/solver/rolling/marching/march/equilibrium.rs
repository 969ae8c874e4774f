//! The equilibrium of a time step.

use crate::numerics::vector::{add_scaled, norm};
use crate::problem::Element;
use crate::reporting::{Error, Watch, within};
use crate::solver::equilibrium::{Limits, Outcome, measure};
use crate::solver::rolling::marching::arrival::{Arrival, places_passed, rigid_slip};
use crate::solver::rolling::marching::change::relative_change;
use crate::solver::rolling::marching::force_control::ForceControl;
use crate::solver::rolling::marching::moved::Moved;
use crate::solver::rolling::marching::step::Step;
use crate::solver::rolling::marching::step_response::Prescribed;
use crate::solver::rolling::marching::time_step::Track;
use crate::solver::summary;

use super::March;

impl March<'_> {
    /// The equilibrium at the end of the step, with the creepages that prescribed forces cause.
    pub(super) fn find_equilibrium(
        &mut self,
        arrivals: &[Arrival],
        watch: Watch,
    ) -> Result<(), Error> {
        let bound = self.now.bound(&self.contact.patch);
        let old_traction = self.now.traction.clone();
        add_scaled(&mut self.now.traction, 1.0, &self.trend);
        self.outcome = Outcome::default();
        let mut control = self.control.take();
        let (time, load) = (self.time, self.contact.normal.load);
        if let Some(control) = &mut control {
            control.begin(self.history, time);
        }
        let moved = loop {
            if let Some(control) = &control {
                self.now.over_step = control.motion(&self.now.over_step);
                self.now.kinematics = control.motion(&self.now.kinematics);
                self.now.conduction = self.problem.interface.conduction(&self.now.over_step);
            }
            let starts_elsewhere = self.now.traction != old_traction;
            let mut moved = self.balance(arrivals, &bound, watch)?;
            if !self.outcome.converged && starts_elsewhere {
                // Once more from the tractions before the step.
                self.now.traction.clone_from(&old_traction);
                moved = self.balance(arrivals, &bound, watch)?;
            }
            let Some(control) = &mut control else { break moved };
            let force = summary::resultant(&self.contact.patch, &self.now.traction);
            let accuracy = (self.options.tolerance, norm(&bound), norm(&self.now.traction));
            if control.is_reached((&force, load), accuracy) {
                self.outcome.residual = self.outcome.residual.max(control.missing);
                break moved;
            }
        };
        let missed = control.as_ref().and_then(ForceControl::missed);
        self.missed = self.missed.or(missed.map(|force| (force, time)));
        self.control = control;
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
        self.trend.clone_from(&self.now.traction);
        add_scaled(&mut self.trend, -1.0, &old_traction);
        if !self.outcome.converged || missed.is_some() || self.change <= self.options.tolerance {
            self.trend.fill(0.0);
        }
        self.elements = moved.iter().enumerate().map(element).collect();
        self.past = self.record();
        self.moved = moved;
        Ok(())
    }

    /// Newton–Raphson on Eq. (13).
    fn balance(
        &mut self,
        arrivals: &[Arrival],
        bound: &[f64],
        watch: Watch,
    ) -> Result<Vec<Moved>, Error> {
        let (limits, watch) = (self.limits(), within(watch, self.progress()));
        let prescribed = self.prescribed(arrivals);
        let motions = [&self.motion_before, &self.now.over_step];
        let places = places_passed(&self.contact.patch, arrivals, motions);
        let step = Step {
            contact: &mut self.contact,
            law: &mut self.law,
            bound,
            prescribed,
            tracks: arrivals.iter().zip(places).map(Track::of).collect(),
            largest: self.largest_traction,
        };
        let traction = &mut self.now.traction;
        let (outcome, moved) = step.solve(&mut self.newton, traction, &limits, &watch)?;
        let Outcome { iterations, products, .. } = self.outcome;
        self.outcome = Outcome {
            iterations: iterations + outcome.iterations,
            products: products + outcome.products,
            ..outcome
        };
        Ok(moved)
    }

    /// What is known of a step when the elements have arrived.
    fn prescribed(&self, arrivals: &[Arrival]) -> Prescribed {
        let mut prescribed = Prescribed::default();
        for (cell, arrival) in self.contact.patch.cells.iter().zip(arrivals) {
            let rigid = rigid_slip(cell, arrival.path, &self.now.over_step);
            prescribed.sliding.extend((0..2).map(|c| rigid[c] + arrival.displacement[c]));
            prescribed.in_contact.push(arrival.in_contact);
            prescribed.in_place.push(arrival.in_place);
        }
        prescribed
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

    /// A p of the present traction, on the whole grid and in the cells.
    pub(super) fn displace(&mut self) {
        let made = self.contact.product(&self.now.traction);
        made.at_cells(&mut self.now.displacement);
        self.now.stored_energy = made.stored_energy();
        self.displacement.clone_from(made.field());
        self.displacement_of_bodies.clone_from(made.field_of_bodies());
        self.work.operator_products += 1.0;
    }
}
