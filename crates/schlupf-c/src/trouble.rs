//! Why the last call did not do what it should, as a sentence that is made when it is asked for.

use std::fmt;

use schlupf::Quantity;
use schlupf_case::{CaseErrors, Cause};

use crate::Status;

/// What kept a call from its work.
#[derive(Debug, Clone)]
pub enum Trouble {
    /// Its status says all.
    Status(Status),
    /// An array has another size than it should have.
    Size {
        /// Which one.
        array: &'static str,
        /// Its size.
        given: usize,
        /// That it should have.
        wanted: usize,
    },
    /// A pointer is null or not aligned.
    Pointer {
        /// To what.
        name: &'static str,
    },
    /// A text is not UTF-8.
    Text {
        /// Which one.
        name: &'static str,
    },
    /// An input or state is not finite.
    Value {
        /// Which one.
        quantity: Quantity,
        /// In the unit of the quantity.
        value: f64,
    },
    /// A duration (in s) is not finite, or negative.
    Duration(f64),
    /// A case is wrong.
    Case {
        /// What is wrong with it.
        text: Box<str>,
        /// Whether a file is what cannot be read.
        is_file: bool,
    },
}

impl Trouble {
    /// The status of the call.
    pub fn status(&self) -> Status {
        match self {
            Self::Status(status) => *status,
            Self::Size { .. } => Status::WrongSize,
            Self::Pointer { .. } => Status::InvalidPointer,
            Self::Value { .. } | Self::Duration(..) => Status::NotFinite,
            Self::Text { .. } | Self::Case { is_file: false, .. } => Status::InvalidCase,
            Self::Case { is_file: true, .. } => Status::Unreadable,
        }
    }
}

impl From<CaseErrors> for Trouble {
    fn from(errors: CaseErrors) -> Self {
        let is_file = errors.first.cause == Cause::FileSystem;
        Self::Case { text: errors.to_string().into(), is_file }
    }
}

impl fmt::Display for Trouble {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Status(status) => formatter.write_str(&status.text().to_string_lossy()),
            Self::Size { array, given, wanted } => {
                write!(formatter, "{array} must have {wanted} numbers, but have {given}")
            }
            Self::Pointer { name } => write!(formatter, "{name} must not be null or unaligned"),
            Self::Text { name } => write!(formatter, "{name} must be text in UTF-8"),
            Self::Value { quantity, value } => {
                write!(formatter, "{} must be finite, but is {value}", quantity.name())
            }
            Self::Duration(value) => {
                write!(formatter, "the duration must be finite and not negative, but is {value}")
            }
            Self::Case { text, .. } => formatter.write_str(text),
        }
    }
}
