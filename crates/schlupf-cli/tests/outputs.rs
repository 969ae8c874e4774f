//! What all commands do with figures of earlier runs and with warnings.

mod support;

use serde_json::Value;
use support::Bench;

const CASE: &str = "[kinematics]\ncreepage_x = 0.01\n[grid]\ncells_x = 8\ncells_y = 8\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench
}

/// Without heat there is no map of temperatures: that of the run before must not look current.
#[test]
fn figures_that_are_not_drawn_again_are_removed() {
    let bench = bench();
    let draw = |more: &[&str]| {
        let run = bench.run(&[&["solve", "case.toml", "--quiet", "--figures", "f"], more].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
    };
    draw(&[]);
    let maps = ["f/map_temperature.svg", "f/map_temperature.png"].map(|name| bench.path(name));
    assert!(maps.iter().all(|path| path.exists()));
    bench.write("f/notes.txt", "mine");
    draw(&["--set", "heat.model=none"]);
    assert!(maps.iter().all(|path| !path.exists()));
    assert_eq!(bench.read("f/notes.txt"), "mine");
    assert!(bench.path("f/cut_y0.svg").exists());
}

#[test]
fn files_of_others_are_neither_overwritten_nor_removed() {
    for name in ["cut_y0.svg", "map_temperature.png"] {
        let bench = bench();
        std::fs::create_dir(bench.path("f")).unwrap();
        bench.write(&format!("f/{name}"), "mine");
        let run = bench.run(&["solve", "case.toml", "--json", "s.json", "--figures", "f"]);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        assert!(run.stderr.contains(name) && run.stderr.contains("not marked as drawn by schlupf"));
        assert_eq!(bench.read(&format!("f/{name}")), "mine");
        assert_eq!(bench.list(), ["case.toml", "f"]);
    }
}

/// Steady rolling draws no history, so one that is not ours does no harm.
#[test]
fn only_names_of_figures_that_may_be_drawn_count() {
    let bench = bench();
    std::fs::create_dir(bench.path("f")).unwrap();
    bench.write("f/history.png", "mine");
    let draw = |driver: &str| {
        let set = format!("solver.driver={driver}");
        bench.run(&["solve", "case.toml", "--quiet", "--set", &set, "--figures", "f"])
    };
    assert_eq!(draw("steady").code, Some(0));
    let refused = draw("marching");
    assert_eq!(refused.code, Some(2));
    assert!(refused.stderr.contains("history.png is not marked"), "{}", refused.stderr);
    assert_eq!(bench.read("f/history.png"), "mine");
}

/// Each drawing and each picture has its own mark.
#[test]
fn a_figure_is_judged_by_itself() {
    let bench = bench();
    let draw = || bench.run(&["solve", "case.toml", "--quiet", "--figures", "f"]);
    assert_eq!(draw().code, Some(0));
    std::fs::remove_file(bench.path("f/cut_y0.svg")).unwrap();
    let again = draw();
    assert_eq!(again.code, Some(0), "{}", again.stderr);
    assert!(bench.path("f/cut_y0.svg").exists());
    bench.write("f/cut_y0.png", "mine");
    let refused = draw();
    assert_eq!(refused.code, Some(2));
    assert!(refused.stderr.contains("cut_y0.png is not marked"), "{}", refused.stderr);
    assert_eq!(bench.read("f/cut_y0.png"), "mine");
}

/// Whatever does not need the case is checked before it is read.
#[test]
fn outputs_are_checked_before_the_case() {
    let bench = bench();
    let rows = [
        ("--json", "missing/s.json", 1, "missing/s.json: its directory missing"),
        ("--csv", "-", 2, "--csv must name a file, but is `-`"),
        ("--figures", "-", 2, "--figures must name a directory, but is `-`"),
    ];
    for (option, path, code, part) in rows {
        let run = bench.run(&["solve", "none.toml", option, path]);
        assert_eq!(run.code, Some(code), "{option} {path}: {}", run.stderr);
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
    }
}

/// Goal: outputs are compared with the files of a case before its micro model, which would fail.
#[test]
fn files_of_the_case_are_refused_before_it_is_posed() {
    let bench = Bench::new();
    bench.write("case.toml", "[contact_law]\nroughness = \"line.csv\"\n");
    let run = bench.run(&["solve", "case.toml", "--csv", "line.csv"]);
    assert_eq!(run.code, Some(2));
    let expected = "also that of contact_law.roughness.file";
    assert!(run.stderr.contains(expected), "{}", run.stderr);
}

/// A full disk behind standard output does not hide what is doubtful.
#[cfg(target_os = "linux")]
#[test]
fn warnings_are_told_where_the_summary_cannot_be() {
    let bench = bench();
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let slow =
        ["solve", "case.toml", "--set", "wheel.radius_x=1 mm", "--set", "rail.radius_y=1 mm"];
    let output = bench.command(&slow).stdout(full).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(stderr.contains("warning: ") && stderr.contains("standard output"), "{stderr}");
}

#[test]
fn warnings_go_to_standard_error_and_have_codes_in_json() {
    let bench = bench();
    let slow =
        ["solve", "case.toml", "--set", "wheel.radius_x=1 mm", "--set", "rail.radius_y=1 mm"];
    for quiet in [&["--quiet"][..], &["--json", "-"]] {
        let run = bench.run(&[&slow, quiet].concat());
        assert!(run.stderr.contains("warning: "), "{}", run.stderr);
        assert!(!run.stdout.contains("warning: "), "{}", run.stdout);
    }
    let document = bench.run(&[&slow[..], &["--json", "-"]].concat()).stdout;
    let document: Value = serde_json::from_str(&document).unwrap();
    let codes: Vec<&str> = document["warnings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|warning| {
            assert!(warning["text"].is_string() && warning["quantity"].is_string());
            warning["code"].as_str().unwrap()
        })
        .collect();
    assert!(codes.contains(&"beyond-elastic"), "{codes:?}");
}
