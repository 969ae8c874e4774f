//! Forces in place of creepages: what a problem may prescribe about its motion instead of the
//! creepage of the same direction.

use crate::bodies::Kinematics;
use crate::reporting::{Error, ForceError, Quantity, require_finite};

/// Forces on the wheel, in the contact frame, that replace the creepage of their direction: F_x
/// replaces ξ, F_y replaces η, and M_z (about the reference point of the creepages) replaces φ.
/// Without any, all creepages are given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PrescribedForces {
    /// Longitudinal force, in place of ξ.
    pub x: Option<LongitudinalForce>,
    /// Lateral force F_y, in N, in place of η.
    pub y: Option<f64>,
    /// Moment M_z, in N m, in place of φ.
    pub moment_z: Option<f64>,
}

/// A longitudinal force on the wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LongitudinalForce {
    /// F_x, in N: negative in braking.
    Force(f64),
    /// Traction coefficient −F_x/N, dimensionless: positive in braking, as ξ is.
    OverLoad(f64),
    /// Torque T on the wheel about its axle (in N m), positive where it drives, and the rolling
    /// radius r (in m): F_x = T/r, the balance of a wheel that turns without acceleration.
    Torque {
        /// T, in N m.
        torque: f64,
        /// r, in m.
        radius: f64,
    },
}

impl LongitudinalForce {
    /// F_x (in N) under a load in N.
    pub fn under(self, load: f64) -> f64 {
        match self {
            Self::Force(force) => force,
            Self::OverLoad(coefficient) => -coefficient * load,
            Self::Torque { torque, radius } => torque / radius,
        }
    }

    /// What is prescribed, with its value in the unit of that quantity.
    pub fn given(self) -> (Quantity, f64) {
        match self {
            Self::Force(force) => (Quantity::ForceX, force),
            Self::OverLoad(coefficient) => (Quantity::ForceOverLoad, coefficient),
            Self::Torque { torque, .. } => (Quantity::WheelTorque, torque),
        }
    }

    /// A longitudinal force (in N) in terms of what is prescribed, in the unit of its quantity.
    pub fn in_terms(self, force: f64, load: f64) -> f64 {
        match self {
            Self::Force(_) => force,
            Self::OverLoad(_) => -force / load,
            Self::Torque { radius, .. } => force * radius,
        }
    }
}

/// A direction of motion with its creepage and its force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// ξ and F_x.
    X,
    /// η and F_y.
    Y,
    /// φ and M_z.
    Spin,
}

impl Direction {
    /// The motion (at any speed) whose creepage of this direction is one, in its unit.
    pub(crate) fn unit(self) -> Kinematics {
        let mut unit = Kinematics::free_rolling(0.0);
        *self.creepage_of(&mut unit) = 1.0;
        unit
    }

    /// Its creepage in a motion, dimensionless or in 1/m.
    pub(crate) fn creepage_of(self, motion: &mut Kinematics) -> &mut f64 {
        match self {
            Self::X => &mut motion.creepage_x,
            Self::Y => &mut motion.creepage_y,
            Self::Spin => &mut motion.spin,
        }
    }

    fn quantity(self) -> Quantity {
        match self {
            Self::X => Quantity::CreepageX,
            Self::Y => Quantity::CreepageY,
            Self::Spin => Quantity::Spin,
        }
    }

    /// Its creepage in a motion, dimensionless or in 1/m.
    pub(crate) fn creepage(self, motion: &Kinematics) -> f64 {
        *self.creepage_of(&mut { *motion })
    }
}

impl PrescribedForces {
    /// Whether all creepages are given.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The directions whose creepages are unknown, with the forces prescribed under a load (in N),
    /// in N or N m.
    pub(crate) fn under(&self, load: f64) -> Vec<(Direction, f64)> {
        let x = self.x.map(|force| (Direction::X, force.under(load)));
        let y = self.y.map(|force| (Direction::Y, force));
        let spin = self.moment_z.map(|moment| (Direction::Spin, moment));
        [x, y, spin].into_iter().flatten().collect()
    }

    /// The first quantity that is prescribed, if any.
    pub fn first(&self) -> Option<Quantity> {
        self.all().next().map(|(_, quantity, _)| quantity)
    }

    /// Whatever is prescribed, with its value in the unit of its quantity.
    fn all(&self) -> impl Iterator<Item = (Direction, Quantity, f64)> {
        let x = self.x.map(LongitudinalForce::given);
        let x = x.map(|(quantity, value)| (Direction::X, quantity, value));
        let y = self.y.map(|force| (Direction::Y, Quantity::ForceY, force));
        let spin = self.moment_z.map(|moment| (Direction::Spin, Quantity::MomentZ, moment));
        [x, y, spin].into_iter().flatten()
    }

    /// Checks that a motion has the creepages of a problem's own one where their forces are
    /// prescribed: others would be ignored.
    ///
    /// # Errors
    /// The first force whose creepage is another one.
    pub fn check_motion(&self, own: &Kinematics, other: &Kinematics) -> Result<(), Error> {
        for (direction, force, _) in self.all() {
            if direction.creepage(own) != direction.creepage(other) {
                let creepage = direction.quantity();
                return Err(ForceError::AndCreepage { force, creepage }.into());
            }
        }
        Ok(())
    }

    /// Checks that all of them are finite.
    pub fn check(&self) -> Result<(), Error> {
        self.all().try_for_each(|(_, quantity, value)| require_finite(quantity, value))
    }
}
