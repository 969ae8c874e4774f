//! Rolling of an elliptic Hertzian patch on a Winkler bedding with Coulomb friction: the limit of
//! FASTSIM with the elliptic traction bound for pure longitudinal or lateral creepage.

use std::f64::consts::{FRAC_PI_2, PI};

/// Force over μN (dimensionless, magnitude) under a pure creepage of magnitude ξ (dimensionless).
///
/// With κ = c ξ a/(μ p0), where c is the bedding in N/m³, the traction of every strip of
/// half-length h rises linearly from the leading edge, c ξ h (1 − s) at x = h s, and meets the
/// bound μ p0 (h/a) √(1 − s²) at s = (κ² − 1)/(κ² + 1), the same in all strips; behind it the strip
/// slides. Integrated,
///
/// F/μN = (κ (1 − s)² + asin s + s √(1 − s²) + π/2)/π.
///
/// ```
/// use schlupf::solver::reference::winkler_strip::force_over_limit;
///
/// assert!(force_over_limit(1e-3) < 0.01 && force_over_limit(1e3) > 0.99);
/// ```
pub fn force_over_limit(stiffness_ratio: f64) -> f64 {
    let kappa = stiffness_ratio;
    let s = (kappa * kappa - 1.0) / (kappa * kappa + 1.0);
    let slip = s.asin() + s * (1.0 - s * s).sqrt() + FRAC_PI_2;
    (kappa * (1.0 - s).powi(2) + slip) / PI
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::force_over_limit;

    /// Full slip in the limit of large creepage; for small creepage everything sticks, and the
    /// integral of c ξ (x_e − x) is F = (8/3) a² b c ξ.
    #[test]
    fn limits_are_full_stick_and_full_slip() {
        assert_relative_eq!(force_over_limit(1e6), 1.0, max_relative = 1e-5);
        // μN = (2/3) π a b μ p0, so F/μN = 4κ/π.
        let small = 1e-4;
        assert_relative_eq!(force_over_limit(small), 4.0 * small / PI, max_relative = 1e-3);
    }
}
