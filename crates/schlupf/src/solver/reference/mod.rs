//! Exact solutions, for tests and comparisons.

mod carter;
mod cattaneo_mindlin;
mod haines_ollerton;
mod kalker_linear;
mod moving_source;
mod sliding_line_contact;
pub mod winkler_strip;
mod westergaard;

pub use carter::Carter;
pub use cattaneo_mindlin::CattaneoMindlin;
pub use haines_ollerton::HainesOllerton;
pub use kalker_linear::CreepCoefficients;
pub(crate) use kalker_linear::linear_force;
pub use moving_source::SemiEllipticSource;
pub use sliding_line_contact::SlidingLineContact;
pub use westergaard::Westergaard;
