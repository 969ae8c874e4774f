//! The sliding that stretches stiff bristles, down the strips of a patch in steady rolling.

use std::ops::Range;

use crate::problem::Problem;
use crate::rolling::shared::coulomb::{Matrix, SlipStencil, Stretch, slide};
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
    /// The part of it over 1/k_c that is along the traction, with its derivative by the change of z
    /// over the way into the cell; dimensionless.
    along: Vec<[f64; 2]>,
    /// Buffer for z of the cells, as pairs.
    excess: Vec<f64>,
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
}

impl Stretching {
    /// The bristles of a problem; `None` if the law has none.
    pub fn of(problem: &Problem, cells: usize) -> Option<Self> {
        let stiffness = problem.contact_law.relaxation()?;
        Some(Self {
            length: stiffness.recip(),
            cells: vec![Stretch::default(); cells],
            sliding: vec![0.0; 2 * cells],
            along: vec![[0.0; 2]; cells],
            excess: vec![0.0; 2 * cells],
        })
    }

    /// Sets the traction and its bound, in Pa.
    pub fn evaluate(&mut self, p: &[f64], bound: &[f64], cells: Cells) {
        for k in cells.all() {
            let stretch = Stretch::of(pair(p, k), bound[k]);
            self.sliding[2 * k..2 * k + 2].copy_from_slice(&stretch.saturation);
            self.excess[2 * k..2 * k + 2].copy_from_slice(&[stretch.excess, 0.0]);
            self.cells[k] = stretch;
        }
        slide(cells.stencils, &mut self.sliding);
        slide(cells.stencils, &mut self.excess);
        for k in cells.all() {
            self.along[k] = Stretch::growth(self.excess[2 * k]);
            for c in 0..2 {
                let along = self.along[k][0] * self.cells[k].direction[c];
                self.sliding[2 * k + c] = self.length * (self.sliding[2 * k + c] + along);
            }
        }
    }

    /// Change of that sliding (in m) with small changes.
    pub fn change(&self, change: &Changed, cause: Option<&Cause>, cells: Cells) -> Vec<f64> {
        let mut sliding = vec![0.0; self.sliding.len()];
        let mut excess = sliding.clone();
        for k in cells.all() {
            let raised = change.bound.map_or(0.0, |bound| bound[k]);
            let q = self.cells[k].saturation_change(pair(change.traction, k), raised);
            sliding[2 * k..2 * k + 2].copy_from_slice(&q);
            excess[2 * k] = self.cells[k].excess_change(q);
        }
        let changes = sliding.clone();
        slide(cells.stencils, &mut sliding);
        slide(cells.stencils, &mut excess);
        let stiffer = cause.map_or(0.0, |cause| cause.stiffness);
        for k in cells.all() {
            let turn = self.cells[k].turn(pair(&changes, k));
            let n = self.cells[k].direction;
            let [along, slope] = self.along[k];
            for c in 0..2 {
                let at = 2 * k + c;
                let along = n[c] * slope * excess[2 * k] + turn[c] * along;
                sliding[at] = self.length * (sliding[at] + along) - stiffer * self.sliding[at];
            }
        }
        sliding
    }

    /// The cells whose traction changes that sliding at cell `k`, with its derivatives in m/Pa.
    pub fn blocks(&self, k: usize, cells: Cells) -> impl Iterator<Item = (usize, Matrix)> {
        let own = &self.cells[k];
        let [along, slope] = self.along[k];
        cells.stencils[k].cells(k).map(move |(j, weight)| {
            let column = |traction: [f64; 2]| {
                let q = self.cells[j].saturation_change(traction, 0.0);
                let grown = slope * self.cells[j].excess_change(q);
                let turn = if j == k { own.turn(q) } else { [0.0; 2] };
                [0, 1].map(|r| {
                    let stretched = weight * (q[r] + own.direction[r] * grown);
                    self.length * (stretched + along * turn[r])
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
