//! Wheels on rails by the command: all contacts of `solve`, the table of `wheelset`, and what goes
//! wrong.

use crate::support::Bench;
use serde_json::Value;

const CASE: &str = "\
title = \"S1002 on 60 E1\"
[kinematics]
speed = \"20 m/s\"
[wheel]
profile = \"S1002\"
[rail]
profile = \"60E1\"
cant = 0.025
[normal]
model = \"wheel-rail\"
load = \"20 kN\"
[elasticity]
model = \"half-space\"
[friction]
model = \"constant\"
coefficient = 0.3
[grid]
cells_x = 16
cells_y = 16
[heat]
model = \"none\"
";

/// A case without elasticity has a table even where a patch on the flange is more slender than
/// those that the default layer is calibrated for.
#[test]
fn slender_patches_do_not_keep_the_table_from_being_written() {
    let bench = Bench::new();
    let text = CASE.replace("[elasticity]\nmodel = \"half-space\"\n", "");
    bench.write("case.toml", &text.replace("20 kN", "80 kN"));
    let points = ["--lateral-position", "-8..8 mm", "--points", "5", "--csv", "c.csv"];
    let run = bench.run(&[&["wheelset", "case.toml"], &points[..]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(bench.read("c.csv").lines().count() > 10);
    let layer = ["--set", "elasticity.model=elastic-layer"];
    let run = bench.run(&[&["wheelset", "case.toml"], &points[..], &layer].concat());
    assert!(run.stderr.contains("the layer is calibrated for ratios"), "{}", run.stderr);
}

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}: {value}"))
}

