//! Studies: rows as solved one by one, tables that are the same however the work was divided, and
//! what is wrong said in words.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use schlupf::unwatched;
use schlupf_case::{CaseFile, Folder, Overrides};
use schlupf_tasks::solve::solve;
use schlupf_tasks::study::merge::merge;
use schlupf_tasks::study::run::{Report, Run, run};
use schlupf_tasks::study::table::{Cells, Reader};
use schlupf_tasks::study::{Study, StudyError};

const CASE: &str = "title = \"braking\"\nelasticity.model = \"half-space\"\n\
                    [grid]\ncells_x = 8\ncells_y = 8\n";

/// A folder with a case and a study of it.
struct Bench(tempfile::TempDir);

impl Bench {
    fn new(study: &str) -> Self {
        let bench = Self(tempfile::tempdir().unwrap());
        bench.write("case.toml", CASE);
        bench.write("study.toml", &format!("case = \"case.toml\"\n{study}"));
        bench
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    fn study(&self) -> Result<Study, StudyError> {
        Study::from_path(&self.path("study.toml"), None)
    }

    fn run(&self, shard: [usize; 2], output: &str) -> Result<Report, StudyError> {
        run(&self.study()?, shard, &self.path(output), &unwatched)
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }
}

const FACTORIAL: &str = "batch = 4\n[vary]\n\
    \"normal.load\" = [\"60 kN\", \"80 kN\"]\n\
    kinematics.creepage_x = [0.0, 0.001, 0.004]\n\
    \"friction.model\" = [\"constant\", \"temperature-linear\"]\n";

/// Numbers of a column of a table.
fn numbers(path: &Path, name: &str) -> Vec<f64> {
    let mut reader = Reader::open(path).unwrap();
    let place = reader.contents().columns.iter().position(|column| column.name == name).unwrap();
    let mut all = Vec::new();
    while let Some(rows) = reader.next_batch().unwrap() {
        match &rows[place] {
            Cells::Numbers(numbers) => all.extend(numbers),
            Cells::Counts(counts) => all.extend(counts.iter().map(|count| *count as f64)),
            _ => panic!("{name} is text"),
        }
    }
    all
}

/// What would be silently wrong is refused: a field that is written in two ways, two columns of one
/// name, ranges without end, and a table that was cut.
#[test]
fn what_would_be_silently_wrong_is_refused() {
    for (study, part) in [
        (
            "[vary]\nkinematics.creepage_x = [0.0, 0.001]\n\"kinematics.creepage_x\" = [0.01]\n",
            "kinematics.creepage_x is given twice",
        ),
        (
            "[sample]\nmethod = \"sobol\"\ncount = 4\n[sample.range]\n\
             \"kinematics.creepage_x\" = [0.0, 0.1]\nkinematics.creepage_x = [0.0, 0.2]\n",
            "kinematics.creepage_x is given twice",
        ),
        (
            "[sample]\nmethod = \"sobol\"\ncount = 4\n[sample.range]\n\
             wheel.radius_y = [\"1 m\", \"inf\"]\n",
            "the range of wheel.radius_y must be finite",
        ),
        ("[states]\nfile = \"states.csv\"\n", "there are two columns time"),
    ] {
        let bench = Bench::new(study);
        bench.write("states.csv", "time [s],time [ms],kinematics.creepage_x\n0,0,0.001\n");
        let error = bench.study().unwrap_err().to_string();
        assert!(error.contains(part), "{study}: {error}");
    }
    let bench =
        Bench::new("batch = 2\n[vary]\nkinematics.creepage_x = [0.0, 0.001, 0.002, 0.003]\n");
    bench.run([1, 1], "table.csv").unwrap();
    let text = fs::read_to_string(bench.path("table.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    bench.write("table.csv", &format!("{}\n", lines[..lines.len() - 2].join("\n")));
    let error = bench.run([1, 1], "table.csv").unwrap_err().to_string();
    assert!(error.contains("it has 2 rows of 4, so it was cut"), "{error}");
}

/// A file that a value names is part of the study: what was solved with another one is not kept.
#[test]
fn files_of_values_are_part_of_the_study() {
    let bench = Bench::new("[vary]\nfriction.variation_file = [\"one.csv\", \"two.csv\"]\n");
    let across = |factor: f64| format!("y [mm],factor\n-9,{factor}\n0,1\n9,{factor}\n");
    bench.write("one.csv", &across(0.9));
    bench.write("two.csv", &across(0.8));
    let before = bench.study().unwrap().digest().to_owned();
    assert_eq!(bench.study().unwrap().digest(), before);
    bench.write("two.csv", &across(0.5));
    assert_ne!(bench.study().unwrap().digest(), before);
}

/// Where the case tells how the wheel turns, creepages of other speeds and other lateral creepages
/// follow from that, also in a study.
#[test]
fn rows_follow_the_wheel() {
    for (field, values) in [
        ("kinematics.speed", ["20 m/s", "20.1 m/s", "20.2 m/s"]),
        ("kinematics.creepage_y", ["0.0", "0.05", "0.1"]),
        ("kinematics.spin", ["0 1/m", "0.2 1/m", "0.5 1/m"]),
    ] {
        let is_number = field == "kinematics.creepage_y";
        let value = |value: &str| if is_number { value.to_owned() } else { format!("{value:?}") };
        let list = values.map(value).join(", ");
        let bench = Bench::new(&format!("[vary]\n{field} = [{list}]\n"));
        let turning = "[kinematics]\nspeed = \"20 m/s\"\nangular_velocity = \"43.4 rad/s\"\n";
        bench.write("case.toml", &format!("{CASE}{turning}"));
        bench.run([1, 1], "table.parquet").unwrap();
        let found = numbers(&bench.path("table.parquet"), "force.x");
        for (found, value) in found.iter().zip(values) {
            let set = [format!("{field}={value}")];
            let files = Folder::new(bench.path(""));
            let overrides = Overrides { option: "--set", assignments: &set };
            let text = format!("{CASE}{turning}");
            let file = CaseFile::from_str(&text, "case", files, overrides).unwrap();
            let case = file.pose(&unwatched).unwrap();
            let alone = solve(&case, case.rolling(None).unwrap(), &unwatched).unwrap();
            let expected = alone.solution.force.x;
            // A millionth of the largest force, the tolerance of a solution.
            assert!((found - expected).abs() < 0.03, "{field}={value}: {found} {expected}");
        }
    }
}

/// Every row is what its case gives when it is solved alone.
#[test]
fn rows_are_those_of_single_cases() {
    let bench = Bench::new(FACTORIAL);
    let report = bench.run([1, 1], "table.parquet").unwrap();
    assert_eq!((report.rows, report.failed, report.not_converged), (12, 0, 0));
    let table = bench.path("table.parquet");
    let found = numbers(&table, "force.x");
    assert_eq!(numbers(&table, "index"), (0..12).map(f64::from).collect::<Vec<_>>());
    let mut row = 0;
    for load in ["60 kN", "80 kN"] {
        for creepage in [0.0, 0.001, 0.004] {
            for friction in ["constant", "temperature-linear"] {
                let assignments = &[
                    format!("normal.load={load}"),
                    format!("kinematics.creepage_x={creepage}"),
                    format!("friction.model={friction}"),
                ];
                let overrides = Overrides { option: "set", assignments };
                let file = CaseFile::from_str(CASE, "case", Folder::new(""), overrides).unwrap();
                let case = file.pose(&unwatched).unwrap();
                let rolling = case.rolling(None).unwrap();
                let alone = solve(&case, rolling, &unwatched).unwrap().solution;
                let limit = 1e-5 * alone.normal.load;
                assert!((found[row] - alone.force.x).abs() < limit, "row {row}");
                row += 1;
            }
        }
    }
    assert_eq!(numbers(&table, "normal.load")[6..8], [8e4, 8e4]);
}

/// Shards, runs that are stopped at any time, and formats: one table.
#[test]
fn the_table_does_not_depend_on_how_it_was_made() {
    let bench = Bench::new(FACTORIAL);
    for ending in ["csv", "parquet"] {
        let whole = format!("whole.{ending}");
        bench.run([1, 1], &whole).unwrap();
        assert!(!bench.path(&format!("{whole}.parts")).exists());
        let shards = [2, 1, 3].map(|shard| format!("{shard}.{ending}"));
        for (name, shard) in shards.iter().zip([2, 1, 3]) {
            bench.run([shard, 3], name).unwrap();
        }
        let shards: Vec<PathBuf> = shards.iter().map(|name| bench.path(name)).collect();
        let merged = format!("merged.{ending}");
        let report = merge(&shards, &bench.path(&merged)).unwrap();
        assert_eq!(report.rows, 12);
        assert_eq!(bench.bytes(&merged), bench.bytes(&whole), "{ending}");
        // Again there is nothing to do; what is something else stays.
        assert_eq!(merge(&shards, &bench.path(&merged)).unwrap().resumed, 12);
        let refused = merge(&shards, &shards[0]).unwrap_err().to_string();
        assert!(refused.contains("remove it, or name another output"), "{refused}");
        for last in 1..40 {
            let (output, asked) = (format!("stopped.{ending}"), AtomicUsize::new(0));
            let stop = |_| {
                let is_over = asked.fetch_add(1, Ordering::Relaxed) >= last * 5;
                if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            match run(&bench.study().unwrap(), [1, 1], &bench.path(&output), &stop) {
                Ok(report) => {
                    assert_eq!(bench.bytes(&output), bench.bytes(&whole));
                    assert!(last > 1 && report.resumed > 0, "{last}: {report:?}");
                    break;
                }
                Err(StudyError::Stopped) => assert!(!bench.path(&output).exists()),
                Err(other) => panic!("{other}"),
            }
        }
        assert!(bench.path(&format!("stopped.{ending}")).exists());
    }
}

#[test]
fn a_table_that_is_there_is_not_computed_again_nor_written_over() {
    let bench = Bench::new(FACTORIAL);
    bench.run([1, 1], "table.csv").unwrap();
    let before = bench.bytes("table.csv");
    let again = bench.run([1, 1], "table.csv").unwrap();
    assert_eq!((again.resumed, again.rows), (12, 12));
    bench.write("case.toml", &format!("{CASE}\n[friction]\ncoefficient = 0.3\n"));
    let error = bench.run([1, 1], "table.csv").unwrap_err().to_string();
    assert!(error.contains("table of another study"), "{error}");
    assert_eq!(bench.bytes("table.csv"), before);
}

#[test]
fn batches_of_another_study_are_not_mixed_in() {
    let bench = Bench::new(FACTORIAL);
    let asked = AtomicUsize::new(0);
    let stop = |_| {
        let is_over = asked.fetch_add(1, Ordering::Relaxed) > 3;
        if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let stopped = run(&bench.study().unwrap(), [1, 1], &bench.path("table.csv"), &stop);
    assert!(matches!(stopped, Err(StudyError::Stopped)));
    bench.write("study.toml", &bench_text(&FACTORIAL.replace("0.004", "0.005")));
    let error = bench.run([1, 1], "table.csv").unwrap_err().to_string();
    assert!(error.contains("batches of another study"), "{error}");
}

/// What a killed run leaves that is not whole goes with the next; batches of which no manifest
/// tells are solved again; and what one leaves that was killed at its very end goes, too.
#[test]
fn remains_of_killed_runs_are_removed() {
    let bench = Bench::new(FACTORIAL);
    bench.run([1, 1], "whole.csv").unwrap();
    let parts = |name: &str| bench.path("table.csv.parts").join(name);
    fs::create_dir(bench.path("table.csv.parts")).unwrap();
    for name in [".schlupf-abc", "batch-00000000.csv", "batch-00000001.csv"] {
        fs::write(parts(name), "of another study").unwrap();
    }
    let asked = AtomicUsize::new(0);
    let stop = |_| {
        let is_over = asked.fetch_add(1, Ordering::Relaxed) > 0;
        if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let stopped = run(&bench.study().unwrap(), [1, 1], &bench.path("table.csv"), &stop);
    assert!(matches!(stopped, Err(StudyError::Stopped)));
    let manifest = fs::read(parts("manifest.json")).unwrap();
    let left = || fs::read_dir(bench.path("table.csv.parts")).unwrap().count();
    assert_eq!(left(), 1);
    fs::write(parts(".schlupf-def"), "").unwrap();
    asked.store(0, Ordering::Relaxed);
    let stopped = run(&bench.study().unwrap(), [1, 1], &bench.path("table.csv"), &stop);
    assert!(matches!(stopped, Err(StudyError::Stopped)) && left() == 1);
    assert_eq!(bench.run([1, 1], "table.csv").unwrap().resumed, 0);
    assert_eq!(bench.bytes("table.csv"), bench.bytes("whole.csv"));
    fs::create_dir(bench.path("table.csv.parts")).unwrap();
    fs::write(parts("manifest.json"), manifest).unwrap();
    assert_eq!(bench.run([1, 1], "table.csv").unwrap().resumed, 12);
    assert!(!bench.path("table.csv.parts").exists());
}

/// Another version of the program solves its own batches, and its tables are not mixed in.
#[test]
fn tables_of_another_version_are_refused() {
    let bench = Bench::new(FACTORIAL);
    bench.run([1, 2], "1.csv").unwrap();
    bench.run([2, 2], "2.csv").unwrap();
    let program = Reader::open(&bench.path("1.csv")).unwrap().contents().program.clone();
    let text = String::from_utf8(bench.bytes("1.csv")).unwrap();
    bench.write("1.csv", &text.replace(&program, "schlupf 0.0.1"));
    let refused = bench.run([1, 2], "1.csv").unwrap_err().to_string();
    let expected = format!("it is the table of schlupf 0.0.1, but this is {program}: remove it");
    assert!(refused.contains(&expected), "{refused}");
    let shards = ["2.csv", "1.csv"].map(|name| bench.path(name));
    let refused = merge(&shards, &bench.path("merged.csv")).unwrap_err().to_string();
    assert!(refused.contains("it is of schlupf 0.0.1, but"), "{refused}");
    assert!(refused.contains(&format!("2.csv is of {program}")), "{refused}");
    let stop = |_| ControlFlow::Break(());
    let stopped = run(&bench.study().unwrap(), [1, 1], &bench.path("table.csv"), &stop);
    assert!(matches!(stopped, Err(StudyError::Stopped)));
    let manifest = bench.path("table.csv.parts").join("manifest.json");
    let text = fs::read_to_string(&manifest).unwrap();
    fs::write(&manifest, text.replace(&program, "schlupf 0.0.1")).unwrap();
    let refused = bench.run([1, 1], "table.csv").unwrap_err().to_string();
    let expected = format!("it has batches of schlupf 0.0.1, but this is {program}: remove it");
    assert!(refused.contains(&expected), "{refused}");
}

fn bench_text(study: &str) -> String {
    format!("case = \"case.toml\"\n{study}")
}

#[test]
fn what_fails_is_a_row_with_its_reason() {
    let bench = Bench::new("[vary]\n\"kinematics.creepage_x\" = [0.001, 1.5]\n");
    let report = bench.run([1, 1], "table.csv").unwrap();
    assert_eq!((report.rows, report.failed), (2, 1));
    let (row, reason) = report.first_failure.unwrap();
    assert_eq!(row, 1);
    assert!(reason.contains("kinematics.creepage_x") && reason.contains("1.5"), "{reason}");
    let forces = numbers(&bench.path("table.csv"), "force.x");
    assert!(forces[0] < 0.0 && forces[1].is_nan());
}

#[test]
fn states_of_a_file_are_rows_with_their_time() {
    let bench = Bench::new("[states]\nfile = \"run.csv\"\n");
    bench.write(
        "run.csv",
        "time [ms],normal.load [kN],kinematics.creepage_x,kinematics.spin [1/m]\n\
         0,60,0.001,0.1\n10,70,0.002,0.2\n20,65,0.001,-0.1\n",
    );
    bench.run([1, 1], "table.parquet").unwrap();
    let table = bench.path("table.parquet");
    assert_eq!(numbers(&table, "time"), [0.0, 0.01, 0.02]);
    assert_eq!(numbers(&table, "normal.load"), [6e4, 7e4, 6.5e4]);
    // A table of one study can be the states of another.
    bench.write("study.toml", &bench_text("[states]\nfile = \"again.csv\"\n"));
    bench.write("again.csv", "kinematics.creepage_x\n0.001\n");
    bench.run([1, 1], "other.csv").unwrap();
}

/// Heads with a bracket too many or too few.
#[test]
fn heads_of_states_have_one_unit() {
    for head in ["normal.load [kN]]", "normal.load [kN", "normal.load [[kN]", "normal.load kN]"] {
        let bench = Bench::new("[states]\nfile = \"run.csv\"\n");
        bench.write("run.csv", &format!("{head}\n60\n"));
        let message = bench.study().unwrap_err().to_string();
        assert!(message.contains("run.csv") && message.contains(head), "{message}");
    }
}

#[test]
fn samples_fill_their_ranges() {
    let bench = Bench::new(
        "[sample]\nmethod = \"sobol\"\ncount = 32\nseed = 5\n[sample.range]\n\
         kinematics.creepage_x = [-0.01, 0.01]\n\"normal.load\" = [\"60 kN\", \"80 kN\"]\n",
    );
    bench.write("case.toml", "solver.method = \"polach\"\nfriction.model = \"constant\"\n");
    bench.run([1, 1], "table.csv").unwrap();
    let loads = numbers(&bench.path("table.csv"), "normal.load");
    let mut intervals: Vec<usize> = loads.iter().map(|n| ((n - 6e4) / 625.0) as usize).collect();
    intervals.sort_unstable();
    assert_eq!(intervals, (0..32).collect::<Vec<_>>());
}

#[test]
fn wrong_studies_are_refused_with_field_and_place() {
    let refused = |study: &str| {
        let bench = Bench::new(study);
        bench.write("run.csv", "kinematics.creepage_x\n");
        bench.study().unwrap_err().to_string()
    };
    let sample = "[sample]\nmethod = \"sobol\"\ncount = 4\n";
    for (study, parts) in [
        ("", &["needs one of [vary], [sample] and [states]"][..]),
        ("[vray]\n", &["study.toml:2:2", "vray", "did you mean `vary`"]),
        ("[vary]\n\"normal.laod\" = [1]\n", &["study.toml:3:1", "normal.laod", "normal.load"]),
        ("[vary]\n\"normal.load\" = [\"60 m\"]\n", &["study.toml:3:", "normal.load", "60 m"]),
        ("[vary]\n\"normal.load\" = 60\n", &["normal.load must be a list"]),
        ("[vary]\n\"normal.load\" = []\n", &["normal.load must have values"]),
        ("[vary]\n\"normal.load\" = [\"1 kN\", \"1000 N\"]\n", &["\"1000 N\" is repeated"]),
        ("[vary]\n\"kinematics.creepage_x\" = [0.0, -0.0]\n", &["-0.0 is repeated"]),
        ("[vary]\n\"history.time\" = [[1.0]]\n", &["history.time"]),
        ("[vary]\n[states]\nfile = \"run.csv\"\n", &["one of [vary] and [states]"]),
        ("[states]\nfile = \"missing.csv\"\n", &["missing.csv", "No such file"]),
        ("[states]\nfile = \"run.csv\"\n", &["run.csv", "must have rows, but has none"]),
        (sample, &["sample.range is missing"]),
        (
            &format!("{sample}[sample.range]\n\"normal.load\" = [\"2 N\", \"1 N\"]\n"),
            &["the range of normal.load must increase"],
        ),
        (
            &format!("{sample}[sample.range]\n\"solver.method\" = [\"full\", \"polach\"]\n"),
            &["solver.method must be a range of numbers"],
        ),
        ("batch = 0\n[vary]\n\"normal.load\" = [\"1 kN\"]\n", &["batch must be a whole number"]),
        ("[vary\n", &["study.toml:2:", "not TOML"]),
    ] {
        let message = refused(study);
        assert!(parts.iter().all(|part| message.contains(part)), "{study}: {message}");
    }
}

#[test]
fn shards_that_do_not_belong_together_are_refused() {
    let bench = Bench::new(FACTORIAL);
    bench.run([1, 2], "1.csv").unwrap();
    bench.run([2, 2], "2.csv").unwrap();
    bench.run([1, 3], "of_three.csv").unwrap();
    let refused = |names: &[&str]| {
        let paths: Vec<PathBuf> = names.iter().map(|name| bench.path(name)).collect();
        let error = merge(&paths, &bench.path("merged.csv")).unwrap_err().to_string();
        assert!(!bench.path("merged.csv").exists());
        error
    };
    assert!(refused(&["1.csv"]).contains("shard 2/2 is missing"));
    assert!(refused(&["1.csv", "1.csv", "2.csv"]).contains("it is shard 1/2, as"));
    assert!(refused(&["1.csv", "of_three.csv"]).contains("not of the same study"));
    let text = String::from_utf8(bench.bytes("2.csv")).unwrap();
    let cut: Vec<&str> = text.lines().take(text.lines().count() - 1).collect();
    bench.write("2.csv", &(cut.join("\n") + "\n"));
    assert!(refused(&["1.csv", "2.csv"]).contains("it lacks rows from 4 on"));
}

/// More shards than a process may well have files open: each is opened again where it was left.
#[test]
fn many_shards_are_merged() {
    let sample = "batch = 1\n[sample]\nmethod = \"sobol\"\ncount = 300\n[sample.range]\n\
                  kinematics.creepage_x = [-0.01, 0.01]\n";
    let bench = Bench::new(sample);
    for ending in ["csv", "parquet"] {
        let whole = format!("whole.{ending}");
        bench.run([1, 1], &whole).unwrap();
        let shard = |k: usize| {
            let name = format!("{k}.{ending}");
            bench.run([k, 260], &name).unwrap();
            bench.path(&name)
        };
        let shards: Vec<PathBuf> = (1..=260).map(shard).collect();
        let merged = format!("merged.{ending}");
        merge(&shards, &bench.path(&merged)).unwrap();
        assert!(bench.bytes(&merged) == bench.bytes(&whole), "{ending}");
    }
}

/// Goal: two cores are at least 1.85 times as fast as one. What they do is counted: batches are
/// independent, so no core waits for another before the last of them, and the products do not
/// depend on the number of threads (that the tables are the same asserts it elsewhere). Handing
/// each core the next batch as soon as it is free, both end when the work is divided this well.
#[test]
fn the_work_of_two_cores_is_divided_evenly() {
    let sample = "batch = 16\n[sample]\nmethod = \"sobol\"\ncount = 640\n[sample.range]\n\
                  kinematics.creepage_x = [-0.01, 0.01]\nkinematics.spin = [\"-1 1/m\", \"1 1/m\"]\n";
    let bench = Bench::new(sample);
    bench.run([1, 1], "table.parquet").unwrap();
    let products = numbers(&bench.path("table.parquet"), "work.operator_products");
    let batches: Vec<f64> = products.chunks(16).map(|batch| batch.iter().sum()).collect();
    let total: f64 = batches.iter().sum();
    let mut cores = [0.0_f64; 2];
    for batch in &batches {
        let free = usize::from(cores[1] < cores[0]);
        cores[free] += batch;
    }
    let faster = total / cores[0].max(cores[1]);
    assert!(faster >= 1.85, "{faster}");
}

#[test]
fn a_study_in_which_nothing_varies_is_refused() {
    for (text, part) in [
        ("[vary]\n", "vary must have fields, but has none"),
        ("[vary]\nkinematics = {}\n", "vary must have fields, but has none"),
        ("[vary]\nkinematics.speed = []\n", "kinematics.speed must have values, but has none"),
        ("", "needs one of [vary], [sample] and [states], but has none"),
    ] {
        let refused = Bench::new(text).study().unwrap_err().to_string();
        assert!(refused.contains(part), "{refused}");
    }
}

/// Fields have a chunk for each batch: those of the solution alone, whatever ends the run.
#[test]
fn fields_are_kept_in_chunks() {
    let text = "batch = 4\n[fields]\ncolumns = [\"x\", \"traction_x\", \"sliding\"]\n[vary]\n\
                kinematics.creepage_x = [0.0, 0.001, 0.002, 0.003, 0.004, 1.5]\n";
    let bench = Bench::new(text);
    let report = bench.run([1, 1], "table.csv").unwrap();
    assert_eq!((report.rows, report.failed), (6, 1));
    let chunk = |table: &str, batch: usize| {
        bench.path(&format!("{table}.fields")).join(format!("batch-{batch:08}.parquet"))
    };
    let first = chunk("table.csv", 0);
    let [index, traction] = ["index", "traction_x"].map(|name| numbers(&first, name));
    let overrides =
        Overrides { option: "set", assignments: &["kinematics.creepage_x=0.003".into()] };
    let file = CaseFile::from_str(CASE, "case", Folder::new(""), overrides).unwrap();
    let case = file.pose(&unwatched).unwrap();
    let alone = solve(&case, case.rolling(None).unwrap(), &unwatched).unwrap().solution;
    let places: Vec<usize> = (0..index.len()).filter(|k| index[*k] == 3.0).collect();
    assert_eq!(places.len(), alone.fields.len());
    let limit = 1e-4 * alone.normal.peak_pressure;
    for (place, expected) in places.iter().zip(&alone.fields.traction_x) {
        assert!((traction[*place] - expected).abs() < limit);
    }
    let contents = Reader::open(&first).unwrap().contents().clone();
    let columns: Vec<(&str, &str)> =
        contents.columns.iter().map(|c| (c.name.as_str(), c.unit.as_str())).collect();
    assert_eq!(columns, [("index", ""), ("x", "m"), ("traction_x", "Pa"), ("sliding", "")]);
    // The state that failed has no cells.
    assert!(numbers(&chunk("table.csv", 1), "index").iter().all(|index| *index == 4.0));
    // Stopped after the first batch, then finished: the same chunks.
    let calls = AtomicUsize::new(0);
    let study = bench.study().unwrap();
    let stopping = |_| match calls.fetch_add(1, Ordering::Relaxed) {
        0..8 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let stopped = run(&study, [1, 1], &bench.path("other.csv"), &stopping);
    assert!(matches!(stopped, Err(StudyError::Stopped)));
    bench.run([1, 1], "other.csv").unwrap();
    for batch in [0, 1] {
        assert_eq!(
            fs::read(chunk("table.csv", batch)).unwrap(),
            fs::read(chunk("other.csv", batch)).unwrap()
        );
    }
    // A new run does not mix its fields with others, however often it is begun.
    fs::remove_file(bench.path("other.csv")).unwrap();
    for _ in 0..2 {
        let refused = bench.run([1, 1], "other.csv").unwrap_err().to_string();
        assert!(refused.contains("fields of another run"), "{refused}");
    }
}

/// Where no method of the study has cells, there would be nothing in the chunks.
#[test]
fn fields_need_a_method_that_has_them() {
    let of = |methods: &str| {
        let text = format!("[fields]\n[vary]\nsolver.method = {methods}\n");
        Bench::new(&text).study().map(|study| study.rows()).map_err(|error| error.to_string())
    };
    let refused = of("[\"polach\", \"table\", \"kalker-linear\"]").unwrap_err();
    let expected = "study.toml:2:1: fields need a solver.method that has cells: full or fastsim";
    assert!(refused.contains(expected), "{refused}");
    assert_eq!(of("[\"polach\", \"fastsim\"]"), Ok(2));
    let bench = Bench::new("[fields]\n[vary]\nkinematics.creepage_x = [0.001]\n");
    bench.write("case.toml", "solver.method = \"shen-hedrick-elkins\"\n");
    let refused = bench.study().unwrap_err().to_string();
    assert!(refused.contains(expected), "{refused}");
}

/// Other machines send rows as text: fields are refused before anything is solved or made.
#[test]
fn a_cluster_is_not_asked_for_fields() {
    let bench = Bench::new("[fields]\n[vary]\nkinematics.creepage_x = [0.001]\n");
    let refused = Run::start_elsewhere(&bench.study().unwrap(), &bench.path("table.csv"));
    let refused = refused.unwrap_err().to_string();
    assert!(refused.contains("fields stay on the machine that solves them"), "{refused}");
    assert!(!bench.path("table.csv.parts").exists() && !bench.path("table.csv.fields").exists());
}

#[test]
fn wrong_fields_are_refused() {
    let vary = "[vary]\nkinematics.creepage_x = [0.001]\n";
    for (text, part) in [
        ("[fields]\ncolumns = [\"traction\"]\n", "there is no `traction`"),
        ("[fields]\ncolumns = []\n", "must have names, but has none"),
        ("[fields]\ncolumns = 3\n", "must be a list of names"),
        ("[fields]\ncolumns = [\"x\", \"x\"]\n", "`x` twice"),
        ("[fields]\ncolumn = [\"x\"]\n", "did you mean `columns`"),
        ("fields = true\n", "fields must be a section"),
    ] {
        let error = Bench::new(&format!("{text}{vary}")).study().unwrap_err();
        let StudyError::Input(errors) = &error else { panic!("{error}") };
        let help = errors.first.help.clone().unwrap_or_default();
        let text = format!("{error} {help}");
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
}
