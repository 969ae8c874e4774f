//! Memory of a study: alone in its program, because the peak is that of the process.

#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;

use schlupf::unwatched;
use schlupf_tasks::study::Study;
use schlupf_tasks::study::run::run;

/// Rows of a batch, in the small study and in the large one.
const BATCH: usize = 4096;

/// Runs a study of so many batches; returns the size of its numbers, in bytes.
fn sweep(folder: &Path, batches: usize) -> usize {
    let list = |count: usize| -> String {
        let values: Vec<String> = (0..count).map(|k| format!("{:e}", 1e-6 * k as f64)).collect();
        values.join(", ")
    };
    let text = format!(
        "case = \"case.toml\"\nbatch = {BATCH}\n[vary]\nkinematics.creepage_x = [{}]\n\
         kinematics.creepage_y = [{}]\n",
        list(batches),
        list(BATCH)
    );
    fs::write(folder.join("case.toml"), "solver.method = \"polach\"\nheat.model = \"none\"\n")
        .unwrap();
    fs::write(folder.join("study.toml"), text).unwrap();
    let study = Study::from_path(&folder.join("study.toml"), None).unwrap();
    let table = folder.join(format!("{batches}.parquet"));
    let report = run(&study, [1, 1], &table, &unwatched).unwrap();
    assert_eq!((report.rows, report.failed), (batches * BATCH, 0));
    8 * report.rows * study.columns().len()
}

/// The largest memory that this process has had, in bytes.
fn peak() -> usize {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    1024 * line.split_whitespace().next().unwrap().parse::<usize>().unwrap()
}

/// Goal: memory does not grow with the rows. Ten times as many take less than a tenth of what the
/// numbers of the additional rows would: what is left is the footer of the Parquet file, with a
/// record for each column of each batch.
#[test]
fn memory_does_not_grow_with_the_rows() {
    let folder = tempfile::tempdir().unwrap();
    let few = sweep(folder.path(), 10);
    let before = peak();
    let many = sweep(folder.path(), 100);
    let (grown, numbers) = (peak() - before, many - few);
    assert!(numbers > 100_000_000, "{numbers}");
    assert!(10 * grown < numbers, "{grown} of {numbers} bytes");
}
