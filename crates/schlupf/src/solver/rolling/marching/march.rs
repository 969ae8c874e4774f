//! Marching in time: everything that changes from step to step.

mod records;
mod equilibrium;
mod at_rest;
mod result;

use crate::bodies::Kinematics;
use crate::normal::{NormalContact, VectorField};
use crate::numerics::vector::norm;
use crate::problem::{
    Element, History, Options, Problem, State, Stretch, Transient, part_too_short,
};
use crate::reporting::{Error, Quantity, Watch, tell, within};
use crate::solution::{FieldsAt, Instant, Solution, Strategy, Work};
use crate::solver::equilibrium::{Newton, Outcome, measure};
use crate::solver::reference_point::AtPatch;
use crate::solver::rolling::shared::contact::{DiscreteContact, Former};
use crate::solver::rolling::shared::passage::{Passage, speed_of};
use crate::solver::settings;
use crate::solver::summary::snapshot::Snapshot;

use super::arrival::{Arrival, carry_over, positions};
use super::change::{largest_change, relative_change};
use super::forces_over_time::ForcesOverTime;
use super::friction_heat::{FrictionPoint, remember, set_temperatures};
use super::initial_state::{check_length, fitting, grid_over_history, on_patch};
use super::moved::Moved;
use super::past::Past;
use super::step_power::{Start, StepPower};
use super::time_step::{TimeStepLaw, calibrate};

/// Solves a problem by marching: to the end of its history, or to the steady state.
///
/// ```
/// use schlupf::problem::History;
/// use schlupf::solver::march;
/// use schlupf::{Options, Problem, Transient, unwatched};
///
/// let (time, creepage_x) = (vec![0.0, 1e-3], Some(vec![0.0, 0.002]));
/// let history = History { time, creepage_x, ..History::default() };
/// let problem = Problem::builder().build()?;
/// let braking = Transient { history, ..Transient::to_steady_state(&problem) };
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let solution = march(&braking, &options, &unwatched)?;
/// assert!(solution.history.iter().all(|instant| instant.force.x <= 0.0));
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Whatever [`Transient::check`] and [`Options::check`] reject, a state that does not fit, and
/// [`Error::Stopped`].
pub fn march(transient: &Transient, options: &Options, watch: Watch) -> Result<Solution, Error> {
    march_from(transient, None, options, watch)
}

/// The same where the initial state was left under another pressure, in the same contact frame; the
/// grid is that of the state.
pub(crate) fn march_from(
    transient: &Transient,
    before: Option<&NormalContact>,
    options: &Options,
    watch: Watch,
) -> Result<Solution, Error> {
    transient.check()?;
    options.check()?;
    let prescribed = transient.problem.prescribed;
    let at = AtPatch::new(&transient.problem.without_forces(), watch)?;
    let transient = at.transient(transient);
    transient.check()?;
    let stretches = transient.history.stretches();
    let mut march = March::new(&transient, before, options)?;
    let (forces, normal) = ((&prescribed, stretches.as_slice()), &march.contact.normal);
    march.forces = ForcesOverTime::new(march.problem, forces, (normal, at.place()))?;
    check_length(&transient, march.contact.patch.grid.spacing_x)?;
    for stretch in stretches {
        march.begin(&stretch);
        if let Some(shift) = &stretch.shift {
            march.shift(shift, watch)?;
            tell(watch, march.progress())?;
        }
        let before = march.distance;
        while !march.is_finished() {
            march.roll(watch)?;
            tell(watch, march.progress())?;
        }
        let span = march.history.span();
        if march.distance <= before && span[0] < span[1] {
            return Err(part_too_short(span, (march.duration(), options.cells_x)));
        }
    }
    Ok(at.back(march.into_solution()))
}

/// Presses the two bodies of a problem together and shifts the wheel over the rail by `shift`
/// (along and across rolling, in m), in one step: a history of one row.
///
/// The bodies do not roll: creepages and spin of the problem are ignored, and those of the solution
/// are zero, as is its speed. As a shift has no duration, there is no slip velocity, no friction
/// power and no heat; friction is that at the temperature at which the bodies meet. The sliding
/// distance of each element, in m, is in the solution's state, from which marching can continue.
///
/// ```
/// use schlupf::solver::shift;
/// use schlupf::{Options, Problem, unwatched};
///
/// let problem = Problem::builder().load(80e3).build()?;
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let solution = shift(&problem, [1e-3, 0.0], &options, &unwatched)?;
/// // A millimetre is far more than sticks: friction is all there is.
/// assert!((solution.force.x + 0.4 * 80e3).abs() < 1e-3 * 80e3);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// A shift that is not finite, whatever [`Problem::check`] and [`Options::check`] reject, and
/// [`Error::Stopped`].
pub fn shift(
    problem: &Problem,
    shift: [f64; 2],
    options: &Options,
    watch: Watch,
) -> Result<Solution, Error> {
    let [shift_x, shift_y] = shift.map(|shift| Some(vec![shift]));
    let history = History { time: vec![0.0], shift_x, shift_y, ..History::default() };
    let transient = Transient { history, ..Transient::to_steady_state(problem) };
    march(&transient, options, watch)
}

