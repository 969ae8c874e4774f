//! What is to be solved ([`Problem`], the physics) and how ([`Options`], the numerics).

mod prescribed_forces;
mod history;
pub mod look_up_table;
mod method;
mod state;
mod builder;
mod transient;

pub use builder::ProblemBuilder;
pub use history::History;
pub use method::{
    AreaReduction, Brush, FastMethod, Flexibilities, Method, SharedTable, SlopeReduction,
    TractionBound,
};
pub use prescribed_forces::{Direction, LongitudinalForce, PrescribedForces};
pub(crate) use state::MOST_PLACES;
pub use state::{Element, HeatRecord, Places, State, TrackPoint};
pub use transient::Transient;

use std::sync::Arc;

use crate::bodies::{Body, Kinematics, Material, ReferencePoint, contact_modulus};
use crate::elasticity::Elasticity;
use crate::interface::friction::memory::FrictionMemory;
use crate::interface::friction::{Friction, FrictionResponse, FrictionState};
use crate::interface::heat::Heat;
use crate::interface::heat::partition::Conduction;
use crate::interface::heat::peclet::Peclet;
use crate::interface::{ContactLaw, ThirdBodyLayer};
use crate::normal::PressureSource;
use crate::normal::patch::Cell;
use crate::reporting::{Error, Quantity, Requirement, Warning, require};

/// A rolling contact: two bodies, their motion, and the laws of their interaction.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Speed and creepages. A creepage whose force is prescribed is only a first guess.
    pub kinematics: Kinematics,
    /// Forces in place of creepages.
    pub prescribed: PrescribedForces,
    /// Reference point of the creepages and of the moment of the solution.
    pub reference: ReferencePoint,
    /// The wheel.
    pub wheel: Body,
    /// The rail.
    pub rail: Body,
    /// Source of the normal pressure.
    pub normal: Arc<dyn PressureSource>,
    /// Elastic deformation of the bodies under tangential traction.
    pub elasticity: Arc<dyn Elasticity>,
    /// The layer between the surfaces, if there is one.
    pub layer: Option<ThirdBodyLayer>,
    /// Dependence of the traction of a point on its sliding, Eq. (8).
    pub contact_law: ContactLaw,
    /// Coefficient of friction, Eq. (23).
    pub friction: Friction,
    /// Frictional heating, Eqs. (17)–(22).
    pub heat: Heat,
}

impl Problem {
    /// The same with all creepages given.
    pub(crate) fn without_forces(&self) -> Self {
        Self { prescribed: PrescribedForces::default(), ..self.clone() }
    }

    /// Compliance h/G of the layer between the surfaces (in m/Pa); zero if there is none.
    pub fn layer_compliance(&self) -> f64 {
        self.layer.map_or(0.0, |layer| layer.compliance())
    }

    /// What bounds the traction over the pressure in a cell (dimensionless) with a coefficient of
    /// friction and a layer that has not flowed yet.
    pub(crate) fn at_entry(&self, friction: f64, cell: &Cell) -> f64 {
        let pressure = cell.pressure_where_covered();
        self.layer.map_or(friction, |layer| {
            layer.pass(friction * pressure, 0.0, [0.0; 2]).bound / pressure
        })
    }

    /// Whether nothing that changes within the contact changes what bounds the traction.
    pub(crate) fn has_constant_bound(&self) -> bool {
        self.friction.law.is_constant() && !self.layer.is_some_and(|layer| layer.hardens())
    }

    /// A warning of a largest pressure (in Pa) that no body can bear.
    pub fn beyond_elastic(&self, pressure: f64) -> Option<Warning> {
        beyond_elastic([&self.wheel.material, &self.rail.material], pressure)
    }

    /// Heat partition and conduction of the two bodies at the speeds of `kinematics`.
    pub fn conduction(&self, kinematics: &Kinematics) -> Conduction {
        Conduction::new(&self.heat.partition, &self.wheel, &self.rail, kinematics)
    }

    /// Péclet numbers of the two bodies passing, at the speeds of `kinematics`, through a contact
    /// of semi-axes a and b (in m).
    pub fn peclet(&self, kinematics: &Kinematics, semi_axes: [f64; 2]) -> Peclet {
        let wheel_speed = kinematics.speed / self.conduction(kinematics).contact_time_ratio();
        let diffusivities = [&self.wheel, &self.rail].map(|body| body.material.diffusivity());
        Peclet::new(semi_axes, [wheel_speed, kinematics.speed], diffusivities)
    }

    /// Friction in a cell at y (in m) with a temperature rise times effusivity (in W √s/m²) and a
    /// slip speed (in m/s), Eq. (23).
    pub fn friction_response(
        &self,
        conduction: &Conduction,
        rise_times_effusivity: f64,
        slip_speed: f64,
        y: f64,
    ) -> FrictionResponse {
        let state = self.friction_state(conduction, rise_times_effusivity, slip_speed, y);
        self.friction.law.respond(&state)
    }

    /// The arguments of the friction law there.
    pub fn friction_state(
        &self,
        conduction: &Conduction,
        rise_times_effusivity: f64,
        slip_speed: f64,
        y: f64,
    ) -> FrictionState {
        let temperature = conduction.contact_temperature(rise_times_effusivity)
            - self.friction.reference_temperature;
        FrictionState { temperature, slip_speed, y }
    }

    /// Friction of material at y (in m) when it enters the contact.
    pub fn entry_friction(&self, conduction: &Conduction, y: f64) -> FrictionResponse {
        self.friction_response(conduction, 0.0, 0.0, y)
    }

