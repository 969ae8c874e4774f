//! `schlupf compare` and `solver.method` from the outside.

use crate::support::Bench;
use serde_json::Value;

/// A case that takes no time.
const SMALL: &str = "title = \"small\"\n[kinematics]\ncreepage_x = 0.002\nspin = \"0.1 1/m\"\n\
                     [grid]\ncells_x = 8\ncells_y = 6\n";

/// Approximate normal contacts of two profiles stand beside the exact one: their largest pressures
/// are off by a third at most, all forces by a tenth, those of FASTSIM on the exact contact less.
#[test]
fn normal_contacts_of_profiles_are_compared() {
    let bench = Bench::new();
    let case = "[kinematics]\nspeed = \"20 m/s\"\ncreepage_x = 0.002\n\
                [normal]\nmodel = \"wheel-rail\"\nload = \"50 kN\"\n\
                [wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n\
                [friction]\nmodel = \"constant\"\n[grid]\ncells_x = 12\ncells_y = 12\n";
    bench.write("case.toml", case);
    let run = bench.run(&["compare", "case.toml", "--json", "c.json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.contains("p0 (MPa)"), "{}", run.stdout);
    let document: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    let methods = document["methods"].as_array().unwrap();
    let exact = methods[0]["peak_pressure"].as_f64().unwrap();
    let of_profiles: Vec<_> =
        methods.iter().filter(|method| !method["normal_method"].is_null()).collect();
    let names: Vec<_> =
        of_profiles.iter().map(|it| it["normal_method"].as_str().unwrap()).collect();
    assert_eq!(names, ["kik-piotrowski", "ellipse-corrected", "equivalent-ellipse", "analyn"]);
    let force = |method: &Value| method["force"]["x"].as_f64().unwrap();
    assert!((force(&methods[4]) / force(&methods[0]) - 1.0).abs() < 0.02, "{}", methods[4]);
    for method in of_profiles {
        let pressure = method["peak_pressure"].as_f64().unwrap();
        assert!((pressure / exact - 1.0).abs() < 0.35 && pressure != exact, "{method} {exact}");
        assert!(method["approach"].as_f64().unwrap() > 0.0, "{method}");
        assert!((force(method) / force(&methods[0]) - 1.0).abs() < 0.1, "{method}");
    }
}

#[test]
fn all_methods_are_compared() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let outputs = ["--json", "c.json", "--csv", "c.csv", "--figures", "pictures"];
    let run = bench.run(&[&["compare", "case.toml"], &outputs[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let document: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    let methods = document["methods"].as_array().unwrap();
    let names: Vec<_> = methods.iter().map(|method| method["method"].as_str().unwrap()).collect();
    assert_eq!(
        names,
        [
            "full",
            "full",
            "full",
            "table",
            "fastsim",
            "modified-fastsim",
            "polach",
            "shen-hedrick-elkins",
            "kalker-linear"
        ]
    );
    for method in methods {
        let force = method["normalised"]["x"].as_f64().unwrap();
        assert!(force < -0.2 && force > -0.9, "{method}");
        assert!(method["time"].as_f64().unwrap() > 0.0);
        assert!(run.stdout.contains(method["name"].as_str().unwrap()), "{}", run.stdout);
    }
    assert_eq!(bench.read("c.csv").lines().count(), 11);
    assert!(bench.has_figure("pictures/comparison"));
}

/// Rigid bodies are none of the models that every case is solved with.
#[test]
fn the_model_of_the_case_has_a_row() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let files = ["--csv", "c.csv", "--figures", "f"];
    let rigid = ["compare", "case.toml", "--set", "elasticity.model=rigid"];
    let run = bench.run(&[&rigid, &files[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.contains("full, rigid bodies"), "{}", run.stdout);
    let table = bench.read("c.csv");
    assert_eq!(table.lines().filter(|line| line.starts_with("full,")).count(), 4, "{table}");
    assert!(table.contains("\nfull,rigid,"), "{table}");
}

/// The case's own stiffnesses count in its own model only.
#[test]
fn stiffnesses_stay_with_their_model() {
    let bench = Bench::new();
    let force = |elasticity: &str, name: &str| {
        bench.write("case.toml", &format!("{SMALL}[elasticity]\n{elasticity}"));
        let run = bench.run(&["compare", "case.toml", "--json", "-"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let document: Value = serde_json::from_str(&run.stdout).unwrap();
        let methods = document["methods"].as_array().unwrap();
        let found = methods.iter().find(|method| method["elasticity"] == name).unwrap();
        found["force"]["x"].as_f64().unwrap()
    };
    let soft = "model = \"winkler\"\nbedding_x = \"1e12 N/m^3\"\n";
    let plain = "model = \"half-space\"\n";
    assert!(force(soft, "winkler") > 0.5 * force(plain, "winkler"));
    assert_eq!(force(soft, "elastic-layer"), force(plain, "elastic-layer"));
}

/// A slender ellipse is none of those that the layer is calibrated for; all others answer.
#[test]
fn a_method_that_cannot_answer_is_a_row_with_its_reason() {
    let bench = Bench::new();
    let slender = "[normal]\nmodel = \"ellipse\"\nload = \"80 kN\"\nsemi_axis_x = \"12 mm\"\n\
                   semi_axis_y = \"1 mm\"\n";
    bench.write("case.toml", &format!("{SMALL}{slender}"));
    let outputs = ["--json", "c.json", "--csv", "c.csv", "--figures", "pictures"];
    let run = bench.run(&[&["compare", "case.toml"], &outputs[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let document: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    for method in document["methods"].as_array().unwrap() {
        let is_layer = method["elasticity"] == "elastic-layer";
        assert_eq!(method["force"]["x"].is_null(), is_layer, "{method}");
        assert_eq!(method["status"] == "not-available", is_layer, "{method}");
    }
    let reason =
        "full, elastic layer: not available: elasticity.calibration: the patch has a/b = 12";
    assert!(run.stderr.contains(reason), "{}", run.stderr);
    assert!(run.stdout.contains("  not available: elasticity.calibration"), "{}", run.stdout);
    assert!(bench.read("c.csv").contains("full,elastic-layer,,"));
    assert!(bench.path("pictures/comparison.svg").exists());
}

/// A contact that reaches over the edge of its profile is none for any method.
#[test]
fn where_no_method_can_answer_the_command_fails() {
    let bench = Bench::new();
    let distances: Vec<String> =
        (-5..=5).map(|y| format!("{y},{}", 1.5 * f64::from(y * y))).collect();
    bench.write("profile.csv", &format!("y [mm],distance [um]\n{}\n", distances.join("\n")));
    let profile =
        "[normal]\nmodel = \"profile\"\nfile = \"profile.csv\"\nload = \"900 kN\"\ncells = 16\n";
    bench.write("case.toml", &format!("{SMALL}{profile}"));
    let run = bench.run(&["compare", "case.toml", "--json", "c.json"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""), "{}", run.stderr);
    assert!(run.stderr.contains("case.toml:10:8: normal.file"), "{}", run.stderr);
    assert!(run.stderr.contains("reaches the edge"), "{}", run.stderr);
    assert!(!bench.path("c.json").exists());
}

#[test]
fn a_comparison_is_of_steady_rolling() {
    let bench = Bench::new();
    let history = "[history]\ntime = [\"0 s\", \"1 ms\"]\ncreepage_x = [0.0, 0.002]\n";
    bench.write("case.toml", history);
    let run = bench.run(&["compare", "case.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("case.toml:2:8"), "{}", run.stderr);
    assert!(run.stderr.contains("steady rolling"), "{}", run.stderr);
    let run = bench.run(&["solve", "case.toml", "--set", "solver.method=fastsim"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("\"fastsim\" solves steady rolling only"), "{}", run.stderr);
}

/// A method without fields says so and leaves its outputs empty.
#[test]
fn forces_alone_fill_no_tables() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let polach = ["solve", "case.toml", "--set", "solver.method=polach"];
    let outputs = ["--json", "r.json", "--csv", "r.csv", "--vtk", "r.vtk", "--figures", "figures"];
    let run = bench.run(&[&polach[..], &outputs[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    for text in ["--csv: no rows", "--vtk: no cells", "--figures: nothing is drawn"] {
        assert!(run.stderr.contains(text), "{}", run.stderr);
    }
    let result: Value = serde_json::from_str(&bench.read("r.json")).unwrap();
    assert_eq!(result["method"], "polach");
    assert!(result["force"]["moment_z"].is_null() && result["temperature"]["max_rise"].is_null());
    assert!(result["area"]["slip"].is_null() && result["area"]["contact"].is_number());
    assert_eq!(bench.read("r.csv").lines().count(), 2);
    // Nothing but the manifest.
    assert_eq!(std::fs::read_dir(bench.path("figures")).unwrap().count(), 1);
    let run = bench.run(&[&polach[..], &["--final-state", "s.json"]].concat());
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("which has no state"), "{}", run.stderr);
}

/// FASTSIM fills all of them, and curves run through all methods.
#[test]
fn fast_methods_have_curves() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let fastsim = ["solve", "case.toml", "--set", "solver.method=fastsim", "--csv", "r.csv"];
    let run = bench.run(&fastsim);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(bench.read("r.csv").lines().count() > 20);
    assert!(run.stdout.contains("by the fast method \"fastsim\""), "{}", run.stdout);
    let over = "solver.method=fastsim,modified-fastsim,polach,shen-hedrick-elkins,kalker-linear";
    let range = [
        "--creepage-x",
        "0..0.01",
        "--points",
        "5",
        "--json",
        "-",
        "--set",
        "kinematics.spin=0 1/m",
    ];
    let run = bench.run(&[&["curve", "case.toml", "--over", over], &range[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let document: Value = serde_json::from_str(&run.stdout).unwrap();
    let slope = |k: usize| document["curves"][k]["initial_slope"]["kalker"]["x"].as_f64().unwrap();
    // C11 = 4.54 at a/b = 1.33, ν = 0.28 (data/kalker_coefficients.csv, between its lines).
    assert!((slope(0) - 4.54).abs() < 0.05, "{}", slope(0));
    for (k, factor) in [(1, 1.0), (2, 0.7), (3, 1.0), (4, 1.0)] {
        assert!((slope(k) / slope(0) - factor).abs() < 1e-3, "{k}: {}", slope(k));
        assert_eq!(document["curves"][k]["method"], document["over"]["values"][k]);
    }
}
