//! `schlupf roughness` and `[contact_law.roughness]` from the outside: outputs, errors and exit
//! codes.

use std::path::Path;

use crate::support::{Bench, Run};
use serde_json::Value;

/// A surface that is solved quickly: 128² cells.
const QUICK: &str = "--synthetic=rms_height=1 um,longest=100 um,shortest=25 um,seed=1";

fn run(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["roughness"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = run(bench, &[&["--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// A sample of the case crate.
fn sample(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../schlupf-case/tests/surfaces");
    folder.join(name).display().to_string()
}

#[test]
fn every_output_is_written() {
    let bench = Bench::new();
    let outputs =
        ["--json", "r.json", "--csv", "r.csv", "--heights", "r.npy", "--figures", "in/here"];
    let run = run(&bench, &[&[QUICK], &outputs[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stderr.starts_with("warning: the spots carry"), "{}", run.stderr);
    assert_eq!(bench.list(), ["in", "r.csv", "r.json", "r.npy"]);
    for part in ["rms_height=1 um", "128 x 128 cells", "Sq  ", "p (MPa)", "k_c", "closed form"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    for name in ["curves", "surface", "spots", "spectrum"] {
        assert!(bench.has_figure(&format!("in/here/roughness_{name}")), "{name}");
    }
    let document: Value = serde_json::from_str(&bench.read("r.json")).unwrap();
    assert_eq!(document["status"], "converged");
    let pressures = document["pressures"].as_array().unwrap();
    assert_eq!(pressures.len(), 6);
    assert!((number(&pressures[5]["mean_pressure"]) - 1.2e9).abs() < 1.0);
    let header = bench.read("r.csv").lines().nth(1).unwrap().to_owned();
    assert!(header.starts_with("mean_pressure,displacement,traction,"), "{header}");
}

/// Goal: k_c of a self-affine surface, from a measurement of it, and from the case: three ways to
/// one number.
#[test]
fn a_surface_written_and_read_gives_the_same_stiffness() {
    let bench = Bench::new();
    let pressures = ["--pressure", "0.4,0.8 GPa"];
    let made = document(&bench, &[&[QUICK, "--heights", "r.npy"], &pressures[..]].concat());
    let file = ["r.npy", "--unit", "m", "--spacing", "6.25 um", "--form", "none"];
    let read = document(&bench, &[&file, &pressures[..]].concat());
    let stiffness = |document: &Value| number(&document["contact_law"]["stiffness"]);
    let relative = stiffness(&read) / stiffness(&made) - 1.0;
    assert!(relative.abs() < 1e-9, "{relative}");
    bench.write(
        "case.toml",
        "[contact_law.roughness]\nfile = \"r.npy\"\nunit = \"m\"\nspacing = \"6.25 um\"\n\
         form = \"none\"\npressures = [\"0.4 GPa\", \"0.8 GPa\"]\n\
         [grid]\ncells_x = 8\ncells_y = 8\n",
    );
    let solved = bench.run(&["solve", "case.toml", "--json", "-"]);
    assert_eq!(solved.code, Some(0), "{}", solved.stderr);
    let solved: Value = serde_json::from_str(&solved.stdout).unwrap();
    assert_eq!(solved["contact_law"]["from"], "micro-model");
    let relative = number(&solved["contact_law"]["stiffness"]) / stiffness(&made) - 1.0;
    assert!(relative.abs() < 1e-9, "{relative}");
    assert_eq!(solved["contact_law"]["fit"]["stiffnesses"].as_array().unwrap().len(), 2);
    // Without a surface, that of the case.
    let own = document(&bench, &["--case", "case.toml"]);
    assert_eq!(stiffness(&own), number(&solved["contact_law"]["stiffness"]));
    let slippery = document(&bench, &["--case", "case.toml", "--friction", "0.2"]);
    assert!((stiffness(&slippery) / stiffness(&own) - 2.0).abs() < 1e-6);
}

/// The closed form and μ: k_c = 2(1 − ν)/(μ (2 − ν) γ h_rms), by hand for steel.
#[test]
fn bodies_and_friction_come_from_the_case() {
    let bench = Bench::new();
    let plain = document(&bench, &[QUICK]);
    let closed = |document: &Value| number(&document["contact_law"]["closed_form"]["stiffness"]);
    let expected = 1.44 / (0.4 * 1.72 * 0.45e-6);
    assert!((closed(&plain) / expected - 1.0).abs() < 1e-9, "{}", closed(&plain));
    let slippery = document(&bench, &[QUICK, "--friction", "0.1"]);
    assert!((closed(&slippery) / (4.0 * expected) - 1.0).abs() < 1e-9);
    let rubber = ["--set", "wheel.poisson_ratio=0.5", "--set", "rail.poisson_ratio=0.5"];
    let rubber = document(&bench, &[&[QUICK], &rubber[..]].concat());
    let expected = 1.0 / (0.4 * 1.5 * 0.45e-6);
    assert!((closed(&rubber) / expected - 1.0).abs() < 1e-9);
    // Harder is stiffer: a hardness flattens summits.
    let soft = document(&bench, &[QUICK, "--hardness", "2.5 GPa"]);
    let plastic =
        |d: &Value| number(d["normal"]["plastic_fraction"].as_array().unwrap().last().unwrap());
    assert!(plastic(&soft) > 0.01 && plastic(&plain) == 0.0);
}

/// A surface of its own needs neither the surface of the case nor its micro model.
#[test]
fn the_surface_of_the_case_is_not_read_for_another() {
    let bench = Bench::new();
    bench.write("case.toml", "[contact_law]\nroughness = \"gone.csv\"\n");
    let pressure = ["--pressure", "0.4,0.8 GPa", "--case", "case.toml"];
    let document = document(&bench, &[&[QUICK], &pressure[..]].concat());
    assert!(number(&document["contact_law"]["stiffness"]) > 0.0);
    let own = run(&bench, &["--case", "case.toml"]);
    assert!(own.stderr.contains("gone.csv"), "{}", own.stderr);
    let calibrated = bench.run(&["calibrate", "case.toml", "--cells", "10"]);
    assert_eq!(calibrated.code, Some(0), "{}", calibrated.stderr);
}

/// A profile becomes a surface of its roughness; two surfaces are added.
#[test]
fn profiles_and_pairs_are_taken() {
    let bench = Bench::new();
    let line: Vec<String> = (0..256)
        .map(|i| (f64::from(i), f64::from(i * i % 97)))
        .map(|(x, noise)| format!("{x},{}", (x / 7.0).sin() + 0.02 * noise))
        .collect();
    bench.write("line.csv", &format!("x [um],height [um]\n{}\n", line.join("\n")));
    let profile = document(&bench, &["line.csv", "--cells", "128"]);
    assert_eq!(profile["surface"]["columns"], 128);
    let warnings = profile["warnings"].to_string();
    assert!(warnings.contains("shorter than 4.000 µm, two cells, are left out"), "{warnings}");
    let wave = sample("wave.x3p");
    let one = document(&bench, &[&wave]);
    let two = document(&bench, &[&wave, "--second", &wave]);
    let height = |document: &Value| number(&document["surface"]["root_mean_square_height"]);
    assert!((height(&two) / height(&one) - 2.0).abs() < 1e-9);
    assert!(one["warnings"].to_string().contains("cells are in contact"));
}

/// Arguments after `roughness`, parts of the report.
const BAD: &[(&[&str], &[&str])] = &[
    (&[], &["there is no surface", "--synthetic"]),
    (&["none.x3p"], &["SURFACE must be a readable file", "none.x3p"]),
    (&["--synthetic", "rms_height=1 um"], &["must name the longest and the shortest wavelength"]),
    (&["--synthetic", "height=1 um"], &["with the keys rms_height, rms_slope", "\"height=1 um\""]),
    (
        &["--synthetic", "rms_height=1,longest=1 mm,shortest=20 um"],
        &["--synthetic rms_height=1: rms_height must be a length with its unit"],
    ),
    (
        &["--synthetic", "rms_height=1 um,longest=1 mm,shortest=2 mm"],
        &["longest must be at least the shortest wavelength, 2e-3 m, but is 1e-3 m"],
    ),
    (
        &["--synthetic", "rms_height=1 um,longest=100 um,shortest=5 um", "--cells", "100"],
        &["shortest must be at least two cells"],
    ),
    (
        &[QUICK, "--pressure", "1"],
        &["--pressure 1: each value of --pressure must be a pressure", "unit is missing"],
    ),
    (&[QUICK, "--friction", "-1"], &["--friction -1: friction.coefficient must be between"]),
    (
        &[QUICK, "--hardness", "0.5 GPa"],
        &["--hardness 0.5 GPa: --hardness must be above the largest"],
    ),
    (
        &["line.csv", "--spacing", "1"],
        &["--spacing 1: --spacing must be a length", "\"1\": the unit is missing"],
    ),
    (&[QUICK, "--form", "plane"], &["--form"]),
    (&[QUICK, "--second", "xx.csv"], &["and --second is \"xx.csv\" (--second xx.csv)"]),
    (
        &[QUICK, "--seed", "2"],
        &["--synthetic must not give what --seed gives, but has \"seed=1\" and --seed is \"2\""],
    ),
    (
        &["--synthetic", "rms_height=1 um,longest=1 mm,longest_wavelength=2 mm,shortest=20 um"],
        &["must give a key once, but has \"longest=1 mm\" and \"longest_wavelength=2 mm\""],
    ),
    (
        &["line.csv", "--cutoff", "1 m"],
        &["--cutoff 1 m: --cutoff must be between 2e-6 and 9.9e-5 m"],
    ),
    (&["line.csv", "--form", "cone"], &["'cone' for '--form <NAME>'", "cylinder, sphere, none"]),
    (
        &["line.csv", "--heights", "line.csv"],
        &["must write files of its own, but line.csv is also that of SURFACE"],
    ),
];

#[test]
fn bad_input_is_reported_and_nothing_is_written() {
    for (arguments, parts) in BAD {
        let bench = Bench::new();
        let line: Vec<String> = (0..99).map(|i| format!("{i},{}", f64::from(i * i % 13))).collect();
        bench.write("line.csv", &format!("x [um],height [um]\n{}\n", line.join("\n")));
        let run = run(&bench, &[&["--json", "t.json", "--figures", "f"], *arguments].concat());
        let is_missing = arguments.contains(&"none.x3p");
        let code = if is_missing { 1 } else { 2 };
        assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.stderr);
        assert_eq!(run.stdout, "");
        for part in *parts {
            assert!(run.stderr.contains(part), "{arguments:?}: {part:?} is not in\n{}", run.stderr);
        }
        assert_eq!(bench.list(), ["line.csv"]);
    }
}

#[test]
fn defects_of_measured_surfaces_name_the_option_that_helps() {
    let bench = Bench::new();
    let samples: [(&str, &[&str], &[&str]); 5] = [
        ("flat.x3p", &[], &["must not be flat"]),
        ("wave_single_holes.x3p", &[], &["1 of 384 are missing", "--fill-holes fills them"]),
        ("wave_not_square.x3p", &[], &["must have square cells", "--square-cells resamples it"]),
        ("wave.npy", &[], &["--unit must be a unit of length"]),
        ("wave.npy", &["--unit", "um"], &["--spacing must be given, because"]),
    ];
    for (name, options, parts) in samples {
        let file = sample(name);
        let run = run(&bench, &[&[file.as_str()], options].concat());
        assert_eq!(run.code, Some(2), "{name}: {}", run.stderr);
        for part in parts {
            assert!(run.stderr.contains(part), "{name}: {part:?} is not in\n{}", run.stderr);
        }
    }
    for (name, option) in
        [("wave_single_holes.x3p", "--fill-holes"), ("wave_not_square.x3p", "--square-cells")]
    {
        let run = run(&bench, &[&sample(name), option, "--quiet"]);
        assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{}", run.stderr);
    }
}

/// A piece that is hardly larger than its longest wave is one of many.
#[test]
fn a_piece_too_small_is_told() {
    let bench = Bench::new();
    let long = "--synthetic=rms_height=1 um,longest=400 um,shortest=100 um";
    document(&bench, &[long, "--cells", "64", "--heights", "whole.npy"]);
    let whole = ["whole.npy", "--unit", "m", "--spacing", "50 um"];
    let whole = document(&bench, &whole)["warnings"].to_string();
    assert!(!whole.contains("longer than a fifth"), "{whole}");
    // The upper left sixth of it.
    let bytes = std::fs::read(bench.path("whole.npy")).unwrap();
    let start = bytes.len() - 8 * 64 * 64;
    let value = |k: usize| {
        let at = start + 8 * k;
        f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap())
    };
    let rows = (0..144).map(|k| {
        let (i, j) = (k % 12, k / 12);
        format!("{i},{j},{}\n", 1e9 * value(64 * j + i))
    });
    let header = "x [um],y [um],height [nm]\n".to_owned();
    bench.write("piece.csv", &rows.fold(header, |text, row| text + &row));
    let piece = document(&bench, &["piece.csv", "--square-cells"])["warnings"].to_string();
    assert!(piece.contains("waves longer than a fifth of the piece"), "{piece}");
}

/// Two surfaces must lie on the same lattice.
#[test]
fn surfaces_of_different_size_are_refused() {
    let bench = Bench::new();
    let first = document(&bench, &[QUICK, "--heights", "first.npy"]);
    assert_eq!(first["surface"]["columns"], 128);
    let smaller = "--synthetic=rms_height=1 um,longest=100 um,shortest=50 um";
    document(&bench, &[smaller, "--cells", "64", "--heights", "second.npy"]);
    let options = ["--second", "second.npy", "--unit", "m", "--spacing", "1 um"];
    let run = run(&bench, &[&["first.npy"], &options[..]].concat());
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("two surfaces must have the same lattice"), "{}", run.stderr);
}

/// What a result says about its k_c; `check` says it, too.
#[test]
fn results_say_where_the_stiffness_comes_from() {
    let bench = Bench::new();
    let small = "[grid]\ncells_x = 8\ncells_y = 8\n";
    let result = |text: &str, options: &[&str]| -> Value {
        bench.write("case.toml", &format!("{text}{small}"));
        let run = bench.run(&[&["solve", "case.toml", "--json", "-"], options].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        serde_json::from_str::<Value>(&run.stdout).unwrap()["contact_law"].clone()
    };
    assert_eq!(result("", &[])["from"], "default");
    assert_eq!(result("contact_law.stiffness = \"1e6 1/m\"\n", &[])["stiffness"], 1e6);
    let rough = "[contact_law]\nroughness = { rms_height = \"1.5 um\" }\n";
    let closed = result(rough, &[]);
    assert_eq!((&closed["from"], &closed["rms_height"]), (&"closed-form".into(), &1.5e-6.into()));
    assert!(result(rough, &["--set", "solver.method=fastsim"]).is_null());
    let run = bench.run(&["solve", "case.toml"]);
    assert!(run.stdout.contains("k_c, closed form: h_rms = 1.5 µm, γ = 0.45"), "{}", run.stdout);
    let run = bench.run(&["check", "case.toml"]);
    assert!(run.stdout.contains("k_c        3.101e6 1/m, closed form"), "{}", run.stdout);
}

/// A name that is not UTF-8 opens its file, and only messages replace what cannot be shown.
#[cfg(target_os = "linux")]
#[test]
fn paths_need_not_be_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let bench = Bench::new();
    for option in [None, Some("--second")] {
        let path = bench.path("").join(OsStr::from_bytes(b"bad\xff.csv"));
        std::fs::write(&path, "# nothing").unwrap();
        let arguments = option.map_or(vec![], |option| vec![sample("wave.csv"), option.to_owned()]);
        let output = bench.command(&["roughness"]).args(arguments).arg(path).output().unwrap();
        let run = Run::from(output);
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(run.stderr.contains("bad\u{fffd}.csv") && run.stderr.contains("header"), "{run:?}");
    }
}
