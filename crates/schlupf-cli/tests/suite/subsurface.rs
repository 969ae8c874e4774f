//! `schlupf subsurface` from the outside: outputs, fields, errors and exit codes.

use crate::support::{Bench, Run};
use serde_json::Value;

/// A circular contact without traction: p0 = 1 GPa, a = 6 mm, ν = 0.3.
const CIRCLE: &str = "title = \"circle\"\n[kinematics]\ncreepage_x = 0.0\n\
                      [wheel]\npoisson_ratio = 0.3\n[rail]\npoisson_ratio = 0.3\n\
                      [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"6 mm\"\npeak_pressure = \"1 GPa\"\n\
                      [heat]\nmodel = \"none\"\n\
                      [grid]\ncells_x = 12\ncells_y = 12\n\
                      [subsurface]\nlayers = 9\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CIRCLE);
    bench
}

fn run(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["subsurface", "case.toml"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = run(bench, &[&["--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn every_output_is_written() {
    let bench = bench();
    let outputs = ["--json", "s.json", "--csv", "s.csv", "--vtk", "s.vtk", "--figures", "in/here"];
    let run = run(&bench, &outputs);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert_eq!(bench.list(), ["case.toml", "in", "s.csv", "s.json", "s.vtk"]);
    for part in ["circle", "stresses in the rail", "largest von Mises stress", "converged"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    for name in ["section", "across", "shear", "profile"] {
        assert!(bench.has_figure(&format!("in/here/subsurface_{name}")));
    }
    let table = bench.read("s.csv");
    assert!(table.starts_with("# units: m, m, m, Pa"));
    assert_eq!(table.lines().count(), 2 + 201);
    // 12 cells and the two columns of the border, with half the patch on each side.
    let vtk = std::fs::read(bench.path("s.vtk")).unwrap();
    let head = String::from_utf8_lossy(&vtk[..200]).into_owned();
    for part in ["DATASET RECTILINEAR_GRID", "DIMENSIONS 28 24 9", "X_COORDINATES 28 double"] {
        assert!(head.contains(part), "{part:?} is not in {head:?}");
    }
    let numbers = 28 + 24 + 9 + 28 * 24 * 9 * (9 + 4);
    assert!(vtk.len() > 8 * numbers && vtk.len() < 8 * numbers + 1000, "{}", vtk.len());
}

/// Hertz 1882: the largest shear stress is 0.310 p0 at 0.48 a below the middle (Johnson 1985,
/// §4.2), in rail and wheel alike; on the surface the profile begins with −p0.
#[test]
fn hertz_1882_largest_shear_below_a_circle() {
    let bench = bench();
    for body in ["rail", "wheel"] {
        let set = format!("subsurface.body={body}");
        let found = document(&bench, &["--set", &set, "--x", "0 mm", "--y", "0 mm"]);
        assert_eq!(found["body"], body);
        let largest = &found["largest"]["shear"];
        assert!((number(&largest["largest_shear_stress"]) / 0.310e9 - 1.0).abs() < 0.01);
        assert!((number(&largest["depth"]) / 6e-3 - 0.48).abs() < 0.01, "{largest}");
        assert!(number(&largest["x"]).abs() < 1e-4 && number(&largest["y"]).abs() < 1e-4);
        let profile = &found["profile"];
        assert!((number(&profile["stress_zz"][0]) / -1e9 - 1.0).abs() < 0.01, "{profile}");
    }
}

/// Beside the axis, under traction and in the wheel: the points of a profile there, one by one.
#[test]
fn points_are_those_of_a_profile_beside_the_axis() {
    let bench = bench();
    let sliding = ["--set", "kinematics.creepage_x=0.05", "--set", "subsurface.body=wheel"];
    let profile = ["--x", "3 mm", "--y", "-1 mm"];
    let profile = document(&bench, &[&sliding[..], &profile].concat());
    let rows = &profile["profile"];
    let count = rows["depth"].as_array().unwrap().len();
    let lines = (0..count).rev().map(|k| format!("3,-1,{}\n", 1e3 * number(&rows["depth"][k])));
    bench.write("points.csv", &format!("x [mm],y [mm],depth [mm]\n{}", lines.collect::<String>()));
    let found = document(&bench, &[&sliding[..], &["--points", "points.csv"]].concat());
    for name in ["xx", "yy", "zz", "xy", "xz", "yz"].map(|c| format!("stress_{c}")) {
        for k in 0..count {
            let [one, other] =
                [&found["points"][&name][k], &rows[&name][count - 1 - k]].map(number);
            assert!((one - other).abs() < 1.0, "{name} {k}: {one} {other}");
        }
    }
    let shear = number(&rows["stress_xz"][count / 4]).abs();
    assert!(shear > 1e7, "{shear}");
}

/// Hertz on the axis of a circular contact (Johnson 1985, §3.4 (a)): σzz = −p0/(1 + z²/a²), and
/// σrr = −(1 + ν) p0 (1 − z/a atan(a/z)) + p0/(2 (1 + z²/a²)); the points stay in their order.
#[test]
fn points_are_those_of_a_table() {
    let bench = bench();
    bench.write("points.csv", "depth [mm],x [mm],y [m]\n6,0,0\n3,0,0\n3,6,0\n");
    let found = document(&bench, &["--points", "points.csv", "--csv", "s.csv"]);
    let points = &found["points"];
    let at = |name: &str, k: usize| number(&points[name][k]);
    for (k, depth) in [1.0, 0.5].into_iter().enumerate() {
        let hydrostatic = 1.0 / (1.0 + depth * depth);
        let radial = -1.3 * (1.0 - depth * (1.0_f64 / depth).atan()) + 0.5 * hydrostatic;
        assert!((at("stress_zz", k) / 1e9 + hydrostatic).abs() < 5e-3);
        assert!((at("stress_xx", k) / 1e9 - radial).abs() < 5e-3);
        assert!((at("stress_yy", k) / 1e9 - radial).abs() < 5e-3);
    }
    assert_eq!((at("x", 2), at("y", 2), at("depth", 2)), (6e-3, 0.0, 3e-3));
    assert_eq!(bench.read("s.csv").lines().count(), 2 + 3);
    assert_eq!(document(&bench, &[])["points"], Value::Null);
}

/// The largest stresses are those of the body, whatever layers are written.
#[test]
fn the_largest_stresses_do_not_depend_on_the_layers() {
    let bench = bench();
    let slip = "kinematics.creepage_x=0.001";
    let usual = document(&bench, &["--set", slip]);
    for layers in [["depth=1 mm", "layers=2"], ["depth=100 m", "margin=0 mm"]] {
        let [one, other] = layers.map(|field| format!("subsurface.{field}"));
        let found = document(&bench, &["--set", slip, "--set", &one, "--set", &other]);
        for part in ["largest", "surface", "below"] {
            assert_eq!(found[part], usual[part], "{layers:?}, {part}");
        }
    }
    assert_eq!(usual["surface"]["von_mises"]["depth"], 0.0);
    assert!(number(&usual["below"]["von_mises"]["depth"]) > 1e-3);
}

/// Depth, layers and margin are those of the case; without them they follow from the patch.
#[test]
fn the_case_says_where() {
    let bench = bench();
    let layers = |arguments: &[&str]| {
        let found = document(&bench, arguments);
        let depths = found["layers"]["depth"].as_array().unwrap().clone();
        (depths.len(), number(depths.last().unwrap()))
    };
    let (count, deepest) = layers(&[]);
    assert_eq!(count, 9);
    assert!((deepest - 12e-3).abs() < 1e-12);
    let (count, deepest) =
        layers(&["--set", "subsurface.depth=3 mm", "--set", "subsurface.layers=4"]);
    assert_eq!(count, 4);
    assert!((deepest - 3e-3).abs() < 1e-12);
    let found = run(&bench, &["--vtk", "s.vtk", "--set", "subsurface.margin=0 mm"]);
    assert_eq!(found.code, Some(0), "{}", found.stderr);
    let vtk = std::fs::read(bench.path("s.vtk")).unwrap();
    assert!(String::from_utf8_lossy(&vtk[..200]).contains("DIMENSIONS 16 12 9"));
}

/// What cannot be is refused with its place, and nothing is written.
#[test]
fn what_cannot_be_is_refused() {
    let bench = bench();
    bench.write("points.csv", "x [mm],y [mm],depth [mm]\n0,0,1\n0,0,-1\n");
    for (arguments, parts) in [
        (vec!["--points", "points.csv"], vec!["points.csv:3:1", "depth", "between 0 and 1000 m"]),
        (vec!["--points", "points.csv", "--csv", "points.csv"], vec!["--csv", "--points"]),
        (vec!["--set", "subsurface.body=sleeper"], vec!["subsurface.body", "rail"]),
        (vec!["--set", "subsurface.depth=-1 mm"], vec!["subsurface.depth", "between"]),
        (vec!["--set", "subsurface.layers=1"], vec!["subsurface.layers"]),
        (vec!["--set", "subsurface.margin=5 m"], vec!["subsurface.margin", "5000000"]),
        (vec!["--set", "solver.method=polach"], vec!["solver.method", "polach"]),
        (vec!["--x", "far"], vec!["--x"]),
        (vec!["--x", "2 km"], vec!["--x", "1000"]),
        (vec!["--x", "500 mm"], vec!["--x", "500 mm", "mm", "subsurface.margin"]),
        (vec!["--y", "500 mm"], vec!["--y", "500 mm", "-12.000 to 12.000 mm", "subsurface.margin"]),
        (vec!["--set", "subsurface.margin=0.6 m", "--set", "subsurface.layers=2"], vec!["4000000"]),
    ] {
        let run = run(&bench, &[&["--json", "s.json"], arguments.as_slice()].concat());
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        for part in parts {
            assert!(run.stderr.contains(part), "{arguments:?}: {part:?} is not in {}", run.stderr);
        }
        assert_eq!(bench.list(), ["case.toml", "points.csv"]);
    }
}

/// The stresses of a history are those of its last instant: pressure and load at its end.
#[test]
fn a_history_has_the_stresses_of_its_end() {
    let bench = bench();
    // Half the load on a patch of given size, so half the pressure.
    let history = "[history]\ntime = [\"0 s\", \"0.2 ms\"]\ncreepage_x = [0.0, 0.001]\n\
                   load = [\"75.398 kN\", \"37.699 kN\"]\n";
    let by_load = CIRCLE.replace("peak_pressure = \"1 GPa\"", "load = \"75.398 kN\"");
    bench.write("case.toml", &format!("{by_load}{history}"));
    let found = document(&bench, &["--x", "0 mm", "--y", "0 mm"]);
    assert_eq!(found["status"], "converged");
    let profile = &found["profile"];
    let expected = -0.5e9;
    assert!((number(&profile["stress_zz"][0]) / expected - 1.0).abs() < 0.01, "{profile}");
    assert!(number(&profile["stress_xz"][0]).abs() > 1e6, "{profile}");
}
