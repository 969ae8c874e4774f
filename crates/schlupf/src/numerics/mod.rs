//! Shared numerics: vector operations, interpolation, roots and minima, sums over the corners of
//! rectangles.

pub(crate) mod interpolation;
pub(crate) mod love;
pub(crate) mod root;
pub(crate) mod vector;
