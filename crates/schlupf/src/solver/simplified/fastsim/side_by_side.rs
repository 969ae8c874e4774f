//! Four strips side by side: strips do not depend on each other, and a processor works on the cells
//! of four of them in hardly more time than on one.
//!
//! What does not depend on the bound of a cell is computed once for its path. Under a bound the
//! state comes with its derivative, so friction that depends on slip and heat takes two or three
//! Newton steps; where the slope is steep, cells are solved one by one within a bracket. Strips
//! whose layer flows, and heat models that are not linear, are passed one by one with single
//! numbers.

use wide::f64x4;

use crate::bodies::Kinematics;
use crate::interface::friction::FrictionState;
use crate::interface::heat::strip_heat::StripHeat;
use crate::normal::patch::{Cell, Patch, Strip};
use crate::numerics::lanes::{FOUR, Lanes, scaled};
use crate::numerics::root::fixed_point;
use crate::problem::Problem;

use super::cell::{Carried, Held, Step};
use super::flexibility::Flexibility;
use super::passage::Approach;
use super::path::Path;

/// Four strips, or fewer if there are no more.
#[derive(Debug, Clone)]
pub(super) struct FourStrips {
    /// The cells at equal distances from the leading edges.
    stations: Vec<Station>,
}

/// Cells of four strips that are passed together.
#[derive(Debug, Clone)]
struct Station {
    /// Number of each; none where a strip has ended.
    cells: [Option<usize>; FOUR],
    path: Path<f64x4>,
    /// Where they are covered, in Pa.
    pressure: f64x4,
    /// In m.
    y: [f64; FOUR],
    /// Weights of their own heat flux in their rise times effusivity, in s^½.
    own_weight: f64x4,
    /// The same of the fluxes of the first cells of their strips. Those of the others are common to
    /// all cells of the patch.
    weights: Vec<f64x4>,
}

/// The strips of a patch, four by four.
pub(super) fn four_by_four(patch: &Patch) -> Vec<FourStrips> {
    let four = |strips: &[Strip]| {
        let longest = strips.iter().map(|strip| strip.cells.len()).max().unwrap_or(0);
        let number = |lane: usize, n: usize| strips.get(lane)?.cells.clone().nth(n);
        let station = |n: usize| Station::of(patch, [0, 1, 2, 3].map(|lane| number(lane, n)), n);
        FourStrips { stations: (0..longest).map(station).collect() }
    };
    patch.strips.chunks(FOUR).map(four).collect()
}

/// Work arrays for a pass: the fluxes of four strips (in W/m²) and common weights (in s^½).
#[derive(Debug, Clone)]
pub(super) struct Workspace {
    flux: Vec<f64x4>,
    common: Vec<f64x4>,
}

impl Workspace {
    /// For the strips of a patch.
    pub fn new(patch: &Patch) -> Self {
        let longest = patch.strips.iter().map(|strip| strip.cells.len()).max().unwrap_or(0);
        Self { flux: Vec::with_capacity(longest), common: Vec::with_capacity(longest) }
    }

    /// Takes over the weights of the heat, if that is linear; returns whether it is.
    pub fn take_weights(&mut self, heat: &StripHeat, strips: &mut [FourStrips]) -> bool {
        if heat.has_model() && !heat.is_linear() {
            return false;
        }
        self.common.clear();
        self.common.extend(heat.common_weights().iter().map(|weight| f64x4::from(*weight)));
        for station in strips.iter_mut().flat_map(|strips| &mut strips.stations) {
            station.take_weights(heat);
        }
        true
    }
}

impl Station {
    /// Cells of a patch that are the n-th of their strips.
    fn of(patch: &Patch, cells: [Option<usize>; FOUR], n: usize) -> Self {
        let of = |value: fn(&Cell) -> f64| cells.map(|k| k.map_or(0.0, |k| value(&patch.cells[k])));
        Self {
            cells,
            path: Path::into_cells(patch, cells),
            pressure: f64x4::from(of(Cell::pressure_where_covered)),
            y: of(|cell| cell.y),
            own_weight: f64x4::from(0.0),
            weights: Vec::with_capacity(n),
        }
    }

