//! From the motion of the wheel to the rigid slip in the contact; Eqs. (1)–(3), (9)–(12).

use crate::error::{Error, require, require_finite, require_positive};

/// How the wheel moves over the rail.
///
/// The rigid slip of the wheel over the rail, over the speed, is (ξ − φ y, η + φ x). Braking has
/// ξ > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Kinematics of a wheel of rolling radius R (in m) that turns with ω (in rad/s) under the yaw
    /// angle α (in rad), exactly: ξ = (v0 cos α − ω R)/v0, η = −sin α. For small α these are
    /// Eq. (3) and (12) of Neuhaus and Sextro (2014).
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

    /// Whether there is neither creepage nor spin.
    pub fn is_pure_rolling(&self) -> bool {
        [self.creepage_x, self.creepage_y, self.spin] == [0.0; 3]
    }

    /// Circumferential speed of the wheel ω R = (cos α − ξ) v0, in m/s.
    pub fn circumferential_speed(&self) -> f64 {
        ((1.0 - self.creepage_y.powi(2)).sqrt() - self.creepage_x) * self.speed
    }

    /// Rigid slip of the wheel over the rail at a point (in m), over the speed; dimensionless.
    pub fn rigid_slip(&self, x: f64, y: f64) -> [f64; 2] {
        [self.creepage_x - self.spin * y, self.creepage_y + self.spin * x]
    }

    /// By how much the rigid slip over a distance (in m) differs between the end of the distance,
    /// downstream, and its middle; in m.
    pub fn half_turn(&self, distance: f64) -> [f64; 2] {
        [0.0, -0.5 * self.spin * distance * distance]
    }

    /// Derivatives of ln(v0/(ωR)) with respect to ξ and η, dimensionless.
    pub fn slowness_by_creepage(&self) -> [f64; 2] {
        let along = (1.0 - self.creepage_y.powi(2)).sqrt();
        let slowness = (along - self.creepage_x).recip();
        [slowness, slowness * self.creepage_y / along]
    }

    /// Checks that the wheel rolls: a speed, finite creepages, ω R > 0.
    pub fn check(&self) -> Result<(), Error> {
        require_positive("kinematics.speed", self.speed, "m/s")?;
        require_finite("kinematics.creepage_x", self.creepage_x, "")?;
        let lateral = self.creepage_y;
        require(lateral.abs() < 1.0, "kinematics.creepage_y", "between -1 and 1", lateral, "")?;
        require_finite("kinematics.spin", self.spin, "1/m")?;
        let rolling = self.circumferential_speed();
        if rolling > 0.0 {
            return Ok(());
        }
        Err(Error::Invalid {
            quantity: "kinematics.creepage_x",
            requirement: "less than cos(yaw_angle): the wheel must roll, angular_velocity · \
                          wheel_radius > 0"
                .to_owned(),
            value: format!(
                "{}, a {} wheel with a circumferential speed of {rolling} m/s",
                self.creepage_x,
                if rolling == 0.0 { "locked" } else { "reversed" }
            ),
        })
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
