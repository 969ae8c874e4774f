//! Shen, Hedrick and Elkins: the linear forces, with the saturation of Vermeulen and Johnson.

use crate::bodies::Kinematics;
use crate::numerics::dual::Number;
use crate::solution::Resultant;

use super::EllipticContact;
use super::elliptic_contact::Ellipse;

/// Forces and moment on the wheel, all three being the linear ones times |F|/|F_lin|, for a
/// friction limit μN (in N):
///
/// |F|/μN = ρ − ρ²/3 + ρ³/27 with ρ = |F_lin|/μN up to 3, and 1 beyond.
///
/// Sources: Vermeulen and Johnson, Contact of nonspherical elastic bodies transmitting tangential
/// forces, J. Appl. Mech. 31 (1964) 338–340; Shen, Hedrick and Elkins, A comparison of alternative
/// creep force models for rail vehicle dynamic analysis, 8th IAVSD Symposium (1983) 591–605, who
/// apply it to Kalker's linear forces with spin. Limits: small spin, as large spin saturates the
/// force differently; the moment is scaled like the forces, which the sources do not specify.
pub fn force(contact: &EllipticContact, kinematics: &Kinematics, limit: f64) -> Resultant {
    let ellipse = contact.ellipse(contact.normal.semi_axes());
    let [x, y, moment] = saturated(&ellipse, kinematics.creepages(), limit);
    Resultant::new(x, y, moment)
}

/// Fx, Fy (in N) and Mz (in N m).
pub(crate) fn saturated<T: Number>(ellipse: &Ellipse<T>, creepages: [T; 3], limit: T) -> [T; 3] {
    let linear = ellipse.linear_force(creepages);
    let saturation = reduction(linear[0].hypot(linear[1]) / limit);
    linear.map(|part| saturation * part)
}

/// |F|/|F_lin| for ρ = |F_lin|/μN, both dimensionless.
fn reduction<T: Number>(rho: T) -> T {
    let one = T::from(1.0);
    if rho.value() > 3.0 { one / rho } else { one - rho * (1.0 / 3.0) + rho * rho * (1.0 / 27.0) }
}

#[cfg(test)]
mod tests {
    use super::reduction;
    use approx::assert_relative_eq;

    /// Vermeulen and Johnson 1964: |F|/μN = 1 − (1 − ρ/3)³, which is 19/27 at ρ = 1 and 1 from ρ =
    /// 3 on.
    #[test]
    fn vermeulen_johnson_1964_saturation() {
        assert_relative_eq!(reduction(1.0), 19.0 / 27.0, max_relative = 1e-14);
        for rho in [0.1, 0.7, 2.0, 2.999] {
            let exact = 1.0 - (1.0 - rho / 3.0_f64).powi(3);
            assert_relative_eq!(rho * reduction(rho), exact, max_relative = 1e-13);
        }
        assert_eq!((reduction(0.0), reduction(4.0)), (1.0, 0.25));
    }
}
