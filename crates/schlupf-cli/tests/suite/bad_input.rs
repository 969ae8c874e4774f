//! Bad input from the outside: exit code 2, the place with the line and a caret, nothing written.

use crate::support::Bench;

/// Arguments after `solve case.toml --json r.json`, text of the case, parts of the report.
const ROWS: &[(&[&str], &str, &[&str])] = &[
    (
        &[],
        "[kinematics]\nspeed = \"108 kN\"\n",
        &[
            "error: case.toml:2:9: kinematics.speed must be a speed",
            "\"108 kN\"",
            "2 | speed = \"108 kN\"",
            "^^^",
        ],
    ),
    (&[], "[normal]\nload = 80\n", &["case.toml:2:8", "normal.load must be a force", "80 N"]),
    (
        &[],
        "[grid]\ncells_z = 3\n",
        &["case.toml:2:1: unknown field `grid.cells_z`", "`grid.cells_x`"],
    ),
    (&[], "[normal\n", &["case.toml:1:", "not TOML"]),
    (
        &["--set", "normal.load=-1 kN"],
        "",
        &["--set normal.load=-1 kN: normal.load must be between 1e-9 and 1e12 N"],
    ),
    (&["--set", "normal.load"], "", &["section.field=value"]),
    (&[], "[rail]\nradius_y = \"inf\"\n", &["case.toml:2:12", "rail.radius_y"]),
    (
        &[],
        "[grid]\ncells_x = 0\ncells_y = 0\n",
        &["grid.cells_x must be between 2 and 1024", "grid.cells_y must be between 1 and 1024"],
    ),
    (&["--frobnicate"], "", &["unexpected argument"]),
];

#[test]
fn it_is_reported_with_its_place_and_nothing_is_written() {
    for (arguments, text, parts) in ROWS {
        let bench = Bench::new();
        bench.write("case.toml", text);
        let mut all = vec!["solve", "case.toml", "--json", "r.json"];
        all.extend(*arguments);
        let run = bench.run(&all);
        assert_eq!(run.code, Some(2), "{text:?}: {}", run.stderr);
        assert_eq!(run.stdout, "");
        for part in *parts {
            assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
        }
        assert_eq!(bench.list(), ["case.toml"]);
    }
}

#[test]
fn a_defect_of_a_table_is_shown_in_the_table() {
    let bench = Bench::new();
    bench.write("case.toml", "[normal]\nmodel = \"tabulated\"\nfile = \"p.csv\"\n");
    bench.write("p.csv", "x [mm],y [mm],pressure [MPa]\n0,0,1\n1,0,1\n0,1,-1\n1,1,1\n");
    let run = bench.run(&["check", "case.toml"]);
    assert_eq!(run.code, Some(2));
    for part in ["p.csv:4:1: pressure must not be negative", "4 | 0,1,-1"] {
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
    }
}

#[test]
fn what_is_no_text_is_no_case() {
    let bench = Bench::new();
    std::fs::write(bench.path("case.toml"), b"title = \"x\"\n# \xff\n").unwrap();
    let run = bench.run(&["solve", "case.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("UTF-8, but is not in line 2"), "{}", run.stderr);
}

#[test]
fn a_case_that_cannot_be_read_is_a_failure_of_the_file_system() {
    let bench = Bench::new();
    for path in ["missing.toml", "."] {
        let run = bench.run(&["solve", path]);
        assert_eq!(run.code, Some(1), "{}", run.stderr);
        assert!(
            run.stderr.contains(&format!("{path}: the case file cannot be read")),
            "{}",
            run.stderr
        );
    }
}
