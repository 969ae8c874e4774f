//! Borders on the grid: between sticking and sliding, and of the contact itself.

use schlupf::grid::Grid;

use super::patch::Patch;

/// A piece of a border, in m.
pub(crate) type Segment = [[f64; 2]; 2];

/// What tells sliding from sticking: a value for each contact cell that exceeds a level where the
/// cell slides.
#[derive(Debug)]
pub(crate) struct Sliding {
    /// The values.
    pub values: Vec<f64>,
    /// The level.
    pub level: f64,
}

/// The share of the friction bound in use where it tells sliding cells from sticking ones, as it
/// does by definition: its contour is smooth. Else the marks of the cells.
pub(crate) fn sliding(patch: &Patch) -> Sliding {
    let used = used_friction(patch);
    let sliding = &patch.fields().sliding;
    let of =
        |state: bool| used.iter().zip(sliding).filter(move |(_, s)| **s == state).map(|(u, _)| *u);
    let most_sticking = of(false).fold(0.0, f64::max);
    let least_sliding = of(true).fold(f64::INFINITY, f64::min);
    if most_sticking < least_sliding && least_sliding.is_finite() {
        return Sliding { level: 0.5 * (most_sticking + least_sliding), values: used };
    }
    let marks = sliding.iter().map(|s| if *s { 1.0 } else { 0.0 }).collect();
    Sliding { values: marks, level: 0.5 }
}

/// The border between sticking and sliding.
pub(crate) fn stick_border(patch: &Patch) -> Vec<Segment> {
    let Sliding { values, level } = sliding(patch);
    contour(patch, &values, level)
}

/// |t|/(μ pₙ) in every contact cell, zero where there is no telling.
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

/// The edges between contact cells and others.
pub(crate) fn outline(patch: &Patch) -> Vec<Segment> {
    let grid = &patch.fields().grid;
    let mut segments = Vec::new();
    for &[i, j] in &patch.fields().cell {
        let [x0, x1] = [grid.edge_x(i), grid.edge_x(i + 1)];
        let [y0, y1] = [grid.edge_y(j), grid.edge_y(j + 1)];
        let before = |index: usize| index.checked_sub(1);
        let sides = [
            (before(i).and_then(|i| patch.cell(i, j)), [[x0, y0], [x0, y1]]),
            (patch.cell(i + 1, j), [[x1, y0], [x1, y1]]),
            (before(j).and_then(|j| patch.cell(i, j)), [[x0, y0], [x1, y0]]),
            (patch.cell(i, j + 1), [[x0, y1], [x1, y1]]),
        ];
        segments.extend(sides.into_iter().filter(|(cell, _)| cell.is_none()).map(|(_, side)| side));
    }
    segments
}

/// The contour of a field between the cell centres, drawn on over the rim of the patch.
fn contour(patch: &Patch, values: &[f64], level: f64) -> Vec<Segment> {
    let field = Padded::new(patch, values);
    let mut segments = Vec::new();
    for j in 1..field.rows {
        for i in 1..field.columns {
            let corner = |i: usize, j: usize| {
                field.value(i, j).map(|value| (field.position(i, j), value - level))
            };
            let corners = [corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)];
            if let [Some(p), Some(q), Some(r), Some(s)] = corners {
                segments.extend(crossings([p, q, r, s]));
            }
        }
    }
    segments
}

/// Where the contour crosses the edges of a square, joined in pairs.
fn crossings(corners: [([f64; 2], f64); 4]) -> Vec<Segment> {
    let mut points = Vec::new();
    for (index, &(p, f)) in corners.iter().enumerate() {
        let (q, g) = corners[(index + 1) % 4];
        if (f >= 0.0) != (g >= 0.0) {
            let share = f / (f - g);
            points.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
        }
    }
    points.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// A field on the grid with one more cell all around. Two rings of cells around the contact take
/// the mean of their neighbours within, so that contours reach its rim.
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
        for (&[i, j], value) in fields.cell.iter().zip(values) {
            padded.values[(j + 1) * columns + i + 1] = Some(*value);
        }
        padded.grow();
        padded.grow();
        padded
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

    /// Gives the cells next to known ones the mean of these.
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
