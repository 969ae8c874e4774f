//! From a rough surface to the contact law, Eq. (8): the micro model.
//!
//! The normal contact of the surface at increasing load gives the approach d(P) ([`LoadCurve`]).
//! For similar elastic bodies the tangential curve follows from it by superposition (Ciavarella
//! 1998; Jäger 1998; [`tangential_curve`]), and the stiffness k_c is fitted to that curve
//! ([`ContactStiffness`]). [`MicroModel`] combines the steps.
//!
//! Limits: Coulomb friction in every spot, half-spaces, bodies of similar material; the influence
//! of a tangential load on the normal contact is neglected. With a hardness the normal curve is
//! that of first loading.

mod load_curve;
pub mod tangential_curve;
mod stiffness;
mod micro_model;

pub use load_curve::{EXPONENTIAL_RANGE, ExponentialRange, LoadCurve, LoadCurveOptions, LoadPoint};
pub use micro_model::{MicroModel, MicroModelResult, pressures_of_patch};
pub use stiffness::{ContactStiffness, ExponentialFit, TYPICAL_GAMMA, closed_form};
