//! The nonlinear equilibrium between elasticity and friction: p = μ pₙ law(D − B p).
//!
//! p is the traction on the rail, x and y component of each cell in turn, D the sliding that the
//! bodies' motion and history prescribe, B the compliance.

mod gmres;
mod newton;

pub use newton::solve;

/// An equilibrium to be solved. The response to p is split into the linear part u = A p, which is
/// dear, and a local rest, which is cheap.
pub trait Equilibrium {
    /// Number of unknowns.
    fn size(&self) -> usize;

    /// ‖μ pₙ‖₂, in Pa: what the residual is measured against.
    fn scale(&self) -> f64;

    /// u = A p: one product.
    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]);

    /// Residual F(p) = p − μ pₙ law, with u = A p given; in Pa. Prepares the tangent at p.
    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]);

    /// Jacobian of F times v, with A v given, at the p of the last residual.
    fn tangent_product(&self, v: &[f64], compliance_v: &[f64], product: &mut [f64]);

    /// Replaces v by an approximation of the inverse Jacobian times v.
    fn precondition(&self, v: &mut [f64]);

    /// A slow but safe step towards the solution (forward–backward splitting), for where Newton's
    /// method finds no descent. `u` = A p on entry.
    fn safe_step(&mut self, p: &mut [f64], u: &[f64]);
}

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest ‖F‖₂ over the scale, dimensionless.
    pub tolerance: f64,
    /// Most Newton steps.
    pub max_iterations: usize,
}

/// How it went.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Outcome {
    /// Whether the tolerance was reached.
    pub converged: bool,
    /// ‖F‖₂ over the scale reached, dimensionless.
    pub residual: f64,
    /// Newton steps.
    pub iterations: usize,
    /// Products with A.
    pub products: usize,
    /// Safe steps in between.
    pub safe_steps: usize,
}

pub(crate) fn norm(v: &[f64]) -> f64 {
    dot(v, v).sqrt()
}

pub(crate) fn dot(v: &[f64], w: &[f64]) -> f64 {
    v.iter().zip(w).map(|(v, w)| v * w).sum()
}

/// v ← v + factor · w
pub(crate) fn add_scaled(v: &mut [f64], factor: f64, w: &[f64]) {
    for (v, w) in v.iter_mut().zip(w) {
        *v += factor * w;
    }
}