    fn take_weights(&mut self, heat: &StripHeat) {
        let of = |k: Option<usize>, weight: &dyn Fn(usize) -> f64| k.map_or(0.0, weight);
        let lanes = |weight: &dyn Fn(usize) -> f64| f64x4::from(self.cells.map(|k| of(k, weight)));
        self.own_weight = lanes(&|k| heat.own_weight(k));
        let upstream = |k: usize| k - heat.first(k);
        let apart = |k: &usize| upstream(*k).min(heat.weights_apart(*k));
        let count = self.cells.iter().flatten().map(apart).max().unwrap_or(0);
        self.weights.clear();
        self.weights.extend((0..count).map(|j| lanes(&|k| heat.weight(k, j))));
    }

    /// Rise times effusivity (in W √s/m²) due to the fluxes of the cells upstream, in W/m².
    #[inline]
    fn inherited(&self, flux: &[f64x4], common: &[f64x4]) -> f64x4 {
        let (apart, alike) = flux.split_at(self.weights.len().min(flux.len()));
        let mut sums = [f64x4::from(0.0); 2];
        for (weight, flux) in self.weights.iter().zip(apart) {
            sums[0] += *weight * *flux;
        }
        // The last of the common weights is that of a cell itself.
        let end = common.len().saturating_sub(1);
        let common = &common[end - alike.len().min(end)..end];
        let (pairs, fluxes) = (common.chunks_exact(2), alike.chunks_exact(2));
        let rest = pairs.remainder().iter().zip(fluxes.remainder());
        for (weight, flux) in rest {
            sums[0] += *weight * *flux;
        }
        for (weight, flux) in pairs.zip(fluxes) {
            sums[0] += weight[0] * flux[0];
            sums[1] += weight[1] * flux[1];
        }
        sums[0] + sums[1]
    }

    /// Writes a value of each cell.
    #[inline]
    fn put<V>(&self, to: &mut [V], value: impl Fn(usize) -> V) {
        for (lane, k) in self.cells.iter().enumerate() {
            if let Some(k) = k {
                to[*k] = value(lane);
            }
        }
    }
}

impl FourStrips {
    /// Takes over paths and pressures of a patch whose lengths and pressures have changed.
    pub fn take_paths(&mut self, patch: &Patch) {
        for station in &mut self.stations {
            let weights = std::mem::take(&mut station.weights);
            *station = Station { weights, ..Station::of(patch, station.cells, 0) };
        }
    }

    /// Passes from the leading to the trailing edges with the given friction; writes the tractions,
    /// in Pa.
    pub fn pass(
        &self,
        (flexibility, motion): (&Flexibility, &Kinematics),
        friction: &[f64],
        traction: &mut [[f64; 2]],
    ) {
        let mut carried = Carried::entering();
        for station in &self.stations {
            let increment = flexibility.stick_increment(motion, &station.path);
            let mu = f64x4::from(station.cells.map(|k| k.map_or(0.0, |k| friction[k])));
            (carried, _) = carried.along(increment).under(mu * station.pressure);
            let [x, y] = carried.traction.map(f64x4::to_array);
            station.put(traction, |lane| [x[lane], y[lane]]);
        }
    }
}

/// The fields that a pass with friction that depends on slip and heat writes, cell by cell.
pub(super) struct Found<'a> {
    /// Tractions on the rail, in Pa.
    pub traction: &'a mut [[f64; 2]],
    /// Coefficients of friction, dimensionless.
    pub friction: &'a mut [f64],
    /// Heat flux, in W/m².
    pub flux: &'a mut [f64],
}

