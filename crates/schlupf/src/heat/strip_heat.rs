//! Heat along the strips of a patch in steady rolling: the temperature of a cell follows from the
//! heat released by the cells upstream of it and by the cell itself.

use std::ops::Range;
use std::sync::Arc;

use crate::numerics::vector::dot;
use crate::patch::{Patch, Strip};

use super::{HeatModel, HeatStep};

/// Heat fluxes in the cells of a patch, and their weights in the temperatures.
#[derive(Debug)]
pub(crate) struct StripHeat {
    model: Option<Arc<dyn HeatModel>>,
    /// First cell of the strip of each cell.
    first: Vec<usize>,
    /// Start of the row of each cell in the weights.
    rows: Vec<usize>,
    /// The lower triangle ∂rise/∂flux, strip by strip and row by row, in √s.
    weights: Vec<f64>,
    /// Times for the path to the cell's point and through the cell, in s.
    durations: Vec<[f64; 2]>,
    /// Heat flux on the path through each cell, in W/m².
    pub flux: Vec<f64>,
    record: Vec<HeatStep>,
}

impl StripHeat {
    /// The cells of a patch, without heat.
    pub fn new(patch: &Patch) -> Self {
        let longest = patch.strips.iter().map(|strip| strip.cells.len()).max().unwrap_or(0);
        let first = patch.strips.iter().flat_map(|s| s.cells.clone().map(|_| s.cells.start));
        let first: Vec<usize> = first.collect();
        let mut size = 0;
        let mut rows = Vec::with_capacity(first.len());
        for (k, first) in first.iter().enumerate() {
            rows.push(size);
            size += k + 1 - first;
        }
        Self {
            model: None,
            durations: vec![[0.0; 2]; first.len()],
            flux: vec![0.0; first.len()],
            weights: vec![0.0; size],
            record: Vec::with_capacity(longest + 1),
            first,
            rows,
        }
    }

    /// Sets a model and the times for the path to each cell's point and through the cell, in s.
    /// This resets the fluxes to zero.
    pub fn set(
        &mut self,
        model: Option<&Arc<dyn HeatModel>>,
        durations: impl Iterator<Item = [f64; 2]>,
    ) {
        self.model = model.map(Arc::clone);
        for (own, duration) in self.durations.iter_mut().zip(durations) {
            *own = duration;
        }
        self.flux.fill(0.0);
        if self.is_linear() {
            (0..self.rows.len()).for_each(|k| self.weigh(k));
        }
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is a heat model.
    pub fn has_model(&self) -> bool {
        self.model.is_some()
    }

    /// First cell of the strip of a cell.
    pub fn first(&self, k: usize) -> usize {
        self.first[k]
    }

    /// Times for the path to a cell's point and through the cell, in s.
    pub fn durations(&self, k: usize) -> [f64; 2] {
        self.durations[k]
    }

    /// Weights of the fluxes from the first cell of the strip to a given cell in its rise times
    /// effusivity, in s^½.
    pub fn row(&self, k: usize) -> &[f64] {
        &self.weights[self.rows[k]..][..=k - self.first[k]]
    }

    /// The same, to be overwritten, in s^½.
    pub fn row_mut(&mut self, k: usize) -> &mut [f64] {
        &mut self.weights[self.rows[k]..][..=k - self.first[k]]
    }

    /// Recomputes the weights of a cell's own and upstream fluxes by linearisation about the
    /// present ones, if the model is not linear.
    pub fn weigh_about_present(&mut self, k: usize) {
        if !self.is_linear() {
            self.weigh(k);
        }
    }

    fn weigh(&mut self, k: usize) {
        let Some(model) = self.model.clone() else { return };
        self.recall(k, HeatStep { flux: self.flux[k], duration: self.durations[k][0] });
        let row = &mut self.weights[self.rows[k]..][..=k - self.first[k]];
        model.derivatives(&self.record, row);
        row.reverse();
    }

    /// Writes the record of a cell, with its own step as the latest, into the buffer.
    fn recall(&mut self, k: usize, own: HeatStep) {
        self.recall_strip(self.first[k]..k, own);
    }

    fn recall_strip(&mut self, upstream: Range<usize>, last: HeatStep) {
        self.record.clear();
        self.record.push(last);
        let step = |j: usize| HeatStep { flux: self.flux[j], duration: self.durations[j][1] };
        self.record.extend(upstream.rev().map(step));
    }

    /// Σ weight · flux over the cells upstream of a cell, and the cell itself if the fluxes extend
    /// to it, in W √s/m².
    pub fn weighted(&self, k: usize, flux: &[f64]) -> f64 {
        if self.model.is_none() {
            return 0.0;
        }
        let upstream = &flux[self.first[k]..flux.len().min(k + 1)];
        dot(&self.row(k)[..upstream.len()], upstream)
    }

    /// Contribution of the upstream heat to the rise times effusivity of a cell (in W √s/m²) in a
    /// linear model.
    pub fn inherited(&self, k: usize) -> f64 {
        if self.is_linear() { self.weighted(k, &self.flux[..k]) } else { 0.0 }
    }

    fn is_linear(&self) -> bool {
        self.model.as_ref().is_some_and(|model| model.is_linear())
    }

    /// Rise times effusivity of a cell (in W √s/m²) with a flux (in W/m²), where `inherited` is the
    /// upstream contribution in a linear model.
    pub fn scaled_rise(&mut self, k: usize, inherited: f64, flux: f64) -> f64 {
        let Some(model) = self.model.clone() else { return 0.0 };
        if model.is_linear() {
            return inherited + self.weights[self.rows[k] + k - self.first[k]] * flux;
        }
        self.recall(k, HeatStep { flux, duration: self.durations[k][0] });
        model.rise_times_effusivity(&self.record)
    }

    /// The record of an element when it leaves a cell, the latest step first.
    pub fn record_on_leaving(&mut self, k: usize) -> &[HeatStep] {
        self.recall(k, HeatStep { flux: self.flux[k], duration: self.durations[k][1] });
        &self.record
    }

    /// Rise times effusivity at the trailing edge of a strip, in W √s/m².
    pub fn scaled_exit_rise(&mut self, strip: &Strip) -> f64 {
        let Some(model) = self.model.clone() else { return 0.0 };
        model.rise_times_effusivity(self.record_on_leaving(strip.cells.end - 1))
    }

    /// The same with another step (in W/m² and s) on the path from the last cell to the edge.
    pub fn scaled_exit_rise_after(&mut self, strip: &Strip, step: HeatStep) -> f64 {
        let Some(model) = self.model.clone() else { return 0.0 };
        self.recall_strip(strip.cells.clone(), step);
        model.rise_times_effusivity(&self.record)
    }
}
