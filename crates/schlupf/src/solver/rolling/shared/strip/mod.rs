//! The contact law of a strip, for bristles of any stiffness and for Coulomb's law: one equation
//! for each cell ([`resolvent`]).
//!
//! Where bristles are stiff, or there are none, the traction behind a leading edge that sticks
//! follows from an equation of the first kind, whose accuracy on few cells rests on three things:
//! the displacement is calibrated with a traction for which it is known ([`calibration`]), the slip
//! is of third order ([`slip_stencil`]), and cells that are hardly loaded take the traction of
//! their neighbours ([`slaved_cells`]).

mod slaved_cells;
mod calibration;
mod resolvent;
mod slip_stencil;
mod lone_cell;
mod contact;
mod block;
mod strip_factors;

pub(in crate::solver::rolling) use calibration::{Calibrated, Calibration};
pub(in crate::solver::rolling) use contact::StripContact;
pub(in crate::solver::rolling) use lone_cell::LoneCell;
pub(in crate::solver::rolling) use resolvent::{
    BristleState, Matrix, Resolvent, reduced, saturation,
};
pub(in crate::solver::rolling) use slip_stencil::{
    SlipStencil, UpstreamValues, order, slide, through,
};
pub(in crate::solver::rolling) use strip_factors::{Displaced, Interface, StripFactors, Upstream};
