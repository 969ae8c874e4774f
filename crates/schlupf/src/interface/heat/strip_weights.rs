//! Weights of the heat fluxes upstream in the temperatures downstream, strip by strip: a lower
//! triangle each, whose rows repeat where equal cells follow each other.

use crate::normal::patch::Patch;
use crate::numerics::vector::dot;

/// Weights of the cells of every strip in the rises of those downstream and their own.
///
/// Cells that the material passes in equal times, without others in between, have weights that
/// depend on their distance only. These are stored once, which leaves of the triangles little more
/// than two columns and two rows: the products are then not limited by the memory.
#[derive(Debug, Clone)]
pub(super) struct StripWeights {
    /// First cell of the strip of each cell.
    first: Vec<usize>,
    rows: Vec<Row>,
    /// The weights that belong to one row only, row by row.
    own: Vec<f64>,
    /// The weights of equal cells, the farthest upstream first.
    common: Vec<f64>,
}

/// The row of a cell.
#[derive(Debug, Clone, Copy, Default)]
struct Row {
    /// Start of its own weights.
    start: usize,
    /// Number of its own weights, from the first cell of the strip on; the others are common.
    own: usize,
}

impl StripWeights {
    /// Those of a patch, all of them common, all zero.
    pub fn new(patch: &Patch) -> Self {
        let first = patch.strips.iter().flat_map(|s| s.cells.clone().map(|_| s.cells.start));
        let first: Vec<usize> = first.collect();
        let rows = vec![Row::default(); first.len()];
        let mut weights = Self { first, rows, own: Vec::new(), common: Vec::new() };
        weights.lay_out(|_| true);
        weights
    }

    /// Chooses which cells share their weights: those that are equal and follow each other. All
    /// weights are zero then.
    pub fn lay_out(&mut self, is_equal: impl Fn(usize) -> bool) {
        let (mut start, mut longest, mut equal_from) = (0, 0, 0);
        for (k, row) in self.rows.iter_mut().enumerate() {
            let first = self.first[k];
            equal_from = if is_equal(k) { equal_from.max(first) } else { k + 1 };
            let own = equal_from.min(k + 1) - first;
            *row = Row { start, own };
            start += own;
            longest = longest.max(k + 1 - first - own);
        }
        self.own.clear();
        self.own.resize(start, 0.0);
        self.common.clear();
        self.common.resize(longest, 0.0);
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.first.len()
    }

    /// First cell of the strip of a cell.
    pub fn first(&self, k: usize) -> usize {
        self.first[k]
    }

    /// The weights that only the row of a cell has, of the first cells of its strip, in s^½.
    pub fn own_row(&mut self, k: usize) -> &mut [f64] {
        let Row { start, own } = self.rows[k];
        &mut self.own[start..start + own]
    }

    /// Number of cells whose weights in the row of a cell are common ones, the cell included.
    pub fn common_in_row(&self, k: usize) -> usize {
        k + 1 - self.first[k] - self.rows[k].own
    }

    /// Number of cells whose weights are in the row of a cell only.
    pub fn own_in_row(&self, k: usize) -> usize {
        self.rows[k].own
    }

    /// Weight of a cell of the same strip, counted from its first, in the row of a cell, in s^½.
    pub fn at(&self, k: usize, from: usize) -> f64 {
        let Row { start, own } = self.rows[k];
        if from < own {
            return self.own[start + from];
        }
        self.common[self.common.len() + from - (k + 1 - self.first[k])]
    }

    /// The weights of equal cells (in s^½), see [`Self::common`].
    pub fn all_common(&self) -> &[f64] {
        &self.common
    }

    /// The weights of equal cells, the farthest upstream first and that of a cell last, in s^½.
    pub fn common(&mut self) -> &mut [f64] {
        &mut self.common
    }

    /// Number of weights that are stored.
    #[cfg(test)]
    pub fn stored(&self) -> usize {
        self.own.len() + self.common.len()
    }

    /// Σ weight · flux (in W/m²) over the first cells of the strip of a cell, at most up to itself;
    /// in W √s/m².
    pub fn weighted(&self, k: usize, flux: &[f64]) -> f64 {
        let flux = &flux[..flux.len().min(k + 1 - self.first[k])];
        let Row { start, own } = self.rows[k];
        let (apart, equal) = flux.split_at(flux.len().min(own));
        let common = &self.common[self.common.len() - self.common_in_row(k)..];
        dot(&self.own[start..][..apart.len()], apart) + dot(&common[..equal.len()], equal)
    }

    /// Weight of a cell in its own row, in s^½.
    pub fn diagonal(&self, k: usize) -> f64 {
        let Row { start, own } = self.rows[k];
        let last = self.common.last();
        match last {
            Some(weight) if self.common_in_row(k) > 0 => *weight,
            _ => self.own[start + own - 1],
        }
    }
}
