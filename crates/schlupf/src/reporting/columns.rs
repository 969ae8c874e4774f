//! Results as columns: name, quantity and getter of every number of a record.
//!
//! CSV, JSON, VTK and all other outputs read these tables, so a number added here appears in all of
//! them.

pub use crate::columns;
use crate::reporting::Quantity;

/// An entry of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number, in the unit of the quantity or dimensionless.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// A yes/no value.
    Flag(bool),
    /// One of several names.
    Name(&'static str),
    /// An unknown value.
    Unknown,
}

impl Value {
    /// The entry as a number (in the unit of the quantity, or dimensionless), if it is one; a flag
    /// is 0 or 1.
    pub fn number(self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(number),
            Self::Count(count) => Some(count as f64),
            Self::Flag(flag) => Some(f64::from(u8::from(flag))),
            Self::Name(_) | Self::Unknown => None,
        }
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Option<f64>> for Value {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Unknown, Self::Number)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<bool> for Value {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

/// A column of a record.
#[derive(Debug, Clone, Copy)]
pub struct Column<R: ?Sized> {
    /// Name in results.
    pub name: &'static str,
    /// The quantity in the column: symbol, unit, description.
    pub quantity: Quantity,
    /// The entry of a row.
    pub value: fn(&R, usize) -> Value,
}

impl<R: ?Sized> Column<R> {
    /// A column with the name of its quantity.
    pub const fn new(quantity: Quantity, value: fn(&R, usize) -> Value) -> Self {
        Self { name: quantity.name(), quantity, value }
    }

    /// The same column under another name.
    #[must_use]
    pub const fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }
}

/// A result consisting of rows with the same columns.
pub trait Record: Send + Sync + 'static {
    /// Number of rows.
    fn rows(&self) -> usize;

    /// The columns.
    const COLUMNS: &'static [Column<Self>];
}

/// The columns of a record: `quantity => |record, row| entry`, with another name in quotes if that
/// of the quantity says too much. Two of the same name do not compile.
#[macro_export]
macro_rules! columns {
    ($record:ty: $($quantity:ident $($name:literal)? => |$r:pat_param, $k:pat_param| $value:expr),* $(,)?) => {
        &$crate::reporting::distinct([$(
            $crate::reporting::Column::new(
                $crate::Quantity::$quantity,
                |$r: &$record, $k: usize| $crate::reporting::Value::from($value),
            )$(.named($name))?
        ),*])
    };
}

/// The same columns, whose names must differ.
///
/// # Panics
/// If two have the same name; in a constant, that is an error of the compiler.
#[doc(hidden)]
pub const fn distinct<R: ?Sized, const N: usize>(columns: [Column<R>; N]) -> [Column<R>; N] {
    let mut one = 0;
    while one < N {
        let mut other = 0;
        while other < one {
            assert!(!is_same(columns[one].name, columns[other].name), "two columns of one name");
            other += 1;
        }
        one += 1;
    }
    columns
}

const fn is_same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    let mut k = 0;
    while k < one.len() && k < other.len() && one[k] == other[k] {
        k += 1;
    }
    k == one.len() && k == other.len()
}
