//! Codes of messages are documented: every one that there is, and no other.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use schlupf::Warning;

/// What makes messages in the case file's crate and in the command.
const MAKERS: [&str; 4] = ["Message::new(", "notice(", "of(", "NO_EFFECT: &str ="];

fn sources(directory: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
}

/// The words in quotes that come first after whatever makes a message.
fn codes_of(text: &str) -> impl Iterator<Item = String> {
    MAKERS.iter().flat_map(move |maker| {
        let after = text.split(maker).skip(1);
        let quoted = after.filter_map(|rest| rest.trim_start().strip_prefix('"'));
        let codes = quoted.filter_map(|rest| rest.split_once('"').map(|(code, _)| code));
        codes.filter(|code| is_code(code)).map(str::to_owned)
    })
}

fn is_code(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_lowercase())
        && text.contains('-')
        && text.chars().all(|c| c.is_ascii_lowercase() || c == '-')
}

#[test]
fn every_code_is_documented_and_no_other() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    for package in ["schlupf-case", "schlupf-cli"] {
        sources(&crates.join(package).join("src"), &mut files);
    }
    let mut codes: BTreeSet<String> = Warning::CODES.iter().map(|&code| code.to_owned()).collect();
    for file in files {
        codes.extend(codes_of(&fs::read_to_string(file).unwrap()));
    }
    assert!(codes.contains("no-effect") && codes.contains("no-table"), "{codes:?}");
    let page = fs::read_to_string(crates.join("../docs/messages.md")).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split_once('`'));
    let documented: BTreeSet<String> = rows.map(|(code, _)| code.to_owned()).collect();
    assert_eq!(codes, documented);
}
