//! The dotted path of a field, which is one of the table: the module above looks it up there.

use std::fmt;
use std::ops::Deref;

/// The path of a field of the table, in whose order paths are. Code has those of
/// [`field!`](crate::field), which does not compile for another text; that of a user is looked up
/// with [`find`](super::find).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FieldPath {
    /// The place of its section in the table.
    pub(super) section: u8,
    /// Its own place in the section.
    pub(super) place: u8,
}

impl Deref for FieldPath {
    type Target = str;

    fn deref(&self) -> &str {
        self.as_str()
    }
}

impl AsRef<str> for FieldPath {
    fn as_ref(&self) -> &str {
        self
    }
}

impl fmt::Display for FieldPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self)
    }
}

impl fmt::Debug for FieldPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.as_str(), f)
    }
}

/// The [`FieldPath`] of a literal, looked up in the table when it is compiled.
///
/// ```
/// assert_eq!(schlupf_case::field!("normal.load").field().kind.unit(), "N");
/// ```
///
/// ```compile_fail
/// schlupf_case::field!("normal.laod");
/// ```
#[macro_export]
macro_rules! field {
    ($($path:literal),+) => {
        const { $crate::FieldPath::known(concat!($($path),+)) }
    };
}

/// The same of several literals, as an array.
#[macro_export]
macro_rules! fields {
    ($($path:literal),+ $(,)?) => {
        const { [$($crate::FieldPath::known($path)),+] }
    };
}
