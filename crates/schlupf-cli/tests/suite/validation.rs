//! The validation report names tests that exist.

use std::fs;
use std::path::{Path, PathBuf};

/// All Rust files below a folder.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Every `file::test` of docs/validation.md is a test function in a file of that name, and every
/// line of its tables that compares something has one.
#[test]
fn every_line_of_the_report_has_a_test() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let report = fs::read_to_string(root.join("docs/validation.md")).unwrap();
    let mut files = Vec::new();
    sources(&root.join("crates"), &mut files);
    let is_test = |name: &str| {
        let (file, test) = name.split_once("::").unwrap();
        let named = files.iter().filter(|path| path.file_stem().is_some_and(|stem| stem == file));
        named.map(|path| fs::read_to_string(path).unwrap()).any(|text| {
            text.split("#[test]").skip(1).any(|part| {
                let function = part.split_once("fn ").map_or("", |(_, rest)| rest);
                function.starts_with(&format!("{test}()"))
            })
        })
    };
    let names: Vec<&str> =
        report.split('`').filter(|name| name.contains("::") && !name.contains(' ')).collect();
    let unknown: Vec<_> =
        names.iter().filter(|name| **name != "file::test" && !is_test(name)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    let (tables, explanation) = report.split_once("\n## Why").unwrap();
    let is_line = |line: &&str| {
        line.starts_with("| ") && !line.starts_with("| quantity") && !line.starts_with("|---")
    };
    let untested: Vec<&str> =
        tables.lines().filter(is_line).filter(|line| !line.contains("::")).collect();
    assert!(untested.is_empty(), "{untested:?}");
    assert!(names.len() > 40 && explanation.contains("::"), "{}", names.len());
}
