//! Heat along the strips of a patch in steady rolling: the temperature of a cell follows from the
//! heat released by the cells upstream of it and by the cell itself.

use std::ops::Range;
use std::sync::Arc;

use crate::normal::patch::{Patch, Strip};

use super::strip_weights::StripWeights;
use super::{HeatModel, HeatStep, is_same};

/// Relative difference of the times in which cells are passed that only comes from rounding.
const ROUNDING: f64 = 1e-12;

/// Heat fluxes in the cells of a patch, and their weights in the temperatures.
#[derive(Debug, Clone)]
pub(crate) struct StripHeat {
    model: Option<Arc<dyn HeatModel>>,
    /// ∂rise/∂flux, in √s.
    weights: StripWeights,
    /// Whether these are not those of the model.
    is_replaced: bool,
    /// The cell in the middle of the longest strip: most are like this one.
    typical: usize,
    /// Times for the path to the cell's point and through the cell, in s.
    durations: Vec<[f64; 2]>,
    /// Heat flux on the path through each cell, in W/m².
    pub flux: Vec<f64>,
    record: Vec<HeatStep>,
    /// Derivatives of a record, in √s.
    by_flux: Vec<f64>,
}

impl StripHeat {
    /// The cells of a patch, without heat.
    pub fn new(patch: &Patch) -> Self {
        let longest = patch.strips.iter().map(|strip| &strip.cells).max_by_key(|cells| cells.len());
        let weights = StripWeights::new(patch);
        Self {
            model: None,
            typical: longest.map_or(0, |cells| cells.start + cells.len() / 2),
            durations: vec![[0.0; 2]; weights.len()],
            flux: vec![0.0; weights.len()],
            record: Vec::with_capacity(longest.map_or(0, ExactSizeIterator::len) + 1),
            by_flux: Vec::new(),
            is_replaced: false,
            weights,
        }
    }

    /// Sets a model and the times for the path to each cell's point and through the cell, in s.
    /// This resets the fluxes to zero.
    pub fn set(
        &mut self,
        model: Option<&Arc<dyn HeatModel>>,
        durations: impl Iterator<Item = [f64; 2]>,
    ) {
        self.flux.fill(0.0);
        let mut is_new = !is_same(self.model.as_ref(), model) || self.is_replaced;
        for (own, duration) in self.durations.iter_mut().zip(durations) {
            is_new |= *own != duration;
            *own = duration;
        }
        if !is_new {
            return;
        }
        self.model = model.map(Arc::clone);
        self.is_replaced = false;
        let typical = self.durations.get(self.typical).copied().unwrap_or_default();
        let durations = &self.durations;
        let is_equal = |k: usize| {
            let differs = |c: usize| (durations[k][c] - typical[c]).abs() > ROUNDING * typical[c];
            !differs(0) && !differs(1)
        };
        if self.is_linear() {
            self.weights.lay_out(is_equal);
            self.weigh_equal_cells(typical);
            (0..self.len()).for_each(|k| self.weigh(k));
        } else {
            // Without heat all cells have the same weights, zero.
            let is_cold = self.model.is_none();
            self.weights.lay_out(|_| is_cold);
        }
    }

    /// Weights of cells that are passed in equal times, in s, to their points and through them.
    fn weigh_equal_cells(&mut self, [before, through]: [f64; 2]) {
        let count = self.weights.common().len();
        self.record.clear();
        self.record.push(HeatStep { flux: 0.0, duration: before });
        self.record.resize(count, HeatStep { flux: 0.0, duration: through });
        self.differentiate();
        for (weight, derivative) in self.weights.common().iter_mut().zip(self.by_flux.iter().rev())
        {
            *weight = *derivative;
        }
    }

    /// Derivatives of the rise of the record.
    fn differentiate(&mut self) {
        self.by_flux.clear();
        self.by_flux.resize(self.record.len(), 0.0);
        if let Some(model) = &self.model {
            model.derivatives(&self.record, &mut self.by_flux);
        }
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.weights.len()
    }

    /// Whether there is a heat model.
    pub fn has_model(&self) -> bool {
        self.model.is_some()
    }

    /// First cell of the strip of a cell.
    pub fn first(&self, k: usize) -> usize {
        self.weights.first(k)
    }

    /// Times for the path to a cell's point and through the cell, in s.
    pub fn durations(&self, k: usize) -> [f64; 2] {
        self.durations[k]
    }

    /// Weight of the flux of a cell in its own rise times effusivity, in s^½.
    pub fn own_weight(&self, k: usize) -> f64 {
        self.weights.diagonal(k)
    }

    /// Replaces the weights, in s^½, by those of a cell so many cells upstream.
    pub fn replace_weights(&mut self, weight: impl Fn(usize, usize) -> f64) {
        self.is_replaced = true;
        for k in 0..self.len() {
            let first = self.weights.first(k);
            for (j, own) in (first..).zip(self.weights.own_row(k)) {
                *own = weight(k - j, j);
            }
        }
        for (columns, common) in self.weights.common().iter_mut().rev().enumerate() {
            *common = weight(columns, self.typical);
        }
    }

    /// Recomputes the weights of a cell's own and upstream fluxes by linearisation about the
    /// present ones, if the model is not linear.
    pub fn weigh_about_present(&mut self, k: usize) {
        if self.has_model() && !self.is_linear() {
            self.weigh(k);
        }
    }

