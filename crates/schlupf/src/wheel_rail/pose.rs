//! Where bodies are: rigid transformations, and how they follow from each other.

use super::side::Side;

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

/// A rigid transformation, from the axes of a body to those of the one that it is seen from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    /// Origin of the body, in m; of a wheelset the middle of the axle.
    pub centre: [f64; 3],
    /// Row by row, dimensionless.
    pub rotation: [[f64; 3]; 3],
}

/// The angle from below around the axle at which the normal of a surface of revolution has no
/// component along the track.
#[derive(Debug, Clone, Copy)]
pub(super) struct Silhouette {
    /// Its sine, positive forwards, and its cosine, dimensionless.
    pub sin_cos: [f64; 2],
    /// Its derivative with respect to the slope dz/dy of the profile, in rad.
    pub by_slope: f64,
}

/// R = Rx(roll) Rz(yaw), angles in rad; dimensionless.
pub(super) fn rotation(roll: f64, yaw: f64) -> [[f64; 3]; 3] {
    let ([sr, cr], [sy, cy]) = (sin_cos(roll), sin_cos(yaw));
    [[cy, -sy, 0.0], [cr * sy, cr * cy, -sr], [sr * sy, sr * cy, cr]]
}

impl Attitude {
    /// That of a wheelset with a lateral position (in m), a roll and a yaw angle (in rad), for one
    /// of its sides.
    pub fn of(side: Side, place: [f64; 3]) -> Self {
        let [lateral, roll, yaw] = place.map(|part| side.outwards() * part);
        Self { lateral, roll, yaw }
    }

    /// With the axle `height` (in m) above the nominal radius (in m) over z = 0 of the track.
    pub fn at_height(&self, nominal_radius: f64, height: f64) -> Pose {
        let centre = [0.0, self.lateral, nominal_radius + height];
        Pose { centre, rotation: rotation(self.roll, self.yaw) }
    }
}

fn sin_cos(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [sin, cos]
}

impl Pose {
    /// A point of the body (in m) where it is seen from.
    pub fn in_track(&self, point: [f64; 3]) -> [f64; 3] {
        plus(self.centre, self.turned(point))
    }

    /// A vector of the body there, in the unit of the vector.
    pub fn turned(&self, direction: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| dot(row, direction))
    }

    /// A vector from there in the axes of the body, in the unit of the vector.
    pub fn in_body(&self, direction: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| (0..3).map(|row| self.rotation[row][k] * direction[row]).sum())
    }

    /// That of a body with a pose in this one.
    pub fn then(&self, inner: &Self) -> Self {
        let column = |k: usize| inner.rotation.map(|row| row[k]);
        let rotation = self.rotation.map(|row| [0, 1, 2].map(|k| dot(row, column(k))));
        Self { centre: self.in_track(inner.centre), rotation }
    }

    /// With the axle along y and a profile of a slope dz/dy, dimensionless; `None` where all of it
    /// is seen along the track.
    ///
    /// The normal is (sin θ, dz/dy, −cos θ); with R for the rotation, R₁₁ sin θ − R₁₃ cos θ =
    /// −R₁₂ dz/dy.
    pub fn silhouette(&self, slope: f64) -> Option<Silhouette> {
        let [along, across, up] = self.rotation[0];
        let size = (along * along + up * up).sqrt();
        let sin = -across / size * slope;
        let cos = (1.0 - sin * sin).sqrt();
        let [from_sin, from_cos] = [up / size, along / size];
        (cos > 0.0).then(|| Silhouette {
            sin_cos: [sin * from_cos + cos * from_sin, cos * from_cos - sin * from_sin],
            by_slope: -across / size / cos,
        })
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

/// v + w
pub(super) fn plus(v: [f64; 3], w: [f64; 3]) -> [f64; 3] {
    [v[0] + w[0], v[1] + w[1], v[2] + w[2]]
}

/// v − w
pub(super) fn minus(v: [f64; 3], w: [f64; 3]) -> [f64; 3] {
    [v[0] - w[0], v[1] - w[1], v[2] - w[2]]
}
