//! Locates the contact and solves for the pressure.

use super::distance::{Shape, UndeformedDistance};
use crate::normal::rough_contact::{
    Boundary, RoughContact, RoughContactOptions, RoughContactSolution,
};
use crate::reporting::{Error, Quantity, Watch};
use crate::surface::{HeightMap, Lattice};

/// The contact problem.
pub(super) struct Search<'a> {
    pub distance: &'a UndeformedDistance,
    /// E*, in Pa.
    pub contact_modulus: f64,
    pub held: Held,
    /// Number of cells across the contact in each direction.
    pub cells: usize,
    pub watch: Watch<'a>,
}

/// What the bodies are pressed together by, or to.
#[derive(Debug, Clone, Copy)]
pub(super) enum Held {
    /// N, in N.
    Load(f64),
    /// δ, in m.
    Approach(f64),
}

/// A pressure at equidistant positions, in the coordinates of the distance.
pub(super) struct Solved {
    /// Positions along rolling, in m.
    pub x: Vec<f64>,
    /// Positions across, in m.
    pub y: Vec<f64>,
    /// Rows along x, in Pa.
    pub pressure: Vec<f64>,
    /// N, in N.
    pub load: f64,
    /// Approach of the bodies, in m.
    pub approach: f64,
}

/// Side of a rectangle, lower and upper end, in m.
type Side = [f64; 2];

/// A rectangle: its sides along x and y.
type Rectangle = [Side; 2];

/// A contact solved on a rectangle.
struct Pressed {
    lattice: Lattice,
    rectangle: Rectangle,
    solution: RoughContactSolution,
    /// δ relative to the origin of the distance, in m.
    level: f64,
}

/// Lower bound of the load that a body carries, relative to E* δ √A, dimensionless.
const LEAST_CARRIED: f64 = 0.3;

/// Cells in each direction of the lattices on which the contact is located.
const COARSE: usize = 64;

/// The search ends when the contact takes up this fraction of the rectangle in each direction,
/// dimensionless.
const TIGHT: f64 = 0.5;

/// Rounds in which rectangles close in on the contact; each may shrink by more than a factor of
/// ten.
const MOST_ROUNDS: usize = 24;

/// If several parts lie side by side the number of cells is increased, so that the widest part has
/// as many as a single contact would, but at most by this factor in each direction.
const MOST_REFINED: f64 = 4.0;

const SEARCHING: RoughContactOptions = RoughContactOptions { tolerance: 1e-4, max_iterations: 300 };
const SOLVING: RoughContactOptions = RoughContactOptions { tolerance: 1e-8, max_iterations: 1000 };

