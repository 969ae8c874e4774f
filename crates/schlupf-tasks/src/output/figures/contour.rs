//! Borders on the grid: between stick and slip, and of the contact itself.

use schlupf::grid::Grid;

use super::chain::{Chain, Crossing, chains};
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
    contour(patch, &values, level)
}

/// The part of the patch that sticks, as polygons that may reach beyond its rim; none if all of it
/// sticks.
pub(crate) fn sticking(patch: &Patch) -> Vec<Vec<[f64; 2]>> {
    let Sliding { values, level } = sliding(patch);
    if contour(patch, &values, level).is_empty() {
        return Vec::new();
    }
    let field = Padded::new(patch, &values);
    field.squares(level).map(below).filter(|polygon| polygon.len() > 2).collect()
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
    chains(&Padded::openness(patch).squares(HALF).flat_map(crossings).collect::<Vec<_>>())
}

/// Level of the rim: what is less open than this is inside.
const HALF: f64 = 0.5;

/// The contour of a field between the cell centres, extended over the rim of the patch.
fn contour(patch: &Patch, values: &[f64], level: f64) -> Vec<Chain> {
    chains(&Padded::new(patch, values).squares(level).flat_map(crossings).collect::<Vec<_>>())
}

/// A corner of a square between four cell centres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    /// Its number on the grid.
    pub node: usize,
    /// Its position, in m or in units of axes.
    pub at: [f64; 2],
    /// Value of the field above a level.
    pub value: f64,
}

/// The corners of a square in order.
pub(super) type Square = [Corner; 4];

/// Place where the contour crosses the edge of a square that begins at a corner.
fn crossing(corners: &Square, index: usize) -> Option<Crossing> {
    let (one, other) = (corners[index], corners[(index + 1) % 4]);
    let (f, g) = (one.value, other.value);
    let share = f / (f - g);
    let at = [0, 1].map(|axis| one.at[axis] + share * (other.at[axis] - one.at[axis]));
    let edge = [one.node.min(other.node), one.node.max(other.node)];
    ((f >= 0.0) != (g >= 0.0)).then_some(Crossing { edge, at })
}

/// Places where the contour crosses the edges of a square, joined in pairs.
pub(super) fn crossings(corners: Square) -> Vec<[Crossing; 2]> {
    let places: Vec<Crossing> = (0..4).filter_map(|index| crossing(&corners, index)).collect();
    places.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// The part of a square below the level.
pub(super) fn below(corners: Square) -> Vec<[f64; 2]> {
    let of_edge = |index: usize| {
        let Corner { at, value, .. } = corners[index];
        let crossing = crossing(&corners, index).map(|crossing| crossing.at);
        (value < 0.0).then_some(at).into_iter().chain(crossing)
    };
    (0..4).flat_map(of_edge).collect()
}

/// A field on the grid with one more cell all around. Rings of cells around the contact get the
/// mean of their inner neighbours, so that contours reach the rim; so do slivers at the rim, whose
/// small numbers scatter.
struct Padded<'a> {
    grid: &'a Grid,
    columns: usize,
    rows: usize,
    values: Vec<Option<f64>>,
}

impl<'a> Padded<'a> {
    fn new(patch: &Patch<'a>, values: &[f64]) -> Self {
        let fields = patch.fields();
        let (columns, rows) = (fields.grid.columns + 2, fields.grid.rows + 2);
        let mut padded =
            Self { grid: &fields.grid, columns, rows, values: vec![None; columns * rows] };
        let is_sliver = |cell: usize| fields.covered[cell] < SLIVER;
        let all = (0..fields.len()).all(is_sliver);
        for (cell, &[i, j]) in fields.cell.iter().enumerate() {
            padded.values[(j + 1) * columns + i + 1] =
                (all || !is_sliver(cell)).then_some(values[cell]);
        }
        for _ring in 0..3 {
            padded.grow();
        }
        padded
    }

    /// All squares between four known values, relative to a level.
    fn squares(&self, level: f64) -> impl Iterator<Item = Square> {
        let corner = move |i: usize, j: usize| {
            let (node, at) = (j * self.columns + i, self.position(i, j));
            self.value(i, j).map(|value| Corner { node, at, value: value - level })
        };
        let columns = self.columns;
        let places = (1..self.rows).flat_map(move |j| (1..columns).map(move |i| [i, j]));
        places.filter_map(move |[i, j]| {
            Some([corner(i - 1, j - 1)?, corner(i, j - 1)?, corner(i, j)?, corner(i - 1, j)?])
        })
    }

    /// The open fraction of the cells, one outside the contact. It is relative to the best covered
    /// cell around each, so that a part of the patch that covers no cell by half is not lost.
    fn openness(patch: &Patch<'a>) -> Self {
        let fields = patch.fields();
        let (columns, rows) = (fields.grid.columns + 2, fields.grid.rows + 2);
        let covered = |i: usize, j: usize| {
            let cell = patch.cell(i.checked_sub(1)?, j.checked_sub(1)?)?;
            Some(fields.covered[cell])
        };
        let most_around = |i: usize, j: usize| {
            let places = (j..j + 3).flat_map(|j| (i..i + 3).map(move |i| (i, j)));
            let covered = places.filter_map(|(i, j)| covered(i.checked_sub(1)?, j.checked_sub(1)?));
            covered.fold(0.0, f64::max)
        };
        let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
        let open = |(i, j)| 1.0 - covered(i, j).map_or(0.0, |part| part / most_around(i, j));
        let values = places.map(|place| Some(open(place))).collect();
        Self { grid: &fields.grid, columns, rows, values }
    }

    fn value(&self, i: usize, j: usize) -> Option<f64> {
        self.values[j * self.columns + i]
    }

    /// Centre of a cell, in m.
    fn position(&self, i: usize, j: usize) -> [f64; 2] {
        [
            self.grid.x(0) + (i as f64 - 1.0) * self.grid.spacing_x,
            self.grid.y(0) + (j as f64 - 1.0) * self.grid.spacing_y,
        ]
    }

    /// Sets the cells next to known ones to the mean of these.
    fn grow(&mut self) {
        let grown = (0..self.rows)
            .flat_map(|j| (0..self.columns).map(move |i| (i, j)))
            .map(|(i, j)| self.value(i, j).or_else(|| self.mean_around(i, j)))
            .collect();
        self.values = grown;
    }

    fn mean_around(&self, i: usize, j: usize) -> Option<f64> {
        let (mut sum, mut count) = (0.0, 0.0);
        for row in j.saturating_sub(1)..=(j + 1).min(self.rows - 1) {
            for column in i.saturating_sub(1)..=(i + 1).min(self.columns - 1) {
                if let Some(value) = self.value(column, row) {
                    sum += value;
                    count += 1.0;
                }
            }
        }
        (count > 0.0).then(|| sum / count)
    }
}
