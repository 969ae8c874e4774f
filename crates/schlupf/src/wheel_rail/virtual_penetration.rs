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
//! along rolling.
//!
//! ANALYN (M. Sh. Sichani, R. Enblom and M. Berg, A novel method to model wheel–rail normal contact
//! in vehicle dynamics simulation, Vehicle System Dynamics 52 (2014)) takes every row as the middle
//! row of Hertz's ellipse with the curvatures A(s) and B(s) there. With its shares ε_x = A a²/δ and
//! ε_y = B b²/δ,
//!
//! l(s)² = ε_x (δ − g(s)/ε_y)/A(s),
//!
//! and the largest pressure is that of this ellipse at the approach δ − g/ε_y.
//!
//! A plane has a part for each place of least distance outside of the parts of deeper ones; each
//! part of force F moves the surfaces of the others apart by F/(π E* r), as contacts in planes of
//! their own do. Limits: a part ends where a deeper one begins; with l from x₀(s) the distance from
//! the middle of a row stands for |s| in η where x₀ varies, which is right far away only.

use std::f64::consts::PI;

use super::contact_plane::ContactPlane;
use super::distance::{CLEAR, PlaneView};
use super::pressed::{Pressed, positions};
use crate::normal::{approach_shares, row_potential, shares_and_pressure};
use crate::numerics::root::bisection;

/// How the normal contact in a plane is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NormalMethod {
    /// As that of two half-spaces.
    #[default]
    HalfSpaces,
    /// As that of two half-spaces that are bent along the surface of the rail.
    Conformal,
    /// By virtual penetration, ε = 0.55 (Piotrowski and Kik 2008).
    KikPiotrowski,
    /// By virtual penetration with ε from Hertz's theory.
    EllipseCorrected,
    /// As Hertz's ellipse with the curvatures of the distance.
    EquivalentEllipse,
    /// Row by row as in Hertz's ellipse with the curvatures there (ANALYN, Sichani et al. 2014).
    Analyn,
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

