//! Friction that varies across the patch, where the patch sticks in part, against independent
//! computations.

use std::sync::Arc;

use crate::common::{cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::elasticity::Winkler;
use schlupf::interface::Incremental;
use schlupf::interface::friction::{Across, Constant, Variation};
use schlupf::normal::Ellipse;
use schlupf::{Problem, Solution, Status, unwatched};

/// Coulomb friction of μ0 at y ≥ −1 mm that falls linearly to half of it at y = −4 mm: a rail with
/// a film of lubricant on its right.
fn lubricated(base: Problem, mu0: f64) -> Problem {
    let constant = Arc::new(Constant::new(mu0).unwrap());
    let across =
        Across::new(constant, Variation::over_y(vec![-4e-3, -1e-3], vec![0.5, 1.0]).unwrap());
    let mut lubricated = base;
    lubricated.interface.friction.law = Arc::new(across);
    lubricated
}

fn factor(y: f64) -> f64 {
    (0.5 + 0.5 * (y + 4e-3) / 3e-3).clamp(0.5, 1.0)
}

fn solve(problem: &Problem, across: usize) -> Solution {
    let solution = schlupf::solver::solve(problem, &cells(across), &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0, "marched");
    solution
}

/// Goal: force and moment on a Winkler bedding, from nearly full stick to nearly full slip, within
/// 0.5 % of μ0 N.
/// Set-up: a = 6, b = 5 mm, p0 = 1 GPa, c = 10¹³ N/m³, k_c = 10⁸/m, longitudinal creepage.
/// Source: Kalker 1982, strip by strip. With the half length h = a √(1 − y²/b²) and κ = c ξ a/(μ(y)
/// p0) the traction of a strip, c ξ (h − x), meets its bound μ(y) p0/a √(h² − x²) at x = s h, s =
/// (κ² − 1)/(κ² + 1). So the strip carries T(y) = ½ c ξ h² (1 − s)² + ½ μ(y) p0/a h² (asin s + s
/// √(1 − s²) + π/2), and Fx = −∫ T dy, Mz = ∫ y T dy.
#[test]
fn kalker_1982_strips_of_different_friction() {
    let (a, b, p0, mu0, c) = (6e-3, 5e-3, 1e9, 0.4, 1e13);
    for creepage in [0.002, 0.006, 0.02, 0.08] {
        let strip = |y: f64| {
            let square = a * a * (1.0 - (y / b) * (y / b));
            let mu = mu0 * factor(y);
            let kappa: f64 = c * creepage * a / (mu * p0);
            let s = (kappa * kappa - 1.0) / (kappa * kappa + 1.0);
            let slides = s.asin() + s * (1.0 - s * s).sqrt() + std::f64::consts::FRAC_PI_2;
            0.5 * square * (c * creepage * (1.0 - s).powi(2) + mu * p0 / a * slides)
        };
        let count = 20_000;
        let width = 2.0 * b / f64::from(count);
        let middles = (0..count).map(|k| -b + (f64::from(k) + 0.5) * width);
        let [force, moment] = middles
            .map(|y| [strip(y), y * strip(y)])
            .fold([0.0; 2], |sum, part| [sum[0] + width * part[0], sum[1] + width * part[1]]);
        let mut bed = lubricated(problem(rolling(creepage, 0.0, 0.0)), mu0);
        bed.interface.elasticity = Arc::new(Winkler::new(c, c).unwrap());
        bed.interface.contact_law = Incremental::new(1e8).unwrap().into();
        let found = solve(&bed, 60);
        let limit = mu0 * found.normal.load;
        println!("{creepage}: {:?} {force} {moment} {:?}", found.force, found.work);
        assert_relative_eq!(-found.force.x, force, epsilon = 5e-3 * limit);
        assert_relative_eq!(found.force.moment_z.unwrap(), moment, epsilon = 5e-3 * limit * 5e-3);
        assert!(found.work.operator_products < 200.0, "{:?}", found.work);
    }
}

/// Goal: forces and moment on the half-space within 0.8 % of μ0 N (√(ab)).
/// Set-up: a = b = 5 mm, p0 = 1 GPa, μ0 = 0.3, E = 210 GPa, ν = 0.28, Coulomb (k_c = 10⁹/m), 60
/// cells across.
/// Source: an independent solver (NumPy): cells whose middle lies in the ellipse, Hertz's pressure
/// there, influence numbers of Cerruti, and p = P(p + γ Δs), P the projection on the circle of
/// radius μ(y) pₙ, by a semismooth Newton method with dense matrices. Its cells are coarse at the
/// edge, which moves forces by up to 2 % of μ0 N; but as it does so with μ0 everywhere, too, where
/// CONTACT has the converged forces (`data/contact_creep.csv`), what is given here is CONTACT's
/// plus the difference that the variation makes. That differs between 20, 28 and 40 cells by at
/// most 0.0015.
#[test]
fn half_space_with_friction_that_varies_across() {
    for (motion, expected) in [
        ([0.002, 0.0, 0.0], [-0.7232, -0.0020, 0.0337]),
        ([0.0, 0.002, 0.0], [-0.0023, -0.6692, 0.1108]),
        ([0.001, -0.0005, 0.4], [-0.3277, -0.1515, -0.2069]),
        ([0.002, 0.001, 0.4], [-0.5785, -0.5674, -0.0620]),
    ] {
        let [xi, eta, spin] = motion;
        let mut case = lubricated(problem(rolling(xi, eta, spin)), 0.3);
        case.normal = Arc::new(Ellipse::from_peak_pressure(5e-3, 5e-3, 1e9).unwrap());
        case.interface.elasticity = half_space();
        case.interface.contact_law = Incremental::new(1e9).unwrap().into();
        let found = solve(&case, 60);
        println!("{motion:?}: {:?} {expected:?} {:?}", found.normalised, found.work);
        assert_relative_eq!(found.normalised.x, expected[0], epsilon = 8e-3);
        assert_relative_eq!(found.normalised.y, expected[1], epsilon = 8e-3);
        assert_relative_eq!(found.normalised.moment_z.unwrap(), expected[2], epsilon = 8e-3);
        assert!(found.work.operator_products < 250.0, "{:?}", found.work);
    }
}
