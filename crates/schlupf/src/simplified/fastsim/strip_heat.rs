//! Temperatures down the strips, from the heat that is released on the ways from cell to cell.

use std::sync::Arc;

use crate::heat::{HeatModel, HeatStep};
use crate::numerics::vector::dot;
use crate::patch::{Patch, Strip};

/// Heat fluxes on the ways into all cells, and what they weigh in the temperatures.
#[derive(Debug, Default)]
pub(super) struct StripHeat {
    model: Option<Arc<dyn HeatModel>>,
    speed: f64,
    /// First cell of the strip of each cell.
    first: Vec<usize>,
    /// Where the row of each cell begins in the weights.
    rows: Vec<usize>,
    /// ∂rise/∂flux of a linear model, row by row, in √s.
    weights: Vec<f64>,
    /// Times for the ways into the cells, in s.
    durations: Vec<f64>,
    /// Heat flux on the way into each cell, in W/m².
    flux: Vec<f64>,
    record: Vec<HeatStep>,
}

impl StripHeat {
    /// No heat in the cells of a patch.
    pub fn new(patch: &Patch) -> Self {
        let mut heat = Self::default();
        let mut row = 0;
        let mut longest = 0;
        for strip in &patch.strips {
            for k in strip.cells.clone() {
                heat.first.push(strip.cells.start);
                heat.rows.push(row);
                row += k + 1 - strip.cells.start;
            }
            longest = longest.max(strip.cells.len());
        }
        heat.weights = vec![0.0; row];
        heat.durations = vec![0.0; patch.len()];
        heat.flux = vec![0.0; patch.len()];
        heat.record = Vec::with_capacity(longest + 1);
        heat
    }

    /// Forgets the speed, as the ways have changed.
    pub fn forget(&mut self) {
        self.speed = 0.0;
    }

    /// Takes over a model and a speed (in m/s).
    pub fn prepare(&mut self, model: Option<&Arc<dyn HeatModel>>, patch: &Patch, speed: f64) {
        let is_same_model = match (&self.model, model) {
            (None, None) => true,
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            _ => false,
        };
        if is_same_model && self.speed == speed {
            return;
        }
        self.model = model.map(Arc::clone);
        self.speed = speed;
        for (duration, cell) in self.durations.iter_mut().zip(&patch.cells) {
            *duration = cell.way_in.distance / speed;
        }
        self.flux.fill(0.0);
        if self.model.as_ref().is_some_and(|model| model.is_linear()) {
            (0..self.rows.len()).for_each(|k| self.weigh(k));
        }
    }

    fn weigh(&mut self, k: usize) {
        self.recall(k, 0.0);
        let row = &mut self.weights[self.rows[k]..][..=k - self.first[k]];
        if let Some(model) = &self.model {
            model.derivatives(&self.record, row);
        }
        row.reverse();
    }

    /// The record of a cell with a flux (in W/m²) on the way into it, the latest step first.
    fn recall(&mut self, k: usize, flux: f64) {
        self.record.clear();
        self.record.push(HeatStep { flux, duration: self.durations[k] });
        let upstream = (self.first[k]..k).rev();
        let step = |j: usize| HeatStep { flux: self.flux[j], duration: self.durations[j] };
        self.record.extend(upstream.map(step));
    }

    /// What the heat from upstream contributes to the rise times effusivity of a cell (in W √s/m²) in a
    /// linear model.
    pub fn inherited(&self, k: usize) -> f64 {
        let row = &self.weights[self.rows[k]..][..k - self.first[k]];
        dot(row, &self.flux[self.first[k]..k])
    }

    /// Rise times effusivity of a cell (in W √s/m²) with a flux (in W/m²) on the way into it.
    pub fn rise(&mut self, k: usize, inherited: f64, flux: f64) -> f64 {
        let Some(model) = self.model.clone() else { return 0.0 };
        if model.is_linear() {
            return inherited + self.weights[self.rows[k] + k - self.first[k]] * flux;
        }
        self.recall(k, flux);
        model.rise_times_effusivity(&self.record)
    }

    /// Notes the flux on the way into a cell, in W/m².
    pub fn release(&mut self, k: usize, flux: f64) {
        self.flux[k] = flux;
    }

    /// Rise times effusivity at the end of a strip (in W √s/m²) with a flux (in W/m²) on the way out.
    pub fn exit_rise(&mut self, strip: &Strip, flux: f64) -> f64 {
        let Some(model) = self.model.clone() else { return 0.0 };
        let last = strip.cells.end - 1;
        self.recall(last, self.flux[last]);
        self.record.insert(0, HeatStep { flux, duration: strip.exit.distance / self.speed });
        model.rise_times_effusivity(&self.record)
    }
}
