//! Position of a wheelset, and its directions in the track.

/// Position and attitude of a wheelset, as seen from the left: y outwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attitude {
    /// Lateral position, in m.
    pub lateral: f64,
    /// About x, in rad.
    pub roll: f64,
    /// About z of the rolled wheelset, in rad.
    pub yaw: f64,
}

/// A position with its height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    /// The middle of the axle in the track frame, in m.
    pub centre: [f64; 3],
    /// R = Rx(roll) Rz(yaw), row by row: from the wheelset's axes to those of the track;
    /// dimensionless.
    pub rotation: [[f64; 3]; 3],
}

impl Attitude {
    /// R, dimensionless.
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        let ([sr, cr], [sy, cy]) = (sin_cos(self.roll), sin_cos(self.yaw));
        [[cy, -sy, 0.0], [cr * sy, cr * cy, -sr], [sr * sy, sr * cy, cr]]
    }

    /// With the axle `height` (in m) above the nominal radius (in m) over the tops of the rails.
    pub fn at_height(&self, nominal_radius: f64, height: f64) -> Pose {
        let centre = [0.0, self.lateral, nominal_radius + height];
        Pose { centre, rotation: self.rotation() }
    }
}

fn sin_cos(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [sin, cos]
}

impl Pose {
    /// A point of the wheelset (in m) in the track frame.
    pub fn in_track(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.turned(point);
        [0, 1, 2].map(|k| self.centre[k] + turned[k])
    }

    /// A vector of the wheelset in the track frame, in the unit of the vector.
    pub fn turned(&self, direction: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| dot(row, direction))
    }

    /// A vector of the track in the wheelset's axes, in the unit of the vector.
    pub fn in_wheelset(&self, direction: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| (0..3).map(|row| self.rotation[row][k] * direction[row]).sum())
    }
}

/// v · w
pub(super) fn dot(v: [f64; 3], w: [f64; 3]) -> f64 {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

/// v × w
pub(super) fn cross(v: [f64; 3], w: [f64; 3]) -> [f64; 3] {
    [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]]
}

/// v − w
pub(super) fn minus(v: [f64; 3], w: [f64; 3]) -> [f64; 3] {
    [v[0] - w[0], v[1] - w[1], v[2] - w[2]]
}
