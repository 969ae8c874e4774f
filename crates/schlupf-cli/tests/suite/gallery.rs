//! Every case of the gallery is solved, and its results are pinned.
//!
//! `cases/NAME.expected.json` is our own output, a regression file: it says that results have not
//! changed, not that they are right. After a change that is meant, `SCHLUPF_PIN=1 cargo test -p
//! schlupf-cli --test suite gallery` rewrites the files.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// Results are compared to this part of the largest number beside them.
const TOLERANCE: f64 = 1e-4;

/// What is pinned.
const PINNED: [&str; 10] = [
    "method",
    "status",
    "normal",
    "kinematics",
    "force",
    "normalised",
    "power",
    "t_gamma",
    "temperature",
    "area",
];

fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut cases: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    cases.sort();
    cases
}

fn solve(case: &Path, options: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_schlupf"))
        .args(["solve", "--json", "-"])
        .arg(case)
        .args(options)
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {message}", case.display());
    serde_json::from_slice(&output.stdout).unwrap()
}

fn pinned(result: &Value) -> Value {
    let mut pinned: Value =
        PINNED.iter().map(|key| ((*key).to_owned(), result[*key].clone())).collect();
    let law = &result["contact_law"];
    // Of one from a roughness, k_c.
    if law["rms_height"].is_number() {
        pinned["contact_law"] =
            serde_json::json!({ "from": law["from"], "stiffness": law["stiffness"] });
    }
    pinned
}

/// Differences between two results, each with its path.
fn differences(path: &str, got: &Value, expected: &Value) -> Vec<String> {
    let (Value::Object(got_fields), Value::Object(fields)) = (got, expected) else {
        return if got == expected {
            vec![]
        } else {
            vec![format!("{path}: {got} ≠ {expected}")]
        };
    };
    let scale = fields.values().filter_map(Value::as_f64).fold(0.0, |s: f64, v| s.max(v.abs()));
    let mut found = Vec::new();
    for (key, value) in fields {
        let path = format!("{path}/{key}");
        let here = got_fields.get(key).unwrap_or(&Value::Null);
        match (here.as_f64(), value.as_f64()) {
            (Some(a), Some(b)) => {
                // Where two places are equally hot, rounding chooses; and sizes of different kind
                // stand side by side, so each number also counts for itself.
                let is_tie = path == "/temperature/y" && (a.abs() - b.abs()).abs() < 1e-9;
                // What the bristles return is a small difference of large numbers.
                let negligible = a.abs().max(b.abs()) < 1e-9 * scale || key == "returned";
                if (a - b).abs() > TOLERANCE * b.abs() && !is_tie && !negligible {
                    found.push(format!("{path}: {a} ≠ {b}"));
                }
            }
            _ => found.extend(differences(&path, here, value)),
        }
    }
    found
}

