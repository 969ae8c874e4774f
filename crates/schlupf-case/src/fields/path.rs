//! The dotted path of a field, which is one of the table.

use std::fmt;
use std::ops::Deref;

use super::Field;
use super::table::{PATHS, SECTIONS};

/// The path of a field of the table, in whose order paths are. Code has those of
/// [`field!`](crate::field), which does not compile for another text; that of a user is looked up
/// with [`find`](super::find).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FieldPath {
    section: u8,
    place: u8,
}

impl FieldPath {
    /// That of a literal.
    ///
    /// # Panics
    /// No field has this path.
    #[doc(hidden)]
    #[expect(clippy::panic, reason = "only when it is compiled: see the macro")]
    pub const fn known(path: &str) -> Self {
        let mut section = 0;
        while section < PATHS.len() {
            let mut place = 0;
            while place < PATHS[section].len() {
                if is_same(PATHS[section][place].as_bytes(), path.as_bytes()) {
                    return Self { section: section as u8, place: place as u8 };
                }
                place += 1;
            }
            section += 1;
        }
        panic!("no field of the case file has this path");
    }

    /// The field.
    pub fn field(self) -> &'static Field {
        &SECTIONS[usize::from(self.section)].fields[usize::from(self.place)]
    }

    /// Name of the section it stands in; empty for the top level.
    pub fn section(self) -> &'static str {
        SECTIONS[usize::from(self.section)].name
    }

    /// Last part of the path.
    pub fn name(self) -> &'static str {
        self.as_str().rsplit('.').next().unwrap_or_default()
    }

    /// The path as text.
    pub const fn as_str(self) -> &'static str {
        PATHS[self.section as usize][self.place as usize]
    }
}

/// Compares from the end, where paths of one length differ.
const fn is_same(one: &[u8], other: &[u8]) -> bool {
    let mut left = one.len();
    if left != other.len() {
        return false;
    }
    while left > 0 {
        left -= 1;
        if one[left] != other[left] {
            return false;
        }
    }
    true
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
