//! Stiffnesses of the layer from displacements under known tractions: those of the half-space, or
//! of a finite-element model.
//!
//! A rigid displacement of the whole surface has no effect in rolling, and the displacement far
//! from the patch differs from model to model; each sample may therefore be shifted as a whole.

use crate::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
use crate::elasticity::{Compliance, Elasticity};
use crate::normal::{Grid, VectorField};
use crate::numerics::least_squares::{Limits, Residuals, minimise};
use crate::numerics::vector::{dot, norm};
use crate::reporting::{CalibrationError, Error, Quantity, require_positive, require_several};
use crate::solution::Solution;

/// Traction and displacement of one component on the cells of a grid.
#[derive(Debug, Clone)]
pub struct Sample {
    /// The grid.
    pub grid: Grid,
    /// Traction in every cell, in Pa.
    pub traction: Vec<f64>,
    /// Displacement difference wheel minus rail (in m) where known.
    pub displacement: Vec<Option<f64>>,
}

impl Sample {
    /// A sample with a value in every cell.
    pub fn new(
        grid: Grid,
        traction: Vec<f64>,
        displacement: Vec<Option<f64>>,
    ) -> Result<Self, Error> {
        for (quantity, count) in [
            (Quantity::SampleTraction, traction.len()),
            (Quantity::SampleDisplacement, displacement.len()),
        ] {
            if count != grid.len() {
                return Err(Error::WrongCount { quantity, expected: grid.len(), count });
            }
        }
        let largest = traction.iter().fold(0.0, |largest: f64, t| largest.max(t.abs()));
        require_positive(Quantity::SampleTraction, largest)?;
        require_several(Quantity::SampleDisplacement, 4, displacement.iter().flatten().count())?;
        Ok(Self { grid, traction, displacement })
    }

    /// Component 0 (x) or 1 (y) of a solution, in the cells of its patch.
    pub(super) fn of(solution: &Solution, component: usize) -> Self {
        let fields = &solution.fields;
        let (tractions, displacements) = if component == 0 {
            (&fields.traction_x, &fields.displacement_x)
        } else {
            (&fields.traction_y, &fields.displacement_y)
        };
        let grid = fields.grid;
        let mut traction = vec![0.0; grid.len()];
        let mut displacement = vec![None; grid.len()];
        for (k, [i, j]) in fields.cell.iter().enumerate() {
            let index = grid.index(*i, *j);
            traction[index] = tractions[k];
            displacement[index] = Some(displacements[k]);
        }
        Self { grid, traction, displacement }
    }
}

/// A fitted component.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct DisplacementFit {
    /// Bedding c, in N/m³.
    pub bedding: f64,
    /// Coupling along rolling, in N/m.
    pub coupling_along_x: f64,
    /// Coupling across rolling, in N/m.
    pub coupling_along_y: f64,
    /// ‖u − u_given‖₂/‖u_given‖₂ of each sample, after subtracting the means; dimensionless.
    pub deviation: Vec<f64>,
    /// Whether the decay lengths along and across rolling are not determined by the displacements:
    /// they are at an end of the admissible range.
    pub is_open: [bool; 2],
    /// Whether the fit converged.
    pub converged: bool,
}

impl DisplacementFit {
    /// Largest deviation of a sample, dimensionless.
    pub fn largest_deviation(&self) -> f64 {
        self.deviation.iter().copied().fold(0.0, f64::max)
    }
}

/// Residuals are relative to the displacements and smooth to rounding error.
const LIMITS: Limits =
    Limits { tolerance: 1e-6, reducible: 1e-8, negligible: 1e-16, max_iterations: 200 };

/// Bounds of the logarithm of the ratio of decay length to the longer side of the grid.
const REACH: [f64; 2] = [-6.0, 0.5];

/// Number of decay lengths tried as a start, the same along and across.
const STARTS: usize = 14;

