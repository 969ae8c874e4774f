//! SIGINT and SIGTERM: the command ends at once and leaves nothing behind.
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{Bench, Run};

/// So long that nobody waits for it.
const LONG: [&str; 9] = [
    "curve",
    "case.toml",
    "--creepage-x",
    "0..0.1",
    "--points",
    "2000",
    "--set",
    "grid.cells_x=120",
    "--quiet",
];

fn interrupted(signal: &str) -> (Bench, Run, Duration) {
    let bench = Bench::new();
    bench.write("case.toml", "[grid]\ncells_y = 120\n");
    let outputs = ["--json", "c.json", "--csv", "c.csv", "--figures", "in/here"];
    let mut command = bench.command(&[&LONG[..], &outputs[..]].concat());
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(Duration::from_secs(2));
    let start = Instant::now();
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let run = Run::from(child.wait_with_output().unwrap());
    (bench, run, start.elapsed())
}

#[test]
fn a_command_that_is_interrupted_leaves_nothing() {
    for signal in ["-INT", "-TERM"] {
        let (bench, run, time) = interrupted(signal);
        assert_eq!(run.code, Some(130), "{signal}: {}", run.stderr);
        assert_eq!(run.stderr, "interrupted: no file was written\n");
        assert_eq!((run.stdout.as_str(), bench.list()), ("", vec!["case.toml".to_owned()]));
        assert!(time < Duration::from_secs(30), "{signal}: {time:?}");
    }
}

/// A study that is solved for its damage has a table of its own meanwhile.
#[test]
fn damage_of_a_study_that_is_interrupted_leaves_nothing() {
    let bench = Bench::new();
    bench.write("case.toml", "grid.cells_x = 120\ngrid.cells_y = 120\n");
    let states: Vec<_> = (0..2000).map(|k| format!("{k},{}", 1e-6 * f64::from(k))).collect();
    let states = states.join("\n");
    bench.write("run.csv", &format!("distance [m],kinematics.creepage_x\n{states}\n"));
    bench.write("study.toml", "case = \"case.toml\"\n[states]\nfile = \"run.csv\"\n");
    std::fs::create_dir(bench.path("tmp")).unwrap();
    let mut command = bench.command(&["damage", "study.toml", "--json", "d.json"]);
    command.env("TMPDIR", bench.path("tmp")).stderr(Stdio::piped());
    let child = command.stdout(Stdio::piped()).spawn().unwrap();
    let start = Instant::now();
    let is_empty = || std::fs::read_dir(bench.path("tmp")).unwrap().next().is_none();
    while is_empty() && start.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(50));
    }
    assert!(!is_empty(), "nothing was solved");
    std::thread::sleep(Duration::from_secs(1));
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let run = Run::from(child.wait_with_output().unwrap());
    assert_eq!((run.code, run.stderr.as_str()), (Some(130), "interrupted: no file was written\n"));
    assert!(is_empty());
    assert_eq!(bench.list(), ["case.toml", "run.csv", "study.toml", "tmp"]);
}

/// The pipe is full and nobody reads it.
#[test]
fn a_command_that_is_interrupted_while_it_prints_says_so() {
    let bench = Bench::new();
    bench.write("case.toml", "solver.method = \"polach\"\n");
    let print = ["curve", "case.toml", "--creepage-x", "0..0.1", "--points", "2000", "--json", "-"];
    let mut child =
        bench.command(&print).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(Duration::from_secs(2));
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let run = Run::from(child.wait_with_output().unwrap());
    let said = "interrupted: no file was written; standard output is incomplete\n";
    assert!(run.stderr.ends_with(said), "{}", run.stderr);
}
