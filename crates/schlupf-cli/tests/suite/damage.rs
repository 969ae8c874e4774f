//! `schlupf damage` from the outside: of a table, of a study, outputs, errors and exit codes.

use crate::support::{Bench, Run, TABLES};
use serde_json::Value;

/// A curve with the patch moving over the profile; the third state locks the wheel if `fails`.
fn bench(fails: bool) -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", "[grid]\ncells_x = 10\ncells_y = 10\n");
    let mut states =
        "distance [m],position_y [mm],kinematics.creepage_x,normal.load [kN]\n".to_owned();
    for k in 0..12 {
        let creepage = if fails && k == 2 { 1.5 } else { 5e-4 * f64::from(k) };
        let line = format!("{},{},{creepage},{}\n", 25 * k, k % 5, 70 + 10 * (k % 2));
        states.push_str(&line);
    }
    bench.write("run.csv", &states);
    bench.write("study.toml", "case = \"case.toml\"\n[states]\nfile = \"run.csv\"\n");
    bench
}

fn damage(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["damage"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = damage(bench, &[arguments, &["--json", "-"]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// Columns of a table by name.
fn column(table: &str, name: &str) -> Vec<f64> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    let place = reader.headers().unwrap().iter().position(|head| head == name).unwrap();
    reader.records().map(|row| row.unwrap()[place].parse().unwrap()).collect()
}

/// Energy and Tγ are trapezoids over the table of the sweep, computed here; a study is the same.
#[test]
fn sums_are_those_of_the_table() {
    let bench = bench(false);
    let sweep = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(sweep.code, Some(0), "{}", sweep.stderr);
    let outputs = ["--csv", "profile.csv", "--along", "along.csv", "--figures", "f"];
    let found = document(&bench, &[&["table.csv"][..], &outputs].concat());
    let table = bench.read("table.csv");
    let [power, speed, t_gamma, distance] =
        ["power.friction", "kinematics.speed", "t_gamma.without_spin", "distance"]
            .map(|name| column(&table, name));
    let trapezoid = |value: &dyn Fn(usize) -> f64| -> f64 {
        let pairs = distance.windows(2).enumerate();
        pairs.map(|(k, d)| 0.5 * (d[1] - d[0]) * (value(k) + value(k + 1))).sum()
    };
    let near = |found: &Value, expected: f64| {
        let found = number(found);
        assert!((found - expected).abs() < 1e-9 * expected.abs(), "{found} {expected}");
    };
    near(&found["distance"], 275.0);
    near(&found["energy"], trapezoid(&|k| power[k] / speed[k]));
    near(&found["t_gamma"]["sum"], trapezoid(&|k| t_gamma[k]));
    let [ax, ay] = ["normal.semi_axis_x", "normal.semi_axis_y"].map(|name| column(&table, name));
    let [load, force] = ["normal.load", "force.x"].map(|name| column(&table, name));
    let index = |k: usize| {
        let yielding = 2.0 * std::f64::consts::PI * ax[k] * ay[k] * 300e6 / (3.0 * load[k]);
        force[k].abs() / load[k] - yielding
    };
    let largest = (0..12).map(index).fold(f64::MIN, f64::max);
    let found_index = number(&found["fatigue"]["max"]);
    assert!((found_index - largest).abs() < 1e-6, "{found_index} {largest}");
    // A third of k: a larger index.
    let soft = document(&bench, &["table.csv", "--set", "damage.shear_yield_stress=100 MPa"]);
    assert!(number(&soft["fatigue"]["max"]) > found_index + 0.1);
    assert_eq!(bench.read("along.csv").lines().count(), 14);
    let depths = column(&bench.read("profile.csv"), "wheel_archard");
    assert!(depths.len() > 20 && depths.iter().all(|depth| *depth >= 0.0));
    for name in ["damage_wear", "damage_run", "damage_histograms"] {
        assert!(bench.has_figure(&format!("f/{name}")));
    }
    let study = document(&bench, &["study.toml"]);
    near(&study["energy"], number(&found["energy"]));
    assert_eq!(study["archard"], found["archard"]);
}

/// Along time, the distance is that at the speed of each state.
#[test]
fn a_run_over_time_has_its_distance() {
    let bench = bench(false);
    let states = "time [s],kinematics.speed [m/s],kinematics.creepage_x\n\
                  0,10,0.001\n1,20,0.002\n3,30,0.003\n";
    bench.write("run.csv", states);
    let found = document(&bench, &["study.toml"]);
    // 0.5 s, 1.5 s and 1 s.
    assert!((number(&found["distance"]) - (5.0 + 30.0 + 30.0)).abs() < 1e-9);
    assert!((number(&found["duration"]) - 3.0).abs() < 1e-12);
    let shares = &found["histograms"][0]["shares"];
    let sum: f64 = shares.as_array().unwrap().iter().map(number).sum();
    assert!((sum - 1.0).abs() < 1e-12);
}

#[test]
fn states_without_a_solution_are_left_out_and_told() {
    let bench = bench(true);
    let run = damage(&bench, &["study.toml", "--json", "d.json"]);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    let expected = "1 of the states have not converged or have failed, the first in row 2";
    assert!(run.stderr.contains(expected), "{}", run.stderr);
    assert!(run.stdout.contains("1 states over 25 m are left out"), "{}", run.stdout);
    let found: Value = serde_json::from_str(&bench.read("d.json")).unwrap();
    assert_eq!((&found["status"], &found["states"]), (&"not-converged".into(), &11.into()));
    assert_eq!(found["left_out"]["distance"], 25.0);
    assert_eq!(found["warnings"][0]["code"], "left-out");
}

/// A table keeps the laws of its study's case, wherever that is gone, with the files that it names.
#[test]
fn laws_are_those_of_the_case_behind_a_table() {
    let bench = bench(false);
    let case = bench.read("case.toml");
    let laws = "[friction]\nvariation_file = \"along.csv\"\n[wheel]\nradius_x = \"0.4 m\"\n\
                density = \"7800 kg/m^3\"\n[damage]\nhardness = \"3 GPa\"\n\
                shear_yield_stress = \"200 MPa\"\n";
    bench.write("case.toml", &format!("# a \"worn\" wheel\n{case}{laws}"));
    bench.write("along.csv", "y [mm],factor\n-10,1\n10,1\n");
    for name in TABLES {
        let sweep = bench.run(&["sweep", "study.toml", "--output", name]);
        assert_eq!(sweep.code, Some(0), "{}", sweep.stderr);
    }
    let of_study = document(&bench, &["study.toml"]);
    for name in ["case.toml", "along.csv", "study.toml", "run.csv"] {
        std::fs::remove_file(bench.path(name)).unwrap();
    }
    for name in TABLES {
        let found = document(&bench, &[name]);
        for part in ["laws", "archard", "energy_wear", "fatigue", "warnings"] {
            assert_eq!(found[part], of_study[part], "{name} {part}");
        }
        assert_eq!(found["laws"]["wheel_radius"], 0.4);
        let harder = document(&bench, &[name, "--set", "damage.hardness=6 GPa"]);
        assert_eq!(harder["laws"]["hardness"], 6e9);
        assert_eq!(harder["laws"]["wheel_radius"], 0.4);
        bench.write("other.toml", "[damage]\nhardness = \"2 GPa\"\n");
        let other = document(&bench, &[name, "other.toml"]);
        assert_eq!(other["laws"]["hardness"], 2e9);
        assert_eq!(other["laws"]["wheel_radius"], 0.46);
    }
}

/// Overrides of a study are solved, as in its case; a table that is solved refuses them.
#[test]
fn overrides_count_for_states_that_are_not_solved_yet() {
    let bench = bench(false);
    let sweep = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(sweep.code, Some(0), "{}", sweep.stderr);
    let slow = ["--set", "kinematics.speed=5 m/s", "--set", "friction.model=constant"];
    let overridden = document(&bench, &[&["study.toml"], &slow[..]].concat());
    let case = bench.read("case.toml");
    let own = "[kinematics]\nspeed = \"5 m/s\"\n[friction]\nmodel = \"constant\"\n";
    bench.write("case.toml", &format!("{case}{own}"));
    let written = document(&bench, &["study.toml"]);
    assert_eq!(overridden["energy"], written["energy"]);
    assert_ne!(overridden["energy"], document(&bench, &["table.csv"])["energy"]);
    let refused = damage(&bench, &["study.toml", "--set", "normal.load=20 kN"]);
    assert!(
        refused.stderr.contains("normal.load would be ignored: the states"),
        "{}",
        refused.stderr
    );
    for of in [&["table.csv"][..], &["table.csv", "case.toml"], &["study.toml", "case.toml"]] {
        for set in ["normal.load=20 kN", "kinematics.speed=5 m/s"] {
            let refused = damage(&bench, &[of, &["--set", set]].concat());
            assert_eq!(refused.code, Some(2), "{}", refused.stdout);
            assert!(refused.stderr.contains(" would be ignored: the states"), "{}", refused.stderr);
        }
    }
}

/// Polach's method has no moment: with spin its friction power is unknown, of those states alone.
#[test]
fn states_without_friction_power_are_left_out_and_told() {
    let bench = bench(false);
    bench.write("case.toml", "solver.method = \"polach\"\n");
    let states = "distance [m],kinematics.creepage_x,kinematics.spin [1/m]\n\
                  0,0.001,0\n10,0.001,0.2\n30,0.002,0\n60,1.5,0\n100,0.001,0\n";
    bench.write("run.csv", states);
    let run = damage(&bench, &["study.toml", "--json", "d.json", "--along", "along.csv"]);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    for expected in [
        "1 of the states have no friction power, because the method gives no moment and they have \
         spin, the first in row 1",
        "1 of the states have not converged or have failed, the first in row 3",
    ] {
        assert!(run.stderr.contains(expected), "{}", run.stderr);
    }
    let found: Value = serde_json::from_str(&bench.read("d.json")).unwrap();
    assert_eq!(found["left_out"]["states"], 2);
    // From 5 m to 20 m and from 45 m to 80 m.
    assert_eq!(found["left_out"]["distance"], 50.0);
    assert_eq!(found["states"], 3);
    // The others stay where they are.
    assert_eq!(column(&bench.read("along.csv"), "distance"), [2.5, 32.5, 90.0]);
    bench.write("run.csv", "distance [m],kinematics.spin [1/m]\n0,0.1\n10,0.2\n");
    let none = damage(&bench, &["study.toml"]);
    assert_eq!(none.code, Some(2), "{}", none.stderr);
    let reason = "none of the states of the run has a friction power";
    assert!(none.stderr.contains(reason), "{}", none.stderr);
}

/// Over time, the distance of a state that failed is that at the speed of the one before.
#[test]
fn states_that_fail_keep_their_distance_over_time() {
    let bench = bench(false);
    bench.write("case.toml", "kinematics.speed = \"20 m/s\"\ngrid.cells_x = 10\n");
    let states = "time [s],kinematics.creepage_x\n0,1.5\n1,0.001\n2,1.5\n4,0.002\n";
    bench.write("run.csv", states);
    let run = damage(&bench, &["study.toml", "--json", "d.json", "--along", "along.csv"]);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    let found: Value = serde_json::from_str(&bench.read("d.json")).unwrap();
    assert_eq!(found["left_out"]["distance"], 20.0 * (0.5 + 1.5));
    assert_eq!(column(&bench.read("along.csv"), "distance"), [20.0, 70.0]);
}

#[test]
fn what_is_no_run_is_refused() {
    let bench = bench(false);
    let refused = |arguments: &[&str], part: &str| {
        let run = damage(&bench, arguments);
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
        assert_eq!(run.stdout, "");
    };
    bench.write("none.toml", "[vary]\nkinematics.creepage_x = [0.001, 0.002]\n");
    refused(&["none.toml"], "a run needs states with a column distance or time");
    bench.run(&["sweep", "none.toml", "--output", "none.csv"]);
    refused(&["none.csv"], "a run needs states with a column distance or time");
    refused(&["run.csv"], "no table of a study");
    bench.run(&["sweep", "study.toml", "--output", "half.csv", "--shard", "1/2"]);
    refused(&["half.csv"], "merge all of them before");
    bench.write("run.csv", "distance [m],kinematics.creepage_x\n1,0.001\n1,0.002\n");
    refused(&["study.toml"], "distance must increase from row to row, but is 1 after 1 in row 1");
    bench.write("run.csv", "distance [m],position_y [mm],kinematics.creepage_x\n0,nan,0\n1,2,0\n");
    refused(&["study.toml"], "position_y must be a number, but is none in row 0");
    // Before anything is solved, and about the study that was named.
    bench.write("run.csv", "distance [m],position_y [m],kinematics.creepage_x\n0,0,0\n1,8,0\n");
    let far = "study.toml: of its states: position_y must be between -1 and 1 m, but is 8 in row 1";
    refused(&["study.toml"], far);
    bench.write("run.csv", "distance [m],kinematics.creepage_x\n1,0.001\n");
    refused(&["study.toml"], "at least 2 states, but has 1");
    refused(&["none.csv", "--set", "damage.hardness=-1 GPa"], "damage.hardness must be");
    refused(&["none.csv", "--set", "damage.wear_rate_mild=5 ug"], "must be a mass per energy");
    refused(&["none.csv", "--set", "wheel.radius_x=inf"], "wheel.radius_x");
    bench.write("empty.toml", "[vary]\n");
    let empty = bench.run(&["sweep", "empty.toml", "--output", "e.csv"]);
    assert_eq!(empty.code, Some(2), "{}", empty.stderr);
    assert!(empty.stderr.contains("vary must have fields, but has none"), "{}", empty.stderr);
}
