//! Input files and what becomes of them.

#![allow(dead_code, reason = "every test file uses a part of it")]

use std::collections::BTreeMap;
use std::sync::Arc;

use schlupf_case::import::contact::{self, Import, ImportedCase, Options, WheelBody};
use schlupf_case::{Case, CaseFile, Overrides, Source};

/// A ball of E = 210 GPa under 52.36 kN, a = b = 5 mm, braking with sideways creepage and spin.
pub const BALL: &str = "\
% Example of an input file

% A steel ball that brakes
 3  MODULE
  203100    P-B-T-N-F-S
  022020    L-D-C-M-Z-E
 0000111    H-G-I-A-O-W-R
  999 100 30 1 1e-5   MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 52359.878 0.001 -0.0005 0.0002    FN, CKSI, CETA, CPHI
 0.3 0.3   FSTAT, FKIN
 0.0d 0.25 30000.   CHI, DQ, VELOC
 0.28 0.28 82031.25 82031.25   POISS 1,2, GG 1,2
 -3
 44 44 5.0 5.0 1.1   MX, MY, AA, BB, SCALE
 0 MODULE
";

/// A text with parts of it replaced, each of which must be there.
pub fn with(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from:?} is not in\n{text}");
        text.replacen(from, to, 1)
    })
}

pub fn import_with(text: &str, wheel: WheelBody) -> Import {
    let source = Arc::new(Source { name: "ball.inp".to_owned(), text: text.to_owned() });
    contact::import(&source, &Options { stem: "ball".to_owned(), folder: String::new(), wheel })
}

pub fn import(text: &str) -> Import {
    import_with(text, WheelBody::First)
}

/// The only case of a text, which `schlupf check` accepts.
pub fn one(text: &str) -> ImportedCase {
    let mut import = import(text);
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    assert_eq!(import.cases.len(), 1);
    let case = import.cases.remove(0);
    read(&case);
    case
}

/// What is wrong with a text, or not available.
pub fn errors(text: &str) -> Vec<String> {
    import(text).errors.iter().map(ToString::to_string).collect()
}

/// A case file that was read and checked.
pub fn read(case: &ImportedCase) -> CaseFile {
    let files: BTreeMap<String, Vec<u8>> = case.files.iter().cloned().collect();
    CaseFile::from_str(&case.text, &case.name, Arc::new(files), Overrides::NONE)
        .unwrap_or_else(|errors| panic!("{errors}\n{}", case.text))
}

/// A case that is ready to be solved.
pub fn posed(case: &ImportedCase) -> Case {
    read(case).pose(&schlupf::unwatched).unwrap_or_else(|errors| panic!("{errors}\n{}", case.text))
}

/// Lines of a case file.
pub fn has(text: &str, lines: &[&str]) {
    for line in lines {
        assert!(text.lines().any(|of_text| of_text == *line), "{line} is missing in\n{text}");
    }
}

fn data(name: &str) -> String {
    std::fs::read_to_string(format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// Rows of a table: names of columns and their values.
pub fn rows(name: &str) -> Vec<Vec<String>> {
    let text = data(name);
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}
