//! Cells at the ends of a strip whose equation does not determine their traction, because they are
//! hardly loaded.

use std::ops::Range;

use crate::normal::patch::Patch;
use crate::solver::settings;

/// How well the equation of a cell determines its traction, relative to its displacement under its
/// own traction.
#[derive(Debug, Clone, Copy)]
pub(in crate::solver::rolling) struct Determinacy {
    /// Displacement that the discrete one under p = pₙ falls short of the exact one, dimensionless.
    pub missing: f64,
    /// Displacement under its own traction relative to that at its entry, if it is the first cell
    /// of its strip; dimensionless.
    pub sliding: f64,
    /// Pressure (in Pa) under which a cell is displaced as much as bristles under p = pₙ, which is
    /// 1/(μ0 k_c) under any: cells on soft bristles need no neighbours to tell their traction.
    pub bristles: f64,
}

/// A cell that takes the traction over the pressure of another cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solver::rolling) struct SlavedCell {
    pub cell: usize,
    /// The cell that it follows.
    pub after: usize,
    /// Ratio of its pressure to that of the other, dimensionless.
    pub ratio: f64,
}

/// The slaved cells of a patch, and the other ones.
pub(in crate::solver::rolling) struct SlavedCells {
    all: Vec<SlavedCell>,
    /// The cells of each strip that are none, from the leading edge; never empty.
    pub kept: Vec<Range<usize>>,
    /// Whether a cell is a slaved one between the leading edge and those cells.
    pub leads: Vec<bool>,
}

impl SlavedCells {
    /// Where cells are not coupled, all have equations of their own.
    pub fn none(patch: &Patch) -> Self {
        let kept = patch.strips.iter().map(|strip| strip.cells.clone());
        Self { all: Vec::new(), kept: kept.collect(), leads: vec![false; patch.len()] }
    }

    /// Of a patch, from how well the equations of its cells determine their tractions.
    pub fn new(patch: &Patch, determinacy: &[Determinacy]) -> Self {
        let pressure = |k: usize| patch.cells[k].pressure;
        let softer = |k: usize| determinacy[k].bristles / pressure(k);
        let is_slaved = |k: usize, next: usize| {
            let bristles = determinacy[k].bristles;
            let is_stiff = determinacy[k].missing < -settings::most_missing() * (1.0 + softer(k));
            pressure(k) + bristles < settings::least_edge_pressure() * (pressure(next) + bristles)
                || (is_stiff && patch.cells[k].covered < 1.0 - f64::EPSILON.sqrt())
        };
        let hardly_slides =
            |k: usize| determinacy[k].sliding + softer(k) < settings::least_sliding();
        let mut all = Vec::new();
        let mut kept = Vec::with_capacity(patch.strips.len());
        let mut leads = vec![false; patch.len()];
        for strip in &patch.strips {
            let (mut first, mut last) = (strip.cells.start, strip.cells.end - 1);
            while first < last && (is_slaved(first, first + 1) || hardly_slides(first)) {
                first += 1;
            }
            while last > first && is_slaved(last, last - 1) {
                last -= 1;
            }
            let follow = |after: usize| {
                move |cell: usize| SlavedCell {
                    cell,
                    after,
                    ratio: pressure(cell) / pressure(after),
                }
            };
            leads[strip.cells.start..first].fill(true);
            all.extend((strip.cells.start..first).map(follow(first)));
            all.extend((last + 1..strip.cells.end).map(follow(last)));
            kept.push(first..last + 1);
        }
        Self { all, kept, leads }
    }

    /// Gives every slaved cell its traction, x and y of each cell in turn.
    pub fn complete(&self, p: &mut [f64]) {
        for SlavedCell { cell, after, ratio } in &self.all {
            for c in 0..2 {
                p[2 * cell + c] = ratio * p[2 * after + c];
            }
        }
    }

    /// Gives every slaved cell its value of something proportional to the pressure.
    pub fn complete_scalar(&self, values: &mut [f64]) {
        for SlavedCell { cell, after, ratio } in &self.all {
            values[*cell] = ratio * values[*after];
        }
    }

    /// Gives every slaved cell the value of the cell that it follows.
    pub fn copy<T: Copy>(&self, values: &mut [T]) {
        for SlavedCell { cell, after, .. } in &self.all {
            values[*cell] = values[*after];
        }
    }
}
