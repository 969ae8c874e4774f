//! Approximate normal contact from the overlap of the undeformed bodies, without solving for the
//! pressure.
//!
//! The patch is the part of the plane in which the bodies overlap by more than a share 1 − ε of the
//! approach δ (virtual penetration), and the pressure is that of a semi-ellipse in every row,
//!
//! p(x, s) = c √(l(s)² − (x − x₀(s))²),  l(s)² = (ε δ − g(s))/A(s),
//!
//! with the distance g of the row and its curvature A along rolling, g + A (x − x₀)². The bodies
//! approach each other by δ at the point of least distance, which gives c (Boussinesq 1885):
//!
//! δ = 1/(π E*) ∬ p/ρ dx ds = 2c/(π E*) ∫ l √(1 + η²) (K(m) − E(m)) ds,
//! η = |s|/l, m = 1/(1 + η²).
//!
//! Sources: J. Piotrowski and W. Kik, A simplified model of wheel/rail contact mechanics for
//! non-Hertzian problems and its application in rail vehicle dynamic simulations, Vehicle System
//! Dynamics 46 (2008), with ε = 0.55; E. A. H. Vollebregt, User guide for CONTACT, for the idea of
//! an ε that makes an ellipse that of Hertz. Here ε follows from Hertz's theory for each side of
//! the patch: with the curvature B of the distance up to the edge, it is B b²/δ across and A a²/δ
//! along rolling. Limits: one coefficient c for a patch of several parts.

use std::f64::consts::PI;

use super::contact_plane::ContactPlane;
use super::distance::{CLEAR, PlaneView};
use super::pressed::{Pressed, positions};
use crate::normal::{approach_shares, row_potential};
use crate::numerics::root::bisection;

/// How the normal contact in a plane is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NormalMethod {
    /// As that of two half-spaces.
    #[default]
    HalfSpaces,
    /// By virtual penetration, ε = 0.55 (Piotrowski and Kik 2008).
    KikPiotrowski,
    /// By virtual penetration with ε from Hertz's theory.
    EllipseCorrected,
    /// As Hertz's ellipse with the curvatures of the distance.
    EquivalentEllipse,
}

/// ε of Piotrowski and Kik (2008).
const SHARE: f64 = 0.55;

/// Rows in which the distance is found; linear in between.
const ROWS: usize = 96;

/// Points of the quadrature on each side of the middle.
const POINTS: usize = 64;

/// Halvings of the step between two rows in which the edge lies.
const HALVINGS: u32 = 30;

/// Cells beside the patch.
const RIM: usize = 2;

/// The distance in a row of the plane, least + A (x − x₀)².
#[derive(Debug, Clone, Copy)]
struct Row {
    /// In m.
    least: f64,
    /// x₀, in m.
    x: f64,
    /// A, in 1/m.
    curvature: f64,
}

/// The distance over a plane, in rows at equal steps.
struct Rows {
    s: Vec<f64>,
    rows: Vec<Row>,
}

impl Row {
    /// From the distances at x − d, x and x + d, all in m; `None` beyond the end of a profile.
    fn through([before, at, after]: [f64; 3], x: f64, d: f64) -> Option<Self> {
        let curvature = (before - 2.0 * at + after) / (2.0 * d * d);
        let slope = (after - before) / (2.0 * d);
        let row = Self {
            least: at - slope * slope / (4.0 * curvature),
            x: x - slope / (2.0 * curvature),
            curvature,
        };
        (curvature > 0.0 && before.max(at).max(after) < CLEAR).then_some(row)
    }

    fn between(one: &Self, two: &Self, part: f64) -> Self {
        let mean = |value: fn(&Self) -> f64| value(one) + part * (value(two) - value(one));
        Self {
            least: mean(|row| row.least),
            x: mean(|row| row.x),
            curvature: mean(|row| row.curvature),
        }
    }
}

