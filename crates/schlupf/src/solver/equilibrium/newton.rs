//! Inexact Newton method with a line search on the residual norm (Eisenstat and Walker 1996). Where
//! that leaves only short steps, the line search is non-monotone (Grippo, Lampariello and Lucidi
//! 1986): near Coulomb's law F has kinks, along which a norm that must decrease in every step makes
//! little progress.

use super::{Continues, Directions, Equilibrium, Limits, Outcome};
use crate::numerics::vector::{add_scaled, norm};
use crate::reporting::{Error, Progress, Stage, Watch, tell};
use crate::solver::settings;

/// Newton's method and its workspace, kept between solutions.
#[derive(Debug, Default)]
pub struct Newton {
    u: Vec<f64>,
    residual: Vec<f64>,
    step: Vec<f64>,
    response_step: Vec<f64>,
    trial: [Vec<f64>; 3],
    /// Residual norms of the last steps.
    recent: Vec<f64>,
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
        if length > settings::poor_guess() * system.scale(p) {
            self.restart(system, p, &mut length, &mut outcome);
        }
        let mut forcing = settings::largest_forcing();
        let mut best = Best { length, iteration: 0 };
        self.recent.clear();
        self.recent.resize(settings::residuals_remembered(), 0.0);
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
            let enough = settings::part_of_tolerance() * limits.tolerance / outcome.residual;
            let forcing_now = forcing.max(enough).min(0.5);
            outcome.products += self.direction(system, forcing_now, &continues)?;
            let before = length;
            if !limits.is_monotone {
                let place = outcome.iterations % self.recent.len();
                self.recent[place] = before;
            }
            let largest = self.recent.iter().copied().fold(before, f64::max);
            let halvings = settings::most_halvings();
            let next = self
                .line_search(system, p, before, halvings / 3)
                .or_else(|| self.line_search(system, p, largest, halvings));
            let Some(next) = next else {
                // The last residual evaluated is to be that of the result.
                system.residual(p, &self.u, &mut self.residual);
                return Ok(Solved { outcome, response: &self.u });
            };
            length = next;
            forcing = (0.9 * (length / before).powi(2)).min(settings::largest_forcing());
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

    /// Halves the step until the residual norm falls sufficiently below `length`. A trial costs no
    /// product, because L is linear.
    fn line_search(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        length: f64,
        most_halvings: usize,
    ) -> Option<f64> {
        let mut fraction = 1.0;
        for _ in 0..=most_halvings {
            let trial_length = self.try_step(system, p, fraction);
            if trial_length <= (1.0 - settings::sufficient_decrease() * fraction) * length {
                self.accept(p);
                return Some(trial_length);
            }
            fraction *= 0.5;
        }
        None
    }

    /// The residual norm after a part of the step.
    fn try_step(&mut self, system: &mut impl Equilibrium, p: &[f64], fraction: f64) -> f64 {
        let [trial_p, trial_u, trial_residual] = &mut self.trial;
        trial_p.copy_from_slice(p);
        trial_u.copy_from_slice(&self.u);
        add_scaled(trial_p, fraction, &self.step);
        add_scaled(trial_u, fraction, &self.response_step);
        system.residual(trial_p, trial_u, trial_residual);
        norm(trial_residual)
    }

    /// Goes to where the residual was evaluated last.
    fn accept(&mut self, p: &mut [f64]) {
        let [trial_p, trial_u, trial_residual] = &mut self.trial;
        p.copy_from_slice(trial_p);
        std::mem::swap(&mut self.u, trial_u);
        std::mem::swap(&mut self.residual, trial_residual);
    }
}

/// The smallest residual so far. With a very stiff contact law, rounding keeps it from falling
/// further.
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
        iteration > self.iteration + settings::patience()
    }
}
