//! Borders on the grid: between sticking and sliding, and of the contact itself.

use super::patch::Patch;

/// A piece of a border, in m.
pub(super) type Segment = [[f64; 2]; 2];

/// What tells sliding from sticking: a value for each contact cell that exceeds a level where the cell
/// slides.
#[derive(Debug)]
pub(super) struct Sliding {
    /// The values.
    pub values: Vec<f64>,
    /// The level.
    pub level: f64,
}

/// The share of the friction bound in use where it tells sliding cells from sticking ones, as it does
/// by definition: its contour is smooth. Else the marks of the cells.
pub(super) fn sliding(patch: &Patch) -> Sliding {
    let used = used_friction(patch);
    let sliding = &patch.fields().sliding;
    let of = |state: bool| used.iter().zip(sliding).filter(move |(_, s)| **s == state).map(|(u, _)| *u);
    let most_sticking = of(false).fold(0.0, f64::max);
    let least_sliding = of(true).fold(f64::INFINITY, f64::min);
    if most_sticking < least_sliding && least_sliding.is_finite() {
        return Sliding { level: 0.5 * (most_sticking + least_sliding), values: used };
    }
    let marks = sliding.iter().map(|s| if *s { 1.0 } else { 0.0 }).collect();
    Sliding { values: marks, level: 0.5 }
}

/// The border between sticking and sliding.
pub(super) fn stick_border(patch: &Patch) -> Vec<Segment> {
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
pub(super) fn outline(patch: &Patch) -> Vec<Segment> {
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
    let grid = &patch.fields().grid;
    let field = extended(patch, values);
    let mut segments = Vec::new();
    for row in -1..grid.rows as isize {
        for column in -1..grid.columns as isize {
            let corner = |i: isize, j: isize| {
                let x = grid.origin_x + (i as f64 + 0.5) * grid.spacing_x;
                let y = grid.origin_y + (j as f64 + 0.5) * grid.spacing_y;
                field[place(grid.columns, i, j)].map(|value| ([x, y], value - level))
            };
            let corners = [
                corner(column, row),
                corner(column + 1, row),
                corner(column + 1, row + 1),
                corner(column, row + 1),
            ];
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

/// A field on the grid with one more cell all around; two rings of cells around the contact take the
/// mean of their neighbours within, so that contours reach its rim.
fn extended(patch: &Patch, values: &[f64]) -> Vec<Option<f64>> {
    let grid = &patch.fields().grid;
    let (columns, rows) = (grid.columns as isize, grid.rows as isize);
    let mut field = vec![None; (grid.columns + 2) * (grid.rows + 2)];
    for (&[i, j], value) in patch.fields().cell.iter().zip(values) {
        field[place(grid.columns, i as isize, j as isize)] = Some(*value);
    }
    for _ in 0..2 {
        let inner = field.clone();
        for row in -1..=rows {
            for column in -1..=columns {
                let here = place(grid.columns, column, row);
                if inner[here].is_some() {
                    continue;
                }
                let neighbours: Vec<f64> = (-1..=1)
                    .flat_map(|dj| (-1..=1).map(move |di| (column + di, row + dj)))
                    .filter(|&(i, j)| (-1..=columns).contains(&i) && (-1..=rows).contains(&j))
                    .filter_map(|(i, j)| inner[place(grid.columns, i, j)])
                    .collect();
                if !neighbours.is_empty() {
                    field[here] = Some(neighbours.iter().sum::<f64>() / neighbours.len() as f64);
                }
            }
        }
    }
    field
}

/// Index of a place, which may lie one cell outside the grid.
fn place(columns: usize, column: isize, row: isize) -> usize {
    ((row + 1) * (columns as isize + 2) + column + 1) as usize
}
