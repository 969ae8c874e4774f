//! `schlupf solve` from the outside: outputs and exit codes.

use std::process::Stdio;

use crate::support::Bench;
use serde_json::Value;

/// A case that takes no time.
const SMALL: &str = "title = \"small\"\n[kinematics]\ncreepage_x = 0.002\n\
                     [grid]\ncells_x = 8\ncells_y = 6\n";

#[test]
fn the_default_case_prints_a_summary() {
    let run = Bench::new().run(&["solve", "--set", "grid.cells_x=8", "--set", "grid.cells_y=6"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.contains("steel wheel, 80 kN, braking"), "{}", run.stdout);
    assert_eq!(run.stderr, "");
}

#[test]
fn every_output_is_written() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let run = bench.run(&[
        "solve",
        "case.toml",
        "--quiet",
        "--json",
        "r.json",
        "--csv",
        "r.csv",
        "--vtk",
        "r.vtk",
        "--figures",
        "pictures/of/it",
        "--final-state",
        "r.state",
    ]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{}", run.stderr);
    assert_eq!(bench.list(), ["case.toml", "pictures", "r.csv", "r.json", "r.state", "r.vtk"]);
    let result: Value = serde_json::from_str(&bench.read("r.json")).unwrap();
    assert_eq!(result["status"], "converged");
    assert_eq!(result["title"], "small");
    assert!(result["force"]["x"].as_f64().unwrap() < 0.0, "braking has a negative force");
    assert!(bench.read("r.csv").lines().count() > 20);
    let figures: Vec<_> = std::fs::read_dir(bench.path("pictures/of/it")).unwrap().collect();
    assert!(figures.len() >= 2);
}

#[cfg(unix)]
#[test]
fn files_are_as_readable_as_any_other() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    bench.run(&["solve", "case.toml", "--quiet", "--json", "r.json"]);
    let mode = |name: &str| std::fs::metadata(bench.path(name)).unwrap().permissions().mode();
    assert_eq!(mode("r.json"), mode("case.toml"));
}

#[test]
fn json_on_standard_output_stands_alone() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let run = bench.run(&["solve", "case.toml", "--json", "-"]);
    assert_eq!(run.code, Some(0));
    let result: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(result["kinematics"]["creepage_x"], 0.002);
}

#[test]
fn overrides_change_the_result() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let load = |overrides: &[&str]| {
        let mut arguments = vec!["solve", "case.toml", "--json", "-"];
        arguments.extend(overrides.iter().flat_map(|text| ["--set", text]));
        let result: Value = serde_json::from_str(&bench.run(&arguments).stdout).unwrap();
        result["normal"]["load"].as_f64().unwrap()
    };
    assert!((load(&[]) - 80e3).abs() < 1e-6);
    assert!((load(&["normal.load=60 kN"]) - 60e3).abs() < 1e-6);
    assert!((load(&["normal.load=\"70 kN\""]) - 70e3).abs() < 1e-6);
}

