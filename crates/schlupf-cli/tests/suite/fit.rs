//! `schlupf fit` as a user runs it.

use crate::support::{Bench, Run};

const CASE: &str = "\
title = \"brushes\"   # soft

[normal]
model = \"ellipse\"
semi_axis_x = \"6 mm\"
semi_axis_y = \"5 mm\"
load = \"60 kN\"

[elasticity]
model = \"rigid\"     # so that everything is known in closed form

[contact_law]
stiffness = \"1e6 1/m\"

[friction]
model = \"constant\"
coefficient = 0.4

[heat]
model = \"none\"

[grid]
cells_x = 20
cells_y = 20
";

const BOTH: &str = "friction.coefficient,contact_law.stiffness";

/// Creepages and F/N of rigid bodies with bristles, μ = 0.3 and k_c = 5e5/m: a point has slid ξ
/// (x_e − x) since it entered, so F = μ ∫ pₙ (1 − e^(−k_c ξ (x_e − x))) dA; integrated with SciPy
/// over the Hertz pressure.
const POINTS: [[f64; 2]; 9] = [
    [2e-5, 0.0154],
    [5e-5, 0.0366],
    [1e-4, 0.0676],
    [2e-4, 0.1165],
    [3.5e-4, 0.1668],
    [6e-4, 0.2155],
    [1e-3, 0.2520],
    [2e-3, 0.2807],
    [5e-3, 0.2948],
];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench.write("data.csv", &data());
    bench
}

fn data() -> String {
    let rows = POINTS.iter().map(|[creepage, ratio]| format!("{creepage},{ratio}\n"));
    let header = "# a = 6 mm, b = 5 mm\ncreepage_x,force_ratio\n".to_owned();
    rows.fold(header, |text, row| text + &row)
}

fn fit(bench: &Bench, parameters: &str, more: &[&str]) -> Run {
    let mut all = vec!["fit", "case.toml", "--data", "data.csv", "--fit", parameters];
    all.extend(more);
    bench.run(&all)
}

/// Independent integration of the same law: the constants come back, and all outputs hold them.
#[test]
fn bristles_on_rigid_bodies_come_back() {
    let bench = bench();
    let outputs = ["--json", "r.json", "--csv", "r.csv", "--write-case", "new.toml"];
    let run = fit(&bench, BOTH, &[&outputs[..], &["--figures", "figures"]].concat());
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert!(run.stdout.contains("r.m.s. residual of F/N"), "{}", run.stdout);
    let result: serde_json::Value = serde_json::from_str(&bench.read("r.json")).unwrap();
    assert_eq!(result["status"], "converged");
    for (k, (name, value)) in
        [("friction.coefficient", 0.3), ("contact_law.stiffness", 5e5)].into_iter().enumerate()
    {
        let found = &result["parameters"][k];
        assert_eq!(found["name"], name);
        let error = found["value"].as_f64().unwrap() / value - 1.0;
        assert!(error.abs() < 0.005, "{found}");
    }
    assert_eq!(result["points"]["fitted"].as_array().unwrap().len(), POINTS.len());
    let table = bench.read("r.csv");
    assert!(table.starts_with("# units: 1, 1, 1/m, m/s, N, x or y, "), "{table}");
    assert_eq!(table.lines().count(), 2 + POINTS.len());
    let new = bench.read("new.toml");
    assert!(new.starts_with("title = \"brushes\"   # soft\n"), "{new}");
    assert!(new.contains("coefficient = 0.") && new.contains("stiffness = \"5"), "{new}");
    assert!(bench.has_figure("figures/fit"));
    // The new case starts where the fit ended.
    let again = bench.run(&["fit", "new.toml", "--data", "data.csv", "--fit", BOTH]);
    assert!(again.stdout.contains("converged, 0 steps"), "{}", again.stdout);
}