/// The keys of the interface: contacts with their places, angles, creepages and forces, the sum of
/// which is the force on the wheel; a running wheel centred on the track has no lateral sum left
/// and right, and the first contact is what the other keys show.
#[test]
fn solve_writes_all_contacts() {
    let bench = bench();
    let solve = |side: &str| -> Value {
        let side = format!("wheelset.side={side}");
        let run = bench.run(&["solve", "case.toml", "--set", &side, "--json", "-"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        serde_json::from_str(&run.stdout).unwrap()
    };
    let [left, right] = ["left", "right"].map(solve);
    for result in [&left, &right] {
        let contact = &result["contacts"][0];
        assert_eq!(contact["force"], result["force"]);
        assert_eq!(contact["normal"], result["normal"]);
        let (sin, cos) = number(contact, "/angle").sin_cos();
        let [normal, x, y] =
            ["/normal/load", "/force/x", "/force/y"].map(|path| number(contact, path));
        let sum = [x, normal * sin + y * cos, normal * cos - y * sin];
        for (axis, expected) in ["x", "y", "z"].into_iter().zip(sum) {
            let found = number(&result["wheel_force"], &format!("/{axis}"));
            assert!((found - expected).abs() < 1e-6 * normal, "{axis}: {found} {expected}");
        }
        assert!((number(result, "/wheel_force/z") - 20e3).abs() < 4.0);
    }
    assert!(number(&left, "/contacts/0/position/y") > 0.7);
    assert!(number(&left, "/contacts/0/angle") < 0.0);
    let of = |result: &Value, path: &str| number(result, path);
    for path in ["/wheel_force/y", "/contacts/0/angle", "/contacts/0/position/y"] {
        let [one, two] = [of(&left, path), of(&right, path)];
        assert!((one + two).abs() < 1e-4 * one.abs(), "{path}: {one} {two}");
    }
    assert!(of(&left, "/wheelset/roll_angle").abs() < 1e-6);
    let summary = bench.run(&["solve", "case.toml"]).stdout;
    assert!(summary.contains("right wheel") && summary.contains("force on the wheel"), "{summary}");
}

/// A row for each contact of each wheel; the conicity of this pair; figures.
#[test]
fn wheelset_tables_contacts_and_conicity() {
    let bench = bench();
    let run = bench.run(&[
        "wheelset",
        "case.toml",
        "--lateral-position",
        "-3..3 mm",
        "--points",
        "5",
        "--csv",
        "contacts.csv",
        "--json",
        "result.json",
        "--conicity",
        "conicity.csv",
        "--figures",
        "figures",
    ]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.contains("equivalent conicity"), "{}", run.stdout);
    let csv = bench.read("contacts.csv");
    let rows: Vec<Vec<&str>> =
        csv.lines().filter(|line| !line.starts_with('#')).map(|l| l.split(',').collect()).collect();
    assert!(rows.len() > 10, "{csv}");
    let column = |name: &str| rows[0].iter().position(|cell| *cell == name).unwrap();
    let at = |row: usize, name: &str| rows[row][column(name)].parse::<f64>().unwrap();
    assert_eq!((at(1, "lateral_position"), rows[1][column("side")]), (-3e-3, "left"));
    let json: Value = serde_json::from_str(&bench.read("result.json")).unwrap();
    assert_eq!(json["positions"].as_array().unwrap().len(), 5);
    let difference = |k: usize| number(&json, &format!("/positions/{k}/rolling_radius_difference"));
    assert!(difference(4) > 0.8e-3 && (difference(0) + difference(4)).abs() < 1e-6);
    assert!(difference(2).abs() < 1e-6);
    let angle = number(&json, "/positions/0/left/contacts/0/angle");
    assert!((angle / at(1, "angle") - 1.0).abs() < 1e-15, "{angle}");
    // From 1 to 6 mm in steps of 0.1 mm, though positions end at 3 mm.
    assert_eq!(bench.read("conicity.csv").lines().count(), 2 + 51);
    let of = |name: &str| number(&json, &format!("/equivalent_conicity/{name}/20"));
    assert_eq!(of("amplitude"), 3e-3);
    // Independent computation from the arcs of the rail, without roll.
    for (name, expected) in [("equivalent_conicity", 0.1742), ("harmonic_conicity", 0.1757)] {
        assert!((of(name) - expected).abs() < 1e-3, "{name}: {}", of(name));
    }
    assert!(run.stdout.contains("EN 15302   harmonic linearisation"), "{}", run.stdout);
    // Roll adds some per cent to Δr on the tread.
    let rigid = number(&json, "/positions/4/rigid_rolling_radius_difference");
    let ratio = rigid / difference(4);
    assert!(ratio > 0.9 && ratio < 1.02, "{ratio}");
    // The profiles are symmetric.
    assert!((at(1, "rigid_rolling_radius_difference") / -rigid - 1.0).abs() < 1e-12);
    for name in ["contact_points", "rolling_radius"] {
        assert!(bench.has_figure(&format!("figures/{name}")));
    }
}

/// A position that fails is a row with its status, and the rest of the table is there: beside the
/// rail, and jammed on the flange, which names the angle and the ratio of the forces.
#[test]
fn positions_that_fail_do_not_take_the_table_with_them() {
    let bench = bench();
    let run = bench.run(&[
        "wheelset",
        "case.toml",
        "--lateral-position",
        "0..90 mm",
        "--points",
        "2",
        "--csv",
        "contacts.csv",
        "--json",
        "result.json",
        "--figures",
        "figures",
    ]);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    assert!(run.stderr.contains("at a lateral position of 90 mm: "), "{}", run.stderr);
    assert!(run.stdout.contains("failed: ") && run.stdout.contains("EN 15302"), "{}", run.stdout);
    let csv = bench.read("contacts.csv");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|cell| *cell == name).unwrap();
    let status: Vec<&str> = rows[1..].iter().map(|row| row[column("status")]).collect();
    assert_eq!(status, ["converged", "converged", "failed", "failed"]);
    let failed = &rows[4];
    let cells = ["side", "contact", "force.x", "wheel_force.z"].map(|name| failed[column(name)]);
    assert_eq!(cells, ["right", "0", "", ""]);
    let json: Value = serde_json::from_str(&bench.read("result.json")).unwrap();
    let position = &json["positions"][1];
    assert_eq!(position["status"], "failed");
    assert!(position["left"].is_null() && position["error"].is_string());
    assert!(number(&json, "/equivalent_conicity/equivalent_conicity/0") > 0.1);
    assert!(bench.has_figure("figures/contact_points"));
}

/// The conicity needs no forces: where all positions fail it is there.
#[test]
fn positions_that_all_fail_do_not_take_the_conicity_with_them() {
    let bench = bench();
    let beside = ["--lateral-position", "80..90 mm", "--points", "2", "--conicity", "k.csv"];
    let run = bench.run(&[&["wheelset", "case.toml", "--csv", "c.csv"], &beside[..]].concat());
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    assert!(run.stderr.contains("at a lateral position of 80 mm: "), "{}", run.stderr);
    assert!(bench.read("k.csv").lines().count() > 2 + 50, "{}", bench.read("k.csv"));
    assert_eq!(bench.read("c.csv").matches("failed").count(), 4);
}

/// Positions are those of the ends and the middle that were asked for, to the last digit, so that
/// nothing known up to an end is missing there.
#[test]
fn ends_and_middle_of_the_positions_are_exact() {
    let bench = bench();
    let range = ["--set", "normal.load=1 N", "--lateral-position", "-6..6 mm", "--points", "7"];
    bench.run(&[&["wheelset", "case.toml", "--json", "result.json"], &range[..]].concat());
    let json: Value = serde_json::from_str(&bench.read("result.json")).unwrap();
    let at = |k: usize, name: &str| number(&json, &format!("/positions/{k}/{name}"));
    assert_eq!([0, 3, 6].map(|k| at(k, "lateral_position")), [-6e-3, 0.0, 6e-3]);
    let [left, right] = [0, 6].map(|k| at(k, "rigid_rolling_radius_difference"));
    assert!((left + right).abs() < 1e-9, "{left} {right}");
}

/// Warnings of many positions tell the worst of each kind, its place and how many there are. Here
/// it is that of points 0.2 mm apart under a contact of 1 N, which is no hole.
#[test]
fn warnings_of_positions_tell_the_worst() {
    let bench = bench();
    let light = ["--set", "normal.load=1 N", "--lateral-position", "0..4 mm", "--points", "3"];
    let run = bench.run(&[&["wheelset", "case.toml"], &light[..]].concat());
    let lines = || run.stderr.lines().filter(|line| line.contains("too coarse for a contact"));
    assert!(lines().any(|line| line.contains(", the worst of ")), "{}", run.stderr);
    assert!(lines().count() <= 2 && !run.stderr.contains("no points between"), "{}", run.stderr);
}

/// What is wrong is told before the work, with where it stands.
#[test]
fn wrong_wheelsets_are_refused() {
    let bench = bench();
    bench.write("plain.toml", "[normal]\nload = \"80 kN\"\n");
    for (arguments, expected) in [
        (&["wheelset", "plain.toml"][..], "normal.model must be \"wheel-rail\" for the contacts"),
        (
            &["wheelset", "case.toml", "--lateral-position", "3..3 mm"],
            "the end of the range must differ from its start",
        ),
        (&["wheelset", "case.toml", "--lateral-position", "0..3 kN"], "--lateral-position"),
        (
            &["wheelset", "case.toml", "--set", "track.gauge=1 m"],
            "error: case.toml: at a lateral position of -8 mm: wheelset.lateral_position: the wheel is \
             beside",
        ),
        (
            &["solve", "case.toml", "--set", "wheelset.lateral_position=0.3 m"],
            "the wheel is beside the rail",
        ),
        (&["solve", "case.toml", "--set", "normal.load="], "normal.load is missing"),
    ] {
        let run = bench.run(arguments);
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(expected), "{arguments:?}: {}", run.stderr);
    }
    let run = bench.run(&["solve", "case.toml", "--set", "rail.profile=none.csv"]);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    assert!(run.stderr.contains("none.csv") && run.stderr.contains("built in are \"46E1\""));
}

