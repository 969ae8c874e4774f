//! Exact solutions, for tests and comparisons.

pub mod carter;
pub mod cattaneo_mindlin;
pub mod haines_ollerton;
pub mod kalker_linear;
pub mod moving_source;
pub mod sliding_line_contact;
pub mod winkler_strip;
pub mod westergaard;
