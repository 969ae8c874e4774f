//! Friction in steady rolling, as a function of traction and slip: the heat in a cell is what the
//! cells upstream of it and the cell itself release now; Eqs. (17)–(23).
//!
//! Each cell multiplies its traction by the mean slip over the cell, so rigid slip works with the
//! whole force, and the elastic parts cancel: the integral of the friction power is the power of
//! the creep forces. The heat is released uniformly along the path through the cell.
//!
//! In slow rolling the temperatures are those of conduction in all directions
//! ([`ContactConduction`]), which couples all cells; then the weights of the upstream cells in a
//! strip only serve as a preconditioner.

mod changes;

use std::ops::Range;

use crate::bodies::Kinematics;
use crate::interface::YieldLimit;
use crate::interface::friction::{FrictionResponse, FrictionState};
use crate::interface::heat::Conduction;
use crate::interface::heat::contact_conduction::{Conductors, ContactConduction, Surfaces};
use crate::interface::heat::strip_heat::StripHeat;
use crate::normal::patch::Patch;
use crate::numerics::root::fixed_point;
use crate::numerics::vector::add_scaled;
use crate::problem::Problem;
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::passage;
use crate::solver::rolling::shared::passage::{
    flux_over_heat, pair, paths_through, rigid_velocity, slip, speed_of,
};

use super::lag::{FrictionInput, Lag};
use super::yielding::{FlowCause, Yielding};

pub(super) use changes::{Change, FrictionCause};

/// Slip, heat, temperature and friction of every cell, and their tangent.
pub(super) struct SteadyFriction {
    /// Whether friction depends on temperature or slip speed at all.
    pub is_coupled: bool,
    kinematics: Kinematics,
    spacing: f64,
    pub conduction: Conduction,
    pub heat: StripHeat,
    /// Ratio of the heat flux along the path through a cell to its friction power, dimensionless.
    flux_over_power: Vec<f64>,
    /// Rigid slip velocity of each cell, in m/s.
    rigid: Vec<[f64; 2]>,
    pressure: Vec<f64>,
    /// Traction of the last evaluation, in Pa.
    traction: Vec<f64>,
    /// Slip velocity, in m/s.
    pub slip: Vec<[f64; 2]>,
    /// Friction power over area, in W/m².
    pub power: Vec<f64>,
    /// Temperature rise times effusivity, in W √s/m².
    pub scaled_rise: Vec<f64>,
    /// Response of the law in each cell.
    pub response: Vec<FrictionResponse>,
    /// The resulting coefficients.
    pub lag: Lag,
    /// The layer between the surfaces, if it may flow.
    yielding: Option<Yielding>,
    /// Bodies in which heat also flows along the surface, if this matters.
    conductors: Option<Conductors>,
    /// Their conduction, once requested.
    conduction_along: Option<Box<ContactConduction>>,
    /// Changes of the rise times effusivity, a buffer, in W √s/m².
    risen: Vec<f64>,
}

impl SteadyFriction {
    /// Friction of a patch; [`Self::set_problem`] sets the laws.
    pub fn new(problem: &Problem, patch: &Patch) -> Self {
        let cells = patch.len();
        let spacing = patch.grid.spacing_x;
        Self {
            is_coupled: false,
            kinematics: problem.kinematics,
            spacing,
            conduction: problem.interface.conduction(&problem.kinematics),
            heat: StripHeat::new(patch),
            flux_over_power: paths(patch).map(|paths| flux_over_heat(spacing, paths)).collect(),
            rigid: vec![[0.0; 2]; cells],
            pressure: patch.cells.iter().map(|cell| cell.pressure).collect(),
            traction: vec![0.0; 2 * cells],
            slip: vec![[0.0; 2]; cells],
            power: vec![0.0; cells],
            scaled_rise: vec![0.0; cells],
            response: vec![FrictionResponse::default(); cells],
            lag: Lag::new(cells),
            yielding: None,
            conductors: None,
            conduction_along: None,
            risen: vec![0.0; cells],
        }
    }

