//! Every case of the gallery is solved, and its results are pinned.
//!
//! `cases/NAME.expected.json` is our own output, a regression file: it says that results have not
//! changed, not that they are right. After a change that is meant, `SCHLUPF_PIN=1 cargo test -p
//! schlupf-cli --test gallery` writes the files anew.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// Results are compared to this part of the largest number beside them.
const TOLERANCE: f64 = 1e-4;

/// What is pinned.
const PINNED: [&str; 9] = [
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
    PINNED.iter().map(|key| ((*key).to_owned(), result[*key].clone())).collect()
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

/// The steady driver and marching give the same results: they solve the same discrete equations.
#[test]
fn marching_ends_where_the_steady_driver_does() {
    let mut found = Vec::new();
    for case in cases() {
        let name = case.file_stem().unwrap().to_string_lossy().into_owned();
        let expected = pinned(&solve(&case, &[]));
        let marched = pinned(&solve(&case, &["--set", "solver.driver=marching"]));
        found.extend(differences("", &marched, &expected).iter().map(|d| format!("{name}{d}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
