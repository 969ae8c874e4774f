//! Results of a solution: plain data. All forces and tractions act on the wheel.

mod columns;

use crate::bodies::{Kinematics, ReferencePoint};
use crate::normal::{Grid, NormalSummary};
use crate::problem::{Direction, Method, State};
use crate::reporting::Warning;

/// Whether the equations are satisfied to the tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Status {
    /// They are.
    Converged,
    /// They are not; `residual` gives the error.
    NotConverged,
}

impl Status {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NotConverged => "not-converged",
        }
    }
}

/// A solved rolling contact. The fields are those of the last instant. Quantities that the method
/// does not compute are `None`, and its fields have no cells: see [`Method`].
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Solution {
    /// The method: the full equations, or a fast method.
    pub method: Method,
    /// Whether the solution converged.
    pub status: Status,
    /// Relative residual reached, dimensionless: the largest of the last equilibrium's ‖p − μ pₙ
    /// law‖₂ / ‖μ pₙ‖₂, measured as described in [`crate::problem::Options::tolerance`], and, in
    /// steady rolling, of the last change of traction and temperature.
    pub residual: f64,
    /// The normal contact at the last instant.
    pub normal: NormalSummary,
    /// Reference point of creepages and moments, here and in [`Self::history`].
    pub reference: ReferencePoint,
    /// Speed and creepages at the last instant.
    pub kinematics: Kinematics,
    /// Forces and moment at the last instant.
    pub force: Resultant,
    /// F/(μ0 N), and Mz/(μ0 N √(ab)); dimensionless.
    pub normalised: Resultant,
    /// |F|/N, dimensionless.
    pub traction_coefficient: f64,
    /// Power of friction and of the creep forces; `None` if they require a moment that is unknown.
    pub power: Option<Power>,
    /// Wear number.
    pub t_gamma: TGamma,
    /// Largest temperatures, if the method has fields.
    pub temperature: Option<Temperature>,
    /// Péclet numbers v a/κ of wheel and rail, dimensionless: v is the speed at which their
    /// material passes the contact in the temperature computation above.
    pub peclet: [f64; 2],
    /// Contact, stick and slip areas.
    pub area: Area,
    /// Traction, slip and temperature in every contact cell.
    pub fields: Fields,
    /// Forces over time, one entry per time step.
    pub history: Vec<Instant>,
    /// Fields at some of these instants, if a march was asked for them: see
    /// [`Options::fields_every`](crate::problem::Options::fields_every).
    pub field_history: Vec<FieldsAt>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Warning>,
    /// Derivatives of forces and moment, if requested and found.
    pub sensitivity: Option<Sensitivity>,
    /// Forces extrapolated from two grids, if requested and there are two.
    pub extrapolation: Option<Extrapolation>,
    /// Amount of work.
    pub work: Work,
    /// The state at the end, from which rolling can continue.
    pub state: State,
}

impl Solution {
    /// Motion, forces and moment referred to a chosen reference point; `None` if it is the origin
    /// of a file and there is none.
    pub fn seen_from(&self, reference: ReferencePoint) -> Option<(Kinematics, Resultant)> {
        if reference == self.reference {
            return Some((self.kinematics, self.force));
        }
        let [x, y] = self.normal.origin?;
        let way = match reference {
            ReferencePoint::Patch => [x, y],
            ReferencePoint::File => [-x, -y],
        };
        Some((self.kinematics.at(way), self.force.about(way)))
    }
}

/// Tangential force and moment on the wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Resultant {
    /// Longitudinal force Fx, in N (or normalised, dimensionless).
    pub x: f64,
    /// Lateral force Fy, in N (or normalised, dimensionless).
    pub y: f64,
    /// Moment Mz about the reference point, by default the centre of the patch, in N m (or
    /// normalised, dimensionless); `None` if the method does not compute it.
    pub moment_z: Option<f64>,
}

/// Zero, including the moment.
impl Default for Resultant {
    fn default() -> Self {
        Self::new(0.0, 0.0, 0.0)
    }
}

