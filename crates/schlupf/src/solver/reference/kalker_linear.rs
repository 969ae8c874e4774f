//! Kalker's linear theory of rolling: forces for vanishing creepage, in full adhesion.

use crate::bodies::Kinematics;
use crate::numerics::dual::Number;
use crate::solution::Resultant;

/// Creep coefficients of an elliptic contact (Kalker 1967; Kalker, *Three-dimensional elastic
/// bodies in rolling contact*, 1990, Table E.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepCoefficients {
    /// C11: longitudinal force under longitudinal creepage, dimensionless.
    pub c11: f64,
    /// C22: lateral force under lateral creepage, dimensionless.
    pub c22: f64,
    /// C23 = −C32: lateral force under spin, dimensionless.
    pub c23: f64,
    /// C33: moment under spin, dimensionless.
    pub c33: f64,
}

impl CreepCoefficients {
    /// Forces and moment on the wheel, with c = √(ab), the semi-axes (in m) and the combined shear
    /// modulus G (in Pa):
    ///
    /// Fx = −G c² C11 ξ,  Fy = −G c² (C22 η + c C23 φ),  Mz = −G c³ (−C23 η + c C33 φ).
    ///
    /// They hold as long as they are small compared with μN.
    ///
    /// ```
    /// use schlupf::solver::kalker_coefficients::interpolated_coefficients;
    /// use schlupf::bodies::Kinematics;
    ///
    /// let creeping = Kinematics { creepage_x: 1e-5, ..Kinematics::free_rolling(30.0) };
    /// let force = interpolated_coefficients(1.0, 0.25)?.force(&creeping, [5e-3, 5e-3], 82e9);
    /// assert!((force.x + 82e9 * 25e-6 * 4.12 * 1e-5).abs() < 1.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn force(
        &self,
        kinematics: &Kinematics,
        semi_axes: [f64; 2],
        shear_modulus: f64,
    ) -> Resultant {
        let coefficients = [self.c11, self.c22, self.c23, self.c33];
        let [x, y, moment] =
            linear_force(coefficients, kinematics.creepages(), semi_axes, shear_modulus);
        Resultant::new(x, y, moment)
    }
}

/// The same from C11, C22, C23 and C33: Fx, Fy (in N) and Mz (in N m).
pub(crate) fn linear_force<T: Number>(
    [c11, c22, c23, c33]: [T; 4],
    [xi, eta, spin]: [T; 3],
    [a, b]: [T; 2],
    shear_modulus: f64,
) -> [T; 3] {
    let unit = -(a * b * shear_modulus);
    let lever = (a * b).sqrt();
    let spin = lever * spin;
    [unit * c11 * xi, unit * (c22 * eta + c23 * spin), unit * lever * (c33 * spin - c23 * eta)]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Vollebregt 2022 (CONTACT, case R0.5_001): a/b = 0.5, ξ = 1e-5, μ = 0.3, N = 52 359.878 N,
    /// steel of E = 210 GPa, ν = 0.28 give Fx = −0.00488 μN; coefficients from
    /// `data/kalker_coefficients.csv`.
    #[test]
    fn vollebregt_2022_force_of_a_small_creepage() {
        let coefficients = CreepCoefficients { c11: 3.7451, c22: 3.0301, c23: 0.9432, c33: 1.9779 };
        let kinematics = Kinematics { creepage_x: 1e-5, ..Kinematics::free_rolling(30.0) };
        let axes = [3.535_533_9e-3, 7.071_067_8e-3];
        let force = coefficients.force(&kinematics, axes, 82.031_25e9);
        assert_relative_eq!(force.x / (0.3 * 52_359.878), -0.00488, max_relative = 4e-3);
        assert_eq!((force.y.abs(), force.moment_z.map(f64::abs)), (0.0, Some(0.0)));
    }

    /// Reciprocity: the force under spin and the moment under creepage are equal and opposite.
    #[test]
    fn spin_and_lateral_creepage_are_reciprocal() {
        let coefficients = CreepCoefficients { c11: 4.12, c22: 3.67, c23: 1.47, c33: 1.19 };
        let of = |creepage_y: f64, spin: f64| {
            let kinematics = Kinematics { creepage_y, spin, ..Kinematics::free_rolling(30.0) };
            coefficients.force(&kinematics, [2e-3, 8e-3], 82e9)
        };
        let (creeping, spinning) = (of(1e-4, 0.0), of(0.0, 1e-4));
        let [creeping_moment, spinning_moment] =
            [creeping, spinning].map(|force| force.moment_z.unwrap());
        assert_relative_eq!(creeping_moment, -spinning.y, max_relative = 1e-14);
        // c = 4 mm.
        let unit = 82e9 * 4e-3_f64.powi(3);
        assert_relative_eq!(spinning.y, -unit * 1.47e-4, max_relative = 1e-14);
        assert!(spinning_moment < 0.0 && creeping.y < 0.0);
    }
}
