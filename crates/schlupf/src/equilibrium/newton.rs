//! Inexact Newton method with a line search on the residual norm (Eisenstat and Walker 1996). Where
//! that leaves only short steps, the line search is non-monotone (Grippo, Lampariello and Lucidi
//! 1986): near Coulomb's law F has kinks, along which a norm that must decrease in every step makes
//! little progress.

use super::{Continues, Directions, Equilibrium, Limits, Outcome};
use crate::error::Error;
use crate::numerics::vector::{add_scaled, norm};
use crate::progress::{Progress, Stage, Watch, tell};

/// Largest forcing term: linear residual allowed in the Krylov method, relative to that of the
/// Newton step.
const LARGEST_FORCING: f64 = 0.3;

/// Smallest forcing term: a Newton step is never more accurate than that anyway.
const LEAST_FORCING: f64 = 1e-4;

/// Fraction of the tolerance that the linear residual may use up.
const ENOUGH: f64 = 0.8;

/// Smallest decrease of the residual norm required of a step of length λ, relative to λ.
const SUFFICIENT_FALL: f64 = 1e-4;

/// ‖F‖₂ over the scale above which an initial guess is considered worthless.
const WORTHLESS: f64 = 0.8;

/// Halvings of a step before the residual norm need only fall below the largest of the last few
/// steps.
const MONOTONE_HALVINGS: usize = 3;

/// Number of these steps.
const MEMORY: usize = 5;

/// Halvings of a step before it is abandoned.
const MAX_HALVINGS: usize = 10;

/// Safe steps after which Newton's method is tried again.
const SAFE_STEPS: usize = 20;

/// Newton's method and its workspace, kept between solutions.
#[derive(Debug, Default)]
pub struct Newton {
    u: Vec<f64>,
    residual: Vec<f64>,
    step: Vec<f64>,
    response_step: Vec<f64>,
    trial: [Vec<f64>; 3],
    directions: Directions,
}

/// Outcome of a solution, with the linear response to the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved<'a> {
    /// Outcome.
    pub outcome: Outcome,
    /// L p, in m.
    pub response: &'a [f64],
}

