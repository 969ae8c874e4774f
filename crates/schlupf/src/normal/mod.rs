//! Normal contact: the pressure, an input of the tangential problem.

mod grid;
mod tabulated;
pub mod patch;
mod at_load;
mod ellipse;
mod hertz;
mod line;
pub mod rough_contact;
pub mod profile;
mod opened;

pub use hertz::{Hertz, Radii};
pub(crate) use hertz::{approach_shares, row_potential, shares_and_pressure};

pub use at_load::AtLoad;
pub use ellipse::Ellipse;
pub use grid::{Axis, BORDER, Extent, Grid, VectorField};
pub use line::Line;
pub(crate) use opened::Opened;
pub(crate) use tabulated::positive_runs;
pub use tabulated::{PressureTable, Tabulated};

use std::fmt::Debug;
use std::sync::Arc;

use crate::bodies::RowMotion;
use crate::reporting::{Error, Quantity, Warning, Watch};

/// A source of the normal pressure. Extension point.
///
/// ```
/// use std::f64::consts::PI;
///
/// use schlupf::normal::{NormalContact, NormalSummary, Pressure, PressureSource};
/// use schlupf::{Error, Options, Problem, solver, unwatched};
///
/// /// A patch that widens with the load like those of worn profiles, its length fixed.
/// #[derive(Debug)]
/// struct Worn;
///
/// impl PressureSource for Worn {
///     fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
///         let load = load.unwrap_or(80e3);
///         let (a, b) = (5e-3, 10e-3 * (load / 80e3).sqrt());
///         let summary = NormalSummary {
///             load,
///             semi_axis_x: a,
///             semi_axis_y: b,
///             peak_pressure: 1.5 * load / (PI * a * b),
///             approach: None,
///             origin: None,
///             parts: 1,
///         };
///         Ok(NormalContact { summary, pressure: Pressure::Elliptic, rows: None })
///     }
///
///     // It changes its shape with the load.
///     fn load_exponent(&self) -> Option<f64> {
///         None
///     }
/// }
///
/// let problem = Problem::builder().normal(Worn).creepage_y(0.02).build()?;
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let solution = solver::solve(&problem, &options, &unwatched)?;
/// assert!((solution.normal.load - 80e3).abs() < 1e-9);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub trait PressureSource: Debug + Send + Sync {
    /// The normal contact under `load` (in N), or under the source's own load.
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error>;

    /// Computes in advance the time-consuming parts of the normal contact under `load` (in N), or
    /// under the source's own load.
    ///
    /// # Errors
    /// As [`Self::normal_contact`], and [`Error::Stopped`].
    fn prepare(&self, _load: Option<f64>, _watch: Watch) -> Result<(), Error> {
        Ok(())
    }

    /// The undeformed distance of the two bodies (in m) at the positions `x` × `y` (in m) in the
    /// contact frame, rows along x, apart from a constant. With it the tractions of unlike bodies
    /// change the pressure; `None` if it is not known.
    fn undeformed_distance(&self, _x: &[f64], _y: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// The rectangle on which it is known, x and y in m in the contact frame.
    fn distance_bounds(&self) -> [[f64; 2]; 2] {
        [[f64::NEG_INFINITY, f64::INFINITY]; 2]
    }

    /// Cells across the contact in each direction on which that change is solved.
    fn cells(&self) -> usize {
        profile::Profile::DEFAULT_CELLS
    }

    /// The power of the load with which the lengths of the patch grow (dimensionless), if only the
    /// load changes in the description of the source: 1/3 for two bodies of given curvature, 0 for
    /// a patch of given size. `None` if the patch changes its shape or the power is not known; then
    /// there are no derivatives with respect to the load.
    fn load_exponent(&self) -> Option<f64> {
        Some(0.0)
    }

    /// A warning about the pressure source for whoever uses the results.
    fn caveat(&self) -> Option<Warning> {
        None
    }
}

/// A loaded normal contact.
#[derive(Debug, Clone)]
pub struct NormalContact {
    /// Its sizes.
    pub summary: NormalSummary,
    /// Its pressure.
    pub pressure: Pressure,
    /// How its rows slip beyond the motion of the plane, if the surfaces turn across it; in the
    /// contact frame.
    pub rows: Option<Arc<RowMotion>>,
}

