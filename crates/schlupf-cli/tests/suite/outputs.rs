//! What all commands do with figures of earlier runs and with warnings.

use crate::support::Bench;
use serde_json::Value;

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
    assert!(bench.has_figure("f/map_temperature"));
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
        assert!(run.stderr.contains(&format!("{name} is none that schlupf-figures.json lists")));
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
    assert!(refused.stderr.contains("history.png is none that"), "{}", refused.stderr);
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
    assert!(refused.stderr.contains("cut_y0.png is none that"), "{}", refused.stderr);
    assert_eq!(bench.read("f/cut_y0.png"), "mine");
}

/// Whatever does not need the case is checked before it is read.
#[test]
fn outputs_are_checked_before_the_case() {
    let bench = bench();
    bench.write("file", "mine");
    let rows = [
        ("--json", "file/s.json", 1, "file: not a directory"),
        ("--csv", "-", 2, "--csv must name a file, but is `-`"),
        ("--figures", "-", 2, "--figures must name a directory, but is `-`"),
    ];
    for (option, path, code, part) in rows {
        let run = bench.run(&["solve", "none.toml", option, path]);
        assert_eq!(run.code, Some(code), "{option} {path}: {}", run.stderr);
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
    }
}

/// What was drawn is what the manifest lists, as it was drawn: not what looks like it.
#[test]
fn only_figures_of_the_manifest_are_ours() {
    let bench = bench();
    let draw = |folder: &str, more: &[&str]| {
        bench.run(&[&["solve", "case.toml", "--quiet", "--figures", folder], more].concat())
    };
    assert_eq!(draw("f", &[]).code, Some(0));
    let manifest = bench.read("f/schlupf-figures.json");
    assert!(manifest.contains("\"map_temperature.svg\""), "{manifest}");
    // A copy elsewhere is its owner's.
    std::fs::create_dir(bench.path("g")).unwrap();
    std::fs::copy(bench.path("f/cut_y0.svg"), bench.path("g/cut_y0.svg")).unwrap();
    let refused = draw("g", &[]);
    assert_eq!(refused.code, Some(2), "{}", refused.stderr);
    assert!(refused.stderr.contains("cut_y0.svg is none that"), "{}", refused.stderr);
    // So is one that was changed: it is neither written over nor removed.
    let changed = bench.read("f/map_temperature.svg") + "<!-- mine -->";
    bench.write("f/map_temperature.svg", &changed);
    assert_eq!(draw("f", &[]).code, Some(2));
    let cold = draw("f", &["--set", "heat.model=none"]);
    assert_eq!(cold.code, Some(2), "{}", cold.stderr);
    assert_eq!(bench.read("f/map_temperature.svg"), changed);
    // A file of the manifest's name that is none.
    bench.write("f/schlupf-figures.json", "mine");
    let refused = draw("f", &[]);
    assert!(refused.stderr.contains("schlupf-figures.json: it is no manifest of figures"));
    assert_eq!(bench.read("f/schlupf-figures.json"), "mine");
}

/// Folders of all outputs are made, on every command, and go again where nothing is written.
#[test]
fn folders_are_made() {
    let bench = bench();
    let outputs = ["--json", "a/b/s.json", "--csv", "a/c/s.csv", "--figures", "d/e"];
    let run = bench.run(&[&["solve", "case.toml", "--quiet"][..], &outputs].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(["a/b/s.json", "a/c/s.csv", "d/e/cut_y0.svg"].iter().all(|p| bench.path(p).exists()));
    assert_eq!(bench.run(&["init", "new/case.toml"]).code, Some(0));
    bench.write(
        "study.toml",
        "case = \"case.toml\"\n[vary]\n\"kinematics.speed\" = [\"10 m/s\", \"20 m/s\"]\n",
    );
    for shard in ["1/2", "2/2"] {
        let output = format!("s/{}.csv", &shard[..1]);
        let run = bench.run(&["sweep", "study.toml", "--output", &output, "--shard", shard]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
    }
    let merged = bench.run(&["merge", "s/1.csv", "s/2.csv", "--output", "m/m.csv"]);
    assert_eq!(merged.code, Some(0), "{}", merged.stderr);
    let before = bench.list();
    let failed = ["solve", "case.toml", "--set", "normal.load=-1 N", "--json", "x/y/s.json"];
    assert_eq!(bench.run(&failed).code, Some(2));
    let unwritten =
        ["compare", "case.toml", "--set", "kinematics.speed=0 m/s", "--json", "x/s.json"];
    assert_eq!(bench.run(&unwritten).code, Some(2));
    assert_eq!(bench.list(), before);
}

/// A place where no file can be made is told before the case is read.
#[cfg(target_os = "linux")]
#[test]
fn places_without_files_are_refused_first() {
    let bench = bench();
    for arguments in [
        &["solve", "none.toml", "--json", "/proc/s.json"][..],
        &["table", "--output", "/proc/new/t.npz"],
        &["sweep", "none.toml", "--output", "/proc/s.csv"],
    ] {
        let run = bench.run(arguments);
        assert_eq!(run.code, Some(1), "{}", run.stderr);
        assert!(run.stderr.contains("no file can be made in /proc"), "{}", run.stderr);
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
