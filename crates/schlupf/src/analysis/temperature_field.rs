//! Temperatures of wheel and rail on and below their surfaces, in the contact and in the wake
//! behind it.
//!
//! At rolling speeds, heat flows perpendicular to the surface only (Knothe and Liebelt 1995), so
//! below every point lies a half-space that has received the heat of that point: the frictional
//! heat since the leading edge, and the heat that the two bodies exchange because they meet at
//! different temperatures. Behind the contact no heat crosses the surface.
//!
//! The record of the last cell of a strip is in steady rolling the past of every element before it.
//! Its steps are subdivided, each keeping its heat: with one flux per cell the surface temperature
//! would have a kink at every cell. A history has no such field, because its wake has a different
//! past.

use std::f64::consts::{FRAC_2_PI, PI};

use crate::bodies::{Body, ReferencePoint};
use crate::interface::heat::HeatStep;
use crate::normal::patch::{Patch, Strip};
use crate::problem::{Method, Problem};
use crate::reporting::{Error, MethodPurpose, StateError, Warning};
use crate::solution::Solution;

/// Wheel or rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The wheel.
    Wheel,
    /// The rail.
    Rail,
}

/// The temperatures of a solution.
///
/// They are exact for the heat released, whatever the heat model: with the constant source of the
/// paper the surface temperature here is lower than in the cells. Without a heat model the bodies
/// still exchange heat where their bulk temperatures differ.
#[derive(Debug, Clone)]
pub struct TemperatureField {
    tracks: Vec<Track>,
    wheel: Conductor,
    rail: Conductor,
}

/// The path of the material through a strip.
#[derive(Debug, Clone)]
struct Track {
    /// Its lower and upper y, in m.
    y: [f64; 2],
    entry_x: f64,
    exit_x: f64,
    /// Heat received, the latest step first, with times in the rail.
    record: Vec<HeatStep>,
    speed: f64,
}

/// A body as a half-space with its share of the heat.
#[derive(Debug, Clone, Copy)]
struct Conductor {
    bulk: f64,
    /// Temperature at which the two surfaces meet, minus the bulk temperature, in K.
    step: f64,
    /// Share of the frictional heat, dimensionless.
    share: f64,
    /// Times in this body over those of the contact frame, dimensionless.
    contact_time: f64,
    effusivity: f64,
    diffusivity: f64,
}

impl TemperatureField {
    /// A warning for whoever uses the temperatures, if there is one.
    pub fn caveat(problem: &Problem, solution: &Solution) -> Vec<Warning> {
        let peclet = problem.interface.peclet(&solution.kinematics, solution.normal.semi_axes());
        let slow = peclet.caveat(true);
        Self::caveat_of_model(problem).into_iter().chain(slow).collect()
    }

    fn caveat_of_model(problem: &Problem) -> Option<Warning> {
        let model = problem.interface.heat.model.as_ref()?;
        (!model.is_linear()).then_some(Warning::HeatModelOfCells {})
    }

    /// Computes the temperatures of steady rolling from the solution of a problem. They do not
    /// exist for a history: the material in its wake has a different past from that leaving the
    /// contact now.
    ///
    /// ```
    /// use schlupf::analysis::temperature_field::{Side, TemperatureField};
    /// use schlupf::{solver, Options, Problem, unwatched};
    ///
    /// let problem = Problem::builder().creepage_x(0.008).build()?;
    /// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
    /// let solution = solver::solve(&problem, &options, &unwatched)?;
    /// let field = TemperatureField::new(&problem, &solution)?;
    /// let [surface, below] = [0.0, 1e-3].map(|depth| field.at(Side::Wheel, -3e-3, 0.0, depth));
    /// assert!(surface > below && below >= 20.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A fast method, which keeps no record of the heat, a solution without a state, and whatever
    /// [`crate::normal::PressureSource::normal_contact`] rejects.
    pub fn new(problem: &Problem, solution: &Solution) -> Result<Self, Error> {
        if solution.method != Method::Full {
            let method = solution.method.name();
            return Err(Error::OtherMethod { purpose: MethodPurpose::Field, method });
        }
        if solution.state.elements.is_empty() {
            return Err(StateError::NotKept {}.into());
        }
        let grid = solution.state.grid;
        let normal = problem.normal.normal_contact(Some(solution.normal.load))?;
        let patch = Patch::new(&normal, grid);
        let mut records = vec![None; grid.len()];
        let elements = solution.state.elements.iter();
        for element in elements.filter(|_| problem.interface.heat.model.is_some()) {
            records[element.index] = Some(&element.heat);
        }
        let speed = solution.kinematics.speed;
        let track = |strip: &Strip| {
            let last = &patch.cells[strip.cells.end - 1];
            // Cells cut by the edge have their own edges; those in the middle share one.
            let middle = &patch.cells[(strip.cells.start + strip.cells.end - 1) / 2];
            // The mean over the strip, as the cells at its ends are only partly covered.
            let covered: f64 = patch.cells[strip.cells.clone()].iter().map(|c| c.covered).sum();
            let length = covered * grid.spacing_x;
            Track {
                y: [grid.edge_y(strip.row), grid.edge_y(strip.row + 1)],
                entry_x: middle.entry_x(),
                exit_x: middle.entry_x() - length,
                record: records[last.index].map(|record| smooth(record)).unwrap_or_default(),
                speed,
            }
        };
        let (motion, _) = solution
            .seen_from(ReferencePoint::Patch)
            .unwrap_or((solution.kinematics, solution.force));
        let conduction = problem.interface.conduction(&motion);
        let conductor = |body: &Body, k: usize| Conductor {
            bulk: body.bulk_temperature,
            step: conduction.entry_temperature - body.bulk_temperature,
            share: conduction.shares()[k],
            contact_time: conduction.contact_times()[k],
            effusivity: body.material.effusivity(),
            diffusivity: body.material.diffusivity(),
        };
        Ok(Self {
            tracks: patch.strips.iter().map(track).collect(),
            wheel: conductor(&problem.interface.wheel, 0),
            rail: conductor(&problem.interface.rail, 1),
        })
    }

