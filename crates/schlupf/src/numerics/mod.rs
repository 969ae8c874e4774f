//! Shared numerics: numbers side by side, vector operations, interpolation, roots and minima, sums
//! over the corners of rectangles.

pub(crate) mod interpolation;
pub(crate) mod lanes;
pub(crate) mod love;
pub(crate) mod root;
pub(crate) mod vector;
