//! The commands that do not solve, from the outside.

mod support;

use serde_json::Value;
use support::Bench;

#[test]
fn init_writes_the_default_case_once() {
    let bench = Bench::new();
    assert_eq!(bench.run(&["init"]).code, Some(0));
    let text = bench.read("case.toml");
    assert!(text.contains("[kinematics]"));
    bench.write("case.toml", "");
    let run = bench.run(&["init"]);
    assert_eq!(run.code, Some(1));
    assert!(run.stderr.contains("--force"), "{}", run.stderr);
    assert_eq!(bench.read("case.toml"), "");
    assert_eq!(bench.run(&["init", "--force"]).code, Some(0));
    assert_eq!(bench.read("case.toml"), text);
    assert_eq!(bench.run(&["init", "-"]).stdout, text);
    assert_eq!(bench.run(&["init", "no/such/case.toml"]).code, Some(1));
    assert_eq!(bench.list(), ["case.toml"]);
}

#[test]
fn check_says_what_it_would_solve() {
    let bench = Bench::new();
    bench.run(&["init"]);
    let run = bench.run(&["check", "case.toml", "--set", "normal.load=60 kN"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    for part in
        ["steel wheel", "load 60.0000 kN", "24 x 24", "kinematics.speed", "\"60 kN\"  (--set)"]
    {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    assert_eq!(bench.list(), ["case.toml"]);
}

#[test]
fn check_shows_the_creepages_of_a_moving_wheel() {
    let bench = Bench::new();
    bench.write("case.toml", "[kinematics]\nspeed = \"30 m/s\"\nyaw_angle = \"1 deg\"\n");
    let stdout = bench.run(&["check", "case.toml"]).stdout;
    assert!(stdout.contains("ξ = 0.000000, η = -0.017452"), "{stdout}");
}

#[test]
fn the_schema_is_json() {
    let schema: Value = serde_json::from_str(&Bench::new().run(&["schema"]).stdout).unwrap();
    assert_eq!(schema["properties"]["grid"]["properties"]["cells_x"]["maximum"], 1024.0);
}

#[test]
fn completions_name_the_commands() {
    let script = Bench::new().run(&["completions", "bash"]).stdout;
    assert!(script.contains("solve") && script.contains("--initial-state"));
}

#[test]
fn help_lists_the_exit_codes() {
    let run = Bench::new().run(&["solve", "--help"]);
    assert_eq!(run.code, Some(0));
    assert!(run.stdout.contains("3  not converged"), "{}", run.stdout);
    assert_eq!(Bench::new().run(&[]).code, Some(2));
}
