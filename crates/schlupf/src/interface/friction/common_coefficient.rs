//! The coefficient of friction that agrees with the heat and the slip it makes.

/// Most evaluations; a root to rounding takes some five.
const EVALUATIONS: usize = 60;

/// Relative accuracy of the coefficient.
const ACCURACY: f64 = 1e-12;

/// The coefficient μ ≥ 0 (dimensionless) with answer(μ) = μ: by the secant through the last two, and by
/// bisection where that leaves what is known to hold the root. `answer` is never negative. Where
/// there are several roots, one of them.
pub(crate) fn common_coefficient(start: f64, mut answer: impl FnMut(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut tried = start;
    let mut last: Option<[f64; 2]> = None;
    for evaluation in 0..EVALUATIONS {
        let asked = answer(tried);
        let excess = asked - tried;
        if excess.abs() <= ACCURACY * tried.max(asked) {
            return asked;
        }
        if excess > 0.0 {
            low = tried;
        } else {
            high = tried;
        }
        let next = match last {
            // Every eighth step halves, lest one end of the interval stand still.
            Some([before, excess_before]) if excess != excess_before && evaluation % 8 != 7 => {
                tried - excess * (tried - before) / (excess - excess_before)
            }
            None => asked,
            _ => f64::NAN,
        };
        last = Some([tried, excess]);
        tried = if next > low && next < high {
            next
        } else if high.is_finite() {
            0.5 * (low + high)
        } else {
            tried + 2.0 * excess
        };
    }
    tried
}

#[cfg(test)]
mod tests {
    use super::common_coefficient;
    use approx::assert_relative_eq;

    /// Mild and steep falls, a rise, a jump, and a root near zero; in few evaluations where it is smooth.
    #[test]
    fn roots_are_found() {
        let count = |answer: &dyn Fn(f64) -> f64, root: f64| {
            let mut evaluations = 0;
            let found = common_coefficient(0.4, |mu| {
                evaluations += 1;
                answer(mu)
            });
            assert_relative_eq!(found, root, epsilon = 1e-11);
            evaluations
        };
        assert_eq!(count(&|_| 0.3, 0.3), 2);
        assert!(count(&|mu| 0.4 - 0.2 * mu, 1.0 / 3.0) <= 4);
        assert!(count(&|mu| 0.4 / (1.0 + 9.0 * mu), (15.4_f64.sqrt() - 1.0) / 18.0) <= 9);
        assert!(count(&|mu| 0.1 + 0.5 * mu, 0.2) <= 5);
        count(&|mu| if mu > 0.25 { 0.1 } else { 0.4 }, 0.25);
        count(&|mu| (0.4 - 50.0 * mu).max(0.0), 0.4 / 51.0);
    }
}
