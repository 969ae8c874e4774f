//! The coordinates of the table: how far a state is from adhesion, and in which direction.
//!
//! With the creepages as forces of Kalker's linear theory over μN,
//!
//! x = (C11 ξ', C22 η', s φ'),  (ξ', η', φ') = G ab/(μN) (ξ, η, √(ab) φ),
//! s² = (C22² a/b + C11² b/a)/5,
//!
//! where s is the root mean square of the slip over the patch under spin, weighted with Hertz's
//! pressure, r = |x| is about 1 where a contact begins to slide as a whole, and r/(1 + r) runs from
//! 0 in rolling without creepage to 1 in sliding without rolling. The direction of x has an
//! inclination to the axis of ξ and an azimuth from η towards φ. For that, ξ is stretched on long
//! patches and η on wide ones, which under spin turn the direction of sliding most.

use wide::f64x2;

/// Nearer to the direction of ξ than this, functions of η and φ are linear.
const POLE: f64 = 1e-3;

/// Below this, and above its inverse, a square may not be a number of full precision.
const SMALL: f64 = 1e-100;

/// What depends on the shape of the patch alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shape {
    /// C11, C22, C23, C33; dimensionless.
    pub coefficients: [f64; 4],
    /// x over the normalised creepages; dimensionless.
    pub scales: [f64; 3],
    /// Stretching of x for the direction; dimensionless.
    pub stretching: [f64; 3],
}

/// A state in the coordinates of the table, mirrored into their range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coordinates {
    /// r; dimensionless.
    pub size: f64,
    /// The direction of x, mirrored; dimensionless.
    pub direction: [f64; 3],
    /// Signs of Fx, and of Fy and Mz, relative to the mirrored state; also those of ξ, and of η and
    /// φ; dimensionless.
    pub signs: [f64; 2],
    /// In [0, π/2]; in rad.
    pub inclination: f64,
    /// In [0, π]; in rad.
    pub azimuth: f64,
    /// 1 away from the direction of ξ; near it the part of the distance to which functions are
    /// continued linearly; dimensionless.
    pub pole: f64,
    /// r times the derivatives of the inclination with respect to x; dimensionless.
    pub inclination_slopes: [f64; 3],
    /// r times the derivatives of the azimuth; dimensionless.
    pub azimuth_slopes: [f64; 3],
}

impl Shape {
    #[inline]
    pub fn new(axis_ratio: f64, coefficients: [f64; 4]) -> Self {
        let [c11, c22, ..] = coefficients;
        let spin = ((c22 * c22 * axis_ratio + c11 * c11 / axis_ratio) / 5.0).sqrt();
        let stretched = |ratio: f64| (1.0 + ratio).sqrt().sqrt();
        let stretching = [stretched(axis_ratio), stretched(axis_ratio.recip()), 1.0];
        Self { coefficients, scales: [c11, c22, spin], stretching }
    }

    /// Normalised creepages at a place of the table; `saturation` is r/(1 + r); dimensionless.
    pub fn creepages(&self, saturation: f64, inclination: f64, azimuth: f64) -> [f64; 3] {
        let direction = self.direction(inclination, azimuth);
        let size = saturation / (1.0 - saturation);
        std::array::from_fn(|k| size * direction[k] / self.scales[k])
    }

    /// The direction of x at a place of the table; dimensionless.
    pub fn direction(&self, inclination: f64, azimuth: f64) -> [f64; 3] {
        let stretched = [
            inclination.cos(),
            inclination.sin() * azimuth.cos(),
            inclination.sin() * azimuth.sin(),
        ];
        let plain: [f64; 3] = std::array::from_fn(|k| stretched[k] / self.stretching[k]);
        let length = plain.iter().map(|part| part * part).sum::<f64>().sqrt();
        plain.map(|part| part / length)
    }

    /// Forces and moment over μN and μN √(ab) in full adhesion, at an x: linear; dimensionless.
    #[inline]
    pub fn adhesion(&self, x: [f64; 3]) -> [f64; 3] {
        let [_, by_y, by_spin] = self.adhesion_slopes();
        [-x[0], by_y[1] * x[1] + by_spin[1] * x[2], by_y[2] * x[1] + by_spin[2] * x[2]]
    }

    /// Its derivatives with respect to each component of x; dimensionless.
    #[inline]
    pub fn adhesion_slopes(&self) -> [[f64; 3]; 3] {
        let [c11, c22, c23, c33] = self.coefficients;
        let [along, across, spin] = self.scales;
        [
            [-c11 / along, 0.0, 0.0],
            [0.0, -c22 / across, c23 / across],
            [0.0, -c23 / spin, -c33 / spin],
        ]
    }

    /// The place of normalised creepages that are not all zero.
    #[inline]
    pub fn coordinates(&self, creepages: [f64; 3]) -> Coordinates {
        let x: [f64; 3] = std::array::from_fn(|k| creepages[k] * self.scales[k]);
        // Neither overflows nor vanishes when it is squared; hardly ever needs a division.
        let largest = x[0].abs().max(x[1].abs()).max(x[2].abs());
        let unit = if (SMALL..SMALL.recip()).contains(&largest) { 1.0 } else { largest };
        let part = if unit == 1.0 { x } else { x.map(|x| x / unit) };
        let flip = |negative: bool| if negative { -1.0 } else { 1.0 };
        let signs = [flip(x[0] < 0.0), flip(x[2] < 0.0)];
        self.placed(unit, [part[0].abs(), signs[1] * part[1], part[2].abs()], signs)
    }

    /// The place of x over a unit. The angles do not wait for its length.
    #[inline]
    fn placed(&self, unit: f64, x: [f64; 3], signs: [f64; 2]) -> Coordinates {
        let [kx, ky, ks] = self.stretching;
        let [along, across, spin] = [kx * x[0], ky * x[1], ks * x[2]];
        let distance = (across * across + spin * spin).sqrt();
        let kept = distance.max(POLE * along);
        let toward = if distance > 0.0 { [across, spin] } else { [1.0, 0.0] };
        let angles = f64x2::from([kept, toward[1]]).atan2(f64x2::from([along, toward[0]]));
        let [inclination, azimuth] = angles.to_array();
        let length = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
        let inverse = length.recip();
        let by_distance = if distance > 0.0 { distance.recip() } else { 1.0 };
        let [toward_y, toward_spin] = toward.map(|part| part * by_distance);
        let around = length / kept;
        let radial = length / (along * along + kept * kept);
        Coordinates {
            size: unit * length,
            direction: x.map(|part| part * inverse),
            signs,
            inclination,
            azimuth,
            pole: if kept > distance { distance / kept } else { 1.0 },
            inclination_slopes: [
                -kx * kept * radial,
                ky * along * radial * toward_y,
                ks * along * radial * toward_spin,
            ],
            azimuth_slopes: [0.0, -ky * toward_spin * around, ks * toward_y * around],
        }
    }
}
