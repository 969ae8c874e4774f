//! Forces in place of creepages from the outside: every command that solves steady rolling takes
//! them, and bad combinations are named with their places.

use crate::support::{Bench, Run};
use serde_json::Value;

/// Braking with 20 kN of 80 kN, free sideways in spite of spin, Coulomb's law on the half-space.
const CASE: &str = "\
[kinematics]
force_x = \"-20 kN\"
force_y = \"0 kN\"
spin = \"0.3 1/m\"
[elasticity]
model = \"half-space\"
[contact_law]
model = \"coulomb\"
[friction]
model = \"constant\"
coefficient = 0.4
[grid]
cells_x = 16
cells_y = 16
";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    bench
}

fn solve(bench: &Bench, settings: &[&str]) -> Run {
    let settings = settings.iter().flat_map(|setting| ["--set", setting]);
    let arguments: Vec<&str> =
        ["solve", "case.toml", "--quiet", "--json", "-"].into_iter().chain(settings).collect();
    bench.run(&arguments)
}

fn solved(bench: &Bench, settings: &[&str]) -> Value {
    let run = solve(bench, settings);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value, path: &[&str]) -> f64 {
    path.iter().fold(value, |value, key| &value[*key]).as_f64().unwrap()
}

/// The creepages that were found are in `kinematics`, and have the forces when they are given.
#[test]
fn creepages_that_were_found_have_the_forces() {
    let bench = bench();
    let found = solved(&bench, &[]);
    assert!((number(&found, &["force", "x"]) + 20e3).abs() < 1.0);
    assert!(number(&found, &["force", "y"]).abs() < 1.0);
    let [x, y] = ["creepage_x", "creepage_y"].map(|key| number(&found, &["kinematics", key]));
    assert!(x > 0.0 && y < 0.0, "{x} {y}");
    let given = [
        "kinematics.force_x=".to_owned(),
        "kinematics.force_y=".to_owned(),
        format!("kinematics.creepage_x={x}"),
        format!("kinematics.creepage_y={y}"),
    ];
    let again = solved(&bench, &given.each_ref().map(String::as_str));
    assert!((number(&again, &["force", "x"]) + 20e3).abs() < 2.0);
    assert!(number(&again, &["force", "y"]).abs() < 2.0);
    // A traction coefficient and a torque that say the same.
    for other in ["traction_coefficient=0.25", "wheel_torque=-9.2 kN m"] {
        let other = format!("kinematics.{other}");
        let settings = ["kinematics.force_x=", "kinematics.wheel_radius=0.46 m", other.as_str()];
        let skipped = usize::from(!other.contains("torque"));
        let settings =
            if skipped == 1 { vec![settings[0], settings[2]] } else { settings.to_vec() };
        let same = solved(&bench, &settings);
        assert!((number(&same, &["kinematics", "creepage_x"]) / x - 1.0).abs() < 1e-6);
    }
}

