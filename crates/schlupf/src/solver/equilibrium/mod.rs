//! The nonlinear equilibrium between elasticity and friction, F(p) = 0: p is the traction on the
//! rail, x and y component of each cell in turn.

mod recycling;
mod newton;

use crate::reporting::Error;
use crate::solver::settings;

pub use newton::Newton;
pub use recycling::Directions;

/// An equilibrium to be solved, F(p) = 0. The response to p is split into a linear part u = L p,
/// which is expensive because it contains the compliance, and a local part, which is cheap.
pub trait Equilibrium: Send + Sync {
    /// Number of unknowns.
    fn size(&self) -> usize;

    /// Length of L p.
    fn response_size(&self) -> usize {
        self.size()
    }

    /// Reference of the residuals, in Pa: see `measure`, at p and the last evaluation.
    fn scale(&self, p: &[f64]) -> f64;

    /// u = L p: one product with the compliance.
    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]);

    /// F(p), in Pa, with u = L p given. Prepares the tangent at p.
    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]);

    /// Jacobian of F times v, with L v given, at the p of the last residual evaluation.
    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]);

    /// Another initial guess, where the given one is nearly worthless; returns whether there is
    /// one.
    fn other_guess(&mut self, _p: &mut [f64]) -> bool {
        false
    }

    /// Directions of earlier linear systems with the same L, if they are worth keeping.
    fn directions(&mut self) -> Option<&mut Directions> {
        None
    }

    /// Replaces v by an approximation to the inverse Jacobian times v, linear in v.
    fn precondition(&mut self, v: &mut [f64]);
}

/// An error if the computation is to stop.
pub(crate) type Continues<'a> = &'a dyn Fn() -> Result<(), Error>;

/// Stopping criteria.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest admissible ratio of residual to scale, dimensionless.
    pub tolerance: f64,
    /// Maximum number of Newton steps.
    pub max_iterations: usize,
    /// Whether the residual norm must decrease in every step: if there may be several solutions, an
    /// increase can lead to a solution other than the one being followed.
    pub is_monotone: bool,
}

/// Outcome of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Outcome {
    /// Whether the tolerance was reached.
    pub converged: bool,
    /// Ratio of residual to scale reached, dimensionless.
    pub residual: f64,
    /// The same of the initial guess, dimensionless.
    pub first_residual: f64,
    /// Newton steps.
    pub iterations: usize,
    /// Products with the compliance.
    pub products: usize,
}

/// The reference of a residual, in Pa, given ‖μ pₙ‖₂ (`bound`) and ‖p‖₂ (`traction`), both in Pa:
/// the bound, if the traction is a hundredth of it or more; the traction itself below 1e-4, where
/// the contact sticks and everything is proportional to the motion, however slow it is; and a
/// transition in between. Without friction it is 1 Pa.
pub(crate) fn measure(bound: f64, traction: f64) -> f64 {
    if bound == 0.0 {
        return 1.0;
    }
    let share = (traction / bound).min(1.0);
    bound * (share / settings::small_traction()).powi(2).max(share).min(1.0)
}
