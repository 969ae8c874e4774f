//! `schlupf sweep` and `schlupf merge`: threads, kills, shards, a full disk, exit codes.

mod support;

use std::fs;
use std::process::{Command, Stdio};
use std::time::Duration;

use support::Bench;

fn bench(count: usize) -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", "[grid]\ncells_x = 10\ncells_y = 10\n");
    let study = format!(
        "case = \"case.toml\"\nbatch = 8\n[sample]\nmethod = \"latin-hypercube\"\n\
         count = {count}\n[sample.range]\nkinematics.creepage_x = [-0.01, 0.01]\n\
         kinematics.creepage_y = [-0.01, 0.01]\nkinematics.spin = [\"-1 1/m\", \"1 1/m\"]\n"
    );
    bench.write("study.toml", &study);
    bench
}

#[test]
fn a_study_has_a_summary_and_a_table() {
    let bench = bench(20);
    let run = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert_eq!(run.stdout, "table.csv\n\n20 states, 20 converged\n");
    assert_eq!(bench.read("table.csv").lines().count(), 23);
    let again = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert!(again.stdout.contains("20 were there already"), "{}", again.stdout);
    assert_eq!(bench.list(), ["case.toml", "study.toml", "table.csv"]);
}

#[test]
fn the_table_does_not_depend_on_threads_and_shards() {
    let bench = bench(60);
    for (threads, name) in [("1", "one.parquet"), ("2", "two.parquet"), ("3", "three.parquet")] {
        let run = bench.run(&["sweep", "study.toml", "--output", name, "--threads", threads]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
    }
    let bytes = |name: &str| fs::read(bench.path(name)).unwrap();
    assert!(bytes("one.parquet") == bytes("two.parquet"));
    assert!(bytes("one.parquet") == bytes("three.parquet"));
    for (shard, name) in [("1/2", "a.csv"), ("2/2", "b.parquet")] {
        let sweep = ["sweep", "study.toml", "--output", name, "--shard", shard, "--quiet"];
        assert_eq!(bench.run(&sweep).stdout, "");
    }
    let merge = bench.run(&["merge", "b.parquet", "a.csv", "--output", "merged.parquet"]);
    assert_eq!(merge.code, Some(0), "{}", merge.stderr);
    assert!(bytes("one.parquet") == bytes("merged.parquet"));
    let missing = bench.run(&["merge", "a.csv", "--output", "other.parquet"]);
    assert_eq!(missing.code, Some(2));
    assert!(missing.stderr.contains("shard 2/2 is missing"), "{}", missing.stderr);
}

/// Killed at twenty moments, the run goes on each time, and its table is that of one run.
#[test]
fn a_run_that_is_killed_goes_on() {
    let bench = bench(2400);
    let whole = bench.run(&["sweep", "study.toml", "--output", "whole.parquet"]);
    assert_eq!(whole.code, Some(0), "{}", whole.stderr);
    let sweep = ["sweep", "study.toml", "--output", "killed.parquet"];
    let (mut kills, mut random) = (0, 12345_u64);
    while kills < 20 {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let mut child = bench.command(&sweep).stdout(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(15 + (random >> 33) % 60));
        if child.try_wait().unwrap().is_some() {
            // On a fast machine the rest is done: once more from the start.
            fs::remove_file(bench.path("killed.parquet")).unwrap();
            continue;
        }
        child.kill().unwrap();
        child.wait().unwrap();
        kills += 1;
    }
    let end = bench.run(&sweep);
    assert_eq!(end.code, Some(0), "{}", end.stderr);
    let bytes = |name: &str| fs::read(bench.path(name)).unwrap();
    assert!(bytes("killed.parquet") == bytes("whole.parquet"));
    assert!(!bench.path("killed.parquet.parts").exists());
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_says_that_it_can_go_on() {
    let bench = bench(200_000);
    let mut command = bench.command(&["sweep", "study.toml", "--output", "table.csv"]);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(Duration::from_secs(2));
    assert!(
        Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success()
    );
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(message, "interrupted: what is done is kept; the same command goes on from there\n");
    assert!(bench.path("table.csv.parts").is_dir() && !bench.path("table.csv").exists());
}

/// Needs the right to mount: where there is none, nothing is tested.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_keeps_what_is_done() {
    let bench = bench(400);
    fs::create_dir(bench.path("small")).unwrap();
    let small = bench.path("small").display().to_string();
    let mount = ["-t", "tmpfs", "-o", "size=64k", "tmpfs", &small];
    let mounted = Command::new("mount").args(mount).stderr(Stdio::null()).status();
    if !mounted.is_ok_and(|status| status.success()) {
        return;
    }
    let sweep = ["sweep", "study.toml", "--output", "small/table.csv"];
    let full = bench.run(&sweep);
    let kept = fs::read_dir(bench.path("small/table.csv.parts")).map(Iterator::count);
    let larger = Command::new("mount").args(["-o", "remount,size=16m", &small]).status();
    let end = bench.run(&sweep);
    let table = fs::metadata(bench.path("small/table.csv"));
    let left = Command::new("umount").arg(&small).status();
    assert_eq!(full.code, Some(1), "{}", full.stderr);
    assert!(full.stderr.contains("No space left on device"), "{}", full.stderr);
    assert!(kept.unwrap() > 2 && larger.unwrap().success() && left.unwrap().success());
    assert_eq!(end.code, Some(0), "{}", end.stderr);
    assert!(end.stdout.contains("were there already"), "{}", end.stdout);
    assert!(table.unwrap().len() > 0);
}

#[test]
fn wrong_arguments_are_refused() {
    let bench = bench(4);
    let refused = |arguments: &[&str], part: &str| {
        let run = bench.run(&[&["sweep", "study.toml"], arguments].concat());
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(part), "{arguments:?}: {}", run.stderr);
    };
    refused(&["--output", "table.txt"], ".csv or .parquet");
    refused(&["--output", "t.csv", "--shard", "3/2"], "I from 1 to N");
    refused(&["--output", "case.toml"], "--output must name a file of its own");
    bench.write("other.csv", "a,b\n1,2\n");
    refused(&["--output", "other.csv"], "no table of a study");
    let failing = "case = \"case.toml\"\n[vary]\n\"kinematics.creepage_x\" = [1.5]\n";
    bench.write("study.toml", failing);
    let failed = bench.run(&["sweep", "study.toml", "--output", "failed.csv"]);
    assert_eq!(failed.code, Some(3), "{}", failed.stderr);
    assert!(failed.stdout.contains("1 states, 0 converged, 1 failed"), "{}", failed.stdout);
}
