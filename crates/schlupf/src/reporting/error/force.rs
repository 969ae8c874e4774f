//! What can be wrong with prescribed forces.

use super::Error;
use crate::reporting::{Quantity, messages, with_unit};

messages! {
    /// Why no motion has the prescribed forces, or none was found.
    ForceError:

    /// A force is prescribed where creepages must be given.
    "force-not-possible" NotPossible {
        /// What is prescribed.
        quantity: Quantity,
    } *quantity, |name, words| {
        format!("{name}: no force can be prescribed here; give the creepage of that direction")
    };

    /// A force and the creepage of its direction are given together.
    "force-and-creepage" AndCreepage {
        /// The force.
        force: Quantity,
        /// The creepage of the same direction.
        creepage: Quantity,
    } *force, |name, words| format!(
        "{name} must not be given together with {}: the force determines the creepage",
        words.word(*creepage)
    );

    /// No creepage causes the prescribed force: the text has the largest one.
    "unreachable-force" Unreachable {
        /// What is prescribed.
        quantity: Quantity,
        /// Its value, in the unit of the quantity.
        value: f64,
        /// The largest that was found, in the unit of the quantity.
        largest: f64,
        /// μN, in N; not if friction depends on the motion.
        limit: Option<f64>,
        /// Whether other forces are prescribed, too: the largest one is with all of them in
        /// proportion.
        has_others: bool,
    } *quantity, |name, words| {
        let unit = quantity.unit();
        let others = if *has_others { ", with the other prescribed forces in proportion" } else { "" };
        let friction = limit.map_or_else(
            || "with this law of friction".to_owned(),
            |limit| format!("with a friction limit of {}", with_unit(limit, "N")),
        );
        format!(
            "{name} cannot be {}: no creepage causes it; {friction} the largest is {}{others}",
            with_unit(*value, unit),
            with_unit(*largest, unit)
        )
    };

    /// The creepage of a prescribed force was not found.
    "force-not-found" NotFound {
        /// What is prescribed.
        quantity: Quantity,
        /// Its value, in the unit of the quantity.
        value: f64,
        /// That of the nearest state that was found, in the unit of the quantity.
        nearest: f64,
    } *quantity, |name, words| {
        let unit = quantity.unit();
        format!(
            "{name} = {}: the creepage that causes it was not found; the nearest state has {}",
            with_unit(*value, unit),
            with_unit(*nearest, unit)
        )
    };
}

impl From<ForceError> for Error {
    fn from(error: ForceError) -> Self {
        Self::Force { error }
    }
}