    /// Switches to another motion, and other friction and heat laws.
    pub fn set_problem(&mut self, problem: &Problem, contact: &DiscreteContact) {
        let patch = &contact.patch;
        self.is_coupled = !problem.interface.has_constant_bound();
        self.yielding = Yielding::new(problem.interface.layer, patch);
        self.conduction = problem.interface.conduction(&problem.kinematics);
        self.kinematics = problem.kinematics;
        self.conductors = conductors_along(problem, patch);
        if self.is_coupled {
            self.prepare_conduction(patch);
        }
        self.lag.set_problem(problem, patch);
        for (rigid, cell) in self.rigid.iter_mut().zip(&patch.cells) {
            *rigid = rigid_velocity(&problem.kinematics, cell);
        }
        let speed = problem.kinematics.speed;
        if let Some(change) = contact.pressed_in_passing() {
            for (k, rigid) in self.rigid.iter_mut().enumerate() {
                *rigid = slip(*rigid, speed / self.spacing, pair(&change, k));
            }
        }
        let durations = paths(patch).map(|[before, after]| [before, before + after]);
        let durations = durations.map(|paths| paths.map(|path| path / speed));
        self.heat.set(problem.interface.heat.model.as_ref(), durations);
        self.scaled_rise.fill(0.0);
        if self.is_coupled && self.conductors.is_some() {
            self.weigh_upstream();
            self.power.fill(0.0);
            self.conduct();
        }
        for k in 0..self.heat.len() {
            self.slip[k] = [0.0; 2];
            self.respond(problem, patch, k);
        }
    }

    /// Conduction along the surface, if it matters.
    fn prepare_conduction(&mut self, patch: &Patch) {
        let ready = self.conduction_along.as_ref().map(|conduction| conduction.conductors);
        if ready != self.conductors {
            let new = |conductors| Box::new(ContactConduction::new(patch, conductors));
            self.conduction_along = self.conductors.map(new);
        }
    }

    /// The weights of the upstream cells if heat also flows along the surface.
    fn weigh_upstream(&mut self) {
        let Some(conduction) = &self.conduction_along else { return };
        let over_factor = self.conduction.contact_factor().recip();
        let over_power = &self.flux_over_power;
        self.heat.replace_weights(|columns, j| {
            over_factor * conduction.downstream(columns) / over_power[j]
        });
    }

    /// Rises due to the friction power, if heat also flows along the surface: those that give the
    /// contact temperature of that conduction.
    fn conduct(&mut self) {
        let heat = self.released();
        let Some(conduction) = &mut self.conduction_along else { return };
        conduction.contact_rise(&heat, &mut self.scaled_rise);
        let (entry, factor) = (self.conduction.entry_temperature, self.conduction.contact_factor());
        for (scaled_rise, unheated) in self.scaled_rise.iter_mut().zip(&conduction.unheated) {
            *scaled_rise = (unheated + *scaled_rise - entry) / factor;
        }
    }

    /// Heat released in the cells, in W/m².
    fn released(&self) -> Vec<f64> {
        self.power.iter().map(|power| passage::heat(*power)).collect()
    }

    /// Both surfaces at the last evaluation, if heat also flows along them.
    pub fn surfaces(&mut self, patch: &Patch) -> Option<Surfaces> {
        let heat = self.released();
        let conduction = self.conduction_along.as_mut().filter(|_| self.conductors.is_some());
        conduction.map(|conduction| conduction.surfaces(patch, &heat))
    }

    /// Derivative of the contact temperature at constant friction power with respect to the
    /// logarithm of v0/(ωR) or of the patch size, in K; `None` if heat flows perpendicular to the
    /// surface only.
    pub fn contact_temperature_by(
        &self,
        problem: &Problem,
        patch: &Patch,
        scaling: Scaling,
    ) -> Option<Vec<f64>> {
        let conductors = self.conductors.filter(|_| self.is_coupled)?;
        let heat = self.released();
        let at = |change: f64| {
            let conductors = scaling.of(problem, conductors, change);
            let mut conduction = ContactConduction::new(patch, conductors);
            let mut rise = vec![0.0; heat.len()];
            conduction.contact_rise(&heat, &mut rise);
            add_scaled(&mut rise, 1.0, &conduction.unheated);
            rise
        };
        // The logarithm, for central differences.
        let difference = f64::EPSILON.cbrt();
        let (mut change, less) = (at(difference), at(-difference));
        add_scaled(&mut change, -1.0, &less);
        for change in &mut change {
            *change /= 2.0 * difference;
        }
        Some(change)
    }

