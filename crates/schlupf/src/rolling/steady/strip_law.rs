//! What the interface of wheel and rail demands along the strips of a patch in steady rolling.

use crate::numerics::vector::norm;
use crate::patch::{Cell, Patch};
use crate::problem::Problem;
use crate::state::Element;

use super::steady_friction::SteadyFriction;

/// The equations F(p) = 0 of the cells, given b = B p: the linear response of the bodies to the
/// traction p on the rail. Vectors have the x and y component of each cell in turn.
pub(super) trait StripLaw: Send + Sync {
    /// Switches to another motion and other laws, with γ in Pa/m.
    fn set_problem(&mut self, problem: &Problem, patch: &Patch, gamma: f64);

    /// μ pₙ of each cell, in Pa.
    fn bound(&self) -> &[f64];

    /// Sets μ pₙ from the coefficient of friction (dimensionless) of each cell.
    fn set_bound(&mut self, cells: &[Cell], coefficient: &[f64]);

    /// Converts displacements at the cells under the traction p, relative to those where their
    /// material entered, into b, in place; both in m.
    fn relate(&self, p: &[f64], b: &mut [f64]);

    /// Traction on the rail divided by μ pₙ of each cell, if only the bristles were compliant;
    /// dimensionless.
    fn rigid_saturation(&self) -> Vec<[f64; 2]>;

    /// The residual that defines the tolerance, in Pa.
    fn defect(&self, p: &[f64], b: &[f64]) -> f64;

    /// F(p), in Pa; prepares the tangent.
    fn residual(&mut self, p: &[f64], b: &[f64], residual: &mut [f64]);

    /// Change of F due to small changes.
    fn tangent(&self, change: &Changed, cause: Option<&Cause>, product: &mut [f64]);

    /// Replaces v by an approximation to the inverse Jacobian times v, in one pass down every
    /// strip. If `friction` depends on the heat from upstream, this is included.
    fn precondition(&mut self, v: &mut [f64], friction: Option<&SteadyFriction>);

    /// The elements of the steady state with the traction p, without their heat, given also the
    /// displacements at the cells relative to those where their material entered, in m.
    fn elements(&self, patch: &Patch, p: &[f64], b: &[f64], relative: &[f64]) -> Vec<Element>;

    /// Gives the cells that have no equation of their own the traction that follows from the
    /// others, in place.
    fn complete(&self, _p: &mut [f64]) {}

    /// Gives such cells the coefficient of friction (dimensionless) that their traction obeys.
    fn complete_friction(&self, _coefficient: &mut [f64]) {}

    /// Replaces the slip velocity of the cells, at a rolling speed in m/s, by that of the law, if
    /// it has one of its own.
    fn take_slip(&self, _b: &[f64], _speed: f64, _slip: &mut [[f64; 2]]) {}

    /// Share of F in which cells stick without sliding, but for what stretches bristles;
    /// dimensionless.
    fn stick_share(&self) -> f64 {
        0.0
    }

    /// Number of cells.
    fn len(&self) -> usize {
        self.bound().len()
    }

    /// ‖μ pₙ‖₂, in Pa.
    fn scale(&self) -> f64 {
        norm(self.bound())
    }
}

/// Small changes of the arguments of F.
#[derive(Clone, Copy)]
pub(super) struct Changed<'a> {
    /// Of p, in Pa.
    pub traction: &'a [f64],
    /// Of b, in m.
    pub response: &'a [f64],
    /// Of μ pₙ, in Pa, if it changes.
    pub bound: Option<&'a [f64]>,
}

/// Small changes of the data of the law, cell by cell (x then y); in the order of the cells.
#[derive(Debug, Clone, Default)]
pub(super) struct Cause {
    /// Of the rigid slip D along the path into each cell, in m.
    pub rigid: Vec<f64>,
    /// Of the rigid part of the turn between the middle and the end of the path, in m.
    pub turn: Vec<f64>,
    /// Relative change of k_c, dimensionless.
    pub stiffness: f64,
    /// Relative change of the stiffness of bristles over that of cells, dimensionless.
    pub over_cells: f64,
}
