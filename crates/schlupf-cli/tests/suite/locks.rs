//! Runs that take long: two on one output, and tables that were interrupted.
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{Bench, Run};
use schlupf_tasks::study::lock::OutputLock;

/// Starts a command that takes long, and waits until a file of it is there.
fn start(bench: &Bench, arguments: &[&str], file: &str) -> Child {
    let mut command = bench.command(arguments);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let start = Instant::now();
    while !bench.path(file).exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "{file} is missing");
        std::thread::sleep(Duration::from_millis(20));
    }
    child
}

fn kill(child: Child, signal: &str) -> Run {
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    Run::from(child.wait_with_output().unwrap())
}

/// As many states as nobody waits for.
fn study(bench: &Bench) {
    bench.write("case.toml", "grid.cells_x = 120\ngrid.cells_y = 120\n");
    let states: Vec<_> = (0..2000).map(|k| format!("{k},{}", 1e-6 * f64::from(k))).collect();
    let states = states.join("\n");
    bench.write("run.csv", &format!("distance [m],kinematics.creepage_x\n{states}\n"));
    bench.write("study.toml", "case = \"case.toml\"\n[states]\nfile = \"run.csv\"\n");
}

/// The second run on an output is refused, also after the first one was told to stop, and a run
/// that was killed does not keep others from it.
#[test]
fn a_second_run_on_an_output_is_refused() {
    let bench = Bench::new();
    study(&bench);
    for (arguments, output) in [
        (&["sweep", "study.toml", "--output", "s.csv"][..], "s.csv"),
        (&["damage", "study.toml", "--json", "d.json"], "d.json"),
        (&["table", "--output", "t.npz"], "t.npz"),
        (&["curve", "case.toml", "--creepage-x", "0..0.1", "--csv", "c.csv"], "c.csv"),
        (&["curve", "case.toml", "--creepage-x", "0..0.1", "--figures", "f/g"], "f/g"),
    ] {
        let path = std::path::Path::new(output);
        let name = path.file_name().unwrap().to_str().unwrap();
        let lock = path.with_file_name(format!(".{name}.lock"));
        let lock = lock.to_str().unwrap();
        let first = start(&bench, arguments, lock);
        let second = bench.run(arguments);
        assert_eq!(second.code, Some(1), "{arguments:?}: {}", second.stderr);
        let told = format!("{output}: another run is writing it");
        assert!(second.stderr.contains(&told), "{}", second.stderr);
        kill(first, "-KILL");
        assert!(bench.path(lock).exists());
        // Whoever comes next has the lock.
        let third = bench.command(arguments).stderr(Stdio::piped()).spawn().unwrap();
        std::thread::sleep(Duration::from_secs(2));
        let third = kill(third, "-INT");
        assert_eq!(third.code, Some(130), "{arguments:?}: {}", third.stderr);
        assert!(!third.stderr.contains("another run"), "{}", third.stderr);
        assert!(!bench.path(lock).exists(), "{arguments:?} leaves its lock");
    }
}

/// A merge does not write what a run is writing.
#[test]
fn a_merge_is_refused_what_another_run_writes() {
    let bench = Bench::new();
    bench.write("case.toml", "[solver]\nmethod = \"polach\"\n[friction]\nmodel = \"constant\"\n");
    let study = "case = \"case.toml\"\n[vary]\n\"kinematics.creepage_x\" = [0.001, 0.002]\n";
    bench.write("study.toml", study);
    let sweep = ["sweep", "study.toml", "--output", "1.csv"];
    assert_eq!(bench.run(&sweep).code, Some(0));
    let merge = ["merge", "1.csv", "--output", "whole.csv"];
    let lock = OutputLock::take(&bench.path("whole.csv")).unwrap();
    let refused = bench.run(&merge);
    assert_eq!(refused.code, Some(1), "{}", refused.stderr);
    assert!(refused.stderr.contains("whole.csv: another run is writing it"), "{}", refused.stderr);
    drop(lock);
    assert_eq!(bench.run(&merge).code, Some(0));
    assert_eq!(bench.list(), ["1.csv", "case.toml", "study.toml", "whole.csv"]);
}

/// A file beside the output that is not of a table stays as it is.
#[test]
fn a_table_keeps_off_files_of_others() {
    let bench = Bench::new();
    bench.write("tab.npz.parts", "my notes");
    let run = bench.run(&["table", "--output", "tab.npz"]);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    assert!(run.stderr.contains("tab.npz.parts: it does not hold states"), "{}", run.stderr);
    assert_eq!(bench.read("tab.npz.parts"), "my notes");
    assert_eq!(bench.list(), ["tab.npz.parts"]);
}

/// A table that was interrupted goes on where it was, and is the same file as one that was not; one
/// with other options does not take its states.
#[test]
fn an_interrupted_table_goes_on() {
    let bench = Bench::new();
    let quick = ["table", "--smallest-axis-ratio", "0.9", "--largest-axis-ratio", "1.1"];
    let options = ["--tolerance", "0.3", "--states", "20", "--output"];
    let table = |name: &str| {
        let mut arguments = quick.to_vec();
        arguments.extend(options);
        arguments.push(name);
        arguments.iter().map(|argument| (*argument).to_owned()).collect::<Vec<_>>()
    };
    let whole = table("whole.npz");
    let whole: Vec<&str> = whole.iter().map(String::as_str).collect();
    assert_eq!(bench.run(&whole).code, Some(0));
    let cut = table("new/cut.npz");
    let cut: Vec<&str> = cut.iter().map(String::as_str).collect();
    let first = start(&bench, &cut, "new/cut.npz.parts");
    let begun = Instant::now();
    while bench.read("new/cut.npz.parts").lines().count() < 8 {
        assert!(begun.elapsed() < Duration::from_secs(60));
        std::thread::sleep(Duration::from_millis(5));
    }
    let stopped = kill(first, "-INT");
    assert_eq!(stopped.code, Some(130), "{}", stopped.stderr);
    let kept = "interrupted: what is done is kept; the same command goes on from there\n";
    assert_eq!(stopped.stderr, kept);
    // As a run that was killed while it wrote a line.
    let states = bench.read("new/cut.npz.parts") + "1 2 3 4";
    bench.write("new/cut.npz.parts", &states);
    let other = bench.run(&[&cut[..], &["--poisson-ratio", "0.3"]].concat());
    assert_eq!(other.code, Some(1), "{}", other.stderr);
    assert!(other.stderr.contains("cut.npz.parts: it does not hold states of this table"));
    let resumed = bench.run(&cut);
    assert_eq!(resumed.code, Some(0), "{}", resumed.stderr);
    assert!(resumed.stdout.contains(" were there already"), "{}", resumed.stdout);
    let bytes = |name: &str| std::fs::read(bench.path(name)).unwrap();
    assert!(bytes("whole.npz") == bytes("new/cut.npz"));
    let left: Vec<_> = std::fs::read_dir(bench.path("new")).unwrap().collect();
    assert_eq!(left.len(), 1, "{left:?}");
}
