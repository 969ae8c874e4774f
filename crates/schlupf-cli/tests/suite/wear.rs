//! `schlupf wear` from the outside: outputs, fields, errors and exit codes.

use crate::support::{Bench, Run};
use serde_json::Value;

/// Full sliding on an ellipse: a = 6 mm, b = 4 mm, p0 = 0.9 GPa, μ = 0.3, ξ = 0.01 at 20 m/s.
const CASE: &str = "title = \"sliding\"\n[kinematics]\nspeed = \"20 m/s\"\ncreepage_x = 0.01\n\
                    [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"4 mm\"\npeak_pressure = \"0.9 GPa\"\n\
                    [friction]\nmodel = \"constant\"\ncoefficient = 0.3\n\
                    [grid]\ncells_x = 12\ncells_y = 12\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench
}

fn run(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["wear", "case.toml"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = run(bench, &[&["--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}: {value}"))
}

#[test]
fn every_output_is_written() {
    let bench = bench();
    let outputs =
        ["--json", "w.json", "--csv", "cells.csv", "--profile", "across.csv", "--figures", "f"];
    let run = run(&bench, &outputs);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert_eq!(bench.list(), ["across.csv", "case.toml", "cells.csv", "f", "w.json"]);
    for part in ["sliding", "fatigue index", "beyond shakedown", "wear, Archard", "converged"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    for name in ["profile", "rate", "shakedown"] {
        assert!(bench.has_figure(&format!("f/wear_{name}")));
    }
    assert!(bench.read("cells.csv").starts_with("# units: m, m, Pa, m/s, 1, kg/m^3"));
    assert_eq!(bench.read("across.csv").lines().count(), 2 + 12);
}

/// Archard's law with the slip speed ξ v0 = 0.2 m/s and Jendel's coefficients: V = k N ξ/H; with a
/// map of one coefficient, of that. FI = μ − k/p0.
#[test]
fn a_map_replaces_the_coefficients() {
    let bench = bench();
    bench.write("map.csv", "slip_speed [m/s],pressure_ratio,coefficient\n0,0,2e-3\n");
    let mapped = document(&bench, &["--set", "damage.wear_map=map.csv"]);
    let load = number(&mapped, "/normal/load");
    let volume = number(&mapped, "/wear/archard_volume");
    assert!((volume / (2e-3 * load * 0.01 / 2.7e9) - 1.0).abs() < 0.01, "{volume}");
    assert_eq!(mapped["laws"]["wear_map"]["coefficients"], serde_json::json!([2e-3]));
    let fatigue = number(&mapped, "/fatigue_index");
    assert!((fatigue - (0.3 - 300e6 / 0.9e9)).abs() < 1e-3, "{fatigue}");
    assert!((number(&mapped, "/shakedown/load_factor") - 3.0).abs() < 1e-9);
    let severe = ["damage.wear_coefficient_mild=2e-3", "damage.wear_coefficient_severe=2e-3"];
    let same = document(&bench, &["--set", severe[0], "--set", severe[1]]);
    assert!((number(&same, "/wear/archard_volume") / volume - 1.0).abs() < 1e-12);
}

/// What is hotter than the limit is told, and the exit code stays that of a result.
#[test]
fn what_melts_is_told() {
    let bench = bench();
    let cold = document(&bench, &[]);
    assert_eq!(cold["melting"]["share"], 0.0);
    let hot = run(&bench, &["--set", "damage.melting_temperature=30 degC"]);
    assert_eq!(hot.code, Some(0));
    assert!(hot.stderr.contains("a surface melts"), "{}", hot.stderr);
    let unheated = document(&bench, &["--set", "heat.model=none"]);
    assert_eq!(unheated["melting"], Value::Null);
    let fast = run(&bench, &["--set", "solver.method=polach", "--json", "w.json"]);
    assert_eq!(fast.code, Some(0), "{}", fast.stderr);
    assert!(fast.stderr.contains("wear and melting are unknown"), "{}", fast.stderr);
    let fast: Value = serde_json::from_str(&bench.read("w.json")).unwrap();
    assert_eq!((&fast["wear"], &fast["cells"]), (&Value::Null, &Value::Null));
    assert!(number(&fast, "/t_gamma/without_spin") > 0.0);
    let springs = [
        "solver.method=fastsim",
        "heat.model=none",
        "layer.thickness=1 mm",
        "layer.shear_modulus=1000 MPa",
        "layer.yield_stress=20 MPa",
    ];
    let set: Vec<&str> = springs.iter().flat_map(|field| ["--set", *field]).collect();
    let fastsim = run(&bench, &set);
    assert!(fastsim.stderr.contains("temperatures and wear are uncertain"), "{}", fastsim.stderr);
    let greased = run(&bench, &["--set", "friction.coefficient=0.075"]);
    assert!(greased.stderr.contains("those of dry steel on steel"), "{}", greased.stderr);
}

/// Files that would have no contents are refused before the work, and one of before stays.
#[test]
fn files_of_cells_need_a_method_with_cells() {
    let bench = bench();
    bench.write("w.csv", "of before");
    for option in ["--csv", "--profile"] {
        let run = run(&bench, &["--set", "solver.method=polach", option, "w.csv"]);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        for part in ["solver.method", "polach", "slip and traction in cells"] {
            assert!(run.stderr.contains(part), "{part:?} is not in {}", run.stderr);
        }
        assert_eq!(bench.read("w.csv"), "of before");
    }
}

/// A map goes with the default case and with a file of `init`; `check` looks at it, too.
#[test]
fn a_map_goes_with_a_file_of_init() {
    let bench = Bench::new();
    bench.write("map.csv", "slip_speed [m/s],pressure_ratio,coefficient\n0,0,2e-3\n");
    assert_eq!(bench.run(&["init"]).code, Some(0));
    let coarse = ["--set", "grid.cells_x=10", "--set", "grid.cells_y=10"];
    let map = ["--set", "damage.wear_map=map.csv"];
    let run = bench.run(&[&["wear", "case.toml"], &coarse[..], &map[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert_eq!(bench.run(&[&["check", "case.toml"], &map[..]].concat()).code, Some(0));
    bench.write("map.csv", "slip_speed [m/s],pressure_ratio,coefficient\n0,0,nan\n");
    let run = bench.run(&[&["check", "case.toml"], &map[..]].concat());
    assert_eq!(run.code, Some(2), "{}", run.stderr);
}

/// What cannot be is refused with its place, and nothing is written.
#[test]
fn what_cannot_be_is_refused() {
    let bench = bench();
    bench.write("map.csv", "slip_speed [m/s],pressure_ratio,coefficient\n0,0,2\n");
    let missing = run(&bench, &["--set", "damage.wear_map=none.csv"]);
    assert_eq!(missing.code, Some(1), "{}", missing.stderr);
    assert!(missing.stderr.contains("readable file, but is \"none.csv\""), "{}", missing.stderr);
    for (arguments, parts) in [
        (vec!["--set", "damage.hardness=-1 GPa"], vec!["damage.hardness"]),
        (vec!["--set", "damage.wear_map=map.csv"], vec!["map.csv:2", "coefficient", "but is 2"]),
        (
            vec!["--set", "damage.wear_map=map.csv", "--set", "damage.wear_coefficient_mild=1e-4"],
            vec!["damage.wear_coefficient_mild", "together with damage.wear_map"],
        ),
        (
            vec!["--set", "damage.crack_t_gamma=[\"0 N\", \"15 N\"]"],
            vec!["damage.crack_damage", "missing"],
        ),
        (
            vec![
                "--set",
                "damage.crack_t_gamma=[\"15 N\", \"0 N\"]",
                "--set",
                "damage.crack_damage=[0.0, 1e-5]",
            ],
            vec!["damage.crack_t_gamma", "ascend"],
        ),
        (vec!["--set", "history.time=[\"0 s\", \"1 ms\"]"], vec!["history"]),
    ] {
        let run = run(&bench, &[&["--json", "w.json"], arguments.as_slice()].concat());
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        for part in parts {
            assert!(run.stderr.contains(part), "{arguments:?}: {part:?} is not in {}", run.stderr);
        }
        assert_eq!(bench.list(), ["case.toml", "map.csv"]);
    }
}
