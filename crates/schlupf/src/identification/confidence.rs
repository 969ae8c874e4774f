//! Student's distribution.

use std::f64::consts::FRAC_2_PI;

/// Two-sided 95 % quantile of the normal distribution, dimensionless.
const NORMAL: f64 = 1.959_963_984_540_054;

/// From so many degrees of freedom on, the quantile is taken to be NORMAL (1 + 1/4ν + …), which is then
/// exact to 10⁻⁷.
const MANY: usize = 1000;

/// Two-sided 95 % quantile of Student's t (dimensionless) with so many degrees of freedom; of the normal
/// distribution where they are unlimited. NaN without any.
pub fn students_t(degrees_of_freedom: Option<usize>) -> f64 {
    let Some(n) = degrees_of_freedom else { return NORMAL };
    if n == 0 {
        return f64::NAN;
    }
    if n > MANY {
        // Fisher and Cornish 1960.
        let (z, n) = (NORMAL, n as f64);
        let second = z * (5.0 * z.powi(4) + 16.0 * z * z + 3.0) / 96.0;
        return z + z * (z * z + 1.0) / (4.0 * n) + second / (n * n);
    }
    // The probability grows with the angle arctan(t/√n).
    let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if probability(middle, n) < 0.95 { low = middle } else { high = middle }
    }
    (0.5 * (low + high)).tan() * (n as f64).sqrt()
}

/// Probability of |t| ≤ √n tan θ; Abramowitz and Stegun 1964, 26.7.3 and 26.7.4.
fn probability(angle: f64, n: usize) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let is_odd = n % 2 == 1;
    let mut term = if is_odd { cos } else { 1.0 };
    let mut sum = if n == 1 { 0.0 } else { term };
    let mut k = if is_odd { 3 } else { 2 };
    while k < n {
        term *= cos * cos * (k as f64 - 1.0) / k as f64;
        sum += term;
        k += 2;
    }
    if is_odd { FRAC_2_PI * (angle + sin * sum) } else { sin * sum }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table of Abramowitz and Stegun 1964, 26.10.
    #[test]
    fn abramowitz_stegun_1964_table() {
        let table = [
            (1, 12.706),
            (2, 4.303),
            (3, 3.182),
            (4, 2.776),
            (9, 2.262),
            (10, 2.228),
            (30, 2.042),
            (120, 1.980),
        ];
        for (n, expected) in table {
            assert!(
                (students_t(Some(n)) - expected).abs() < 5.1e-4,
                "{n}: {}",
                students_t(Some(n))
            );
        }
        assert!((students_t(None) - 1.960).abs() < 5e-4);
        assert!(students_t(Some(0)).is_nan());
        assert!((students_t(Some(MANY)) - students_t(Some(MANY + 1))).abs() < 3e-6);
    }
}
