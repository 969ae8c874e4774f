//! Notices: what users of results should know about what the command did.

use schlupf::reporting::{Message, messages};
use schlupf_case::FieldNames;

messages! {
    /// A notice about a field of a case.
    Notice of &'static str:

    /// States of a look-up table that could not be kept for a later run.
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use schlupf::Error;
    use schlupf_tasks::Notice as TaskNotice;

    use super::*;

    /// The codes in the tables of a part of docs/messages.md.
    fn documented(part: usize) -> BTreeSet<String> {
        let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/messages.md");
        let page = std::fs::read_to_string(page).unwrap();
        let part = page.split("\n# ").nth(part).unwrap();
        let rows = part.lines().filter_map(|line| line.strip_prefix("| `")?.split_once('`'));
        rows.map(|(code, _)| code.to_owned()).collect()
    }

    fn all(codes: &[&[&str]]) -> BTreeSet<String> {
        codes.concat().into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn every_warning_is_documented_and_no_other() {
        let codes = [
            schlupf::Warning::CODES,
            schlupf_case::Notice::CODES,
            schlupf_case::import::Notice::CODES,
            TaskNotice::CODES,
            Notice::CODES,
        ];
        assert_eq!(documented(0), all(&codes));
    }

    #[test]
    fn every_error_is_documented_and_no_other() {
        use schlupf::reporting::{FitError, ForceError, SurfaceError, WheelRailError};
        /// Those of which the code is that of the error within.
        const OUTER: [&str; 6] =
            ["at-time", "no-rolling-at-patch", "surface", "fit", "force", "wheel-rail"];
        let parts =
            [FitError::CODES, ForceError::CODES, SurfaceError::CODES, WheelRailError::CODES];
        let mut codes = all(&[Error::CODES]);
        codes.extend(all(&parts));
        codes.retain(|code| !OUTER.contains(&code.as_str()));
        assert_eq!(documented(1), codes);
    }
}
