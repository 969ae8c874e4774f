//! Polach: a creep curve in closed form with reduced slopes in the areas of adhesion and of slip.

use std::f64::consts::FRAC_2_PI;

use crate::kinematics::Kinematics;
use crate::method::AreaReduction;
use crate::solution::Resultant;

use super::EllipticContact;

/// Forces on the wheel for a friction limit μN, in N; the moment is unknown: NaN.
///
/// With the lateral creepage η_c = η + φa if that is larger in magnitude than η, else η, the total one
/// ν_c = √(ξ² + η_c²), and ε_c = ε ν_c/ν of the [stress gradient](EllipticContact::stress_gradient) ε:
///
/// F = (2/π) μN (k_A ε_c/(1 + (k_A ε_c)²) + arctan(k_S ε_c)),
/// Fx = −F ξ/ν_c, Fy = −F η/ν_c − (9/16) a μN K_M (1 + 6.3 (1 − e^(−a/b))) φ/ν_c,
///
/// where K_M = −|ε_s| (δ³/3 − δ²/2 + 1/6) + ⅓ (1 − δ²)^(3/2), δ = (ε_s² − 1)/(ε_s² + 1) and
/// ε_s = (8/3) G b √(ab) C23 |η_c|/(μN (1 + 6.3 (1 − e^(−a/b)))). For small creepages these are Kalker's forces, that under
/// creepage times (k_A + k_S)/2.
///
/// Sources: Polach, A fast wheel-rail forces calculation computer code, Vehicle System Dynamics Suppl. 33 (1999) 728–739, with
/// k_A = k_S = 1; Polach, Creep forces in simulations of traction vehicles running on adhesion limit, Wear 258
/// (2005) 992–1000, for k_A, k_S and the falling friction. Limits: no moment; the force of spin is
/// added without another cut, so both together may exceed μN by some per cent.
pub fn force(
    contact: &EllipticContact,
    kinematics: &Kinematics,
    limit: f64,
    reduction: AreaReduction,
) -> Resultant {
    let Kinematics { creepage_x: xi, creepage_y: eta, spin, .. } = *kinematics;
    let a = contact.normal.semi_axis_x;
    let with_spin = eta + spin * a;
    let eta_c = if with_spin.abs() > eta.abs() { with_spin } else { eta };
    let (nu, nu_c) = (xi.hypot(eta), xi.hypot(eta_c));
    if nu_c == 0.0 {
        return Resultant { x: 0.0, y: 0.0, moment_z: f64::NAN };
    }
    let gradient = contact.stress_gradient(kinematics, limit);
    let force = if nu > 0.0 { limit * curve(gradient * nu_c / nu, reduction) } else { 0.0 };
    let spin_force = limit * spin_share(contact, eta_c, limit) * spin;
    Resultant { x: -force * xi / nu_c, y: -(force * eta + spin_force) / nu_c, moment_z: f64::NAN }
}

/// F/μN of creepage alone, dimensionless.
fn curve(gradient: f64, AreaReduction { area_adhesion, area_slip }: AreaReduction) -> f64 {
    let adhesion = area_adhesion * gradient;
    FRAC_2_PI * (adhesion / (1.0 + adhesion * adhesion) + (area_slip * gradient).atan())
}

/// (9/16) a K_M (1 + 6.3 (1 − e^(−a/b))), in m.
fn spin_share(contact: &EllipticContact, eta_c: f64, limit: f64) -> f64 {
    let (a, b) = (contact.normal.semi_axis_x, contact.normal.semi_axis_y);
    let shape = 1.0 + 6.3 * (1.0 - (-a / b).exp());
    let unit = contact.shear_modulus * b * contact.lever() * contact.coefficients.c23;
    let gradient = 8.0 / 3.0 * unit * eta_c.abs() / (limit * shape);
    9.0 / 16.0 * a * shape * spin_saturation(gradient)
}

/// K_M, dimensionless. With 1 − δ = 2/(1 + ε²) the first term is ε (1 − δ)² (1 + 2δ)/6, in which nothing
/// cancels.
fn spin_saturation(gradient: f64) -> f64 {
    let rest = 2.0 / (1.0 + gradient * gradient);
    let delta = 1.0 - rest;
    let root = gradient * rest;
    root.powi(3) / 3.0 - gradient * rest * rest * (1.0 + 2.0 * delta) / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Polach 1999, K_M as printed, where it can be computed so.
    #[test]
    fn polach_1999_spin_saturation() {
        for gradient in [0.1, 0.5, 1.0, 3.0, 8.0_f64] {
            let delta = (gradient.powi(2) - 1.0) / (gradient.powi(2) + 1.0);
            let cubic = delta.powi(3) / 3.0 - delta.powi(2) / 2.0 + 1.0 / 6.0;
            let printed = -gradient * cubic + (1.0 - delta * delta).powf(1.5) / 3.0;
            assert_relative_eq!(spin_saturation(gradient), printed, max_relative = 1e-10);
        }
        assert_relative_eq!(spin_saturation(1e-4), 2.0 / 3.0 * 1e-4, max_relative = 1e-3);
    }

    /// k_A = k_S = 1: the slope is 4/π, that of the linear theory, and the limit is μN.
    #[test]
    fn polach_1999_curve_between_its_limits() {
        let plain = AreaReduction { area_adhesion: 1.0, area_slip: 1.0 };
        assert_relative_eq!(curve(1e-6, plain), 2.0 * FRAC_2_PI * 1e-6, max_relative = 1e-9);
        assert_relative_eq!(curve(1e6, plain), 1.0, max_relative = 1e-6);
    }
}