/// Everything that changes from step to step.
struct March<'a> {
    problem: &'a Problem,
    /// The whole history.
    whole: &'a History,
    /// The present part, in which the wheel rolls throughout.
    history: History,
    /// Whether the pressure is that of before.
    has_other_pressure: bool,
    options: &'a Options,
    contact: DiscreteContact,
    law: TimeStepLaw,
    /// Change of the traction in the last step, if it was found and more than noise, in Pa.
    trend: Vec<f64>,
    forces: ForcesOverTime,
    /// The first step that did not end with the prescribed forces: what, and its end in s.
    missed: Option<(Quantity, f64)>,
    /// A p of the present traction and the displacement under the pressure on the whole grid, in m.
    displacement: VectorField,
    /// That of the bodies alone: how the material is displaced that enters.
    displacement_of_bodies: VectorField,
    time: f64,
    /// The time of the history whose values hold, in s: where a part ends within half a cell, its
    /// last.
    place: f64,
    /// Rolled since the start, in m.
    distance: f64,
    now: Snapshot,
    /// Mean motion over the step before.
    motion_before: Kinematics,
    /// The elements, in the order of the patch.
    elements: Vec<Element>,
    past: Past,
    /// What the material did in the last step.
    moved: Vec<Moved>,
    newton: Newton,
    outcome: Outcome,
    /// Powers over the last step.
    powers: Option<StepPower>,
    /// Largest ‖p‖₂ so far, in Pa.
    largest_traction: f64,
    /// Relative change in traction and temperature in the last step.
    change: f64,
    /// The same over the last passage of the material through the whole patch.
    passage_change: f64,
    /// The largest change in one step of the present passage.
    largest_step: f64,
    /// Traction and temperature rises one passage ago.
    passage_start: [Vec<f64>; 2],
    worst_residual: f64,
    /// Cells in the longest strip: fewest and most of all instants.
    strip_lengths: [usize; 2],
    /// Of all instants, in Pa.
    largest_pressure: f64,
    /// Number of successive time steps whose equilibrium was not found.
    failures: usize,
    work: Work,
    instants: Vec<Instant>,
    field_history: Vec<FieldsAt>,
}

impl<'a> March<'a> {
    fn new(
        transient: &'a Transient,
        before: Option<&NormalContact>,
        options: &'a Options,
    ) -> Result<Self, Error> {
        let Transient { problem, history: whole, initial_state } = transient;
        let Stretch { shift, rolling: history } = whole.stretches().swap_remove(0);
        let are_apart = shift.is_some() && initial_state.is_none();
        let [start, _] = history.span();
        let (grid, normal) = if let (Some(before), Some(state)) = (before, initial_state) {
            (state.grid, before.clone())
        } else {
            let normal = problem.normal.normal_contact(history.load(start))?;
            (grid_over_history(transient, options)?, normal)
        };
        let mut contact = DiscreteContact::new(problem, &normal, grid)?;
        contact.require_rows()?;
        let law = TimeStepLaw::of(problem, &normal, &mut contact)?;
        let state = match initial_state {
            Some(state) => fitting(state, &grid)?,
            None => State::at_rest(&contact.patch),
        };
        let time = if history.is_endless() { state.time } else { start };
        let kinematics = history.kinematics(time, &problem.kinematics);
        let conduction = problem.interface.conduction(&kinematics);
        let elements = on_patch(&contact.patch, &state.elements);
        let mut march = Self {
            problem,
            whole,
            history,
            has_other_pressure: before.is_some(),
            options,
            time,
            place: time,
            distance: 0.0,
            now: Snapshot::blank(kinematics, conduction, contact.patch.len()),
            trend: vec![0.0; 2 * elements.len()],
            elements,
            motion_before: kinematics,
            past: Past::default(),
            moved: Vec::new(),
            newton: Newton::default(),
            outcome: Outcome::default(),
            powers: None,
            largest_traction: 0.0,
            change: f64::INFINITY,
            passage_change: f64::INFINITY,
            largest_step: 0.0,
            passage_start: [Vec::new(), Vec::new()],
            worst_residual: 0.0,
            missed: None,
            strip_lengths: [usize::MAX, 0],
            largest_pressure: 0.0,
            failures: 0,
            work: Work { strategy: Some(Strategy::March), ..Work::default() },
            instants: Vec::new(),
            field_history: Vec::new(),
            displacement: VectorField::zeros(grid.len()),
            displacement_of_bodies: VectorField::zeros(grid.len()),
            law,
            forces: ForcesOverTime::default(),
            contact,
        };
        march.now.traction = march.elements.iter().flat_map(|e| e.traction).collect();
        march.now.scaled_rise = march.elements.iter().map(|e| e.scaled_rise).collect();
        march.largest_traction = norm(&march.now.traction);
        march.now.over_step = state.motion.unwrap_or(kinematics);
        if !are_apart {
            march.displace();
        }
        march.past = march.record();
        Ok(march)
    }

