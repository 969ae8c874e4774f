//! Constrained conjugate gradients for the pressure.
//!
//! The method of Polonsky and Keer (1999), with these differences, which keep the number of
//! iterations small and nearly independent of the grid:
//! - The gap is preconditioned with the stiffness of the unbounded surface, E*|k|/2 (Vollebregt
//!   2014).
//! - Cells that are pressed in without pressure, or yield while the gap opens, join the search
//!   direction immediately. The direction is kept when they do, with Polak and Ribière's weight,
//!   which by itself becomes small where the contact has changed much.
//! - A step is projected onto the load and the bounds by a shift, not a scaling: the energy is
//!   insensitive to a shift to first order.
//! - Where no cell meets a constraint the displacement is updated instead of recomputed.
//! - Where constraints spoil a step so that the energy ½ pᵀSp + pᵀh would rise, the step is
//!   shortened: the energy decreases in every iteration.
//!
//! Convergence is measured by the duality gap. With λ the level of the gap in contact, and P the
//! largest possible pressure (the hardness, or twice the largest one present),
//!
//! Σ p (g − λ)⁺ + (P − p) (λ − g)⁺
//!
//! bounds the distance of the energy from its minimum, which is half the squared error of the
//! pressure in the energy norm. Its ratio to pᵀu is the residual.

use crate::reporting::{Error, Progress, Stage, Watch, tell};

use super::RoughContactOptions;
use super::compliance::NormalCompliance;
use crate::numerics::vector::dot;

/// What holds the bodies together.
#[derive(Debug, Clone, Copy)]
pub(super) enum Held {
    /// The sum of the pressures of all cells, in Pa.
    Total(f64),
    /// The level λ of the gap in contact, in m.
    Level(f64),
}

/// The problem: Σ p or λ, and the bounds of p are given.
///
/// With λ given, Σ p is free, and the minimum is that of ½ pᵀSp + pᵀ(h − λ).
pub(super) struct Equilibrium<'a> {
    /// Undeformed distance, in m.
    pub distance: &'a [f64],
    pub held: Held,
    /// Largest pressure, in Pa; infinite without a limit.
    pub hardness: f64,
    /// S.
    pub compliance: &'a mut NormalCompliance,
}

/// Result of the iteration.
pub(super) struct Outcome {
    /// Pressure, in Pa.
    pub pressure: Vec<f64>,
    /// Gap relative to its level, g − λ, in m.
    pub gap: Vec<f64>,
    /// λ = δ, in m.
    pub level: f64,
    /// Dimensionless.
    pub residual: f64,
    pub iterations: usize,
    pub products: usize,
}

/// The state of an iteration.
struct State {
    pressure: Vec<f64>,
    displacement: Vec<f64>,
    /// Whether the displacement was computed from the pressure or updated.
    is_fresh: bool,
    /// g − λ.
    gap: Vec<f64>,
    level: f64,
    /// ½ pᵀu + pᵀh.
    energy: f64,
    /// Search direction and the displacement under it.
    direction: Vec<f64>,
    response: Vec<f64>,
    /// The preconditioned gap of the cells that may move, and their gap in the previous iteration.
    steepest: Vec<f64>,
    last_gap: Vec<f64>,
    /// The product of both in the previous iteration; initially zero.
    last_product: f64,
    /// Whether to omit the preconditioner, because with it the bounds spoiled all steps.
    is_plain: bool,
    /// Pressure before a step.
    before: Vec<f64>,
    products: usize,
}

