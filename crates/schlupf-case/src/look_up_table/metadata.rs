//! What a file says about its table.

use schlupf::analysis::table_building::{
    BuiltTable, LONGER_SIDE_EXPONENT, TableError, TableOptions,
};
use serde::{Deserialize, Serialize};

/// What `metadata.json` calls the format.
pub(crate) const FORMAT: &str = "schlupf look-up table";

/// Version of the format: of the arrays, and of how forces follow from them.
pub(crate) const VERSION: u32 = 1;

/// What a table holds for, how it was made, and how good it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Metadata {
    /// The format.
    pub format: String,
    /// Its version.
    pub version: u32,
    /// The program that made the table.
    pub program: String,
    /// `half-space`.
    pub elasticity: String,
    /// `coulomb`.
    pub contact_law: String,
    /// `constant`.
    pub friction: String,
    /// ν, dimensionless.
    pub poisson_ratio: f64,
    /// Number of nodes in a/b, azimuth, inclination and saturation.
    pub nodes: [usize; 4],
    /// Error that was asked for, dimensionless.
    pub tolerance: f64,
    /// Whether random states were within it.
    pub is_within_tolerance: bool,
    /// Error in other random states of rolling.
    pub error: StatedError,
    /// Error in other random states of sliding without rolling; earlier files do not say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sliding_error: Option<StatedError>,
    /// Solutions at nodes.
    pub solutions: usize,
    /// Solutions of these, and of the random states, that did not converge.
    pub unconverged: usize,
    /// Cells across the narrower side of the patch of the coarser grids.
    pub cells: usize,
    /// Cells along the longer side over those across the narrower one: the ratio of the sides to
    /// this power. Earlier files do not say; their grids have as many along both.
    #[serde(default)]
    pub longer_side_exponent: f64,
    /// SHA-256 of all arrays in the order of their names, in hexadecimal digits.
    pub sha256: String,
}

/// Errors of forces over μN and moments over μN √(ab), the larger of both, dimensionless: see
/// [`TableError`](schlupf::analysis::table_building::TableError).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StatedError {
    /// Number of random states.
    pub states: usize,
    /// Median, dimensionless.
    pub median: f64,
    /// 90 % are below this, dimensionless.
    pub ninety_percent: f64,
    /// The largest, dimensionless.
    pub largest: f64,
}

impl StatedError {
    fn new(error: &TableError) -> Self {
        Self {
            states: error.states,
            median: rounded(error.median),
            ninety_percent: rounded(error.ninety_percent),
            largest: rounded(error.largest),
        }
    }
}

/// Four digits of a number (dimensionless), which are read again as they are written.
fn rounded(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

impl Metadata {
    /// Of a table that was made with these options.
    pub(crate) fn new(built: &BuiltTable, options: &TableOptions, sha256: String) -> Self {
        let nodes = built.table.nodes();
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            program: concat!("schlupf ", env!("CARGO_PKG_VERSION")).to_owned(),
            elasticity: "half-space".to_owned(),
            contact_law: "coulomb".to_owned(),
            friction: "constant".to_owned(),
            poisson_ratio: nodes.poisson_ratio,
            nodes: [
                nodes.axis_ratios.len(),
                nodes.azimuths.len(),
                nodes.inclinations.len(),
                nodes.saturations.len(),
            ],
            tolerance: options.tolerance,
            is_within_tolerance: built.is_within_tolerance,
            error: StatedError::new(&built.error),
            sliding_error: Some(StatedError::new(&built.sliding_error)),
            solutions: built.solutions,
            unconverged: built.unconverged,
            cells: options.cells,
            longer_side_exponent: LONGER_SIDE_EXPONENT,
            sha256,
        }
    }
}
