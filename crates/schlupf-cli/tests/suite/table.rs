//! `schlupf table`: a table, its summary, wrong options; `solver.method = "table"`.

use std::fs;

use crate::support::Bench;
use schlupf_case::look_up_table::StoredTable;

/// Few nodes.
const QUICK: [&str; 9] = [
    "table",
    "--smallest-axis-ratio",
    "0.95",
    "--largest-axis-ratio",
    "1.1",
    "--tolerance",
    "0.4",
    "--states",
    "10",
];

#[test]
fn a_table_has_a_summary_and_a_file_that_can_be_refined() {
    let bench = Bench::new();
    let run = bench.run(&[&QUICK[..], &["--output", "t.npz"]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.starts_with("t.npz\n\nnodes      5 x "), "{}", run.stdout);
    assert!(run.stdout.contains("in 10 random states"), "{}", run.stdout);
    let again = bench.run(&[&QUICK[..], &["--from", "t.npz", "--output", "u.npz"]].concat());
    assert_eq!(again.code, Some(0), "{}", again.stderr);
    assert_eq!(bench.list(), ["t.npz", "u.npz"]);
    // Solutions on grids of another shape are not mixed with these.
    let mut square = StoredTable::from_bytes(&fs::read(bench.path("t.npz")).unwrap()).unwrap();
    square.metadata.longer_side_exponent = 0.0;
    fs::write(bench.path("square.npz"), square.to_bytes().unwrap()).unwrap();
    let refused = bench.run(&[&QUICK[..], &["--from", "square.npz", "--output", "w.npz"]].concat());
    assert_eq!(refused.code, Some(2), "{}", refused.stderr);
    assert!(refused.stderr.contains("--from: square.npz must have been solved on more cells"));
    assert_eq!(bench.list(), ["square.npz", "t.npz", "u.npz"]);
    let quiet = bench.run(&[&QUICK[..], &["--output", "v.npz", "--quiet"]].concat());
    assert_eq!(quiet.stdout, "");
    // The file is the same whenever and on however many threads it is made.
    let bytes = |name: &str| fs::read(bench.path(name)).unwrap();
    assert!(bytes("t.npz") == bytes("v.npz"));
}

/// A table of one's own as a method: it is used, and what is none is refused at its field.
#[test]
fn a_case_names_its_own_table() {
    let bench = Bench::new();
    let options = ["--poisson-ratio", "0.25", "--output", "own.npz", "--quiet"];
    assert_eq!(bench.run(&[&QUICK[..], &options].concat()).code, Some(0));
    let case = "[kinematics]\ncreepage_x = 0.0005\n[normal]\nmodel = \"ellipse\"\n\
                semi_axis_x = \"5 mm\"\nsemi_axis_y = \"5 mm\"\nload = \"80 kN\"\n[friction]\n\
                model = \"constant\"\n[solver]\nmethod = \"table\"\n";
    bench.write("case.toml", case);
    let force = |table: &str| {
        let set = format!("solver.table={table}");
        let options = if table.is_empty() { vec![] } else { vec!["--set", set.as_str()] };
        let run =
            bench.run(&[&["solve", "case.toml", "--json", "-", "--quiet"], &options[..]].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        document["normalised"]["x"].as_f64().unwrap()
    };
    let (own, standard) = (force("own.npz"), force(""));
    assert!(own != standard && (own - standard).abs() < 0.1, "{own} {standard}");
    bench.write("text.npz", "no table");
    fs::write(bench.path("cut.npz"), &fs::read(bench.path("own.npz")).unwrap()[..2000]).unwrap();
    for (table, told) in [
        ("text.npz", "must be a look-up table"),
        ("cut.npz", "must be a look-up table"),
        ("missing.npz", "must be the path of a readable file"),
    ] {
        let set = format!("solver.table={table}");
        let run = bench.run(&["solve", "case.toml", "--set", &set]);
        assert!(matches!(run.code, Some(1 | 2)), "{table} {:?}", run.code);
        assert!(run.stderr.contains(told) && run.stderr.contains("solver.table"), "{}", run.stderr);
        assert!(run.stderr.contains(table), "{}", run.stderr);
    }
}

/// A table that may not have enough nodes is written and marked.
#[test]
fn an_error_that_is_not_met_is_told() {
    let bench = Bench::new();
    let options = [&QUICK[..5], &["--tolerance", "0.005", "--states", "20"]].concat();
    let run = bench.run(&[&options[..], &["--most-solutions", "1"]].concat());
    assert_eq!(run.code, Some(3), "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("not within 0.50 %"), "{}", run.stdout);
    assert_eq!(bench.list(), ["table.npz"]);
}

#[test]
fn wrong_options_are_named() {
    let bench = Bench::new();
    bench.write("text.npz", "no table");
    for (options, told) in [
        (&["--tolerance", "0"][..], "--tolerance"),
        (&["--poisson-ratio", "0.7"], "--poisson-ratio"),
        (&["--smallest-axis-ratio", "3", "--largest-axis-ratio", "2"], "--smallest-axis-ratio"),
        (&["--largest-axis-ratio", "1e9"], "--largest-axis-ratio"),
        (&["--states", "0"], "--states"),
        (&["--output", "table.csv"], "must end in .npz"),
        (&["--output", "-"], "--output"),
        (&["--output", "text.npz/t.npz"], "text.npz: not a directory"),
        (&["--from", "text.npz"], "text.npz must be a look-up table"),
        (&["--from", "missing.npz"], "missing.npz"),
        (&["--from", "text.npz", "--output", "text.npz"], "--output"),
    ] {
        let run = bench.run(&[&["table"], options].concat());
        assert!(matches!(run.code, Some(1 | 2)), "{options:?} {:?}", run.code);
        assert!(run.stderr.contains(told), "{options:?}: {}", run.stderr);
    }
    assert_eq!(bench.list(), ["text.npz"]);
}

/// The table as a method: forces with derivatives and a moment, no fields; heat is told of.
#[test]
fn the_table_is_a_method() {
    let bench = Bench::new();
    let case = "[kinematics]\ncreepage_x = 0.001\nspin = \"0.2 1/m\"\n[friction]\n\
                model = \"constant\"\ncoefficient = 0.35\n";
    bench.write("case.toml", case);
    let run = bench.run(&[
        "solve",
        "case.toml",
        "--set",
        "solver.method=table",
        "--json",
        "t.json",
        "--quiet",
    ]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let full = bench.run(&[
        "solve",
        "case.toml",
        "--set",
        "elasticity.model=half-space",
        "--set",
        "contact_law.model=coulomb",
        "--json",
        "f.json",
        "--quiet",
    ]);
    assert_eq!(full.code, Some(0), "{}", full.stderr);
    let [table, full] = ["t.json", "f.json"]
        .map(|name| serde_json::from_str::<serde_json::Value>(&bench.read(name)).unwrap());
    assert_eq!(table["status"], "converged");
    for force in ["x", "y", "moment_z"] {
        let [one, other] = [&table, &full].map(|d| d["normalised"][force].as_f64().unwrap());
        assert!((one - other).abs() < 0.01, "{force}: {one} {other}");
        for by in ["creepage_x", "creepage_y", "spin", "load", "friction_coefficient"] {
            assert!(table["sensitivity"][by][force].is_number(), "{by} {force}: {table:#}");
        }
    }
    let slopes = [&table, &full].map(|d| d["sensitivity"]["creepage_x"]["x"].as_f64().unwrap());
    assert!((slopes[0] / slopes[1] - 1.0).abs() < 0.03, "{slopes:?}");
}