/// Creepages at the origin of the file: the result says so, has them and the moment for both
/// points, and the patch's own creepages in another run give the same forces. By hand: ξ' = ξ − φ
/// y0, Mz' = Mz − (x0 Fy − y0 Fx).
#[test]
fn creepages_at_the_origin_of_the_file() {
    let bench = Bench::new();
    let cases = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/");
    for name in ["worn_profile.toml", "worn_profile.csv"] {
        bench.write(name, &std::fs::read_to_string(format!("{cases}{name}")).unwrap());
    }
    let solve = |overrides: &[&str]| -> Value {
        let mut arguments = vec!["solve", "worn_profile.toml", "--json", "-"];
        arguments.extend(["--set", "grid.cells_x=12", "--set", "grid.cells_y=12"]);
        arguments.extend(["--set", "normal.cells=48", "--set", "solver.tolerance=1e-9"]);
        arguments.extend(overrides.iter().flat_map(|text| ["--set", text]));
        serde_json::from_str(&bench.run(&arguments).stdout).unwrap()
    };
    let number = |value: &Value| value.as_f64().unwrap();
    let file = solve(&["kinematics.reference=file"]);
    assert_eq!(file["reference"]["point"], "file");
    assert_eq!(file["kinematics"]["creepage_x"], 0.001);
    assert_eq!(file["reference"]["file"]["moment_z"], file["force"]["moment_z"]);
    let there = &file["reference"]["patch"];
    let y0 = number(&file["normal"]["origin_y"]);
    assert!(y0 > 5e-3);
    assert!((number(&there["creepage_x"]) - (0.001 - 0.25 * y0)).abs() < 1e-12);
    let lever = y0 * number(&file["force"]["x"]);
    let moment = number(&file["force"]["moment_z"]) + lever;
    assert!((number(&there["moment_z"]) - moment).abs() < 1e-9 * lever.abs());
    let creepage = format!("kinematics.creepage_x={:e}", number(&there["creepage_x"]));
    let patch = solve(&["kinematics.reference=patch", &creepage]);
    assert_eq!(patch["reference"]["point"], "patch");
    let limit = 0.35 * number(&file["normal"]["load"]);
    for component in ["x", "y"] {
        let [one, other] = [&file, &patch].map(|result| number(&result["force"][component]));
        assert!((one - other).abs() < 1e-6 * limit, "{component}: {one} {other}");
    }
    let found = number(&patch["force"]["moment_z"]);
    assert!((found - moment).abs() < 1e-8 * limit, "{found} {moment}");
    let summary = bench.run(&["solve", "worn_profile.toml", "--set", "kinematics.reference=file"]);
    for text in ["those at the origin of the file", "at the middle of the patch"] {
        assert!(summary.stdout.contains(text), "{}", summary.stdout);
    }
}

#[test]
fn a_field_without_effect_is_among_the_warnings() {
    let bench = Bench::new();
    bench.write("case.toml", &format!("{SMALL}[heat]\nmodel = \"none\"\npartition = 0.5\n"));
    let run = bench.run(&["solve", "case.toml", "--json", "-"]);
    let result: Value = serde_json::from_str(&run.stdout).unwrap();
    assert!(
        result["warnings"][0]["text"].as_str().unwrap().contains("heat.partition has no effect")
    );
}

#[test]
fn what_did_not_converge_is_written_and_marked() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let one_step = ["--set", "solver.driver=marching", "--set", "solver.max_steps=1"];
    let run = bench.run(&[&["solve", "case.toml", "--json", "r.json"], &one_step[..]].concat());
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    assert!(run.stderr.contains("not converged"), "{}", run.stderr);
    let result: Value = serde_json::from_str(&bench.read("r.json")).unwrap();
    assert_eq!(result["status"], "not-converged");
}

#[test]
fn solving_goes_on_from_a_state() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let steps = |arguments: &[&str]| {
        let mut all = vec!["solve", "case.toml", "--json", "-", "--set", "solver.driver=marching"];
        all.extend(arguments);
        let run = bench.run(&all);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let result: Value = serde_json::from_str(&run.stdout).unwrap();
        result["work"]["steps"].as_u64().unwrap()
    };
    let from_rest = steps(&["--final-state", "s.json"]);
    let from_there = steps(&["--initial-state", "s.json"]);
    assert!(from_there < from_rest, "{from_there} of {from_rest}");
}

#[test]
fn bad_states_are_refused() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    bench.write("s.json", "{}");
    let run = bench.run(&["solve", "case.toml", "--initial-state", "s.json"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("--initial-state must be"), "{}", run.stderr);
    assert_eq!(bench.run(&["solve", "case.toml", "--initial-state", "none"]).code, Some(1));
    bench.run(&["solve", "case.toml", "-q", "--final-state", "s.json"]);
    // A state of another grid is named as such, whichever is finer.
    for cells in ["grid.cells_x=9", "grid.cells_x=6"] {
        let other = ["solve", "case.toml", "--set", cells, "--initial-state", "s.json"];
        let run = bench.run(&other);
        assert_eq!(run.code, Some(2));
        assert!(run.stderr.contains("--initial-state s.json: "), "{}", run.stderr);
        assert!(run.stderr.contains("grid"), "{}", run.stderr);
        assert!(!run.stderr.contains("element outside"), "{}", run.stderr);
    }
}

