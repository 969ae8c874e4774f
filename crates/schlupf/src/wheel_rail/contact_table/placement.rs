//! Where a wheel is, with the derivatives of that.

use crate::numerics::dual::Dual;
use crate::numerics::lanes::Lanes;
use crate::wheel_rail::pair::Pair;
use crate::wheel_rail::pose::{Attitude, Pose};

use super::outlines::Node;

/// Lateral position and height (in m), roll and yaw angle (in rad): the variables of a pose.
pub(crate) const POSE: usize = 4;
pub(crate) const HEIGHT: usize = 1;
pub(crate) const ROLL: usize = 2;
pub(crate) const YAW: usize = 3;

/// A number with its derivatives with respect to a pose.
pub(crate) type OfPose = Dual<POSE>;

/// A wheel in the track, as seen from the left.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placement {
    pub attitude: Attitude,
    /// The axes of the wheel in the track.
    pub wheel: Pose,
    /// Their derivatives with respect to the roll and the yaw angle, in the units of the pose over
    /// rad.
    pub turned: [Pose; 2],
    /// Middle of the axle, in m, and direction of the axis about which the wheelset yaws.
    centre: [f64; 3],
    upwards: [f64; 3],
    /// Sine of the angle from below of a candidate with slope one, and sine and cosine of that of
    /// one without a slope.
    silhouette: [f64; 3],
}

/// A point of the wheel that may touch, in the track.
#[derive(Debug, Clone, Copy)]
pub(super) struct Posed<T> {
    /// Sine and cosine of its angle from below.
    sin_cos: [T; 2],
    /// Position in the track, in m.
    pub place: [T; 3],
}

impl Placement {
    /// At a height (in m).
    pub fn new(pair: &Pair, attitude: Attitude, height: f64) -> Self {
        let set = attitude.at_height(pair.nominal_radius, height);
        let [[cy, minus_sy, _], [_, _, minus_sr], [.., cr]] = set.rotation;
        let (sr, sy) = (-minus_sr, -minus_sy);
        let by_roll = [[0.0; 3], [-sr * sy, -sr * cy, -cr], [cr * sy, cr * cy, -sr]];
        let by_yaw = [[-sy, -cy, 0.0], [cr * cy, -cr * sy, 0.0], [sr * cy, -sr * sy, 0.0]];
        let turned = [by_roll, by_yaw];
        let turned = turned.map(|rotation| pair.wheel_in(&Pose { centre: [0.0; 3], rotation }));
        let wheel = pair.wheel_in(&set);
        let [along, across, up] = wheel.rotation[0];
        let part = (along * along + up * up).sqrt().recip();
        let silhouette = [-across * part, up * part, along * part];
        let (centre, upwards) = (set.centre, set.turned([0.0, 0.0, 1.0]));
        Self { attitude, wheel, turned, centre, upwards, silhouette }
    }

    /// A point of the wheel; far above the rail where it is seen along the track.
    #[inline]
    pub fn at<T: Lanes>(&self, node: &Node<T>) -> Posed<T> {
        let [lean, from_sin, from_cos] = self.silhouette.map(T::from);
        let sin = lean * node.slope;
        let cos = (T::from(1.0) - sin * sin).max(T::from(0.0)).sqrt();
        let [sin, cos] = [sin * from_cos + cos * from_sin, cos * from_cos - sin * from_sin];
        let turned = turned(&self.wheel, [node.radius * sin, node.y, -(node.radius * cos)]);
        let place = [0, 1, 2].map(|k| T::from(self.wheel.centre[k]) + turned[k]);
        Posed { sin_cos: [sin, cos], place }
    }

    /// The tangent of the wheel at a point, per step along the axle; dimensionless.
    #[inline]
    pub fn tangent<T: Lanes>(&self, node: &Node<T>, posed: &Posed<T>) -> [T; 3] {
        let [sin, cos] = posed.sin_cos;
        turned(&self.wheel, [-(node.slope * sin), T::from(1.0), node.slope * cos])
    }

    /// tan²ψ of a wheel that yaws by ψ against the direction of the track, dimensionless.
    #[inline]
    pub fn lean(&self) -> f64 {
        self.silhouette[0] * self.silhouette[0]
    }

    /// Derivatives of the place of a point of the wheel with respect to the roll and the yaw angle,
    /// in m/rad.
    #[inline]
    pub fn slopes<T: Lanes>(&self, node: &Node<T>, posed: &Posed<T>) -> [[T; 3]; 2] {
        let [sin, cos] = posed.sin_cos;
        let [along, _, up] = self.wheel.rotation[0].map(T::from);
        let [along_by, across_by, up_by] = self.turned[1].rotation[0].map(T::from);
        // The point stays where it is on the profile, and moves around the wheel as it yaws; a roll
        // leaves the direction along the track where it is.
        let off = along_by * sin - up_by * cos + across_by * node.slope;
        let turn = -off / (along * cos + up * sin);
        let around = turned(&self.wheel, [node.radius * cos, T::from(0.0), node.radius * sin]);
        let [x, y, z] = [0, 1, 2].map(|k| posed.place[k] - T::from(self.centre[k]));
        let [e_x, e_y, e_z] = self.upwards.map(T::from);
        let by_yaw = [e_y * z - e_z * y, e_z * x - e_x * z, e_x * y - e_y * x];
        [[T::from(0.0), -z, y], [0, 1, 2].map(|k| by_yaw[k] + turn * around[k])]
    }
}

/// A vector of a body where that is seen from, in the unit of the vector.
#[inline]
fn turned<T: Lanes>(body: &Pose, [x, y, z]: [T; 3]) -> [T; 3] {
    body.rotation.map(|row| {
        let [along, across, up] = row.map(T::from);
        x * along + y * across + z * up
    })
}
