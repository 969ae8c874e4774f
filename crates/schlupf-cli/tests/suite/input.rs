//! Where input comes from, and what is assumed where it is silent.

use std::process::Stdio;

use crate::support::{Bench, Run};

const CHEAP: [&str; 4] = ["--set", "grid.cells_x=8", "--set", "grid.cells_y=8"];

#[test]
fn a_case_comes_from_standard_input() {
    let bench = Bench::new();
    bench.write("in.toml", "title = \"piped\"\n[kinematics]\ncreepage_x = 0.002\n");
    let solve = |case: &str| {
        let mut command = bench.command(&[&["solve", case][..], &CHEAP].concat());
        command.stdin(std::fs::File::open(bench.path("in.toml")).unwrap());
        Run::from(command.output().unwrap())
    };
    let (piped, named) = (solve("-"), solve("in.toml"));
    assert_eq!(piped.code, Some(0), "{}", piped.stderr);
    assert!(piped.stdout.starts_with("piped\n") && piped.stdout == named.stdout);
    bench.write("in.toml", "[kinematics]\nspeed = 3\n");
    let wrong = solve("-");
    assert_eq!(wrong.code, Some(2));
    assert!(wrong.stderr.contains("standard input:2:9: kinematics.speed"), "{}", wrong.stderr);
}

