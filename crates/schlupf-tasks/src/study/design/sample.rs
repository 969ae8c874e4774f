//! Points within the ranges of several fields.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use super::sobol;

/// How points are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The sequence of Sobol'.
    Sobol,
    /// One point in each of as many equal intervals of every field, at random in them (McKay,
    /// Beckman and Conover 1979).
    LatinHypercube,
}

impl Method {
    /// All methods.
    pub const ALL: [Self; 2] = [Self::Sobol, Self::LatinHypercube];

    /// Name in a study.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sobol => "sobol",
            Self::LatinHypercube => "latin-hypercube",
        }
    }

    /// The largest number of fields that it can vary.
    pub fn most_fields(self) -> usize {
        match self {
            Self::Sobol => sobol::MOST,
            Self::LatinHypercube => usize::MAX,
        }
    }
}

/// Which points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sample {
    /// How they are chosen.
    pub method: Method,
    /// How many.
    pub count: usize,
    /// Another one gives other points.
    pub seed: u64,
}

impl Sample {
    /// Values of one field within its range; `dimension` counts the fields from 0.
    pub fn values(&self, dimension: usize, [low, high]: [f64; 2]) -> Vec<f64> {
        let points = match self.method {
            Method::Sobol => sobol::points(dimension, self.count, self.seed),
            Method::LatinHypercube => self.strata(dimension),
        };
        points.into_iter().map(|point| low + point * (high - low)).collect()
    }

    fn strata(&self, dimension: usize) -> Vec<f64> {
        let seed = self.seed ^ ((dimension as u64 + 1) << 40);
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut order: Vec<usize> = (0..self.count).collect();
        // Fisher and Yates.
        for k in (1..self.count).rev() {
            order.swap(k, (random.next_u64() % (k as u64 + 1)) as usize);
        }
        let mut within = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
        order.into_iter().map(|k| (k as f64 + within()) / self.count as f64).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_latin_hypercube_has_a_point_in_every_interval() {
        let sample = Sample { method: Method::LatinHypercube, count: 50, seed: 3 };
        let values = sample.values(1, [10.0, 60.0]);
        let mut intervals: Vec<usize> = values.iter().map(|v| (v - 10.0) as usize).collect();
        assert_ne!(intervals, (0..50).collect::<Vec<_>>());
        intervals.sort_unstable();
        assert_eq!(intervals, (0..50).collect::<Vec<_>>());
        assert_eq!(values, sample.values(1, [10.0, 60.0]));
        assert_ne!(values, sample.values(2, [10.0, 60.0]));
        assert_ne!(values, Sample { seed: 4, ..sample }.values(1, [10.0, 60.0]));
    }
}
