//! Temperature of a half-space under a heat flux that changes with time, by Duhamel's theorem
//! (Carslaw and Jaeger 1959, §2.9).

use std::f64::consts::FRAC_2_SQRT_PI;

use super::{HeatModel, HeatStep};

/// T β = (1/√π) ∫ q(t') dt'/√(t − t'), with q constant within each step and the kernel integrated
/// exactly: a step from s₁ to s₂ before now has the weight (2/√π)(√s₂ − √s₁).
///
/// ```
/// use schlupf::interface::heat::{HeatModel, HeatStep, Duhamel};
///
/// let rise = |duration| Duhamel.rise_times_effusivity(&[HeatStep { flux: 1e8, duration }]);
/// // Under a constant flux the rise goes with the root of the time (Carslaw and Jaeger 1959).
/// assert!((rise(4e-4) / rise(1e-4) - 2.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Duhamel;

impl HeatModel for Duhamel {
    fn rise_times_effusivity(&self, record: &[HeatStep]) -> f64 {
        let mut elapsed = 0.0;
        let mut root = 0.0;
        let mut sum = 0.0;
        for step in record {
            elapsed += step.duration;
            let next_root = f64::sqrt(elapsed);
            sum += step.flux * (next_root - root);
            root = next_root;
        }
        FRAC_2_SQRT_PI * sum
    }

    fn derivatives(&self, record: &[HeatStep], by_flux: &mut [f64]) {
        let mut elapsed = 0.0;
        let mut root = 0.0;
        for (step, derivative) in record.iter().zip(by_flux) {
            elapsed += step.duration;
            let next_root = f64::sqrt(elapsed);
            *derivative = FRAC_2_SQRT_PI * (next_root - root);
            root = next_root;
        }
    }

    fn is_linear(&self) -> bool {
        true
    }

    fn is_conduction(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::interface::heat::ConstantSource;

    /// Carslaw and Jaeger 1959, §2.9 (7): constant flux, T = (2/√π) q √t/β; exact for both models.
    #[test]
    fn carslaw_jaeger_1959_constant_flux() {
        let record = vec![HeatStep { flux: 3e8, duration: 1e-5 }; 40];
        let exact = FRAC_2_SQRT_PI * 3e8 * 4e-4_f64.sqrt();
        assert_relative_eq!(Duhamel.rise_times_effusivity(&record), exact, max_relative = 1e-13);
        let squares = ConstantSource.rise_times_effusivity(&record);
        assert_relative_eq!(squares, exact, max_relative = 1e-13);
    }

    /// After the source stops a body cools; the paper's model does not.
    #[test]
    fn only_duhamel_cools() {
        let hot = vec![HeatStep { flux: 3e8, duration: 1e-4 }];
        let mut later = vec![HeatStep { flux: 0.0, duration: 3e-4 }];
        later.extend(&hot);
        let fall = Duhamel.rise_times_effusivity(&later) / Duhamel.rise_times_effusivity(&hot);
        assert_relative_eq!(fall, 2.0 - 3.0_f64.sqrt(), max_relative = 1e-13);
        let kept = ConstantSource.rise_times_effusivity(&later);
        assert_eq!(kept, ConstantSource.rise_times_effusivity(&hot));
    }
}