/// Fits bedding and couplings to samples. The fit starts from the best of some decay lengths, each
/// with its optimal bedding: displacements are inversely proportional to it.
///
/// ```
/// use schlupf::analysis::calibration::displacements::{Sample, fit};
/// use schlupf::normal::Grid;
///
/// let grid =
///     Grid { columns: 9, rows: 9, spacing_x: 1e-3, spacing_y: 1e-3, ..Grid::default() };
/// // One loaded cell of springs that are not coupled.
/// let middle = |value| (0..81).map(|cell| if cell == 40 { value } else { 0.0 }).collect();
/// let displacement = Vec::into_iter(middle(1e-6)).map(Some).collect();
/// let found = fit(&[Sample::new(grid, middle(1e7), displacement)?])?;
/// assert!((found.bedding / 1e13 - 1.0).abs() < 0.05);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// No samples; displacements opposite to their load; or a layer that cannot be set up.
pub fn fit(samples: &[Sample]) -> Result<DisplacementFit, Error> {
    require_several(Quantity::Samples, 1, samples.len())?;
    let length = samples
        .iter()
        .map(|s| {
            (s.grid.columns as f64 * s.grid.spacing_x).max(s.grid.rows as f64 * s.grid.spacing_y)
        })
        .fold(0.0, f64::max);
    let mut fit = Fit { samples, length };
    let start = fit.start()?;
    let found = minimise(&mut fit, &start, &LIMITS)?.ok_or(CalibrationError::NoLayer {})?;
    let stiffness = fit.stiffness(&found.parameters);
    let mut deviation = Vec::with_capacity(samples.len());
    let mut rest = found.residuals.as_slice();
    for sample in samples {
        let (own, others) = rest.split_at(sample.displacement.iter().flatten().count());
        deviation.push(norm(own));
        rest = others;
    }
    Ok(DisplacementFit {
        bedding: stiffness.bedding,
        coupling_along_x: stiffness.coupling_along_x,
        coupling_along_y: stiffness.coupling_along_y,
        deviation,
        is_open: [found.is_held[1], found.is_held[2]],
        converged: found.converged,
    })
}

struct Fit<'a> {
    samples: &'a [Sample],
    /// Longer side of the grids, in m.
    length: f64,
}

impl Fit<'_> {
    fn stiffness(&self, parameters: &[f64]) -> LayerStiffness {
        let bedding = parameters[0].exp();
        let coupling = |reach: f64| bedding * (reach.exp() * self.length).powi(2);
        LayerStiffness {
            bedding,
            coupling_along_x: coupling(parameters[1]),
            coupling_along_y: coupling(parameters[2]),
        }
    }

    /// The best of some decay lengths, with its bedding.
    fn start(&self) -> Result<Vec<f64>, Error> {
        let [least, largest] = REACH;
        let reach = |n: usize| least + (largest - least) * (n as f64 + 0.5) / STARTS as f64;
        let mut best: Option<(f64, Vec<f64>)> = None;
        for reach in (0..STARTS).map(reach) {
            // For the layer with a bedding of one.
            let [mut along, mut squares] = [0.0; 2];
            for sample in self.samples {
                let [unit, given] = self
                    .displacements(sample, &[0.0, reach, reach])
                    .ok_or(CalibrationError::NoLayer {})?;
                along += dot(&unit, &given);
                squares += dot(&unit, &unit);
            }
            // The sum of squares with the optimal bedding squares/along is lower by this than
            // without a layer.
            let gain = along * along.abs() / squares;
            if along > 0.0 && best.as_ref().is_none_or(|(most, _)| gain > *most) {
                best = Some((gain, vec![(squares / along).ln(), reach, reach]));
            }
        }
        best.map(|(_, start)| start).ok_or(CalibrationError::AgainstLoad {}.into())
    }

    /// Displacements of the layer and the known ones, each minus its mean and divided by the norm
    /// of the known ones; dimensionless.
    fn displacements(&self, sample: &Sample, parameters: &[f64]) -> Option<[Vec<f64>; 2]> {
        let stiffness = self.stiffness(parameters);
        let layer = ElasticLayer::new(stiffness, stiffness, None).ok()?;
        Some(compared(sample, layer.compliance(&sample.grid).ok()?.as_mut()))
    }
}

impl Residuals for Fit<'_> {
    fn residuals(&mut self, parameters: &[f64]) -> Result<Option<Vec<f64>>, Error> {
        let pairs = self.samples.iter().map(|sample| {
            let [found, given] = self.displacements(sample, parameters)?;
            Some(found.into_iter().zip(given).map(|(u, v)| u - v))
        });
        let pairs: Option<Vec<_>> = pairs.collect();
        Ok(pairs.map(|pairs| pairs.into_iter().flatten().collect()))
    }

    fn bounds(&self, parameter: usize) -> [f64; 2] {
        if parameter == 0 { [f64::NEG_INFINITY, f64::INFINITY] } else { REACH }
    }

    fn difference_step(&self) -> f64 {
        1e-6
    }
}

fn compared(sample: &Sample, compliance: &mut dyn Compliance) -> [Vec<f64>; 2] {
    let cells = sample.grid.len();
    let traction = VectorField { x: sample.traction.clone(), y: vec![0.0; cells] };
    let mut found = VectorField::zeros(cells);
    compliance.displacement(&traction, &mut found);
    let pairs = found.x.iter().zip(&sample.displacement).filter_map(|(u, v)| Some((*u, (*v)?)));
    let (found, given): (Vec<f64>, Vec<f64>) = pairs.unzip();
    let less_mean = |values: Vec<f64>| -> Vec<f64> {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.iter().map(|value| value - mean).collect()
    };
    let (found, given) = (less_mean(found), less_mean(given));
    let size = norm(&given);
    [found, given].map(|values| values.into_iter().map(|value| value / size).collect())
}
