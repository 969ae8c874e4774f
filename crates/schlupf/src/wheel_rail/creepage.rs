//! Creepages of a contact from the rigid motion of the wheelset.

use super::contact_plane::ContactPlane;
use super::pair::Pair;
use super::pose::{Pose, cross, dot, minus, plus};
use crate::bodies::{Kinematics, ReferenceSpeed};

/// Motion of a wheelset. Of rail and wheel the velocities are those of their
/// [deviations](super::Deviation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Speed along the track v0, in m/s; on rollers that of their circumference at the nominal
    /// radius, and the wheelset stays where it is.
    pub speed: f64,
    /// Radius of the curve of the track, in m: positive where it turns to the left, infinite where
    /// it is straight. The yaw rate is that relative to the track.
    pub curve_radius: f64,
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
    /// Along a straight track at a speed (in m/s), turning about the axle (in rad/s).
    pub fn straight(speed: f64, angular_velocity: f64) -> Self {
        Self {
            speed,
            curve_radius: f64::INFINITY,
            lateral_velocity: 0.0,
            vertical_velocity: 0.0,
            angular_velocity,
            roll_rate: 0.0,
            yaw_rate: 0.0,
        }
    }

    /// The mirror image.
    pub(super) fn mirrored(&self) -> Self {
        Self {
            curve_radius: -self.curve_radius,
            lateral_velocity: -self.lateral_velocity,
            roll_rate: -self.roll_rate,
            yaw_rate: -self.yaw_rate,
            ..*self
        }
    }
}

/// The motion of the wheel relative to the rail at the origin of a plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving {
    /// Angular velocity ω in the track, in rad/s.
    pub turning: [f64; 3],
    /// Velocity of the material point of the wheel there, in m/s.
    at_origin: [f64; 3],
    /// Part of its x component that is due to rolling, in m/s.
    rolling: f64,
}

/// A velocity (in m/s) and an angular velocity (in rad/s).
type Rigid = [[f64; 3]; 2];

impl Moving {
    /// The wheel at the point Q = P − δ n, the rail at P, the origin of a plane, under an approach
    /// δ, in m; `pose` is that of the wheelset.
    pub fn new(
        (pair, pose): (&Pair, &Pose),
        (plane, approach): (&ContactPlane, f64),
        motion: &Motion,
    ) -> Self {
        let normal = plane.normal();
        let material = [0, 1, 2].map(|k| plane.origin[k] - approach * normal[k]);
        let [wheel, turning] = wheel(pair, pose, material, motion);
        let [rail, rail_turning] = rail(pair, plane.origin, motion);
        let axle = pose.turned([0.0, motion.angular_velocity, 0.0]);
        Self {
            turning: minus(turning, rail_turning),
            at_origin: minus(wheel, rail),
            rolling: cross(axle, minus(material, pose.centre))[0],
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

/// The motion of a wheel at a point of it in the track, in m: that of the wheelset, and of the
/// wheel in it.
fn wheel(pair: &Pair, pose: &Pose, point: [f64; 3], motion: &Motion) -> Rigid {
    let turning = pose.turned([motion.roll_rate, motion.angular_velocity, motion.yaw_rate]);
    // The axle of a wheelset on rollers stays where it is.
    let speed = if pair.roller.is_some() { 0.0 } else { motion.speed };
    let centre = [speed, motion.lateral_velocity, motion.vertical_velocity];
    let arm = minus(point, pose.centre);
    let away = minus(pose.in_body(arm), pair.wheel_origin());
    let deviation = &pair.wheel_deviation;
    let bent = pose.turned(deviation.velocity_at(away));
    let turning_bent = pose.turned(deviation.turning);
    [plus(plus(centre, cross(turning, arm)), bent), plus(turning, turning_bent)]
}

/// The motion of a rail at a point of it in the track, in m: as it deviates, as the track turns
/// away under a wheelset in a curve, and as a roller turns.
fn rail(pair: &Pair, point: [f64; 3], motion: &Motion) -> Rigid {
    let [y, z] = pair.rail_origin;
    let deviation = &pair.rail_deviation;
    let curving = [0.0, 0.0, -motion.speed / motion.curve_radius];
    let mut velocity = deviation.velocity_at(minus(point, [0.0, y, z]));
    let mut turning = plus(deviation.turning, curving);
    velocity = plus(velocity, cross(curving, point));
    if let Some(radius) = pair.roller {
        let rolling = [0.0, -motion.speed / radius, 0.0];
        velocity = plus(velocity, cross(rolling, minus(point, [0.0, 0.0, -radius])));
        turning = plus(turning, rolling);
    }
    [velocity, turning]
}

/// Creepages at the origin of a plane.
///
/// The material point of the wheel there, Q = P − δ n, moves at v = v_o + ω × (Q − o) relative to
/// that of the rail, P. With p the part of vₓ that is due to rolling, the rolling speed is
/// V = (|vₓ − p| + |p|)/2, and ξ = vₓ/V, η = v·s/V, φ = ω·n/V (Kalker 1990).
///
/// In a plane that rises with the rail at θ the wheel follows it: whatever velocity along the
/// normal of the profile that takes, it slides at vₓ/cos θ and rolls at V/cos θ.
pub(super) fn creepages(plane: &ContactPlane, moving: &Moving) -> Kinematics {
    let Moving { turning, at_origin, rolling } = *moving;
    let [level, ..] = plane.along();
    let speed = 0.5 * ((at_origin[0] - rolling).abs() + rolling.abs()) / level;
    Kinematics {
        speed,
        creepage_x: at_origin[0] / (level * speed),
        creepage_y: dot(at_origin, plane.across()) / speed,
        spin: dot(turning, plane.normal()) / speed,
        reference_speed: ReferenceSpeed::Mean,
    }
}