    /// The arguments of the law in a cell, and for the material that enters at its y.
    pub fn states(&self, problem: &Problem, patch: &Patch, k: usize) -> [FrictionState; 2] {
        let y = patch.cells[k].y;
        let given = [[self.scaled_rise[k], speed_of(self.slip[k])], [0.0; 2]];
        given.map(|[scaled_rise, slip]| {
            problem.interface.friction_state(&self.conduction, scaled_rise, slip, y)
        })
    }

    fn respond(&mut self, problem: &Problem, patch: &Patch, k: usize) {
        let slip_speed = speed_of(self.slip[k]);
        let y = patch.cells[k].y;
        let response = problem.interface.friction_response(
            &self.conduction,
            self.scaled_rise[k],
            slip_speed,
            y,
        );
        let (durations, is_first) = (self.heat.durations(k), k == self.heat.first(k));
        let input = FrictionInput { law: response.coefficient, slip_speed, durations, is_first };
        self.lag.pass(k, &input);
        self.response[k] = response;
        if let Some(yielding) = &mut self.yielding {
            let slips = durations.map(|duration| slip_speed * duration);
            yielding.pass(k, is_first, self.lag.coefficient[k], slips);
        }
    }

    /// Slip, heat, temperature and friction for the traction p, where `change` is the change of A p
    /// while a material point passes each cell, in m.
    pub fn evaluate(&mut self, problem: &Problem, patch: &Patch, p: &[f64], change: &[f64]) {
        self.traction.copy_from_slice(p);
        let is_along = self.conductors.is_some();
        let per_length = self.kinematics.speed / self.spacing;
        for k in 0..self.heat.len() {
            self.slip[k] = slip(self.rigid[k], per_length, pair(change, k));
            self.power[k] = passage::power(pair(p, k), self.slip[k]);
            self.heat.flux[k] = passage::heat(self.power[k]) * self.flux_over_power[k];
        }
        if is_along {
            self.prepare_conduction(patch);
            self.conduct();
        }
        for k in 0..self.heat.len() {
            if !is_along {
                self.warm(k);
                self.heat.weigh_about_present(k);
            }
            self.respond(problem, patch, k);
        }
    }

    /// Scales the tractions p of rigid bodies with some bounds μ pₙ (both in Pa), cell by cell down
    /// the strips, to the friction at the slip and the temperature that result. Cells upstream of
    /// those in `kept` have the coefficient of the first one in it.
    pub fn rigid_slip_state(
        &mut self,
        (problem, patch): (&Problem, &Patch),
        kept: &[Range<usize>],
        bound: &[f64],
        p: &mut [f64],
    ) {
        self.slip.copy_from_slice(&self.rigid);
        for cells in kept {
            let mut coefficient = problem.interface.friction.cold_coefficient();
            for k in cells.clone() {
                let over = if bound[k] > 0.0 { bound[k].recip() } else { 0.0 };
                let along = pair(p, k).map(|p| over * p);
                let alike = if k == cells.start { self.heat.first(k)..=k } else { k..=k };
                coefficient = fixed_point(coefficient, |coefficient| {
                    for j in alike.clone() {
                        let heat = passage::heat(passage::power(along, self.rigid[j]));
                        let flux = self.pressure[j] * heat * self.flux_over_power[j];
                        self.heat.flux[j] = coefficient * flux;
                        self.warm(j);
                        self.respond(problem, patch, j);
                    }
                    self.coefficients()[k]
                });
                for c in 0..2 {
                    p[2 * k + c] = coefficient * self.pressure[k] * along[c];
                }
            }
        }
    }

