//! Polach's method: a creep curve in closed form with reduced slopes in the areas of adhesion and
//! of slip.

use std::f64::consts::{FRAC_2_PI, PI};

use crate::bodies::Kinematics;
use crate::numerics::dual::{Dual, Number};
use crate::problem::AreaReduction;
use crate::solution::Resultant;

use super::EllipticContact;
use super::elliptic_contact::Ellipse;

/// Forces on the wheel for a friction limit μN, in N; the moment is unknown (`None`).
///
/// With the lateral creepage η_c = η + φa if that is larger in magnitude than η, otherwise η, the
/// total creepage ν_c = √(ξ² + η_c²), and ε_c = ε ν_c/ν with the gradient of the stress in the area
/// of adhesion, ε = G π a b √((C11 ξ)² + (C22 η)²)/(4 μN), ν = √(ξ² + η²):
///
/// F = (2/π) μN (k_A ε_c/(1 + (k_A ε_c)²) + arctan(k_S ε_c)),
/// Fx = −F ξ/ν_c, Fy = −F η/ν_c − (9/16) a μN K_M (1 + 6.3 (1 − e^(−a/b))) φ/ν_c,
///
/// where K_M = −|ε_s| (δ³/3 − δ²/2 + 1/6) + ⅓ (1 − δ²)^(3/2), δ = (ε_s² − 1)/(ε_s² + 1) and ε_s =
/// (8/3) G b √(ab) C23 |η_c|/(μN (1 + 6.3 (1 − e^(−a/b)))). For small creepages these are Kalker's
/// forces, with that due to creepage multiplied by (k_A + k_S)/2.
///
/// Sources: Polach, A fast wheel-rail forces calculation computer code, Vehicle System Dynamics
/// Suppl. 33 (1999) 728–739, with k_A = k_S = 1; Polach, Creep forces in simulations of traction
/// vehicles running on adhesion limit, Wear 258 (2005) 992–1000, for k_A, k_S and the falling
/// friction. Limits: no moment; the spin force is added without further limitation, so both
/// together may exceed μN by a few per cent.
///
/// ```
/// use schlupf::problem::{AreaReduction, FastMethod};
/// use schlupf::solver::simplified::{FastContact, polach};
/// use schlupf::{Options, Problem};
///
/// let problem = Problem::builder().creepage_x(0.002).build()?;
/// let method = FastMethod::Polach(AreaReduction::DRY);
/// let contact = FastContact::new(&problem, method, &Options::default())?;
/// let (limit, dry) = (0.4 * 80e3, AreaReduction::DRY);
/// let force = polach::force(contact.contact(), &problem.kinematics, limit, dry);
/// assert!(force.x < 0.0 && force.x > -limit);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn force(
    contact: &EllipticContact,
    kinematics: &Kinematics,
    limit: f64,
    reduction: AreaReduction,
) -> Resultant {
    let ellipse = contact.present_ellipse();
    let AreaReduction { area_adhesion, area_slip } = reduction;
    let [x, y] = limited(&ellipse, kinematics.creepages(), limit, [area_adhesion, area_slip]);
    Resultant { x, y, moment_z: None }
}

/// Fx and Fy (in N), for k_A and k_S.
///
/// Where there is no creepage, the derivatives are those along ξ and along η: the stress gradient
/// has no other there unless C11 = C22.
pub(crate) fn limited<T: Number>(
    ellipse: &Ellipse<T>,
    [xi, eta, spin]: [T; 3],
    limit: T,
    [adhesion, slip]: [T; 2],
) -> [T; 2] {
    let [a, b] = ellipse.semi_axes;
    let with_spin = eta + spin * a;
    let eta_c = if with_spin.abs().value() > eta.abs().value() { with_spin } else { eta };
    let (nu, nu_c) = (xi.hypot(eta), xi.hypot(eta_c));
    if nu_c.value() == 0.0 {
        let [x, y, _] = ellipse.linear_force([xi, eta, T::from(0.0)]);
        let [_, spin_force, _] = ellipse.linear_force([T::from(0.0), T::from(0.0), spin]);
        let part = (adhesion + slip) * 0.5;
        return [part * x, part * y + spin_force];
    }
    // ε/ν, without spin.
    let unit = a * b * (0.25 * PI * ellipse.shear_modulus) / limit;
    let [c11, c22, c23, _] = ellipse.coefficients;
    let rate = (c11 * xi).hypot(c22 * eta);
    let over_creepage = |rate: T| limit * curve(unit * rate * nu_c, [adhesion, slip]) / nu_c;
    let force = if nu.value() > 0.0 {
        [over_creepage(rate / nu); 2]
    } else {
        [c11, c22].map(over_creepage)
    };
    let shape = T::from(1.0 + 6.3) - (-(a / b)).exp() * 6.3;
    let spin_gradient = b * ellipse.lever() * c23 * eta_c.abs() / (limit * shape)
        * (8.0 / 3.0 * ellipse.shear_modulus);
    let spin_force = limit * a * shape * spin_saturation(spin_gradient) * spin / nu_c;
    [-(force[0] * xi), -(force[1] * eta + spin_force * (9.0 / 16.0))]
}

