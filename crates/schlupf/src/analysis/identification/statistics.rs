//! Statistics of the residuals of a fit.

use crate::numerics::vector::dot;

/// One minus the ratio of the sum of the squared residuals to that of the data about their mean;
/// dimensionless. `None` if all data are equal.
pub(super) fn r_squared(data: &[f64], residuals: &[f64]) -> Option<f64> {
    let mean = data.iter().sum::<f64>() / data.len() as f64;
    let total: f64 = data.iter().map(|value| (value - mean).powi(2)).sum();
    let rounding = f64::EPSILON * dot(data, data);
    (total > rounding).then(|| 1.0 - dot(residuals, residuals) / total)
}

/// Correlation of each residual with the next one in its series, dimensionless: near zero if they
/// are random.
pub(super) fn autocorrelation<'a>(series: impl Iterator<Item = &'a [f64]>) -> f64 {
    let (mut products, mut squares) = (0.0, 0.0);
    for residuals in series {
        products += residuals.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>();
        squares += dot(residuals, residuals);
    }
    products / squares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residuals_of_one_sign_hang_together_and_alternating_ones_do_not() {
        let of = |series: &[&[f64]]| autocorrelation(series.iter().copied());
        assert!(of(&[&[1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0]]) > 0.5);
        assert!(of(&[&[1.0, -1.0, 1.0, -1.0]]) < -0.5);
        // Two series, each on its own.
        assert!(of(&[&[1.0, 1.0, 1.0, 1.0], &[-1.0, -1.0, -1.0, -1.0]]) > 0.7);
    }

    #[test]
    fn r_squared_is_one_for_a_perfect_fit_and_zero_for_the_mean() {
        let data = [1.0, 2.0, 3.0];
        assert_eq!(r_squared(&data, &[0.0; 3]), Some(1.0));
        assert_eq!(r_squared(&data, &[-1.0, 0.0, 1.0]), Some(0.0));
        assert_eq!(r_squared(&[0.2; 6], &[0.01; 6]), None);
        assert_eq!(r_squared(&[0.0; 3], &[0.1; 3]), None);
    }
}
