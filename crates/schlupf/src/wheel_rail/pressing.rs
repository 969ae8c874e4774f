//! Normal contact in a plane, with the approach of the bodies given.
//!
//! The undeformed overlap contains the contact, because pressure moves the surfaces apart
//! everywhere. It is found first, then the contact on a coarse lattice over it, then the contact on
//! cells that follow its size.
//!
//! No condition fixes the sum of the pressures, because several contacts share one height.

use super::contact_plane::ContactPlane;
use super::distance::{CLEAR, Heights, PlaneView};
use super::opening::Opening;
use super::pair::Pair;
use super::pose::Pose;
use super::pressed::{Pressed, positions};
use super::virtual_penetration::{self, NormalMethod};
use crate::normal::rough_contact::{
    Boundary, Curved, RoughContact, RoughContactOptions, RoughContactSolution,
};
use crate::reporting::{Error, Quantity, Watch};
use crate::surface::{HeightMap, Lattice};

/// Cells each way of the lattice on which the overlap is found, and on which the contact is found
/// coarsely.
const COARSE: usize = 32;

/// Least share of the rectangle that the overlap takes in each direction when it counts as found.
const TIGHT: f64 = 0.5;

/// Most rounds in which the rectangle closes in.
const MOST_ROUNDS: usize = 24;

/// Rim around a contact on the final lattice, in its cells.
const RIM: f64 = 2.0;

const COARSELY: RoughContactOptions = RoughContactOptions { tolerance: 1e-5, max_iterations: 300 };
const FINELY: RoughContactOptions = RoughContactOptions { tolerance: 1e-8, max_iterations: 1000 };

/// Sides along x and s, relative to the plane's origin, in m.
type Rectangle = [[f64; 2]; 2];

/// How accurately a normal contact is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Accuracy {
    /// On a coarse lattice over the overlap.
    Coarse,
    /// With so many cells across the contact each way.
    Cells(usize),
}

/// How far surfaces have been moved apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct Raised<'a> {
    /// By other contacts, in m.
    pub everywhere: f64,
    /// By tractions.
    pub opening: Option<&'a Opening>,
}

/// Bodies that are pressed together in a plane.
pub(super) struct Pressing<'a> {
    pub pair: &'a Pair,
    pub pose: &'a Pose,
    /// E*, in Pa.
    pub contact_modulus: f64,
    /// Combined Poisson's ratio, dimensionless.
    pub poisson_ratio: f64,
    pub method: NormalMethod,
    pub watch: Watch<'a>,
}