/// A pass with friction that depends on slip and heat, without a layer that flows.
pub(super) struct WithFriction<'a> {
    problem: &'a Problem,
    flexibility: &'a Flexibility,
    /// Derivative of the temperature by the rise times effusivity, in m² √s K/W.
    by_rise: f64x4,
    /// Temperature of unheated material relative to the reference, in K.
    unheated: f64x4,
    follows_slip_speed: bool,
}

/// A cell of four strips each, with what has been passed before.
struct Arrival<'a> {
    station: &'a Station,
    approach: Approach<f64x4>,
    step: Step<f64x4>,
    before: Held<f64x4>,
    /// Of the cell before, in Pa.
    pressure_before: f64x4,
    /// Rise times effusivity due to the heat upstream, in W √s/m².
    inherited: f64x4,
}

/// Newton steps before a cell is solved by itself, with a bracket.
const MOST_STEPS: usize = 6;

/// Relative length of a step (dimensionless) that is the last one, as the error falls with its
/// square.
const SMALL: f64 = 1e-7;

/// Largest slope of the coefficient that follows from a coefficient (dimensionless) with which
/// Newton's method is trusted: near one it may end at another solution.
const STEEPEST: f64 = 0.5;

impl<'a> WithFriction<'a> {
    pub fn new(problem: &'a Problem, flexibility: &'a Flexibility) -> Self {
        let conduction = problem.interface.conduction(&problem.kinematics);
        let unheated = problem.interface.friction_state(&conduction, 0.0, 0.0, 0.0).temperature;
        let by_rise = conduction.contact_factor().into();
        let follows_slip_speed = problem.interface.friction.law.follows_slip_speed();
        Self { problem, flexibility, by_rise, unheated: unheated.into(), follows_slip_speed }
    }

    /// Passes from the leading to the trailing edges.
    ///
    /// A point that arrives with more traction than its coefficient here would have allowed there
    /// loses the excess without slip and heat: see [`super::Fastsim::path_in`].
    pub fn pass(&self, strips: &FourStrips, workspace: &mut Workspace, found: &mut Found) {
        let cold = f64x4::from(self.problem.interface.friction.cold_coefficient());
        let mut last = [cold; 2];
        let mut carried = Carried::entering();
        let mut pressure_before = f64x4::from(0.0);
        workspace.flux.clear();
        for station in &strips.stations {
            let motion = &self.problem.kinematics;
            let approach = Approach::new(self.flexibility, motion, &station.path);
            let arrival = Arrival {
                station,
                step: carried.along(approach.stick_increment),
                before: carried.held(),
                approach,
                pressure_before,
                inherited: station.inherited(&workspace.flux, &workspace.common),
            };
            let start = (f64x4::from(2.0) * last[0] - last[1]).fast_max(f64x4::from(0.0));
            let Cells { mu, next, heat } = self.cells(&arrival, start);
            workspace.flux.push(heat);
            let [x, y] = next.traction.map(f64x4::to_array);
            let (mu_of, flux_of) = (mu.to_array(), heat.to_array());
            station.put(found.traction, |lane| [x[lane], y[lane]]);
            station.put(found.friction, |lane| mu_of[lane]);
            station.put(found.flux, |lane| flux_of[lane]);
            last = [mu, last[0]];
            carried = next;
            pressure_before = station.pressure;
        }
    }

