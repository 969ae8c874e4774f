//! Written by the test `the_table_is_that_of_the_computation` of [`crate::calibration`].

/// Poisson's ratios of the rows: multiples of this, from zero on; dimensionless.
pub(super) const POISSON_RATIO_STEP: f64 = 0.5 / 3.0;

/// Axes ratio a/b of the first entry of a row, dimensionless.
pub(super) const LEAST_AXIS_RATIO: f64 = 0.1;

/// Ratio of each axes ratio to the one before, dimensionless.
pub(super) const AXIS_RATIO_STEP: f64 = 1.584_893_192_461_113_5;

/// Bedding and the two reaches for displacements along x, and the same for those along y.
pub(super) const TABLE: [[[f64; 6]; 11]; 4] = [[[1.0, 0.2, 0.2, 1.0, 0.2, 0.2]; 11]; 4];
