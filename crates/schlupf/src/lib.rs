//! Rolling contact of wheel and rail: tangential stress, slip and temperature in the contact patch.
//!
//! The model is that of Neuhaus and Sextro, *Thermo-mechanical model for wheel rail contact using
//! coupled point contact elements* (ICCM 2014); equation numbers without a source in this crate are
//! theirs. The modules are listed in the order of data flow, from the constants of the two bodies
//! to the solution; each uses only modules above it.
//!
//! All quantities are SI, temperatures are in degC and their differences in K. The contact frame
//! moves with the patch: x along rolling, the leading edge at larger x, y to the left, z up into
//! the wheel. Tractions, forces and moments act on the wheel.

#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod reporting;
pub mod numerics;
pub mod surface;
pub mod bodies;
pub mod normal;
pub mod elasticity;
pub mod interface;
pub mod problem;
pub mod solution;
pub mod solver;
pub mod wheel_rail;
pub mod analysis;

pub use problem::{Method, Options, Problem, ProblemBuilder, Transient};
pub use reporting::{Error, Progress, Quantity, Warning, Watch, unwatched};
pub use solution::{Solution, Status};
pub use solver::Solver;
