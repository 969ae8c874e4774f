//! Formatting of numbers in text.

/// Four significant digits without trailing zeros, in powers of ten if the digits would not fit;
/// `n/a` for an unknown number.
pub fn significant(value: impl Into<Option<f64>>) -> String {
    let Some(value) = value.into().filter(|value| value.is_finite()) else {
        return "n/a".to_owned();
    };
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if rounded == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e6).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// The same number, with 0 for −0.
pub(crate) fn without_sign_of_zero(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn four_significant_digits() {
        let numbers = [0.0, -0.0, 80.0, -0.58493, 641.123, 1234.56, 3.2e-7, 1e7, f64::NAN];
        let texts = ["0", "0", "80", "-0.5849", "641.1", "1235", "3.2e-7", "1e7", "n/a"];
        assert_eq!(numbers.map(significant), texts);
        assert_eq!(significant(None), "n/a");
    }
}