/// A study over forces is creepage over force; a curve over a creepage counts instead of its force,
/// and keeps the other one at every point; each method of a comparison finds its own creepages.
#[test]
fn studies_curves_and_comparisons_take_forces() {
    let bench = bench();
    let study = "case = \"case.toml\"\n[vary]\n\
        \"kinematics.force_x\" = [\"-5 kN\", \"-15 kN\", \"-25 kN\"]\n";
    bench.write("study.toml", study);
    let run = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let table = bench.read("table.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    let head = reader.headers().unwrap().clone();
    let place = |name: &str| head.iter().position(|head| head == name).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let column = |name: &str| -> Vec<f64> {
        rows.iter().map(|row| row[place(name)].parse().unwrap()).collect()
    };
    let (force, creepage) = (column("force.x"), column("kinematics.creepage_x"));
    for (force, wanted) in force.iter().zip([-5e3, -15e3, -25e3]) {
        assert!((force - wanted).abs() < 1.0);
    }
    assert!(creepage[0] > 0.0 && creepage[1] > 3.0 * creepage[0] && creepage[2] > creepage[1]);

    let range = ["--creepage-x", "0..0.01", "--points", "5", "--json", "-"];
    let run = bench.run(&[&["curve", "case.toml", "--quiet"][..], &range].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let curve: Value = serde_json::from_str(&run.stdout).unwrap();
    let text = curve.to_string();
    assert!(text.contains("\"initial_slope\":null"), "{text}");

    let run = bench.run(&["compare", "case.toml", "--json", "-"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let compared: Value = serde_json::from_str(&run.stdout).unwrap();
    let methods = compared["methods"].as_array().unwrap();
    for name in ["full", "fastsim", "polach", "shen-hedrick-elkins"] {
        let method = methods.iter().find(|method| method["method"] == name).unwrap();
        assert!((number(method, &["force", "x"]) + 20e3).abs() < 1.0, "{method}");
    }
}

/// Contradictions name both fields and their places; what cannot be is refused with a reason.
#[test]
fn bad_combinations_are_named() {
    let bench = bench();
    for (settings, words) in [
        (
            vec!["kinematics.creepage_x=0.001"],
            vec!["kinematics.creepage_x", "kinematics.force_x", "case.toml:2:11"],
        ),
        (vec!["kinematics.traction_coefficient=0.1"], vec!["traction_coefficient", "force_x"]),
        (vec!["kinematics.wheel_torque=1 kN m"], vec!["wheel_torque", "force_x"]),
        (vec!["kinematics.angular_velocity=60 rad/s"], vec!["angular_velocity", "force_x"]),
        (vec!["kinematics.yaw_angle=1 mrad"], vec!["yaw_angle", "force_y"]),
        (vec!["kinematics.moment_z=1 N m"], vec!["moment_z", "kinematics.spin"]),
        (vec!["kinematics.force_x=-20"], vec!["force with its unit", "-20 N"]),
        (
            vec!["kinematics.force_x=-33 kN"],
            vec!["kinematics.force_x cannot be -33000 N", "largest is -32000 N"],
        ),
        (
            vec!["kinematics.force_x=", "kinematics.traction_coefficient=0.45"],
            vec!["kinematics.traction_coefficient cannot be 0.45", "largest is 0.4"],
        ),
    ] {
        let run = solve(&bench, &settings);
        assert_eq!(run.code, Some(2), "{settings:?}: {}", run.stderr);
        for word in words {
            assert!(run.stderr.contains(word), "{settings:?}, {word}: {}", run.stderr);
        }
    }
    let profiles = "[kinematics]\nforce_y = \"-5 kN\"\n[normal]\nmodel = \"wheel-rail\"\n\
        load = \"60 kN\"\n[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\n";
    bench.write("case.toml", profiles);
    let run = solve(&bench, &[]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("kinematics.force_y must be left out"), "{}", run.stderr);
}

/// Forces over time, in the case and in a file, end at the creepage of steady rolling; a file must
/// not have the creepage of a force as well.
#[test]
fn forces_over_time() {
    let bench = bench();
    let steady = number(&solved(&bench, &[]), &["kinematics", "creepage_x"]);
    let without = CASE.replace("force_x = \"-20 kN\"\n", "");
    let history = "[history]\ntime = [\"0 s\", \"0.5 ms\", \"4 ms\"]\n\
        force_x = [\"0 kN\", \"-20 kN\", \"-20 kN\"]\n";
    bench.write("case.toml", &format!("{without}{history}"));
    let ramp = solved(&bench, &[]);
    assert!((number(&ramp, &["kinematics", "creepage_x"]) / steady - 1.0).abs() < 1e-3);
    bench.write("h.csv", "time [ms],force_x [kN]\n0,0\n0.5,-20\n4,-20\n");
    bench.write("case.toml", &format!("{without}[history]\nfile = \"h.csv\"\n"));
    let of_file = solved(&bench, &[]);
    assert_eq!(of_file["force"], ramp["force"]);
    bench.write("h.csv", "time [ms],force_x [kN],creepage_x\n0,0,0\n4,-20,0.001\n");
    let run = solve(&bench, &[]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("the force determines the creepage"), "{}", run.stderr);
}