impl Search<'_> {
    pub fn solve(&self) -> Result<Solved, Error> {
        let (mut touched, widest) = self.locate()?;
        let mut rectangle = touched.map(|side| padded(side, 2.0 * length(side) / COARSE as f64));
        for _ in 0..MOST_ROUNDS {
            rectangle = self.within_bounds(rectangle);
            let cells = [0, 1].map(|k| {
                let parts = (length(touched[k]) / widest[k]).clamp(1.0, MOST_REFINED);
                let spacing = length(touched[k]) / (parts * self.cells as f64);
                (length(rectangle[k]) / spacing).ceil() as usize
            });
            let pressed = self.press(rectangle, cells, &SOLVING)?;
            pressed.require_convergence()?;
            let (again, missed) = (pressed.touched(), self.pressed_in_outside(&pressed));
            let next = self.widened(rectangle, again, missed);
            if next == rectangle {
                self.refuse_edge(&pressed, again)?;
                return Ok(self.solved(pressed));
            }
            (touched, rectangle) = (again, next);
        }
        Err(lost(rectangle))
    }

    /// The bounding rectangle of the contact, to a few hundredths of its sides, and the width along
    /// x and y of its widest part.
    fn locate(&self) -> Result<(Rectangle, [f64; 2]), Error> {
        let mut rectangle = self.within_bounds(self.overlap(self.greatest_approach()));
        // Parts that such a coarse lattice may miss.
        let mut beside: Option<Rectangle> = None;
        for _ in 0..MOST_ROUNDS {
            let pressed = self.press(rectangle, [COARSE; 2], &SEARCHING)?;
            let missed = self.pressed_in_outside(&pressed);
            beside = union(beside, missed);
            let touched = beside.map_or(pressed.touched(), |r| joined(pressed.touched(), r));
            let next = self.widened(rectangle, touched, missed);
            let is_tight = (0..2).all(|k| length(touched[k]) >= TIGHT * length(rectangle[k]));
            if next == rectangle && is_tight {
                self.refuse_edge(&pressed, touched)?;
                return Ok((touched, pressed.widest_parts()));
            }
            rectangle = if next == rectangle {
                let cells = [pressed.lattice.spacing_x, pressed.lattice.spacing_y];
                let pad = |k: usize| cells[k] + 0.1 * length(touched[k]);
                self.within_bounds([0, 1].map(|k| padded(touched[k], pad(k))))
            } else {
                next
            };
        }
        Err(lost(rectangle))
    }

    /// The approach (in m) if it is held, otherwise an upper estimate, and not much larger.
    ///
    /// With A the area within δ of first contact, a flat punch carries 1.1 E* δ √A, a sphere half
    /// as much, a cone 0.36 E* δ √A.
    fn greatest_approach(&self) -> f64 {
        let load = match self.held {
            Held::Load(load) => load,
            Held::Approach(approach) => return approach,
        };
        let [_, across] = self.distance.bounds();
        let carries = |approach: f64| {
            LEAST_CARRIED * self.contact_modulus * approach * self.area(approach).sqrt()
        };
        let mut approach = 1e-6 * load / (self.contact_modulus * length(across));
        while carries(approach) < load && approach < length(across) {
            approach *= 1.5;
        }
        approach
    }

    /// Area within an approach (in m) of first contact, in m².
    fn area(&self, approach: f64) -> f64 {
        let level = self.distance.lowest() + approach;
        match &self.distance.shape {
            Shape::Across { y, distance, radius } => {
                let chord = |d: f64| 2.0 * (2.0 * radius * (level - d).max(0.0)).sqrt();
                distance.iter().enumerate().map(|(j, d)| chord(*d) * share(y, j)).sum()
            }
            Shape::Along { x, distance, length } => {
                let inside = (0..x.len()).filter(|i| distance[*i] < level);
                length * inside.map(|i| share(x, i)).sum::<f64>()
            }
            Shape::Lattice { x, y, distance } => {
                let cell = |k: usize| share(x, k % x.len()) * share(y, k / x.len());
                (0..distance.len()).filter(|k| distance[*k] < level).map(cell).sum()
            }
        }
    }

    /// The rectangle that contains all points within an approach (in m) of first contact. It
    /// contains the contact, because pressure moves the surfaces apart everywhere.
    fn overlap(&self, approach: f64) -> Rectangle {
        let level = self.distance.lowest() + approach;
        match &self.distance.shape {
            Shape::Across { y, distance, radius } => {
                let half = (2.0 * radius * approach).sqrt();
                [[-half, half], spanned(y, |j| distance[j] < level)]
            }
            Shape::Along { x, distance, .. } => {
                [spanned(x, |i| distance[i] < level), self.distance.bounds()[1]]
            }
            Shape::Lattice { x, y, distance } => {
                let n = x.len();
                let column = |i: usize| (0..y.len()).any(|j| distance[j * n + i] < level);
                let row = |j: usize| (0..n).any(|i| distance[j * n + i] < level);
                [spanned(x, column), spanned(y, row)]
            }
        }
    }

    fn within_bounds(&self, rectangle: Rectangle) -> Rectangle {
        let bounds = self.distance.bounds();
        [0, 1].map(|k| [rectangle[k][0].max(bounds[k][0]), rectangle[k][1].min(bounds[k][1])])
    }

    fn press(
        &self,
        rectangle: Rectangle,
        cells: [usize; 2],
        options: &RoughContactOptions,
    ) -> Result<Pressed, Error> {
        let [columns, rows] = cells;
        let rows = if self.distance.is_line() { 1 } else { rows };
        let lattice = Lattice {
            columns,
            rows,
            spacing_x: length(rectangle[0]) / columns as f64,
            spacing_y: length(rectangle[1]) / rows as f64,
        };
        let [x, y] = positions(&lattice, rectangle);
        let distance = self.distance.sample(&x, &y);
        let map = if self.distance.is_line() {
            HeightMap::row(lattice, distance)
        } else {
            HeightMap::new(lattice, distance)?
        };
        let [lowest, _] = map.range();
        let mut contact = RoughContact::new(map, self.contact_modulus, Boundary::Free)?;
        let solution = match self.held {
            Held::Load(load) => contact.solve(load, options, self.watch),
            Held::Approach(approach) => {
                contact.solve_at_level(self.distance.lowest() + approach, options, self.watch)
            }
        }?;
        let level = lowest + solution.approach;
        Ok(Pressed { lattice, rectangle, solution, level })
    }

    /// The rectangle enlarged where the contact continues beyond it; unchanged if it contains all
    /// of the contact.
    fn widened(
        &self,
        rectangle: Rectangle,
        touched: Rectangle,
        missed: Option<Rectangle>,
    ) -> Rectangle {
        let bounds = self.distance.bounds();
        let grown = [0, 1].map(|k| {
            let [mut from, mut to] = rectangle[k];
            let more = 0.5 * length(rectangle[k]);
            if touched[k][0] <= from && from > bounds[k][0] {
                from -= more;
            }
            if touched[k][1] >= to && to < bounds[k][1] {
                to += more;
            }
            [from, to]
        });
        self.within_bounds(missed.map_or(grown, |missed| joined(grown, missed)))
    }

    /// The rectangle of the given points outside the lattice at which the bodies would overlap.
    fn pressed_in_outside(&self, pressed: &Pressed) -> Option<Rectangle> {
        let level = pressed.level;
        let forces = pressed.forces();
        let [columns, rows] = pressed.rectangle;
        let is_outside =
            |x: f64, y: f64| x < columns[0] || x > columns[1] || y < rows[0] || y > rows[1];
        let over = (std::f64::consts::PI * self.contact_modulus).recip();
        let is_pressed_in = |x: f64, y: f64, distance: f64| {
            if distance >= level || !is_outside(x, y) {
                return false;
            }
            let moved: f64 = forces.iter().map(|[fx, fy, f]| f / self.reach(x - fx, y - fy)).sum();
            distance + over * moved < level - NEGLIGIBLE * pressed.solution.approach
        };
        match &self.distance.shape {
            Shape::Across { y, distance, .. } => {
                let is_hit: Vec<bool> =
                    (0..y.len()).map(|j| is_pressed_in(0.0, y[j], distance[j])).collect();
                let is_any = is_hit.iter().any(|hit| *hit);
                is_any.then(|| [columns, spanned(y, |j| is_hit[j])])
            }
            Shape::Along { x, distance, .. } => {
                let is_hit: Vec<bool> =
                    (0..x.len()).map(|i| is_pressed_in(x[i], 0.0, distance[i])).collect();
                let is_any = is_hit.iter().any(|hit| *hit);
                is_any.then(|| [spanned(x, |i| is_hit[i]), rows])
            }
            Shape::Lattice { x, y, distance } => {
                let n = x.len();
                let is_hit: Vec<bool> = (0..distance.len())
                    .map(|k| is_pressed_in(x[k % n], y[k / n], distance[k]))
                    .collect();
                let is_any = is_hit.iter().any(|hit| *hit);
                let column = |i: usize| (0..y.len()).any(|j| is_hit[j * n + i]);
                let row = |j: usize| (0..n).any(|i| is_hit[j * n + i]);
                is_any.then(|| [spanned(x, column), spanned(y, row)])
            }
        }
    }

    /// The distance (in m) at which a point force displaces as much as one at a distance (in m)
    /// along and across, which acts on the whole length of a line contact.
    fn reach(&self, x: f64, y: f64) -> f64 {
        match &self.distance.shape {
            Shape::Along { length, .. } => 0.5 * length / (0.5 * length / x.abs()).asinh(),
            Shape::Across { .. } | Shape::Lattice { .. } => x.hypot(y),
        }
    }

    fn solved(&self, pressed: Pressed) -> Solved {
        let [x, mut y] = positions(&pressed.lattice, pressed.rectangle);
        let RoughContactSolution { mut pressure, load, .. } = pressed.solution;
        if self.distance.is_line() {
            // Two rows that are half as wide.
            let aside = 0.25 * pressed.lattice.spacing_y;
            y = vec![-aside, aside];
            pressure = pressure.repeat(2);
        }
        let approach = match self.held {
            Held::Load(_) => pressed.level - self.distance.lowest(),
            Held::Approach(approach) => approach,
        };
        Solved { x, y, pressure, load, approach }
    }

    /// Rejects a contact that extends to the limits of the known distance.
    fn refuse_edge(&self, pressed: &Pressed, touched: Rectangle) -> Result<(), Error> {
        let bounds = self.distance.bounds();
        let axes = if self.distance.is_line() { &['x'][..] } else { &['x', 'y'] };
        for (k, axis) in axes.iter().copied().enumerate() {
            for end in 0..2 {
                let edge = bounds[k][end];
                let is_there = pressed.rectangle[k][end] == edge && touched[k][end] == edge;
                if is_there {
                    let load = pressed.solution.load;
                    return Err(Error::ContactAtEdge { load, axis, edge });
                }
            }
        }
        Ok(())
    }
}

