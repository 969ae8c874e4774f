//! Fatigue of the surface.

use super::{RunPoint, State};

/// Surface-fatigue index of Ekberg, Kabo and Andersson (2002),
///
/// FI = T/N − k/p0,
///
/// the utilised friction minus that at which the surface just shakes down. For an ellipse of Hertz
/// the second term is 2π a b k/(3N), as they write it; for patches of other shapes or of several
/// parts it is that of the largest pressure. Where FI is positive, every passage deforms the
/// surface plastically.
///
/// Limits: full sliding is assumed in the shakedown limit; the index says that fatigue begins, not
/// how long it takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceFatigue {
    /// Yield stress in pure shear k of the cyclically hardened material, in Pa.
    pub shear_yield_stress: f64,
}

impl Default for SurfaceFatigue {
    /// 300 MPa, usual for wheel and rail steels (Ekberg, Kabo and Andersson 2002).
    fn default() -> Self {
        Self { shear_yield_stress: 300e6 }
    }
}

impl SurfaceFatigue {
    /// The index of a state, dimensionless.
    pub fn index(&self, state: &State) -> f64 {
        state.tangential_force / state.load - self.shear_yield_stress / state.peak_pressure
    }
}

/// The fatigue index over a run.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FatigueSummary {
    /// Largest index, dimensionless.
    pub max: f64,
    /// Mean index over the distance, dimensionless.
    pub mean: f64,
    /// Part of the distance over which the index is positive, dimensionless.
    pub share: f64,
    /// Mean over the distance of the index where it is positive and zero elsewhere, dimensionless.
    pub mean_excess: f64,
}

impl FatigueSummary {
    /// Over a distance, in m.
    pub(super) fn of(states: &[State], points: &[RunPoint], distance: f64) -> Self {
        let contacts: Vec<(&State, f64)> =
            states.iter().zip(points).map(|(state, point)| (state, point.fatigue_index)).collect();
        let largest = |contacts: &[(&State, f64)]| {
            contacts.iter().map(|(_, index)| *index).fold(f64::NEG_INFINITY, f64::max)
        };
        let mean = |value: fn(f64) -> f64| -> f64 {
            let wheels = contacts.chunk_by(|_, (next, _)| next.is_further_contact);
            let each = wheels.map(|wheel| value(largest(wheel)) * wheel[0].0.distance);
            each.sum::<f64>() / distance
        };
        Self {
            max: largest(&contacts),
            mean: mean(|index| index),
            share: mean(|index| f64::from(u8::from(index > 0.0))),
            mean_excess: mean(|index| index.max(0.0)),
        }
    }
}
