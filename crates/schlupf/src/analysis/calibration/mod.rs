//! Stiffnesses with which the elastic layer behaves like the half-space in steady rolling. Neuhaus
//! and Sextro (2014) do not specify them.
//!
//! First the layer is fitted to the displacements of the half-space under the tractions of full
//! sticking and of full sliding ([`displacements`]), which gives a good start; then to creep forces
//! and tractions of rolling under longitudinal, lateral and spin creepage, single and combined, in
//! the limit of a stiff contact law. In units of the patch size √(ab) and the shear modulus G the
//! result depends on a/b and ν alone. The couplings along and across rolling are separate constants
//! for each component.

pub mod displacements;
mod kalker_bed;
mod rolling_contact;
mod rolling_fit;
pub mod side_by_side;

use std::sync::Arc;

use crate::elasticity::elastic_layer::ElasticLayer;
use crate::elasticity::{Elasticity, RelativeStiffness, Winkler, tabulated_stiffness};
use crate::numerics::least_squares::{Limits, Residuals, minimise};
use crate::reporting::{CalibrationError, Error, Watch};

pub use kalker_bed::KalkerBed;

use rolling_contact::SIZE;
use rolling_fit::{FITTED, Motions, OTHERS};

/// Result of a calibration.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Calibration {
    /// Axis ratio a/b of the patch, dimensionless.
    pub axis_ratio: f64,
    /// Combined Poisson's ratio ν, dimensionless.
    pub poisson_ratio: f64,
    /// Stiffnesses for displacements along and across rolling.
    pub stiffness: [RelativeStiffness; 2],
    /// Deviation of the layer from the half-space.
    pub layer: Deviation,
    /// Deviation of an uncoupled Winkler bedding fitted to the same forces.
    pub winkler: Deviation,
    /// Bedding c √(ab)/G of that Winkler bedding along and across rolling, dimensionless.
    pub winkler_bedding: [f64; 2],
    /// Whether the fits converged.
    pub converged: bool,
}

/// Deviations from the half-space over motions between and around those that were fitted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Deviation {
    /// Largest difference in force relative to μN under longitudinal and lateral creepage,
    /// dimensionless.
    pub force: f64,
    /// The same with spin, dimensionless.
    pub force_with_spin: f64,
    /// Difference of the tractions relative to those of the half-space, ‖t − t_h‖₂/‖t_h‖₂, mean
    /// over the motions without spin; dimensionless.
    pub field: f64,
    /// The same with spin, dimensionless.
    pub field_with_spin: f64,
}

/// Options of a calibration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CalibrationOptions {
    /// Cells across the patch in both directions.
    pub cells: usize,
    /// Maximum number of steps of each fit.
    pub max_iterations: usize,
}

impl Default for CalibrationOptions {
    fn default() -> Self {
        Self { cells: 20, max_iterations: 40 }
    }
}

/// Calibrates the layer for an axis ratio a/b and a combined Poisson's ratio (both dimensionless).
///
/// ```
/// use schlupf::analysis::calibration::{CalibrationOptions, calibrate};
/// use schlupf::unwatched;
///
/// let coarse = CalibrationOptions { cells: 6, ..CalibrationOptions::default() };
/// let layer = calibrate(1.0, 0.28, &coarse, &unwatched)?;
/// // Without coupling a bed of springs is farther from the half-space.
/// assert!(layer.converged && layer.layer.field < layer.winkler.field);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// An axis ratio that is not positive, a Poisson's ratio outside 0 to 0.5, and [`Error::Stopped`].
pub fn calibrate(
    axis_ratio: f64,
    poisson_ratio: f64,
    options: &CalibrationOptions,
    watch: Watch,
) -> Result<Calibration, Error> {
    let motions = Motions::new(axis_ratio, poisson_ratio, options.cells, &FITTED, watch)?;
    let limits = Limits {
        tolerance: 1e-4,
        reducible: 1e-4,
        negligible: 0.0,
        max_iterations: options.max_iterations,
    };
    let mut fit = LayerFit { motions: &motions };
    let start = motions.start()?;
    let found = minimise(&mut fit, &start, &limits)?;
    let mut uncoupled = WinklerFit { motions: &motions };
    let bed = minimise(
        &mut uncoupled,
        &[motions.slope_bedding()[0].ln(), motions.slope_bedding()[1].ln()],
        &limits,
    )?;
    let failed = || Error::from(CalibrationError::NotConverged { axis_ratio });
    let (found, bed) = (found.ok_or_else(failed)?, bed.ok_or_else(failed)?);
    let others = Motions::new(axis_ratio, poisson_ratio, options.cells, &OTHERS, watch)?;
    let deviation = |elasticity: Option<Arc<dyn Elasticity>>| match elasticity {
        Some(elasticity) => others.deviation(&elasticity)?.ok_or_else(failed),
        None => Err(failed()),
    };
    Ok(Calibration {
        axis_ratio,
        poisson_ratio,
        stiffness: relative(&found.parameters),
        layer: deviation(fit.layer(&found.parameters))?,
        winkler: deviation(uncoupled.bed(&bed.parameters))?,
        winkler_bedding: [bed.parameters[0].exp(), bed.parameters[1].exp()],
        converged: found.converged && bed.converged,
    })
}

