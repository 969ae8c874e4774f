//! The stress tensor at a point.

use std::f64::consts::FRAC_PI_3;
use std::ops::{Add, Mul};

/// The stress at a point: components in the contact frame (x along rolling, y to the left, z up),
/// tension positive.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Stress {
    /// Normal stress along rolling σxx, in Pa.
    pub xx: f64,
    /// Normal stress across rolling σyy, in Pa.
    pub yy: f64,
    /// Normal stress perpendicular to the surface σzz, in Pa.
    pub zz: f64,
    /// Shear stress σxy, in Pa.
    pub xy: f64,
    /// Shear stress σxz, in Pa.
    pub xz: f64,
    /// Shear stress σyz, in Pa.
    pub yz: f64,
}

impl Stress {
    /// From σxx, σyy, σzz, σxy, σxz and σyz, in Pa.
    pub const fn new([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Self {
        Self { xx, yy, zz, xy, xz, yz }
    }

    /// σxx, σyy, σzz, σxy, σxz and σyz, in Pa.
    pub const fn components(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.xz, self.yz]
    }

    /// Hydrostatic stress (σxx + σyy + σzz)/3, in Pa; negative under pressure.
    pub fn hydrostatic(&self) -> f64 {
        (self.xx + self.yy + self.zz) / 3.0
    }

    /// Equivalent stress of von Mises (1913), in Pa: √3 times the root of the second invariant of
    /// the deviator,
    ///
    /// σ_v² = ½ ((σxx − σyy)² + (σyy − σzz)² + (σzz − σxx)²) + 3 (σxy² + σxz² + σyz²).
    pub fn von_mises(&self) -> f64 {
        let normal = [self.xx - self.yy, self.yy - self.zz, self.zz - self.xx];
        let squares: f64 = normal.iter().map(|difference| difference * difference).sum();
        (0.5 * squares + 3.0 * self.shear_squares()).sqrt()
    }

    /// Principal stresses in Pa, the largest one first: the roots of the characteristic polynomial
    /// by the cosines of a third of an angle.
    pub fn principal(&self) -> [f64; 3] {
        let mean = self.hydrostatic();
        // σ_v = √(3 J₂); the roots are the mean plus 2 √(J₂/3) cos(θ + 2πk/3).
        let radius = 2.0 / 3.0 * self.von_mises();
        if radius == 0.0 {
            return [mean; 3];
        }
        let [x, y, z] = [self.xx, self.yy, self.zz].map(|normal| (normal - mean) / radius);
        let [xy, xz, yz] = [self.xy, self.xz, self.yz].map(|shear| shear / radius);
        let determinant = x * y * z + 2.0 * xy * xz * yz - x * yz * yz - y * xz * xz - z * xy * xy;
        // cos 3θ = 4 det of the deviator over the cube of the radius.
        let angle = (4.0 * determinant).clamp(-1.0, 1.0).acos() / 3.0;
        [angle, angle - 2.0 * FRAC_PI_3, angle + 2.0 * FRAC_PI_3].map(|a| mean + radius * a.cos())
    }

    /// Largest shear stress at the point, over all planes, in Pa: half the difference between the
    /// largest and the smallest principal stress (Tresca).
    pub fn largest_shear(&self) -> f64 {
        let [largest, _, smallest] = self.principal();
        0.5 * (largest - smallest)
    }

    fn shear_squares(&self) -> f64 {
        self.xy * self.xy + self.xz * self.xz + self.yz * self.yz
    }

    /// The tensor as rows, in Pa.
    pub const fn tensor(&self) -> [[f64; 3]; 3] {
        let Self { xx, yy, zz, xy, xz, yz } = *self;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }
}

impl Add for Stress {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (one, two) = (self.components(), other.components());
        Self::new(std::array::from_fn(|c| one[c] + two[c]))
    }
}

impl Mul<f64> for Stress {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self::new(self.components().map(|component| factor * component))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Uniaxial tension, pure shear and hydrostatic pressure have known invariants.
    #[test]
    fn simple_states_have_known_invariants() {
        let tension = Stress { xx: 3.0, ..Stress::default() };
        assert_relative_eq!(tension.von_mises(), 3.0);
        assert_relative_eq!(tension.largest_shear(), 1.5);
        let shear = Stress { yz: 2.0, ..Stress::default() };
        assert_relative_eq!(shear.von_mises(), 2.0 * 3.0_f64.sqrt());
        for (found, expected) in shear.principal().into_iter().zip([2.0, 0.0, -2.0]) {
            assert_relative_eq!(found, expected, epsilon = 1e-14);
        }
        let pressure = Stress { xx: -5.0, yy: -5.0, zz: -5.0, ..Stress::default() };
        assert_eq!(pressure.principal(), [-5.0; 3]);
        assert_eq!((pressure.hydrostatic(), pressure.largest_shear()), (-5.0, 0.0));
        assert_eq!(Stress::default().principal(), [0.0; 3]);
    }

    /// A full tensor against its eigenvalues: [[2, −1, 0], [−1, 2, −1], [0, −1, 2]] has 2 ± √2 and
    /// 2.
    #[test]
    fn principal_stresses_are_eigenvalues() {
        let stress = Stress { xx: 2.0, yy: 2.0, zz: 2.0, xy: -1.0, xz: 0.0, yz: -1.0 };
        let root = 2.0_f64.sqrt();
        for (found, expected) in stress.principal().into_iter().zip([2.0 + root, 2.0, 2.0 - root]) {
            assert_relative_eq!(found, expected, max_relative = 1e-12);
        }
        assert_relative_eq!(stress.largest_shear(), root, max_relative = 1e-12);
    }
}
