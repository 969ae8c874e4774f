//! Rigid slip in the contact from the motion of the wheel; Eqs. (1)–(3), (9)–(12).

use crate::reporting::{Error, Quantity, Requirement, require, require_finite, require_positive};

/// The point to which creepages and moment refer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum ReferencePoint {
    /// The centre of the patch, which is the origin of the contact frame.
    #[default]
    Patch,
    /// The origin of the coordinates used in the file of the normal contact.
    File,
}

impl ReferencePoint {
    /// Its name in case files and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Patch => "patch",
            Self::File => "file",
        }
    }
}

/// How the wheel moves over the rail.
///
/// The rigid slip of the wheel over the rail, divided by the speed, is (ξ − φ y, η + φ x), with x
/// and y measured from the reference point of the creepages ([`ReferencePoint`]). Braking has
/// ξ > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Kinematics {
    /// Speed of the vehicle and of the contact frame v0, in m/s.
    pub speed: f64,
    /// Longitudinal creepage ξ, dimensionless; positive when braking.
    pub creepage_x: f64,
    /// Lateral creepage η, dimensionless.
    pub creepage_y: f64,
    /// Spin creepage φ, in 1/m.
    pub spin: f64,
}

impl Kinematics {
    /// Rolling at a speed (in m/s) without creepage and spin.
    pub fn free_rolling(speed: f64) -> Self {
        Self { speed, creepage_x: 0.0, creepage_y: 0.0, spin: 0.0 }
    }

    /// Exact kinematics of a wheel of rolling radius R (in m) that turns at ω (in rad/s) with the
    /// yaw angle α (in rad): ξ = (v0 cos α − ω R)/v0, η = −sin α. For small α these are Eq. (3) and
    /// (12) of Neuhaus and Sextro (2014).
    ///
    /// ```
    /// use schlupf::bodies::Kinematics;
    ///
    /// let braking = Kinematics::from_wheel(30.0, 64.7, 0.46, 0.0);
    /// assert!((braking.creepage_x - (30.0 - 64.7 * 0.46) / 30.0).abs() < 1e-12);
    /// ```
    pub fn from_wheel(
        speed: f64,
        angular_velocity: f64,
        wheel_radius: f64,
        yaw_angle: f64,
    ) -> Self {
        Self {
            speed,
            creepage_x: yaw_angle.cos() - angular_velocity * wheel_radius / speed,
            creepage_y: -yaw_angle.sin(),
            spin: 0.0,
        }
    }

    /// ξ, η (dimensionless) and φ, in 1/m.
    pub fn creepages(&self) -> [f64; 3] {
        [self.creepage_x, self.creepage_y, self.spin]
    }

    /// Whether there is neither creepage nor spin.
    pub fn is_pure_rolling(&self) -> bool {
        self.creepages() == [0.0; 3]
    }

    /// Circumferential speed of the wheel ω R = (cos α − ξ) v0, in m/s.
    pub fn circumferential_speed(&self) -> f64 {
        (self.locking_creepage() - self.creepage_x) * self.speed
    }

    /// Longitudinal creepage √(1 − η²) at which the wheel locks, dimensionless.
    fn locking_creepage(&self) -> f64 {
        (1.0 - self.creepage_y.powi(2)).sqrt()
    }

    /// Rigid slip of the wheel over the rail at a point (in m), divided by the speed;
    /// dimensionless.
    pub fn rigid_slip(&self, x: f64, y: f64) -> [f64; 2] {
        [self.creepage_x - self.spin * y, self.creepage_y + self.spin * x]
    }