/// Passes in which parts move each other's surfaces apart.
const PASSES: usize = 4;

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
    lines: Vec<Row>,
    /// Of ANALYN: shares of the ellipse of each row, and c/E* in 1/m.
    ellipses: Vec<[f64; 3]>,
    /// Whether a profile ends at the first and at the last row.
    ends: [bool; 2],
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
    /// Those over the overlap of surfaces that are `raised` apart (in m); `None` where there are
    /// fewer than three.
    fn new(
        view: &PlaneView,
        plane: &ContactPlane,
        (raised, method): (f64, NormalMethod),
    ) -> Option<Self> {
        let [[from, to], across] = plane.guess;
        let (x, d) = (0.5 * (from + to), 0.25 * (to - from));
        let [low, high] = [across[0].max(plane.limits[1][0]), across[1].min(plane.limits[1][1])];
        let s = positions([low, high], ROWS);
        let heights = view.heights(&[x - d, x, x + d], &s).distance;
        let row = |row: &[f64]| Row::through([row[0], row[1], row[2]].map(|h| h + raised), x, d);
        let rows: Vec<Option<Row>> = heights.chunks_exact(3).map(row).collect();
        let is_missing = |row: Option<&Option<Row>>| matches!(row, Some(None));
        let ends = [is_missing(rows.first()), is_missing(rows.last())];
        let found = s.into_iter().zip(rows).filter_map(|(s, row)| Some((s, row?)));
        let (s, rows): (Vec<_>, Vec<_>) = found.unzip();
        let is_local = s.len() >= 3 && method == NormalMethod::Analyn;
        let ellipses = if is_local { ellipses(&s, &rows) } else { Vec::new() };
        (s.len() >= 3).then_some(Self { s, lines: rows, ellipses, ends })
    }

    /// The first and the last row, in m.
    fn span(&self) -> [f64; 2] {
        [self.s[0], self.s[self.s.len() - 1]]
    }

    /// The row after a place (in m), and how far the place is on the way to it, dimensionless.
    fn before(&self, s: f64) -> (usize, f64) {
        let next = self.s.partition_point(|at| *at < s).clamp(1, self.s.len() - 1);
        let part = (s - self.s[next - 1]) / (self.s[next] - self.s[next - 1]);
        (next, part.clamp(0.0, 1.0))
    }

    fn at(&self, s: f64) -> Row {
        let (next, part) = self.before(s);
        Row::between(&self.lines[next - 1], &self.lines[next], part)
    }

    /// Of ANALYN.
    fn ellipse_at(&self, s: f64) -> Option<[f64; 3]> {
        let (next, part) = self.before(s);
        let [one, two] = [self.ellipses.get(next - 1)?, self.ellipses.get(next)?];
        Some([0, 1, 2].map(|k| one[k] + part * (two[k] - one[k])))
    }

    /// The first place from a middle towards a bound (in m) that is no longer inside, if one is.
    fn edge(&self, middle: f64, bound: f64, is_inside: impl Fn(f64) -> bool) -> Option<f64> {
        let is_between = |s: &f64| (s - middle) * (bound - s) >= 0.0 && *s != middle;
        let mut places: Vec<f64> = self.s.iter().copied().filter(is_between).collect();
        if bound < middle {
            places.reverse();
        }
        let outside = places.iter().position(|s| !is_inside(*s))?;
        let inside = if outside == 0 { middle } else { places[outside - 1] };
        let [edge, _] = bisection([inside, places[outside]], HALVINGS, is_inside);
        Some(edge)
    }

    /// Places at which the distance is least (in m) and the surfaces overlap, the deepest first,
    /// each with its depth, in m.
    fn deepest(&self) -> Vec<[f64; 2]> {
        let least = |k: usize| self.lines[k].least;
        let last = self.s.len() - 1;
        // At a bound that is no end the other plane has the contact.
        let below = |k: usize, beside: Option<usize>, is_end: bool| match beside {
            Some(beside) => least(k) <= least(beside),
            None => is_end,
        };
        let is_least = |k: &usize| {
            let after = (*k < last).then_some(k + 1);
            least(*k) < 0.0
                && below(*k, k.checked_sub(1), self.ends[0])
                && below(*k, after, self.ends[1])
        };
        let mut found: Vec<[f64; 2]> =
            (0..=last).filter(is_least).map(|k| self.through(k)).collect();
        found.sort_unstable_by(|one, two| two[1].total_cmp(&one[1]));
        found
    }

    /// Place (in m) and depth (in m) of the least distance next to a row, through three rows.
    fn through(&self, k: usize) -> [f64; 2] {
        let own = [self.s[k], -self.lines[k].least];
        let vertex = step(&self.s, k).and_then(|step| {
            let three = [k - 1, k, k + 1].map(|k| self.lines[k].least);
            Row::through(three, self.s[k], step)
        });
        vertex.map_or(own, |vertex| [vertex.x, -vertex.least])
    }
}

/// The step from a row to both of its neighbours, in m; `None` where rows between them are missing,
/// and at the ends.
fn step(s: &[f64], k: usize) -> Option<f64> {
    let [before, after] = [s[k] - s.get(k.checked_sub(1)?)?, s.get(k + 1)? - s[k]];
    (before < 1.5 * after && after < 1.5 * before).then_some(after)
}

/// Of rows (at s in m) the shares of their ellipses and c/E* (in 1/m), with the curvature across
/// through three rows, else those of the nearest row that has neighbours on both sides; where the
/// curvature is not positive, those of a line.
fn ellipses(s: &[f64], rows: &[Row]) -> Vec<[f64; 3]> {
    let last = rows.len() - 1;
    let local = |k: usize| {
        let mut nearby = (0..rows.len()).flat_map(|d| [k.saturating_sub(d), (k + d).min(last)]);
        let found = nearby.find_map(|k| Some((k, step(s, k)?)));
        let across = found.and_then(|(k, step)| {
            Row::through([k - 1, k, k + 1].map(|k| rows[k].least), s[k], step)
        });
        let across = across.map_or(0.0, |row| row.curvature);
        let along = rows[found.map_or(k, |(k, _)| k)].curvature;
        let ([x, y], pressure) = shares_and_pressure(along / across);
        [x, y, along * pressure]
    };
    (0..rows.len()).map(local).collect()
}

