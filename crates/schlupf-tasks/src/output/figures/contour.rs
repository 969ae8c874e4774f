//! Borders on the grid: between stick and slip, and of the contact itself.

use super::chain::Chain;
use super::lattice::Lattice;
use super::patch::Patch;
use super::run::SLIVER;

/// Criterion for sliding: a value for each contact cell that exceeds a level where the cell slides.
#[derive(Debug)]
pub(crate) struct Sliding {
    /// The values.
    pub values: Vec<f64>,
    /// The level.
    pub level: f64,
}

/// The used fraction of the friction bound, if it separates sliding from sticking cells, as it does
/// by definition: its contour is smooth. Otherwise the flags of the cells. Where next to nothing
/// sticks, everything slides: single cells at the rim would leave horns.
pub(crate) fn sliding(patch: &Patch) -> Sliding {
    /// Share of the contact.
    const NEXT_TO_NOTHING: f64 = 0.03;
    let used = used_friction(patch);
    let sliding = &patch.fields().sliding;
    let of =
        |state: bool| used.iter().zip(sliding).filter(move |(_, s)| **s == state).map(|(u, _)| *u);
    let most_sticking = of(false).fold(0.0, f64::max);
    let least_sliding = of(true).fold(f64::INFINITY, f64::min);
    let covered = &patch.fields().covered;
    let stuck = covered.iter().zip(sliding).filter(|(_, sliding)| !**sliding);
    let stuck: f64 = stuck.map(|(covered, _)| covered).sum();
    if stuck < NEXT_TO_NOTHING * covered.iter().sum::<f64>() {
        return Sliding { values: used, level: -1.0 };
    }
    if most_sticking < least_sliding && least_sliding.is_finite() {
        return Sliding { level: 0.5 * (most_sticking + least_sliding), values: used };
    }
    let marks = sliding.iter().map(|s| if *s { 1.0 } else { 0.0 }).collect();
    Sliding { values: marks, level: 0.5 }
}

/// The border between stick and slip.
pub(crate) fn stick_border(patch: &Patch) -> Vec<Chain> {
    let Sliding { values, level } = sliding(patch);
    padded(patch, &values).contour(level)
}

/// The part of the patch that sticks, as polygons that may reach beyond its rim; none if all of it
/// sticks.
pub(crate) fn sticking(patch: &Patch) -> Vec<Vec<[f64; 2]>> {
    let Sliding { values, level } = sliding(patch);
    let field = padded(patch, &values);
    if field.contour(level).is_empty() { Vec::new() } else { field.below(level) }
}

/// |t|/(μ pₙ) in every contact cell, zero where unknown.
fn used_friction(patch: &Patch) -> Vec<f64> {
    let fields = patch.fields();
    (0..fields.len())
        .map(|cell| {
            let bound = fields.friction_coefficient[cell] * fields.pressure[cell];
            fields.traction_x[cell].hypot(fields.traction_y[cell]) / bound
        })
        .map(|used| if used.is_finite() { used } else { 0.0 })
        .collect()
}

/// The rim of a patch that is no ellipse: where half of a cell would be covered. All of its chains
/// are closed.
pub(crate) fn outline(patch: &Patch) -> Vec<Chain> {
    openness(patch).contour(HALF)
}

/// Level of the rim: what is less open than this is inside.
const HALF: f64 = 0.5;

/// Values at the cell centres, with one more cell all around.
fn lattice(patch: &Patch, value: impl Fn(usize, usize) -> f64) -> Lattice {
    let grid = &patch.fields().grid;
    let centre = |first: f64, spacing: f64| move |k: usize| first + (k as f64 - 1.0) * spacing;
    let (columns, rows) = (grid.columns + 2, grid.rows + 2);
    Lattice {
        x: (0..columns).map(centre(grid.x(0), grid.spacing_x)).collect(),
        y: (0..rows).map(centre(grid.y(0), grid.spacing_y)).collect(),
        rows: (0..rows).map(|j| (0..columns).map(|i| value(i, j)).collect()).collect(),
    }
}

/// The contact cell at a place of a lattice.
fn cell(patch: &Patch, i: usize, j: usize) -> Option<usize> {
    patch.cell(i.checked_sub(1)?, j.checked_sub(1)?)
}

/// A field, in which rings of cells around the contact get the mean of their inner neighbours, so
/// that contours reach the rim; so do slivers at the rim, whose small numbers scatter.
fn padded(patch: &Patch, values: &[f64]) -> Lattice {
    let covered = &patch.fields().covered;
    let is_sliver = |cell: usize| covered[cell] < SLIVER;
    let all = (0..covered.len()).all(is_sliver);
    let known = |cell: &usize| all || !is_sliver(*cell);
    let value = |i, j| cell(patch, i, j).filter(known).map_or(f64::NAN, |cell| values[cell]);
    let mut field = lattice(patch, value);
    for _ring in 0..3 {
        field.rows = lattice(patch, |i, j| grown(&field.rows, i, j)).rows;
    }
    field
}

/// A value, or the mean of the known ones around.
fn grown(rows: &[Vec<f64>], i: usize, j: usize) -> f64 {
    if !rows[j][i].is_nan() {
        return rows[j][i];
    }
    let near = rows.iter().take(j + 2).skip(j.saturating_sub(1));
    let near = near.flat_map(|row| row.iter().take(i + 2).skip(i.saturating_sub(1)));
    let known = near.filter(|value| !value.is_nan());
    known.clone().sum::<f64>() / known.count() as f64
}

/// The open fraction of the cells, one outside the contact. It is relative to the best covered cell
/// around each, so that a part of the patch that covers no cell by half is not lost.
fn openness(patch: &Patch) -> Lattice {
    let covered = |i, j| cell(patch, i, j).map_or(0.0, |cell| patch.fields().covered[cell]);
    let most_around = |i: usize, j: usize| {
        let places = (j.max(1)..j + 3).flat_map(|j| (i.max(1)..i + 3).map(move |i| (i, j)));
        places.map(|(i, j)| covered(i - 1, j - 1)).fold(0.0, f64::max)
    };
    lattice(patch, |i, j| {
        let part = covered(i, j);
        if part > 0.0 { 1.0 - part / most_around(i, j) } else { 1.0 }
    })
}
