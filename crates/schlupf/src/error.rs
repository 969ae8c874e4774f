//! What can go wrong before and during a solution.

/// Why a problem cannot be solved as posed.
///
/// A solution that was computed but did not converge is not an error: see
/// [`Status`](crate::solution::Status).
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A quantity has a value that the model does not allow.
    #[error("{quantity} must be {requirement}, but is {value}")]
    Invalid {
        /// The quantity, by its dotted name in the case file, such as `normal.load`.
        quantity: &'static str,
        /// What it must be, with its unit.
        requirement: String,
        /// What it is, with its unit.
        value: String,
    },
    /// Two or more quantities cannot hold together.
    #[error("{quantity}: {reason}")]
    Contradiction {
        /// The quantity that was read last, by its dotted name in the case file.
        quantity: &'static str,
        /// What contradicts what, with the values.
        reason: String,
    },
    /// Something that must be known before the solution was not found.
    #[error("{quantity}: {reason}")]
    NotConverged {
        /// The quantity from which it follows, by its dotted name in the case file.
        quantity: &'static str,
        /// What was not found, with the work that was done.
        reason: String,
    },
    /// Whoever watched wanted no more of it.
    #[error("stopped before the end")]
    Stopped,
}

/// A value that must be positive and finite.
pub(crate) fn require_positive(
    quantity: &'static str,
    value: f64,
    unit: &str,
) -> Result<(), Error> {
    require(value > 0.0 && value.is_finite(), quantity, "positive and finite", value, unit)
}

/// A value that must be finite.
pub(crate) fn require_finite(quantity: &'static str, value: f64, unit: &str) -> Result<(), Error> {
    require(value.is_finite(), quantity, "finite", value, unit)
}

/// `condition`, or an [`Error::Invalid`] that names the quantity, the requirement and the value.
pub(crate) fn require(
    condition: bool,
    quantity: &'static str,
    requirement: &str,
    value: f64,
    unit: &str,
) -> Result<(), Error> {
    if condition {
        return Ok(());
    }
    let value = format!("{value} {unit}").trim_end().to_owned();
    Err(Error::Invalid { quantity, requirement: requirement.to_owned(), value })
}