    /// Rise of a cell due to the heat from upstream and its own, conducted perpendicular to the
    /// surface.
    fn warm(&mut self, k: usize) {
        let inherited = self.heat.inherited(k);
        self.scaled_rise[k] = self.heat.scaled_rise(k, inherited, self.heat.flux[k]);
    }

    /// What bounds the tractions over the pressure, dimensionless: the coefficient of friction, or
    /// less where the layer between the surfaces flows.
    pub fn coefficients(&self) -> &[f64] {
        self.yielding.as_ref().map_or(&self.lag.coefficient, |yielding| &yielding.coefficient)
    }

    /// −∂μ/∂(slip speed) in cell `k` at y (in m), in s/m, at a slip speed (in m/s) and the
    /// temperature of the last evaluation, of material that some time ago (in s) had the friction
    /// of rest.
    pub fn fall(&self, problem: &Problem, (k, y): (usize, f64), speed: f64, duration: f64) -> f64 {
        let law =
            problem.interface.friction_response(&self.conduction, self.scaled_rise[k], speed, y);
        let Some(memory) = problem.interface.friction_memory() else { return -law.by_slip_speed };
        let kept = memory.kept(speed, duration);
        let at_rest = problem.interface.entry_friction(&self.conduction, y).coefficient;
        let faded = (at_rest - law.coefficient) * kept.by_slip_speed;
        -(1.0 - kept.part) * law.by_slip_speed - faded
    }

    /// Whether the layer bounds the traction of a cell, and not friction.
    pub fn yields(&self, k: usize) -> bool {
        self.yielding.as_ref().is_some_and(|yielding| yielding.yields(k))
    }

    /// Change of the bound of a cell (in Pa) with the limit of elasticity of the layer, at the same
    /// slip.
    pub fn bound_by_limit(&self, k: usize, limit: YieldLimit) -> f64 {
        let cause = FlowCause { friction: 0.0, slips: [0.0; 2], limit };
        let yielding = self.yielding.as_ref();
        self.pressure[k] * yielding.map_or(0.0, |yielding| yielding.change(k, &cause, &mut 0.0))
    }

    /// The plastic displacement of the layer (in m) with which the material leaves a cell.
    pub fn flowed_on_leaving(&self, k: usize) -> f64 {
        self.yielding.as_ref().map_or(0.0, |yielding| yielding.on_leaving(k))
    }

    /// ∂μ/∂(rise times effusivity), in m²/(W √s).
    fn by_rise(&self, k: usize) -> f64 {
        self.response[k].by_temperature * self.conduction.contact_factor()
    }
}

/// The paths of the material in every cell of a patch; see [`paths_through`].
fn paths(patch: &Patch) -> impl Iterator<Item = [f64; 2]> {
    let cells = patch.strips.iter().flat_map(|strip| strip.cells.clone().map(move |k| (strip, k)));
    cells.map(|(strip, k)| paths_through(patch, strip, k))
}

/// The conducting bodies of a problem if heat also flows along the surface.
fn conductors_along(problem: &Problem, patch: &Patch) -> Option<Conductors> {
    let peclet = problem.interface.peclet(&problem.kinematics, patch.grid.semi_axes());
    let is_conduction =
        problem.interface.heat.model.as_ref().is_some_and(|model| model.is_conduction());
    (is_conduction && !peclet.is_fast()).then(|| Conductors {
        conduction: problem.interface.conduction(&problem.kinematics),
        materials: [problem.interface.wheel.material, problem.interface.rail.material],
        speed: problem.kinematics.speed,
        scale: 1.0,
    })
}

/// The quantity that is scaled when heat flows along the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scaling {
    /// v0/(ωR).
    ContactTime,
    /// All lengths of the patch.
    Size,
}

impl Scaling {
    /// The conducting bodies after a change of the logarithm.
    fn of(self, problem: &Problem, conductors: Conductors, change: f64) -> Conductors {
        if self == Self::Size {
            return Conductors { scale: change.exp(), ..conductors };
        }
        let motion = problem.kinematics.with_contact_time_ratio(change);
        let conduction = problem.interface.conduction(&motion);
        Conductors { conduction, ..conductors }
    }
}
