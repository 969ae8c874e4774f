//! Fields that a body may have on one side only.

use schlupf::wheel_rail::Side;

use crate::FieldPath;
use crate::error::CaseError;
use crate::settings::Settings;

/// Paths of a field of both sides, and of one of them.
#[derive(Debug, Clone, Copy)]
pub struct Sided {
    /// Of both.
    pub common: FieldPath,
    /// Of the left one alone.
    pub left: FieldPath,
    /// Of the right one alone.
    pub right: FieldPath,
}

/// The paths of a field of `wheel` or `rail`.
macro_rules! sided {
    ($body:literal, $name:literal) => {
        $crate::side::Sided {
            common: field!($body, ".", $name),
            left: field!("left_", $body, ".", $name),
            right: field!("right_", $body, ".", $name),
        }
    };
}
pub(crate) use sided;

impl Sided {
    /// The field that counts on a side.
    pub fn of(self, settings: &Settings, side: Side) -> FieldPath {
        let own = match side {
            Side::Left => self.left,
            Side::Right => self.right,
        };
        if settings.is_given(own) { own } else { self.common }
    }

    /// Its number, in SI units.
    pub fn number(self, settings: &Settings, side: Side) -> Result<f64, CaseError> {
        settings.number(self.of(settings, side))
    }
}
