//! Jacobians of single strips, factorised.
//!
//! Along a strip a cell is displaced by all tractions, on elastic layers within their decay length
//! hardly less than by its own. With p = T w, where T is the inverse of an exponential decay
//! (tridiagonal), a cell is displaced by w of itself and of two neighbours on either side alone.
//! With the slip taken of that, the Jacobian of a strip is banded, with blocks of both components.

use std::ops::Range;

use crate::normal::patch::Patch;
use crate::solver::rolling::shared::contact::{Row as Compliances, at_distance};
use crate::solver::settings;

use super::block::{Block, Twice, image, reduced_by};
use super::contact::StripContact;
use super::resolvent::Resolvent;
use super::slip_stencil::SlipStencil;

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
pub(in crate::solver::rolling) struct StripFactors {
    /// Relative to the compliance of a cell, by w.
    slips: Vec<Row<Block>>,
    decay: Decay,
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
    /// Of a patch, with the displacements of which the slip over the path into a cell is made.
    pub fn new<I: Iterator<Item = Displaced>>(
        patch: &Patch,
        contact: &StripContact,
        displaced: impl Fn(usize) -> I,
    ) -> Self {
        let row = &contact.row;
        let mut slips = Vec::with_capacity(patch.len());
        let decay = Decay::of(row);
        let local = Local { patch, contact, decay: &decay };
        let own = if row[0][0] > 0.0 { row[0][0] } else { 1.0 };
        for cells in &contact.slaved.kept {
            slips.resize(cells.start, Row::default());
            for k in cells.clone() {
                let mut blocks = Row::default();
                for displaced in displaced(k) {
                    local.add(cells, &displaced, (k, &mut blocks));
                }
                slips.push(blocks.map(|block| block.scaled([own.recip() as f32; 2])));
            }
        }
        slips.resize(patch.len(), Row::default());
        Self { own, ..Self::of(slips, decay) }
    }

    fn of(slips: Vec<Row<Block>>, decay: Decay) -> Self {
        Self {
            own: 1.0,
            decay,
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
                    self.decay.add(&mut row, LOWER, (k, cells), Block::ONE.plus(-1.0, slope));
                    if let Some(bristles) = &interface.bristles {
                        bristles.add(&mut row, &interface.resolvents[k], (k, cells, &self.decay));
                    }
                    self.factorise_row((k, n), row);
                }
            }
        }
    }

    /// Of a cell with `upstream` cells before it.
    fn factorise_row(&mut self, (k, upstream): (usize, usize), mut row: Row<Block>) {
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
        let Self { lower, upper, pivots, solved, decay, .. } = self;
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
                    }
                }
            }
            for (cells, solved) in cells.iter().zip(solved.iter()) {
                for (n, w) in solved[LOWER - 1..].windows(3).take(cells.len()).enumerate() {
                    let k = cells.start + n;
                    let traction = decay.traction([w[0], w[1], w[2]], (k, cells));
                    [v[2 * k], v[2 * k + 1]] = traction.map(f64::from);
                }
            }
        }
    }
}

/// A displacement that is a part of the slip over the path into a cell: `weight` times that of a
/// cell, less `entered` times that where its material entered, plus `alone` times that of the cell
/// under its own traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solver::rolling) struct Displaced {
    /// Index of the cell.
    pub cell: usize,
    /// Dimensionless.
    pub weight: f64,
    /// Dimensionless.
    pub entered: f64,
    /// Dimensionless.
    pub alone: f64,
}

/// The law in every cell, linearised.
pub(in crate::solver::rolling) struct Interface<'a> {
    /// The cells with equations of their own, strip by strip.
    pub kept: &'a [Range<usize>],
    pub resolvents: &'a [Resolvent],
    /// γ, in Pa/m.
    pub gamma: f64,
    /// What the bristles do, if there are any.
    pub bristles: Option<Upstream<'a>>,
}

/// How the bristles of a cell depend on the tractions upstream.
pub(in crate::solver::rolling) struct Upstream<'a> {
    pub stencils: &'a [SlipStencil],
    /// 1/(μ pₙ), in 1/Pa.
    pub over_bound: &'a [f64],
}

impl Upstream<'_> {
    /// Takes what the traction of cell `k` owes to those upstream off its row.
    fn add(
        &self,
        row: &mut Row<Block>,
        resolvent: &Resolvent,
        (k, cells, decay): (usize, &Range<usize>, &Decay),
    ) {
        for (cell, weight) in self.stencils[k].upstream(k) {
            let per_bound = -weight * self.over_bound[cell];
            let by = resolvent.by_upstream.map(|row| row.map(|by| per_bound * by));
            decay.add(row, (LOWER + cell).wrapping_sub(k), (cell, cells), Block::of(&by));
        }
    }
}

/// p = T w along a strip: the inverse of a decay r^|n| over n cells, times 1 − r² over 1 + r².
struct Decay {
    /// Compliances of a row, in m/Pa.
    row: Compliances,
    /// r/(1 + r²) of both components: minus the entries beside the diagonal.
    beside: [f64; 2],
    /// 1/(1 + r²): the first and the last entry of the diagonal. All others are one.
    end: [f64; 2],
}

impl Decay {
    fn has_neighbours(&self) -> bool {
        self.row[1] != [0.0; 2]
    }

