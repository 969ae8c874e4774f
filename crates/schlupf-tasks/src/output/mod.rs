//! Output of solutions: JSON, CSV, VTK, a text summary, and figures.
//!
//! Every function takes a [`Solution`](schlupf::Solution), a family of creep curves, temperatures
//! along lines, the heat balance of a wheel, a comparison of methods, calibrated stiffnesses, a
//! fit, a rough contact, stresses below the surface or the damage of a passage or a run, and
//! returns text or bytes; writing files is left to the caller. Tractions and forces act on the
//! wheel in all tables; the figures show the traction on the rail, −t, as in Neuhaus and Sextro
//! (2014), and say so on their axes.

#[cfg(feature = "bulk")]
pub mod bulk_temperature;
#[cfg(feature = "fitting")]
pub mod calibration;
#[cfg(feature = "compare")]
pub mod comparison;
pub mod contact_law;
pub mod creep_curve;
pub mod damage;
pub mod figures;
#[cfg(feature = "fitting")]
pub mod identification;
pub(crate) mod json;
mod number;
pub mod profiles;
pub mod report;
pub mod roughness;
pub mod solution;
pub mod subsurface;
pub mod summary;
pub mod table;
pub mod temperature;
mod vtk;
pub mod wear;
pub mod wheelset;

pub use number::significant;
pub use report::Report;
pub use summary::Summary;