impl Newton {
    /// Solves F(p) = 0 from the given p, in place. On return the last evaluation of the system was
    /// at the p that is returned. `watch` is asked before every step.
    ///
    /// # Errors
    /// [`Error::Stopped`]; p is then that of the previous step.
    pub fn solve(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        limits: &Limits,
        watch: Watch,
    ) -> Result<Solved<'_>, Error> {
        self.prepare(system);
        let mut outcome = Outcome { products: 1, ..Outcome::default() };
        system.compliance_product(p, &mut self.u);
        system.residual(p, &self.u, &mut self.residual);
        let mut length = norm(&self.residual);
        if length > WORTHLESS * system.scale(p) {
            self.restart(system, p, &mut length, &mut outcome);
        }
        let mut forcing = LARGEST_FORCING;
        let mut best = Best { length, iteration: 0 };
        let mut recent = [0.0; MEMORY];
        loop {
            let scale = system.scale(p);
            // The scale of a traction that is still zero is unknown.
            let scale = if scale == 0.0 { f64::MIN_POSITIVE } else { scale };
            best.note(outcome.iterations, length);
            let given_up = outcome.iterations == limits.max_iterations
                || !length.is_finite()
                || length == 0.0
                || best.is_stale(outcome.iterations);
            outcome.residual = length / scale;
            outcome.converged = outcome.residual <= limits.tolerance && scale.is_finite();
            if outcome.iterations == 0 {
                outcome.first_residual = outcome.residual;
            }
            if outcome.converged || given_up {
                return Ok(Solved { outcome, response: &self.u });
            }
            let (change, done) = (Some(outcome.residual), outcome.iterations);
            let progress = Progress { change, ..Progress::count(Stage::Steady, done) };
            let continues = || tell(watch, progress);
            continues()?;
            outcome.iterations += 1;
            let enough = ENOUGH * limits.tolerance / outcome.residual;
            let forcing_now = forcing.max(enough).min(0.5);
            outcome.products += self.direction(system, forcing_now, &continues)?;
            let before = length;
            if !limits.is_monotone {
                recent[outcome.iterations % MEMORY] = before;
            }
            length = match self.line_search(system, p, before, &recent) {
                Some(length) => length,
                None => self.safe_steps(system, p, &mut outcome),
            };
            forcing = (0.9 * (length / before).powi(2)).clamp(LEAST_FORCING, LARGEST_FORCING);
        }
    }

    /// L p of the last solution, in m.
    pub fn response(&self) -> &[f64] {
        &self.u
    }

    /// The directions of the last solution.
    pub(crate) fn directions(&mut self) -> &mut Directions {
        &mut self.directions
    }

    fn prepare(&mut self, system: &impl Equilibrium) {
        self.directions.clear();
        let [p, u, residual] = &mut self.trial;
        for vector in [p, residual, &mut self.residual, &mut self.step] {
            vector.resize(system.size(), 0.0);
        }
        for vector in [u, &mut self.u, &mut self.response_step] {
            vector.resize(system.response_size(), 0.0);
        }
    }

    /// Restarts from the system's alternative to the initial guess, if that is better.
    fn restart(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        length: &mut f64,
        outcome: &mut Outcome,
    ) {
        let [trial_p, trial_u, trial_residual] = &mut self.trial;
        if !system.other_guess(trial_p) {
            return;
        }
        outcome.products += 1;
        system.compliance_product(trial_p, trial_u);
        system.residual(trial_p, trial_u, trial_residual);
        let trial_length = norm(trial_residual);
        if trial_length < *length {
            *length = trial_length;
            p.copy_from_slice(trial_p);
            std::mem::swap(&mut self.u, trial_u);
            std::mem::swap(&mut self.residual, trial_residual);
        } else {
            system.residual(p, &self.u, &mut self.residual);
        }
    }

    /// The step, which reduces the linear residual to `forcing` times the present one; returns the
    /// number of products.
    fn direction(
        &mut self,
        system: &mut impl Equilibrium,
        forcing: f64,
        continues: Continues,
    ) -> Result<usize, Error> {
        let target = [self.step.as_mut_slice(), self.response_step.as_mut_slice()];
        if let Some(mut directions) = system.directions().map(std::mem::take) {
            let products = directions.solve(system, &self.residual, forcing, (target, continues));
            if let Some(kept) = system.directions() {
                *kept = directions;
            }
            return products;
        }
        self.directions.solve(system, &self.residual, forcing, (target, continues))
    }

    /// Goes along the step until the residual norm decreases sufficiently, and returns it; where
    /// that takes less than half the step, until the norm falls below the largest of the recent
    /// ones.
    fn line_search(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        length: f64,
        recent: &[f64],
    ) -> Option<f64> {
        let largest = recent.iter().copied().fold(length, f64::max);
        self.go_along(system, p, length, MONOTONE_HALVINGS)
            .or_else(|| self.go_along(system, p, largest, MAX_HALVINGS))
    }

    /// Halves the step until the residual norm falls sufficiently below `length`. A trial costs no
    /// product, because L is linear.
    fn go_along(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        length: f64,
        most_halvings: usize,
    ) -> Option<f64> {
        let mut fraction = 1.0;
        for _ in 0..=most_halvings {
            let [trial_p, trial_u, trial_residual] = &mut self.trial;
            trial_p.copy_from_slice(p);
            trial_u.copy_from_slice(&self.u);
            add_scaled(trial_p, fraction, &self.step);
            add_scaled(trial_u, fraction, &self.response_step);
            system.residual(trial_p, trial_u, trial_residual);
            let trial_length = norm(trial_residual);
            if trial_length <= (1.0 - SUFFICIENT_FALL * fraction) * length {
                p.copy_from_slice(trial_p);
                std::mem::swap(&mut self.u, trial_u);
                std::mem::swap(&mut self.residual, trial_residual);
                return Some(trial_length);
            }
            fraction *= 0.5;
        }
        None
    }

    fn safe_steps(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        outcome: &mut Outcome,
    ) -> f64 {
        for _ in 0..SAFE_STEPS {
            add_scaled(p, -1.0, &self.residual);
            system.complete(p);
            system.compliance_product(p, &mut self.u);
            system.residual(p, &self.u, &mut self.residual);
        }
        outcome.safe_steps += SAFE_STEPS;
        outcome.products += SAFE_STEPS;
        norm(&self.residual)
    }
}

/// The smallest residual so far. Rounding, amplified by a very stiff contact law, can hide the
/// rest.
struct Best {
    length: f64,
    iteration: usize,
}

impl Best {
    fn note(&mut self, iteration: usize, length: f64) {
        if length < 0.9 * self.length {
            *self = Self { length, iteration };
        }
    }

    fn is_stale(&self, iteration: usize) -> bool {
        iteration > self.iteration + PATIENCE
    }
}

/// Newton steps without a smaller residual before giving up.
const PATIENCE: usize = 40;
