//! The elastic layer with stiffnesses that make it answer like the half-space, which Neuhaus and
//! Sextro (2014) leave open: from a table over the patch's axes ratio and Poisson's ratio, made by
//! [`crate::calibration`].

use super::calibration_table::{AXIS_RATIO_STEP, LEAST_AXIS_RATIO, POISSON_RATIO_STEP, TABLE};
use super::elastic_layer::{ElasticLayer, LayerStiffness};
use super::half_space::HalfSpace;
use super::{Compliance, Elasticity};
use crate::error::{Error, require};
use crate::grid::{BORDER, Grid};
use crate::material::Material;
use crate::numerics::interpolation::cubic;
use crate::quantity::Quantity;
use crate::requirement::Requirement;
use crate::warning::Warning;

/// Stiffness of the layer for one displacement component, relative to the patch: s = √(ab) its
/// size, G the combined shear modulus of the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeStiffness {
    /// Bedding c s/G, dimensionless.
    pub bedding: f64,
    /// Decay length along rolling over the size, √(g_x/c)/s; dimensionless.
    pub reach_along_x: f64,
    /// Decay length across rolling over the size, √(g_y/c)/s; dimensionless.
    pub reach_along_y: f64,
}

impl RelativeStiffness {
    /// For a shear modulus G (in Pa) and a size s (in m).
    pub fn absolute(&self, shear_modulus: f64, size: f64) -> LayerStiffness {
        let bedding = self.bedding * shear_modulus / size;
        LayerStiffness {
            bedding,
            coupling_along_x: bedding * (self.reach_along_x * size).powi(2),
            coupling_along_y: bedding * (self.reach_along_y * size).powi(2),
        }
    }
}

/// Axes ratios a/b for which the table holds, dimensionless.
pub const AXIS_RATIO_RANGE: [f64; 2] = [0.1, 10.0];

/// Stiffnesses for displacements along and across rolling, for an axes ratio a/b and a combined
/// Poisson's ratio ν (both dimensionless): cubic in ln(a/b) and in ν between the entries of the
/// table, whose logarithms are interpolated.
///
/// ```
/// use schlupf::elasticity::calibrated_layer::tabulated_stiffness;
///
/// // A circle is the same along and across rolling, but rolling is not.
/// let [along, across] = tabulated_stiffness(1.0, 0.0)?;
/// assert!((along.bedding / across.bedding - 1.0).abs() < 0.2);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn tabulated_stiffness(
    axis_ratio: f64,
    poisson_ratio: f64,
) -> Result<[RelativeStiffness; 2], Error> {
    let [least, largest] = AXIS_RATIO_RANGE;
    // Half a percent for grids whose patch is not quite that of the axes.
    let is_known = (0.995 * least..=1.005 * largest).contains(&axis_ratio);
    if !is_known {
        return Err(Error::BeyondCalibration { axis_ratio, range: AXIS_RATIO_RANGE });
    }
    require(Quantity::PoissonRatio, Requirement::Between(0.0, 0.5), poisson_ratio)?;
    let (first_row, across) = cubic(poisson_ratio / POISSON_RATIO_STEP, TABLE.len());
    let steps = (axis_ratio / LEAST_AXIS_RATIO).ln() / AXIS_RATIO_STEP.ln();
    let (first, along) = cubic(steps, TABLE[0].len());
    let value = |k: usize| {
        let row = |row: usize| -> f64 {
            (0..4).map(|n| along[n] * TABLE[first_row + row][first + n][k].ln()).sum()
        };
        (0..4).map(|n| across[n] * row(n)).sum::<f64>().exp()
    };
    let component = |k: usize| RelativeStiffness {
        bedding: value(k),
        reach_along_x: value(k + 1),
        reach_along_y: value(k + 2),
    };
    Ok([component(0), component(3)])
}

/// A layer that in steady rolling answers like the half-space of two bodies, whatever the patch.
///
/// Its stiffnesses follow from the size of the grid: a = half its length, b = half its width. On
/// elliptic patches forces agree with those of the half-space as [`crate::calibration`] says;
/// others, and several parts together, are treated like the ellipse with the same extent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CalibratedLayer {
    half_space: HalfSpace,
    margin: Option<f64>,
}

impl CalibratedLayer {
    /// For two bodies, with at least `margin` (in m) of surroundings on each side; eight decay
    /// lengths if none.
    pub fn new(wheel: &Material, rail: &Material, margin: Option<f64>) -> Result<Self, Error> {
        let half_space = HalfSpace::new(wheel, rail)?;
        Ok(Self { half_space, margin })
    }

    /// Stiffnesses for displacements along and across rolling, for a patch with these semi-axes
    /// along and across rolling (in m).
    pub fn stiffness(&self, semi_axes: [f64; 2]) -> Result<[LayerStiffness; 2], Error> {
        let [a, b] = semi_axes;
        let size = (a * b).sqrt();
        let relative = tabulated_stiffness(a / b, self.half_space.poisson_ratio())?;
        Ok(relative.map(|stiffness| stiffness.absolute(self.half_space.shear_modulus(), size)))
    }

    /// The layer for a patch with these semi-axes along and across rolling, in m.
    pub fn layer(&self, semi_axes: [f64; 2]) -> Result<ElasticLayer, Error> {
        let [x, y] = self.stiffness(semi_axes)?;
        ElasticLayer::new(x, y, self.margin)
    }
}

impl Elasticity for CalibratedLayer {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        let half = |cells: usize, spacing: f64| 0.5 * cells as f64 * spacing;
        let semi_axes =
            [half(grid.columns - 2 * BORDER, grid.spacing_x), half(grid.rows, grid.spacing_y)];
        self.layer(semi_axes)?.growing(grid, GROWTH)
    }

    fn caveat(&self) -> Option<Warning> {
        self.half_space.caveat()
    }

    fn caveat_of_parts(&self, parts: usize) -> Option<Warning> {
        (parts > 1).then_some(Warning::LayerOfParts { parts })
    }
}

/// Its displacements go with this power of the patch's size, like those of the half-space.
const GROWTH: f64 = 1.0;
