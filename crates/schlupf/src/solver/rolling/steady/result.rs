//! All results of a steady state that was found, and forces extrapolated from two grids.

use crate::problem::{Element, HeatRecord, Method, Options, Problem, State};
use crate::reporting::Warning;
use crate::solution::{Extrapolation, Resultant, Solution, Status, Work};
use crate::solver::equilibrium::Outcome;
use crate::solver::rolling::shared::passage::speed_of;
use crate::solver::rolling::shared::warnings::warnings;
use crate::solver::summary::snapshot::{Snapshot, View};
use crate::solver::summary::{self};

use super::level::Level;
use super::nested::NestedGrids;

impl Level {
    /// What the material at the cells carries on, with its displacement since it entered, in m.
    fn elements(&mut self, relative: &[f64], has_heat: bool) -> Vec<Element> {
        let Self { contact, strips, friction, traction, .. } = self;
        let mut elements = strips.elements(&contact.patch, traction, relative);
        for (k, element) in elements.iter_mut().enumerate() {
            element.slip_speed = speed_of(friction.slip[k]);
            element.scaled_rise = friction.scaled_rise[k];
            element.friction_on_leaving = friction.lag.on_leaving(k);
            element.plastic_displacement = friction.flowed_on_leaving(k);
        }
        for strip in contact.patch.strips.iter().filter(|_| has_heat) {
            let shared = friction.heat.records_on_leaving(strip);
            for (element, k) in elements[strip.cells.clone()].iter_mut().zip(1..) {
                element.heat = HeatRecord::without(strip.cells.len() - k, &shared);
            }
        }
        elements
    }
}

impl NestedGrids {
    /// All results.
    pub fn solution(
        &mut self,
        problem: &Problem,
        options: &Options,
        outcome: &Outcome,
        mut work: Work,
    ) -> Solution {
        let Level { contact, strips, friction, traction, response, .. } = &mut self.levels[0];
        let mut now = Snapshot::blank(problem.kinematics, friction.conduction, strips.len());
        now.traction.copy_from_slice(traction);
        let mut made = contact.product(traction);
        made.at_cells(&mut now.displacement);
        now.stored_energy = made.stored_energy();
        let mut relative = vec![0.0; traction.len()];
        made.at_entries(&mut relative);
        for (entry, u) in relative.iter_mut().zip(&now.displacement) {
            *entry = u - *entry;
        }
        let mut change = vec![0.0; traction.len()];
        made.change_in_passing(&mut change);
        contact.add_pressed(&mut now.displacement);
        now.pressed_power = contact.pressed_power(traction, problem.kinematics.speed);
        work.operator_products += 1.0;
        friction.evaluate(problem, &contact.patch, traction, &change);
        now.slip.copy_from_slice(&friction.slip);
        strips.take_slip(response, problem.kinematics.speed, &mut now.slip);
        now.friction_power.copy_from_slice(&friction.power);
        now.scaled_rise.copy_from_slice(&friction.scaled_rise);
        now.friction.copy_from_slice(friction.coefficients());
        strips.complete_friction(&mut now.friction);
        let has_heat = problem.interface.heat.model.is_some();
        let elements = options.keeps_state.then(|| self.levels[0].elements(&relative, has_heat));
        let Level { contact, friction, .. } = &mut self.levels[0];
        let exits = contact.patch.strips.iter().map(|strip| friction.heat.scaled_exit_rise(strip));
        now.scaled_exit_rise = exits.collect();
        now.surfaces = friction.surfaces(&contact.patch);
        let is_found =
            outcome.converged && now.surfaces.as_ref().is_none_or(|surfaces| surfaces.is_found);
        let mut warnings = warnings(problem, options, &mut self.levels[0].contact, &now);
        let forces = summary::force(&self.levels[0].contact.patch, &now);
        let extrapolation = if options.extrapolate && is_found {
            self.extrapolated(problem, &forces)
        } else {
            None
        };
        if options.extrapolate && is_found && extrapolation.is_none() {
            warnings.push(Warning::NoExtrapolation {});
        }
        let Level { contact, .. } = &self.levels[0];
        let view = View { normal: &contact.normal, patch: &contact.patch, now: &now };
        let whole = Outcome { iterations: work.newton_iterations, ..*outcome };
        let account = summary::SolverReport {
            method: Method::Full,
            status: if is_found { Status::Converged } else { Status::NotConverged },
            residual: outcome.residual,
            history: vec![summary::instant(view, [0.0; 2], &whole)],
            field_history: Vec::new(),
            warnings,
            sensitivity: None,
            work,
            state: State {
                grid: contact.patch.grid,
                time: 0.0,
                elements: elements.unwrap_or_default(),
                motion: Some(problem.kinematics),
            },
        };
        let solution = summary::solution(problem, options, view, account);
        Solution { extrapolation, ..solution }
    }

    /// Forces for cells of no size, from those on the finest grid and on the next coarser one, if
    /// there is one that is coarser in both directions.
    fn extrapolated(&self, problem: &Problem, force: &Resultant) -> Option<Extrapolation> {
        let [fine, coarse, ..] = self.levels.as_slice() else { return None };
        let (grid, coarser) = (&fine.contact.patch.grid, &coarse.contact.patch.grid);
        let ratios = [coarser.spacing_x / grid.spacing_x, coarser.spacing_y / grid.spacing_y];
        if !coarse.is_found || ratios.iter().any(|ratio| *ratio <= 1.0) {
            return None;
        }
        let on_coarse = summary::resultant(&coarse.contact.patch, &coarse.traction);
        let share = (ratios[0] * ratios[1] - 1.0).recip();
        let error = on_coarse.plus(-1.0, force).scaled(share, share);
        let force = force.plus(-1.0, &error);
        let normalised = summary::normalised(problem, &fine.contact.normal, &force);
        Some(Extrapolation { force, normalised, error })
    }
}
