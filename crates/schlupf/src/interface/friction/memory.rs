//! Friction memory.

use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// Parameters of friction memory.
///
/// Friction memory: the coefficient of a material point relaxes towards the value of the law over a
/// sliding distance d_c,
///
/// dμ/dt = (μ_law − μ) max(s, s_0)/d_c,
///
/// where s is its slip speed. It enters the contact with the coefficient of the law without slip.
/// (Rice and Ruina 1983, near the steady state of their law; likewise in Vollebregt, User guide for
/// CONTACT, "friction memory".) Without memory μ jumps at the onset of sliding, if the law falls
/// with the slip speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionMemory {
    distance: f64,
    least_speed: f64,
}

/// Decay of a difference over a time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Kept {
    /// exp(−max(s, s_0) t/d_c), dimensionless.
    pub part: f64,
    /// Its derivative with respect to the slip speed, in s/m.
    pub by_slip_speed: f64,
    /// Its derivative with respect to the logarithm of the time, dimensionless.
    pub by_duration: f64,
}

impl FrictionMemory {
    /// Relaxation over a sliding distance d_c (in m), at slip speeds below s_0 (in m/s) as fast as
    /// at s_0; with s_0 = 0 the memory does not fade while the surfaces stick.
    ///
    /// ```
    /// use schlupf::Problem;
    /// use schlupf::interface::friction::FrictionMemory;
    ///
    /// let mut problem = Problem::builder().build()?;
    /// problem.interface.friction.memory = Some(FrictionMemory::new(0.02e-3, 0.01)?);
    /// // Nothing of a difference is left after a long way.
    /// assert!(FrictionMemory::new(0.02e-3, 0.01)?.kept(1.0, 1.0).part < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(distance: f64, least_speed: f64) -> Result<Self, Error> {
        require_positive(Quantity::MemoryDistance, distance)?;
        require(Quantity::MemorySpeed, Requirement::NotNegative, least_speed)?;
        Ok(Self { distance, least_speed })
    }

    /// The same in another unit of length (dimensionless) and of time, speeds being the same.
    pub(crate) fn in_unit(self, length: f64) -> Self {
        Self { distance: self.distance / length, ..self }
    }

    /// Decay of a difference over a time (in s) at a slip speed (in m/s).
    pub fn kept(&self, slip_speed: f64, duration: f64) -> Kept {
        let relaxed = slip_speed.max(self.least_speed) * duration / self.distance;
        let part = (-relaxed).exp();
        let by_speed = if slip_speed > self.least_speed { duration / self.distance } else { 0.0 };
        Kept { part, by_slip_speed: -part * by_speed, by_duration: -part * relaxed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_fades_over_the_distance() {
        let memory = FrictionMemory::new(2e-5, 1e-3).unwrap();
        let kept = memory.kept(0.5, 4e-5);
        assert!((kept.part - (-1.0_f64).exp()).abs() < 1e-15);
        let cut = memory.kept(0.5, 1e-5).part * memory.kept(0.5, 3e-5).part;
        assert!((kept.part - cut).abs() < 1e-15);
        let step = 1e-6;
        let slope = (memory.kept(0.5 + step, 4e-5).part - memory.kept(0.5 - step, 4e-5).part)
            / (2.0 * step);
        assert!((kept.by_slip_speed - slope).abs() < 1e-9, "{slope}");
        assert_eq!(memory.kept(0.0, 4e-5), memory.kept(1e-4, 4e-5));
    }

    #[test]
    fn bad_memories_are_refused() {
        assert!(FrictionMemory::new(0.0, 0.0).is_err());
        assert!(FrictionMemory::new(1e-5, -1.0).is_err());
        assert!(FrictionMemory::new(1e-5, f64::NAN).is_err());
    }
}
