//! Jacobians of single strips, factorised.
//!
//! Along a strip a cell is displaced by its own traction and by those of two neighbours on either
//! side, compared with the displacement at the entry and with that of cells farther away. With the
//! slip taken of that, the Jacobian of a strip is banded, with blocks of both components.

use std::ops::Range;

use crate::patch::Patch;
use crate::rolling::shared::contact::{Row as Compliances, at_distance};
use crate::rolling::shared::strip::{Matrix, Resolvent, SlipStencil, StripContact};
use crate::settings;

use super::block::{Block, Twice, image, reduced_by};

/// Number of neighbours on either side that displace a cell.
const NEIGHBOURS: usize = 2;

/// Blocks to the left and to the right of the diagonal.
const LOWER: usize = 5;
const UPPER: usize = 3;
const WIDTH: usize = LOWER + 1 + UPPER;

/// Number of strips that are worked on in turn: the steps down a single one wait for each other.
const AT_ONCE: usize = 4;

/// Blocks of a row, from the left.
type Row<B> = [B; WIDTH];

/// The slip at every cell due to the tractions of its neighbourhood, and the factors of the
/// Jacobian made of it.
pub(super) struct StripFactors {
    /// Relative to the compliance of a cell.
    slips: Vec<Row<Block>>,
    /// Compliance of a cell, in m/Pa.
    own: f64,
    /// The lower factor without its diagonal.
    lower: Vec<[Block; LOWER]>,
    /// Inverse of the diagonal of the lower factor.
    pivots: Vec<Block>,
    /// The upper factor without its diagonal, which is one.
    upper: Vec<[Block; UPPER]>,
    /// Strips that are being solved, with as many zeros on either side as a row reaches.
    solved: [Vec<Twice>; AT_ONCE],
}

impl StripFactors {
    /// Of a patch.
    pub fn new(patch: &Patch, contact: &StripContact, stencils: &[SlipStencil]) -> Self {
        let row = short_range(&contact.row);
        let mut slips = Vec::with_capacity(patch.len());
        let has_neighbours = row[1] != [0.0; 2];
        let local = Local { patch, contact, row: &row, has_neighbours };
        let own = if row[0][0] > 0.0 { row[0][0] } else { 1.0 };
        for cells in &contact.slaved.kept {
            slips.resize(cells.start, Row::default());
            for k in cells.clone() {
                let mut blocks = Row::default();
                for (j, weight) in stencils[k].cells(k) {
                    local.add(cells, j, weight, (k, &mut blocks));
                }
                slips.push(blocks.map(|block| Block::of(&block.map(|row| row.map(|s| s / own)))));
            }
        }
        slips.resize(patch.len(), Row::default());
        Self { own, ..Self::of(slips) }
    }

    fn of(slips: Vec<Row<Block>>) -> Self {
        Self {
            own: 1.0,
            lower: vec![[Block::default(); LOWER]; slips.len()],
            upper: vec![[Block::default(); UPPER]; slips.len()],
            pivots: vec![Block::default(); slips.len()],
            solved: Default::default(),
            slips,
        }
    }

    /// Factorises the Jacobian of all strips.
    pub fn factorise(&mut self, interface: &Interface) {
        let stiffness = (interface.gamma * self.own).min(f64::from(f32::MAX)) as f32;
        for cells in interface.kept.chunks(AT_ONCE) {
            let longest = cells.iter().map(ExactSizeIterator::len).max().unwrap_or(0);
            for n in 0..longest {
                for cells in cells.iter().filter(|cells| n < cells.len()) {
                    let k = cells.start + n;
                    let slope = Block::of(&interface.resolvents[k].by_trial);
                    let mut row = [Block::default(); WIDTH];
                    for (block, slip) in row.iter_mut().zip(&self.slips[k]) {
                        *block = block.plus(stiffness, slope.times(*slip));
                    }
                    if let Some(bristles) = &interface.bristles {
                        bristles.add(&mut row, &interface.resolvents[k], k);
                    }
                    self.factorise_row((k, n), row, slope);
                }
            }
        }
    }