    /// Goes on to the next part of the history, which begins now.
    fn begin(&mut self, stretch: &Stretch) {
        self.history = stretch.rolling.clone();
        [self.place, _] = self.history.span();
    }

    /// A step in which the wheel rolls over one cell. Every part of a history ends with the step
    /// whose end is nearest.
    fn roll(&mut self, watch: Watch) -> Result<(), Error> {
        let mut start = Start::of(&self.displacement, &self.contact, &self.now);
        let arrivals = self.move_on(&mut start, watch)?;
        self.find_equilibrium(&arrivals, false, watch)?;
        self.heat_up(&arrivals, &start);
        self.note(None);
        Ok(())
    }

    /// Of a step over one cell, in s.
    fn duration(&self) -> f64 {
        let spacing = self.contact.patch.grid.spacing_x;
        self.history.duration(self.time, spacing, &self.problem.kinematics)
    }

    fn is_finished(&self) -> bool {
        if !self.history.is_endless() {
            let [_, end] = self.history.span();
            return self.time >= end || self.time + 0.5 * self.duration() >= end;
        }
        let is_steady = self.passage_change <= self.options.tolerance;
        is_steady
            || self.failures >= settings::steps_lost()
            || self.work.steps >= self.options.max_steps
    }

    /// At the end of a passage, compares with its start. The remaining change is about as large as
    /// that of a passage, but many times that of a step.
    fn compare_passages(&mut self) {
        self.largest_step = self.largest_step.max(self.change);
        let longest = self.contact.patch.strips.iter().map(|s| s.cells.len()).max().unwrap_or(1);
        if !self.work.steps.is_multiple_of(longest) {
            return;
        }
        let [traction, scaled_rise] = &self.passage_start;
        if traction.len() == self.now.traction.len() {
            let scale = measure(norm(&self.now.bound(&self.contact.patch)), self.largest_traction);
            let warmed = largest_change(scaled_rise, &self.now.scaled_rise);
            let changed = relative_change(traction, &self.now.traction, scale);
            // An oscillation may return to the same values after a passage.
            self.passage_change = changed.max(warmed).max(self.largest_step);
        }
        self.largest_step = 0.0;
        self.passage_start = [self.now.traction.clone(), self.now.scaled_rise.clone()];
    }

    /// Carries every element over into the next cell; Eqs. (9)–(12).
    fn move_on(&mut self, start: &mut Start, watch: Watch) -> Result<Vec<Arrival>, Error> {
        let duration = self.duration();
        let (history, otherwise) = (&self.history, &self.problem.kinematics);
        self.motion_before = self.now.over_step;
        self.now.over_step = history.mean(self.time, self.time + duration, otherwise);
        self.time += duration;
        self.distance += self.contact.patch.grid.spacing_x;
        let [_, end] = history.span();
        let is_last = self.time + 0.5 * duration >= end;
        self.place = if is_last { self.time.max(end) } else { self.time };
        self.now.kinematics = history.kinematics(self.place, otherwise);
        self.now.conduction = self.problem.interface.conduction(&self.now.over_step);
        start.former = self.follow_load(watch)?;
        let moves = start.former.is_some();
        let (contact, displacement) = (&self.contact, &self.displacement);
        let arrivals = carry_over(contact, displacement, &self.past, moves, &self.elements);
        self.stay_in_place();
        self.set_friction(&arrivals);
        Ok(arrivals)
    }