/// One exit code, wherever the file is named.
#[test]
fn a_missing_file_is_one_of_the_file_system() {
    let bench = Bench::new();
    let case = |name: &str, section: &str, more: &str| {
        bench.write(name, &format!("[{section}]\n{more}file = \"no.csv\"\n"));
    };
    case("table.toml", "normal", "model = \"tabulated\"\n");
    case("rough.toml", "contact_law.roughness", "");
    case("history.toml", "history", "");
    for arguments in [
        &["solve", "no.toml"][..],
        &["solve", "table.toml"],
        &["solve", "rough.toml"],
        &["solve", "history.toml"],
        &["check", "table.toml"],
        &["curve", "table.toml", "--creepage-x", "0..0.01"],
        &["fit", "--data", "no.csv", "--fit", "friction.coefficient"],
        &["roughness", "no.csv"],
        &["calibrate", "--displacements", "no.csv"],
        &["solve", "--initial-state", "no.json"],
    ] {
        let run = bench.run(arguments);
        assert_eq!(run.code, Some(1), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains("No such file"), "{arguments:?}: {}", run.stderr);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn files_without_end_are_read_up_to_a_size() {
    let bench = Bench::new();
    let run = bench.run(&["solve", "/dev/zero"]);
    assert_eq!(run.code, Some(1));
    assert!(run.stderr.contains("larger than 4 MiB"), "{}", run.stderr);
    let mut endless = bench.command(&["check", "-"]);
    endless.stdin(std::fs::File::open("/dev/zero").unwrap()).stdout(Stdio::null());
    let run = Run::from(endless.output().unwrap());
    assert!(run.stderr.contains("standard input: the case file cannot be read"), "{}", run.stderr);
}

#[test]
fn an_ellipse_needs_a_load_or_a_pressure() {
    let bench = Bench::new();
    let ellipse = "[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"5 mm\"\n";
    bench.write("case.toml", ellipse);
    let run = bench.run(&["check", "case.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("case.toml:2:9: normal.load is missing"), "{}", run.stderr);
    for given in ["load = \"80 kN\"", "peak_pressure = \"1 GPa\""] {
        bench.write("case.toml", &format!("{ellipse}{given}\n"));
        assert_eq!(bench.run(&["check", "case.toml"]).code, Some(0), "{given}");
    }
}

#[test]
fn what_is_assumed_and_what_has_an_effect_is_told() {
    let bench = Bench::new();
    bench.write("empty.toml", "# nothing yet\n");
    let run = bench.run(&["check", "empty.toml"]);
    assert_eq!(run.code, Some(0));
    assert!(run.stderr.contains("the case gives no fields"), "{}", run.stderr);
    assert!(!run.stdout.contains("contact_law.roughness"), "{}", run.stdout);
    bench.write("rough.toml", "[contact_law.roughness]\nrms_height = \"1 um\"\n");
    let run = bench.run(&["check", "rough.toml"]);
    assert!(run.stdout.contains("contact_law.roughness.slope_factor"), "{}", run.stdout);
    assert!(!run.stderr.contains("gives no fields"));
}

/// The points of a profile may be equidistant without saying so.
#[test]
fn a_profile_of_heights_alone_has_its_spacing_beside_it() {
    let bench = Bench::new();
    let heights = |k: i32| 0.4 * f64::from(k * k % 37) / 37.0;
    let with = |line: fn(i32, f64) -> String| -> String {
        (0..128).map(|k| line(k, heights(k))).collect()
    };
    let bare = with(|_, height| format!("{height}\n"));
    let placed = with(|k, height| format!("{},{height}\n", 2 * k));
    bench.write("bare.csv", &format!("height [um]\n{bare}"));
    bench.write("placed.csv", &format!("x [um],height [um]\n{placed}"));
    let surface = |name: &str, more: &[&str]| {
        let run = bench.run(&[&["roughness", name, "--json", "-"][..], more].concat());
        assert!(run.code == Some(0), "{name}: {}", run.stderr);
        let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        ["root_mean_square_height", "root_mean_square_gradient", "spacing_x"]
            .map(|key| document["surface"][key].as_f64().unwrap())
    };
    let (bare, placed) = (surface("bare.csv", &["--spacing", "2 um"]), surface("placed.csv", &[]));
    for (one, other) in bare.into_iter().zip(placed) {
        assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
    }
    let run = bench.run(&["roughness", "bare.csv"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("--spacing must be given"), "{}", run.stderr);
}

/// An error shows its line, but not one that fills the screen.
#[test]
fn long_lines_are_not_quoted() {
    let bench = Bench::new();
    bench.write("case.toml", &format!("[normal]\nload = \"{}\"\n", "x".repeat(400_000)));
    let run = bench.run(&["check", "case.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("case.toml:2:8: normal.load must be a force"));
    assert!(run.stderr.len() < 500, "{}", run.stderr.len());
    bench.write("case.toml", "[normal]\nload = \"x\"\n");
    assert!(bench.run(&["check", "case.toml"]).stderr.contains("load = \"x\""));
}

/// A number in another unit than its bounds is told in theirs, too.
#[test]
fn values_beyond_their_bounds_are_told_in_their_unit() {
    let run = Bench::new().run(&["check", "--set", "kinematics.yaw_angle=100 deg"]);
    let part = "below 1.5708 rad, but is \"100 deg\": that is 1.74533 rad";
    assert!(run.stderr.contains(part), "{}", run.stderr);
    let run = Bench::new().run(&["check", "--set", "kinematics.yaw_angle=2 rad"]);
    assert!(run.stderr.trim_end().ends_with("but is \"2 rad\""), "{}", run.stderr);
}

/// Every method and the check tell a pressure that no body bears.
#[test]
fn pressures_beyond_elasticity_are_told_by_every_method() {
    let bench = Bench::new();
    bench.write("case.toml", "[normal]\nload = \"80 MN\"\n[grid]\ncells_x = 10\ncells_y = 10\n");
    let methods = ["full", "kalker-linear", "shen-hedrick-elkins", "polach", "fastsim"];
    let others = ["modified-fastsim", "table"];
    for method in methods.into_iter().chain(others) {
        let set = format!("solver.method={method}");
        for command in ["solve", "check"] {
            let run = bench.run(&[command, "case.toml", "--set", &set]);
            assert_eq!(run.code, Some(0), "{}", run.stderr);
            let told = run.stderr.matches("beyond elasticity with small strains").count();
            assert_eq!(told, 1, "{command} {method}: {}", run.stderr);
        }
    }
}

/// Without heat there are no temperatures to print, and a method is not warned of for
/// being what was asked for.
#[test]
fn without_heat_no_temperatures_are_printed() {
    let bench = Bench::new();
    bench.write(
        "case.toml",
        "[grid]\ncells_x = 10\ncells_y = 10\n[kinematics]\ncreepage_x = 0.002\n",
    );
    for (set, heats) in [("heat.model=none", false), ("heat.model=duhamel", true)] {
        let run = bench.run(&["solve", "case.toml", "--set", set]);
        for word in ["largest temp. rise", "into the rail", "°C"] {
            assert_eq!(run.stdout.contains(word), heats, "{set}: {}", run.stdout);
        }
        assert!(run.stdout.contains("% slides"), "{}", run.stdout);
    }
    let run = bench.run(&["solve", "case.toml", "--set", "solver.method=kalker-linear"]);
    assert_eq!(run.stderr, "");
}