impl Rows {
    /// Those over the overlap; `None` where there are fewer than three.
    fn new(view: &PlaneView, plane: &ContactPlane) -> Option<Self> {
        let [[from, to], across] = plane.guess;
        let (x, d) = (0.5 * (from + to), 0.25 * (to - from));
        let [low, high] = [across[0].max(plane.limits[1][0]), across[1].min(plane.limits[1][1])];
        let at = |k: usize| low + (high - low) * k as f64 / (ROWS - 1) as f64;
        let s: Vec<f64> = (0..ROWS).map(at).collect();
        let heights = view.heights(&[x - d, x, x + d], &s).distance;
        let rows = heights.chunks_exact(3).map(|row| Row::through([row[0], row[1], row[2]], x, d));
        let (s, rows): (Vec<_>, Vec<_>) =
            s.into_iter().zip(rows).filter_map(|(s, row)| Some((s, row?))).unzip();
        (s.len() >= 3).then_some(Self { s, rows })
    }

    fn at(&self, s: f64) -> Row {
        let next = self.s.partition_point(|at| *at < s).clamp(1, self.s.len() - 1);
        let part = (s - self.s[next - 1]) / (self.s[next] - self.s[next - 1]);
        Row::between(&self.rows[next - 1], &self.rows[next], part.clamp(0.0, 1.0))
    }

    /// The same with the surfaces moved apart, in m.
    fn raised(mut self, raised: f64) -> Self {
        for row in &mut self.rows {
            row.least += raised;
        }
        self
    }

    /// The first place below or above a middle that is no longer inside, in m.
    fn edge(&self, middle: f64, is_above: bool, is_inside: impl Fn(f64) -> bool) -> Option<f64> {
        let places: Vec<f64> = if is_above {
            self.s.iter().copied().filter(|s| *s > middle).collect()
        } else {
            self.s.iter().rev().copied().filter(|s| *s < middle).collect()
        };
        let outside = places.iter().position(|s| !is_inside(*s))?;
        let inside = if outside == 0 { middle } else { places[outside - 1] };
        let [edge, _] = bisection([inside, places[outside]], HALVINGS, is_inside);
        Some(edge)
    }

    /// Where the distance is least, through three rows, and how large it is there; both in m.
    fn least(&self) -> [f64; 2] {
        let least = |k: &usize| self.rows[*k].least;
        let found = (0..self.s.len()).min_by(|j, k| least(j).total_cmp(&least(k)));
        let middle = found.unwrap_or(0).clamp(1, self.s.len() - 2);
        let three = [middle - 1, middle, middle + 1].map(|k| least(&k));
        match Row::through(three, self.s[middle], self.s[middle + 1] - self.s[middle]) {
            Some(row) if (row.x - self.s[middle]).abs() <= self.s[middle + 1] - self.s[middle] => {
                [row.x, row.least]
            }
            _ => [self.s[found.unwrap_or(0)], least(&found.unwrap_or(0))],
        }
    }
}

/// A patch of rows.
struct Patch<'a> {
    rows: &'a Rows,
    /// Where the bodies approach each other by δ, in m.
    middle: f64,
    /// δ, in m.
    approach: f64,
    /// ε δ along rolling, in m.
    along: f64,
    /// ε δ across, below and above the middle; in m.
    across: [f64; 2],
    /// Edges, in m.
    edges: [f64; 2],
    /// Whether its edge is an ellipse.
    is_ellipse: bool,
}

impl<'a> Patch<'a> {
    /// The patch under an approach (in m) about a middle (in m); the end of
    /// the rows (in m) that lies inside, if one does.
    fn new(
        rows: &'a Rows,
        [middle, approach]: [f64; 2],
        method: NormalMethod,
    ) -> Result<Self, f64> {
        let curvature = rows.at(middle).curvature;
        let shares = |s: f64| {
            if method == NormalMethod::KikPiotrowski {
                return [SHARE; 2];
            }
            let across = (rows.at(s).least + approach).max(0.0) / (s - middle).powi(2);
            approach_shares(curvature / across)
        };
        let mut edges = [middle; 2];
        for (side, edge) in edges.iter_mut().enumerate() {
            let is_inside = |s: f64| rows.at(s).least + approach < shares(s)[1] * approach;
            let end = if side == 0 { rows.s.first() } else { rows.s.last() };
            *edge = rows.edge(middle, side == 1, is_inside).ok_or(*end.unwrap_or(&middle))?;
        }
        let [low, high] = edges.map(shares);
        let mut patch = Self {
            rows,
            middle,
            approach,
            along: 0.5 * (low[0] + high[0]) * approach,
            across: [low[1] * approach, high[1] * approach],
            edges,
            is_ellipse: method == NormalMethod::EquivalentEllipse,
        };
        if patch.is_ellipse {
            patch.middle = 0.5 * (edges[0] + edges[1]);
        }
        Ok(patch)
    }

