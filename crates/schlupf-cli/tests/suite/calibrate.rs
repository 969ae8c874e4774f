//! `schlupf calibrate` from the outside: stiffnesses, snippet, displacements, errors and exit
//! codes.

use std::fmt::Write;

use crate::support::{Bench, Run};
use schlupf::bodies::Material;
use schlupf::elasticity::HalfSpace;
use serde_json::Value;

/// A braking wheel with spin, whose layer is calibrated.
const CASE: &str = "title = \"to calibrate\"\n[kinematics]\ncreepage_x = 0.002\nspin = \"0.3 1/m\"\n\
                    [heat]\nmodel = \"none\"\n[friction]\nmodel = \"constant\"\n\
                    [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"5 mm\"\nload = \"60 kN\"\n\
                    [grid]\ncells_x = 16\ncells_y = 15\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench
}

fn run(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["calibrate", "case.toml", "--cells", "12"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = run(bench, &[&["--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// From `[elasticity]` to the next empty line.
fn snippet(stdout: &str) -> &str {
    let start = stdout.find("[elasticity]").unwrap();
    let length = stdout[start..].find("\n\n").unwrap();
    &stdout[start..=start + length]
}

/// The table's stiffnesses, pasted into the case, give the forces of the calibrated layer, to the
/// digits of the snippet.
#[test]
fn the_snippet_is_the_calibrated_layer() {
    let bench = bench();
    let run = run(&bench, &["--json", "c.json"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    for part in ["to calibrate", "a/b = 1.2", "table", "% of μN", "coupling_x_across", "converged"]
    {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    let document: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    assert!(number(&document["table"]["deviation"]["force"]) < 0.03);
    assert!(document["direct"].is_null() && document["fitted"].is_null());
    bench.write("pasted.toml", &format!("{CASE}{}", snippet(&run.stdout)));
    let force = |case: &str| -> [f64; 2] {
        let run = bench.run(&["solve", case, "--json", "-"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let solution: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!(solution["warnings"], Value::Array(Vec::new()));
        ["x", "y"].map(|component| number(&solution["normalised"][component]))
    };
    let [here, there] = ["case.toml", "pasted.toml"].map(force);
    for (here, there) in here.iter().zip(there) {
        assert!((here - there).abs() < 1e-4, "{here} {there}");
    }
}

/// A calibration of its own is near the table, and nearer to the half-space than springs without
/// coupling.
#[test]
fn a_direct_calibration_stands_beside_the_table() {
    let bench = bench();
    let document = document(&bench, &["--direct"]);
    let [table, direct] = ["table", "direct"].map(|name| number(&document[name]["x"]["bedding"]));
    assert!((table / direct - 1.0).abs() < 0.1, "{table:e} {direct:e}");
    let field = |name: &str| number(&document[name]["deviation"]["field"]);
    assert!(field("direct") < 0.7 * field("uncoupled"));
    assert_eq!(number(&document["uncoupled"]["x"]["coupling"]), 0.0);
}

/// A patch of separate parts gets the warning that `solve` gives.
#[test]
fn separate_parts_are_warned_of_as_by_solve() {
    let bench = Bench::new();
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/two_point_contact.toml");
    let warning = |command: &str, others: &[&str]| {
        let layer = ["--set", "elasticity.model=elastic-layer", "--set", "grid.cells_x=12"];
        let run = bench.run(&[&[command, case], &layer[..], others].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let found = run.stderr.lines().find(|line| line.contains("separate parts"));
        found.map_or_else(|| panic!("{}", run.stderr), str::to_owned)
    };
    let told = warning("calibrate", &["--cells", "10"]);
    assert!(told.contains("too compliant"), "{told}");
    assert_eq!(told, warning("solve", &[]));
}

#[test]
fn the_figure_is_drawn() {
    let bench = bench();
    let run = run(&bench, &["--figures", "figures", "--quiet"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{}", run.stderr);
    assert!(bench.has_figure("figures/calibration"));
}

#[test]
fn what_did_not_converge_is_marked() {
    let bench = bench();
    let arguments = ["--direct", "--set", "solver.max_iterations=1", "--json", "-"];
    let run = run(&bench, &arguments);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    let document: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(document["status"], "not-converged");
    assert!(run.stderr.contains("not converged"));
}

/// Stiffnesses of the layer that the made-up displacements belong to: c, g along rolling, g across.
const FIRST: [f64; 3] = [9e12, 4e7, 1.5e7];
const SECOND: [f64; 3] = [6e12, 2e7, 3e7];

/// Displacement u = u0 exp(−x²/p² − y²/q²) (p, q in m), and the traction c u − g_x u_xx − g_y u_yy
/// that makes it.
fn bell([x, y]: [f64; 2], [p, q]: [f64; 2], [c, along, across]: [f64; 3]) -> [f64; 2] {
    let u = 1e-5 * (-(x / p).powi(2) - (y / q).powi(2)).exp();
    let curvature = |x: f64, p: f64| (4.0 * x * x / p.powi(4) - 2.0 / (p * p)) * u;
    [u, c * u - along * curvature(x, p) - across * curvature(y, q)]
}

/// A table as a finite-element program would write it: displacements in µm, shifted as a whole.
fn table() -> String {
    let mut text = "# made up\ny [mm],x [mm],traction_x [MPa],displacement_x [um],traction_y [MPa],displacement_y [um]\n"
        .to_owned();
    for i in 0..61 {
        for j in 0..51 {
            let point = [(f64::from(i) - 30.0) * 0.4e-3, (f64::from(j) - 25.0) * 0.4e-3];
            let [u, t] = bell(point, [4e-3, 3e-3], FIRST);
            let [v, s] = bell(point, [3e-3, 3.5e-3], SECOND);
            let [x, y] = point.map(|length| length * 1e3);
            let (u, v) = (u * 1e6 + 7.0, v * 1e6 - 3.0);
            writeln!(text, "{y:.4},{x:.4},{},{u},{},{v}", t * 1e-6, s * 1e-6).unwrap();
        }
    }
    text
}

/// Displacements that solve c u − g_x u_xx − g_y u_yy = t in closed form give back c and g, in x
/// and y of their own, to what springs 0.4 mm long leave open.
#[test]
fn displacements_in_closed_form_give_back_the_stiffnesses() {
    let bench = bench();
    bench.write("fe.csv", &table());
    let document = document(&bench, &["--displacements", "fe.csv"]);
    for (component, expected) in [("x", FIRST), ("y", SECOND)] {
        let fitted = &document["fitted"][component];
        assert_eq!(fitted["converged"], true);
        assert!(number(&fitted["files"][0]["deviation"]) < 2e-3, "{fitted}");
        let found = ["bedding", "coupling", "coupling_across"].map(|name| number(&fitted[name]));
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.02, "{fitted}");
        }
    }
    let run = run(&bench, &["--displacements", "fe.csv"]);
    assert!(run.stdout.contains("away from the displacements") && run.stdout.contains("fe.csv"));
    bench.write("pasted.toml", &format!("{CASE}{}", snippet(&run.stdout)));
    assert_eq!(bench.run(&["solve", "pasted.toml", "--quiet"]).code, Some(0));
}

/// Displacements of two steel half-spaces under μp on a circle of 5 mm, from Cerruti's solution
/// cell by cell.
fn half_space_table() -> String {
    let bodies = HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap();
    let spacing = 0.5e-3;
    let points: Vec<[f64; 2]> =
        (0..33 * 33).map(|k| [k % 33, k / 33].map(|n| (f64::from(n) - 16.0) * spacing)).collect();
    let traction = |[x, y]: [f64; 2]| 3e8 * (1.0 - (x * x + y * y) / 25e-6).max(0.0).sqrt();
    let loaded: Vec<[f64; 2]> = points.iter().copied().filter(|p| traction(*p) > 0.0).collect();
    let mut text = "x [mm],y [mm],traction_x [MPa],displacement_x [um]\n".to_owned();
    for &[x, y] in &points {
        let under = |&[i, j]: &[f64; 2]| {
            bodies.influence_of([spacing; 2], [x - i, y - j])[0] * traction([i, j])
        };
        let displacement: f64 = loaded.iter().map(under).sum();
        let t = traction([x, y]);
        writeln!(text, "{},{},{},{}", x * 1e3, y * 1e3, t * 1e-6, displacement * 1e6).unwrap();
    }
    text
}

/// The half-space as if it came from finite elements: the layer's displacements are within 4 % of
/// its, and in rolling the forces of the fitted layer within 2 % of μN.
#[test]
fn kalker_1990_displacements_of_the_half_space() {
    let bench = Bench::new();
    bench.write("hs.csv", &half_space_table());
    bench.write("case.toml", &CASE.replace("6 mm", "5 mm").replace("spin = \"0.3 1/m\"", ""));
    let run = run(&bench, &["--displacements", "hs.csv", "--json", "c.json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let document: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    let deviation = number(&document["fitted"]["x"]["files"][0]["deviation"]);
    bench.write("pasted.toml", &format!("{}{}", bench.read("case.toml"), snippet(&run.stdout)));
    let force = |arguments: &[&str]| {
        let run = bench.run(&[&["solve", "--json", "-"], arguments].concat());
        let solution: Value = serde_json::from_str(&run.stdout).unwrap();
        number(&solution["normalised"]["x"])
    };
    let fitted = force(&["pasted.toml"]);
    let exact = force(&["case.toml", "--set", "elasticity.model=half-space"]);
    println!("displacements {:.1} %, forces {fitted:.4} {exact:.4}", 100.0 * deviation);
    assert!(deviation < 0.04 && (fitted - exact).abs() < 0.02, "{deviation} {fitted} {exact}");
}

/// Where one component is loaded the other has no stiffness of its own, and the snippet says so.
#[test]
fn a_component_without_load_is_left_out() {
    let bench = bench();
    let table = table().replace("traction_x [MPa],displacement_x [um]", "a,b");
    let columns = |line: &str| -> String {
        let cells: Vec<&str> = line.split(',').collect();
        if cells.len() < 6 {
            line.to_owned()
        } else {
            [cells[0], cells[1], cells[4], cells[5]].join(",")
        }
    };
    let table: Vec<String> = table.lines().map(columns).collect();
    bench.write("y.csv", &(table.join("\n") + "\n"));
    let run = run(&bench, &["--displacements", "y.csv"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let snippet = snippet(&run.stdout);
    assert!(snippet.contains("# along x as along y"), "{snippet}");
    bench.write("pasted.toml", &format!("{CASE}{snippet}"));
    assert_eq!(bench.run(&["solve", "pasted.toml", "--quiet"]).code, Some(0));
}

/// Displacements in another unit, and such as no layer has.
#[test]
fn displacements_that_do_not_belong_to_the_load_are_told() {
    let bench = bench();
    bench.write("fe.csv", &table().replace("displacement_x [um]", "displacement_x [mm]"));
    let run = run(&bench, &["--displacements", "fe.csv"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stderr.contains("are units and bodies right?"), "{}", run.stderr);
    let point = |k: usize| [k % 20, k / 20].map(|n| n as f64 - 9.5);
    let rows = (0..400).map(point).map(|[x, y]| {
        let load = (25.0 - x * x - y * y).max(0.0);
        format!("{x},{y},{load},{}\n", 10.0 + x + 0.01 * load)
    });
    let header = "x [mm],y [mm],traction_x [MPa],displacement_x [um]\n".to_owned();
    bench.write("tilted.csv", &rows.fold(header, |text, row| text + &row));
    let run = bench.run(&["calibrate", "case.toml", "--displacements", "tilted.csv"]);
    assert_eq!(run.code, Some(2), "{}", run.stdout);
    let expected = "displacement_x: no elastic layer has such displacements";
    assert!(run.stderr.contains(expected), "{}", run.stderr);
}

#[test]
fn bad_input_is_named() {
    let bench = bench();
    bench.write("fe.csv", &table());
    bench.write("bad.csv", &table().replacen("[um]", "[MPa]", 1));
    bench.write(
        "opposite.csv",
        "x [mm],y [mm],traction_x [MPa],displacement_x [um]\n0,0,1,-1\n1,0,0,0\n0,1,0,0\n1,1,0,0\n",
    );
    let cases: [(&[&str], i32, &str); 8] = [
        (&["--displacements", "none.csv"], 1, "the file of --displacements cannot be read"),
        (
            &["--displacements", "bad.csv"],
            2,
            "bad.csv:2:1: column `displacement_x` must name its unit",
        ),
        (&["--displacements", "opposite.csv"], 2, "displacement_x must go with traction_x"),
        (&["--displacements", "bad.csv", "--direct"], 2, "cannot be used with '--direct'"),
        (&["--displacements", "fe.csv", "--json", "fe.csv"], 2, "must write files of its own"),
        (&["--cells", "5"], 2, "between 10 and 80"),
        (&["--json", "fe.csv/file.json"], 1, "fe.csv"),
        (&["--set", "normal.semi_axis_x=80 mm"], 2, "between 0.1 and 10"),
    ];
    for (arguments, code, expected) in cases {
        let run = bench.run(&[&["calibrate", "case.toml"], arguments].concat());
        assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(expected), "{arguments:?}: {}", run.stderr);
    }
}
