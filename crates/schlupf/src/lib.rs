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

pub mod quantity;
pub mod message;
pub mod requirement;
pub mod error;
pub mod warning;
pub mod tally;
mod numerics;
pub mod progress;
pub mod parallel;
mod least_squares;
pub mod material;
pub mod kinematics;
pub mod row_motion;
pub mod grid;
mod fourier;
pub mod surface;
pub mod normal;
pub mod patch;
pub mod elasticity;
pub mod interface;
mod settings;
mod equilibrium;
pub mod heat;
pub mod prescribed_forces;
pub mod history;
pub mod look_up_table;
pub mod method;
pub mod state;
pub mod problem;
mod builder;
pub mod transient;
pub mod solution;
mod summary;
pub mod solver;
mod reference_point;
pub mod reference;
pub mod kalker_coefficients;
pub mod simplified;
pub mod rolling;
pub mod prescribed;
pub mod wheel_rail;
pub mod temperature_field;
pub mod subsurface;
pub mod bulk_temperature;
pub mod damage;
pub mod creep_curve;
pub mod calibration;
pub mod identification;
pub mod table_building;
pub mod columns;
#[cfg(feature = "serde")]
mod serialize;

pub use builder::ProblemBuilder;
pub use error::Error;
pub use method::Method;
pub use problem::{Options, Problem};
pub use progress::{Progress, Watch, unwatched};
pub use quantity::Quantity;
pub use solution::{Solution, Status};
pub use solver::Solver;
pub use transient::Transient;
pub use warning::Warning;