impl Pressing<'_> {
    /// The contact in a plane in which the surfaces have been moved apart already; `None` where the
    /// bodies do not touch.
    pub fn solve(
        &self,
        plane: &ContactPlane,
        raised: Raised,
        accuracy: Accuracy,
    ) -> Result<Option<Pressed>, Error> {
        let view = PlaneView::new(self.pair, self.pose, plane);
        if !matches!(self.method, NormalMethod::HalfSpaces | NormalMethod::Conformal) {
            let cells = match accuracy {
                Accuracy::Coarse => COARSE,
                Accuracy::Cells(cells) => cells,
            };
            let bodies = (raised.everywhere, self.contact_modulus);
            let pressed = virtual_penetration::pressed(&view, plane, bodies, (self.method, cells));
            return pressed.map_err(|s| self.at_end(&view, plane, s));
        }
        let Some(rectangle) = overlap(&view, plane, raised.everywhere)? else { return Ok(None) };
        let coarse = self.press(&view, plane, (rectangle, raised), [COARSE; 2])?;
        let Some(coarse) = coarse else { return Ok(None) };
        let Accuracy::Cells(cells) = accuracy else { return Ok(Some(coarse.0)) };
        let touched = touched(&coarse.0, rectangle);
        let spacing = touched.map(|side| (side[1] - side[0]) / cells as f64);
        let coarse_cell = rectangle.map(|side| (side[1] - side[0]) / COARSE as f64);
        let rectangle = [0, 1].map(|k| {
            let rim = (RIM * spacing[k]).max(coarse_cell[k]);
            [touched[k][0] - rim, touched[k][1] + rim]
        });
        let counts =
            [0, 1].map(|k| ((rectangle[k][1] - rectangle[k][0]) / spacing[k]).round() as usize);
        let Some((pressed, beyond)) = self.press(&view, plane, (rectangle, raised), counts)? else {
            return Ok(None);
        };
        self.refuse_end(&view, &pressed, &beyond)?;
        Ok(Some(pressed))
    }

    /// The contact on a lattice, and which cells of it are beyond the end of a profile.
    fn press(
        &self,
        view: &PlaneView,
        plane: &ContactPlane,
        (rectangle, raised): (Rectangle, Raised),
        [columns, rows]: [usize; 2],
    ) -> Result<Option<(Pressed, Vec<bool>)>, Error> {
        let [x, s] = [positions(rectangle[0], columns), positions(rectangle[1], rows)];
        let Heights { mut distance, is_beyond } = view.heights(&x, &s);
        set_apart(plane, [&x, &s], &mut distance);
        let opening = raised.opening.map_or_else(Vec::new, |opening| opening.sample(&x, &s));
        for distance in &mut distance {
            *distance += raised.everywhere;
        }
        let least = |distance: &[f64]| distance.iter().copied().fold(f64::INFINITY, f64::min);
        let undeformed = least(&distance);
        for (distance, opening) in distance.iter_mut().zip(&opening) {
            *distance += opening;
        }
        let opened = least(&distance) - undeformed;
        if !distance.iter().any(|d| *d < 0.0) {
            return Ok(None);
        }
        let lattice = Lattice {
            columns,
            rows,
            spacing_x: (rectangle[0][1] - rectangle[0][0]) / columns as f64,
            spacing_y: (rectangle[1][1] - rectangle[1][0]) / rows as f64,
        };
        let curvature = if plane.is_curved { self.curvature(plane, &s, &distance) } else { 0.0 };
        let curved = Curved { curvature, poisson_ratio: self.poisson_ratio };
        let map = HeightMap::new(lattice, distance)?;
        let mut contact = RoughContact::new(map, self.contact_modulus, Boundary::Free)?;
        if plane.is_curved {
            contact = contact.curved(curved);
        }
        let options = if columns.max(rows) > COARSE { &FINELY } else { &COARSELY };
        let solution = contact.solve_at_level(0.0, options, self.watch)?;
        require_convergence(&solution, options)?;
        let RoughContactSolution { pressure, load, approach, .. } = solution;
        let approach = approach + opened;
        let (plane, force) = self.directed(plane, &s, (&pressure, load));
        let pressed = Pressed { plane, x, s, pressure, opening, force, load, curvature, approach };
        Ok(Some((pressed, is_beyond)))
    }

    /// Curvature of the rail (in 1/m) where the bodies overlap: of the parabola through its
    /// profile's directions, as many times as they overlap.
    fn curvature(&self, plane: &ContactPlane, s: &[f64], distance: &[f64]) -> f64 {
        let overlap = |row: &[f64]| -> f64 { row.iter().map(|d| (-d).max(0.0)).sum() };
        let weights = distance.chunks_exact(distance.len() / s.len()).map(overlap);
        let rows: Vec<[f64; 3]> =
            weights.zip(s).map(|(weight, s)| [weight, *s, plane.turn(self.pair, *s)]).collect();
        let sum =
            |of: &dyn Fn(&[f64; 3]) -> f64| rows.iter().map(|row| row[0] * of(row)).sum::<f64>();
        let weight = sum(&|_| 1.0);
        let [middle, turn] = [sum(&|row| row[1]), sum(&|row| row[2])].map(|sum| sum / weight);
        let square = sum(&|row| (row[1] - middle).powi(2));
        let slope = -sum(&|row| (row[1] - middle) * (row[2] - turn)) / square;
        if slope.is_finite() { slope } else { 0.0 }
    }

    /// The plane with the direction of the force of a pressure whose integral is a load, in N, and
    /// that force, in N.
    fn directed(
        &self,
        plane: &ContactPlane,
        s: &[f64],
        (pressure, load): (&[f64], f64),
    ) -> (ContactPlane, f64) {
        if !plane.is_curved || load <= 0.0 {
            return (*plane, load);
        }
        let rows = pressure.chunks_exact(pressure.len() / s.len()).zip(s);
        let mut parts = [0.0; 2];
        let mut total = 0.0;
        for (row, s) in rows {
            let (sum, (sin, cos)) = (row.iter().sum::<f64>(), plane.turn(self.pair, *s).sin_cos());
            total += sum;
            parts = [parts[0] + sum * sin, parts[1] + sum * cos];
        }
        let turn = parts[0].atan2(parts[1]);
        let inclination = plane.inclination + turn;
        (ContactPlane { inclination, ..*plane }, load * parts[0].hypot(parts[1]) / total)
    }

    /// Refuses a contact next to the end of a profile.
    fn refuse_end(
        &self,
        view: &PlaneView,
        pressed: &Pressed,
        beyond: &[bool],
    ) -> Result<(), Error> {
        let (columns, rows) = (pressed.x.len(), pressed.s.len());
        let end_near = |k: usize| {
            let (i, j) = (k % columns, k / columns);
            let near_columns = i.saturating_sub(1)..(i + 2).min(columns);
            let mut near_rows = j.saturating_sub(1)..(j + 2).min(rows);
            near_rows.find(|j| near_columns.clone().any(|i| beyond[j * columns + i]))
        };
        let mut touching = (0..beyond.len()).filter(|k| pressed.pressure[*k] > 0.0);
        let Some(row) = touching.find_map(end_near) else { return Ok(()) };
        Err(self.at_end(view, &pressed.plane, pressed.s[row]))
    }

    /// An error for a profile that ends at s, in m.
    fn at_end(&self, view: &PlaneView, plane: &ContactPlane, s: f64) -> Error {
        let arcs = plane.arcs.map(|arc| arc + s);
        let is_rail = view.rail_point(s, arcs[0]).is_none();
        self.pair.at_end(is_rail, arcs, plane.origin[1])
    }
}

