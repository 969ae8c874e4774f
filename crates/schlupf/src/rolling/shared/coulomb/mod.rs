//! Coulomb's law itself, and not a contact law with stiff bristles: where a cell sticks it does not
//! slide at all, where it slides |p| = μ pₙ along the slip.
//!
//! Behind a leading edge that sticks, the traction follows from an equation of the first kind,
//! whose accuracy on few cells rests on three things: the displacement is calibrated with a
//! traction for which it is known ([`calibration`]), the slip is of third order ([`slip_stencil`]),
//! and cells that are hardly loaded take the traction of their neighbours ([`slivers`]).

mod slivers;
mod calibration;
mod slip_stencil;
mod resolvent;
mod contact;

/// How exactly the equations of sticking cells are posed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::rolling) enum Discretisation {
    /// As exactly as possible.
    Exact,
    /// For edges and pressures so irregular that the exact equations have no solution, or none that
    /// Newton's method finds: less is asked of cells at the edge, and slip depends on nothing
    /// downstream.
    Robust,
}

impl Discretisation {
    /// Sliding of the first cell since entry under its own traction, relative to its compliance,
    /// below which it is a sliver: the traction of its neighbours would determine its own one;
    /// dimensionless. Under an elliptic pressure it is hardly ever less than a third.
    fn least_slid(self) -> f64 {
        match self {
            Self::Exact => 0.25,
            Self::Robust => 0.45,
        }
    }
}

pub(in crate::rolling) use calibration::{Calibrated, Calibration};
pub(in crate::rolling) use contact::CoulombContact;
pub(in crate::rolling) use resolvent::{Answer, Bristles, Matrix, reduced, saturation};
pub(in crate::rolling) use slip_stencil::{SlipStencil, order, slide, through};
