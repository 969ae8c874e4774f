//! Where among several a value stands.

use crate::reporting::readable;

/// Where among several a value stands.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Place {
    /// It is the only one.
    Only,
    /// At a time, in s.
    Time(f64),
    /// At a position x, y, in m.
    Position([f64; 2]),
    /// At a position y, in m.
    Across(f64),
    /// At a place of a list, counted from 1.
    Index(usize),
    /// In a row and a column, counted from 0.
    Cell {
        /// The row.
        row: usize,
        /// The column.
        column: usize,
    },
}

impl Place {
    /// It in words, to follow a value.
    pub(super) fn text(self) -> String {
        match self {
            Self::Only => String::new(),
            Self::Time(time) => format!(" at {} s", readable(time)),
            Self::Position([x, y]) => {
                format!(" at x = {} m, y = {} m", readable(x), readable(y))
            }
            Self::Across(y) => format!(" at y = {} m", readable(y)),
            Self::Index(index) => format!(" in place {index}"),
            Self::Cell { row, column } => format!(" in row {row}, column {column}"),
        }
    }
}