fn require_convergence(
    solution: &RoughContactSolution,
    options: &RoughContactOptions,
) -> Result<(), Error> {
    if solution.is_converged {
        return Ok(());
    }
    Err(Error::NormalNotConverged {
        quantity: Quantity::UndeformedDistance,
        iterations: solution.iterations,
        residual: solution.residual,
        tolerance: options.tolerance,
    })
}

/// Where another plane begins, this one has no contact.
fn set_apart(plane: &ContactPlane, [x, s]: [&[f64]; 2], distance: &mut [f64]) {
    let is_beyond = |place: f64, [low, high]: [f64; 2]| place < low || place > high;
    for (s, row) in s.iter().zip(distance.chunks_mut(x.len())) {
        let is_row = is_beyond(*s, plane.limits[1]);
        for (x, distance) in x.iter().zip(row) {
            if is_row || is_beyond(*x, plane.limits[0]) {
                *distance = CLEAR;
            }
        }
    }
}

/// The bounding rectangle of the overlap, with a rim; `None` where there is none.
fn overlap(
    view: &PlaneView,
    plane: &ContactPlane,
    raised: f64,
) -> Result<Option<Rectangle>, Error> {
    let mut rectangle = plane.guess.map(|side| {
        let more = 0.25 * (side[1] - side[0]) + 1e-4;
        [side[0] - more, side[1] + more]
    });
    for _ in 0..MOST_ROUNDS {
        let [x, s] = rectangle.map(|side| positions(side, COARSE));
        let mut distance = view.heights(&x, &s).distance;
        set_apart(plane, [&x, &s], &mut distance);
        let is_hit = |k: usize| distance[k] + raised < 0.0;
        let columns = hit(|i| (0..COARSE).any(|j| is_hit(j * COARSE + i)));
        let rows = hit(|j| (0..COARSE).any(|i| is_hit(j * COARSE + i)));
        let (Some(columns), Some(rows)) = (columns, rows) else {
            let Some(nearer) = nearer(&distance, raised, rectangle) else { return Ok(None) };
            rectangle = nearer;
            continue;
        };
        let mut is_found = true;
        let mut next = rectangle;
        for (k, [first, last]) in [columns, rows].into_iter().enumerate() {
            let [from, to] = rectangle[k];
            let (length, cell) = (to - from, (to - from) / COARSE as f64);
            let share = (last + 1 - first) as f64 / COARSE as f64;
            next[k] = [from + (first as f64 - 1.0) * cell, from + (last as f64 + 2.0) * cell];
            if first == 0 {
                next[k][0] = from - 0.5 * length;
            }
            if last + 1 == COARSE {
                next[k][1] = to + 0.5 * length;
            }
            is_found &= first > 0 && last + 1 < COARSE && share >= TIGHT;
        }
        if is_found {
            return Ok(Some(next));
        }
        rectangle = next;
    }
    let [x, y] = rectangle;
    Err(Error::ContactNotFound { rounds: MOST_ROUNDS, x, y })
}

/// The rectangle around the least of the distances on the lattice, if between it and its neighbours
/// there may be an overlap: with as much more overlap as a parabola has there.
fn nearer(distance: &[f64], raised: f64, rectangle: Rectangle) -> Option<Rectangle> {
    let least = (0..distance.len()).min_by(|j, k| distance[*j].total_cmp(&distance[*k]))?;
    let at = [least % COARSE, least / COARSE];
    let [columns, rows] = at.map(|k| k.saturating_sub(1)..(k + 2).min(COARSE));
    let beside = rows.flat_map(|j| columns.clone().map(move |i| distance[j * COARSE + i]));
    let highest = beside.filter(|d| *d < CLEAR).fold(f64::NEG_INFINITY, f64::max);
    let side = |k: usize| {
        let [from, to] = rectangle[k];
        let cell = (to - from) / COARSE as f64;
        [from + (at[k] as f64 - 1.0) * cell, from + (at[k] as f64 + 2.0) * cell]
    };
    let may_overlap = distance[least] + raised < 0.25 * (highest - distance[least]);
    may_overlap.then(|| [side(0), side(1)])
}