/// Sizes of a normal contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalSummary {
    /// Normal load N, in N.
    pub load: f64,
    /// Semi-axis a along rolling, in m; half the extent if the patch is not an ellipse.
    pub semi_axis_x: f64,
    /// Semi-axis b across rolling, in m; half the extent if the patch is not an ellipse.
    pub semi_axis_y: f64,
    /// Largest pressure p0, in Pa.
    pub peak_pressure: f64,
    /// Approach of distant points of the two bodies, in m, if the source computes it.
    pub approach: Option<f64>,
    /// Position of the origin of the contact frame in the coordinates of the source's file, x and y
    /// in m; `None` without a file.
    pub origin: Option<[f64; 2]>,
    /// Number of separate parts of the patch.
    pub parts: usize,
}

/// A distribution of normal pressure.
#[derive(Debug, Clone)]
pub enum Pressure {
    /// p0 √(1 − x²/a² − y²/b²), with the sizes of the summary (Hertz 1882).
    Elliptic,
    /// p0 √(1 − x²/a²) on a rectangle of these sizes: a line contact.
    Line,
    /// A table times a factor (dimensionless).
    Tabulated(Arc<PressureTable>, f64),
}

impl NormalSummary {
    /// Semi-axes along and across rolling, in m.
    pub fn semi_axes(&self) -> [f64; 2] {
        [self.semi_axis_x, self.semi_axis_y]
    }

    /// That of the same bodies under another load (in N), with lengths that grow with a power of
    /// the load.
    pub(crate) fn under(&self, load: f64, exponent: f64) -> Self {
        let part = load / self.load;
        let growth = part.powf(exponent);
        Self {
            load,
            semi_axis_x: growth * self.semi_axis_x,
            semi_axis_y: growth * self.semi_axis_y,
            peak_pressure: part / (growth * growth) * self.peak_pressure,
            // N ∝ d^(3/2) where a ∝ N^(1/3).
            approach: self.approach.map(|approach| growth * growth * approach),
            ..*self
        }
    }
}

impl NormalContact {
    /// Whether its pressure does not change across rolling.
    pub(crate) fn is_line(&self) -> bool {
        match &self.pressure {
            Pressure::Elliptic => false,
            Pressure::Line => true,
            Pressure::Tabulated(table, _) => table.is_line(),
        }
    }

    /// Refuses a line contact where `assumed_by` takes the patch for an ellipse.
    pub(crate) fn refuse_line(&self, assumed_by: Quantity) -> Result<(), Error> {
        match self.pressure {
            Pressure::Line => Err(Error::LineIsNoEllipse { assumed_by }),
            Pressure::Elliptic | Pressure::Tabulated(..) => Ok(()),
        }
    }

    /// The bounding rectangle of the patch.
    pub fn extent(&self) -> Extent {
        match &self.pressure {
            Pressure::Elliptic | Pressure::Line => {
                let (a, b) = (self.summary.semi_axis_x, self.summary.semi_axis_y);
                Extent { x: [-a, a], y: [-b, b] }
            }
            Pressure::Tabulated(table, _) => table.extent(),
        }
    }
}

/// With the components of its origin as separate fields.
#[cfg(feature = "serde")]
impl serde::Serialize for NormalSummary {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;

        let mut fields = serializer.serialize_struct("NormalSummary", 8)?;
        fields.serialize_field("load", &self.load)?;
        fields.serialize_field("semi_axis_x", &self.semi_axis_x)?;
        fields.serialize_field("semi_axis_y", &self.semi_axis_y)?;
        fields.serialize_field("peak_pressure", &self.peak_pressure)?;
        fields.serialize_field("approach", &self.approach)?;
        fields.serialize_field("origin_x", &self.origin.map(|[x, _]| x))?;
        fields.serialize_field("origin_y", &self.origin.map(|[_, y]| y))?;
        fields.serialize_field("parts", &self.parts)?;
        fields.end()
    }
}
