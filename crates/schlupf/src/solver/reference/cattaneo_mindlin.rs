//! Tangential shift of two spheres in contact: Cattaneo 1938; Mindlin 1949; Johnson, *Contact
//! Mechanics* (1985), §7.2(d).

/// Two spheres in a circular contact under the pressure p0 √(1 − r²/a²), shifted by less than the
/// full-sliding shift.
///
/// A disk of radius c in the middle sticks, the ring around it slides. The traction is that of full
/// sliding minus one of the same shape on the disk,
///
/// t = μ p0 (√(1 − r²/a²) − (c/a) √(1 − r²/c²)), c/a = (1 − F/μN)^⅓.
///
/// Limits: similar bodies; exact for ν = 0, otherwise the small traction transverse to the force is
/// neglected.
///
/// ```
/// use schlupf::solver::reference::CattaneoMindlin;
///
/// let (radius, load) = (5e-3, 50e3);
/// let (friction_coefficient, shear_modulus, poisson_ratio) = (0.3, 82e9, 0.28);
/// let spheres = CattaneoMindlin {
///     radius, load, friction_coefficient, shear_modulus, poisson_ratio,
/// };
/// assert!((spheres.stick_radius(0.875) / 5e-3 - 0.5).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CattaneoMindlin {
    /// Radius of the contact a, in m.
    pub radius: f64,
    /// Normal load N, in N.
    pub load: f64,
    /// Coefficient of friction μ, dimensionless.
    pub friction_coefficient: f64,
    /// Combined shear modulus G of both bodies, in Pa.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio ν of both bodies, dimensionless.
    pub poisson_ratio: f64,
}

impl CattaneoMindlin {
    /// Shift at the onset of full sliding, δ₁ = 3 μN (2 − ν)/(8 G a), in m (Johnson 1985, §7.2(d),
    /// with F = μN).
    pub fn full_sliding_shift(&self) -> f64 {
        let limit = self.friction_coefficient * self.load;
        3.0 * limit * (2.0 - self.poisson_ratio) / (8.0 * self.shear_modulus * self.radius)
    }

    /// Relative shift of the two bodies (in m) under a force over μN (dimensionless, 0 to 1): δ =
    /// δ₁ (1 − (1 − F/μN)^⅔) (Johnson 1985, §7.2(d)).
    pub fn shift(&self, force_over_limit: f64) -> f64 {
        let stick = self.stick_radius(force_over_limit) / self.radius;
        self.full_sliding_shift() * (1.0 - stick * stick)
    }

    /// Force over μN (dimensionless) for a non-negative shift (in m): 1 − (1 − δ/δ₁)^{3/2}.
    pub fn force_over_limit(&self, shift: f64) -> f64 {
        1.0 - (1.0 - shift / self.full_sliding_shift()).max(0.0).powf(1.5)
    }

    /// Radius of the sticking disk c = a (1 − F/μN)^⅓ (in m) under a force over μN (dimensionless).
    pub fn stick_radius(&self, force_over_limit: f64) -> f64 {
        self.radius * (1.0 - force_over_limit).max(0.0).cbrt()
    }

    /// Traction along the force (in Pa) at the distance r from the centre (in m) under a force over
    /// μN (dimensionless).
    pub fn traction(&self, force_over_limit: f64, r: f64) -> f64 {
        let (a, c) = (self.radius, self.stick_radius(force_over_limit));
        let peak_pressure = 1.5 * self.load / (std::f64::consts::PI * a * a);
        let dome = |radius: f64| (radius * radius - r * r).max(0.0).sqrt() / a;
        self.friction_coefficient * peak_pressure * (dome(a) - dome(c))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const STEEL: CattaneoMindlin = CattaneoMindlin {
        radius: 5e-3,
        load: 50e3,
        friction_coefficient: 0.3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
    };

    /// Mindlin 1949: without sliding the stiffness of two equal bodies is 4 G a/(2 − ν).
    #[test]
    fn mindlin_1949_initial_stiffness() {
        let force = 1e-6 * 0.3 * 50e3;
        let stiffness = force / STEEL.shift(1e-6);
        assert_relative_eq!(stiffness, 4.0 * 82e9 * 5e-3 / 1.72, max_relative = 1e-5);
    }

    #[test]
    fn shift_and_force_belong_together() {
        for force in [0.0, 0.1, 0.5, 0.9, 1.0] {
            let shift = STEEL.shift(force);
            assert_relative_eq!(STEEL.force_over_limit(shift), force, epsilon = 1e-14);
        }
        assert_eq!(STEEL.force_over_limit(1.0), 1.0);
        assert_relative_eq!(STEEL.stick_radius(0.875), 2.5e-3, max_relative = 1e-14);
    }

    /// The traction integrates to the force, and is μ times the pressure in the sliding ring.
    #[test]
    fn traction_adds_up_to_the_force() {
        const NODES: u32 = 20_000;
        let width = STEEL.radius / f64::from(NODES);
        let ring = |k: u32| {
            let r = (f64::from(k) + 0.5) * width;
            STEEL.traction(0.6, r) * std::f64::consts::TAU * r * width
        };
        let sum: f64 = (0..NODES).map(ring).sum();
        assert_relative_eq!(sum, 0.6 * 0.3 * STEEL.load, max_relative = 1e-5);
        let peak = 0.3 * 1.5 * STEEL.load / (std::f64::consts::PI * 25e-6);
        assert_relative_eq!(STEEL.traction(0.6, 4e-3), peak * 0.6, max_relative = 1e-12);
    }
}
