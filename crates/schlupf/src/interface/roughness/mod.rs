//! From a rough surface to the contact law, Eq. (8): the micro model.
//!
//! The normal contact of the surface at growing load gives the approach d(P) ([`load_curve`]). For
//! similar elastic bodies the tangential curve follows from it by superposition (Ciavarella 1998;
//! Jäger 1998; [`tangential_curve`]), and the stiffness k_c is fitted to that ([`stiffness`]).
//! [`micro_model`] does all of it.
//!
//! Limits: Coulomb friction in every spot, half-spaces, bodies of similar material; of a tangential
//! load the influence on the normal contact is neglected. With a hardness the normal curve is that
//! of first loading.

pub mod load_curve;
pub mod micro_model;
pub mod stiffness;
pub mod tangential_curve;
