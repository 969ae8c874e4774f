//! Student's distribution.

use distrs::StudentsT;

/// Two-sided 95 % quantile of Student's t (dimensionless) with so many degrees of freedom, to a
/// relative accuracy of 10⁻⁶; that of the normal distribution if they are unlimited. NaN for zero
/// degrees of freedom.
pub fn students_t(degrees_of_freedom: Option<usize>) -> f64 {
    StudentsT::ppf(0.975, degrees_of_freedom.map_or(f64::INFINITY, |n| n as f64))
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
        assert!((students_t(Some(1000)) - students_t(Some(1001))).abs() < 3e-6);
    }
}
