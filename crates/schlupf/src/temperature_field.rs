//! Temperatures of wheel and rail on and below their surfaces, in the contact and in the wake behind
//! it.
//!
//! At the speeds of rolling, heat flows perpendicular to the surface only (Knothe and Liebelt 1995),
//! so below every point lies a half-space that has received what its point has: the frictional heat
//! since the leading edge, and the heat that the two bodies exchange because they meet at different
//! temperatures. After the contact no heat passes the surface.

use std::f64::consts::{FRAC_2_PI, PI};

use crate::error::Error;
use crate::heat::HeatStep;
use crate::material::Body;
use crate::method::Method;
use crate::patch::{Patch, Strip};
use crate::problem::Problem;
use crate::solution::Solution;

/// Wheel or rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The wheel.
    Wheel,
    /// The rail.
    Rail,
}

/// The temperatures that belong to a solution.
///
/// They are exact for the heat that is released, whatever the heat model: with the constant source of
/// the paper the surface is not as hot here as its cells say.
#[derive(Debug, Clone)]
pub struct TemperatureField {
    tracks: Vec<Track>,
    wheel: Conductor,
    rail: Conductor,
}

/// The way of the material through a strip.
#[derive(Debug, Clone)]
struct Track {
    /// Its lower and upper y, in m.
    y: [f64; 2],
    entry_x: f64,
    exit_x: f64,
    /// Heat received, the latest step first, at the speed of the rail.
    record: Vec<HeatStep>,
    speed: f64,
}

/// A body as a half-space under its part of the heat.
#[derive(Debug, Clone, Copy)]
struct Conductor {
    bulk: f64,
    /// Temperature with which the two surfaces meet, less the bulk temperature, in K.
    step: f64,
    /// Part of the frictional heat, dimensionless.
    share: f64,
    /// Times in this body over those in the rail, dimensionless.
    slowness: f64,
    effusivity: f64,
    diffusivity: f64,
}

impl TemperatureField {
    /// The temperatures of a solution of a problem.
    ///
    /// # Errors
    /// A fast method, which keeps no record of the heat, and whatever
    /// [`crate::normal::PressureSource::normal_contact`] refuses.
    pub fn new(problem: &Problem, solution: &Solution) -> Result<Self, Error> {
        if solution.method != Method::Full {
            return Err(Error::Contradiction {
                quantity: "solver.method",
                reason: format!(
                    "temperatures below the surface need the heat record of \"full\", but the method is \
                     {:?}",
                    solution.method.name()
                ),
            });
        }
        let grid = solution.state.grid;
        let normal = problem.normal.normal_contact(Some(solution.normal.load))?;
        let patch = Patch::new(&normal, grid);
        let mut records = vec![None; grid.len()];
        for element in &solution.state.elements {
            records[element.index] = Some(&element.heat);
        }
        let speed = solution.kinematics.speed;
        let track = |strip: &Strip| {
            let last = &patch.cells[strip.cells.end - 1];
            // Cells that the edge cuts have edges of their own; those in the middle share one.
            let middle = &patch.cells[(strip.cells.start + strip.cells.end - 1) / 2];
            let length = last.since_entry.distance + strip.exit.distance;
            Track {
                y: [grid.edge_y(strip.row), grid.edge_y(strip.row + 1)],
                entry_x: middle.entry_x(),
                exit_x: middle.entry_x() - length,
                record: records[last.index].cloned().unwrap_or_default(),
                speed,
            }
        };
        let conduction = problem.conduction(&solution.kinematics);
        let [wheel_share, rail_share] = conduction.shares();
        let conductor = |body: &Body, share: f64, slowness: f64| Conductor {
            bulk: body.bulk_temperature,
            step: conduction.entry_temperature - body.bulk_temperature,
            share,
            slowness,
            effusivity: body.material.effusivity(),
            diffusivity: body.material.diffusivity(),
        };
        Ok(Self {
            tracks: patch.strips.iter().map(track).collect(),
            wheel: conductor(&problem.wheel, wheel_share, conduction.slowness()),
            rail: conductor(&problem.rail, rail_share, 1.0),
        })
    }

    /// Temperature (in degC) of a body at (x, y) and below its surface by `depth` (in m): in the
    /// contact, behind it, and ahead of it, where the body has its bulk temperature.
    pub fn at(&self, side: Side, x: f64, y: f64, depth: f64) -> f64 {
        let conductor = match side {
            Side::Wheel => &self.wheel,
            Side::Rail => &self.rail,
        };
        let passed = |track: &&Track| {
            let [low, high] = track.y;
            y >= low && y < high && x < track.entry_x
        };
        // Of several pieces of contact in a line, the last one counts, as in the solution.
        let last = self.tracks.iter().filter(passed).min_by(|p, q| p.entry_x.total_cmp(&q.entry_x));
        last.map_or(conductor.bulk, |track| conductor.temperature(track, x, depth))
    }
}

impl Conductor {
    fn temperature(&self, track: &Track, x: f64, depth: f64) -> f64 {
        let seconds = |way: f64| self.slowness * way / track.speed;
        let since_entry = seconds(track.entry_x - x);
        let in_contact = seconds(track.entry_x - track.exit_x.max(x));
        let mixed = self.step * mixing(depth, self.diffusivity, since_entry, in_contact);
        self.bulk + mixed + self.heated(track, since_entry, depth)
    }

    /// Rise by the frictional heat: a flux q from s₁ to s₂ before now gives
    /// (2q/β) (√s₂ ierfc(z/2√(κs₂)) − √s₁ ierfc(z/2√(κs₁))) (Carslaw and Jaeger 1959, §2.9 (7)).
    fn heated(&self, track: &Track, since_entry: f64, depth: f64) -> f64 {
        let part = |ago: f64| {
            if ago <= 0.0 {
                return 0.0;
            }
            ago.sqrt() * ierfc(depth / (2.0 * (self.diffusivity * ago).sqrt()))
        };
        let mut began = since_entry;
        let mut sum = 0.0;
        for step in track.record.iter().rev() {
            let ended = began - self.slowness * step.duration;
            sum += step.flux * (part(began) - part(ended));
            began = ended;
            if began <= 0.0 {
                break;
            }
        }
        2.0 * self.share * sum / self.effusivity
    }
}

/// Integral of the complementary error function, ierfc(x) = exp(−x²)/√π − x erfc(x).
fn ierfc(x: f64) -> f64 {
    (-x * x).exp() / PI.sqrt() - x * libm::erfc(x)
}

/// How far a body has come to the common surface temperature at a depth (in m), dimensionless, a time
/// t after entry of which it spent t_c in contact: erfc(z/2√(κt)) in contact, and behind it, where
/// no heat passes the surface, (2/π) ∫ exp(−z²/(4κt cos²θ)) dθ from 0 to asin √(t_c/t). On the surface
/// that is (2/π) asin √(t_c/t).
fn mixing(depth: f64, diffusivity: f64, time: f64, in_contact: f64) -> f64 {
    if time <= 0.0 {
        return 0.0;
    }
    let square = depth * depth / (4.0 * diffusivity * time);
    if in_contact >= time {
        return libm::erfc(square.sqrt());
    }
    let end = (in_contact / time).sqrt().asin();
    let width = end / NODES as f64;
    let value = |k: usize| (-square / ((k as f64 + 0.5) * width).cos().powi(2)).exp();
    FRAC_2_PI * width * (0..NODES).map(value).sum::<f64>()
}

/// Nodes of the midpoint rule over the angle.
const NODES: usize = 400;
