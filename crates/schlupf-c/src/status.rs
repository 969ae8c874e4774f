//! What became of a call.

use std::ffi::CStr;

use schlupf::element;

macro_rules! statuses {
    ($($variant:ident = $code:literal $text:literal)*) => {
        /// What became of a call. Codes never change; there may be more of them.
        #[repr(C)]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Status {
            $(#[doc = concat!(" ", $text, ".")] $variant = $code),*
        }

        impl Status {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// What it means.
            pub const fn text(self) -> &'static CStr {
                const fn terminated(text: &'static str) -> &'static CStr {
                    match CStr::from_bytes_with_nul(text.as_bytes()) {
                        Ok(text) => text,
                        Err(_) => c"",
                    }
                }
                match self { $(Self::$variant => terminated(concat!($text, "\0"))),* }
            }
        }
    };
}

statuses! {
    Found = 0 "forces were found, or what was asked for was done"
    NoContact = 1 "the wheel does not touch the rail: there are no forces"
    NotFinite = 2 "an input or state is not finite; nor are the outputs"
    NotConverged = 3 "a solver did not find the state; the outputs are not finite"
    WrongSize = 4 "an array has another size than it should have; nothing was done"
    InvalidPointer = 5 "a pointer is null or not aligned; nothing was done"
    InvalidElement = 6 "there is no such element; nothing was done"
    Busy = 7 "another thread uses the element; nothing was done"
    InvalidCase = 8 "the case is wrong: the element has no contact, only a message"
    Unreadable = 9 "a file cannot be read: the element has no contact, only a message"
    TooMany = 10 "there is no room for another element"
    Panicked = 11 "an error of the library, which should be reported"
    OutsideTable = 12 "forces were found, with contacts beyond the table of the wheel"
}

impl Status {
    /// Whether there are outputs, then the code: the largest of many calls is the worst.
    pub fn severity(self) -> (bool, i32) {
        (!self.has_outputs(), self as i32)
    }

    /// Whether there are outputs.
    pub fn has_outputs(self) -> bool {
        matches!(self, Self::Found | Self::NoContact | Self::OutsideTable)
    }
}

impl From<element::Status> for Status {
    fn from(status: element::Status) -> Self {
        match status {
            element::Status::Found => Self::Found,
            element::Status::NoContact => Self::NoContact,
            element::Status::OutsideTable => Self::OutsideTable,
            element::Status::NotFinite => Self::NotFinite,
            element::Status::NotConverged => Self::NotConverged,
            element::Status::WrongSize => Self::WrongSize,
        }
    }
}
