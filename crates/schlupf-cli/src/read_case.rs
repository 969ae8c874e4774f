//! How a case is read.

use std::path::Path;

use schlupf_case::{CaseFile, Folder, Overrides};

use crate::arguments::{CaseArguments, STANDARD_STREAM};
use crate::failure::Failure;

/// Reads the case that was named, or the default one; nothing is solved yet.
pub fn read_case(arguments: &CaseArguments) -> Result<CaseFile, Failure> {
    let overrides = Overrides { option: "--set", assignments: &arguments.overrides };
    let file = if let Some(path) = &arguments.case {
        if path == Path::new(STANDARD_STREAM) {
            let input = std::io::stdin().lock();
            CaseFile::from_reader(input, "standard input", Folder::new(""), overrides)
        } else {
            CaseFile::from_path(path, overrides)
        }
    } else {
        let text = CaseFile::default_text();
        CaseFile::from_str(&text, "default case", Folder::new(""), overrides)
    };
    Ok(file?)
}
