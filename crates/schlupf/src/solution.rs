//! What a solution holds: plain data. All forces and tractions act on the wheel.

use crate::grid::Grid;
use crate::kinematics::{Kinematics, ReferencePoint};
use crate::method::Method;
use crate::normal::NormalSummary;
use crate::state::State;
use crate::warning::Warning;

/// Whether the equations hold to the tolerance asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Status {
    /// They do.
    Converged,
    /// They do not; `residual` says how far off.
    NotConverged,
}

impl Status {
    /// Its name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NotConverged => "not-converged",
        }
    }
}

/// A solved rolling contact. The fields belong to the last instant. What the method does not know
/// is `None`, and its fields have no cells: see [`Method`].
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Solution {
    /// What was solved: all equations, or those of a fast method.
    pub method: Method,
    /// Whether to trust it.
    pub status: Status,
    /// Relative residual reached, dimensionless: the largest of the last equilibrium's
    /// ‖p − μ pₙ law‖₂ / ‖μ pₙ‖₂, measured as [`crate::problem::Options::tolerance`] says, and, in
    /// steady rolling, of the last change of traction and temperature.
    pub residual: f64,
    /// The normal contact at the last instant.
    pub normal: NormalSummary,
    /// Where the creepages hold, here and in [`Self::history`], and about which point moments are
    /// taken.
    pub reference: ReferencePoint,
    /// Speed and creepages at the last instant.
    pub kinematics: Kinematics,
    /// Forces and moment at the last instant.
    pub force: Resultant,
    /// F/(μ0 N), and Mz/(μ0 N √(ab)); dimensionless.
    pub normalised: Resultant,
    /// |F|/N, dimensionless.
    pub traction_coefficient: f64,
    /// Power of friction and of the creep forces; `None` where they take a moment that is not
    /// known.
    pub power: Option<Power>,
    /// Wear number.
    pub t_gamma: TGamma,
    /// Largest temperatures, where the method has fields.
    pub temperature: Option<Temperature>,
    /// Péclet numbers v a/κ of wheel and rail, dimensionless: v is the speed with which their
    /// material passes the contact in the temperatures above.
    pub peclet: [f64; 2],
    /// Contact, stick and slip areas.
    pub area: Area,
    /// Traction, slip and temperature in every contact cell.
    pub fields: Fields,
    /// Forces over time, one entry a time step.
    pub history: Vec<Instant>,
    /// Whatever the reader of the numbers must know.
    pub warnings: Vec<Warning>,
    /// Derivatives of forces and moment, where they were asked for and found.
    pub sensitivity: Option<Sensitivity>,
    /// How much work it was.
    pub work: Work,
    /// The state at the end, to go on from.
    pub state: State,
}

impl Solution {
    /// Motion, and forces and moment, with a reference point of choice; `None` where no file has an
    /// origin.
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
    /// Moment Mz about the reference point, by default the middle of the patch, in N m (or
    /// normalised, dimensionless); `None` where the method does not give it.
    pub moment_z: Option<f64>,
}

/// Zero, its moment, too.
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

    /// |F|, in the unit of the forces.
    pub fn tangential(&self) -> f64 {
        self.x.hypot(self.y)
    }

    /// Forces and moment times a factor each.
    pub(crate) fn scaled(&self, factor: f64, moment_factor: f64) -> Self {
        Self {
            x: factor * self.x,
            y: factor * self.y,
            moment_z: self.moment_z.map(|moment| moment_factor * moment),
        }
    }

    /// The same with the moment about another point, which lies at (x, y) (in m) from the one about
    /// which this is taken: Mz' = Mz − (x Fy − y Fx).
    #[must_use]
    pub fn about(&self, [x, y]: [f64; 2]) -> Self {
        let moment_z = self.moment_z.map(|moment| moment - (x * self.y - y * self.x));
        Self { moment_z, ..*self }
    }

    /// The sum with a multiple of another; a moment only where both have one.
    pub(crate) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            x: self.x + factor * other.x,
            y: self.y + factor * other.y,
            moment_z: self.moment_z.zip(other.moment_z).map(|(one, two)| one + factor * two),
        }
    }
}