/// An overlap outside the lattice below this fraction of the approach carries a negligible load.
const NEGLIGIBLE: f64 = 1e-3;

impl Pressed {
    /// The rectangle of the cells in contact. Where it reaches the lattice's sides, it has exactly
    /// those sides.
    fn touched(&self) -> Rectangle {
        let Lattice { columns, rows, .. } = self.lattice;
        let is_contact = |i: usize, j: usize| self.solution.pressure[j * columns + i] > 0.0;
        let counts = [columns, rows];
        let is_line = [
            (0..columns).map(|i| (0..rows).any(|j| is_contact(i, j))).collect::<Vec<_>>(),
            (0..rows).map(|j| (0..columns).any(|i| is_contact(i, j))).collect(),
        ];
        [0, 1].map(|k| {
            let [from, to] = self.rectangle[k];
            let first = is_line[k].iter().position(|is| *is).unwrap_or(0);
            let end = is_line[k].iter().rposition(|is| *is).unwrap_or(0) + 1;
            let at = |edge: usize| {
                if edge == counts[k] {
                    to
                } else {
                    from + (to - from) * edge as f64 / counts[k] as f64
                }
            };
            [at(first), at(end)]
        })
    }

    /// Longest uninterrupted run of columns and of rows that contain contact, along x and y, in m.
    fn widest_parts(&self) -> [f64; 2] {
        let Lattice { columns, rows, spacing_x, spacing_y } = self.lattice;
        let is_contact = |i: usize, j: usize| self.solution.pressure[j * columns + i] > 0.0;
        let longest = |count: usize, is_line: &dyn Fn(usize) -> bool| {
            let runs = (0..count).scan(0_usize, |run, k| {
                *run = if is_line(k) { *run + 1 } else { 0 };
                Some(*run)
            });
            runs.max().unwrap_or(0) as f64
        };
        let column = |i: usize| (0..rows).any(|j| is_contact(i, j));
        let row = |j: usize| (0..columns).any(|i| is_contact(i, j));
        [spacing_x * longest(columns, &column), spacing_y * longest(rows, &row)]
    }