    /// Of a cell with `upstream` cells before it, from the blocks of its slip.
    fn factorise_row(&mut self, (k, upstream): (usize, usize), mut row: Row<Block>, slope: Block) {
        row[LOWER] = row[LOWER].plus(-1.0, slope).plus(1.0, Block::ONE);
        for at in LOWER - LOWER.min(upstream)..LOWER {
            let above = self.upper[k + at - LOWER];
            for (n, above) in above.into_iter().enumerate() {
                row[at + 1 + n] = row[at + 1 + n].plus(-1.0, row[at].times(above));
            }
        }
        let pivot = row[LOWER].inverse();
        self.pivots[k] = pivot;
        self.lower[k].copy_from_slice(&row[..LOWER]);
        for (upper, block) in self.upper[k].iter_mut().zip(&row[LOWER + 1..]) {
            *upper = pivot.times(*block);
        }
    }

    /// Solves for all strips, in place.
    pub fn solve(&mut self, strips: &[Range<usize>], v: &mut [f64]) {
        let Self { lower, upper, pivots, solved, .. } = self;
        for cells in strips.chunks(AT_ONCE) {
            let longest = cells.iter().map(ExactSizeIterator::len).max().unwrap_or(0);
            for solved in solved.iter_mut() {
                solved.clear();
                solved.resize(LOWER + longest + UPPER, Twice::default());
            }
            for n in 0..longest {
                for (cells, solved) in cells.iter().zip(solved.iter_mut()) {
                    if n < cells.len() {
                        let k = cells.start + n;
                        let rest = reduced_by(single(v, k), &lower[k], &solved[n..]);
                        solved[LOWER + n] = Twice::of(image(&pivots[k], rest));
                    }
                }
            }
            for n in (0..longest).rev() {
                for (cells, solved) in cells.iter().zip(solved.iter_mut()) {
                    if n < cells.len() {
                        let k = cells.start + n;
                        let (before, after) = solved.split_at_mut(LOWER + n + 1);
                        let own = &mut before[LOWER + n];
                        let value = reduced_by(own.once(), &upper[k], after);
                        *own = Twice::of(value);
                        [v[2 * k], v[2 * k + 1]] = value.map(f64::from);
                    }
                }
            }
        }
    }
}

/// The law in every cell, linearised.
pub(super) struct Interface<'a> {
    /// The cells with equations of their own, strip by strip.
    pub kept: &'a [Range<usize>],
    pub resolvents: &'a [Resolvent],
    /// γ, in Pa/m.
    pub gamma: f64,
    /// What the bristles do, if there are any.
    pub bristles: Option<Upstream<'a>>,
}

/// How the bristles of a cell depend on the tractions upstream.
pub(super) struct Upstream<'a> {
    pub stencils: &'a [SlipStencil],
    /// 1/(μ pₙ), in 1/Pa.
    pub over_bound: &'a [f64],
}

impl Upstream<'_> {
    /// Takes what the traction of cell `k` owes to those upstream off its row.
    fn add(&self, row: &mut Row<Block>, resolvent: &Resolvent, k: usize) {
        for (cell, weight) in self.stencils[k].upstream(k) {
            if let Some(at) = row.get_mut((LOWER + cell).wrapping_sub(k)) {
                let per_bound = weight * self.over_bound[cell];
                let by = resolvent.by_upstream.map(|row| row.map(|by| per_bound * by));
                *at = at.plus(-1.0, Block::of(&by));
            }
        }
    }
}

/// What a cell displaces its neighbours more than those farther away: all of these are displaced
/// nearly alike, which coarser grids know.
fn short_range(row: &Compliances) -> Compliances {
    let far = row[NEIGHBOURS + 1];
    row.map(|at| [0, 1].map(|c| (at[c] - far[c]).max(0.0)))
}

fn single(v: &[f64], k: usize) -> [f32; 2] {
    [v[2 * k] as f32, v[2 * k + 1] as f32]
}

/// Adds a symmetric block times a weight at a place of a row, if it is one.
fn add_block(row: &mut Row<Matrix>, at: usize, weight: f64, [xx, yy, xy]: [f64; 3]) {
    if let Some(block) = row.get_mut(at) {
        for (r, c, value) in [(0, 0, xx), (1, 1, yy), (0, 1, xy), (1, 0, xy)] {
            block[r][c] += weight * value;
        }
    }
}

