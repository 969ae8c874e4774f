//! Values of fields after they were read.

use std::ops::Range;

use crate::document::Value;

/// The value of a field, numbers in SI units and temperatures in degC.
#[derive(Debug, Clone, PartialEq)]
pub enum Setting {
    /// A number.
    Number(f64),
    /// Text or a path.
    Text(String),
    /// Whether or not.
    Flag(bool),
    /// One of several names.
    Choice(&'static str),
    /// An array of numbers.
    Series(Vec<f64>),
}

/// Why a value cannot stand in a field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// What it must be, to follow "must be".
    pub requirement: String,
    /// What it is.
    pub value: String,
    /// What is wrong with it in particular.
    pub reason: Option<String>,
    /// What to do about it.
    pub help: Option<String>,
    /// Bytes of the value in its text.
    pub span: Range<usize>,
}

impl Refusal {
    /// A value is not what it must be.
    pub fn new(requirement: String, value: &Value) -> Self {
        let shown = value.content.shown();
        Self { requirement, value: shown, reason: None, help: None, span: value.span.clone() }
    }

    /// The same with what is wrong in particular.
    pub fn because(self, reason: String) -> Self {
        Self { reason: Some(reason), ..self }
    }

    /// The same with advice.
    pub fn help(self, help: Option<String>) -> Self {
        Self { help, ..self }
    }

    /// The sentence for a field.
    pub fn message(&self, field: &str) -> String {
        let sentence = format!("{field} must be {}, but is {}", self.requirement, self.value);
        match &self.reason {
            Some(reason) => format!("{sentence}: {reason}"),
            None => sentence,
        }
    }
}
