//! `schlupf curve` from the outside: outputs, families, errors and exit codes.

use crate::support::{Bench, Run};
use serde_json::Value;

/// A case that takes no time.
const SMALL: &str = "title = \"small\"\n[kinematics]\ncreepage_x = 0.002\n\
                     [grid]\ncells_x = 8\ncells_y = 6\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", SMALL);
    bench
}

fn curve(bench: &Bench, arguments: &[&str]) -> Run {
    bench.run(&[&["curve", "case.toml", "--points", "9"], arguments].concat())
}

fn document(bench: &Bench, arguments: &[&str]) -> Value {
    let run = curve(bench, &[&["--json", "-"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

#[test]
fn every_output_is_written() {
    let bench = bench();
    let run = curve(
        &bench,
        &["--creepage-x", "0..0.05", "--json", "c.json", "--csv", "c.csv", "--figures", "in/here"],
    );
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert_eq!(bench.list(), ["c.csv", "c.json", "case.toml", "in"]);
    for part in ["small", "creepage_x", "initial slope", "maximum           |F|/N = 0.3"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    let result: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    let curve = &result["curves"][0];
    assert_eq!(curve["points"]["force_x"].as_array().unwrap().len(), 9);
    assert!(curve["initial_slope"]["force"]["x"].as_f64().unwrap() < 0.0, "braking");
    let maximum = curve["maximum"]["kinematics"]["creepage_x"].as_f64().unwrap();
    assert!(maximum > 0.005 && maximum < 0.01, "{maximum}");
    assert_eq!(bench.read("c.csv").lines().count(), 11);
    assert!(bench.has_figure("in/here/creep_curve"));
}

#[test]
fn a_family_has_a_curve_for_each_value() {
    let bench = bench();
    let family = ["--over", "kinematics.speed=10 m/s,72 km/h", "--csv", "c.csv"];
    let result = document(&bench, &[&["--creepage-x", "0..0.05", "--quiet"], &family[..]].concat());
    assert_eq!(result["over"]["field"], "kinematics.speed");
    assert_eq!(result["curves"][1]["value"], "72 km/h");
    let speeds = [0, 1].map(|k| result["curves"][k]["points"]["speed"][0].as_f64().unwrap());
    assert!((speeds[0] - 10.0).abs() + (speeds[1] - 20.0).abs() < 1e-12);
    let top = |k: usize| result["curves"][k]["maximum"]["traction_coefficient"].as_f64().unwrap();
    assert!(top(0) > top(1), "faster is hotter");
    let table = bench.read("c.csv");
    assert!(table.lines().nth(1).unwrap().starts_with("kinematics.speed,speed,creepage_x,"));
    assert_eq!(table.lines().filter(|line| line.starts_with("2e1,")).count(), 9);
}

/// Braking forces over the load at even steps; each has its creepage.
#[test]
fn creepage_over_force() {
    let bench = bench();
    let options = ["--traction-coefficient", "0..0.2", "--over", "kinematics.speed=10..30 m/s:3"];
    let files = ["--csv", "c.csv", "--figures", "f"];
    let result = document(&bench, &[&options[..], &files[..]].concat());
    assert_eq!(result["path"]["abscissa"], "force_over_load");
    assert_eq!(result["path"]["spacing"], "even");
    assert_eq!(result["map"]["x"]["name"], "force_over_load");
    let curve = &result["curves"][2];
    assert!(curve["initial_slope"].is_null() && curve["maximum"].is_null());
    let column = |name: &str, k: usize| curve["points"][name][k].as_f64().unwrap();
    for k in 1..9 {
        let coefficient = 0.025 * k as f64;
        assert!((column("abscissa", k) - coefficient).abs() < 1e-12);
        assert!((column("traction_coefficient", k) - coefficient).abs() < 1e-5);
        assert!(column("creepage_x", k) > column("creepage_x", k - 1));
    }
    let csv = bench.read("c.csv");
    assert!(csv.lines().nth(1).unwrap().starts_with("kinematics.speed,force_over_load,speed,"));
    assert!(bench.read("f/creep_curve.svg").contains("Creepage over force"));
    assert!(bench.path("f/creep_map_creepage.svg").exists());
    assert!(!bench.path("f/creep_map.svg").exists());
}

/// Points of any distance, in either direction, of one creepage or of two in a straight line.
#[test]
fn points_are_each_given() {
    let bench = bench();
    let document = |arguments: &[&str]| {
        let run = bench.run(&[&["curve", "case.toml", "--json", "-"], arguments].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        serde_json::from_str::<Value>(&run.stdout).unwrap()
    };
    let result = document(&["--creepage-x", "0.02,0.003,0,-0.001"]);
    assert_eq!(result["path"]["spacing"], "given");
    assert_eq!((&result["path"]["points"], &result["path"]["end"]), (&4.into(), &(-0.001).into()));
    let points = &result["curves"][0]["points"];
    assert_eq!(points["creepage_x"], serde_json::json!([0.02, 0.003, 0.0, -0.001]));
    assert!(points["force_x"][0].as_f64() < points["force_x"][1].as_f64());
    let result = document(&["--spin", "0,0.1,1 1/m", "--creepage-x", "0..0.01"]);
    let points = &result["curves"][0]["points"];
    let near = |name: &str, expected: f64| (points[name][1].as_f64().unwrap() - expected).abs();
    assert!(near("creepage_x", 0.001) < 1e-15 && near("spin", 0.1) < 1e-15);
    let lines = ["--creepage-x", "0,0.001,0.01", "--creepage-y", "0,0.002,0.02"];
    let points = &document(&lines)["curves"][0]["points"];
    assert!((points["creepage_y"][1].as_f64().unwrap() - 0.002).abs() < 1e-15);
    let forces = document(&["--force-x", "0,-1,-10 kN"]);
    assert_eq!(forces["curves"][0]["points"]["abscissa"][1], -1e3);
}

/// Whatever the case says of the direction of the force counts for nothing.
#[test]
fn a_force_varies_in_place_of_the_motion_of_the_case() {
    let bench = bench();
    let of = |motion: &str| {
        bench.write("case.toml", &SMALL.replace("creepage_x = 0.002", motion));
        let result = document(&bench, &["--force-x", "0..-10 kN"]);
        result["curves"][0]["points"]["creepage_x"][8].as_f64().unwrap()
    };
    let found = of("creepage_x = 0.03");
    assert!(found > 0.0 && found < 0.01, "{found}");
    assert_eq!(found, of("force_x = \"-5 kN\""));
}

/// Two fields: curves of all pairs, each like the one alone, and maps of the largest forces.
#[test]
fn two_fields_make_a_map() {
    let bench = bench();
    let speeds = ["--over", "kinematics.speed=10..30 m/s:3"];
    let loads = ["--over", "normal.load=60..80 kN:2", "--figures", "f"];
    let range = ["--creepage-x", "0..0.05", "--quiet"];
    let result = document(&bench, &[&range[..], &speeds, &loads].concat());
    let map = &result["map"];
    assert_eq!(map["x"]["values"], serde_json::json!([10.0, 20.0, 30.0]));
    assert_eq!(map["y"]["values"], serde_json::json!([60e3, 80e3]));
    let alone = ["--set", "kinematics.speed=30 m/s", "--set", "normal.load=60 kN"];
    let alone = document(&bench, &[&range[..], &alone].concat());
    let largest = alone["curves"][0]["maximum"]["traction_coefficient"].as_f64().unwrap();
    let found = map["columns"]["traction_coefficient"]["values"][0][2].as_f64().unwrap();
    assert!((found - largest).abs() < 1e-5 * largest, "{found} {largest}");
    assert!(bench.has_figure("f/creep_map") && bench.has_figure("f/creep_map_creepage"));
    assert!(!bench.path("f/creep_curve.svg").exists());
    // Over one field only, maps of two are gone.
    let one = document(&bench, &[&range[..], &speeds, &["--figures", "f"]].concat());
    assert_eq!(one["map"]["x"]["name"], "creepage_x");
    assert!(bench.path("f/creep_curve.svg").exists());
    assert!(bench.path("f/creep_map_temperature.svg").exists());
    assert!(!bench.path("f/creep_map_creepage.svg").exists());
}

#[test]
fn other_creepages_are_kept_and_several_vary_together() {
    let bench = bench();
    let result = document(&bench, &["--creepage-y", "-0.01..0.01"]);
    let points = &result["curves"][0]["points"];
    assert_eq!(points["creepage_x"][0], 0.002);
    assert_eq!(points["creepage_y"][8], 0.01);
    assert!(result["curves"][0]["initial_slope"]["kalker"].is_null(), "something slides already");
    let result =
        document(&bench, &["--creepage-x", "0..0.01", "--spin", "0..0.5 1/m", "--spacing", "even"]);
    let points = &result["curves"][0]["points"];
    assert_eq!((&points["creepage_x"][4], &points["spin"][4]), (&0.005.into(), &0.25.into()));
    let result = document(&bench, &["--creepage", "0..0.01", "--direction", "90deg"]);
    let points = &result["curves"][0]["points"];
    assert_eq!((&points["creepage_x"][8], &points["creepage_y"][8]), (&0.0.into(), &0.01.into()));
    let forces = document(&bench, &["--spin", "-1..1 1/m", "--set", "kinematics.creepage_x=0"]);
    let moments = &forces["curves"][0]["points"]["moment_z"];
    assert!(moments[0].as_f64().unwrap() > 0.0 && moments[8].as_f64().unwrap() < 0.0);
}

#[test]
fn what_did_not_converge_is_written_and_marked() {
    let bench = bench();
    let one_step = ["--set", "solver.driver=marching", "--set", "solver.max_steps=1"];
    let files = ["--creepage-x", "0..0.01", "--json", "c.json", "--figures", "f"];
    let run = curve(&bench, &[&files[..], &one_step].concat());
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    let expected = "warning: not converged: 9 of 9 points, at kinematics.creepage_x = 0, 8.98199e-5, 0.000215883, ";
    assert!(run.stderr.starts_with(expected), "{}", run.stderr);
    assert!(run.stdout.contains("NOT CONVERGED"), "{}", run.stdout);
    let result: Value = serde_json::from_str(&bench.read("c.json")).unwrap();
    assert_eq!(result["curves"][0]["points"]["status"][0], "not-converged");
    assert_eq!(result["curves"][0]["points"]["status"][1], "not-converged");
    assert!(result["curves"][0]["maximum"].is_null());
    assert!(bench.read("f/creep_curve.svg").contains("not converged at some points"));
}

/// Arguments after `curve case.toml`, parts of the report.
const BAD: &[(&[&str], &[&str])] = &[
    (&[], &["required", "<--creepage-x <START..END|VALUE,…>|--creepage-y <START"]),
    (&["--creepage-x", "0.05"], &["--creepage-x must be a range, such as 0..0.05,", "\"0.05\""]),
    (&["--creepage-x", "0,0.2,0.1"], &["from each to the next, but 0.1 follows 0.2"]),
    (
        &["--creepage-x", "0,0.1", "--points", "9"],
        &["--points must be left out where --creepage-x gives each point"],
    ),
    (&["--creepage-x", "0.05..0.05"], &["must differ from its start, but both are 0.05"]),
    (&["--creepage-x", "0..nan"], &["--creepage-x 0..nan: the end", "finite", "NaN"]),
    (&["--creepage-x", "0..1 m"], &["a number without unit", "\"1 m\""]),
    (&["--spin", "0..2"], &["the unit is missing", "1/m"]),
    (&["--spin", "0 1/m..2 m"], &["`m` is the unit of a length"]),
    (
        &["--creepage-x", "0..1.5"],
        &["--creepage-x 0..1.5", "the wheel must roll", "does not at kinematics.creepage_x = 1"],
    ),
    (
        &["--creepage", "0..2", "--direction", "0 deg"],
        &["--creepage 0..2 --direction 0 deg", "does not at creepage = 1"],
    ),
    (&["--creepage", "0..0.1"], &["required", "--direction <ANGLE>"]),
    (
        &["--creepage-x", "0..0.1", "--direction", "3 deg"],
        &["required", "--creepage <START..END|VALUE,…>"],
    ),
    (
        &["--force-x", "0..-40 kN", "--over", "normal.load=60 kN,70 kN"],
        &["--force-x 0..-40 kN with normal.load = 60 kN: kinematics.force_x cannot be"],
    ),
    (
        &["--creepage", "0..0.1", "--direction", "30"],
        &["--direction must be an angle", "\"30\"", "such as 30 deg"],
    ),
    (&["--creepage", "0..0.1", "--creepage-x", "0..1"], &["cannot be used with"]),
    (&["--creepage-x", "0..0.1", "--points", "1"], &["--points must be a whole number between 2"]),
    (&["--creepage-x", "0..0.1", "--spacing", "odd"], &["refined, even"]),
    (&["--creepage-x", "0..0.1", "--over", "speed"], &["section.field=value,value,…"]),
    (
        &["--creepage-x", "0..0.1", "--over", "kinematics.sped=1 m/s"],
        &["did you mean `kinematics.speed`?"],
    ),
    (
        &["--creepage-x", "0..0.1", "--over", "kinematics.speed=10 m/s,20 kN,-1 m/s"],
        &["--over kinematics.speed=20 kN: ", "--over kinematics.speed=-1 m/s: "],
    ),
    (
        &["--creepage-x", "0..0.1", "--over", "kinematics.creepage_x=0,1"],
        &["--over must not vary kinematics.creepage_x", "--creepage-x"],
    ),
    (
        &["--creepage-y", "0..0.1", "--over", "kinematics.yaw_angle=0 deg,1 deg"],
        &["--over must not vary kinematics.yaw_angle", "--creepage-y"],
    ),
    (
        &["--creepage-y", "0..0.9", "--over", "kinematics.creepage_x=0,0.5"],
        &["--creepage-y 0..0.9", "does not at kinematics.creepage_y = 0.866025"],
    ),
    (
        &["--creepage-x", "0..0.1", "--set", "heat.model=none", "--over", "heat.partition=0.3,0.5"],
        &["--over heat.partition=0.3: heat.partition must have an effect", "none with heat.model"],
    ),
    (
        &["--creepage-x", "0..0.1", "--over", "normal.load=80 kN,80000 N"],
        &["the values of normal.load must differ, but \"80 kN\" and \"80000 N\" are equal"],
    ),
    (
        &["--creepage-x", "0..0.1", "--csv", "p.csv", "--over", "normal.file=p.csv,q.csv"],
        &["--csv must write files of its own, but p.csv is also that of --over"],
    ),
    (
        &["--creepage-x", "0..0.1", "--over", "kinematics.speed=10..20"],
        &["--over 10..20: the end of the range must be a speed", "the unit is missing"],
    ),
    (
        &["--creepage-x", "0..0.1", "--over", "kinematics.speed=10..20 m/s:1"],
        &["the number of values after `:` must be a whole number between 2 and 1000"],
    ),
    (
        &["--creepage-x", "0..0.1", "--over", "normal.load=1..2 kN", "--over", "normal.load=3 kN"],
        &["--over must vary two different fields, not normal.load twice"],
    ),
    (
        &[
            "--creepage-x",
            "0..0.1",
            "--over",
            "normal.load=1..2 kN:2",
            "--over",
            "friction.model=constant,temperature-linear",
        ],
        &["both must be numbers, but friction.model is none"],
    ),
    (&["--force-x", "0..-10"], &["--force-x 0..-10: ", "unit is missing", "or \"0..-10 kN\""]),
    (&["--force-x", "0..1 kN", "--spin", "0..1 1/m"], &["cannot be used with"]),
    (&["--force-x", "0..1 kN", "--force-y", "0..1 kN"], &["cannot be used with"]),
    (&["--moment-z", "1..1 N m"], &["must differ from its start, but both are 1 N m"]),
    (
        &["--traction-coefficient", "0..0.9"],
        &["--traction-coefficient 0..0.9: kinematics.traction_coefficient cannot be ", "largest"],
    ),
    (
        &["--force-y", "0..1 kN", "--over", "kinematics.yaw_angle=0 deg,1 deg"],
        &["--over must not vary kinematics.yaw_angle, in place of which --force-y varies"],
    ),
    (
        &[
            "--force-x",
            "0..1 kN",
            "--over",
            "normal.load=1..2 kN:2",
            "--over",
            "kinematics.speed=1..2 m/s:2",
        ],
        &["but --force-x prescribes the force"],
    ),
    (&["--creepage-x", "0..0.1", "--csv", "case.toml"], &["is also the case file"]),
    (&["--creepage-x", "0..0.1", "--csv", "-"], &["--csv must name a file"]),
];

#[test]
fn bad_input_is_reported_and_nothing_is_written() {
    for (arguments, parts) in BAD {
        let bench = bench();
        let outputs = ["curve", "case.toml", "--json", "c.json", "--figures", "f"];
        let run = bench.run(&[&outputs, *arguments].concat());
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        assert_eq!(run.stdout, "");
        for part in *parts {
            assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
        }
        assert_eq!(bench.list(), ["case.toml"]);
    }
}

#[test]
fn a_history_has_no_creep_curve() {
    let bench = bench();
    let history = "[history]\ntime = [\"0 s\", \"1 ms\"]\ncreepage_x = [0.0, 0.001]\n";
    bench.write("case.toml", &format!("{SMALL}{history}"));
    let run = curve(&bench, &["--creepage-x", "0..0.01"]);
    assert_eq!(run.code, Some(2));
    for part in ["case.toml:8:8: history.time: a creep curve is of steady rolling", "^^^"] {
        assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
    }
}

#[test]
fn the_file_system_is_asked_before_the_work() {
    let bench = bench();
    std::fs::create_dir_all(bench.path("full/creep_curve.png")).unwrap();
    for arguments in
        [["--json", "case.toml/c.json"], ["--figures", "case.toml"], ["--figures", "full"]]
    {
        let run = curve(&bench, &[&["--creepage-x", "0..0.01"], &arguments[..]].concat());
        assert_eq!(run.code, Some(1), "{arguments:?}: {}", run.stderr);
        assert_eq!(run.stdout, "");
    }
    assert_eq!(bench.list(), ["case.toml", "full"]);
}

#[test]
fn a_field_without_effect_is_among_the_warnings() {
    let bench = bench();
    let set = ["--set", "heat.model=none", "--set", "heat.partition=0.3"];
    let none = [&set[..], &["--over", "kinematics.speed=10 m/s,20 m/s"]].concat();
    let result = document(&bench, &[&["--creepage-x", "0..0.01"], &none[..]].concat());
    let warning = result["warnings"][0]["text"].as_str().unwrap();
    // It is common to all curves.
    let expected = "--set heat.partition=0.3: heat.partition has no effect";
    assert!(warning.starts_with(expected), "{warning}");
}

/// The warning of a curve was that of its first hot point; it is that of the hottest.
#[test]
fn a_warning_of_a_curve_is_that_of_its_worst_point() {
    let bench = Bench::new();
    bench.write(
        "case.toml",
        "[grid]\ncells_x = 12\ncells_y = 12\n[friction]\nmodel = \"constant\"\n",
    );
    let arguments = ["--creepage-x", "0..0.9", "--set", "kinematics.speed=100 m/s"];
    let found = document(&bench, &arguments);
    let warnings = found["warnings"].as_array().or(found["curves"][0]["warnings"].as_array());
    let texts = warnings.unwrap().iter().filter(|warning| {
        warning["code"] == "hot-surface" && warning["quantity"] == "wheel.bulk_temperature"
    });
    let texts: Vec<&str> = texts.map(|warning| warning["text"].as_str().unwrap()).collect();
    let [text] = texts[..] else { panic!("{texts:?}") };
    assert!(text.contains("kinematics.creepage_x = 0.9, the worst of "), "{text}");
}
