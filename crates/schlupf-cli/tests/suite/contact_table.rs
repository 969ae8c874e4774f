//! `schlupf table CASE`: the contacts of a wheel with two profiles, wrong options and cases.

use std::fs;

use crate::support::Bench;

const CASE: &str = r#"
[kinematics]
speed = "20 m/s"
[normal]
model = "wheel-rail"
load = "50 kN"
[wheel]
profile = "S1002"
radius_x = "460 mm"
[rail]
profile = "60E1"
cant = 0.025
[friction]
model = "constant"
[solver]
method = "polach"
"#;

/// Few nodes and poses.
const QUICK: [&str; 10] = [
    "table",
    "case.toml",
    "--largest-roll-angle",
    "2 mrad",
    "--largest-yaw-angle",
    "2 mrad",
    "--most-nodes",
    "1",
    "--states",
    "10",
];

/// A table that is not within the tolerance is there and says so, but the exit code is that of what
/// did not converge. The wheel of the case rolls by its table; that of another one is refused, and
/// so is a file with other axes than those that its checksum is of.
#[test]
fn a_table_serves_its_wheel_only() {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    let strict = [&QUICK[..], &["--tolerance", "0.0001", "--output", "contacts.npz"]].concat();
    let run = bench.run(&strict);
    assert_eq!(run.code, Some(3), "{}", run.stderr);
    assert!(run.stdout.contains("\nnot within the tolerance: the nodes are"), "{}", run.stdout);
    assert_eq!(bench.list(), ["case.toml", "contacts.npz"]);
    assert!(run.stdout.starts_with("contacts.npz\n\nnodes      "), "{}", run.stdout);
    assert!(run.stdout.contains(" x 5 x 3 x 5: place on the wheel, roll"), "{}", run.stdout);
    assert!(run.stdout.contains("\nload       median 0."), "{}", run.stdout);
    let check = |table: &str, more: &[&str]| {
        let own = format!("element.contact_table={table}");
        bench.run(&[&["check", "case.toml", "--set", &own], more].concat())
    };
    let own = check("contacts.npz", &[]);
    assert_eq!(own.code, Some(0), "{}", own.stderr);
    let other = check("contacts.npz", &["--set", "wheel.radius_x=\"450 mm\""]);
    assert_eq!(other.code, Some(2), "{}", other.stderr);
    assert!(other.stderr.contains("element.contact_table: contacts.npz is "), "{}", other.stderr);
    let mut bytes = fs::read(bench.path("contacts.npz")).unwrap();
    let axes = b"axes.npy";
    let at = bytes.windows(axes.len()).position(|window| window == axes).unwrap();
    // Behind the header of the array.
    bytes[at + axes.len() + 128 + 7] ^= 1;
    fs::write(bench.path("damaged.npz"), bytes).unwrap();
    let damaged = check("damaged.npz", &[]);
    assert_eq!(damaged.code, Some(2), "{}", damaged.stderr);
    assert!(damaged.stderr.contains("element.contact_table: damaged.npz"), "{}", damaged.stderr);
}

#[test]
fn wrong_options_are_told_in_their_names() {
    let bench = Bench::new();
    bench.write("case.toml", CASE);
    for (option, value, message) in [
        ("--tolerance", "5", "--tolerance must be between 1e-4 and 0.5, but is 5"),
        ("--states", "0", "--states must be at least 1, but is 0"),
        ("--largest-yaw-angle", "5 mm", "--largest-yaw-angle"),
        ("--largest-roll-angle", "0.01 mrad", "--largest-roll-angle must be between"),
    ] {
        let run = bench.run(&["table", "case.toml", option, value]);
        assert_eq!(run.code, Some(2), "{option}: {}", run.stderr);
        assert!(run.stderr.contains(message), "{option}: {}", run.stderr);
    }
    let run = bench.run(&["table", "case.toml", "--set", "normal.model=hertz"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("normal.model: a table of contacts"), "{}", run.stderr);
    assert_eq!(bench.list(), ["case.toml"]);
}