#[test]
fn the_file_system_is_asked_before_the_work() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    bench.write("file", "");
    for arguments in [
        &["--json", "file/r.json"][..],
        &["--json", "."],
        &["--csv", "file/r.csv"],
        &["--figures", "file"],
    ] {
        let mut all = vec!["solve", "case.toml"];
        all.extend(arguments);
        let run = bench.run(&all);
        assert_eq!(run.code, Some(1), "{arguments:?}: {}", run.stderr);
        let named = arguments[1].split('/').next().unwrap();
        assert!(run.stderr.contains(named), "{}", run.stderr);
        assert_eq!(run.stdout, "");
    }
    assert_eq!(bench.list(), ["case.toml", "file"]);
}

#[test]
fn no_two_outputs_share_a_file() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    for arguments in [["--json", "r", "--csv", "./r"], ["--json", "s", "--vtk", "case.toml"]] {
        let mut all = vec!["solve", "case.toml"];
        all.extend(arguments);
        let run = bench.run(&all);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        assert!(run.stderr.contains("files of its own"), "{}", run.stderr);
    }
    assert_eq!(bench.read("case.toml"), SMALL);
}

#[test]
fn inputs_are_not_overwritten() {
    const TABLE: &str =
        "x [mm],y [mm],pressure [MPa]\n-1,-1,1\n0,-1,1\n1,-1,1\n-1,1,1\n0,1,1\n1,1,1\n";
    let bench = Bench::new();
    bench.write("off.csv", TABLE);
    bench.write("off.toml", "[normal]\nmodel = \"tabulated\"\nfile = \"off.csv\"\n");
    let run = bench.run(&["solve", "off.toml", "--csv", "off.csv"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("off.csv is also that of normal.file"), "{}", run.stderr);
    assert_eq!(bench.read("off.csv"), TABLE);

    bench.write("case.toml", SMALL);
    bench.write("h.csv", "time [s],creepage_x\n0,0\n0.0001,0.001\n");
    bench.write("h.toml", &format!("{SMALL}[history]\nfile = \"h.csv\"\n"));
    assert_eq!(bench.run(&["solve", "h.toml", "--vtk", "./h.csv"]).code, Some(2));
    bench.run(&["solve", "case.toml", "-q", "--final-state", "s.json"]);
    let again = ["solve", "case.toml", "-q", "--initial-state", "s.json"];
    assert_eq!(bench.run(&[&again[..], &["--json", "s.json"]].concat()).code, Some(2));
    let run = bench.run(&[&again[..], &["--final-state", "s.json"]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

#[test]
fn figures_do_not_share_a_place_with_other_outputs() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    std::fs::create_dir_all(bench.path("full/map_slip.png")).unwrap();
    std::fs::create_dir(bench.path("none")).unwrap();
    for (arguments, code) in [
        (["--json", "a", "--figures", "a"], 2),
        (["--json", "a", "--figures", "a/b"], 2),
        (["--json", "none/cut_y0.svg", "--figures", "none"], 2),
        (["--json", "r.json", "--figures", "full"], 1),
        (["--json", "r.json", "--figures", "case.toml"], 1),
        (["--json", "r.json", "--figures", "case.toml/in"], 1),
    ] {
        let run = bench.run(&[&["solve", "case.toml"], &arguments[..]].concat());
        assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.stderr);
    }
    assert_eq!(bench.list(), ["case.toml", "full", "none"]);
}

#[test]
fn only_json_knows_standard_output() {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    for option in ["--csv", "--vtk", "--final-state", "--figures"] {
        let run = bench.run(&["solve", "case.toml", option, "-"]);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        assert!(run.stderr.contains(&format!("{option} must name a ")), "{}", run.stderr);
    }
    assert_eq!(bench.list(), ["case.toml"]);
}

#[cfg(unix)]
#[test]
fn devices_stay_devices() {
    use std::os::unix::fs::FileTypeExt;
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    let run = bench.run(&["solve", "case.toml", "-q", "--json", "/dev/null", "--csv", "/dev/null"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let bench = Bench::new();
    let mut child = bench.command(&["schema"]).stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert!(child.wait().unwrap().success());
}

/// Cattaneo (1938) and Mindlin (1949) through the command: steel spheres with a = 6 mm and p0 = 1
/// GPa, μ = 0.3, shifted by 0.015 mm. CONTACT has Fx = −0.6530 μN.
#[test]
fn a_case_may_be_a_shift_at_rest() {
    let bench = Bench::new();
    bench.write(
        "shift.toml",
        "[wheel]\nyoung_modulus = \"210 GPa\"\npoisson_ratio = 0.28\n\
         [rail]\nyoung_modulus = \"210 GPa\"\npoisson_ratio = 0.28\n\
         [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"6 mm\"\n\
         peak_pressure = \"1 GPa\"\n[elasticity]\nmodel = \"half-space\"\n\
         [contact_law]\nstiffness = \"1e8 1/m\"\n[friction]\nmodel = \"constant\"\n\
         coefficient = 0.3\n[grid]\ncells_x = 40\ncells_y = 40\n\
         [history]\nshift_x = \"0.015 mm\"\n",
    );
    let outputs = ["--quiet", "--json", "-", "--figures", "f", "--history", "h.csv"];
    let run = bench.run(&[&["solve", "shift.toml"][..], &outputs].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let result: Value = serde_json::from_str(&run.stdout).unwrap();
    let force = result["normalised"]["x"].as_f64().unwrap();
    assert!((force + 0.6530).abs() < 3e-3, "{force}");
    assert_eq!(result["kinematics"]["creepage_x"], 0.0);
    assert_eq!(result["power"]["friction"], 0.0);
    assert!(result["history"]["stored_energy"][0].as_f64().unwrap() > 0.0);
    let table = bench.read("h.csv");
    let lines: Vec<&str> = table.lines().collect();
    let names: Vec<&str> = lines[1].split(',').collect();
    let mut keys: Vec<&str> =
        result["history"].as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable_by_key(|key| names.iter().position(|name| name == key));
    assert_eq!(keys, names);
    assert_eq!(lines.len() - 2, result["history"]["time"].as_array().unwrap().len());
    let fast = bench.run(&["solve", "shift.toml", "--set", "solver.method=polach"]);
    assert_eq!(fast.code, Some(2), "{}", fast.stderr);
    assert!(fast.stderr.contains("history"), "{}", fast.stderr);
    let bare = bench.run(&["solve", "shift.toml", "--set", "history.shift_x=0.015"]);
    assert!(bare.stderr.contains("history.shift_x must be a length"), "{}", bare.stderr);
}

/// Full sliding of a layer that flows: Fx = −∫ min(μ p, τ_c) dA. With p0 = 1 GPa, μ = 0.6 and τ_c =
/// 400 MPa, p = p0 √(1 − s²) exceeds τ_c/μ up to s² = 5/9, so Fx = −πab (τ_c s² + ⅔ μ p0 (1 −
/// s²)^(3/2)). FASTSIM has it with the ellipsoid, which is its bound unless given.
#[test]
fn fastsim_bounds_a_layer_by_the_pressure() {
    let bench = Bench::new();
    bench.write(
        "layer.toml",
        "[kinematics]\ncreepage_x = 0.3\n[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\n\
         semi_axis_y = \"5 mm\"\npeak_pressure = \"1 GPa\"\n[elasticity]\nmodel = \"half-space\"\n\
         [contact_law]\nmodel = \"coulomb\"\n[friction]\nmodel = \"constant\"\n\
         coefficient = 0.6\n[heat]\nmodel = \"none\"\n[grid]\ncells_x = 40\ncells_y = 40\n\
         [layer]\nthickness = \"1 mm\"\nshear_modulus = \"8000 MPa\"\nyield_stress = \"400 MPa\"\n",
    );
    let flowing = 5.0 / 9.0;
    let mean = 400e6 * flowing + 2.0 / 3.0 * 0.6e9 * (1.0_f64 - flowing).powf(1.5);
    let expected = -std::f64::consts::PI * 6e-3 * 5e-3 * mean;
    for method in ["full", "fastsim"] {
        let set = format!("solver.method={method}");
        let run = bench.run(&["solve", "layer.toml", "--json", "-", "--set", &set]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let result: Value = serde_json::from_str(&run.stdout).unwrap();
        let force = result["force"]["x"].as_f64().unwrap();
        assert!((force / expected - 1.0).abs() < 5e-3, "{method}: {force} {expected}");
    }
    let bound = ["--set", "fastsim.bound=parabolic"];
    let fastsim = ["solve", "layer.toml", "--set", "solver.method=fastsim"];
    let run = bench.run(&[&fastsim[..], &bound].concat());
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    for part in ["--set fastsim.bound=parabolic", "must be \"elliptic\" with layer.yield_stress"] {
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
}
