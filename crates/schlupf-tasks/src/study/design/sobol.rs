//! The sequence of Sobol' (1967), with the direction numbers of Joe and Kuo (2008) and a digital
//! shift by a seed (Cranley and Patterson 1976 in base two): points that fill the unit cube evenly.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Largest number of dimensions.
pub const MOST: usize = 21;

/// Bits of a coordinate.
const BITS: usize = 52;

/// For the second dimension and those after it: degree of the primitive polynomial, its
/// coefficients, and the first direction numbers (Joe and Kuo 2008, new-joe-kuo-6.21201).
const DIRECTIONS: [(u32, u32, &[u64]); MOST - 1] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
];

/// The first points of a dimension, in [0, 1).
pub fn points(dimension: usize, count: usize, seed: u64) -> Vec<f64> {
    let directions = directions(dimension);
    let mut random = Pcg64Mcg::seed_from_u64(seed ^ ((dimension as u64) << 32));
    let shift = random.next_u64() >> (64 - BITS);
    let mut point = 0_u64;
    let scale = (1_u64 << BITS) as f64;
    (0..count)
        .map(|k| {
            if k > 0 {
                // Gray code: each point differs from the one before in one direction.
                point ^= directions[k.trailing_zeros() as usize];
            }
            (point ^ shift) as f64 / scale
        })
        .collect()
}

/// Directions as binary fractions.
fn directions(dimension: usize) -> [u64; BITS] {
    let mut directions = [0; BITS];
    if dimension == 0 {
        for (k, direction) in directions.iter_mut().enumerate() {
            *direction = 1 << (BITS - 1 - k);
        }
        return directions;
    }
    let (degree, coefficients, first) = DIRECTIONS[dimension - 1];
    let degree = degree as usize;
    for k in 0..BITS {
        directions[k] = if k < degree {
            first[k] << (BITS - 1 - k)
        } else {
            let mut direction = directions[k - degree] ^ (directions[k - degree] >> degree);
            for i in 1..degree {
                let bit = (coefficients >> (degree - 1 - i)) & 1;
                direction ^= u64::from(bit) * directions[k - i];
            }
            direction
        };
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without the shift the points are those of SciPy 1.17 (`scipy.stats.qmc.Sobol`,
    /// `scramble=False`).
    #[test]
    fn points_are_those_of_joe_and_kuo() {
        let unshifted = |dimension: usize, count: usize| -> Vec<f64> {
            let shifted = points(dimension, count, 0);
            let bits = |value: f64| (value * (1_u64 << BITS) as f64) as u64;
            let shift = bits(shifted[0]);
            let plain = |value: &f64| (bits(*value) ^ shift) as f64 / (1_u64 << BITS) as f64;
            shifted.iter().map(plain).collect()
        };
        for (dimension, row) in EXPECTED {
            assert_eq!(unshifted(dimension, 33)[17..25], row, "dimension {dimension}");
        }
    }

    const EXPECTED: [(usize, [f64; 8]); 6] = [
        (1, [0.96875, 0.21875, 0.71875, 0.09375, 0.59375, 0.34375, 0.84375, 0.15625]),
        (2, [0.96875, 0.21875, 0.71875, 0.84375, 0.34375, 0.59375, 0.09375, 0.53125]),
        (6, [0.03125, 0.78125, 0.28125, 0.90625, 0.40625, 0.65625, 0.15625, 0.96875]),
        (12, [0.15625, 0.90625, 0.40625, 0.78125, 0.28125, 0.53125, 0.03125, 0.34375]),
        (17, [0.09375, 0.84375, 0.34375, 0.46875, 0.96875, 0.21875, 0.71875, 0.28125]),
        (20, [0.21875, 0.96875, 0.46875, 0.59375, 0.09375, 0.84375, 0.34375, 0.53125]),
    ];

    /// Each of the 2^k intervals has one of 2^k points, in every dimension.
    #[test]
    fn points_are_even_in_every_dimension() {
        for dimension in 0..MOST {
            let mut taken = [false; 64];
            for point in points(dimension, 64, 7) {
                let interval = (point * 64.0) as usize;
                assert!(!taken[interval], "dimension {dimension}");
                taken[interval] = true;
            }
        }
    }
}
