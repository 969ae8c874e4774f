//! Notices: what users of results should know about what the command did.

use schlupf::reporting::{Message, messages};
use schlupf_case::FieldNames;

messages! {
    /// A notice about a field of a case.
    Notice of &'static str:

    /// States of a look-up table could not be kept for a later run; the table is whole.
    "states-not-kept" StatesNotKept {
        /// Why.
        reason: String,
    } "--output", |subject, words| reason.clone();
}

impl From<Notice> for Message {
    fn from(notice: Notice) -> Self {
        notice.message(&FieldNames::CASE)
    }
}
