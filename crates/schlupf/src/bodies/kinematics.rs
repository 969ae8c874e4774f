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

/// The speed to which creepages refer, and at which the contact frame moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum ReferenceSpeed {
    /// That of the vehicle, v0: the surface of the rail passes at it.
    #[default]
    Vehicle,
    /// The mean (v0 + ωR)/2 of those at which both surfaces pass (Kalker 1990). Creepages that
    /// spin adds away from the reference point count half for either surface.
    Mean,
}

#[cfg(feature = "serde")]
fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// How the wheel moves over the rail.
///
/// The rigid slip of the wheel over the rail, divided by the speed, is (ξ − φ y, η + φ x), with x
/// and y measured from the reference point of the creepages ([`ReferencePoint`]). Braking has
/// ξ > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Kinematics {
    /// Speed V of the contact frame, in m/s: usually that of the vehicle, v0.
    pub speed: f64,
    /// Longitudinal creepage ξ, dimensionless; positive when braking.
    pub creepage_x: f64,
    /// Lateral creepage η, dimensionless.
    pub creepage_y: f64,
    /// Spin creepage φ, in 1/m.
    pub spin: f64,
    /// Which speed that is.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "is_default"))]
    pub reference_speed: ReferenceSpeed,
}

impl Kinematics {
    /// Rolling at a speed (in m/s) without creepage and spin.
    pub const fn free_rolling(speed: f64) -> Self {
        let reference_speed = ReferenceSpeed::Vehicle;
        Self { speed, creepage_x: 0.0, creepage_y: 0.0, spin: 0.0, reference_speed }
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
            ..Self::free_rolling(speed)
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

    /// Circumferential speed of the wheel, in m/s: ωR = (cos α − ξ) v0 or (1 − ξ/2) V.
    pub fn circumferential_speed(&self) -> f64 {
        let part = match self.reference_speed {
            ReferenceSpeed::Vehicle => self.locking_creepage() - self.creepage_x,
            ReferenceSpeed::Mean => 1.0 - 0.5 * self.creepage_x,
        };
        part * self.speed
    }

    /// Speeds at which the surfaces of wheel and rail pass through the contact, in m/s; forwards or
    /// backwards, as heat has no direction.
    pub fn surface_speeds(&self) -> [f64; 2] {
        let rail = match self.reference_speed {
            ReferenceSpeed::Vehicle => self.speed,
            ReferenceSpeed::Mean => (1.0 + 0.5 * self.creepage_x) * self.speed,
        };
        [self.circumferential_speed(), rail].map(f64::abs)
    }

    /// Longitudinal creepage at which the wheel locks: √(1 − η²) or 2, dimensionless.
    fn locking_creepage(&self) -> f64 {
        match self.reference_speed {
            ReferenceSpeed::Vehicle => (1.0 - self.creepage_y.powi(2)).sqrt(),
            ReferenceSpeed::Mean => 2.0,
        }
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
    pub(crate) fn contact_time_ratio_by_creepage(&self) -> [f64; 2] {
        match self.reference_speed {
            ReferenceSpeed::Vehicle => {
                let along = self.locking_creepage();
                let contact_time_ratio = (along - self.creepage_x).recip();
                [contact_time_ratio, contact_time_ratio * self.creepage_y / along]
            }
            ReferenceSpeed::Mean => [(1.0 - 0.25 * self.creepage_x.powi(2)).recip(), 0.0],
        }
    }

    /// The same motion at another longitudinal creepage, at which ln(v0/(ωR)) differs by `change`.
    pub(crate) fn with_contact_time_ratio(&self, change: f64) -> Self {
        let creepage_x = match self.reference_speed {
            ReferenceSpeed::Vehicle => {
                let rolling = self.locking_creepage() - self.creepage_x;
                self.creepage_x + rolling * (1.0 - (-change).exp())
            }
            ReferenceSpeed::Mean => {
                let (wheel, rail) = (2.0 - self.creepage_x, 2.0 + self.creepage_x);
                let rail = rail * change.exp();
                2.0 * (rail - wheel) / (rail + wheel)
            }
        };
        Self { creepage_x, ..*self }
    }

    /// Derivatives of the logarithms of the times in which both surfaces pass with respect to
    /// ln(v0/(ωR)), dimensionless.
    pub(crate) fn contact_times_by_ratio(&self) -> [f64; 2] {
        match self.reference_speed {
            ReferenceSpeed::Vehicle => [1.0, 0.0],
            ReferenceSpeed::Mean => [0.5 + 0.25 * self.creepage_x, -0.5 + 0.25 * self.creepage_x],
        }
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

    /// v0 = 30 m/s, ωR = 27 m/s.
    #[test]
    fn the_mean_speed_lies_between_those_of_the_surfaces() {
        let mean = Kinematics {
            creepage_x: 3.0 / 28.5,
            reference_speed: ReferenceSpeed::Mean,
            ..Kinematics::free_rolling(28.5)
        };
        let [wheel, rail] = mean.surface_speeds();
        assert_relative_eq!(wheel, 27.0, max_relative = 1e-14);
        assert_relative_eq!(rail, 30.0, max_relative = 1e-14);
        assert!(Kinematics { creepage_x: 1.9, ..mean }.check().is_ok());
        assert!(Kinematics { creepage_x: 2.0, ..mean }.check().is_err());
        for motion in [mean, Kinematics::from_wheel(30.0, 58.0, 0.46, 0.02)] {
            let ratio = |motion: &Kinematics| {
                let [wheel, rail] = motion.surface_speeds();
                (rail / wheel).ln()
            };
            let changed = motion.with_contact_time_ratio(1e-6);
            assert_relative_eq!(ratio(&changed) - ratio(&motion), 1e-6, max_relative = 1e-6);
            let [by_x, _] = motion.contact_time_ratio_by_creepage();
            let step = changed.creepage_x - motion.creepage_x;
            assert_relative_eq!(by_x * step, 1e-6, max_relative = 1e-5);
            let times = |motion: &Kinematics| {
                motion.surface_speeds().map(|speed| (motion.speed / speed).ln())
            };
            for body in [0, 1] {
                let change = times(&changed)[body] - times(&motion)[body];
                let expected = 1e-6 * motion.contact_times_by_ratio()[body];
                assert_relative_eq!(change, expected, epsilon = 1e-11);
            }
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
        let one = Kinematics {
            creepage_x: 0.002,
            creepage_y: -0.001,
            spin: 0.7,
            ..Kinematics::free_rolling(30.0)
        };
        let other = one.at([3e-3, -8e-3]);
        for [x, y] in [[0.0, 0.0], [5e-3, 2e-3], [-1e-3, 7e-3]] {
            let [here, there] = [one.rigid_slip(x, y), other.rigid_slip(x - 3e-3, y + 8e-3)];
            assert_relative_eq!(here[0], there[0], max_relative = 1e-14);
            assert_relative_eq!(here[1], there[1], max_relative = 1e-14);
        }
    }

    #[test]
    fn a_locked_wheel_is_no_rolling() {
        let locked = Kinematics { creepage_x: 1.0, ..Kinematics::free_rolling(30.0) };
        assert!(locked.check().unwrap_err().to_string().contains("a locked wheel"));
        let reversed = Kinematics { creepage_x: 1.5, ..locked };
        assert!(reversed.check().unwrap_err().to_string().contains("a reversed wheel"));
    }

    #[test]
    fn driving_and_concave_signs_are_legal() {
        let driving = Kinematics {
            creepage_x: -0.3,
            creepage_y: 0.1,
            spin: -2.0,
            ..Kinematics::free_rolling(30.0)
        };
        assert_eq!(driving.check(), Ok(()));
    }
}