    /// The cells with the coefficients of friction of the slip and the heat they cause, by Newton's
    /// method from a guess.
    #[inline]
    fn cells(&self, arrival: &Arrival, start: f64x4) -> Cells {
        let (zero, one) = (f64x4::from(0.0), f64x4::from(1.0));
        let mut mu = start;
        // What becomes of a strip does not depend on those beside it: only cells for which Newton's
        // method fails are solved otherwise.
        let mut failed = zero;
        let mut is_near = zero;
        for _ in 0..MOST_STEPS {
            let Tried { asked, slope, next, by_mu, heat, heat_by_mu } = self.tried(arrival, mu);
            failed |= !slope.at_most(f64x4::from(STEEPEST));
            let newton = Lanes::max(mu + (asked - mu) / (one - slope), zero) - mu;
            let step = Lanes::choose(failed, zero, newton);
            is_near = step.abs().at_most(f64x4::from(SMALL) * Lanes::max(mu, asked));
            mu += step;
            if !is_near.all() {
                continue;
            }
            if failed.any() {
                break;
            }
            // To first order, as the step is small.
            let next = next.moved(scaled(step, by_mu), mu * arrival.station.pressure);
            let heat = Lanes::max(heat + step * heat_by_mu, zero);
            return Cells { mu, next, heat };
        }
        let alone = self.one_by_one(arrival, start, failed | !is_near);
        let mu = Lanes::choose(failed | !is_near, alone, mu);
        let Tried { next, heat, .. } = self.tried(arrival, mu);
        Cells { mu, next, heat }
    }

    /// The cells with some coefficients of friction, dimensionless.
    #[inline]
    fn tried(&self, arrival: &Arrival, mu: f64x4) -> Tried {
        let Arrival { station, approach, step, before, pressure_before, inherited } = arrival;
        let (next, by_bound) = step.under(mu * station.pressure);
        let [from, from_by] = before.under(mu * *pressure_before);
        let ends = [from, next.traction];
        let passage = approach.passage(ends);
        let by_mu = scaled(station.pressure, by_bound);
        let both_by_mu = [scaled(*pressure_before, from_by), by_mu];
        let heat_by_mu = approach.heat_change(&passage, ends, both_by_mu);
        let heat = passage.heat();
        let [speed, faster] = if self.follows_slip_speed {
            approach.slip_speed_with_change(&passage, ends, both_by_mu)
        } else {
            [f64x4::from(0.0); 2]
        };
        let rise = *inherited + station.own_weight * heat;
        let temperature = (self.unheated + self.by_rise * rise).to_array();
        let slip_speed = speed.to_array();
        let responses = [0, 1, 2, 3].map(|n| {
            let (temperature, slip_speed) = (temperature[n], slip_speed[n]);
            let state = FrictionState { temperature, slip_speed, y: station.y[n] };
            self.problem.interface.friction.law.respond(&state)
        });
        let by_temperature = f64x4::from(responses.map(|response| response.by_temperature));
        let by_speed = f64x4::from(responses.map(|response| response.by_slip_speed));
        let hotter = self.by_rise * station.own_weight * heat_by_mu;
        Tried {
            asked: f64x4::from(responses.map(|response| response.coefficient)),
            slope: by_temperature * hotter + by_speed * faster,
            next,
            by_mu,
            heat,
            heat_by_mu,
        }
    }

    /// The coefficients of friction (dimensionless) of some cells, each by itself within a bracket.
    #[cold]
    #[inline(never)]
    fn one_by_one(&self, arrival: &Arrival, start: f64x4, which: f64x4) -> f64x4 {
        let (start, which) = (start.to_array(), which.move_mask());
        let alone = |lane: usize| {
            if which & (1 << lane) == 0 {
                return start[lane];
            }
            fixed_point(start[lane], |tried| {
                self.tried(arrival, f64x4::from(tried)).asked.to_array()[lane]
            })
        };
        f64x4::from([0, 1, 2, 3].map(alone))
    }
}

/// Four cells, in the units of [`Found`].
struct Cells {
    mu: f64x4,
    next: Carried<f64x4>,
    heat: f64x4,
}

/// The same with coefficients that are tried.
struct Tried {
    /// Coefficients that follow from them, dimensionless, and their derivatives by them.
    asked: f64x4,
    slope: f64x4,
    next: Carried<f64x4>,
    /// Derivative of the tractions, in Pa.
    by_mu: [f64x4; 2],
    /// Heat flux and its derivative, in W/m².
    heat: f64x4,
    heat_by_mu: f64x4,
}
