//! Shared numerics: numbers side by side or with derivatives, vector operations, interpolation,
//! roots and minima, sums over the corners of rectangles.

pub mod parallel;
pub(crate) mod vector;
pub(crate) mod least_squares;
pub(crate) mod fourier;

pub(crate) mod anderson;
pub(crate) mod dual;
pub(crate) mod interpolation;
pub(crate) mod lanes;
pub(crate) mod love;
pub(crate) mod quadrature;
pub(crate) mod root;
pub(crate) mod upstream;
