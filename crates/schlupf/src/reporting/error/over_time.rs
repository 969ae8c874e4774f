//! The words of what is wrong at a time of a history.

use std::borrow::Cow;

use crate::reporting::{Quantity, Words};

/// Words for quantities that vary over time.
pub(super) struct OverTime<'a>(pub &'a dyn Words);

impl Words for OverTime<'_> {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        self.0.word(over_time(quantity))
    }

    fn choice(&self, quantity: Quantity, name: &str) -> String {
        self.0.choice(quantity, name)
    }
}

/// The history of a quantity, if it has one.
pub(super) fn over_time(quantity: Quantity) -> Quantity {
    match quantity {
        Quantity::Speed => Quantity::HistorySpeed,
        Quantity::CreepageX => Quantity::HistoryCreepageX,
        Quantity::CreepageY => Quantity::HistoryCreepageY,
        Quantity::Spin => Quantity::HistorySpin,
        Quantity::Load => Quantity::HistoryLoad,
        Quantity::ForceX => Quantity::HistoryForceX,
        Quantity::ForceY => Quantity::HistoryForceY,
        Quantity::MomentZ => Quantity::HistoryMomentZ,
        other => other,
    }
}