impl Equilibrium<'_> {
    /// Starts from any pressure that is nowhere negative.
    ///
    /// # Errors
    /// [`Error::Stopped`].
    pub(super) fn solve(
        &mut self,
        start: Vec<f64>,
        options: &RoughContactOptions,
        watch: Watch,
    ) -> Result<Outcome, Error> {
        let mut state = State::new(start);
        match self.held {
            Held::Total(total) => self.scale_to_the_load(total, &mut state.pressure),
            Held::Level(level) => self.scale_to_the_level(level, &mut state),
        }
        self.move_surface(&mut state);
        let mut iterations = 0;
        let residual = loop {
            let residual = self.measure(&mut state);
            if residual <= options.tolerance && !state.is_fresh {
                // Rounding error may have accumulated in the updates.
                self.move_surface(&mut state);
                continue;
            }
            if residual <= options.tolerance || iterations >= options.max_iterations {
                break residual;
            }
            let change = Some(residual);
            tell(watch, Progress { change, ..Progress::count(Stage::NormalContact, iterations) })?;
            iterations += 1;
            self.choose_direction(&mut state);
            self.step(&mut state);
        };
        let State { pressure, gap, level, products, .. } = state;
        Ok(Outcome { pressure, gap, level, residual, iterations, products })
    }

    /// Displacement and energy of the pressure.
    fn move_surface(&mut self, state: &mut State) {
        self.compliance.displacement(&state.pressure, &mut state.displacement);
        state.products += 1;
        state.is_fresh = true;
        let raised = match self.held {
            Held::Total(_) => 0.0,
            Held::Level(level) => level * state.pressure.iter().sum::<f64>(),
        };
        state.energy = 0.5 * dot(&state.pressure, &state.displacement)
            + dot(&state.pressure, self.distance)
            - raised;
    }

    /// Whether a cell meets neither bound.
    fn is_free(&self, pressure: f64) -> bool {
        pressure > 0.0 && pressure < self.hardness
    }

    /// Whether the pressure of a cell with this gap relative to the level may move: away from a
    /// bound only.
    fn may_move(&self, pressure: f64, gap: f64) -> bool {
        (pressure > 0.0 || gap < 0.0) && (pressure < self.hardness || gap > 0.0)
    }

    /// Gap and its level; returns the residual.
    fn measure(&self, state: &mut State) -> f64 {
        let State { pressure, displacement, gap, .. } = state;
        let (mut sum, mut free) = (0.0, 0_usize);
        let (mut lowest, mut largest_pressure) = (f64::INFINITY, 0.0_f64);
        for (k, g) in gap.iter_mut().enumerate() {
            *g = self.distance[k] + displacement[k];
            largest_pressure = largest_pressure.max(pressure[k]);
            lowest = lowest.min(*g);
            if self.is_free(pressure[k]) {
                sum += *g;
                free += 1;
            }
        }
        state.level = match self.held {
            Held::Level(level) => level,
            Held::Total(_) if free > 0 => sum / free as f64,
            Held::Total(_) => lowest,
        };
        let largest_pressure = self.hardness.min(2.0 * largest_pressure);
        let (mut excess, mut work) = (0.0, 0.0);
        for (k, g) in gap.iter_mut().enumerate() {
            *g -= state.level;
            let share = if *g > 0.0 { pressure[k] } else { largest_pressure - pressure[k] };
            excess += share * g.abs();
            work += pressure[k] * displacement[k];
        }
        if excess > 0.0 { excess / work.max(f64::MIN_POSITIVE) } else { 0.0 }
    }

    /// The next search direction: preconditioned gap of the cells that may move, conjugate to the
    /// previous one.
    fn choose_direction(&mut self, state: &mut State) {
        let State { pressure, gap, direction, response, steepest, last_gap, .. } = state;
        // The response is used as a buffer for the gap of the cells that may move.
        for (k, masked) in response.iter_mut().enumerate() {
            *masked = if self.may_move(pressure[k], gap[k]) { gap[k] } else { 0.0 };
        }
        if state.is_plain {
            steepest.copy_from_slice(response);
        } else {
            self.compliance.stiffness(response, steepest);
            state.products += 1;
        }
        self.restrict(pressure, gap, steepest);
        let product = dot(response, steepest);
        let change = product - dot(steepest, last_gap);
        let weight =
            if state.last_product > 0.0 { (change / state.last_product).max(0.0) } else { 0.0 };
        for (t, z) in direction.iter_mut().zip(steepest.iter()) {
            *t = z + weight * *t;
        }
        self.restrict(pressure, gap, direction);
        if dot(response, direction) <= 0.0 {
            direction.copy_from_slice(steepest);
        }
        std::mem::swap(response, last_gap);
        state.last_product = product;
    }

    /// Makes a field an admissible direction of the pressure: away from the bounds only, and where
    /// the load is given with a sum of zero. Free cells compensate for the sum; their gap has zero
    /// mean, so the energy does not change to first order.
    fn restrict(&self, pressure: &[f64], gap: &[f64], field: &mut [f64]) {
        let (mut sum, mut free) = (0.0, 0_usize);
        for (k, value) in field.iter_mut().enumerate() {
            let is_free = self.is_free(pressure[k]);
            if !is_free && (*value * gap[k] <= 0.0 || !self.may_move(pressure[k], gap[k])) {
                *value = 0.0;
            }
            sum += *value;
            free += usize::from(is_free);
        }
        let mean = match self.held {
            Held::Total(_) => sum / free.max(1) as f64,
            Held::Level(_) => return,
        };
        for (value, _) in field.iter_mut().zip(pressure).filter(|(_, p)| self.is_free(**p)) {
            *value -= mean;
        }
    }

    /// Steps to the minimum along the direction and enforces the bounds.
    fn step(&mut self, state: &mut State) {
        self.compliance.displacement(&state.direction, &mut state.response);
        state.products += 1;
        let stiffness = dot(&state.response, &state.direction);
        let mut length =
            if stiffness > 0.0 { dot(&state.gap, &state.direction) / stiffness } else { 0.0 };
        if self.is_inside(state, length) {
            let steps = state.pressure.iter_mut().zip(&state.direction);
            steps.for_each(|(p, t)| *p -= length * t);
            let steps = state.displacement.iter_mut().zip(&state.response);
            steps.for_each(|(u, r)| *u -= length * r);
            state.energy -= 0.5 * length * length * stiffness;
            state.is_fresh = false;
            return;
        }
        state.before.copy_from_slice(&state.pressure);
        let energy = state.energy;
        for _ in 0..MOST_CUTS {
            let steps = state.before.iter().zip(&state.direction);
            for (p, (before, t)) in state.pressure.iter_mut().zip(steps) {
                *p = before - length * t;
            }
            let direction = &state.direction;
            self.project(&mut state.pressure, |k| direction[k] != 0.0);
            self.move_surface(state);
            if state.energy <= energy + ROUNDING * energy.abs() {
                return;
            }
            length *= 0.5;
            // What was learned from earlier directions no longer holds.
            state.last_product = 0.0;
        }
        state.is_plain = !state.is_plain;
    }

    /// Whether a step leaves all cells that it moves within the bounds.
    fn is_inside(&self, state: &State, length: f64) -> bool {
        let mut steps = state.pressure.iter().zip(&state.direction);
        steps.all(|(p, t)| *t == 0.0 || self.is_free(p - length * t))
    }

    /// Moves the pressure of the moving cells to the nearest one that is within the bounds and
    /// carries the load, if that is given: q minus a common shift for all of these cells, clipped
    /// at the bounds.
    ///
    /// The load is a piecewise linear, decreasing function of the shift: Newton's method within a
    /// bracket.
    fn project(&self, pressure: &mut [f64], moves: impl Fn(usize) -> bool) {
        let less = match self.held {
            Held::Total(total) => self.shift(total, pressure, &moves),
            Held::Level(_) => 0.0,
        };
        for (k, p) in pressure.iter_mut().enumerate() {
            if moves(k) {
                *p = (*p - less).clamp(0.0, self.hardness);
            }
        }
    }

    /// The common shift.
    fn shift(&self, total: f64, pressure: &[f64], moves: impl Fn(usize) -> bool) -> f64 {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut less = 0.0;
        for _ in 0..MOST_ROUNDS {
            let (mut sum, mut free) = (0.0, 0_usize);
            for (k, p) in pressure.iter().enumerate() {
                let p = if moves(k) { p - less } else { *p };
                sum += p.clamp(0.0, self.hardness);
                free += usize::from(self.is_free(p));
            }
            let excess = sum - total;
            if excess.abs() <= ROUNDING * total {
                break;
            }
            if excess > 0.0 {
                low = less;
            } else {
                high = less;
            }
            let newton = less + excess / free.max(1) as f64;
            let middle = 0.5 * (low + high);
            let is_within = newton > low && newton < high && free > 0;
            less = if is_within || !middle.is_finite() { newton } else { middle };
        }
        less
    }

    /// Scales the pressure of another load to this one.
    fn scale_to_the_load(&self, total: f64, pressure: &mut [f64]) {
        let factor = total / pressure.iter().sum::<f64>();
        let in_contact = pressure.iter().filter(|p| **p > 0.0).count() as f64;
        if factor.is_finite() && total < self.hardness * in_contact {
            let was: Vec<bool> = pressure.iter().map(|p| *p > 0.0).collect();
            for p in pressure.iter_mut() {
                *p *= factor;
            }
            self.project(pressure, |k| was[k]);
        } else {
            // The cells in contact cannot carry it.
            pressure.fill(total / pressure.len() as f64);
        }
    }

    /// Scales a pressure to the least energy that it can have at this level.
    fn scale_to_the_level(&mut self, level: f64, state: &mut State) {
        self.move_surface(state);
        let overlap =
            level * state.pressure.iter().sum::<f64>() - dot(&state.pressure, self.distance);
        let factor = overlap / dot(&state.pressure, &state.displacement);
        if factor.is_finite() && factor > 0.0 {
            state.pressure.iter_mut().for_each(|p| *p = (factor * *p).min(self.hardness));
        }
    }
}

/// Maximum number of iterations to meet the load, and of halvings of a step.
const MOST_ROUNDS: usize = 100;
const MOST_CUTS: usize = 6;

/// Relative increase of the energy that may be due to rounding error.
const ROUNDING: f64 = 1e-13;

impl State {
    fn new(pressure: Vec<f64>) -> Self {
        let count = pressure.len();
        let zeros = || vec![0.0; count];
        Self {
            pressure,
            displacement: zeros(),
            is_fresh: false,
            gap: zeros(),
            level: 0.0,
            energy: 0.0,
            direction: zeros(),
            response: zeros(),
            steepest: zeros(),
            last_gap: zeros(),
            last_product: 0.0,
            is_plain: false,
            before: zeros(),
            products: 0,
        }
    }
}
