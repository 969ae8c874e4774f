//! The sliding that stretches stiff bristles, down the strips of a patch in steady rolling.

use std::ops::Range;

use crate::problem::Problem;
use crate::rolling::shared::coulomb::{Growth, Matrix, SlipStencil, Stretch, slide};
use crate::rolling::shared::passage::pair;

use super::strip_law::{Cause, Changed};

/// Stretch of the bristles of all cells, at the last evaluation.
#[derive(Debug, Default)]
pub(super) struct Stretching {
    /// 1/k_c, in m.
    length: f64,
    cells: Vec<Stretch>,
    /// Sliding that stretches the bristles over the way into each cell, in m.
    pub sliding: Vec<f64>,
    /// The part of it over 1/k_c that is along the traction.
    along: Vec<Growth>,
}

/// The cells with equations of their own, strip by strip, and the stencils of all cells.
#[derive(Clone, Copy)]
pub(super) struct Cells<'a> {
    pub kept: &'a [Range<usize>],
    pub stencils: &'a [SlipStencil],
}

impl Cells<'_> {
    fn all(&self) -> impl Iterator<Item = usize> {
        self.kept.iter().flat_map(Clone::clone)
    }

    /// Change of something over the way into a cell: the part of the cell itself and of one ahead,
    /// and that of those before.
    fn parts(&self, k: usize, of: impl Fn(usize) -> f64) -> [f64; 2] {
        let mut parts = [0.0; 2];
        for (j, weight) in self.stencils[k].cells(k) {
            parts[usize::from(j < k)] += weight * of(j);
        }
        parts
    }
}

impl Stretching {
    /// The bristles of a problem; `None` if the law has none.
    pub fn of(problem: &Problem, cells: usize) -> Option<Self> {
        let stiffness = problem.contact_law.relaxation()?;
        Some(Self {
            length: stiffness.recip(),
            cells: vec![Stretch::default(); cells],
            sliding: vec![0.0; 2 * cells],
            along: vec![Growth::default(); cells],
        })
    }

    /// Sets the traction and its bound, in Pa.
    pub fn evaluate(&mut self, p: &[f64], bound: &[f64], cells: Cells) {
        for k in cells.all() {
            let stretch = Stretch::of(pair(p, k), bound[k]);
            self.sliding[2 * k..2 * k + 2].copy_from_slice(&stretch.saturation);
            self.cells[k] = stretch;
        }
        slide(cells.stencils, &mut self.sliding);
        for k in cells.all() {
            let [here, before] = cells.parts(k, |j| self.cells[j].excess);
            self.along[k] = Stretch::growth(here, before);
            for c in 0..2 {
                let along = self.along[k].value * self.cells[k].direction[c];
                self.sliding[2 * k + c] = self.length * (self.sliding[2 * k + c] + along);
            }
        }
    }

    /// Change of that sliding (in m) with small changes.
    pub fn change(&self, change: &Changed, cause: Option<&Cause>, cells: Cells) -> Vec<f64> {
        let mut sliding = vec![0.0; self.sliding.len()];
        let mut excess = vec![0.0; self.cells.len()];
        for k in cells.all() {
            let raised = change.bound.map_or(0.0, |bound| bound[k]);
            let q = self.cells[k].saturation_change(pair(change.traction, k), raised);
            sliding[2 * k..2 * k + 2].copy_from_slice(&q);
            excess[k] = self.cells[k].excess_change(q);
        }
        let changes = sliding.clone();
        slide(cells.stencils, &mut sliding);
        let stiffer = cause.map_or(0.0, |cause| cause.stiffness);
        for k in cells.all() {
            let turn = self.cells[k].turn(pair(&changes, k));
            let n = self.cells[k].direction;
            let [here, before] = cells.parts(k, |j| excess[j]);
            let grown = self.along[k].change(here, before);
            for c in 0..2 {
                let at = 2 * k + c;
                let along = n[c] * grown + turn[c] * self.along[k].value;
                sliding[at] = self.length * (sliding[at] + along) - stiffer * self.sliding[at];
            }
        }
        sliding
    }

    /// The cells whose traction changes that sliding at cell `k`, with its derivatives in m/Pa.
    pub fn blocks(&self, k: usize, cells: Cells) -> impl Iterator<Item = (usize, Matrix)> {
        let own = &self.cells[k];
        let growth = &self.along[k];
        cells.stencils[k].cells(k).map(move |(j, weight)| {
            let column = |traction: [f64; 2]| {
                let q = self.cells[j].saturation_change(traction, 0.0);
                let excess = weight * self.cells[j].excess_change(q);
                let grown =
                    if j < k { growth.change(0.0, excess) } else { growth.change(excess, 0.0) };
                let turn = if j == k { own.turn(q) } else { [0.0; 2] };
                [0, 1].map(|r| {
                    let stretched = weight * q[r] + own.direction[r] * grown;
                    self.length * (stretched + growth.value * turn[r])
                })
            };
            let [[xx, yx], [xy, yy]] = [column([1.0, 0.0]), column([0.0, 1.0])];
            (j, [[xx, xy], [yx, yy]])
        })
    }

    /// The same of cell `k` alone.
    pub fn block(&self, k: usize, cells: Cells) -> Matrix {
        self.blocks(k, cells).find(|(j, _)| *j == k).map_or_else(Matrix::default, |(_, own)| own)
    }
}
