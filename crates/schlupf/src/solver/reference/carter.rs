//! Rolling of two cylinders with Coulomb friction: Carter, *On the action of a locomotive driving
//! wheel*, Proc. R. Soc. A 112 (1926); Johnson, *Contact Mechanics* (1985), §8.3.

use std::f64::consts::FRAC_PI_2;

/// Two cylinders that roll on each other under the pressure p0 √(1 − x²/a²), in plane strain.
///
/// A zone of length 2c at the leading edge sticks. The traction is that of full sliding minus one
/// of the same shape over the sticking zone (signs for ξ > 0, on the wheel),
///
/// t = −μ p0 (√(1 − x²/a²) − (c/a) √(1 − (x − d)²/c²)), d = a − c,
///
/// and as q0 √(1 − x²/a²) causes a relative displacement of the two surfaces of 2 q0 (1 − ν) x/(G
/// a), they stick where ξ = 2 μ p0 (1 − ν) d/(G a). Limits: similar bodies, no lateral creepage, no
/// spin.
///
/// ```
/// use schlupf::solver::reference::Carter;
///
/// let (half_length, peak_pressure) = (5e-3, 1e9);
/// let (friction_coefficient, shear_modulus, poisson_ratio) = (0.3, 82e9, 0.28);
/// let cylinders = Carter {
///     half_length, peak_pressure, friction_coefficient, shear_modulus, poisson_ratio,
/// };
/// let creepage = 0.5 * cylinders.full_sliding_creepage();
/// assert!((cylinders.force_over_limit(creepage) + 0.75).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carter {
    /// Half-length of the contact a, in m.
    pub half_length: f64,
    /// Largest pressure p0, in Pa.
    pub peak_pressure: f64,
    /// Coefficient of friction μ, dimensionless.
    pub friction_coefficient: f64,
    /// Combined shear modulus G of both bodies, in Pa.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio ν of both bodies, dimensionless.
    pub poisson_ratio: f64,
}

impl Carter {
    /// Normal load per metre of width N = ½ π a p0, in N/m.
    pub fn load(&self) -> f64 {
        FRAC_PI_2 * self.half_length * self.peak_pressure
    }

    /// Creepage at the onset of full sliding, 2 μ p0 (1 − ν)/G; dimensionless.
    pub fn full_sliding_creepage(&self) -> f64 {
        let limit = self.friction_coefficient * self.peak_pressure;
        2.0 * limit * (1.0 - self.poisson_ratio) / self.shear_modulus
    }

    /// Half-length of the sticking zone c (in m) under the creepage ξ (dimensionless).
    pub fn stick_half_length(&self, creepage: f64) -> f64 {
        self.half_length * (1.0 - creepage.abs() / self.full_sliding_creepage()).max(0.0)
    }

    /// Force on the wheel divided by μN (dimensionless) under the creepage ξ (dimensionless):
    /// F/μN = −sgn ξ (1 − (c/a)²).
    pub fn force_over_limit(&self, creepage: f64) -> f64 {
        let stick = self.stick_half_length(creepage) / self.half_length;
        -creepage.signum() * (1.0 - stick * stick)
    }

    /// Traction on the wheel (in Pa) at x (in m), leading edge at x = a, under the creepage ξ
    /// (dimensionless).
    pub fn traction(&self, creepage: f64, x: f64) -> f64 {
        let (a, c) = (self.half_length, self.stick_half_length(creepage));
        let semicircle = |x: f64, half: f64| (half * half - x * x).max(0.0).sqrt() / a;
        let shape = semicircle(x, a) - semicircle(x - (a - c), c);
        -creepage.signum() * self.friction_coefficient * self.peak_pressure * shape
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const STEEL: Carter = Carter {
        half_length: 5e-3,
        peak_pressure: 1e9,
        friction_coefficient: 0.3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
    };

    /// Johnson 1985, §8.3: F/μN = 1 − (1 − ξR/(μa))² with 1/R = 2 p0/(E* a), E* = G/(1 − ν).
    #[test]
    fn johnson_1985_creep_curve() {
        let radius = 82e9 / 0.72 * 5e-3 / 2e9;
        for creepage in [1e-4, 1e-3, 4e-3] {
            let rest = 1.0 - creepage * radius / (0.3 * 5e-3);
            let force = STEEL.force_over_limit(creepage);
            assert_relative_eq!(force, rest * rest - 1.0, max_relative = 1e-12);
            assert_relative_eq!(STEEL.force_over_limit(-creepage), -force);
        }
        assert_relative_eq!(STEEL.full_sliding_creepage(), 0.3 * 5e-3 / radius);
        assert_eq!(STEEL.force_over_limit(0.1), -1.0);
        assert_eq!(STEEL.force_over_limit(0.0).abs(), 0.0);
    }

    /// The traction integrates to the force, equals that of sliding behind the sticking zone and
    /// stays below it within the zone.
    #[test]
    fn traction_adds_up_to_the_force() {
        const NODES: u32 = 20_000;
        let (creepage, a) = (2e-3, STEEL.half_length);
        let edge = a - 2.0 * STEEL.stick_half_length(creepage);
        let mut sum = 0.0;
        for k in 0..NODES {
            let x = a * (2.0 * (f64::from(k) + 0.5) / f64::from(NODES) - 1.0);
            let traction = STEEL.traction(creepage, x);
            let limit = 0.3e9 * (1.0 - (x / a).powi(2)).sqrt();
            assert!(traction <= 0.0 && -traction <= limit * (1.0 + 1e-12));
            if x < edge {
                assert_relative_eq!(traction, -limit, max_relative = 1e-12);
            }
            sum += traction * 2.0 * a / f64::from(NODES);
        }
        let force = STEEL.force_over_limit(creepage) * 0.3 * STEEL.load();
        assert_relative_eq!(sum, force, max_relative = 1e-5);
    }
}
