//! What is recorded of every time step.

use crate::reporting::{Progress, Stage};
use crate::solution::{FieldsAt, Instant};
use crate::solver::summary;
use crate::solver::summary::snapshot::View;

use super::March;

impl March<'_> {
    /// Adds up the work and records the forces of the step, and the shift if it is one.
    pub(super) fn note(&mut self, shift: Option<[f64; 3]>) {
        self.work.steps += 1;
        self.work.cells = self.contact.patch.len();
        self.work.newton_iterations += self.outcome.iterations;
        self.work.operator_products += self.outcome.products as f64;
        self.work.outer_iterations += 1;
        self.compare_passages();
        if self.outcome.residual.is_nan() {
            self.outcome.residual = f64::INFINITY;
        }
        let has_failed = self.outcome.residual > self.options.tolerance;
        self.failures = if has_failed { self.failures + 1 } else { 0 };
        self.keep_instant(shift);
    }

    fn keep_instant(&mut self, shift: Option<[f64; 3]>) {
        self.worst_residual = self.worst_residual.max(self.outcome.residual);
        let length = self.contact.patch.strips.iter().map(|strip| strip.cells.len()).max();
        let ([fewest, most], length) = (self.strip_lengths, length.unwrap_or(0));
        self.strip_lengths = [fewest.min(length), most.max(length)];
        self.largest_pressure = self.largest_pressure.max(self.contact.normal.peak_pressure);
        let view =
            View { normal: &self.contact.normal, patch: &self.contact.patch, now: &self.now };
        let instant = summary::instant(view, [self.time, self.distance], &self.outcome);
        let instant = Instant { shift, ..instant };
        self.instants.push(self.powers.map_or(instant, |powers| Instant {
            friction_power: Some(powers.friction),
            creep_power: powers.creep,
            ..instant
        }));
        self.keep_fields();
    }

    /// Keeps the fields of this step, if they are wanted.
    fn keep_fields(&mut self) {
        let (step, every) = (self.work.steps, self.options.fields_every);
        if every > 0 && (step.is_multiple_of(every) || self.is_finished()) {
            let patch = &self.contact.patch;
            let fields = summary::fields(patch, &self.now, self.options.slip_threshold);
            self.field_history.push(FieldsAt { step, time: self.time, fields });
        }
    }

    pub(super) fn progress(&self) -> Progress {
        let [start, end] = self.whole.span();
        let total = (end > start).then(|| {
            let done = ((self.time - start) / (end - start)).clamp(1e-9, 1.0);
            (self.work.steps as f64 / done).round() as usize
        });
        let change = Some(self.change);
        Progress { stage: Stage::Marching, done: self.work.steps, total, change }
    }
}