/// A part of a patch.
struct Part<'a> {
    rows: &'a Rows,
    /// Where the bodies approach each other by δ: of an ellipse its middle, otherwise the place of
    /// least distance; in m.
    middle: f64,
    /// How far the undeformed surfaces overlap there, in m.
    depth: f64,
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
    /// c (in Pa/m), of ANALYN over that of [`Self::local`].
    level: f64,
    /// In N.
    force: f64,
}

/// What a part is found with.
struct Bodies {
    method: NormalMethod,
    /// E*, in Pa.
    contact_modulus: f64,
}

impl Bodies {
    /// The part about a place of least distance and its depth (in m), between bounds (in m), whose
    /// surfaces others have moved apart by `raised` (in m).
    ///
    /// # Errors
    /// The end of the rows (in m) that lies inside.
    fn part<'a>(
        &self,
        rows: &'a Rows,
        ([middle, depth], raised): ([f64; 2], f64),
        bounds: [f64; 2],
    ) -> Result<Part<'a>, f64> {
        let approach = depth - raised;
        let curvature = rows.at(middle).curvature;
        let grown = |s: f64| rows.at(s).least + depth;
        let shares = |s: f64| {
            if let Some([x, y, _]) = rows.ellipse_at(s) {
                return [x, y];
            }
            if self.method == NormalMethod::KikPiotrowski {
                return [SHARE; 2];
            }
            approach_shares(curvature * (s - middle).powi(2) / grown(s).max(0.0))
        };
        let mut edges = bounds;
        for (side, edge) in edges.iter_mut().enumerate() {
            let found = rows.edge(middle, *edge, |s| grown(s) < shares(s)[1] * approach);
            if found.is_none() && rows.ends[side] && *edge == rows.span()[side] {
                return Err(*edge);
            }
            *edge = found.unwrap_or(*edge);
        }
        let [low, high] = edges.map(shares);
        let is_ellipse = self.method == NormalMethod::EquivalentEllipse;
        let mut part = Part {
            rows,
            middle: if is_ellipse { 0.5 * (edges[0] + edges[1]) } else { middle },
            depth,
            approach,
            along: 0.5 * (low[0] + high[0]) * approach,
            across: [low[1] * approach, high[1] * approach],
            edges,
            is_ellipse,
            level: 0.0,
            force: 0.0,
        };
        let [potential, area] = part.integrals();
        part.level = if rows.ellipses.is_empty() {
            PI * self.contact_modulus * approach / (2.0 * potential)
        } else {
            self.contact_modulus
        };
        part.force = part.level * 0.5 * PI * area;
        Ok(part)
    }

    /// The parts of a plane, the deepest first, apart from those that others lift off.
    fn parts<'a>(&self, rows: &'a Rows) -> Result<Vec<Part<'a>>, f64> {
        let mut parts: Vec<Part> = Vec::new();
        for _ in 0..PASSES {
            let before = std::mem::take(&mut parts);
            for place in rows.deepest() {
                let [middle, depth] = place;
                if parts.iter().any(|part| part.covers(middle)) {
                    continue;
                }
                let raised = self.raised(middle, &before);
                if depth <= raised {
                    continue;
                }
                let mut bounds = rows.span();
                for part in &parts {
                    let side = usize::from(part.middle > middle);
                    let nearer = [f64::max, f64::min][side];
                    bounds[side] = nearer(bounds[side], part.edges[1 - side]);
                }
                parts.push(self.part(rows, (place, raised), bounds)?);
            }
            if parts.len().max(before.len()) < 2 {
                break;
            }
        }
        Ok(parts)
    }

    /// How far other parts move the surfaces at a place apart, in m.
    fn raised(&self, middle: f64, parts: &[Part]) -> f64 {
        let others = parts.iter().filter(|part| !part.covers(middle));
        let raise =
            |part: &Part| part.force / (PI * self.contact_modulus * (part.middle - middle).abs());
        others.map(raise).sum()
    }
}

