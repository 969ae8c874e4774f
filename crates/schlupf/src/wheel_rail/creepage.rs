//! Creepages of a contact from the rigid motion of the wheelset.

use super::contact_plane::ContactPlane;
use super::pose::{Pose, cross, dot, minus};
use crate::kinematics::Kinematics;

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

/// Creepages at the origin of a plane under an approach (in m).
///
/// The material point of the wheel there, Q = P − δ n, moves at v = v_o + ω × (Q − o). With p the
/// part of vₓ that is due to rolling, the rolling speed is V = (|vₓ − p| + |p|)/2, and
/// ξ = vₓ/V, η = v·s/V, φ = ω·n/V (Kalker 1990).
pub(super) fn creepages(
    pose: &Pose,
    plane: &ContactPlane,
    approach: f64,
    motion: &Motion,
) -> Kinematics {
    let normal = plane.normal();
    let material = [0, 1, 2].map(|k| plane.origin[k] - approach * normal[k]);
    let arm = minus(material, pose.centre);
    let turning = pose.turned([motion.roll_rate, motion.angular_velocity, motion.yaw_rate]);
    let [dx, dy, dz] = cross(turning, arm);
    let velocity = [motion.speed + dx, motion.lateral_velocity + dy, motion.vertical_velocity + dz];
    let rolling = cross(pose.turned([0.0, motion.angular_velocity, 0.0]), arm)[0];
    let speed = 0.5 * ((velocity[0] - rolling).abs() + rolling.abs());
    Kinematics {
        speed,
        creepage_x: velocity[0] / speed,
        creepage_y: dot(velocity, plane.across()) / speed,
        spin: dot(turning, normal) / speed,
    }
}