/// First and last line that is hit.
fn hit(is_hit: impl Fn(usize) -> bool) -> Option<[usize; 2]> {
    let first = (0..COARSE).find(|k| is_hit(*k))?;
    let last = (0..COARSE).rfind(|k| is_hit(*k))?;
    Some([first, last])
}

/// The rectangle of the cells in contact.
fn touched(pressed: &Pressed, rectangle: Rectangle) -> Rectangle {
    let columns = pressed.x.len();
    let is_contact = |i: usize, j: usize| pressed.pressure[j * columns + i] > 0.0;
    let rows = pressed.s.len();
    let column = hit(|i| i < columns && (0..rows).any(|j| is_contact(i, j)));
    let row = hit(|j| j < rows && (0..columns).any(|i| is_contact(i, j)));
    let side = |side: [f64; 2], found: Option<[usize; 2]>| {
        let Some([first, last]) = found else { return side };
        let cell = (side[1] - side[0]) / COARSE as f64;
        [side[0] + first as f64 * cell, side[0] + (last + 1) as f64 * cell]
    };
    [side(rectangle[0], column), side(rectangle[1], row)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::{Material, contact_modulus};
    use crate::numerics::root::bisection;

    /// Largest pressure (in Pa) and approach (in m) of a ball of 10 mm in a groove under a vertical
    /// force (in N), and the angle by which its surface turns over the contact; half-spaces are
    /// bent with a multiple of its curvature.
    fn ball_in_groove(radius: f64, load: f64, factor: f64) -> [f64; 3] {
        let (count, ball, rolling) = (64, 10e-3, 0.42);
        let (half_x, half_s) = (9e-3, 0.9 * radius);
        let lattice = Lattice {
            columns: count,
            rows: count,
            spacing_x: 2.0 * half_x / count as f64,
            spacing_y: 2.0 * half_s / count as f64,
        };
        let [x, s] = [half_x, half_s].map(|half| positions([-half, half], count));
        let modulus = contact_modulus(&Material::STEEL, &Material::STEEL);
        let curved = Curved { curvature: -factor / radius, poisson_ratio: 0.28 };
        let pressed = |approach: f64| {
            let row = |s: &f64| {
                let (angle, x) = (s / radius, x.clone());
                let gap = (radius - ball) * (1.0 - angle.cos()) - approach * angle.cos();
                x.into_iter().map(move |x| gap + 0.5 * x * x * angle.cos() / rolling)
            };
            let map = HeightMap::new(lattice, s.iter().flat_map(row).collect()).unwrap();
            let contact = RoughContact::new(map, modulus, Boundary::Free).unwrap();
            contact.curved(curved).solve_at_level(0.0, &FINELY, &crate::unwatched).unwrap()
        };
        let vertical = |pressure: &[f64]| {
            let rows = pressure.chunks(count).zip(&s);
            let parts = rows.map(|(row, s)| row.iter().sum::<f64>() * (s / radius).cos());
            parts.sum::<f64>() * lattice.spacing_x * lattice.spacing_y
        };
        let is_below = |approach: f64| vertical(&pressed(approach).pressure) < load;
        let [approach, _] = bisection([5e-6, 100e-6], 20, is_below);
        let pressure = pressed(approach).pressure;
        let is_loaded = |j: &usize| pressure[j * count..(j + 1) * count].iter().any(|p| *p > 0.0);
        let rows = (0..count).filter(is_loaded).count();
        let peak = pressure.iter().copied().fold(0.0, f64::max);
        [peak, approach, rows as f64 * lattice.spacing_y / radius]
    }

    /// What a curvature that is a fifth too large or too small over the contact changes, for each
    /// radian by which the surface turns away: up to 8 % of the largest pressure and 17 % of the
    /// approach, as [`crate::Warning::UnevenCurvature`] says.
    #[test]
    fn wrong_curvatures_change_pressure_and_approach_by_so_much_for_a_radian() {
        let mut largest = [0.0_f64; 2];
        for (radius, load) in [(10.25e-3, 10e3), (10.02e-3, 10e3), (10.1e-3, 50e3)] {
            let right = ball_in_groove(radius, load, 1.0);
            for factor in [0.8, 1.2] {
                let wrong = ball_in_groove(radius, load, factor);
                let angle = 0.2 * 0.5 * right[2];
                for k in 0..2 {
                    largest[k] = largest[k].max((wrong[k] / right[k] - 1.0).abs() / angle);
                }
            }
        }
        assert!((0.06..=0.17).contains(&largest[0]), "{largest:?}");
        assert!((0.13..=0.17).contains(&largest[1]), "{largest:?}");
    }
}
