//! Creepages of a contact from the rigid motion of the wheelset.

use super::contact_plane::ContactPlane;
use super::pose::{Pose, cross, dot, minus};
use crate::bodies::Kinematics;

/// Motion of a wheelset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Speed along the track v0, in m/s.
    pub speed: f64,
    /// Lateral velocity of the middle of the axle, in m/s.
    pub lateral_velocity: f64,
    /// Vertical velocity of the middle of the axle, in m/s.
    pub vertical_velocity: f64,
    /// Angular velocity ω about the axle, in rad/s; positive when rolling forwards.
    pub angular_velocity: f64,
    /// Angular velocity about the longitudinal axis of the wheelset, in rad/s.
    pub roll_rate: f64,
    /// Angular velocity about the vertical axis of the wheelset, in rad/s.
    pub yaw_rate: f64,
}

impl Motion {
    /// The mirror image.
    pub(super) fn mirrored(&self) -> Self {
        Self {
            lateral_velocity: -self.lateral_velocity,
            roll_rate: -self.roll_rate,
            yaw_rate: -self.yaw_rate,
            ..*self
        }
    }
}

/// The motion of the wheelset at the material point of the wheel at the origin of a plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving {
    /// Angular velocity ω in the track, in rad/s.
    pub turning: [f64; 3],
    /// Velocity of that point, in m/s.
    at_origin: [f64; 3],
    /// Part of its x component that is due to rolling, in m/s.
    rolling: f64,
}

impl Moving {
    /// The point Q = P − δ n at the origin P of a plane under an approach δ, in m.
    pub fn new(pose: &Pose, plane: &ContactPlane, approach: f64, motion: &Motion) -> Self {
        let normal = plane.normal();
        let material = [0, 1, 2].map(|k| plane.origin[k] - approach * normal[k]);
        let arm = minus(material, pose.centre);
        let turning = pose.turned([motion.roll_rate, motion.angular_velocity, motion.yaw_rate]);
        let [dx, dy, dz] = cross(turning, arm);
        Self {
            turning,
            at_origin: [
                motion.speed + dx,
                motion.lateral_velocity + dy,
                motion.vertical_velocity + dz,
            ],
            rolling: cross(pose.turned([0.0, motion.angular_velocity, 0.0]), arm)[0],
        }
    }

    /// Ratio of the angular velocity about the axle at which that point has no velocity along the
    /// track to the present one, dimensionless.
    pub fn free_rolling(&self) -> f64 {
        1.0 - self.at_origin[0] / self.rolling
    }

    /// Velocity (in m/s) of the point of the wheel that is `away` (in m) from that point.
    pub fn velocity(&self, away: [f64; 3]) -> [f64; 3] {
        let more = cross(self.turning, away);
        [0, 1, 2].map(|k| self.at_origin[k] + more[k])
    }
}

/// Creepages at the origin of a plane.
///
/// The material point of the wheel there, Q = P − δ n, moves at v = v_o + ω × (Q − o). With p the
/// part of vₓ that is due to rolling, the rolling speed is V = (|vₓ − p| + |p|)/2, and
/// ξ = vₓ/V, η = v·s/V, φ = ω·n/V (Kalker 1990).
pub(super) fn creepages(plane: &ContactPlane, moving: &Moving) -> Kinematics {
    let Moving { turning, at_origin, rolling } = *moving;
    let speed = 0.5 * ((at_origin[0] - rolling).abs() + rolling.abs());
    Kinematics {
        speed,
        creepage_x: at_origin[0] / speed,
        creepage_y: dot(at_origin, plane.across()) / speed,
        spin: dot(turning, plane.normal()) / speed,
    }
}
