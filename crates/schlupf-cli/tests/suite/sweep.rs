//! `schlupf sweep` and `schlupf merge`: threads, kills, shards, a full disk, exit codes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::support::Bench;

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

/// The same with fields of every state.
fn bench_with_fields(count: usize) -> Bench {
    let bench = bench(count);
    let study = bench.read("study.toml");
    let fields = "[fields]\ncolumns = [\"x\", \"y\", \"traction_x\", \"sliding\"]\n";
    bench.write("study.toml", &format!("{study}{fields}"));
    bench
}

/// Names of the files in a folder with their bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let named = entries.map(|entry| entry.file_name().into_string().unwrap());
    named.map(|name| (name.clone(), fs::read(folder.join(name)).unwrap())).collect()
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

/// Kills a run at so many random moments, then lets it end.
fn kill(bench: &Bench, kills: usize) {
    let sweep = ["sweep", "study.toml", "--output", "killed.parquet"];
    let (mut killed, mut random) = (0, 12345_u64);
    while killed < kills {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let mut child = bench.command(&sweep).stdout(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(15 + (random >> 33) % 60));
        if child.try_wait().unwrap().is_some() {
            // On a fast machine the rest is done: once more from the start.
            fs::remove_file(bench.path("killed.parquet")).unwrap();
            let _ = fs::remove_dir_all(bench.path("killed.parquet.fields"));
            continue;
        }
        child.kill().unwrap();
        child.wait().unwrap();
        killed += 1;
    }
    let end = bench.run(&sweep);
    assert_eq!(end.code, Some(0), "{}", end.stderr);
}

/// Killed at twenty moments, the run goes on each time, and its table is that of one run.
#[test]
fn a_run_that_is_killed_goes_on() {
    let bench = bench(2400);
    let whole = bench.run(&["sweep", "study.toml", "--output", "whole.parquet"]);
    assert_eq!(whole.code, Some(0), "{}", whole.stderr);
    kill(&bench, 20);
    let bytes = |name: &str| fs::read(bench.path(name)).unwrap();
    assert!(bytes("killed.parquet") == bytes("whole.parquet"));
    assert_eq!(bench.list(), ["case.toml", "killed.parquet", "study.toml", "whole.parquet"]);
}

/// So it is with fields: the same chunks, and nothing else beside them.
#[test]
fn a_run_with_fields_that_is_killed_goes_on() {
    let bench = bench_with_fields(800);
    let whole = bench.run(&["sweep", "study.toml", "--output", "whole.parquet"]);
    assert_eq!(whole.code, Some(0), "{}", whole.stderr);
    kill(&bench, 20);
    let bytes = |name: &str| fs::read(bench.path(name)).unwrap();
    assert!(bytes("killed.parquet") == bytes("whole.parquet"));
    let [killed, whole] =
        ["killed", "whole"].map(|name| files(&bench.path(&format!("{name}.parquet.fields"))));
    assert_eq!(whole.len(), 100);
    assert!(killed == whole);
    assert!(!bench.path("killed.parquet.parts").exists());
}

/// A new file of the command may be read by those who may read any other new file.
#[cfg(unix)]
#[test]
fn tables_and_chunks_have_the_mode_of_new_files() {
    use std::os::unix::fs::PermissionsExt;

    let bench = bench_with_fields(8);
    let command = bench.command(&["sweep", "study.toml", "--output", "table.csv"]);
    let merge = bench.command(&["merge", "table.csv", "--output", "merged.csv"]);
    for command in [command, merge] {
        let mut shell = Command::new("sh");
        shell.args(["-c", "umask 027; exec \"$@\"", "sh"]).arg(command.get_program());
        shell.args(command.get_args()).stdout(Stdio::null());
        if let Some(folder) = command.get_current_dir() {
            shell.current_dir(folder);
        }
        assert!(shell.status().unwrap().success());
    }
    for name in ["table.csv", "table.csv.fields/batch-00000000.parquet", "merged.csv"] {
        let mode = fs::metadata(bench.path(name)).unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o640, "{name}");
    }
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

/// A file system of so many kB in the folder of a bench; `None` without the right to mount one.
#[cfg(target_os = "linux")]
struct SmallDisk(PathBuf);

#[cfg(target_os = "linux")]
impl SmallDisk {
    fn mount(path: PathBuf, kilobytes: usize) -> Option<Self> {
        fs::create_dir(&path).unwrap();
        let size = format!("size={kilobytes}k");
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", &size, "tmpfs"]).arg(&path).stderr(Stdio::null());
        mount.status().is_ok_and(|status| status.success()).then_some(Self(path))
    }

    fn enlarge(&self) {
        let mut mount = Command::new("mount");
        assert!(mount.args(["-o", "remount,size=16m"]).arg(&self.0).status().unwrap().success());
    }
}

#[cfg(target_os = "linux")]
impl Drop for SmallDisk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).status();
    }
}

