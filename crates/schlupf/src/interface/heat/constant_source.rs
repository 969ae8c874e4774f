//! The paper's heat model: each step is treated as if its source had always been constant; Eqs.
//! (21), (22).

use std::f64::consts::FRAC_2_SQRT_PI;

use super::{HeatModel, HeatStep};

/// T_j² = T_(j−1)² + ΔT², ΔT = (2/√π) √(κ/v0) (α q/λ) √Δx (Neuhaus and Sextro 2014, Eqs. 21, 22).
/// Exact for a constant source only. It cannot cool.
///
/// ```
/// use schlupf::interface::heat::{HeatModel, HeatStep, ConstantSource, Duhamel};
///
/// let record = [HeatStep { flux: 1e8, duration: 1e-4 }];
/// let rise = ConstantSource.rise_times_effusivity(&record);
/// assert!((rise / Duhamel.rise_times_effusivity(&record) - 1.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConstantSource;

impl HeatModel for ConstantSource {
    fn rise_times_effusivity(&self, record: &[HeatStep]) -> f64 {
        let squares: f64 = record.iter().map(|s| s.flux * s.flux * s.duration).sum();
        FRAC_2_SQRT_PI * squares.sqrt()
    }

    fn derivatives(&self, record: &[HeatStep], by_flux: &mut [f64]) {
        let rise = self.rise_times_effusivity(record);
        for (step, derivative) in record.iter().zip(by_flux) {
            // Without a source there is no rise, and the derivative has no direction.
            let over_rise = if rise > 0.0 { step.flux / rise } else { 0.0 };
            *derivative = FRAC_2_SQRT_PI.powi(2) * over_rise * step.duration;
        }
    }

    fn is_linear(&self) -> bool {
        false
    }
}