    /// Where the material on the line y (in m) enters and leaves the contact (x in m), for each
    /// piece of contact that it passes, the first one first. Empty outside the patch.
    pub fn passages(&self, y: f64) -> Vec<[f64; 2]> {
        let on_line = self.tracks.iter().filter(|track| track.holds(y));
        let mut passages: Vec<_> = on_line.map(|track| [track.entry_x, track.exit_x]).collect();
        passages.sort_unstable_by(|p, q| q[0].total_cmp(&p[0]));
        passages
    }

    /// Lower and upper y of the contact, in m.
    pub fn width(&self) -> [f64; 2] {
        let ends = |k: usize| self.tracks.iter().map(move |track| track.y[k]);
        [ends(0).fold(f64::INFINITY, f64::min), ends(1).fold(f64::NEG_INFINITY, f64::max)]
    }

    /// Temperature (in degC) of a body at (x, y) and at the given `depth` below its surface (in m):
    /// in the contact, behind it, and ahead of it, where the body has its bulk temperature.
    pub fn at(&self, side: Side, x: f64, y: f64, depth: f64) -> f64 {
        let conductor = match side {
            Side::Wheel => &self.wheel,
            Side::Rail => &self.rail,
        };
        let passed = |track: &&Track| track.holds(y) && x < track.entry_x;
        // Of several pieces of contact in a line, only the last one is used, as in the solution.
        let last = self.tracks.iter().filter(passed).min_by(|p, q| p.entry_x.total_cmp(&q.entry_x));
        last.map_or(conductor.bulk, |track| conductor.temperature(track, x, depth))
    }
}

impl Track {
    fn holds(&self, y: f64) -> bool {
        y >= self.y[0] && y < self.y[1]
    }
}

impl Conductor {
    fn temperature(&self, track: &Track, x: f64, depth: f64) -> f64 {
        let seconds = |way: f64| self.contact_time * way / track.speed;
        let since_entry = seconds(track.entry_x - x);
        let in_contact = seconds(track.entry_x - track.exit_x.max(x));
        let mixed = self.step * mixing(depth, self.diffusivity, since_entry, in_contact);
        self.bulk + mixed + self.heated(track, since_entry, depth)
    }

    /// Rise due to the frictional heat: a flux q from s₁ to s₂ before now gives (2q/β) (√s₂
    /// ierfc(z/2√(κs₂)) − √s₁ ierfc(z/2√(κs₁))) (Carslaw and Jaeger 1959, §2.9 (7)).
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
            let ended = began - self.contact_time * step.duration;
            sum += step.flux * (part(began) - part(ended));
            began = ended;
            if began <= 0.0 {
                break;
            }
        }
        2.0 * self.share * sum / self.effusivity
    }
}

/// Number of parts into which a step of a record is divided.
const PARTS: usize = 8;

/// A record in finer steps, with the mean of each step preserved: with one flux per cell the
/// surface temperature would have a kink at every cell edge. Inside, the flux varies linearly
/// towards those of the neighbours; in the first and the last step as A√s + B, with s measured from
/// the edge, as under Hertz's pressure.
fn smooth(record: &[HeatStep]) -> Vec<HeatStep> {
    let finer = |k: usize| {
        let means = match (k, record.len() - 1) {
            (0, last) if last > 0 => at_edge(&record[0], &record[1]),
            (k, last) if k == last && last > 0 => {
                let mut from_edge = at_edge(&record[k], &record[k - 1]);
                from_edge.reverse();
                from_edge
            }
            _ => inside(record, k),
        };
        let duration = record[k].duration / PARTS as f64;
        means.map(|flux| HeatStep { flux, duration })
    };
    (0..record.len()).flat_map(finer).collect()
}

