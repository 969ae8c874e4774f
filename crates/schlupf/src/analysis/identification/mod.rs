//! Identification: constants of friction and contact law from measured creep curves.
//!
//! [`fit`] minimises the sum of the squared differences between measured and computed forces
//! (Levenberg–Marquardt). A [`CreepForceModel`] computes forces with their exact derivatives;
//! [`RollingContactModel`] is that of the steady solver, [`PolachModel`] that of Polach's method.
//! The results include confidence intervals and correlations, and data that do not determine a
//! parameter are rejected.

mod parameter;
mod adjustment;
mod confidence;
mod data;
mod model;
mod curves;
mod determinacy;
mod residuals;
mod statistics;
mod fit;
mod held_forces;
mod polach_method;
pub mod roughness;
mod rolling_contact;

pub use curves::{FittedCurves, ModelPoint, Series, sample_curves};
pub use data::{Component, Condition, DataPoint, FittedPoint};
pub use fit::{Estimate, Fit, check, fit};
pub use model::{CreepForceModel, ForceRatio};
pub use parameter::Parameter;
pub use polach_method::PolachModel;
pub use rolling_contact::RollingContactModel;