#[test]
fn the_gallery_gives_its_pinned_results() {
    let mut found = Vec::new();
    for case in cases() {
        let result = pinned(&solve(&case, &[]));
        let file = case.with_extension("expected.json");
        if std::env::var_os("SCHLUPF_PIN").is_some() {
            fs::write(&file, serde_json::to_string_pretty(&result).unwrap() + "\n").unwrap();
        }
        let expected: Value = serde_json::from_slice(&fs::read(&file).unwrap()).unwrap();
        let name = case.file_stem().unwrap().to_string_lossy();
        found.extend(differences("", &result, &expected).iter().map(|d| format!("{name}{d}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Neuhaus and Sextro 2014, Figures 5–7, in shape: with a slip angle Fx is smaller and more of the
/// patch slides; with the paper's heat model the trailing edge is hottest.
#[test]
fn neuhaus_sextro_2014_figures_in_shape() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let pure = solve(&folder.join("neuhaus_sextro_2014.toml"), &[]);
    let combined = solve(&folder.join("neuhaus_sextro_2014_combined.toml"), &[]);
    let number = |result: &Value, path: &str| result.pointer(path).unwrap().as_f64().unwrap();
    let (fx, fx_combined) = (number(&pure, "/force/x"), number(&combined, "/force/x"));
    assert!(fx < 0.0 && fx_combined.abs() < 0.85 * fx.abs(), "{fx} {fx_combined}");
    assert!(number(&combined, "/force/y") > 0.0);
    assert!(number(&combined, "/area/slip") > 1.3 * number(&pure, "/area/slip"));
    assert!(number(&pure, "/area/stick") > 0.3 * number(&pure, "/area/contact"));
    for result in [&pure, &combined] {
        assert!(number(result, "/temperature/x") < -0.99 * 6e-3);
    }
}

/// The cells of the field CSV next to y = 0, from the leading to the trailing edge: column by name.
fn middle_row(case: &Path) -> impl Fn(&str) -> Vec<f64> + use<> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("fields.csv");
    solve(case, &["--csv", &file.to_string_lossy()]);
    let text = fs::read_to_string(file).unwrap();
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let header: Vec<String> = lines.next().unwrap().split(',').map(str::to_owned).collect();
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    let middle = rows.iter().map(|row| row[1]).filter(|y| *y > 0.0).fold(f64::MAX, f64::min);
    let mut cells: Vec<Vec<f64>> =
        rows.into_iter().filter(|row| (row[1] - middle).abs() < 2e-5).collect();
    cells.sort_by(|p, q| q[0].total_cmp(&p[0]));
    move |name| {
        let column = header.iter().position(|h| h == name).unwrap();
        cells.iter().map(|row| row[column]).collect()
    }
}

/// Neuhaus and Sextro 2014, Figures 5 and 7: behind the leading edge the force rises linearly, from
/// a step that the coupling makes; the sliding zone follows the pressure; the friction power is
/// zero in the sticking zone and largest towards the trailing edge.
#[test]
fn neuhaus_sextro_2014_stick_rises_linearly_from_a_step() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let column = middle_row(&folder.join("neuhaus_sextro_2014.toml"));
    let (x, traction) = (column("x"), column("traction_x"));
    let bound: Vec<f64> = column("pressure")
        .iter()
        .zip(column("friction_coefficient"))
        .map(|(p, mu)| mu * p)
        .collect();
    let power = column("friction_power");
    let inside = |low: f64, high: f64| {
        (0..x.len()).filter(|k| (low..high).contains(&x[*k])).collect::<Vec<_>>()
    };
    let stick = inside(0.5e-3, 4.5e-3);
    let (first, last) = (stick[0], stick[stick.len() - 1]);
    let slope = (traction[last] - traction[first]) / (x[last] - x[first]);
    let line = |at: f64| traction[first] + slope * (at - x[first]);
    for &k in &stick {
        assert!((traction[k] - line(x[k])).abs() < 0.05 * traction[last].abs(), "{}", x[k]);
    }
    assert!(line(6e-3) < -0.1 * 0.4e9, "no step: {}", line(6e-3));
    for k in inside(-5.5e-3, -2.5e-3) {
        assert!((traction[k] / bound[k] + 1.0).abs() < 0.01, "{} {}", traction[k], bound[k]);
    }
    let largest = power.iter().copied().fold(0.0, f64::max);
    assert!(stick.iter().all(|k| power[*k] < 0.02 * largest));
    let hottest = power.iter().position(|q| *q == largest).unwrap();
    assert!(x[hottest] < -2e-3);
}

/// What coupling adds: a step of the force at the leading edge, and a stiffer patch.
#[test]
fn coupling_stiffens_the_patch() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let force = |name: &str| solve(&folder.join(name), &[])["force"]["x"].as_f64().unwrap();
    assert!(force("layer_coupled.toml") < 1.3 * force("winkler_uncoupled.toml"));
}

/// Polach 2005, in shape: adhesion that falls with the temperature gives creep curves with a
/// maximum and a falling branch; at higher speeds the maximum comes earlier and is lower, and the
/// branch lies lower and falls more.
#[test]
fn polach_2005_falling_adhesion_in_shape() {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/falling_adhesion.toml");
    let output = Command::new(env!("CARGO_BIN_EXE_schlupf"))
        .args(["curve", "--creepage-x", "0..0.15", "--json", "-"])
        .args(["--over", "kinematics.speed=10 m/s,20 m/s,40 m/s"])
        .arg(&case)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let curves = result["curves"].as_array().unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    // Creepage and height of the maximum, height at 15 %.
    let shapes: Vec<[f64; 3]> = curves
        .iter()
        .map(|curve| {
            let maximum = &curve["maximum"];
            assert_eq!(maximum["saturated"], false);
            let coefficients = curve["points"]["traction_coefficient"].as_array().unwrap();
            let creepages = curve["points"]["creepage_x"].as_array().unwrap();
            let peak = number(&maximum["abscissa"]);
            let beyond = (0..creepages.len()).filter(|k| number(&creepages[*k]) > peak);
            let branch: Vec<f64> = beyond.map(|k| number(&coefficients[k])).collect();
            assert!(branch.len() > 5 && branch.windows(2).all(|pair| pair[1] < pair[0]));
            let last = number(&coefficients[coefficients.len() - 1]);
            [peak, number(&maximum["traction_coefficient"]), last]
        })
        .collect();
    for pair in shapes.windows(2) {
        assert!((0..3).all(|k| pair[1][k] < pair[0][k]), "{shapes:?}");
        assert!(pair[1][1] - pair[1][2] > pair[0][1] - pair[0][2], "{shapes:?}");
    }
    assert!(shapes.iter().all(|shape| shape[2] < 0.85 * shape[1]), "{shapes:?}");
}

/// A wrong number in a pinned file is found.
#[test]
fn the_comparison_can_fail() {
    let expected =
        serde_json::json!({ "force": { "x": 100.0, "y": 1e-12 }, "status": "converged" });
    let mut got = expected.clone();
    assert!(differences("", &got, &expected).is_empty());
    got["force"]["x"] = 100.02.into();
    got["status"] = "not-converged".into();
    assert_eq!(differences("", &got, &expected).len(), 2);
}

/// Ten times the tolerance of the gallery's cases.
const TEN_TOLERANCES: f64 = 1e-5;

/// Results that are compared by these bounds and not by that of the pins: a prescribed force of
/// zero is met to the tolerance of the solver.
const FORCES: [&str; 2] = ["/force/", "/normalised/"];

/// The steady driver and marching give the same results: they solve the same discrete equations.
/// The forces over μ0 N agree to ten times the solver's tolerance.
#[test]
#[ignore = "long: cargo xtask long"]
fn marching_ends_where_the_steady_driver_does() {
    let mut found = Vec::new();
    for case in cases() {
        let name = case.file_stem().unwrap().to_string_lossy().into_owned();
        let steady = solve(&case, &[]);
        if steady["method"] != "full" {
            continue;
        }
        let expected = pinned(&steady);
        let marched = pinned(&solve(&case, &["--set", "solver.driver=marching"]));
        for component in ["x", "y", "moment_z"] {
            let of = |result: &Value| result["normalised"][component].as_f64().unwrap();
            let gap = (of(&marched) - of(&expected)).abs();
            if gap > TEN_TOLERANCES {
                found.push(format!("{name}: normalised {component} differs by {gap:e}"));
            }
        }
        let differences = differences("", &marched, &expected);
        let others = differences.iter().filter(|d| !FORCES.iter().any(|f| d.starts_with(f)));
        found.extend(others.map(|d| format!("{name}{d}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