/// The forces with their derivatives, for identification.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Differentiated {
    /// (Fx, Fy) on the wheel, in N.
    pub force: [f64; 2],
    /// Derivatives with respect to the friction limit μN, dimensionless.
    pub by_limit: [f64; 2],
    /// Derivatives with respect to k_A, in N.
    pub by_area_adhesion: [f64; 2],
    /// Derivatives with respect to k_S, in N.
    pub by_area_slip: [f64; 2],
}

/// The same as [`force`], with its derivatives with respect to the friction limit (in N) and the
/// reductions.
pub fn differentiated_force(
    contact: &EllipticContact,
    kinematics: &Kinematics,
    limit: f64,
    reduction: AreaReduction,
) -> Differentiated {
    let AreaReduction { area_adhesion, area_slip } = reduction;
    let [limit, area_adhesion, area_slip] = Dual::<3>::variables([limit, area_adhesion, area_slip]);
    let ellipse = contact.ellipse(contact.normal.semi_axes().map(Dual::from));
    let creepages = kinematics.creepages().map(Dual::from);
    let found = limited(&ellipse, creepages, limit, [area_adhesion, area_slip]);
    let by = |k: usize| found.map(|force| force.slopes[k]);
    Differentiated {
        force: found.map(|force| force.value),
        by_limit: by(0),
        by_area_adhesion: by(1),
        by_area_slip: by(2),
    }
}

/// F/μN due to creepage alone, dimensionless.
fn curve<T: Number>(gradient: T, [adhesion, slip]: [T; 2]) -> T {
    let adhesion = adhesion * gradient;
    (adhesion / (T::from(1.0) + adhesion * adhesion) + (slip * gradient).atan()) * FRAC_2_PI
}

/// K_M, dimensionless. With 1 − δ = 2/(1 + ε²) the first term is ε (1 − δ)² (1 + 2δ)/6, which has
/// no cancellation.
fn spin_saturation<T: Number>(gradient: T) -> T {
    let one = T::from(1.0);
    let rest = T::from(2.0) / (one + gradient * gradient);
    let delta = one - rest;
    let root = gradient * rest;
    root * root * root * (1.0 / 3.0) - root * rest * (one + delta * 2.0) * (1.0 / 6.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::NormalSummary;
    use crate::solver::reference::CreepCoefficients;
    use approx::assert_relative_eq;

    /// Polach 1999, K_M as printed, where that form can be evaluated.
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

    #[test]
    fn derivatives_are_those_of_central_differences() {
        let normal = NormalSummary {
            load: 82e3,
            semi_axis_x: 8e-3,
            semi_axis_y: 4e-3,
            peak_pressure: 1.2e9,
            approach: None,
            origin: None,
            parts: 1,
        };
        let coefficients = CreepCoefficients { c11: 4.8, c22: 4.3, c23: 2.2, c33: 0.7 };
        let contact = EllipticContact::new_of(normal, 82e9, coefficients, 0.0);
        let dry = AreaReduction { area_adhesion: 0.9, area_slip: 0.4 };
        for (xi, eta, spin) in [
            (3e-3, 0.0, 0.0),
            (1e-3, -2e-3, 0.4),
            (0.0, 6e-4, 0.6),
            (2e-3, 0.0, -0.3),
            (0.0, 0.0, 0.5),
        ] {
            let motion = Kinematics {
                creepage_x: xi,
                creepage_y: eta,
                spin,
                ..Kinematics::free_rolling(20.0)
            };
            let at = |limit: f64, area_adhesion: f64, area_slip: f64| {
                let reduction = AreaReduction { area_adhesion, area_slip };
                let found = force(&contact, &motion, limit, reduction);
                [found.x, found.y]
            };
            let (limit, part) = (3e4, 1e-5);
            let exact = differentiated_force(&contact, &motion, limit, dry);
            assert_eq!(exact.force, at(limit, 0.9, 0.4));
            let rows = [
                (exact.by_limit, [1.0 + part, 1.0 - part].map(|f| at(f * limit, 0.9, 0.4)), limit),
                (exact.by_area_adhesion, [0.9 + part, 0.9 - part].map(|k| at(limit, k, 0.4)), 1.0),
                (exact.by_area_slip, [0.4 + part, 0.4 - part].map(|k| at(limit, 0.9, k)), 1.0),
            ];
            for (exact, [plus, minus], scale) in rows {
                for c in 0..2 {
                    let difference = (plus[c] - minus[c]) / (2.0 * part);
                    let error = (exact[c] * scale - difference).abs();
                    assert!(error < 1e-8 * limit, "{motion:?}: {exact:?} {difference}");
                }
            }
        }
    }

    /// k_A = k_S = 1: the slope is 4/π, that of the linear theory, and the limit is μN.
    #[test]
    fn polach_1999_curve_between_its_limits() {
        let plain = [1.0, 1.0];
        assert_relative_eq!(curve(1e-6, plain), 2.0 * FRAC_2_PI * 1e-6, max_relative = 1e-9);
        assert_relative_eq!(curve(1e6, plain), 1.0, max_relative = 1e-6);
    }
}
