//! What a number must be.

/// A condition on a number in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Requirement {
    /// Any finite number.
    Finite,
    /// Finite and above zero.
    Positive,
    /// Finite and not below zero.
    NonNegative,
    /// Within bounds that belong to it.
    Between(f64, f64),
    /// Within bounds that do not belong to it.
    Inside(f64, f64),
    /// Above the first and at most the second.
    AboveUpTo(f64, f64),
    /// At least.
    AtLeast(f64),
    /// A radius of curvature: positive where convex, negative where concave, infinite where straight.
    Radius,
}

impl Requirement {
    /// Whether a value meets it.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Radius => !value.is_nan() && value != 0.0 && value != f64::NEG_INFINITY,
            _ if !value.is_finite() => false,
            Self::Finite => true,
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::Between(low, high) => (low..=high).contains(&value),
            Self::Inside(low, high) => low < value && value < high,
            Self::AboveUpTo(low, high) => low < value && value <= high,
            Self::AtLeast(low) => value >= low,
        }
    }

    /// It in words, to follow "must be"; `unit` is the unit of the bounds.
    pub fn text(self, unit: &str) -> String {
        let words = match self {
            Self::Finite => return "finite".to_owned(),
            Self::Positive => return "positive and finite".to_owned(),
            Self::NonNegative => return "zero or positive, and finite".to_owned(),
            Self::Radius => {
                return "a length other than 0: negative where concave, \"inf\" where straight"
                    .to_owned();
            }
            Self::Between(low, high) => format!("between {low} and {high}"),
            Self::Inside(low, high) => format!("above {low} and below {high}"),
            Self::AboveUpTo(low, high) => format!("above {low} and at most {high}"),
            Self::AtLeast(low) => format!("at least {low}"),
        };
        format!("{words} {unit}").trim_end().to_owned()
    }

    /// Bounds for a JSON schema: its keyword and the number.
    pub fn bounds(self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Finite | Self::Radius => Vec::new(),
            Self::Positive => vec![("exclusiveMinimum", 0.0)],
            Self::NonNegative => vec![("minimum", 0.0)],
            Self::Between(low, high) => vec![("minimum", low), ("maximum", high)],
            Self::Inside(low, high) => vec![("exclusiveMinimum", low), ("exclusiveMaximum", high)],
            Self::AboveUpTo(low, high) => vec![("exclusiveMinimum", low), ("maximum", high)],
            Self::AtLeast(low) => vec![("minimum", low)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_radius_may_be_infinite_and_nothing_is_nan() {
        let all = [
            Requirement::Finite,
            Requirement::Positive,
            Requirement::NonNegative,
            Requirement::Between(0.0, 1.0),
            Requirement::Inside(0.0, 1.0),
            Requirement::AboveUpTo(0.0, 1.0),
            Requirement::AtLeast(1.0),
            Requirement::Radius,
        ];
        for requirement in all {
            assert!(!requirement.holds(f64::NAN));
            let is_radius = requirement == Requirement::Radius;
            assert_eq!(requirement.holds(f64::INFINITY), is_radius);
            assert!(requirement.holds(1.0) || requirement == Requirement::Inside(0.0, 1.0));
        }
        assert!(Requirement::Radius.holds(-0.3) && !Requirement::Radius.holds(0.0));
        assert!(!Requirement::Positive.holds(0.0) && Requirement::NonNegative.holds(0.0));
    }
}