    /// Computes the weights that only the row of a cell has. The path through the cells whose
    /// weights are common counts as one step.
    fn weigh(&mut self, k: usize) {
        let equal = self.weights.common_in_row(k);
        let own = HeatStep { flux: self.flux[k], duration: self.durations[k][0] };
        if equal == 0 {
            self.recall(k, own);
        } else {
            self.recall_strip(self.first(k)..k + 1 - equal, own);
            if equal > 1 {
                let duration = (equal - 1) as f64 * self.durations[k][1];
                self.record.insert(1, HeatStep { flux: 0.0, duration });
            }
        }
        self.differentiate();
        let steps = self.by_flux.iter().rev();
        for (weight, derivative) in self.weights.own_row(k).iter_mut().zip(steps) {
            *weight = *derivative;
        }
    }

    /// Writes the record of a cell, with its own step as the latest, into the buffer.
    fn recall(&mut self, k: usize, own: HeatStep) {
        self.recall_strip(self.first(k)..k, own);
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
        self.weights.weighted(k, &flux[self.first(k)..])
    }

    /// Contribution of the upstream heat to the rise times effusivity of a cell (in W √s/m²) in a
    /// linear model.
    pub fn inherited(&self, k: usize) -> f64 {
        if self.is_linear() { self.weighted(k, &self.flux[..k]) } else { 0.0 }
    }

    /// Weights of equal cells, the farthest upstream first and that of a cell last, in s^½.
    pub fn common_weights(&self) -> &[f64] {
        self.weights.all_common()
    }

    /// Number of cells at the leading edge whose weights in the rise of a cell are not common ones.
    pub fn weights_apart(&self, k: usize) -> usize {
        self.weights.own_in_row(k)
    }

    /// Weight of the flux of a cell of the same strip, counted from the leading edge, in the rise
    /// times effusivity of a cell, in s^½.
    pub fn weight(&self, k: usize, from: usize) -> f64 {
        self.weights.at(k, from)
    }

    /// Whether the rise is a sum of what the cells contribute.
    pub fn is_linear(&self) -> bool {
        self.model.as_ref().is_some_and(|model| model.is_linear())
    }

    /// Rise times effusivity of a cell (in W √s/m²) with a flux (in W/m²), where `inherited` is the
    /// upstream contribution in a linear model.
    pub fn scaled_rise(&mut self, k: usize, inherited: f64, flux: f64) -> f64 {
        let Some(model) = self.model.clone() else { return 0.0 };
        if model.is_linear() {
            return inherited + self.weights.diagonal(k) * flux;
        }
        self.recall(k, HeatStep { flux, duration: self.durations[k][0] });
        model.rise_times_effusivity(&self.record)
    }

    /// The record of an element when it leaves the last cell of a strip, the latest step first. Its
    /// end is that of an element that leaves an earlier one.
    pub fn records_on_leaving(&mut self, strip: &Strip) -> Arc<[HeatStep]> {
        self.record_on_leaving(strip.cells.end - 1).into()
    }

    /// The record of an element when it leaves a cell, the latest step first.
    fn record_on_leaving(&mut self, k: usize) -> &[HeatStep] {
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

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::interface::heat::Duhamel;
    use crate::normal::{Ellipse, Grid, PressureSource};

    /// The heat of a patch whose cells have different fluxes; the cells are passed in equal times
    /// but for the first and last of a strip.
    fn heated_patch() -> (StripHeat, Patch) {
        let source = Ellipse::from_peak_pressure(7e-3, 4e-3, 1e9).unwrap();
        let contact = source.normal_contact(None).unwrap();
        let patch = Patch::new(&contact, Grid::across(&contact.extent(), 24, 17));
        let strips = patch.strips.iter();
        let durations = strips.flat_map(|strip| {
            let cells = strip.cells.clone();
            let is_edge = move |k: usize| k == cells.start || k + 1 == cells.end;
            strip.cells.clone().map(move |k| if is_edge(k) { [1.3e-5, 2e-5] } else { [2e-5, 4e-5] })
        });
        let model: Arc<dyn HeatModel> = Arc::new(Duhamel);
        let mut heat = StripHeat::new(&patch);
        heat.set(Some(&model), durations);
        for (k, flux) in heat.flux.iter_mut().enumerate() {
            *flux = 1e8 * (1.0 + (k as f64).sin());
        }
        (heat, patch)
    }

    /// Weights that equal cells share give the rises of the records, at any cell.
    #[test]
    fn shared_weights_are_those_of_the_records() {
        let (mut heat, patch) = heated_patch();
        for k in 0..patch.len() {
            let own = HeatStep { flux: heat.flux[k], duration: heat.durations(k)[0] };
            heat.recall(k, own);
            let rise = Duhamel.rise_times_effusivity(&heat.record);
            let flux = heat.flux.clone();
            assert_relative_eq!(heat.weighted(k, &flux), rise, max_relative = 1e-12);
            let own = heat.own_weight(k) * flux[k];
            assert_relative_eq!(heat.inherited(k), rise - own, epsilon = 1e-12 * rise);
        }
    }

    /// Only a small part of the triangles is stored.
    #[test]
    fn few_weights_are_stored() {
        let (heat, patch) = heated_patch();
        let triangles = patch.strips.iter().map(|strip| {
            let cells = strip.cells.len();
            cells * (cells + 1) / 2
        });
        let (all, stored) = (triangles.sum::<usize>(), heat.weights.stored());
        assert!(4 * stored < all, "{stored} of {all}");
    }
}
