//! Inexact Newton's method with a line search on the residual norm (Eisenstat and Walker 1996).

use super::gmres::Gmres;
use super::{Equilibrium, Limits, Outcome, add_scaled, norm};

/// Largest linear residual asked of the Krylov method, relative to that of the Newton step.
const LARGEST_FORCING: f64 = 0.1;

/// Smallest one: a Newton step is never that exact anyway.
const LEAST_FORCING: f64 = 1e-4;

/// Least fall of the residual norm that a step of length λ must bring, relative to λ.
const SUFFICIENT_FALL: f64 = 1e-4;

/// Halvings of a step before it is given up.
const MAX_HALVINGS: usize = 10;

/// Safe steps after which Newton's method is tried again.
const SAFE_STEPS: usize = 20;

/// Solves F(p) = 0 from the given p, in place.
pub fn solve(system: &mut impl Equilibrium, p: &mut [f64], limits: &Limits) -> Outcome {
    let scale = system.scale();
    let mut newton = Newton::new(system.size());
    let mut outcome = Outcome { products: 1, ..Outcome::default() };
    system.compliance_product(p, &mut newton.u);
    let mut forcing = LARGEST_FORCING;
    let mut best = Best { defect: f64::INFINITY, iteration: 0 };
    loop {
        let defect = system.defect(p, &newton.u);
        outcome.residual = if scale > 0.0 { defect / scale } else { defect };
        outcome.converged = outcome.residual <= limits.tolerance && scale.is_finite();
        best.note(outcome.iterations, defect);
        let given_up = outcome.iterations == limits.max_iterations
            || !defect.is_finite()
            || best.is_stale(outcome.iterations);
        if outcome.converged || given_up {
            return outcome;
        }
        system.residual(p, &newton.u, &mut newton.residual);
        let before = norm(&newton.residual);
        if before == 0.0 {
            // Rounding hides the rest of the defect.
            return outcome;
        }
        outcome.iterations += 1;
        // No more than half of what is needed in the end.
        let enough = 0.5 * limits.tolerance / outcome.residual;
        outcome.products += newton.direction(system, forcing.max(enough).min(0.5));
        let after = match newton.line_search(system, p, before) {
            Some(length) => length,
            None => newton.safe_steps(system, p, &mut outcome),
        };
        forcing = (0.9 * (after / before).powi(2)).clamp(LEAST_FORCING, LARGEST_FORCING);
    }
}

/// The best defect so far. Rounding, amplified by a very stiff contact law, can hide the rest.
struct Best {
    defect: f64,
    iteration: usize,
}

impl Best {
    fn note(&mut self, iteration: usize, defect: f64) {
        if defect < 0.9 * self.defect {
            *self = Self { defect, iteration };
        }
    }

    fn is_stale(&self, iteration: usize) -> bool {
        iteration > self.iteration + PATIENCE
    }
}

/// Newton steps without a better defect after which there is no hope.
const PATIENCE: usize = 40;

struct Newton {
    u: Vec<f64>,
    residual: Vec<f64>,
    step: Vec<f64>,
    compliance_step: Vec<f64>,
    trial: [Vec<f64>; 3],
    krylov: Gmres,
}

impl Newton {
    fn new(size: usize) -> Self {
        let zeros = || vec![0.0; size];
        Self {
            u: zeros(),
            residual: zeros(),
            step: zeros(),
            compliance_step: zeros(),
            trial: [zeros(), zeros(), zeros()],
            krylov: Gmres::default(),
        }
    }

    fn direction(&mut self, system: &mut impl Equilibrium, forcing: f64) -> usize {
        let target = [self.step.as_mut_slice(), self.compliance_step.as_mut_slice()];
        self.krylov.solve(system, &self.residual, forcing, target)
    }

    /// Goes along the step as far as the residual norm falls enough, and returns it. A trial costs
    /// no product, because A is linear.
    fn line_search(
        &mut self,
        system: &mut impl Equilibrium,
        p: &mut [f64],
        length: f64,
    ) -> Option<f64> {
        let mut fraction = 1.0;
        for _ in 0..=MAX_HALVINGS {
            let [trial_p, trial_u, trial_residual] = &mut self.trial;
            trial_p.copy_from_slice(p);
            trial_u.copy_from_slice(&self.u);
            add_scaled(trial_p, fraction, &self.step);
            add_scaled(trial_u, fraction, &self.compliance_step);
            system.residual(trial_p, trial_u, trial_residual);
            let trial_length = norm(trial_residual);
            if trial_length <= (1.0 - SUFFICIENT_FALL * fraction) * length {
                p.copy_from_slice(trial_p);
                std::mem::swap(&mut self.u, trial_u);
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
            system.compliance_product(p, &mut self.u);
            system.residual(p, &self.u, &mut self.residual);
        }
        outcome.safe_steps += SAFE_STEPS;
        outcome.products += SAFE_STEPS;
        norm(&self.residual)
    }
}
