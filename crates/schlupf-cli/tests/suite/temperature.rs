//! `schlupf temperature` from the outside: outputs, places, errors and exit codes.

use crate::support::{Bench, Run};
use serde_json::Value;

/// A hot wheel that brakes on a cold rail.
const HOT: &str = "title = \"hot\"\n[kinematics]\ncreepage_x = 0.02\n\
                   [wheel]\nbulk_temperature = \"100 degC\"\n[rail]\nbulk_temperature = \"0 degC\"\n\
                   [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"5 mm\"\nload = \"60 kN\"\n\
                   [grid]\ncells_x = 12\ncells_y = 9\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", HOT);
    bench
}

fn run(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["temperature", "case.toml"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = run(bench, &[&["--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn column(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn every_output_is_written() {
    let bench = bench();
    let run = run(&bench, &["--json", "t.json", "--csv", "t.csv", "--figures", "in/here"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert_eq!(bench.list(), ["case.toml", "in", "t.csv", "t.json"]);
    for part in ["hot", "below x = ", "depth (mm)", "on the surface along y = 0 mm", "converged"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    assert!(bench.has_figure("in/here/temperature"));
    let table = bench.read("t.csv");
    assert_eq!(table.lines().nth(1), Some("line,x,y,depth,temperature_wheel,temperature_rail"));
    assert_eq!(table.lines().filter(|line| line.starts_with("profile,")).count(), 201);
    let document: Value = serde_json::from_str(&bench.read("t.json")).unwrap();
    assert_eq!(document["status"], "converged");
    assert_eq!(document["rows"].as_array().unwrap().len(), 3);
}

/// Without options the profile is below the hottest point and begins with its surface temperatures,
/// to the error of the grid; it ends at the bulk temperatures, and so does the row ahead of the
/// contact.
#[test]
fn the_hottest_point_is_the_one_of_the_result() {
    let bench = bench();
    let document = document(&bench, &[]);
    let solved = bench.run(&["solve", "case.toml", "--json", "-"]);
    let solved: Value = serde_json::from_str(&solved.stdout).unwrap();
    let hottest = &solved["temperature"];
    assert_eq!(document["point"]["x"], hottest["x"]);
    let number = |value: &Value| value.as_f64().unwrap();
    for (side, largest, bulk) in [("wheel", "max_wheel", 100.0), ("rail", "max_rail", 0.0)] {
        let profile = column(&document["profile"][side]);
        assert!((profile[0] - number(&hottest[largest])).abs() < 2.0, "{profile:?}");
        assert!((profile.last().unwrap() - bulk).abs() < 0.1, "{profile:?}");
        let row = column(&document["rows"][0][side]);
        assert_eq!(*row.last().unwrap(), bulk);
    }
}

/// Where nothing is hotter than the rest the profile is in the middle row: without a heat model,
/// and without sliding.
#[test]
fn a_contact_of_one_temperature_has_a_profile_too() {
    // The wheel's surface passes at (1 − ξ) v0; both meet at the mean weighted by the roots of
    // speed.
    let met = |creepage: f64| 100.0 * (1.0 - creepage).sqrt() / (1.0 + (1.0 - creepage).sqrt());
    for (set, creepage) in [("heat.model=none", 0.02), ("kinematics.creepage_x=0", 0.0)] {
        let document = document(&bench(), &["--set", set]);
        assert!(document["point"]["y"].as_f64().unwrap().abs() < 1e-9, "{set}");
        let wheel = column(&document["profile"]["wheel"]);
        assert!((wheel[0] - met(creepage)).abs() < 1e-6, "{set}: {}", wheel[0]);
    }
    let cold = ["--set", "heat.model=none", "--set", "wheel.bulk_temperature=0 degC"];
    let document = document(&bench(), &cold);
    assert!(column(&document["rows"][0]["wheel"]).iter().all(|t| *t == 0.0));
}

#[test]
fn places_depths_and_wakes_are_taken() {
    let bench = bench();
    let wanted = ["--x", "-3 mm", "--y", "1 mm", "--depth", "0.1..0.2 mm", "--wake", "5 cm"];
    let document = document(&bench, &[&wanted[..], &["--points", "11"]].concat());
    assert_eq!(
        (&document["point"]["x"], &document["point"]["y"]),
        (&(-0.003).into(), &0.001.into())
    );
    let depth = column(&document["profile"]["depth"]);
    assert_eq!((depth.len(), depth[0], depth[10]), (11, 0.1e-3, 0.2e-3));
    let x = column(&document["rows"][0]["x"]);
    let exit = document["contact"]["trailing_edge"].as_f64().unwrap();
    assert!((x[0] - (exit - 0.05)).abs() < 1e-12, "{} {exit}", x[0]);
    // A point in the wake beyond the given length is still on its row.
    let far = ["--x", "-80 mm", "--wake", "1 mm", "--points", "5"];
    let bench = self::bench();
    let document = self::document(&bench, &far);
    assert!(column(&document["rows"][0]["x"])[0] <= -0.08 + 1e-12);
}

#[test]
fn depths_are_each_given() {
    let document = document(&bench(), &["--depth", "0,0.1,2 mm"]);
    assert_eq!(column(&document["profile"]["depth"]), [0.0, 1e-4, 2e-3]);
}

#[test]
fn the_heat_model_of_the_paper_is_mentioned() {
    let document = document(&bench(), &["--set", "heat.model=constant-source"]);
    let warning = document["warnings"][0]["text"].as_str().unwrap();
    assert!(warning.starts_with("heat.model: below the surface"), "{warning}");
}

#[test]
fn what_did_not_converge_is_written_and_marked() {
    let bench = bench();
    let one_step = ["--set", "solver.driver=marching", "--set", "solver.max_steps=1"];
    let run = run(&bench, &[&["--json", "t.json", "--figures", "f"], &one_step[..]].concat());
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    assert!(run.stderr.contains("warning: not converged"), "{}", run.stderr);
    assert!(run.stdout.contains("NOT CONVERGED"), "{}", run.stdout);
    assert!(bench.read("t.json").contains("\"status\": \"not-converged\""));
    assert!(bench.read("f/temperature.svg").contains("not converged"));
}

/// Arguments after `temperature case.toml`, parts of the report.
const BAD: &[(&[&str], &[&str])] = &[
    (&["--x", "3"], &["--x 3: --x must be a length", "the unit is missing"]),
    (&["--y", "1 kN"], &["--y 1 kN: --y must be a length", "`kN`"]),
    (&["--y", "7 mm"], &["--y must lie in the contact, between -5 and 5 mm, but is 7 mm"]),
    (
        &["--x", "7 mm"],
        &["--x must not lie ahead of the contact, which begins at x = 5.", "y = 0 mm, but is 7 mm"],
    ),
    (&["--depth", "2 mm"], &["--depth must be a range, such as \"0..2 mm\",", "\"2 mm\""]),
    (&["--depth", "2,1 mm"], &["must be larger than the one before"]),
    (&["--depth", "-1mm..1mm"], &["the start of the range must be between 0 and 1000 m"]),
    (&["--depth", "2mm..1mm"], &["must be larger than its start, but is 1e-3 m after 2e-3 m"]),
    (&["--depth", "0..2"], &["the unit is missing"]),
    (&["--wake", "-1 mm"], &["--wake must be between 0 and 1000 m", "\"-1 mm\""]),
    (&["--wake", "nan m"], &["--wake must be between", "nan m"]),
    (&["--points", "1"], &["--points must be a whole number between 2 and 10000"]),
    (&["--csv", "case.toml"], &["is also the case file"]),
];

#[test]
fn bad_input_is_reported_and_nothing_is_written() {
    for (arguments, parts) in BAD {
        let bench = bench();
        let run = run(&bench, &[&["--json", "t.json", "--figures", "f"], *arguments].concat());
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        assert_eq!(run.stdout, "");
        for part in *parts {
            assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
        }
        assert_eq!(bench.list(), ["case.toml"]);
    }
}

#[test]
fn a_history_has_no_wake() {
    let bench = bench();
    bench.write("case.toml", "[history]\ntime = [\"0 s\", \"1 ms\"]\ncreepage_x = [0.0, 0.001]\n");
    let run = run(&bench, &[]);
    assert_eq!(run.code, Some(2));
    for part in ["case.toml:2:8: history.time: temperatures below the surface", "^^^"] {
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
    }
}
