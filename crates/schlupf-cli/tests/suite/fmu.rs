//! `schlupf fmu`: an archive, its summary, and libraries that are missing or none.

use std::fs;
use std::process::Command;

use crate::support::{Bench, Run};

/// What the command takes for a library.
const LIBRARY: &str = "... fmi3GetVersion ...";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", "solver.method = \"polach\"\nkinematics.wheel_radius = \"0.4 m\"\n");
    bench.write("library", LIBRARY);
    bench
}

#[test]
fn an_fmu_has_a_summary_and_is_the_same_whenever_it_is_made() {
    let bench = bench();
    let write = |output: &str| {
        let own = ["fmu", "case.toml", "--library", "library", "-o", output];
        bench.run(
            &[&own[..], &["--add-binary", "win64=library", "--set", "element.memory=false"]]
                .concat(),
        )
    };
    let run = write("a.fmu");
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.starts_with("a.fmu\n\nFMI        2.0: model exchange and co-simulation\n"));
    assert!(run.stdout.contains("inputs     velocity_x, velocity_y, spin_rate,"), "{}", run.stdout);
    assert!(run.stderr.starts_with("warning: solver.method = \"polach\" has no temperatures, so"));
    assert_eq!(run.stderr.lines().count(), 1, "{}", run.stderr);
    assert!(run.stdout.contains("states     none\nplatforms  "), "{}", run.stdout);
    assert!(run.stdout.contains(", win64\n"), "{}", run.stdout);
    assert_eq!(write("b.fmu").code, Some(0));
    assert!(fs::read(bench.path("a.fmu")).unwrap() == fs::read(bench.path("b.fmu")).unwrap());
}

/// The command says what to build, and where it looked.
#[test]
fn a_missing_library_is_named() {
    let bench = bench();
    let program = bench.path(&format!("alone{}", std::env::consts::EXE_SUFFIX));
    fs::copy(env!("CARGO_BIN_EXE_schlupf"), &program).unwrap();
    let arguments = ["fmu", "case.toml", "--output", "a.fmu"];
    let mut command = Command::new(&program);
    let output = command.args(arguments).current_dir(bench.path("")).output().unwrap();
    let run = Run::from(output);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    assert!(run.stderr.contains("cargo build --release --package schlupf-c"), "{}", run.stderr);
    assert!(run.stderr.contains(&*bench.path("").to_string_lossy()), "{}", run.stderr);
    assert!(!bench.path("a.fmu").exists());
}

#[test]
fn wrong_libraries_are_refused() {
    let bench = bench();
    for (arguments, code, message) in [
        (&["--library", "case.toml"][..], 1, "case.toml: must be a library of the crate schlupf-c"),
        (&["--library", "nothing"], 1, "nothing: "),
        (&["--add-binary", "win64"], 2, "must be PLATFORM=FILE"),
        (&["--add-binary", "../x=library"], 2, "must be PLATFORM=FILE"),
        (
            &["--library", "library", "--add-binary", "a=library", "--add-binary", "a=library"],
            2,
            "a has a library already",
        ),
        (&["--library", "library", "--output", "library"], 2, "also a library"),
        (&["--library", "library", "--output", "case.toml"], 2, "also the case file"),
        (&["--fmi", "1"], 2, "[possible values: 2, 3]"),
    ] {
        let run = bench.run(&[&["fmu", "case.toml"], arguments].concat());
        assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(message), "{arguments:?}: {}", run.stderr);
    }
    assert_eq!(bench.list(), ["case.toml", "library"]);
}
