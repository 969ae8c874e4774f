//! Identification: constants of friction and contact law from measured creep curves.
//!
//! [`fit`] minimises the sum of the squared differences between measured and computed forces
//! (Levenberg–Marquardt). A [`CreepForceModel`] computes forces with their exact derivatives;
//! [`RollingContactModel`] is that of the steady solver, [`PolachModel`] that of Polach's method.
//! The results include confidence intervals and correlations, and data that do not determine a
//! parameter are rejected.

mod adjustment;
mod confidence;
mod curves;
mod data;
mod determinacy;
mod fit;
mod held_forces;
mod model;
mod parameter;
mod polach_method;
mod residuals;
mod rolling_contact;
mod statistics;
pub mod roughness;

pub use curves::{FittedCurves, ModelPoint, Series, sample_curves};
pub use data::{Component, Condition, DataPoint, FittedPoint};
pub use fit::{Estimate, Fit, check, fit};
pub use model::{CreepForceModel, ForceRatio};
pub use parameter::Parameter;
pub use polach_method::PolachModel;
pub use rolling_contact::RollingContactModel;
