//! The nonlinear equilibrium between elasticity and friction: p = μ pₙ law(D − B p).
//!
//! p is the traction on the rail, x and y component of each cell in turn, D the sliding that the
//! bodies' motion and history prescribe, B the compliance.

mod gmres;
mod newton;

pub(crate) use gmres::Gmres;
pub use newton::Newton;

/// An equilibrium to be solved, F(p) = 0. The response to p is split into a linear part u = L p,
/// which is dear because it contains the compliance, and a local rest, which is cheap.
pub trait Equilibrium: Send + Sync {
    /// Number of unknowns.
    fn size(&self) -> usize;

    /// Length of L p.
    fn response_size(&self) -> usize {
        self.size()
    }

    /// What residuals are measured against, in Pa: see `measure`, at p and the last evaluation.
    fn scale(&self, p: &[f64]) -> f64;

    /// u = L p: one product with the compliance.
    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]);

    /// The residual that defines the tolerance, ‖p − μ pₙ law(D − B p)‖₂ in Pa, with u = L p given.
    fn defect(&mut self, p: &[f64], u: &[f64]) -> f64;

    /// F(p), in Pa, with u = L p given; zero where the defect is zero. Prepares the tangent at p.
    /// The step p ← p − F(p) must never lead away from the solution.
    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]);

    /// Jacobian of F times v, with L v given, at the p of the last residual.
    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]);

    /// Another first guess, where the one given tells next to nothing; whether there is one.
    fn other_guess(&mut self, _p: &mut [f64]) -> bool {
        false
    }

    /// Replaces v by an approximation of the inverse Jacobian times v, linear in v.
    fn precondition(&mut self, v: &mut [f64]);
}

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest defect over the scale, dimensionless.
    pub tolerance: f64,
    /// Most Newton steps.
    pub max_iterations: usize,
    /// Whether the residual norm must fall in every step: where there may be several solutions, one
    /// that rises can lead to another than the one that is followed.
    pub is_monotone: bool,
}

/// How it went.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Outcome {
    /// Whether the tolerance was reached.
    pub converged: bool,
    /// Defect over the scale reached, dimensionless.
    pub residual: f64,
    /// Newton steps.
    pub iterations: usize,
    /// Products with the compliance.
    pub products: usize,
    /// Safe steps in between.
    pub safe_steps: usize,
}

/// What a residual is measured against, in Pa, for ‖μ pₙ‖₂ (`bound`) and ‖p‖₂ (`traction`), both in
/// Pa: the former, where the traction is a hundredth of it or more; the traction itself below 1e-4,
/// where the contact sticks and all is proportional to the motion, however slow it is; and what
/// lies between. Without friction it is 1 Pa.
pub(crate) fn measure(bound: f64, traction: f64) -> f64 {
    if bound == 0.0 {
        return 1.0;
    }
    let share = (traction / bound).min(1.0);
    bound * (share / RELATIVE).powi(2).max(share).min(1.0)
}

/// See [`measure`]: the geometric mean of the two parts.
const RELATIVE: f64 = 0.01;
