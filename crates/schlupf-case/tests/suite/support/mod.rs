//! Cases that are read from a text, and the errors that they must give.

use schlupf::unwatched;
use schlupf_case::{Case, CaseErrors, CaseFile, Folder, Overrides};

pub fn read(text: &str, overrides: &[&str]) -> Result<Case, CaseErrors> {
    let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
    CaseFile::from_str(
        text,
        "case.toml",
        Folder::new("/nowhere"),
        Overrides { option: "--set", assignments: &overrides },
    )?
    .pose(&unwatched)
}

/// A case text, the field that the error names, and parts of its text.
pub type Row = (&'static str, &'static str, &'static [&'static str]);

#[track_caller]
pub fn assert_errors(rows: &[Row]) {
    for (text, field, parts) in rows {
        let Err(errors) = read(text, &[]) else { panic!("{text:?} was accepted") };
        let message = errors.first.to_string();
        assert_eq!(errors.first.field, *field, "{text:?}: {message}");
        for part in *parts {
            assert!(message.contains(part), "{text:?}: {part:?} is not in {message:?}");
        }
    }
}
