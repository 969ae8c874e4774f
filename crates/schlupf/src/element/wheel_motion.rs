//! Slip of a contact of a wheel, from the motion of the wheelset.

use crate::numerics::dual::Number;

/// A vector.
pub(super) type Vector<T> = [T; 3];

/// A wheelset in the track, as seen from the left.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wheelset<T> {
    /// Middle of the axle, in m.
    pub centre: Vector<T>,
    /// Roll and yaw angle, in rad.
    pub angles: [T; 2],
    /// Velocity of the middle of the axle relative to the rail, in m/s.
    pub velocity: Vector<T>,
    /// Angular velocity about its axes, in rad/s.
    pub turning: Vector<T>,
    /// Speed along the track (in m/s), and curvature of the track, in 1/m.
    pub along: (T, f64),
}

/// Directions of a contact in the track: along, across, normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axes<T>(pub [Vector<T>; 3]);

/// How a contact moves.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving<T> {
    /// Velocity of the material point of the wheel relative to the rail, in m/s: along, across.
    pub slip: [T; 2],
    /// Spin rate about the normal, in rad/s.
    pub spin_rate: T,
    /// The part of the velocity along the track that is due to turning about the axle, in m/s.
    pub around: T,
}

impl<T: Number> Axes<T> {
    /// Of a plane that rises outwards by an angle, in rad.
    pub fn new(inclination: T) -> Self {
        let (sin, cos) = inclination.value().sin_cos();
        let (sin, cos) = (inclination.chain(sin, cos), inclination.chain(cos, -sin));
        let [zero, one] = [0.0, 1.0].map(T::from);
        Self([[one, zero, zero], [zero, cos, sin], [zero, -sin, cos]])
    }

    /// A vector with components along, across and normal, in the unit of those.
    pub fn resolved(&self, components: Vector<T>) -> Vector<T> {
        let [along, across, normal] = self.0;
        let [x, s, n] = components;
        [0, 1, 2].map(|k| along[k] * x + across[k] * s + normal[k] * n)
    }
}

impl<T: Number> Wheelset<T> {
    /// Directions of its axes in the track: R = Rx(roll) Rz(yaw), column by column.
    fn axes(&self) -> [Vector<T>; 3] {
        let [(sr, cr), (sy, cy)] = self.angles.map(|angle| {
            let (sin, cos) = angle.value().sin_cos();
            (angle.chain(sin, cos), angle.chain(cos, -sin))
        });
        let zero = T::from(0.0);
        [[cy, cr * sy, sr * sy], [-sy, cr * cy, sr * cy], [zero, -sr, cr]]
    }

    /// The motion at a point of the wheel (in m) under a contact with axes, in the track.
    ///
    /// As [`crate::wheel_rail`]: v = v_o + ω × (Q − o), in a curve relative to the track that turns
    /// away.
    pub fn at(&self, point: Vector<T>, axes: &Axes<T>) -> Moving<T> {
        let [forwards, axle, upwards] = self.axes();
        let [roll_rate, angular_velocity, yaw_rate] = self.turning;
        let about_axle = axle.map(|part| part * angular_velocity);
        let turning: Vector<T> =
            [0, 1, 2].map(|k| about_axle[k] + forwards[k] * roll_rate + upwards[k] * yaw_rate);
        let arm = [0, 1, 2].map(|k| point[k] - self.centre[k]);
        let around = cross(about_axle, arm)[0];
        let of_body = cross(turning, arm);
        let (speed, curvature) = self.along;
        // Minus the velocity of a track that turns away with −v0/R about z.
        let curving = speed * curvature;
        let [x, y, _] = point;
        let of_track = [-(curving * y), curving * x, T::from(0.0)];
        let velocity: Vector<T> = [0, 1, 2].map(|k| self.velocity[k] + of_body[k] + of_track[k]);
        let [_, across, normal] = axes.0;
        let spin = dot(turning, normal) + curving * normal[2];
        Moving { slip: [velocity[0], dot(velocity, across)], spin_rate: spin, around }
    }
}

/// v · w
pub(super) fn dot<T: Number>(v: Vector<T>, w: Vector<T>) -> T {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

/// v × w
pub(super) fn cross<T: Number>(v: Vector<T>, w: Vector<T>) -> Vector<T> {
    [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]]
}
