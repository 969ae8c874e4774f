//! Changes from step to step.

use crate::numerics::vector::norm;

/// Largest change over the largest new value.
pub(super) fn largest_change(old: &[f64], new: &[f64]) -> f64 {
    let largest = new.iter().copied().fold(0.0, f64::max);
    let difference = |(new, old): (&f64, &f64)| (new - old).abs();
    let changed = new.iter().zip(old).map(difference).fold(0.0, f64::max);
    if largest > 0.0 { changed / largest } else { 0.0 }
}

/// Length of the change of a vector over a scale.
pub(super) fn relative_change(old: &[f64], new: &[f64], scale: f64) -> f64 {
    let moved: Vec<f64> = new.iter().zip(old).map(|(new, old)| new - old).collect();
    if scale > 0.0 { norm(&moved) / scale } else { 0.0 }
}