    /// The pressure as forces (in N) at positions x and y (in m), one for each loaded block of
    /// cells.
    fn forces(&self) -> Vec<[f64; 3]> {
        let Lattice { columns, rows, .. } = self.lattice;
        let [x, y] = positions(&self.lattice, self.rectangle);
        let block = [columns, rows].map(|count| count.div_ceil(BLOCKS));
        let mut forces = vec![[0.0; 3]; BLOCKS * BLOCKS];
        for (k, pressure) in self.solution.pressure.iter().enumerate() {
            let (i, j) = (k % columns, k / columns);
            let force = pressure * self.lattice.cell_area();
            let sums = &mut forces[j / block[1] * BLOCKS + i / block[0]];
            for (sum, add) in sums.iter_mut().zip([force * x[i], force * y[j], force]) {
                *sum += add;
            }
        }
        let carrying = forces.into_iter().filter(|[_, _, force]| *force > 0.0);
        carrying.map(|[x, y, force]| [x / force, y / force, force]).collect()
    }

    fn require_convergence(&self) -> Result<(), Error> {
        if self.solution.is_converged {
            return Ok(());
        }
        Err(Error::NormalNotConverged {
            quantity: Quantity::UndeformedDistance,
            iterations: self.solution.iterations,
            residual: self.solution.residual,
            tolerance: SOLVING.tolerance,
        })
    }
}

/// Blocks of cells in each direction whose forces act as one at a distance.
const BLOCKS: usize = 16;

/// Centres of the columns and rows of a lattice on a rectangle, in m.
fn positions(lattice: &Lattice, rectangle: Rectangle) -> [Vec<f64>; 2] {
    let middle = |side: Side| 0.5 * (side[0] + side[1]);
    [
        (0..lattice.columns).map(|i| middle(rectangle[0]) + lattice.x(i)).collect(),
        (0..lattice.rows).map(|j| middle(rectangle[1]) + lattice.y(j)).collect(),
    ]
}

fn length(side: Side) -> f64 {
    side[1] - side[0]
}

/// The smallest rectangle that contains both.
fn joined(p: Rectangle, q: Rectangle) -> Rectangle {
    [0, 1].map(|k| [p[k][0].min(q[k][0]), p[k][1].max(q[k][1])])
}

fn union(p: Option<Rectangle>, q: Option<Rectangle>) -> Option<Rectangle> {
    match (p, q) {
        (Some(p), Some(q)) => Some(joined(p, q)),
        _ => p.or(q),
    }
}

fn padded(side: Side, by: f64) -> Side {
    [side[0] - by, side[1] + by]
}

/// Length that a point represents, in its unit.
fn share(points: &[f64], k: usize) -> f64 {
    let (before, after) = (k.saturating_sub(1), (k + 1).min(points.len() - 1));
    0.5 * (points[after] - points[before])
}

/// From the point before the first counted one to the one after the last.
fn spanned(points: &[f64], counts: impl Fn(usize) -> bool) -> Side {
    let first = (0..points.len()).position(&counts).unwrap_or(0);
    let last = (0..points.len()).rposition(&counts).unwrap_or(0);
    [points[first.saturating_sub(1)], points[(last + 1).min(points.len() - 1)]]
}

fn lost(rectangle: Rectangle) -> Error {
    let [x, y] = rectangle;
    Error::ContactNotFound { rounds: MOST_ROUNDS, x, y }
}
