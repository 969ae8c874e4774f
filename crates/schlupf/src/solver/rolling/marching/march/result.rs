//! The result of a march, and why it is none.

use crate::problem::{Method, State};
use crate::reporting::{Unconverged, Warning};
use crate::solution::{Solution, Status};
use crate::solver::rolling::shared::warnings::warnings;
use crate::solver::summary::snapshot::View;
use crate::solver::summary::{self};

use super::March;

impl March<'_> {
    /// Loads of the history that the grid or the bodies do not bear.
    fn of_load(&self) -> Vec<Warning> {
        /// Fewest cells along rolling that show a patch, if the grid has as many.
        const FEWEST: usize = 8;
        let [cells, of] = self.strip_lengths;
        let coarse = (cells < FEWEST && cells < of).then_some(Warning::FewCells { cells, of });
        let is_past = self.largest_pressure > self.contact.normal.peak_pressure;
        let yields =
            self.problem.interface.beyond_elastic(self.largest_pressure).filter(|_| is_past);
        coarse.into_iter().chain(yields).collect()
    }

    pub(super) fn into_solution(mut self) -> Solution {
        let transient = !self.whole.is_endless();
        let passed = self.passage_change.is_finite();
        let residual = match (transient, passed) {
            (true, _) => self.worst_residual,
            (false, true) => self.outcome.residual.max(self.passage_change),
            (false, false) => self.outcome.residual.max(self.change),
        };
        let status = if residual <= self.options.tolerance && (transient || passed) {
            Status::Converged
        } else {
            Status::NotConverged
        };
        let mut warnings = warnings(self.problem, self.options, &mut self.contact, &self.now);
        warnings.extend(self.of_load());
        if self.options.extrapolate {
            warnings.push(Warning::NoExtrapolation {});
        }
        if status == Status::NotConverged {
            warnings.insert(0, Warning::of(self.why_not_converged()));
        }
        let state = State {
            grid: self.contact.patch.grid,
            time: self.time,
            elements: self.elements,
            motion: Some(self.now.over_step),
        };
        let account = summary::SolverReport {
            method: Method::Full,
            status,
            residual,
            history: self.instants,
            field_history: self.field_history,
            warnings,
            sensitivity: None,
            work: self.work,
            state,
        };
        let view =
            View { normal: &self.contact.normal, patch: &self.contact.patch, now: &self.now };
        summary::solution(self.problem, self.options, view, account)
    }

    fn why_not_converged(&self) -> Unconverged {
        let (tolerance, residual) = (self.options.tolerance, self.worst_residual);
        let (steps, change) = (self.work.steps, self.passage_change);
        if let Some((force, time)) = self.missed {
            Unconverged::MissedForce { force, time }
        } else if residual > tolerance && self.whole.is_at_rest_throughout() && self.work.steps == 1
        {
            let newton_steps = self.outcome.iterations;
            Unconverged::Equilibrium { newton_steps, residual, tolerance }
        } else if residual > tolerance {
            Unconverged::TimeStep { residual, tolerance }
        } else if change.is_infinite() && self.whole.is_endless() {
            Unconverged::ShortMarch { steps }
        } else {
            Unconverged::UnsteadyMarch { steps, change, tolerance }
        }
    }
}
