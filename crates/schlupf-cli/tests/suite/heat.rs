//! Heat from a case file to the result: rail chill, sliding, the heat of each body, and `schlupf
//! bulk`.

use crate::support::{Bench, Run};
use serde_json::Value;

/// The full slide of Ertz and Knothe 2002 on rigid bodies, half of the heat to each, or rolling
/// without sliding.
fn case(creepage: f64, bulk: [f64; 2]) -> String {
    let [wheel, rail] = bulk;
    format!(
        "[kinematics]\nspeed = \"30 m/s\"\ncreepage_x = {creepage}\n\
         [wheel]\nbulk_temperature = \"{wheel} degC\"\n[rail]\nbulk_temperature = \"{rail} degC\"\n\
         [normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"5.88 mm\"\nsemi_axis_y = \"10.54 mm\"\nload = \"100 kN\"\n\
         [elasticity]\nmodel = \"rigid\"\n[friction]\nmodel = \"constant\"\ncoefficient = 0.3\n\
         [heat]\npartition = 0.5\n[grid]\ncells_x = 60\ncells_y = 41\n"
    )
}

fn solve(text: &str) -> Value {
    let bench = Bench::new();
    bench.write("case.toml", text);
    let run = bench.run(&["solve", "case.toml", "--json", "-"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).unwrap().as_f64().unwrap()
}

/// Ertz and Knothe 2002: a wheel of 150 °C on a rail of 0 °C has 75.0 °C in the contact; sliding
/// with 1 m/s at 30 m/s adds its 150.3 K to that in both bodies.
#[test]
fn ertz_knothe_2002_rail_chill_and_sliding_add_up() {
    let rolling = solve(&case(0.0, [150.0, 0.0]));
    for side in ["max_wheel", "max_rail"] {
        assert!((number(&rolling, &format!("/temperature/{side}")) - 75.0).abs() < 1e-9);
    }
    assert!((number(&rolling, "/temperature/max_rise_wheel") + 75.0).abs() < 1e-9);
    assert!((number(&rolling, "/temperature/max_rise_rail") - 75.0).abs() < 1e-9);
    let cold = solve(&case(1.0 / 30.0, [0.0, 0.0]));
    let flash = number(&cold, "/temperature/max_rise");
    assert!((flash - 150.3).abs() < 0.3, "{flash}");
    let sliding = solve(&case(1.0 / 30.0, [150.0, 0.0]));
    for side in ["max_wheel", "max_rail"] {
        let sum = number(&sliding, &format!("/temperature/{side}"));
        assert!((sum - (75.0 + flash)).abs() < 1e-6 * flash, "{side}: {sum}");
    }
}

/// Energy: heat into the wheel plus heat into the rail is the friction power, which is μ N w here.
#[test]
fn the_heat_of_both_bodies_is_the_friction_power() {
    for partition in ["0.3", "velocity"] {
        let text = case(1.0 / 30.0, [20.0, 20.0]);
        let partition =
            if partition == "velocity" { "\"velocity\"".to_owned() } else { partition.to_owned() };
        let given = text.replace("partition = 0.5", &format!("partition = {partition}"));
        let result = solve(&given);
        let power = |name: &str| number(&result, &format!("/power/{name}"));
        let sum = power("into_wheel") + power("into_rail");
        assert!((sum - power("friction") - power("returned")).abs() < 1e-9 * sum);
        assert!((power("friction") - 30e3).abs() < 30.0, "{}", power("friction"));
        assert!((power("friction") - power("creep")).abs() < 1e-6 * sum);
    }
}

const BRAKING: &str = "title = \"braking\"\n[kinematics]\ncreepage_x = 0.01\n\
                       [grid]\ncells_x = 12\ncells_y = 12\n";
const COOLING: &str = "[cooling]\nfilm_coefficient = \"40 W/(m^2 K)\"\narea = \"1.5 m^2\"\n\
                       air_temperature = \"10 degC\"\n";

fn bulk(text: &str, arguments: &[&str]) -> (Bench, Run) {
    let bench = Bench::new();
    bench.write("case.toml", text);
    let run = bench.run(&[&["bulk", "case.toml"], arguments].concat());
    (bench, run)
}

#[test]
fn the_bulk_temperature_balances_the_heat() {
    let (bench, run) = bulk(&format!("{BRAKING}{COOLING}"), &["--json", "b.json"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    for part in
        ["braking", "bulk temp. of wheel", "J per revolution", "h A = 60 W/K", "converged: "]
    {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    let result: Value = serde_json::from_str(&bench.read("b.json")).unwrap();
    assert_eq!(result["status"], "converged");
    let of = |path: &str| number(&result, path);
    let given = of("/heat/convection") + of("/heat/conduction");
    assert!((of("/heat/frictional") - given).abs() < 2e-6 * given);
    let (wheel, air) = (of("/temperature/wheel"), of("/temperature/air"));
    assert!((of("/heat/convection") - 60.0 * (wheel - air)).abs() < 1e-9 * given);
    assert!(wheel > 25.0 && air == 10.0, "{wheel}");
    // R = 0.46 m at 0.99 · 30 m/s.
    let revolution = std::f64::consts::TAU * 0.46 / (0.99 * 30.0);
    let ratio = of("/heat_per_revolution/frictional") / of("/heat/frictional");
    assert!((ratio - revolution).abs() < 1e-12);
    let solved = bench.run(&[
        "solve",
        "case.toml",
        "--json",
        "-",
        "--set",
        &format!("wheel.bulk_temperature={wheel} degC"),
    ]);
    let solved: Value = serde_json::from_str(&solved.stdout).unwrap();
    let gap = number(&solved, "/power/into_wheel") - of("/heat/frictional");
    assert!(gap.abs() < 1e-4 * given, "{gap}");
}

#[test]
fn cooling_may_be_set_and_goes_to_standard_output() {
    let set = |value: &'static str| ["--set", value];
    let arguments = [
        &["--json", "-"][..],
        &set("cooling.film_coefficient=40 W/(m^2 K)"),
        &set("cooling.area=1.5 m^2"),
    ]
    .concat();
    let (_, run) = bulk(BRAKING, &arguments);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let result: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(number(&result, "/temperature/air"), 20.0);
}

#[test]
fn a_balance_that_is_not_found_says_so() {
    let unfound =
        ["--set", "solver.max_iterations=1", "--set", "solver.max_steps=1", "--json", "b.json"];
    let (bench, run) = bulk(&format!("{BRAKING}{COOLING}"), &unfound);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    assert!(run.stderr.contains("warning: not converged: "), "{}", run.stderr);
    assert!(run.stdout.contains("NOT CONVERGED"), "{}", run.stdout);
    assert!(bench.read("b.json").contains("\"status\": \"not-converged\""));
}

#[test]
fn what_has_no_bulk_temperature_is_refused() {
    let history = "[history]\ntime = [\"0 s\", \"1 ms\"]\ncreepage_x = [0.0, 0.001]\n";
    for (text, parts) in [
        (
            BRAKING.to_owned(),
            &[
                "case.toml: cooling.film_coefficient is missing, which the bulk temperature",
                "[cooling]",
            ][..],
        ),
        (
            format!("{BRAKING}{COOLING}[heat]\nmodel = \"none\"\n"),
            &["case.toml:12:9: heat.model: the wheel is heated by friction only", "^^^"][..],
        ),
        (
            format!("{BRAKING}{COOLING}{history}"),
            &["case.toml:12:8: history.time: the bulk temperature is that of steady rolling"][..],
        ),
        (
            format!("{BRAKING}[cooling]\nfilm_coefficient = \"40 W/(m^2 K)\"\n"),
            &["case.toml:8:20: cooling.area is missing, which cooling.film_coefficient needs"][..],
        ),
    ] {
        let (bench, run) = bulk(&text, &["--json", "b.json"]);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        for part in parts {
            assert!(run.stderr.contains(part), "{part:?} is not in\n{}", run.stderr);
        }
        assert_eq!(bench.list(), ["case.toml"]);
    }
    let (_, run) = bulk(&format!("{BRAKING}{COOLING}"), &["--json", "case.toml"]);
    assert!(run.stderr.contains("is also the case file"), "{}", run.stderr);
}