/// Derivatives of the steady forces and moment on the wheel, everything else staying. Where a law
/// has a kink they are those of one of its sides.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sensitivity {
    /// By the longitudinal creepage ξ, in N and N m.
    pub creepage_x: Resultant,
    /// By the lateral creepage η, in N and N m.
    pub creepage_y: Resultant,
    /// By the spin φ, in N m and N m².
    pub spin: Resultant,
    /// By the normal load N (dimensionless, and in m), if the elasticity knows how it grows with
    /// the patch. The patch grows as its description says: with the curvatures of the bodies, or
    /// not at all where its size is given.
    pub load: Option<Resultant>,
    /// By the cold coefficient of friction μ0, in N and N m.
    pub friction_coefficient: Resultant,
    /// By the stiffness k_c of the contact law, in N m and N m².
    pub contact_stiffness: Resultant,
}

impl Sensitivity {
    /// The same with creepages that hold, and moments that are taken, at another point, which lies
    /// at (x, y) (in m) from this one. Of the motion there, (ξ', η', φ), ξ is ξ' + φ y and η is η'
    /// − φ x.
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
    /// Part of the heat that goes into the wheel, in W.
    pub into_wheel: f64,
    /// Part of the heat that goes into the rail, in W; both together are the friction power and
    /// what is returned.
    pub into_rail: f64,
    /// Heat that flows from the wheel through the contact into the rail besides, because their bulk
    /// temperatures differ, in W; `None` where the method has no fields.
    pub exchanged: Option<f64>,
}

/// T-gamma, the wear number of the railways.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TGamma {
    /// |ξ Fx| + |η Fy|, in N.
    pub without_spin: f64,
    /// |ξ Fx| + |η Fy| + |φ Mz|, in N; `None` where that moment is not known.
    pub with_spin: Option<f64>,
}

/// Largest temperatures in the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Temperature {
    /// The larger of the two rises, in K.
    pub max_rise: f64,
    /// Largest rise of the wheel's surface over its bulk temperature, in K.
    pub max_rise_wheel: f64,
    /// Largest rise of the rail's surface over its bulk temperature, in K.
    pub max_rise_rail: f64,
    /// Largest temperature of the wheel's surface, in degC.
    pub max_wheel: f64,
    /// Largest temperature of the rail's surface, in degC.
    pub max_rail: f64,
    /// Where the largest rise is, in m.
    pub x: f64,
    /// Where the largest rise is, in m.
    pub y: f64,
}

/// Areas in m², each cell with its covered part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Area {
    /// Contact area, in m².
    pub contact: f64,
    /// Where the elements stick, in m²; `None` where the method has no fields.
    pub stick: Option<f64>,
    /// Where they slide, in m²; `None` where the method has no fields.
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
    /// Friction power per area, in W/m².
    pub friction_power: Vec<f64>,
    /// Rise of the wheel's surface over its bulk temperature, in K.
    pub temperature_rise_wheel: Vec<f64>,
    /// Rise of the rail's surface over its bulk temperature, in K.
    pub temperature_rise_rail: Vec<f64>,
    /// Whether the cell slides.
    pub sliding: Vec<bool>,
}

impl Fields {
    /// Number of contact cells.
    pub fn len(&self) -> usize {
        self.cell.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.cell.is_empty()
    }
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
    /// Normal load at the end of the step, in N.
    pub load: f64,
    /// Forces and moment at the end of the step.
    pub force: Resultant,
    /// Friction power, mean over the step, in W. Here and below, `None` is what the method does not
    /// know.
    pub friction_power: Option<f64>,
    /// Power of the creep forces −v0 (ξ Fx + η Fy + φ Mz), mean over the step, in W: the friction
    /// power and the change of the stored energy over the duration of the step.
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

/// Work counters.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Work {
    /// Newton steps, all together.
    pub newton_iterations: usize,
    /// Products with the compliance A, dimensionless; one on a coarser grid of n' cells counts
    /// n'/n.
    pub operator_products: f64,
    /// Products more for the derivatives.
    pub sensitivity_products: usize,
    /// Iterations between traction and temperature: the time steps of a march; one in the steady
    /// driver, which finds both together.
    pub outer_iterations: usize,
    /// Time steps.
    pub steps: usize,
    /// Contact cells.
    pub cells: usize,
}
