//! Rolling contact of wheel and rail: tangential stress, slip and temperature in the contact patch.
//!
//! The model is that of Neuhaus and Sextro, *Thermo-mechanical model for wheel rail contact using
//! coupled point contact elements* (ICCM 2014); equation numbers without a source in this crate are
//! theirs.
//!
//! All quantities are SI, temperatures are in degC and their differences in K. The contact frame
//! moves with the patch: x along rolling, the leading edge at larger x, y to the left, z up into
//! the wheel. Tractions, forces and moments act on the wheel.
//!
//! # From a problem to its solution
//!
//! A [`Problem`] is what presses wheel and rail together ([`normal`]), how they move ([`bodies`])
//! or what force moves them, and the [`Interface`]: their [`elasticity`], contact law, friction and
//! heat. A builder has all of it, for a steel wheel on a steel rail unless told otherwise;
//! [`Options`] say how accurately to solve, and [`solve`] finds the steady state.
//!
//! ```
//! use schlupf::elasticity::HalfSpace;
//! use schlupf::bodies::Material;
//! use schlupf::interface::friction::TemperatureLinear;
//! use schlupf::{Options, Problem, Status, solve, unwatched};
//!
//! let problem = Problem::builder()
//!     .load(100e3)
//!     .speed(40.0)
//!     .creepage_x(0.01)
//!     .elasticity(HalfSpace::new(&Material::STEEL, &Material::STEEL)?)
//!     .friction(TemperatureLinear::new(0.35, 700.0, 0.1)?)
//!     .build()?;
//! let options = Options { cells_x: 16, cells_y: 16, ..Options::default() };
//! let solution = solve(&problem, &options, &unwatched)?;
//!
//! // Braking: the force on the wheel points backwards, and what it gives is heat.
//! assert_eq!(solution.status, Status::Converged);
//! assert!(solution.force.x < 0.0 && solution.traction_coefficient < 0.35);
//! assert!(solution.temperature.is_some_and(|found| found.max_rise_rail > 100.0));
//! # Ok::<(), schlupf::Error>(())
//! ```
//!
//! A [`Solver`] keeps what many states of one contact share: a curve takes a fraction of the time
//! of its points. A [`Method`] makes one, that of the full equations or a fast one.
//!
//! ```
//! use schlupf::problem::FastMethod;
//! use schlupf::{Method, Options, Problem, unwatched};
//!
//! let options = Options { cells_x: 12, cells_y: 12, ..Options::default() };
//! for method in [Method::Full, Method::Fast(FastMethod::ShenHedrickElkins)] {
//!     let mut solver = method.solver(&options);
//!     for creepage in [1e-4, 1e-3, 1e-2] {
//!         let problem = Problem::builder().creepage_x(creepage).build()?;
//!         println!("{creepage} {}", solver.solve(&problem, &unwatched)?.traction_coefficient);
//!     }
//! }
//! # Ok::<(), schlupf::Error>(())
//! ```
//!
//! What changes with time is a [`Transient`], which [`march`] follows step by step. Two
//! profiles and the position of a wheelset are a [`WheelOnRail`](wheel_rail::WheelOnRail), and a
//! contact in the loop of a simulation is an [`Element`](element::Element).
//! [`analysis`] has what follows from solutions: stresses and temperatures below the surface, wear,
//! creep curves, the laws behind measured ones, look-up tables.
//!
//! # Laws of one's own
//!
//! Each of these traits is introduced by an implementation:
//! [`FrictionLaw`](interface::friction::FrictionLaw),
//! [`PressureSource`](normal::PressureSource), [`Elasticity`](elasticity::Elasticity),
//! [`HeatModel`](interface::heat::HeatModel),
//! [`PartitionLaw`](interface::heat::PartitionLaw), and
//! [`CreepForceModel`](analysis::identification::CreepForceModel).
//!
//! The modules are listed in the order of data flow: each uses only modules above it.

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
pub mod element;
pub mod analysis;

pub use interface::Interface;
pub use problem::{Method, Options, Problem, ProblemBuilder, Transient};
pub use reporting::{Error, Progress, Quantity, Warning, Watch, unwatched};
pub use solution::{Solution, Status};
pub use solver::{Solver, march, solve};