    /// The same motion with the creepages at another point, which lies at (x, y) (in m) from the
    /// present one: ξ' = ξ − φ y, η' = η + φ x.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> Self {
        let [creepage_x, creepage_y] = self.rigid_slip(x, y);
        Self { creepage_x, creepage_y, ..*self }
    }

    /// The same speed with creepages that change by a multiple of others.
    pub(crate) fn changed(&self, factor: f64, change: &Self) -> Self {
        Self {
            creepage_x: self.creepage_x + factor * change.creepage_x,
            creepage_y: self.creepage_y + factor * change.creepage_y,
            spin: self.spin + factor * change.spin,
            ..*self
        }
    }

    /// Derivatives of ln(v0/(ωR)) with respect to ξ and η, dimensionless.
    pub fn contact_time_ratio_by_creepage(&self) -> [f64; 2] {
        let along = (1.0 - self.creepage_y.powi(2)).sqrt();
        let contact_time_ratio = (along - self.creepage_x).recip();
        [contact_time_ratio, contact_time_ratio * self.creepage_y / along]
    }

    /// Checks that the wheel rolls: a speed, finite creepages, ω R > 0.
    #[inline]
    pub fn check(&self) -> Result<(), Error> {
        require_positive(Quantity::Speed, self.speed)?;
        require_finite(Quantity::CreepageX, self.creepage_x)?;
        require(Quantity::CreepageY, Requirement::Inside(-1.0, 1.0), self.creepage_y)?;
        require_finite(Quantity::Spin, self.spin)?;
        let rolling = self.circumferential_speed();
        if rolling > 0.0 {
            return Ok(());
        }
        let limit = self.locking_creepage();
        Err(Error::NoRolling { creepage_x: self.creepage_x, limit, rolling })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Neuhaus and Sextro 2014, Eqs. (3) and (12): ξ = s, η = −α to first order in α.
    #[test]
    fn neuhaus_sextro_2014_small_angles_agree_to_first_order() {
        let (speed, radius, slip) = (30.0, 0.46, 0.008);
        let angular_velocity = (1.0 - slip) * speed / radius;
        for angle in [1e-2, 1e-3, 1e-4] {
            let exact = Kinematics::from_wheel(speed, angular_velocity, radius, angle);
            assert!((exact.creepage_x - slip).abs() < 0.51 * angle * angle);
            assert!((exact.creepage_y + angle).abs() < 0.17 * angle.powi(3));
        }
    }

    #[test]
    fn circumferential_speed_undoes_the_creepages() {
        let kinematics = Kinematics::from_wheel(30.0, 60.0, 0.46, 0.02);
        assert_relative_eq!(kinematics.circumferential_speed(), 60.0 * 0.46, max_relative = 1e-14);
    }

    /// A rigid body has one motion: its slip at a point is the same wherever the creepages are
    /// given.
    #[test]
    fn the_reference_point_does_not_change_the_motion() {
        let one = Kinematics { speed: 30.0, creepage_x: 0.002, creepage_y: -0.001, spin: 0.7 };
        let other = one.at([3e-3, -8e-3]);
        for [x, y] in [[0.0, 0.0], [5e-3, 2e-3], [-1e-3, 7e-3]] {
            let [here, there] = [one.rigid_slip(x, y), other.rigid_slip(x - 3e-3, y + 8e-3)];
            assert_relative_eq!(here[0], there[0], max_relative = 1e-14);
            assert_relative_eq!(here[1], there[1], max_relative = 1e-14);
        }
    }

    #[test]
    fn a_locked_wheel_is_no_rolling() {
        let locked = Kinematics { speed: 30.0, creepage_x: 1.0, creepage_y: 0.0, spin: 0.0 };
        assert!(locked.check().unwrap_err().to_string().contains("a locked wheel"));
        let reversed = Kinematics { creepage_x: 1.5, ..locked };
        assert!(reversed.check().unwrap_err().to_string().contains("a reversed wheel"));
    }

    #[test]
    fn driving_and_concave_signs_are_legal() {
        let driving = Kinematics { speed: 30.0, creepage_x: -0.3, creepage_y: 0.1, spin: -2.0 };
        assert_eq!(driving.check(), Ok(()));
    }
}
