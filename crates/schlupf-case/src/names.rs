//! What a case calls the quantities of the core, and what a command calls the fields of a case.

use std::borrow::Cow;
use std::sync::{Mutex, PoisonError};

use schlupf::Quantity;
use schlupf::reporting::Words;

use crate::fields::{self, FieldPath, SECTIONS};

/// Path of the field that gives a quantity, if one does.
pub fn quantity_field(quantity: Quantity) -> Option<FieldPath> {
    fields::all().find(|field| field.quantities.contains(&quantity)).map(|field| field.path)
}

/// Dotted path of the field, or the section, that gives a quantity; empty where none does.
pub fn path(quantity: Quantity) -> &'static str {
    let section = || SECTIONS.iter().find(|section| section.quantities.contains(&quantity));
    let field = quantity_field(quantity).map(FieldPath::as_str);
    field.or_else(|| section().map(|section| section.name)).unwrap_or_default()
}

/// What fields are called where options of a command give them.
#[derive(Debug, Clone, Copy)]
pub struct FieldNames {
    option: fn(FieldPath) -> Option<&'static str>,
}

impl FieldNames {
    /// As the case file has them.
    pub const CASE: Self = Self { option: |_| None };

    /// Some by options: that of a path.
    pub const fn of_options(option: fn(FieldPath) -> Option<&'static str>) -> Self {
        Self { option }
    }

    /// The option that gives a field, if one does.
    pub fn option(self, path: FieldPath) -> Option<&'static str> {
        (self.option)(path)
    }

    /// What a field is called.
    pub fn name(self, path: FieldPath) -> &'static str {
        self.option(path).unwrap_or(path.as_str())
    }

    /// How a flag is set: `fill_holes = true`, or by its option.
    pub fn switch(self, path: FieldPath) -> String {
        self.option(path).map_or_else(|| format!("{} = true", path.name()), str::to_owned)
    }
}

impl Words for FieldNames {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        let word = match (quantity, quantity_field(quantity)) {
            (Quantity::Heights, _) => "the surface",
            (Quantity::InitialState, _) => "the initial state",
            (_, Some(path)) => self.name(path),
            (_, None) => match path(quantity) {
                "" => quantity.name(),
                section => section,
            },
        };
        word.into()
    }
}

/// Words that notes which quantities it was asked for.
pub struct Noting {
    names: FieldNames,
    asked: Mutex<Vec<Quantity>>,
}

impl Noting {
    /// Those of the names.
    pub fn new(names: FieldNames) -> Self {
        Self { names, asked: Mutex::default() }
    }

    /// The fields of all quantities that were asked for.
    pub fn fields(self) -> impl Iterator<Item = FieldPath> {
        let asked = self.asked.into_inner().unwrap_or_else(PoisonError::into_inner);
        asked.into_iter().filter_map(quantity_field)
    }
}

impl Words for Noting {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).push(quantity);
        self.names.word(quantity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_is_given_once() {
        let mut given: Vec<Quantity> = SECTIONS
            .iter()
            .flat_map(|section| {
                section.fields.iter().flat_map(|f| f.quantities).chain(section.quantities)
            })
            .copied()
            .collect();
        let count = given.len();
        given.sort_unstable();
        given.dedup();
        assert_eq!(given.len(), count);
        assert!(count > 100, "{count}");
    }

    /// A number has the same unit in the core and in the case file.
    #[test]
    fn fields_have_the_unit_of_their_quantity() {
        for field in fields::all().filter(|f| matches!(f.kind, fields::Kind::Quantity(_))) {
            for quantity in field.quantities {
                assert_eq!(field.kind.unit(), quantity.unit(), "{}", field.path);
            }
        }
    }
}
