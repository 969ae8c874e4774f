//! What the material of each cell has done so far: the state from which a march goes on.

use crate::normal::patch::Patch;
use crate::problem::{Element, Places, TrackPoint};
use crate::solver::rolling::shared::passage::pair;
use crate::solver::rolling::shared::strip::saturation;

use super::StripLaw;

impl StripLaw {
    /// The elements of the steady state with the traction p, without their heat, given also the
    /// displacements at the cells relative to those where their material entered, in m.
    pub fn elements(&self, patch: &Patch, p: &[f64], relative: &[f64]) -> Vec<Element> {
        let mut displaced = relative.to_vec();
        self.contact.calibration.add(p, &mut displaced);
        let pairs = self.rigid_since_entry.iter().zip(&displaced);
        let slid: Vec<f64> = pairs.map(|(rigid, displaced)| rigid - displaced).collect();
        let mut elements = Vec::with_capacity(self.len());
        for (number, strip) in patch.strips.iter().enumerate() {
            for k in strip.cells.clone() {
                elements.push(Element {
                    index: patch.cells[k].index,
                    traction: pair(p, k),
                    saturation: saturation(pair(p, k), self.bound[k]),
                    sliding: pair(&slid, k),
                    track: self.track(patch, &slid, p, (number, k)),
                    ..Element::default()
                });
            }
        }
        elements
    }

    /// The places of the path of an element to a cell of a strip from which the next slip follows,
    /// the latest first, with the sliding since entry up to each cell, in m. Slaved cells at the
    /// leading edge are none of them.
    fn track(&self, patch: &Patch, slid: &[f64], p: &[f64], at: (usize, usize)) -> Places {
        let (strip, k) = at;
        let kept = self.contact.slaved.kept[strip].clone();
        let here = patch.cells[k].since_entry.distance;
        let entry = TrackPoint { distance: here, ..TrackPoint::default() };
        let cells = (kept.start..=k).rev().filter(|cell| kept.contains(cell) || *cell == k);
        let cells = cells.map(|j| TrackPoint {
            distance: here - patch.cells[j].since_entry.distance,
            sliding: pair(slid, j),
            saturation: saturation(pair(p, j), self.bound[j]),
        });
        cells.chain([entry]).collect()
    }

    /// Replaces the slip velocity of the cells, at a rolling speed in m/s, by that of the law:
    /// exactly zero where a cell sticks without bristles. The friction power, from mean slips over
    /// the cells, is not.
    pub fn take_slip(&self, b: &[f64], speed: f64, slip: &mut [[f64; 2]]) {
        if self.is_total() {
            return;
        }
        for k in self.contact.kept() {
            let path = self.stencils[k].path;
            let per_path = if path > 0.0 { speed / path } else { 0.0 };
            let slides = self.resolvents[k].is_sliding();
            let sliding = if slides { self.sliding(b, k) } else { [0.0; 2] };
            slip[k] = sliding.map(|s| per_path * s);
        }
        self.contact.slaved.copy(slip);
    }

    /// Sums along the strips of something that happens on the path into each cell.
    pub(super) fn since_entry(&self, on_the_path: &[f64]) -> Vec<f64> {
        let mut sums = on_the_path.to_vec();
        for k in 1..self.len() {
            if !self.is_first[k] {
                sums[2 * k] += sums[2 * k - 2];
                sums[2 * k + 1] += sums[2 * k - 1];
            }
        }
        sums
    }

    /// Gives such cells the coefficient of friction (dimensionless) that their traction obeys.
    pub fn complete_friction(&self, coefficient: &mut [f64]) {
        self.contact.slaved.copy(coefficient);
    }
}
