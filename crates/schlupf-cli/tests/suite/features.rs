//! What the command says of the files that it can write with the features it is built with.

use crate::support::{Bench, TABLES};

const STUDY: &str = "case = \"case.toml\"\n[vary]\n\"kinematics.creepage_x\" = [0.001]\n";

fn bench(study: &str) -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", "[grid]\ncells_x = 8\n");
    bench.write("study.toml", study);
    bench
}

#[test]
fn the_help_names_what_can_be_written() {
    let bench = Bench::new();
    let tables = if cfg!(feature = "parquet") { ": .csv or .parquet" } else { ": .csv" };
    let figures = if cfg!(feature = "png") { "(PNG and SVG)" } else { "(SVG, without" };
    for (command, part) in [
        ("sweep", format!("{tables}; run again")),
        ("merge", format!("{tables}\n")),
        ("solve", format!("figures {figures}")),
        ("check", format!("in place {figures}")),
    ] {
        let help = bench.run(&[command, "--help"]).stdout;
        assert!(help.contains(&part), "{part:?} is not in\n{help}");
    }
}

#[test]
fn tables_are_written_where_they_can_be() {
    let bench = bench(STUDY);
    for name in ["table.csv", "table.parquet"] {
        let run = bench.run(&["sweep", "study.toml", "--output", name]);
        let told = "table.parquet: a .parquet file needs a program built with the feature parquet";
        let is_known = TABLES.contains(&name);
        assert_eq!(run.code, Some(if is_known { 0 } else { 2 }), "{}", run.stderr);
        assert_eq!(run.stderr.contains(told), !is_known, "{}", run.stderr);
    }
}

#[test]
fn fields_of_states_need_parquet() {
    let bench = bench(&format!("{STUDY}[fields]\n"));
    let run = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    let is_known = cfg!(feature = "parquet");
    assert_eq!(run.code, Some(if is_known { 0 } else { 2 }), "{}", run.stderr);
    assert_eq!(run.stderr.contains("feature parquet"), !is_known, "{}", run.stderr);
}

/// A state is read from a file before a study begins.
#[test]
fn states_of_a_file_need_parquet_if_they_are() {
    let bench = bench("case = \"case.toml\"\n[states]\nfile = \"states.parquet\"\n");
    bench.write("states.parquet", "");
    let run = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("states.parquet"), "{}", run.stderr);
    let is_known = cfg!(feature = "parquet");
    assert_eq!(run.stderr.contains("feature parquet"), !is_known, "{}", run.stderr);
}