    /// The coefficient of friction (dimensionless), if it is the same everywhere within a distance
    /// from the middle across rolling (in m), whatever the motion.
    pub(crate) fn uniform_friction(&self, width: f64) -> Option<f64> {
        /// Places on either side of the middle that are compared.
        const PLACES: i32 = 8;
        let (cold, law) = (self.friction.cold_coefficient(), &self.friction.law);
        let conduction = self.conduction(&self.kinematics);
        let mut places = (-PLACES..=PLACES).map(|k| width * f64::from(k) / f64::from(PLACES));
        let is_cold = |y| self.entry_friction(&conduction, y).coefficient == cold;
        let is_bounded = self.layer.is_none_or(|layer| layer.yield_limit().is_none());
        (law.is_constant() && is_bounded && places.all(is_cold)).then_some(cold)
    }

    /// How friction lags behind its law, if it depends on anything that changes within the contact.
    pub fn friction_memory(&self) -> Option<FrictionMemory> {
        self.friction.memory.filter(|_| !self.friction.law.is_constant())
    }

    /// Performs all checks possible before the patch is known.
    pub fn check(&self) -> Result<(), Error> {
        self.kinematics.check()?;
        self.prescribed.check()?;
        self.wheel.check_wheel()?;
        self.rail.check_rail()?;
        self.heat.check()?;
        self.friction.check(self.conduction(&self.kinematics).entry_temperature)
    }
}

/// Ratio of the largest pressure to E* above which even steel is no longer elastic: its hardness is
/// lower.
const YIELDING: f64 = 0.03;

/// A warning of a largest pressure (in Pa) that no body of one of two materials can bear.
pub fn beyond_elastic([one, other]: [&Material; 2], pressure: f64) -> Option<Warning> {
    let modulus = contact_modulus(one, other);
    (pressure > YIELDING * modulus).then_some(Warning::BeyondElastic { pressure, modulus })
}

/// Maximum number of cells in one direction across the patch.
pub const MAX_CELLS: usize = 1024;

/// Maximum number of cells of a grid.
pub const MAX_CELLS_TOGETHER: usize = 1 << 17;

/// Which steady state to find, if falling friction causes several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// The one reached when the creepages grow from zero.
    LowSlip,
    /// The one reached when larger creepages decrease.
    HighSlip,
}

/// Numerical options. No choice here changes the physics.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Which steady state, if there are several; only for steady states found directly.
    pub branch: Branch,
    /// Cells along rolling across the patch.
    pub cells_x: usize,
    /// Cells across rolling over the patch.
    pub cells_y: usize,
    /// Largest admissible residual ‖p − μ pₙ law‖₂ / ‖μ pₙ‖₂, dimensionless, with the friction at
    /// the temperatures found. Where ‖p‖₂ is less than a hundredth of ‖μ pₙ‖₂, a smaller reference
    /// replaces ‖μ pₙ‖₂: (100 ‖p‖₂)²/‖μ pₙ‖₂, and ‖p‖₂ itself below 1e-4 of it. Marching to the
    /// steady state ends when, in addition, the passage of material through the whole patch changes
    /// the traction by less than this, and the temperature by less than this fraction of its
    /// largest rise.
    pub tolerance: f64,
    /// Maximum number of Newton steps for one equilibrium.
    pub max_iterations: usize,
    /// Maximum number of time steps on the way to the steady state.
    pub max_steps: usize,
    /// A cell slides where |t| ≥ this · μ pₙ; dimensionless.
    pub slip_threshold: f64,
    /// Whether to compute the derivatives of the forces, too; only for steady states found
    /// directly.
    pub sensitivity: bool,
    /// Time steps of a march from one record of the fields to the next; 0: none but the last.
    pub fields_every: usize,
    /// Whether to extrapolate the forces from this grid and one half as fine, too; only for steady
    /// states found directly.
    pub extrapolate: bool,
    /// Whether a steady state that is found directly keeps the state of the material, from which a
    /// march can go on and the temperatures away from the cells follow. Leaving it out saves about
    /// a sixth of the time of a point of a creep curve.
    pub keeps_state: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            branch: Branch::LowSlip,
            cells_x: 24,
            cells_y: 24,
            tolerance: 1e-6,
            max_iterations: 200,
            max_steps: 2000,
            slip_threshold: 0.95,
            sensitivity: false,
            fields_every: 0,
            extrapolate: false,
            keeps_state: true,
        }
    }
}

impl Options {
    /// Checks that the numbers are usable.
    pub fn check(&self) -> Result<(), Error> {
        let between = |least: usize| Requirement::Between(least as f64, MAX_CELLS as f64);
        require(Quantity::CellsX, between(2), self.cells_x as f64)?;
        require(Quantity::CellsY, between(1), self.cells_y as f64)?;
        let (columns, rows) = (self.cells_x, self.cells_y);
        if columns * rows > MAX_CELLS_TOGETHER {
            return Err(Error::TooManyCells { columns, rows, most: MAX_CELLS_TOGETHER });
        }
        require(Quantity::Tolerance, Requirement::Between(1e-13, 0.1), self.tolerance)?;
        let at_least_one = Requirement::AtLeast(1.0);
        require(Quantity::MaxIterations, at_least_one, self.max_iterations as f64)?;
        require(Quantity::MaxSteps, at_least_one, self.max_steps as f64)?;
        require(Quantity::SlipThreshold, Requirement::Inside(0.0, 1.0), self.slip_threshold)
    }
}
