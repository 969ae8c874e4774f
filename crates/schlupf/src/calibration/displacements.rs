//! Stiffnesses of the layer from displacements under known tractions: of the half-space, or of a
//! finite-element model.
//!
//! A rigid displacement of the whole surface does not matter in rolling, and what it is far from the
//! patch is different in every model; so each sample may be shifted as a whole.

use faer::Mat;

use crate::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
use crate::elasticity::{Compliance, Elasticity};
use crate::error::{Error, require, require_positive};
use crate::grid::{Grid, VectorField};
use crate::least_squares::{Limits, Residuals, minimise};
use crate::solution::Solution;

/// Traction and displacement of one component on the cells of a grid.
#[derive(Debug, Clone)]
pub struct Sample {
    /// The grid.
    pub grid: Grid,
    /// Traction in every cell, in Pa.
    pub traction: Vec<f64>,
    /// Displacement difference wheel minus rail (in m) where it is known.
    pub displacement: Vec<Option<f64>>,
}

impl Sample {
    /// A sample with a value in every cell.
    pub fn new(
        grid: Grid,
        traction: Vec<f64>,
        displacement: Vec<Option<f64>>,
    ) -> Result<Self, Error> {
        for (quantity, length) in
            [("traction", traction.len()), ("displacement", displacement.len())]
        {
            let reason = format!("{length} values on a grid of {} cells", grid.len());
            if length != grid.len() {
                return Err(Error::Contradiction { quantity, reason });
            }
        }
        let largest = traction.iter().fold(0.0, |largest: f64, t| largest.max(t.abs()));
        require(
            largest > 0.0 && largest.is_finite(),
            "traction",
            "finite and not zero",
            largest,
            "Pa",
        )?;
        let known = displacement.iter().flatten().count();
        require(known >= 4, "displacement", "known in at least four cells", known as f64, "cells")?;
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
pub struct DisplacementFit {
    /// Bedding c, in N/m³.
    pub bedding: f64,
    /// Coupling along rolling, in N/m.
    pub coupling_along_x: f64,
    /// Coupling across rolling, in N/m.
    pub coupling_along_y: f64,
    /// ‖u − u_given‖₂/‖u_given‖₂ of each sample, each less its mean; dimensionless.
    pub deviation: Vec<f64>,
    /// Whether the fit converged.
    pub converged: bool,
}

const LIMITS: Limits = Limits { tolerance: 1e-6, max_iterations: 200 };

/// Logarithm of the decay length over the longer side of the grid: the bounds.
const REACH: [f64; 2] = [-6.0, 0.5];

/// Fits bedding and couplings to samples, from a guess of the bedding (in N/m³).
///
/// # Errors
/// No samples, a guess that is not positive, or a layer that cannot be set up.
pub fn fit(samples: &[Sample], guess: f64) -> Result<DisplacementFit, Error> {
    require(!samples.is_empty(), "samples", "at least one", 0.0, "")?;
    require_positive("bedding", guess, "N/m^3")?;
    let length = samples
        .iter()
        .map(|s| {
            (s.grid.columns as f64 * s.grid.spacing_x).max(s.grid.rows as f64 * s.grid.spacing_y)
        })
        .fold(0.0, f64::max);
    let mut fit = Fit { samples, length };
    let start = [guess.ln(), -2.0, -2.0];
    let found = minimise(&mut fit, &start, &LIMITS).ok_or_else(|| Error::Contradiction {
        quantity: "displacement",
        reason: "no layer could be set up on its grid".to_owned(),
    })?;
    let stiffness = fit.stiffness(&found.parameters);
    let mut deviation = Vec::with_capacity(samples.len());
    let mut rest = found.residuals.as_slice();
    for sample in samples {
        let (own, others) = rest.split_at(sample.displacement.iter().flatten().count());
        deviation.push(own.iter().map(|r| r * r).sum::<f64>().sqrt());
        rest = others;
    }
    Ok(DisplacementFit {
        bedding: stiffness.bedding,
        coupling_along_x: stiffness.coupling_along_x,
        coupling_along_y: stiffness.coupling_along_y,
        deviation,
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
}

impl Residuals for Fit<'_> {
    fn residuals(&mut self, parameters: &[f64]) -> Option<Vec<f64>> {
        let [least, largest] = REACH;
        if !parameters[1..].iter().all(|reach| (least..=largest).contains(reach)) {
            return None;
        }
        let stiffness = self.stiffness(parameters);
        let layer = ElasticLayer::new(stiffness, stiffness, None).ok()?;
        let mut residuals = Vec::new();
        for sample in self.samples {
            let mut compliance = layer.compliance(&sample.grid).ok()?;
            residuals.extend(differences(sample, compliance.as_mut()));
        }
        Some(residuals)
    }

    fn jacobian(&mut self, parameters: &[f64], residuals: &[f64]) -> Option<Mat<f64>> {
        // The residuals are smooth to rounding, so a small step does.
        let mut jacobian = Mat::zeros(residuals.len(), parameters.len());
        for column in 0..parameters.len() {
            let (step, changed) = [1e-6, -1e-6].into_iter().find_map(|step| {
                let mut moved = parameters.to_vec();
                moved[column] += step;
                self.residuals(&moved).map(|changed| (step, changed))
            })?;
            for (row, (changed, residual)) in changed.iter().zip(residuals).enumerate() {
                jacobian[(row, column)] = (changed - residual) / step;
            }
        }
        Some(jacobian)
    }
}

/// Displacements of the layer less the known ones, both less their means, over the size of the known
/// ones.
fn differences(sample: &Sample, compliance: &mut dyn Compliance) -> Vec<f64> {
    let cells = sample.grid.len();
    let traction = VectorField { x: sample.traction.clone(), y: vec![0.0; cells] };
    let mut found = VectorField::zeros(cells);
    compliance.displacement(&traction, &mut found);
    let pairs = || found.x.iter().zip(&sample.displacement).filter_map(|(u, v)| Some((u, (*v)?)));
    let count = pairs().count() as f64;
    let mean = pairs().map(|(u, v)| u - v).sum::<f64>() / count;
    let middle = pairs().map(|(_, v)| v).sum::<f64>() / count;
    let size = pairs().map(|(_, v)| (v - middle).powi(2)).sum::<f64>().sqrt();
    pairs().map(|(u, v)| (u - v - mean) / size).collect()
}