impl Part<'_> {
    fn covers(&self, s: f64) -> bool {
        (self.edges[0]..=self.edges[1]).contains(&s)
    }

    /// Middle (in m) and half length squared (in m²) of a row; negative outside.
    fn row(&self, s: f64) -> [f64; 2] {
        if self.is_ellipse {
            let Row { x, curvature, .. } = self.rows.at(self.middle);
            let part = (s - self.middle) / (self.edges[1] - self.middle);
            return [x, self.along / curvature * (1.0 - part * part)];
        }
        let Row { x, curvature, least } = self.rows.at(s);
        if let Some([along, across, _]) = self.rows.ellipse_at(s) {
            let approach = self.approach - (least + self.depth) / across;
            return [x, along * approach / curvature];
        }
        let across = self.across[usize::from(s > self.middle)];
        [x, self.along / curvature * (1.0 - (least + self.depth) / across)]
    }

    /// What the level of a row is multiplied by: 1, or c/E* of ANALYN, in 1/m.
    fn local(&self, s: f64) -> f64 {
        self.rows.ellipse_at(s).map_or(1.0, |[.., local]| local)
    }

    /// ∫ l G(η) ds with the potential G of a row (in m²), and ∫ l² ds (in m³), of ANALYN times the
    /// local factor.
    fn integrals(&self) -> [f64; 2] {
        let [x, _] = self.row(self.middle);
        let mut sums = [0.0; 2];
        for edge in self.edges {
            for k in 0..POINTS {
                // Dense at the middle, where the potential of a row is singular.
                let t = (k as f64 + 0.5) / POINTS as f64;
                let away = (edge - self.middle) * t * t;
                let [at, square] = self.row(self.middle + away);
                let half = square.max(0.0).sqrt();
                if half > 0.0 {
                    let width = 2.0 * t * (edge - self.middle).abs() / POINTS as f64;
                    sums[0] += half * row_potential(away.hypot(at - x) / half) * width;
                    sums[1] += self.local(self.middle + away) * square * width;
                }
            }
        }
        sums
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
    let Some(rows) = Rows::new(view, plane, (raised, method)) else { return Ok(None) };
    let parts = Bodies { method, contact_modulus }.parts(&rows)?;
    let Some(approach) = parts.first().map(|part| part.depth) else { return Ok(None) };
    let around = |[from, to]: [f64; 2]| {
        let rim = RIM as f64 * (to - from) / cells as f64;
        positions([from - rim, to + rim], cells + 2 * RIM)
    };
    let s = around(hull(parts.iter().map(|part| part.edges)));
    let row = |s: &f64| {
        let part = parts.iter().find(|part| part.covers(*s))?;
        let [middle, square] = part.row(*s);
        (square > 0.0).then_some((part.level * part.local(*s), middle, square))
    };
    let lines: Vec<Option<(f64, f64, f64)>> = s.iter().map(row).collect();
    let ends = lines.iter().flatten();
    let x = around(hull(ends.map(|(_, x, square)| [x - square.sqrt(), x + square.sqrt()])));
    let cell = |line: &Option<(f64, f64, f64)>, x: &f64| {
        line.map_or(0.0, |(level, middle, square)| {
            level * (square - (x - middle).powi(2)).max(0.0).sqrt()
        })
    };
    let pressure = lines.iter().flat_map(|line| x.iter().map(|x| cell(line, x))).collect();
    let force = parts.iter().map(|part| part.force).sum();
    let (plane, load, curvature) = (*plane, force, 0.0);
    let opening = Vec::new();
    Ok(Some(Pressed { plane, x, s, pressure, opening, force, load, curvature, approach }))
}

/// The interval around all.
fn hull(intervals: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    intervals.fold(none, |[low, high], [from, to]| [low.min(from), high.max(to)])
}