/// Displacements of the cells of a strip relative to the entry.
struct Local<'a> {
    patch: &'a Patch,
    contact: &'a StripContact,
    row: &'a [[f64; 2]],
    has_neighbours: bool,
}

impl Local<'_> {
    /// Adds the displacement of cell `j` times a weight to the row of cell `k`.
    fn add(
        &self,
        cells: &Range<usize>,
        j: usize,
        weight: f64,
        (k, row): (usize, &mut Row<Matrix>),
    ) {
        if !self.has_neighbours {
            let [[xx, xy], [_, yy]] = self.contact.local[j];
            add_block(row, (LOWER + j).wrapping_sub(k), weight, [xx, yy, xy]);
            return;
        }
        let mut put = |to: usize, symmetric: [f64; 3]| {
            add_block(row, (LOWER + to).wrapping_sub(k), weight, symmetric);
        };
        for to in j.saturating_sub(NEIGHBOURS).max(cells.start)..cells.end.min(j + NEIGHBOURS + 1) {
            let [xx, yy] = self.row[to.abs_diff(j)];
            put(to, [xx, yy, 0.0]);
        }
        let [xx, yy, xy] = self.contact.calibration.at_cells[j];
        let least = self.row[0].map(|own| -settings::most_reduced() * own);
        put(j, [xx.max(least[0]), yy.max(least[1]), xy]);
        put(cells.start, self.contact.calibration.at_entries[j].map(|u| -u));
        let entry = self.patch.cells[j].entry_x();
        for to in cells.start..cells.end.min(cells.start + NEIGHBOURS + 1) {
            let [xx, yy] = self.at(entry, to);
            put(to, [-xx, -yy, 0.0]);
        }
    }

    /// Displacement at a place along the strip (in m) due to a cell.
    fn at(&self, x: f64, k: usize) -> [f64; 2] {
        let grid = &self.patch.grid;
        let away = x - grid.x(self.patch.cells[k].index % grid.columns);
        at_distance(self.row, (away / grid.spacing_x).abs())
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::rolling::shared::cell::times;
    use crate::rolling::shared::passage::pair;
    use crate::rolling::shared::strip::BristleState;

    /// The factors solve the banded system, strip by strip, in stick and in slip.
    #[test]
    fn factors_solve_the_jacobian() {
        let cells = 2..13;
        let entry = |k: usize, at: usize, c: usize| ((7 * k + 3 * at + 5 * c) % 11) as f64 - 5.0;
        let block = |k: usize, at: usize| {
            let own = if at == LOWER { 20.0 } else { 0.0 };
            [[own + entry(k, at, 0), entry(k, at, 1)], [entry(k, at, 2), own + entry(k, at, 3)]]
        };
        let slips: Vec<Row<Matrix>> = (0..14)
            .map(|k| std::array::from_fn(|at| block(k, at).map(|r| r.map(|s| 1e-2 * s))))
            .collect();
        let bristles = BristleState::default();
        let resolvents: Vec<Resolvent> =
            (0..14).map(|k| Resolvent::at([0.3 * f64::from(k), 1.0], 2.0, &bristles)).collect();
        let single = slips.iter().map(|row| row.map(|block| Block::of(&block)));
        let mut factors = StripFactors::of(single.collect());
        factors.factorise(&Interface {
            kept: std::slice::from_ref(&cells),
            resolvents: &resolvents,
            gamma: 3.0,
            bristles: None,
        });
        let right: Vec<f64> = (0..28).map(|n| f64::from((5 * n) % 9) - 4.0).collect();
        let mut v = right.clone();
        factors.solve(std::slice::from_ref(&cells), &mut v);
        for k in cells.clone() {
            let own = pair(&v, k);
            let mut slid = [0.0; 2];
            for j in k.saturating_sub(LOWER).max(cells.start)..cells.end.min(k + UPPER + 1) {
                let by = times(&slips[k][LOWER + j - k], pair(&v, j));
                slid = [slid[0] + 3.0 * by[0], slid[1] + 3.0 * by[1]];
            }
            let moved = times(&resolvents[k].by_trial, [own[0] - slid[0], own[1] - slid[1]]);
            for c in 0..2 {
                assert_relative_eq!(own[c] - moved[c], right[2 * k + c], epsilon = 2e-5);
            }
        }
    }
}
