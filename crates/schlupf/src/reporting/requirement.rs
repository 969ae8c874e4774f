//! Requirements on numbers.

use crate::reporting::{Quantity, Words};

/// A condition on a number in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Requirement {
    /// Any finite number.
    Finite,
    /// Above zero and finite.
    Positive,
    /// Zero or above, and finite.
    NotNegative,
    /// Finite and at most this magnitude, in the unit of the quantity.
    Magnitude(f64),
    /// Within bounds, which are included, in the unit of the quantity.
    Between(f64, f64),
    /// Within bounds, which are excluded, in the unit of the quantity.
    Inside(f64, f64),
    /// Above the first bound and at most the second, in the unit of the quantity.
    AboveUpTo(f64, f64),
    /// At least this, in the unit of the quantity.
    AtLeast(f64),
    /// A radius of curvature with magnitude between these, in m: positive if convex, negative if
    /// concave, infinite if straight.
    Radius(f64, f64),
    /// Not zero; infinite if flat.
    NotZero,
    /// Not negative, and at most the value of another quantity,
    /// in the unit of the quantity.
    UpTo(Quantity, f64),
}

impl Requirement {
    /// Whether a value (in the unit of the quantity) satisfies the requirement.
    #[inline]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Radius(low, high) => {
                value == f64::INFINITY || (low..=high).contains(&value.abs())
            }
            Self::NotZero => !value.is_nan() && value != 0.0,
            _ if !value.is_finite() => false,
            Self::Finite => true,
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Magnitude(high) => value.abs() <= high,
            Self::Between(low, high) => (low..=high).contains(&value),
            Self::Inside(low, high) => low < value && value < high,
            Self::AboveUpTo(low, high) => low < value && value <= high,
            Self::AtLeast(low) => value >= low,
            Self::UpTo(_, high) => (0.0..=high).contains(&value),
        }
    }

    /// The requirement in words, to follow "must be"; `unit` is the unit of the bounds.
    pub fn text(self, unit: &str, words: &dyn Words) -> String {
        let bounds = match self {
            Self::Finite => return "finite".to_owned(),
            Self::Positive => return "positive and finite".to_owned(),
            Self::NotNegative => return "finite and not negative".to_owned(),
            Self::NotZero => return "other than 0 (inf where flat)".to_owned(),
            Self::UpTo(other, high) => {
                return format!("between 0 and {} = {high}", words.word(other));
            }
            Self::Radius(low, high) => {
                let (low, high) = (readable(low), readable(high));
                return format!(
                    "between {low} and {high} {unit} in magnitude, or \"inf\" where straight"
                );
            }
            Self::Magnitude(high) => format!("finite and at most ±{}", readable(high)),
            Self::Between(low, high) => {
                format!("between {} and {}", readable(low), readable(high))
            }
            Self::Inside(low, high) => {
                format!("above {} and below {}", readable(low), readable(high))
            }
            Self::AboveUpTo(low, high) => {
                format!("above {} and at most {}", readable(low), readable(high))
            }
            Self::AtLeast(low) => format!("at least {}", readable(low)),
        };
        format!("{bounds} {unit}").trim_end().to_owned()
    }

    /// How far a value is from the nearest bound, as the logarithm of their ratio, dimensionless.
    pub fn remoteness(self, value: f64) -> f64 {
        let bounds = match self {
            Self::Radius(low, high) => [Some(low), Some(high)],
            _ => self.bounds().map(|bound| bound.map(|(bound, _)| bound)),
        };
        let remoteness = bounds.into_iter().flatten().map(|bound| (value / bound).abs().ln().abs());
        remoteness.fold(f64::INFINITY, f64::min)
    }

    /// The bounds that do not depend on other quantities, lower and upper (in the unit of the
    /// quantity); `true` marks a bound that is included.
    pub fn bounds(self) -> [Option<(f64, bool)>; 2] {
        match self {
            Self::Finite | Self::NotZero | Self::Radius(..) => [None; 2],
            Self::Positive => [Some((0.0, false)), None],
            Self::NotNegative | Self::UpTo(..) => [Some((0.0, true)), None],
            Self::Magnitude(high) => [Some((-high, true)), Some((high, true))],
            Self::Between(low, high) => [Some((low, true)), Some((high, true))],
            Self::Inside(low, high) => [Some((low, false)), Some((high, false))],
            Self::AboveUpTo(low, high) => [Some((low, false)), Some((high, true))],
            Self::AtLeast(low) => [Some((low, true)), None],
        }
    }
}

/// A number with its unit, if it has one.
pub fn with_unit(value: f64, unit: &str) -> String {
    format!("{} {unit}", readable(value)).trim_end().to_owned()
}

/// Formats a number with at most six digits, using powers of ten instead of a run of zeros.
pub fn readable(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-2..1e5).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reporting::Names;

    #[test]
    fn only_a_radius_may_be_infinite_and_nothing_is_nan() {
        let all = [
            Requirement::Finite,
            Requirement::Positive,
            Requirement::NotNegative,
            Requirement::Magnitude(1.0),
            Requirement::Between(0.0, 1.0),
            Requirement::Inside(0.0, 1.0),
            Requirement::AboveUpTo(0.0, 1.0),
            Requirement::AtLeast(1.0),
            Requirement::Radius(0.1, 10.0),
            Requirement::NotZero,
        ];
        for requirement in all {
            assert!(!requirement.holds(f64::NAN));
            let is_radius = matches!(requirement, Requirement::Radius(..) | Requirement::NotZero);
            assert_eq!(requirement.holds(f64::INFINITY), is_radius);
            assert!(requirement.holds(1.0) || requirement == Requirement::Inside(0.0, 1.0));
        }
        let radius = Requirement::Radius(0.1, 10.0);
        assert!(radius.holds(-0.3) && !radius.holds(0.0) && !radius.holds(f64::NEG_INFINITY));
        assert!(Requirement::Magnitude(1.0).holds(-1.0));
    }

    #[test]
    fn bounds_are_no_runs_of_zeros() {
        let text = |requirement: Requirement, unit| requirement.text(unit, &Names);
        assert_eq!(text(Requirement::Between(1e3, 1e14), "Pa"), "between 1000 and 1e14 Pa");
        assert_eq!(text(Requirement::Magnitude(1e6), "1/m"), "finite and at most ±1e6 1/m");
        let texts = ["0", "-273.15", "1.5708", "0.999", "1e-6", "-2.5e5"];
        let numbers = [0.0, -273.15, std::f64::consts::FRAC_PI_2, 0.999, 1e-6, -2.5e5];
        assert_eq!(numbers.map(readable), texts);
    }
}
