//! `--threads`: results do not depend on it, to the last bit.

use crate::support::Bench;
use serde_json::Value;

/// Two loads fall into groups of their own.
const DATA: &str = "creepage_x,force_ratio,load [N]\n\
                    5e-4,0.1050,50e3\n2e-3,0.295,50e3\n2e-2,0.361,50e3\n\
                    5e-4,0.0705,80e3\n2e-3,0.217,80e3\n2e-2,0.344,80e3\n";

const CASE: &str = "title = \"small\"\n[kinematics]\ncreepage_x = 0.002\nspin = \"0.1 1/m\"\n\
                    [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"5 mm\"\n\
                    load = \"60 kN\"\n[grid]\ncells_x = 12\ncells_y = 10\n";

/// Without what a clock has measured.
fn without_times(mut document: Value) -> Value {
    match &mut document {
        Value::Object(entries) => {
            entries.retain(|name, _| !name.starts_with("time"));
            for entry in entries.values_mut() {
                *entry = without_times(entry.take());
            }
        }
        Value::Array(entries) => {
            for entry in entries.iter_mut() {
                *entry = without_times(entry.take());
            }
        }
        _ => {}
    }
    document
}

fn is_the_same(arguments: &[&str]) {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench.write("data.csv", DATA);
    let found = ["1", "2", "5"].map(|threads| {
        let all = [arguments, &["--json", "-", "--threads", threads]].concat();
        let run = bench.run(&all);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        without_times(serde_json::from_str(&run.stdout).unwrap())
    });
    assert!(found[0] == found[1] && found[0] == found[2], "{arguments:?}\n{found:#?}");
}

#[test]
fn families_are_the_same_on_any_number_of_threads() {
    let family = ["--creepage-x", "0..0.05", "--over", "kinematics.speed=10 m/s,20 m/s,30 m/s"];
    is_the_same(&[&["curve", "case.toml", "--points", "9"], &family[..]].concat());
}

#[test]
fn fits_are_the_same_on_any_number_of_threads() {
    is_the_same(&["fit", "case.toml", "--data", "data.csv", "--fit", "friction.coefficient"]);
}

#[test]
fn calibrations_are_the_same_on_any_number_of_threads() {
    is_the_same(&["calibrate", "case.toml", "--direct", "--cells", "10"]);
}

#[test]
fn comparisons_are_the_same_on_any_number_of_threads() {
    is_the_same(&["compare", "case.toml"]);
}

#[test]
fn no_threads_are_refused() {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    for number in ["0", "-1", "many"] {
        let run = bench.run(&["solve", "case.toml", &format!("--threads={number}")]);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        assert!(run.stderr.contains("--threads"), "{}", run.stderr);
    }
}