#[test]
fn json_on_standard_output_stands_alone() {
    let run = fit(&bench(), "friction.coefficient,contact_law.roughness", &["--json", "-"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let result: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    // k_c = 2 (1 − ν)/(μ0 (2 − ν) γ h), ν = 0.28, γ = 0.45.
    let height = 1.44 / (0.3 * 1.72 * 0.45 * 5e5);
    let found = result["parameters"][1]["value"].as_f64().unwrap();
    assert!((found / height - 1.0).abs() < 0.01, "{found} {height}");
    assert_eq!(result["roughness"]["gamma"], 0.45);
}

/// The gallery's made-up measurement as docs/identification.md fits it, and Polach's method on the
/// same points.
#[test]
fn the_gallery_has_points_to_fit() {
    let bench = Bench::new();
    let file = |name: &str| format!("{}/../../cases/{name}", env!("CARGO_MANIFEST_DIR"));
    let [case, data] = ["falling_adhesion.toml", "falling_adhesion_points.csv"].map(file);
    let fit = |more: &[&str]| {
        let mut all = vec!["fit", &case, "--data", &data, "--json", "-"];
        all.extend(more);
        let run = bench.run(&all);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        serde_json::from_str::<serde_json::Value>(&run.stdout).unwrap()
    };
    let parameters =
        "friction.coefficient,friction.temperature_at_zero_friction,contact_law.stiffness";
    let cells = ["--set", "grid.cells_x=16", "--set", "grid.cells_y=16"];
    let start = ["--set", "friction.coefficient=0.5", "--fit", parameters];
    let found = fit(&[&cells[..], &start].concat());
    for (k, truth) in [0.33, 700.0, 2e5].into_iter().enumerate() {
        let found = &found["parameters"][k];
        let error = (found["value"].as_f64().unwrap() - truth).abs();
        assert!(error <= found["half_width_95"].as_f64().unwrap(), "{found}");
    }
    let polach = [
        "--set",
        "solver.method=polach",
        "--set",
        "friction.model=polach",
        "--set",
        "friction.limit_ratio=0.5",
        "--set",
        "friction.decay=0.6 s/m",
        "--fit",
        "friction.coefficient,friction.limit_ratio,friction.decay,solver.polach_area_slip",
    ];
    let found = fit(&polach);
    assert_eq!(found["parameters"][3]["symbol"], "k_S");
    // Its friction knows the slip speed, not the heat.
    let warnings = found["warnings"].to_string();
    assert!(warnings.contains("not random"), "{warnings}");
}

#[test]
fn a_fit_that_is_cut_short_is_marked() {
    let bench = bench();
    let run = fit(&bench, BOTH, &["--max-steps", "1", "--json", "r.json"]);
    assert_eq!(run.code, Some(3));
    assert!(run.stdout.contains("NOT CONVERGED"), "{}", run.stdout);
    assert!(run.stderr.contains("warning: not converged: after 1 steps"), "{}", run.stderr);
    assert!(bench.read("r.json").contains("\"not-converged\""));
}

#[test]
fn what_the_data_leave_open_is_refused_and_nothing_is_written() {
    let bench = bench();
    bench.write("data.csv", "creepage_x,force_ratio\n1e-6,0.0004\n2e-6,0.0008\n4e-6,0.0016\n");
    let run = fit(&bench, BOTH, &["--json", "r.json"]);
    assert_eq!(run.code, Some(2), "{}", run.stdout);
    let expected = "--data data.csv: friction.coefficient: the data do not determine it";
    assert!(run.stderr.contains(expected), "{}", run.stderr);
    assert!(!run.stderr.contains("are the units right?"), "{}", run.stderr);
    assert_eq!(bench.list(), ["case.toml", "data.csv"]);
    // A load a hundred times too large may be why.
    let load = "creepage_x,force_ratio,load [kN]\n";
    bench.write("data.csv", &format!("{load}1e-6,0.0004,6e3\n2e-6,0.0008,6e3\n4e-6,0.0016,6e3\n"));
    let run = fit(&bench, BOTH, &[]);
    assert_eq!(run.code, Some(2), "{}", run.stdout);
    let help =
        "the data have a load of 6.0000e6 N, the case one of 6.0000e4 N: are the units right?";
    assert!(run.stderr.contains(expected) && run.stderr.contains(help), "{}", run.stderr);
}

/// A load a thousand times that of the case: kN for N, as a rule.
#[test]
fn a_load_far_from_that_of_the_case_is_told() {
    let bench = bench();
    let load = "creepage_x,force_ratio,load [kN]\n".to_owned();
    let rows = POINTS.iter().map(|[creepage, ratio]| format!("{creepage},{ratio},6e4\n"));
    bench.write("data.csv", &rows.fold(load, |text, row| text + &row));
    let run = fit(&bench, BOTH, &["--json", "r.json"]);
    assert!(run.stderr.contains("are the units right?"), "{}", run.stderr);
    assert!(bench.read("r.json").contains("are the units right?"));
}

/// Polach's curve with k_A = k_S = 0.3, fitted with k_A held at 0.15: k_S above k_A is no case.
/// What was found is printed, and no file written: one of an earlier run would look current.
#[test]
fn a_case_that_cannot_be_is_told_with_the_results() {
    let bench = bench();
    let ratio = |creepage: f64| {
        // Gradient of the stress for steel, a = 6 mm, b = 5 mm, μN = 24 kN, about.
        let stress = 0.3 * 350.0 * creepage;
        0.4 * 2.0 / std::f64::consts::PI * (stress / (1.0 + stress * stress) + stress.atan())
    };
    let rows = (1..20).map(|k| 1e-4 * f64::from(k * k)).map(|c| format!("{c},{}\n", ratio(c)));
    let header = "creepage_x,force_ratio\n".to_owned();
    bench.write("data.csv", &rows.fold(header, |text, row| text + &row));
    let outputs = ["--json", "r.json", "--write-case", "new.toml"];
    let polach = [
        "--set",
        "solver.method=polach",
        "--set",
        "solver.polach_area_adhesion=0.15",
        "--set",
        "solver.polach_area_slip=0.1",
    ];
    let run = fit(&bench, "solver.polach_area_slip", &[&polach[..], &outputs].concat());
    assert_eq!(run.code, Some(2), "{}\n{}", run.stdout, run.stderr);
    assert!(run.stderr.contains("new.toml") && run.stderr.contains("area_slip"), "{}", run.stderr);
    assert!(run.stdout.contains("k_S"), "{}", run.stdout);
    assert_eq!(bench.list(), ["case.toml", "data.csv"]);
}

/// Paths of a case are text: from another folder, a file in one that is not UTF-8 cannot be named.
/// This is known before the fit, which would fail for want of steps.
#[cfg(target_os = "linux")]
#[test]
fn a_case_that_cannot_be_written_is_refused_before_the_fit() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let bench = bench();
    let folder = bench.path("").join(OsStr::from_bytes(b"bad\xff"));
    std::fs::create_dir(&folder).unwrap();
    let named = CASE.replace("load = \"60 kN\"", "load = \"60 kN\"\nfile = \"p.csv\"");
    std::fs::write(folder.join("case.toml"), named).unwrap();
    let arguments = ["--data", "data.csv", "--fit", BOTH, "--write-case", "new.toml"];
    let mut command = bench.command(&["fit"]);
    let command = command.arg(folder.join("case.toml")).args(arguments);
    let run = Run::from(command.args(["--json", "r.json"]).output().unwrap());
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""), "{}", run.stderr);
    assert!(run.stderr.contains("normal.file must be a path in UTF-8"), "{}", run.stderr);
    assert!(!bench.path("r.json").exists());
}