impl Resultant {
    /// Forces (in N) with a moment (in N m).
    pub const fn new(x: f64, y: f64, moment_z: f64) -> Self {
        Self { x, y, moment_z: Some(moment_z) }
    }

    /// The force of a direction, in N or N m; `None` if the method has no moment.
    pub(crate) fn along(&self, direction: Direction) -> Option<f64> {
        match direction {
            Direction::X => Some(self.x),
            Direction::Y => Some(self.y),
            Direction::Spin => self.moment_z,
        }
    }

    /// |F|, in the unit of the forces.
    #[inline]
    pub fn tangential(&self) -> f64 {
        (self.x * self.x + self.y * self.y).sqrt()
    }

    /// Forces and moment, each multiplied by its factor.
    pub(crate) fn scaled(&self, factor: f64, moment_factor: f64) -> Self {
        Self {
            x: factor * self.x,
            y: factor * self.y,
            moment_z: self.moment_z.map(|moment| moment_factor * moment),
        }
    }

    /// The same with the moment about another point, which lies at (x, y) (in m) from the present
    /// one: Mz' = Mz − (x Fy − y Fx).
    #[must_use]
    pub fn about(&self, [x, y]: [f64; 2]) -> Self {
        let moment_z = self.moment_z.map(|moment| moment - (x * self.y - y * self.x));
        Self { moment_z, ..*self }
    }

    /// The sum with a multiple of another resultant; with a moment only if both have one.
    pub(crate) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            x: self.x + factor * other.x,
            y: self.y + factor * other.y,
            moment_z: self.moment_z.zip(other.moment_z).map(|(one, two)| one + factor * two),
        }
    }
}

/// Forces and moment extrapolated to cells of no size, from this grid and one half as fine, with
/// errors that fall as the square of the size of the cells (Richardson 1911).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extrapolation {
    /// Extrapolated, in N and N m.
    pub force: Resultant,
    /// F/(μ0 N) and Mz/(μ0 N √(ab)) of that, dimensionless.
    pub normalised: Resultant,
    /// Estimated error of the forces on this grid, which are those of the result, in N and N m.
    pub error: Resultant,
}

/// Derivatives of the steady forces and moment on the wheel, everything else held constant. At a
/// kink of a law they are one-sided.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sensitivity {
    /// With respect to the longitudinal creepage ξ, in N and N m.
    pub creepage_x: Resultant,
    /// With respect to the lateral creepage η, in N and N m.
    pub creepage_y: Resultant,
    /// With respect to the spin φ, in N m and N m².
    pub spin: Resultant,
    /// With respect to the normal load N (dimensionless, and in m), if the elasticity defines how
    /// it scales with the patch. The patch grows according to its model: with the curvatures of the
    /// bodies, or not at all if its size is given.
    pub load: Option<Resultant>,
    /// With respect to the cold coefficient of friction μ0, in N and N m.
    pub friction_coefficient: Resultant,
    /// With respect to the stiffness k_c of the contact law, in N m and N m².
    pub contact_stiffness: Resultant,
}

impl Sensitivity {
    /// The same for a reference point that lies at (x, y) (in m) from the present one. The motion
    /// there, (ξ', η', φ), gives ξ = ξ' + φ y and η = η' − φ x.
    pub(crate) fn at(&self, place: [f64; 2]) -> Self {
        let [x, y] = place;
        let spin = self.spin.plus(y, &self.creepage_x).plus(-x, &self.creepage_y);
        Self {
            creepage_x: self.creepage_x.about(place),
            creepage_y: self.creepage_y.about(place),
            spin: spin.about(place),
            load: self.load.map(|load| load.about(place)),
            friction_coefficient: self.friction_coefficient.about(place),
            contact_stiffness: self.contact_stiffness.about(place),
        }
    }
}

