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
pub(crate) use history::{Shift, Stretch, part_too_short};
pub use method::{
    AreaReduction, Brush, Driver, FastMethod, Flexibilities, Method, SlopeReduction, TractionBound,
};
pub use prescribed_forces::{Direction, LongitudinalForce, PrescribedForces};
pub(crate) use state::MOST_PLACES;
pub use state::{Element, HeatRecord, Places, State, TrackPoint};
pub use transient::Transient;

use std::sync::Arc;

use crate::bodies::{Kinematics, ReferencePoint};
use crate::interface::Interface;
use crate::normal::PressureSource;
use crate::reporting::{Error, Quantity, Requirement, require};

/// A rolling contact: what presses two bodies together, how they move, and what acts between them.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Speed and creepages. A creepage whose force is prescribed is only a first guess.
    pub kinematics: Kinematics,
    /// Forces in place of creepages.
    pub prescribed: PrescribedForces,
    /// Reference point of the creepages and of the moment of the solution.
    pub reference: ReferencePoint,
    /// Which steady state, if there are several; only for steady states found directly.
    pub branch: Branch,
    /// Source of the normal pressure.
    pub normal: Arc<dyn PressureSource>,
    /// The two bodies and the laws of their interaction.
    pub interface: Interface,
}

impl Problem {
    /// The same with all creepages given.
    pub(crate) fn without_forces(&self) -> Self {
        Self { prescribed: PrescribedForces::default(), ..self.clone() }
    }

    /// The same with something else acting at the interface.
    #[must_use]
    pub fn with_interface(mut self, change: impl FnOnce(&mut Interface)) -> Self {
        change(&mut self.interface);
        self
    }

    /// The coefficient of friction (dimensionless), if it is the same everywhere within a distance
    /// from the middle across rolling (in m), whatever the motion.
    pub(crate) fn uniform_friction(&self, width: f64) -> Option<f64> {
        /// Places on either side of the middle that are compared.
        const PLACES: i32 = 8;
        let (cold, law) =
            (self.interface.friction.cold_coefficient(), &self.interface.friction.law);
        let conduction = self.interface.conduction(&self.kinematics);
        let mut places = (-PLACES..=PLACES).map(|k| width * f64::from(k) / f64::from(PLACES));
        let is_cold = |y| self.interface.entry_friction(&conduction, y).coefficient == cold;
        let is_bounded = self.interface.layer.is_none_or(|layer| layer.yield_limit().is_none());
        (law.is_constant() && is_bounded && places.all(is_cold)).then_some(cold)
    }

    /// Performs all checks possible before the patch is known.
    pub fn check(&self) -> Result<(), Error> {
        self.kinematics.check()?;
        self.prescribed.check()?;
        self.interface.check(&self.kinematics)
    }
}

/// Maximum number of cells in one direction across the patch.
pub const MAX_CELLS: usize = 1024;

/// Maximum number of cells of a grid.
pub const MAX_CELLS_TOGETHER: usize = 1 << 17;

/// Which steady state to find, if falling friction causes several.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Branch {
    /// The one reached when the creepages grow from zero.
    #[default]
    LowSlip,
    /// The one reached when larger creepages decrease.
    HighSlip,
}

/// Numerical options. No choice here changes the physics.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
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