/// Mean fluxes (in W/m²) in the parts of a step, from the edge inwards: A√s + B with the means of
/// the step and of its neighbour. A negative B is replaced by zero.
fn at_edge(step: &HeatStep, neighbour: &HeatStep) -> [f64; PARTS] {
    // ∫ √s ds is two thirds of this.
    let power = |s: f64| s * s.sqrt();
    let end = step.duration + neighbour.duration;
    let own = 2.0 / 3.0 * step.duration.sqrt();
    let next = 2.0 / 3.0 * (power(end) - power(step.duration)) / neighbour.duration;
    let fitted = (neighbour.flux - step.flux) / (next - own);
    // Keeps the flux from falling below zero at the edge and within the step.
    let root = fitted.min(step.flux / own).max(-2.0 * step.flux / own);
    let constant = step.flux - root * own;
    std::array::from_fn(|part| {
        let [from, to] = [part, part + 1].map(|k| step.duration * k as f64 / PARTS as f64);
        constant + root * 2.0 / 3.0 * (power(to) - power(from)) / (to - from)
    })
}

/// Mean fluxes (in W/m²) in the parts of a step between two others, with the smaller of the two
/// adjacent slopes.
fn inside(record: &[HeatStep], k: usize) -> [f64; PARTS] {
    let HeatStep { flux, duration } = record[k];
    let slope_to = |other: Option<&HeatStep>| {
        other.map_or(0.0, |other| (other.flux - flux) / (0.5 * (duration + other.duration)))
    };
    let before = -slope_to(k.checked_sub(1).and_then(|k| record.get(k)));
    let after = slope_to(record.get(k + 1));
    let is_peak = before * after <= 0.0;
    let slope = if is_peak { 0.0 } else { before.abs().min(after.abs()).copysign(after) };
    std::array::from_fn(|part| flux + slope * ((part as f64 + 0.5) / PARTS as f64 - 0.5) * duration)
}

/// Integral of the complementary error function, ierfc(x) = exp(−x²)/√π − x erfc(x).
fn ierfc(x: f64) -> f64 {
    (-x * x).exp() / PI.sqrt() - x * libm::erfc(x)
}

/// Approach of a body to the common surface temperature at a depth (in m), dimensionless, at time t
/// after entry, of which t_c was spent in contact: erfc(z/2√(κt)) in contact, and behind it, where
/// no heat crosses the surface, (2/π) ∫ exp(−z²/(4κt cos²θ)) dθ from 0 to asin √(t_c/t). On the
/// surface that is (2/π) asin √(t_c/t).
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

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Heat is conserved step by step, and no part is negative; a linear profile inside is
    /// reproduced exactly, and A√s + B at an edge.
    #[test]
    fn finer_steps_keep_the_heat() {
        let step = |flux| HeatStep { flux, duration: 2.0 };
        for fluxes in
            [[1.0, 2.0, 3.0, 4.0], [5.0, 5.0, 0.0, 0.0], [0.1, 3.0, 1.0, 0.0], [3.0, 0.0, 0.0, 9.0]]
        {
            let record = fluxes.map(step);
            let finer = smooth(&record);
            for (k, coarse) in record.iter().enumerate() {
                let heat = |step: &HeatStep| step.flux * step.duration;
                let sum: f64 = finer[k * PARTS..(k + 1) * PARTS].iter().map(heat).sum();
                assert_relative_eq!(sum, heat(coarse), max_relative = 1e-14, epsilon = 1e-14);
            }
            assert!(finer.iter().all(|step| step.flux >= -1e-14), "{finer:?}");
        }
        let linear = smooth(&[0.0, 1.0, 2.0, 3.0].map(step));
        assert_relative_eq!(linear[PARTS].flux, 1.0 - 0.5 * 7.0 / 8.0);
        // √s from 0 to 2 has the mean 2√2/3, from 2 to 4 (8 − 2√2)/3.
        let root = |s: f64| 2.0 / 3.0 * s * s.sqrt();
        let [edge, next] = [root(2.0) / 2.0, (root(4.0) - root(2.0)) / 2.0].map(|f| 3.0 + f);
        let parts = smooth(&[edge, next, next].map(step));
        assert_relative_eq!(
            parts[1].flux,
            3.0 + (root(0.5) - root(0.25)) / 0.25,
            max_relative = 1e-12
        );
        assert!(smooth(&[]).is_empty());
        assert_eq!(smooth(&[step(7.0)]), [HeatStep { flux: 7.0, duration: 0.25 }; PARTS]);
    }
}