    /// With the r for which a cell is not displaced by w of the one beside it.
    fn of(row: &Compliances) -> Self {
        let beside = [0, 1].map(|c| {
            let around = row[0][c] + row[2][c];
            if around > 0.0 { (row[1][c] / around).clamp(0.0, 0.5) } else { 0.0 }
        });
        let end = beside.map(|beside| 0.5 * (1.0 + (1.0 - 4.0 * beside * beside).sqrt()));
        Self { row: *row, beside, end }
    }

    fn diagonal(&self, (k, cells): (usize, &Range<usize>)) -> [f64; 2] {
        if k == cells.start || k + 1 == cells.end { self.end } else { [1.0; 2] }
    }

    /// Adds a block times p of a cell, which is at some place of the row.
    fn add(&self, row: &mut Row<Block>, at: usize, of: (usize, &Range<usize>), block: Block) {
        let (k, cells) = of;
        let beside = block.scaled(self.beside.map(|beside| -beside as f32));
        let own = block.scaled(self.diagonal(of).map(|own| own as f32));
        let before = (k > cells.start).then_some((at.wrapping_sub(1), beside));
        let after = (k + 1 < cells.end).then_some((at.wrapping_add(1), beside));
        for (at, block) in before.into_iter().chain([(at, own)]).chain(after) {
            if let Some(sum) = row.get_mut(at) {
                *sum = sum.plus(1.0, block);
            }
        }
    }

    /// p of a cell, from w before, of, and after it.
    fn traction(&self, [before, own, after]: [Twice; 3], of: (usize, &Range<usize>)) -> [f32; 2] {
        let [before, own, after] = [before, own, after].map(Twice::once);
        let diagonal = self.diagonal(of);
        [0, 1].map(|c| diagonal[c] as f32 * own[c] - self.beside[c] as f32 * (before[c] + after[c]))
    }

    /// Displacement at a distance of some columns from a cell under its w, in m/Pa.
    fn displacement(&self, columns: f64, of: (usize, &Range<usize>)) -> [f64; 2] {
        let (k, cells) = of;
        let diagonal = self.diagonal(of);
        let at = |away: f64| at_distance(&self.row, away.abs());
        let own = at(columns);
        let before = if k > cells.start { at(columns + 1.0) } else { [0.0; 2] };
        let after = if k + 1 < cells.end { at(columns - 1.0) } else { [0.0; 2] };
        [0, 1].map(|c| diagonal[c] * own[c] - self.beside[c] * (before[c] + after[c]))
    }
}

fn single(v: &[f64], k: usize) -> [f32; 2] {
    [v[2 * k] as f32, v[2 * k + 1] as f32]
}

fn symmetric([xx, yy, xy]: [f64; 3]) -> Block {
    Block::of(&[[xx, xy], [xy, yy]])
}

/// Displacements of the cells of a strip relative to the entry.
struct Local<'a> {
    patch: &'a Patch,
    contact: &'a StripContact,
    decay: &'a Decay,
}

impl Local<'_> {
    /// Adds a displacement to the row of cell `k`.
    fn add(&self, cells: &Range<usize>, of: &Displaced, (k, row): (usize, &mut Row<Block>)) {
        let Displaced { cell: j, weight, entered, alone } = *of;
        let mut put = |to: usize, weight: f64, by: [f64; 3]| {
            if let Some(block) = row.get_mut((LOWER + to).wrapping_sub(k)) {
                *block = block.plus(weight as f32, symmetric(by));
            }
        };
        if !self.decay.has_neighbours() {
            let [[xx, xy], [_, yy]] = self.contact.local[j];
            put(j, weight + alone, [xx, yy, xy]);
            return;
        }
        for to in j.saturating_sub(NEIGHBOURS).max(cells.start)..cells.end.min(j + NEIGHBOURS + 1) {
            let [xx, yy] = self.decay.displacement(j as f64 - to as f64, (to, cells));
            put(to, weight, [xx, yy, 0.0]);
        }
        let entry = self.patch.cells[j].entry_x();
        for to in cells.start..cells.end.min(cells.start + NEIGHBOURS + 1) {
            let [xx, yy] = self.decay.displacement(-self.columns(entry, to), (to, cells));
            put(to, -entered, [xx, yy, 0.0]);
        }
        let calibration = &self.contact.calibration;
        let [xx, yy, xy] = calibration.at_cells[j];
        let least = self.decay.row[0].map(|own| -settings::most_reduced() * own);
        let [own_x, own_y] = self.decay.row[0];
        for (of, weight, by) in [
            (j, weight + alone, [xx.max(least[0]), yy.max(least[1]), xy]),
            (j, alone, [own_x, own_y, 0.0]),
            (cells.start, -entered, calibration.at_entries[j]),
        ] {
            let block = symmetric(by.map(|by| weight * by));
            self.decay.add(row, (LOWER + of).wrapping_sub(k), (of, cells), block);
        }
    }

    /// Distance of a place (x in m) from a cell, in columns.
    fn columns(&self, x: f64, k: usize) -> f64 {
        let grid = &self.patch.grid;
        ((x - grid.x(self.patch.cells[k].index % grid.columns)) / grid.spacing_x).abs()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::solver::rolling::shared::cell::times;
    use crate::solver::rolling::shared::passage::pair;
    use crate::solver::rolling::shared::strip::{BristleState, Matrix};

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
        let mut factors = StripFactors::of(single.collect(), Decay::of(&Compliances::default()));
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
