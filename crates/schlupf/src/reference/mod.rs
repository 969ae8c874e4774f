//! Exact solutions, to test against and to compare with.

pub mod moving_source;
pub mod winkler_strip;