    /// Middle (in m) and half length squared (in m²) of a row; negative outside.
    fn row(&self, s: f64) -> [f64; 2] {
        if self.is_ellipse {
            let Row { x, curvature, .. } = self.rows.at(self.middle);
            let part = (s - self.middle) / (self.edges[1] - self.middle);
            return [x, self.along / curvature * (1.0 - part * part)];
        }
        let Row { x, curvature, least } = self.rows.at(s);
        let across = self.across[usize::from(s > self.middle)];
        [x, self.along / curvature * (1.0 - (least + self.approach) / across)]
    }

    /// c of the pressure c √(l² − (x − x₀)²), in Pa/m.
    fn level(&self, contact_modulus: f64) -> f64 {
        let side = |edge: f64| {
            let point = |k: usize| {
                // Dense at the middle, where the potential of a row is singular.
                let t = (k as f64 + 0.5) / POINTS as f64;
                let away = (edge - self.middle) * t * t;
                let [_, square] = self.row(self.middle + away);
                let width = 2.0 * t * (edge - self.middle).abs() / POINTS as f64;
                if square <= 0.0 {
                    return 0.0;
                }
                let half = square.sqrt();
                half * row_potential(away.abs() / half) * width
            };
            (0..POINTS).map(point).sum::<f64>()
        };
        let sides: f64 = self.edges.map(side).iter().sum();
        PI * contact_modulus * self.approach / (2.0 * sides)
    }

    /// On a lattice with so many cells across it each way.
    fn pressed(&self, plane: &ContactPlane, contact_modulus: f64, cells: usize) -> Pressed {
        let [low, high] = self.edges;
        let count = cells + 2 * RIM;
        let around = |from: f64, to: f64| {
            let rim = RIM as f64 * (to - from) / cells as f64;
            positions([from - rim, to + rim], count)
        };
        let s = around(low, high);
        let rows: Vec<[f64; 2]> = s.iter().map(|s| self.row(*s)).collect();
        let ends = rows.iter().filter(|[_, square]| *square > 0.0);
        let ends = ends.map(|[x, square]| [x - square.sqrt(), x + square.sqrt()]);
        let [from, to] = ends
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
                [low.min(from), high.max(to)]
            });
        let x = around(from, to);
        let level = self.level(contact_modulus);
        let cell = |[middle, square]: &[f64; 2], x: f64| {
            level * (square - (x - middle).powi(2)).max(0.0).sqrt()
        };
        let pressure = rows.iter().flat_map(|row| x.iter().map(|x| cell(row, *x))).collect();
        let step = (high - low) / cells as f64;
        let areas = rows.iter().map(|[_, square]| 0.5 * PI * square.max(0.0));
        let force = level * step * areas.sum::<f64>();
        Pressed { plane: *plane, x, s, pressure, force, approach: self.approach }
    }
}

/// The contact in a plane in which other contacts have moved the surfaces apart by `raised` (in m),
/// with so many cells across it each way: `None` where the bodies do not touch.
///
/// # Errors
/// The place s (in m) at which a profile ends in the contact.
pub(super) fn pressed(
    view: &PlaneView,
    plane: &ContactPlane,
    (raised, contact_modulus): (f64, f64),
    (method, cells): (NormalMethod, usize),
) -> Result<Option<Pressed>, f64> {
    let Some(rows) = Rows::new(view, plane) else { return Ok(None) };
    let [middle, least] = rows.least();
    let approach = -least - raised;
    if approach <= 0.0 {
        return Ok(None);
    }
    let rows = rows.raised(raised);
    let patch = Patch::new(&rows, [middle, approach], method)?;
    Ok(Some(patch.pressed(plane, contact_modulus, cells)))
}
