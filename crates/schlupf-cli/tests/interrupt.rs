//! SIGINT and SIGTERM: the command ends at once and leaves nothing behind.
#![cfg(unix)]

mod support;

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use support::{Bench, Run};

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