/// Power put into the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Power {
    /// Friction power ∫ q dA, in W.
    pub friction: f64,
    /// Power of the creep forces −v0 (ξ Fx + η Fy + φ Mz), in W; equal to the friction power in
    /// steady rolling.
    pub creep: f64,
    /// Friction power that the bristles of the contact law return, in W: the negative part of q,
    /// which does not heat.
    pub returned: f64,
    /// Share of the heat that goes into the wheel, in W.
    pub into_wheel: f64,
    /// Share of the heat that goes into the rail, in W; both together are the friction power plus
    /// the returned power.
    pub into_rail: f64,
    /// Additional heat that flows from the wheel through the contact into the rail because their
    /// bulk temperatures differ, in W; `None` if the method has no fields.
    pub exchanged: Option<f64>,
}

/// T-gamma, the wear number used by railways: energy per distance rolled, taken by its parts.
///
/// In a plane, |ξ Fx| + |η Fy| (+ |φ Mz|). Where the rows of a curved contact have motions of their
/// own (Δξ, Δη, Δφ beyond the plane, at y), each part includes what its rows do:
/// |ξ Fx| + |η Fy + ∫ Δη dFy| (+ |φ Mz + ∫ (Δξ dFx + x Δφ dFy)|). The longitudinal slip of the rows
/// belongs to the spin, as −φ y does in a plane: it changes by −Δφ dy from row to row. Where all
/// parts have one sign, Tγ with spin is the creep power over the speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TGamma {
    /// Without spin, in N.
    pub without_spin: f64,
    /// With spin, in N; `None` if the moment is unknown.
    pub with_spin: Option<f64>,
    /// What the rows have in its lateral and in its spin part, −∫ Δη dFy and
    /// −∫ (Δξ dFx + x Δφ dFy), in N; zero in a plane.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub rows: [f64; 2],
}

/// Largest temperatures in the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Temperature {
    /// The larger of the two rises, in K.
    pub max_rise: f64,
    /// Largest rise of the wheel's surface above its bulk temperature, in K.
    pub max_rise_wheel: f64,
    /// Largest rise of the rail's surface above its bulk temperature, in K.
    pub max_rise_rail: f64,
    /// Largest temperature of the wheel's surface, in degC.
    pub max_wheel: f64,
    /// Largest temperature of the rail's surface, in degC.
    pub max_rail: f64,
    /// Position of the largest rise along x, in m.
    pub x: f64,
    /// Position of the largest rise along y, in m.
    pub y: f64,
}

/// Areas in m²; each cell counts with its covered part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Area {
    /// Contact area, in m².
    pub contact: f64,
    /// Area where the elements stick, in m²; `None` if the method has no fields.
    pub stick: Option<f64>,
    /// Area where they slide, in m²; `None` if the method has no fields.
    pub slip: Option<f64>,
}

/// One entry for each contact cell, strip by strip from the leading to the trailing edge.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Fields {
    /// Grid of the patch.
    pub grid: Grid,
    /// Column and row of the cell on the grid.
    pub cell: Vec<[usize; 2]>,
    /// Centroid of the covered part along rolling, in m.
    pub x: Vec<f64>,
    /// Centroid of the covered part across rolling, in m.
    pub y: Vec<f64>,
    /// Covered part of the cell, dimensionless, at most 1.
    pub covered: Vec<f64>,
    /// Normal pressure, mean over the whole cell, in Pa.
    pub pressure: Vec<f64>,
    /// Tangential traction along rolling, mean over the whole cell, in Pa.
    pub traction_x: Vec<f64>,
    /// Tangential traction across rolling, mean over the whole cell, in Pa.
    pub traction_y: Vec<f64>,
    /// Elastic displacement difference along rolling, in m.
    pub displacement_x: Vec<f64>,
    /// Elastic displacement difference across rolling, in m.
    pub displacement_y: Vec<f64>,
    /// Slip velocity of the wheel over the rail along rolling, in m/s.
    pub slip_x: Vec<f64>,
    /// Slip velocity of the wheel over the rail across rolling, in m/s.
    pub slip_y: Vec<f64>,
    /// Coefficient of friction, dimensionless.
    pub friction_coefficient: Vec<f64>,
    /// Friction power per unit area, in W/m².
    pub friction_power: Vec<f64>,
    /// Rise of the wheel's surface above its bulk temperature, in K.
    pub temperature_rise_wheel: Vec<f64>,
    /// Rise of the rail's surface above its bulk temperature, in K.
    pub temperature_rise_rail: Vec<f64>,
    /// Whether the cell slides.
    pub sliding: Vec<bool>,
}

