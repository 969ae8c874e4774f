//! Tables as files.

use schlupf::analysis::table_building::{
    LONGER_SIDE_EXPONENT, NothingKept, TableOptions, build, build_from,
};
use schlupf::unwatched;
use schlupf_case::look_up_table::shared;
use schlupf_case::look_up_table::{StoredTable, TableFileError, standard};
use schlupf_case::{CaseFile, Folder, Overrides};

/// The file in the package.
const STANDARD: &[u8] = include_bytes!("../../src/look_up_table/standard.npz");

fn options() -> TableOptions {
    TableOptions { axis_ratios: [0.9, 1.2], tolerance: 0.4, states: 10, ..TableOptions::default() }
}

/// The standard table: under 5 MB, 1 % of μN in random states that had no part in making it.
#[test]
fn the_standard_table_states_its_error() {
    assert!(STANDARD.len() < 5_000_000, "{}", STANDARD.len());
    let metadata = &standard().unwrap().metadata;
    assert_eq!(metadata.poisson_ratio, 0.28);
    assert_eq!(standard().unwrap().table.axis_ratios(), [0.1, 10.0]);
    assert!(metadata.is_within_tolerance && metadata.error.largest <= 0.01);
    assert!(metadata.error.median < 0.001 && metadata.error.states >= 1000);
    assert_eq!(metadata.unconverged, 0);
    assert_eq!(metadata.longer_side_exponent, LONGER_SIDE_EXPONENT);
}

/// Cases with the same file have the same table, as long as one of them is used.
#[test]
fn a_table_is_read_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("t.npz"), STANDARD).unwrap();
    let text = "solver = { method = \"table\", table = \"t.npz\" }";
    let method = || {
        let files = Folder::new(folder.path());
        CaseFile::from_str(text, "case", files, Overrides::NONE).unwrap().method().unwrap()
    };
    // Methods are equal if their table is the same one.
    assert_eq!(method(), method());
    assert!(shared(b"no table").is_err());
}

/// A table that is made, written and read again is the same, and so is one made from it.
#[test]
fn a_table_survives_its_file() {
    let built = build(&options(), &NothingKept, &unwatched).unwrap();
    assert!(built.is_within_tolerance && built.error.median < 0.05, "{:?}", built.error);
    assert_eq!(built.unconverged, 0);
    let (error, solutions) = (built.error, built.solutions);
    let stored = StoredTable::new(built, &options());
    let bytes = stored.to_bytes().unwrap();
    let read = StoredTable::from_bytes(&bytes).unwrap();
    assert!(read == stored, "{:?} {:?}", read.metadata, stored.metadata);
    assert!(bytes == read.to_bytes().unwrap());
    let again = build_from(&read.table, &options(), &NothingKept, &unwatched).unwrap();
    assert_eq!(again.solutions, solutions);
    assert!((again.error.largest - error.largest).abs() < 1e-6);
    let sliding = stored.metadata.sliding_error.as_ref().map(|error| error.states);
    assert_eq!(sliding, Some(10 * options().states));
    let other = TableOptions { poisson_ratio: 0.3, ..options() };
    let refused =
        build_from(&read.table, &other, &NothingKept, &unwatched).unwrap_err().to_string();
    assert!(refused.starts_with("poisson_ratio"), "{refused}");
}

#[test]
fn files_that_are_no_tables_are_refused() {
    let refused = |bytes: &[u8]| StoredTable::from_bytes(bytes).unwrap_err();
    let text = |bytes: &[u8]| refused(bytes).to_string();
    assert!(text(b"").starts_with("must be a look-up table"));
    assert!(text(b"a,b\n1,2\n").contains("is no archive"));
    assert!(text(&STANDARD[..STANDARD.len() / 2]).starts_with("must be a look-up table"));
    // Another digit of a number: the archive's own checksum sees it.
    let mut damaged = STANDARD.to_vec();
    let middle = damaged.len() / 2;
    damaged[middle] ^= 1;
    assert!(matches!(refused(&damaged), TableFileError::Damaged(_)), "{}", text(&damaged));
}

/// What the metadata of a table says with other values: written anew, so that the archive is whole.
#[test]
fn another_version_is_named() {
    let mut stored = standard().unwrap();
    stored.metadata.version = 2;
    let newer = StoredTable::from_bytes(&stored.to_bytes().unwrap()).unwrap_err();
    assert_eq!(newer, TableFileError::Version(2));
    assert!(newer.to_string().contains("version 2, but this program reads version 1"));
    let mut stored = standard().unwrap();
    stored.metadata.sha256 = "0".repeat(64);
    let damaged = StoredTable::from_bytes(&stored.to_bytes().unwrap()).unwrap_err();
    assert!(damaged.to_string().contains("checksum"), "{damaged}");
    let mut stored = standard().unwrap();
    stored.metadata.nodes[0] += 1;
    let unfit = StoredTable::from_bytes(&stored.to_bytes().unwrap()).unwrap_err();
    assert!(unfit.to_string().contains("another shape"), "{unfit}");
    let mut stored = standard().unwrap();
    stored.metadata.nodes = [usize::MAX; 4];
    let many = StoredTable::from_bytes(&stored.to_bytes().unwrap()).unwrap_err();
    assert!(many.to_string().contains("too many nodes"), "{many}");
}

#[test]
fn options_outside_their_bounds_are_named() {
    let refused =
        |options: &TableOptions| build(options, &NothingKept, &unwatched).unwrap_err().to_string();
    let base = options();
    for (options, name) in [
        (TableOptions { axis_ratios: [1.2, 0.9], ..base.clone() }, "axis_ratio"),
        (TableOptions { axis_ratios: [0.0, 1.0], ..base.clone() }, "axis_ratio"),
        (TableOptions { tolerance: 0.0, ..base.clone() }, "tolerance"),
        (TableOptions { tolerance: f64::NAN, ..base.clone() }, "tolerance"),
        (TableOptions { poisson_ratio: 0.7, ..base.clone() }, "poisson_ratio"),
        (TableOptions { cells: 4, ..base.clone() }, "cells_x"),
        (TableOptions { states: 0, ..base }, "look_up_table"),
    ] {
        assert!(refused(&options).starts_with(name), "{}", refused(&options));
    }
}