    /// Switches to the patch of a load that changes with time; returns the previous one.
    fn follow_load(&mut self, watch: Watch) -> Result<Option<Former>, Error> {
        let load = self.history.load(self.place);
        let stays = load.is_none_or(|load| load == self.contact.normal.load);
        if stays && !std::mem::take(&mut self.has_other_pressure) {
            return Ok(None);
        }
        self.problem.normal.prepare(load, &within(watch, self.progress()))?;
        let normal = self.problem.normal.normal_contact(load)?;
        let former = self.contact.set_normal(&normal)?;
        self.law = TimeStepLaw::of(self.problem, &normal, &mut self.contact)?;
        Ok(Some(former))
    }

    /// Quantities that stay in place while the material moves: the previous traction is the initial
    /// guess, and friction begins with the power and the slip there.
    fn stay_in_place(&mut self) {
        let patch = &self.contact.patch;
        let at = positions(patch, &self.elements);
        let blank = Snapshot {
            over_step: self.now.over_step,
            ..Snapshot::blank(self.now.kinematics, self.now.conduction, patch.len())
        };
        let old = std::mem::replace(&mut self.now, blank);
        let mut trend = vec![0.0; 2 * patch.len()];
        for (k, cell) in patch.cells.iter().enumerate() {
            let Some(e) = at[cell.index] else { continue };
            self.now.traction[2 * k..2 * k + 2].copy_from_slice(&old.traction_at(e));
            trend[2 * k..2 * k + 2].copy_from_slice(&self.trend[2 * e..2 * e + 2]);
            self.now.scaled_rise[k] = old.scaled_rise[e];
            self.now.friction[k] = old.friction.get(e).copied().unwrap_or(0.0);
            self.now.friction_power[k] = old.friction_power.get(e).copied().unwrap_or(0.0);
        }
        self.trend = trend;
    }

    /// Friction, Eq. (23), follows the temperature of the arriving element, including the heat that
    /// friction itself generates here now: both are found together.
    fn set_friction(&mut self, arrivals: &[Arrival]) {
        let hardens = self.problem.interface.layer.is_some_and(|layer| layer.hardening() > 0.0);
        let compliance = if hardens { self.contact.patch_compliance() } else { 0.0 };
        let patch = &self.contact.patch;
        let at = positions(patch, &self.elements);
        for strip in &patch.strips {
            for k in strip.cells.clone() {
                let cell = &patch.cells[k];
                let slip_speed = at[cell.index].map_or(0.0, |e| self.elements[e].slip_speed);
                let point = FrictionPoint {
                    friction: self.now.friction[k],
                    power: self.now.friction_power[k],
                    bound_power: cell.pressure * slip_speed,
                    slip_speed,
                };
                let passage = Passage::of(patch, strip, k);
                let bounding = (cell.pressure_where_covered(), compliance);
                self.now.friction[k] =
                    point.coefficient(self.problem, &self.now, &passage, &arrivals[k], bounding);
            }
        }
    }

    /// The record of the present instant.
    fn record(&self) -> Past {
        let mut past = Past::of(&self.contact, [&self.displacement, &self.displacement_of_bodies]);
        calibrate(&mut past, &self.law, &self.contact.patch, &self.now.traction);
        past
    }

    /// Friction power and temperatures, Eqs. (17)–(22).
    fn heat_up(&mut self, arrivals: &[Arrival], start: &Start) {
        let (contact, displacement) = (&self.contact, &self.displacement);
        start.set_friction_power(&mut self.now, contact, displacement);
        self.powers = Some(start.powers_until(&self.now, contact, displacement));
        let mut records: Vec<_> = arrivals.iter().map(|arrival| arrival.heat.to_vec()).collect();
        let patch = &self.contact.patch;
        let old_scaled_rise = self.now.scaled_rise.clone();
        set_temperatures(&mut self.now, patch, &self.problem.interface.heat, &mut records);
        for (k, (element, record)) in self.elements.iter_mut().zip(records).enumerate() {
            element.heat = record.into();
            element.scaled_rise = self.now.scaled_rise[k];
            element.slip_speed = speed_of(self.now.slip[k]);
        }
        self.change = self.change.max(largest_change(&old_scaled_rise, &self.now.scaled_rise));
        let patch = &self.contact.patch;
        remember(self.problem, &self.now, patch, &mut self.elements, arrivals);
        self.law.contact.slaved.copy(&mut self.now.friction);
        self.law.take_slip(&self.moved, self.now.kinematics.speed, &mut self.now.slip);
    }
}
