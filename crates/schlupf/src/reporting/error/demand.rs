//! What values must be.

use super::{Error, Place};
use crate::reporting::{Quantity, Requirement};

/// Refuses a value that does not meet a requirement.
#[inline]
pub(crate) fn require(
    quantity: Quantity,
    requirement: Requirement,
    value: f64,
) -> Result<(), Error> {
    require_at(quantity, requirement, value, Place::Only)
}

/// The same of one value among several.
#[inline]
pub(crate) fn require_at(
    quantity: Quantity,
    requirement: Requirement,
    value: f64,
    place: Place,
) -> Result<(), Error> {
    if requirement.holds(value) {
        return Ok(());
    }
    Err(Error::Invalid { quantity, requirement, value, place })
}

/// A value that must be positive and finite.
#[inline]
pub(crate) fn require_positive(quantity: Quantity, value: f64) -> Result<(), Error> {
    require(quantity, Requirement::Positive, value)
}

/// A value that must be finite.
#[inline]
pub(crate) fn require_finite(quantity: Quantity, value: f64) -> Result<(), Error> {
    require(quantity, Requirement::Finite, value)
}

/// At least so many of something.
pub(crate) fn require_several(
    quantity: Quantity,
    fewest: usize,
    count: usize,
) -> Result<(), Error> {
    if count < fewest { Err(Error::TooFew { quantity, fewest, count }) } else { Ok(()) }
}