/// Where k_c follows from a roughness and μ0 is fitted, the case that is written has the k_c of the
/// fit: solved, it has the fitted forces.
#[test]
fn the_case_that_is_written_is_that_of_the_fit() {
    let bench = bench();
    let rough = bench
        .read("case.toml")
        .replace("stiffness = \"1e6 1/m\"", "roughness = { rms_height = \"9 um\" }");
    bench.write("case.toml", &rough);
    let run =
        fit(&bench, "friction.coefficient", &["--write-case", "new.toml", "--json", "r.json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let fit: serde_json::Value = serde_json::from_str(&bench.read("r.json")).unwrap();
    let solved =
        bench.run(&["solve", "new.toml", "--set", "kinematics.creepage_x=0.001", "--json", "-"]);
    assert_eq!(solved.code, Some(0), "{}", solved.stderr);
    let solved: serde_json::Value = serde_json::from_str(&solved.stdout).unwrap();
    let force =
        -solved["force"]["x"].as_f64().unwrap() / solved["normal"]["load"].as_f64().unwrap();
    let fitted = fit["points"]["fitted"][6].as_f64().unwrap();
    assert!((force / fitted - 1.0).abs() < 1e-4, "{force} {fitted}");
}

#[test]
fn bad_requests_are_refused() {
    let rows: &[(&str, &[&str], i32, &str)] = &[
        ("friction.coeficient", &[], 2, "did you mean `friction.coefficient`?"),
        ("friction.decay", &[], 2, "it is not a constant of the friction law in use"),
        (BOTH, &["--data", "none.csv"], 2, "cannot be used multiple times"),
        (BOTH, &["--gamma", "0"], 2, "between 0.01 and 10"),
        (BOTH, &["--max-steps", "0"], 2, "--max-steps"),
        (BOTH, &["--csv", "data.csv"], 2, "--csv must write files of its own"),
        (BOTH, &["--write-case", "case.toml"], 2, "also the case file"),
        (BOTH, &["--set", "friction.coefficient=5"], 2, "must start a fit between"),
    ];
    for (parameters, more, code, part) in rows {
        let bench = bench();
        let run = fit(&bench, parameters, more);
        assert_eq!(run.code, Some(*code), "{parameters} {more:?}: {}", run.stderr);
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
        assert_eq!(bench.list(), ["case.toml", "data.csv"]);
    }
    let bench = bench();
    let run = bench.run(&["fit", "case.toml", "--data", "none.csv", "--fit", BOTH]);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    bench.write("data.csv", "creepage_x,force_ratio\n0.001,21000\n");
    let run = fit(&bench, BOTH, &[]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("data.csv:2:1: force_ratio must be"), "{}", run.stderr);
    assert!(run.stderr.contains("neither in N nor in per cent"), "{}", run.stderr);
}

/// Forces that a fit would ignore are refused with their place: those of Polach's method, and those
/// on a wheel with two profiles; without them both are fitted.
#[test]
fn forces_that_a_fit_does_not_hold_are_refused() {
    let bench = bench();
    let polach = "solver.method=polach";
    for (field, value) in [("force_y", "0 N"), ("force_x", "-3 kN"), ("moment_z", "0 N m")] {
        let force = format!("kinematics.{field}={value}");
        let set = ["--set", polach, "--set", "elasticity.model=", "--set", &force];
        let run = fit(&bench, "friction.coefficient", &set);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        let place = format!("--set {force}: kinematics.{field}: a fit of Polach's method needs");
        assert!(run.stderr.contains(&place), "{}", run.stderr);
    }
    let wheel =
        CASE.replace("model = \"ellipse\"", "model = \"wheel-rail\"").replace("semi_axis", "# ")
            + "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n\
           [kinematics]\ntraction_coefficient = 0.05\n";
    bench.write("case.toml", &wheel);
    let run = fit(&bench, "friction.coefficient", &[]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    let told = "kinematics.traction_coefficient: a fit with normal.model = \"wheel-rail\"";
    assert!(run.stderr.contains("case.toml:") && run.stderr.contains(told), "{}", run.stderr);
    let given = ["--set", "kinematics.traction_coefficient="];
    let run = fit(&bench, "friction.coefficient", &given);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}
