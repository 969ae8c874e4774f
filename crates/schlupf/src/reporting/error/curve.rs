//! Why a creep curve cannot be computed.

use super::Error;
use crate::reporting::{Quantity, messages, with_unit};

messages! {
    /// What is wrong with the path of a creep curve or the points on it.
    CurveError:

    /// Start and end of a creep curve are the same.
    "no-range" NoRange {
        /// The creepage.
        quantity: Quantity,
        /// Its value, in its unit if it has one.
        value: f64,
    } *quantity, |name, words| format!(
        "{name} must differ between start and end of a creep curve, as no other creepage varies, but \
         is {} at both",
        with_unit(*value, quantity.unit())
    );

    /// Points of a creep curve out of order, or beyond its ends.
    "curve-order" Order {
        /// What varies.
        quantity: Quantity,
        /// The first such point, in its unit if it has one.
        value: f64,
        /// Start and end of the curve, in the same unit.
        range: [f64; 2],
    } *quantity, |name, words| {
        let [value, start, end] =
            [*value, range[0], range[1]].map(|place| with_unit(place, quantity.unit()));
        format!(
            "{name} must run from {start} to {end} on a creep curve, each point beyond the one before, \
             but one is at {value}"
        )
    };

    /// The wheel locks on a creep curve.
    "locks-on-curve" Locks {
        /// The creepage that varies.
        quantity: Quantity,
        /// Where the wheel no longer rolls, in the unit of the creepage if it has one.
        value: f64,
    } quantity.own_component(), |name, words| {
        let place = with_unit(*value, quantity.unit());
        let abscissa = words.word(*quantity);
        format!(
            "{name}: the wheel must roll throughout a creep curve, but does not at {abscissa} = {place}"
        )
    };
}

impl std::error::Error for CurveError {}

impl From<CurveError> for Error {
    fn from(error: CurveError) -> Self {
        Self::Curve { error }
    }
}
