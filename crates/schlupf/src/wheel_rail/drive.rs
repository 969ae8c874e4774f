//! What turns a wheel: its angular velocity, or a force or a torque.

use crate::reporting::{Error, Quantity, require_finite};

/// What turns a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// The angular velocity of its motion.
    AngularVelocity,
    /// Longitudinal force F_x on the wheel, of all contacts together, in N: negative in braking.
    Force {
        /// F_x, in N.
        force: f64,
        /// Along which axis.
        along: Along,
    },
    /// −F_x over the vertical force on the wheel, both in the track; dimensionless, positive in
    /// braking.
    OverLoad(f64),
    /// Torque T on the wheel about its axle (in N m), positive where it drives: that of the
    /// tangential tractions of all contacts balances it.
    Torque(f64),
}

/// The axis of a longitudinal force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Along {
    /// That of the track.
    #[default]
    Track,
    /// That of the wheelset, across its axle: it turns with roll and yaw.
    Wheelset,
}

impl Drive {
    /// Whether the angular velocity is to be found.
    pub fn is_force(self) -> bool {
        self != Self::AngularVelocity
    }

    /// Checks that what is given is finite.
    pub(super) fn check(self) -> Result<(), Error> {
        match self {
            Self::AngularVelocity => Ok(()),
            Self::Force { force, .. } => require_finite(Quantity::ForceX, force),
            Self::OverLoad(coefficient) => require_finite(Quantity::ForceOverLoad, coefficient),
            Self::Torque(torque) => require_finite(Quantity::WheelTorque, torque),
        }
    }
}
