//! Distribution of a quantity over the distance.

use crate::reporting::Quantity;

/// Parts of the distance by the value of a quantity, in classes of equal width.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Histogram {
    /// The quantity.
    pub quantity: Quantity,
    /// Limits of the classes, increasing, in the unit of the quantity: one more than classes.
    pub edges: Vec<f64>,
    /// Part of the distance in each class, dimensionless; they add up to one.
    pub shares: Vec<f64>,
}

/// Most classes.
const MOST: f64 = 25.0;

impl Histogram {
    /// That of values (in the unit of the quantity) with their weights (in any unit): classes have
    /// round limits, and a value on a limit belongs to the class above.
    pub fn of(quantity: Quantity, values: &[f64], weights: &[f64]) -> Self {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let step = step(low, high);
        let first = (low / step).floor();
        let count = ((high / step).floor() - first) as usize + 1;
        let mut sums = vec![0.0; count];
        for (value, weight) in values.iter().zip(weights) {
            let class = ((value / step).floor() - first) as usize;
            sums[class.min(count - 1)] += weight;
        }
        let total: f64 = weights.iter().sum();
        Self {
            quantity,
            edges: (0..=count).map(|k| (first + k as f64) * step).collect(),
            shares: sums.into_iter().map(|sum| sum / total).collect(),
        }
    }
}

/// 1, 2 or 5 times a power of ten that divides a range into at most so many classes.
fn step(low: f64, high: f64) -> f64 {
    let magnitude = low.abs().max(high.abs());
    // A value alone, up to rounding, has a class of its own.
    let range = (high - low).max(1e-9 * magnitude);
    if !(range > 0.0 && range.is_finite()) {
        return 1.0;
    }
    let least = range / (MOST - 1.0);
    let power = 10_f64.powf(least.log10().floor());
    let round = [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power);
    round.into_iter().find(|step| *step >= least).unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_are_round_and_hold_everything() {
        let values = [0.0, 0.9, 1.0, 7.3, 20.0, 19.99];
        let histogram =
            Histogram::of(Quantity::WearNumber, &values, &[1.0, 1.0, 2.0, 4.0, 1.0, 1.0]);
        assert_eq!(histogram.edges.len(), histogram.shares.len() + 1);
        assert_eq!((histogram.edges[0], histogram.edges[1]), (0.0, 1.0));
        assert_eq!(histogram.shares[..2], [0.2, 0.2]);
        assert_eq!((histogram.shares[7], histogram.shares[20]), (0.4, 0.1));
        assert!((histogram.shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn values_alone_and_below_zero_have_a_class() {
        for value in [0.0, -0.3, 5.0, 1e-12, -1e9] {
            let histogram = Histogram::of(Quantity::FatigueIndex, &[value, value], &[1.0, 3.0]);
            let [low, .., high] = histogram.edges[..] else { panic!("{value}") };
            assert!(low <= value && value <= high && histogram.shares.contains(&1.0), "{value}");
        }
        let wide = Histogram::of(Quantity::FatigueIndex, &[-1.0, 1.0], &[1.0, 1.0]);
        assert!(wide.shares.len() <= 26 && wide.edges[0] <= -1.0);
    }
}