/// Computes the deviation of the tabulated stiffnesses from the half-space.
///
/// ```
/// use schlupf::analysis::calibration::{CalibrationOptions, deviation_of_table};
/// use schlupf::unwatched;
///
/// let options = CalibrationOptions { cells: 10, ..CalibrationOptions::default() };
/// // Forces within 2 % of μN.
/// assert!(deviation_of_table(1.0, 0.28, &options, &unwatched)?.force < 0.02);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Ratios outside the table, and [`Error::Stopped`].
pub fn deviation_of_table(
    axis_ratio: f64,
    poisson_ratio: f64,
    options: &CalibrationOptions,
    watch: Watch,
) -> Result<Deviation, Error> {
    let motions = Motions::new(axis_ratio, poisson_ratio, options.cells, &OTHERS, watch)?;
    let [x, y] = tabulated_stiffness(axis_ratio, poisson_ratio)?
        .map(|relative| relative.absolute(motions.shear_modulus(), SIZE));
    let layer: Arc<dyn Elasticity> = Arc::new(ElasticLayer::new(x, y, None)?);
    motions.deviation(&layer)?.ok_or(CalibrationError::NotConverged { axis_ratio }.into())
}

/// Converts the logarithms of the bedding and of the two decay lengths of each component.
fn relative(parameters: &[f64]) -> [RelativeStiffness; 2] {
    [&parameters[..3], &parameters[3..]].map(|p| RelativeStiffness {
        bedding: p[0].exp(),
        reach_along_x: p[1].exp(),
        reach_along_y: p[2].exp(),
    })
}

/// Logarithms of the shortest and the longest decay length, relative to the patch, that are tried.
const REACH: [f64; 2] = [-4.0, 0.4];

/// Weight of the difference between the logarithms of the two decay lengths. It decides where
/// forces and fields hardly depend on it, so that the stiffnesses vary smoothly with a/b.
const EVENNESS: f64 = 0.3;

const ANY: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

struct LayerFit<'a> {
    motions: &'a Motions<'a>,
}

impl LayerFit<'_> {
    fn layer(&self, parameters: &[f64]) -> Option<Arc<dyn Elasticity>> {
        let [x, y] = relative(parameters)
            .map(|relative| relative.absolute(self.motions.shear_modulus(), SIZE));
        Some(Arc::new(ElasticLayer::new(x, y, None).ok()?))
    }
}

impl Residuals for LayerFit<'_> {
    fn residuals(&mut self, parameters: &[f64]) -> Result<Option<Vec<f64>>, Error> {
        let Some(layer) = self.layer(parameters) else { return Ok(None) };
        let mut residuals = self.motions.residuals(&layer, true)?;
        if let Some(residuals) = &mut residuals {
            residuals.extend([1, 4].map(|k| EVENNESS * (parameters[k] - parameters[k + 1])));
        }
        Ok(residuals)
    }

    fn bounds(&self, parameter: usize) -> [f64; 2] {
        if matches!(parameter, 0 | 3) { ANY } else { REACH }
    }
}

struct WinklerFit<'a> {
    motions: &'a Motions<'a>,
}

impl WinklerFit<'_> {
    fn bed(&self, parameters: &[f64]) -> Option<Arc<dyn Elasticity>> {
        let [x, y] = [0, 1].map(|k| parameters[k].exp() * self.motions.shear_modulus() / SIZE);
        Some(Arc::new(Winkler::new(x, y).ok()?))
    }
}

impl Residuals for WinklerFit<'_> {
    fn residuals(&mut self, parameters: &[f64]) -> Result<Option<Vec<f64>>, Error> {
        let Some(bed) = self.bed(parameters) else { return Ok(None) };
        self.motions.residuals(&bed, false)
    }
}
