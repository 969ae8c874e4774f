//! How a rail or a wheel deviates from its place.

use super::pose::{Pose, cross, minus, plus, rotation};
use crate::reporting::{Error, Quantity, Requirement, require, require_finite};

/// Largest displacement in m, and angle in rad.
const LARGEST: f64 = 1.0;

/// How a rail deviates from its place in the track, or a wheel from its place in the wheelset, and
/// how fast: by an irregularity, or as rail, axle and wheel give way. x forwards, y to the left and
/// z up, in the axes of the track or of the wheelset; it turns about the origin of its profile. A
/// roller's axle keeps its place: its profile moves on it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// Displacement of the origin of its profile, in m; x does not count for a rail.
    pub displacement: [f64; 3],
    /// About x, in rad.
    pub roll: f64,
    /// About the z that has turned about x, in rad; that of a rail does not count.
    pub yaw: f64,
    /// Velocity of the origin of its profile, in m/s.
    pub velocity: [f64; 3],
    /// Angular velocity about the three axes, in rad/s.
    pub turning: [f64; 3],
}

impl Deviation {
    /// The mirror image.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let vector = |[x, y, z]: [f64; 3]| [x, -y, z];
        let axial = |[x, y, z]: [f64; 3]| [-x, y, -z];
        Self {
            displacement: vector(self.displacement),
            roll: -self.roll,
            yaw: -self.yaw,
            velocity: vector(self.velocity),
            turning: axial(self.turning),
        }
    }

    /// Whether it has a velocity.
    pub(super) fn is_moving(&self) -> bool {
        self.velocity.into_iter().chain(self.turning).any(|rate| rate != 0.0)
    }

    /// Checks it; `quantity` is what to call it.
    pub(super) fn check(&self, quantity: Quantity) -> Result<(), Error> {
        for part in self.displacement.into_iter().chain([self.roll, self.yaw]) {
            require(quantity, Requirement::Magnitude(LARGEST), part)?;
        }
        let mut rates = self.velocity.into_iter().chain(self.turning);
        rates.try_for_each(|rate| require_finite(quantity, rate))
    }

    /// The pose of a body whose profile has its origin at `origin` (in m), in the axes of that from
    /// which it deviates.
    pub(super) fn pose(&self, origin: [f64; 3]) -> Pose {
        let turned = Pose { centre: [0.0; 3], rotation: rotation(self.roll, self.yaw) };
        let centre = minus(plus(origin, self.displacement), turned.turned(origin));
        Pose { centre, ..turned }
    }

    /// Velocity (in m/s) of its point that is `away` (in m) from the origin of its profile.
    pub(super) fn velocity_at(&self, away: [f64; 3]) -> [f64; 3] {
        plus(self.velocity, cross(self.turning, away))
    }
}