/// Where a wheel has two contacts, what is about the first of them says so.
#[test]
fn what_is_about_one_contact_says_so() {
    let bench = bench();
    let apart = [
        "wheelset.lateral_position=5 mm",
        "wheelset.side=left",
        "normal.join_distance=1 mm",
        "normal.join_angle=0.01 rad",
        "normal.load=10 kN",
    ];
    let set: Vec<&str> = apart.iter().flat_map(|field| ["--set", *field]).collect();
    let run = |command: &str| bench.run(&[&[command, "case.toml"], set.as_slice()].concat());
    let said = "the wheel has 2 contacts, and this is about the first of them, which carries 60 %";
    for command in ["subsurface", "temperature", "compare"] {
        let found = run(command);
        assert!(found.stderr.contains(said), "{command}: {}", found.stderr);
    }
    assert!(!run("solve").stderr.contains("is about the first"));
    // A study and the damage of a run have both contacts.
    let fields = "\n[wheelset]\nlateral_position = \"5 mm\"\nside = \"left\"\n";
    let joined = "\njoin_distance = \"1 mm\"\njoin_angle = \"0.01 rad\"\n";
    let case = CASE.replace("load = \"20 kN\"\n", &format!("load = \"10 kN\"{joined}"));
    bench.write("two.toml", &format!("{case}{fields}"));
    bench.write("run.csv", "distance [m],kinematics.speed [m/s]\n0,20\n10,20.5\n");
    bench.write("study.toml", "case = \"two.toml\"\n[states]\nfile = \"run.csv\"\n");
    let sweep = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(sweep.code, Some(0), "{}", sweep.stderr);
    let table = bench.read("table.csv");
    let names = table.lines().find(|line| line.starts_with("index,")).unwrap();
    let place = names.split(',').position(|name| name == "contact_2.normal.load").unwrap();
    let second = table.lines().last().unwrap().split(',').nth(place).unwrap();
    assert!(second.parse::<f64>().unwrap() > 3e3, "{second}");
    let damage = bench.run(&["damage", "table.csv"]);
    assert_eq!(damage.code, Some(0), "{}", damage.stderr);
    assert!(!damage.stderr.contains("more-contacts"), "{}", damage.stderr);
}
