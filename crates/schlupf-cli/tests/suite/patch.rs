//! `schlupf patch` from the outside: every normal model, outputs, errors and exit codes.

use std::f64::consts::PI;

use crate::support::Bench;
use serde_json::Value;

/// A file of the gallery.
fn gallery(name: &str) -> String {
    format!("{}/../../cases/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = bench.run(&[&["patch", "--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, part: f64) {
    assert!((found - expected).abs() <= part * expected.abs(), "{found} is not {expected}");
}

/// Hertz 1882: A = πab, p0 = 3N/2A, a mean of 2p0/3; the cells carry the load.
#[test]
fn a_patch_is_that_of_hertz() {
    let bench = Bench::new();
    let options = ["--set", "grid.cells_x=40", "--set", "grid.cells_y=40"];
    let result = document(&bench, &options);
    let contact = &result["contacts"][0];
    let normal = &contact["normal"];
    let area = PI * number(&normal["semi_axis_x"]) * number(&normal["semi_axis_y"]);
    assert_close(number(&contact["area"]), area, 1e-9);
    let [load, peak] = ["load", "peak_pressure"].map(|name| number(&normal[name]));
    assert_close(peak, 1.5 * load / area, 1e-9);
    assert_close(number(&contact["mean_pressure"]), peak / 1.5, 1e-9);
    let column = |name: &str| result["cells"][name].as_array().unwrap();
    assert_eq!(column("pressure").len() as f64, number(&contact["cells"]));
    let whole = 4.0 * area / PI / 1600.0;
    let carried = column("pressure").iter().map(|pressure| whole * number(pressure)).sum();
    assert_close(carried, load, 1e-9);
    let covered = column("covered").iter().map(|covered| whole * number(covered)).sum();
    assert_close(covered, area, 1e-9);
}

/// Every normal model: the contacts are those of the solution, which is pinned.
#[test]
fn contacts_are_those_of_the_solution() {
    let bench = Bench::new();
    let cases = [
        ("steel_wheel_braking", 1),
        ("stresses_below", 1),
        ("pressure_table", 1),
        ("worn_profile", 1),
        ("two_point_contact", 1),
        ("measured_surface", 1),
        ("braking_from_rolling", 1),
        ("wheel_on_rail", 1),
    ];
    for (name, count) in cases {
        let result = document(&bench, &[&gallery(&format!("{name}.toml"))]);
        let expected = std::fs::read_to_string(gallery(&format!("{name}.expected.json"))).unwrap();
        let expected: Value = serde_json::from_str(&expected).unwrap();
        let contacts = result["contacts"].as_array().unwrap();
        assert_eq!(contacts.len(), count, "{name}");
        for (k, contact) in contacts.iter().enumerate() {
            let solved = expected.get("contacts").map_or(&expected, |solved| &solved[k]);
            for part in ["load", "semi_axis_x", "semi_axis_y", "peak_pressure"] {
                let found = number(&contact["normal"][part]);
                assert_close(found, number(&solved["normal"][part]), 1e-6);
            }
        }
        let area = number(&contacts[0]["area"]);
        assert_close(area, number(&expected["area"]["contact"]), 1e-6);
    }
}

/// Between tread and flange root both carry: each contact has its cells, in its own frame.
#[test]
fn a_wheel_has_all_its_contacts() {
    let bench = Bench::new();
    let case = gallery("wheel_on_rail.toml");
    let apart = [
        "wheelset.lateral_position=5 mm",
        "wheelset.side=left",
        "wheelset.yaw_angle=0 mrad",
        "normal.join_distance=1 mm",
        "normal.join_angle=0.01 rad",
        "normal.load=10 kN",
    ];
    let set = apart.iter().flat_map(|field| ["--set", *field]);
    let moved: Vec<&str> = [case.as_str()].into_iter().chain(set).collect();
    let arguments = ["--csv", "cells.csv", "--figures", "figures"];
    let result = document(&bench, &[&moved[..], &arguments].concat());
    let contacts = result["contacts"].as_array().unwrap();
    assert_eq!(contacts.len(), 2, "{contacts:?}");
    let [one, two] = [0, 1].map(|k| number(&contacts[k]["position"]["y"]));
    assert!((one - two).abs() > 4e-3, "{contacts:?}");
    let cells: f64 = contacts.iter().map(|contact| number(&contact["cells"])).sum();
    let table = bench.read("cells.csv");
    let mut lines = table.lines().skip(1);
    assert_eq!(lines.next(), Some("contact,x,y,covered,pressure"));
    assert_eq!(lines.count() as f64, cells);
    let drawing = bench.read("figures/pressure_across.svg");
    assert!(drawing.contains("contact 1") && drawing.contains("contact 2"));
    let run = bench.run(&[&["patch"], &moved[..]].concat());
    for part in ["contact 2, angle", "mean pressure", "in the track", "converged"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
}

#[test]
fn bad_input_is_reported() {
    let bench = Bench::new();
    let run = bench.run(&["patch", "--set", "normal.load=-1 kN"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("--set normal.load=-1 kN: normal.load must be"), "{}", run.stderr);
    let run = bench.run(&["patch", "--set", "normal.load=90 MN"]);
    assert!(run.stderr.contains("warning"), "{run:?}");
}