/// Needs the right to mount: where there is none, nothing is tested.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_keeps_what_is_done() {
    let bench = bench(400);
    let Some(disk) = SmallDisk::mount(bench.path("small"), 64) else { return };
    let sweep = ["sweep", "study.toml", "--output", "small/table.csv"];
    let full = bench.run(&sweep);
    assert_eq!(full.code, Some(1), "{}", full.stderr);
    assert!(full.stderr.contains("No space left on device"), "{}", full.stderr);
    assert!(files(&bench.path("small/table.csv.parts")).len() > 2);
    disk.enlarge();
    let end = bench.run(&sweep);
    assert_eq!(end.code, Some(0), "{}", end.stderr);
    assert!(end.stdout.contains("were there already"), "{}", end.stdout);
    assert!(fs::metadata(bench.path("small/table.csv")).unwrap().len() > 0);
}

/// So it is where chunks of fields fill the disk: those that are there are whole.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_full_of_fields_keeps_what_is_done() {
    let bench = bench_with_fields(200);
    let whole = bench.run(&["sweep", "study.toml", "--output", "whole.csv"]);
    assert_eq!(whole.code, Some(0), "{}", whole.stderr);
    let whole = files(&bench.path("whole.csv.fields"));
    let Some(disk) = SmallDisk::mount(bench.path("small"), 256) else { return };
    let sweep = ["sweep", "study.toml", "--output", "small/table.csv"];
    let full = bench.run(&sweep);
    assert_eq!(full.code, Some(1), "{}", full.stderr);
    assert!(full.stderr.contains("No space left on device"), "{}", full.stderr);
    let chunks = || files(&bench.path("small/table.csv.fields"));
    let kept = chunks();
    assert!(kept.len() > 2 && kept.len() < whole.len(), "{}", kept.len());
    assert!(kept.iter().all(|(name, bytes)| whole.get(name) == Some(bytes)));
    disk.enlarge();
    let end = bench.run(&sweep);
    assert_eq!(end.code, Some(0), "{}", end.stderr);
    assert!(end.stdout.contains("were there already"), "{}", end.stdout);
    assert!(chunks() == whole);
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
    refused(&["--output", "case.toml"], "--output must write files of its own");
    bench.write("other.csv", "a,b\n1,2\n");
    refused(&["--output", "other.csv"], "no table of a study");
    let failing = "case = \"case.toml\"\n[vary]\n\"kinematics.creepage_x\" = [1.5]\n";
    bench.write("study.toml", failing);
    let failed = bench.run(&["sweep", "study.toml", "--output", "failed.csv"]);
    assert_eq!(failed.code, Some(3), "{}", failed.stderr);
    assert!(failed.stdout.contains("1 states, 0 converged, 1 failed"), "{}", failed.stdout);
}

/// A wheel that lifts has no contact: it is neither converged nor a failure.
#[test]
fn states_without_contact_are_counted_by_themselves() {
    let bench = Bench::new();
    bench.write("case.toml", "[solver]\nmethod = \"polach\"\n[friction]\nmodel = \"constant\"\n");
    bench.write("states.csv", "normal.load [kN]\n0\n80\n");
    bench.write("study.toml", "case = \"case.toml\"\n[states]\nfile = \"states.csv\"\n");
    // Solved, and read from its table.
    for _ in 0..2 {
        let run = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let counted = "2 states, 1 converged, 1 without contact";
        assert!(run.stdout.contains(counted), "{}", run.stdout);
    }
}

/// A study at 80 MN a wheel ended "3 converged" and no more.
#[test]
fn a_study_ends_with_its_warnings_counted_by_code() {
    let bench = Bench::new();
    bench.write("case.toml", "[solver]\nmethod = \"polach\"\n[friction]\nmodel = \"constant\"\n");
    let states = "distance [m],normal.load [kN],kinematics.creepage_x\n\
                  0,80,0\n1,80000,0\n2,200000,0\n3,100000,-2\n";
    bench.write("states.csv", states);
    bench.write("study.toml", "case = \"case.toml\"\n[states]\nfile = \"states.csv\"\n");
    for shard in ["1/2", "2/2"] {
        let name = format!("{}.csv", &shard[..1]);
        bench.run(&["sweep", "study.toml", "--output", &name, "--shard", shard]);
    }
    let run = bench.run(&["sweep", "study.toml", "--output", "table.csv"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.contains("4 states, 4 converged"), "{}", run.stdout);
    let worst = "warning: beyond-elastic in 3 of 4 states, worst in row 2: normal.peak_pressure";
    assert!(run.stderr.contains(worst), "{}", run.stderr);
    let unusual = "unusual-value in 3 of 4 states, worst in row 2: row 2 normal.load=";
    assert!(run.stderr.contains(unusual), "{}", run.stderr);
    assert!(
        run.stderr.contains("first in row 3: row 3 kinematics.creepage_x=-2.0"),
        "{}",
        run.stderr
    );
    // From tables alone, what is known is how many.
    let merge = ["merge", "1.csv", "2.csv", "--output", "merged.csv"];
    for run in [bench.run(&["sweep", "study.toml", "--output", "table.csv"]), bench.run(&merge)] {
        let counted =
            "warning: beyond-elastic in 3 of 4 states, first in row 1: the pressure is above";
        assert!(run.stderr.contains(counted), "{}", run.stderr);
    }
    for (run, worst) in [("study.toml", "worst in row 2"), ("table.csv", "first in row 1")] {
        let damage = bench.run(&["damage", run]);
        let counted = format!("warning: beyond-elastic in 3 of 4 states, {worst}");
        assert!(damage.stderr.contains(&counted), "{}", damage.stderr);
    }
}