impl Fields {
    /// Number of contact cells.
    pub fn len(&self) -> usize {
        self.cell.len()
    }

    /// Whether there are no contact cells.
    pub fn is_empty(&self) -> bool {
        self.cell.is_empty()
    }
}

/// The fields at the end of one time step.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FieldsAt {
    /// The step, of rolling or a shift: 1 is the first.
    pub step: usize,
    /// Time, in s.
    pub time: f64,
    /// The fields.
    pub fields: Fields,
}

/// Forces at the end of one time step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Instant {
    /// Time, in s.
    pub time: f64,
    /// Distance rolled since the start, in m.
    pub distance: f64,
    /// Speed and creepages at the end of the step.
    pub kinematics: Kinematics,
    /// Shift of the wheel over the rail along and across rolling, in m, and turn, in rad; `None`
    /// where the wheel rolls.
    pub shift: Option<[f64; 3]>,
    /// Normal load at the end of the step, in N.
    pub load: f64,
    /// Forces and moment at the end of the step.
    pub force: Resultant,
    /// Friction power, mean over the step, in W. Here and below, `None` means that the method does
    /// not compute it.
    pub friction_power: Option<f64>,
    /// Power of the creep forces −v0 (ξ Fx + η Fy + φ Mz), mean over the step, in W: the friction
    /// power plus the change in stored energy divided by the duration of the step.
    pub creep_power: Option<f64>,
    /// Elastic energy ½ ∫ p·u dA of the tangential tractions at the end of the step, in J.
    pub stored_energy: Option<f64>,
    /// Largest temperature rise, in K.
    pub max_rise: Option<f64>,
    /// Newton steps of this time step.
    pub newton_iterations: usize,
    /// Relative residual of this time step's equilibrium, dimensionless.
    pub residual: f64,
}

/// What led to a state of the full equations; to a steady one they are tried in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Strategy {
    /// Newton's method from earlier solutions of the same solver.
    Warm,
    /// Newton's method from no traction, on nested grids.
    Cold,
    /// Newton's method along motions that lead to the one sought, from larger creepages or from
    /// rest: along both where there may be several states.
    Continuation,
    /// Time steps until nothing changes any more.
    March,
}

impl Strategy {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Warm => "warm",
            Self::Cold => "cold",
            Self::Continuation => "continuation",
            Self::March => "march",
        }
    }
}

/// Work counters.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Work {
    /// What led to the solution, of several to the one it was hardest to find; `None` with fast
    /// methods.
    pub strategy: Option<Strategy>,
    /// Newton steps in total.
    pub newton_iterations: usize,
    /// Products with the compliance A, dimensionless; one on a coarser grid of n' cells counts as
    /// n'/n.
    pub operator_products: f64,
    /// Additional products for the derivatives.
    pub sensitivity_products: usize,
    /// Iterations between traction and temperature: the number of time steps of a march; one in the
    /// steady driver, which finds both together.
    pub outer_iterations: usize,
    /// Time steps.
    pub steps: usize,
    /// Contact cells.
    pub cells: usize,
}

impl Work {
    /// Adds the work of another solution, with its number of cells.
    pub(crate) fn add(&mut self, other: &Self) {
        self.strategy = self.strategy.max(other.strategy);
        self.newton_iterations += other.newton_iterations;
        self.operator_products += other.operator_products;
        self.sensitivity_products += other.sensitivity_products;
        self.outer_iterations += other.outer_iterations;
        self.steps += other.steps;
        self.cells = other.cells;
    }
}
