//! `schlupf import`: names of files, what is not overwritten, and what is not available.

use crate::support::Bench;

/// A ball that brakes, a second case for FASTSIM with a given flexibility, which is not available,
/// and a third one with more creepage.
const INPUT: &str = "\
% A ball that brakes
 3  MODULE
  203100    P-B-T-N-F-S
  022020    L-D-C-M-Z-E
 0000111    H-G-I-A-O-W-R
  999 100 30 1 1e-5   MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 52359.878 0.001 0.0 0.0    FN, CKSI, CETA, CPHI
 0.3 0.3   FSTAT, FKIN
 0d 0.25 30000.   CHI, DQ, VELOC
 0.28 0.28 82031.25 82031.25   POISS 1,2, GG 1,2
 -3
 22 22 5.0 5.0 1.1   MX, MY, AA, BB, SCALE

 3  MODULE
  203100    P-B-T-N-F-S
  102200    L-D-C-M-Z-E
 0100111    H-G-I-A-O-W-R
 52359.878 0.002 0.0 0.0    FN, CKSI, CETA, CPHI
 0d 0.25 30000.   CHI, DQ, VELOC
 0.28 0.28 82031.25 82031.25   POISS 1,2, GG 1,2
 1e-5 1. 1. 1.   FLX, K0_MF, ALFAMF, BETAMF

 3  MODULE
  203100    P-B-T-N-F-S
  100000    L-D-C-M-Z-E
 0100111    H-G-I-A-O-W-R
 52359.878 0.003 0.0 0.0    FN, CKSI, CETA, CPHI
 0  MODULE
";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("ball.inp", INPUT);
    bench
}

/// Cases that are available are written, and `check` and `solve` accept them; the exit code is that
/// of wrong input where one is not, and what is missing is named once with its line.
#[test]
fn what_is_available_is_written() {
    let bench = bench();
    let run = bench.run(&["import", "ball.inp"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert_eq!(bench.list(), ["ball.inp", "ball_1.toml", "ball_3.toml"]);
    assert_eq!(
        run.stdout,
        "wrote ball_1.toml: A ball that brakes\nwrote ball_3.toml: ball.inp, case 3\n\
         case 2: not available, see the errors\n"
    );
    let fast = "ball.inp:16:6: M = 2: FASTSIM with a flexibility FLX that is given";
    assert_eq!(run.stderr.matches(fast).count(), 1, "{}", run.stderr);
    assert!(
        run.stderr.contains("G, I, A, O, W, MAXGS … EPS, DQ, FACPHI set CONTACT's own"),
        "{}",
        run.stderr
    );
    assert_eq!(bench.run(&["check", "ball_3.toml"]).code, Some(0));
    let run = bench.run(&["solve", "ball_1.toml"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout.contains("A ball that brakes"), "{}", run.stdout);
}

/// Nothing is overwritten, and nothing is written beside what would be; one case has no number.
#[test]
fn existing_files_stay() {
    let bench = bench();
    bench.write("ball_3.toml", "mine");
    let run = bench.run(&["import", "ball.inp"]);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    assert!(run.stderr.contains("ball_3.toml: there is a file already; --force"), "{}", run.stderr);
    assert_eq!(bench.list(), ["ball.inp", "ball_3.toml"]);
    assert_eq!(bench.read("ball_3.toml"), "mine");
    let run = bench.run(&["import", "ball.inp", "--output", "new/cases", "--quiet"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""));
    assert!(bench.path("new/cases/ball_3.toml").exists());
    let run = bench.run(&["import", "ball.inp", "--force"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(bench.read("ball_3.toml").contains("creepage_x = 0.003"));
    let end = INPUT.find("\n 3  MODULE\n  203100    P-B-T-N-F-S\n  102200").unwrap();
    bench.write("one.inp", &format!("{}\n 0\n", &INPUT[..end]));
    let run = bench.run(&["import", "one.inp", "--wheel-body", "2"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(bench.read("one.toml").contains("creepage_x = -0.001"));
    bench.write("own.toml", &bench.read("one.inp"));
    let run = bench.run(&["import", "own.toml", "--force"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("own.toml is also the input file"), "{}", run.stderr);
}

/// Text as editors on other systems write it: with a byte order mark, in UTF-16, with comments in
/// Latin-1.
#[test]
fn encodings_of_input_files() {
    let bench = Bench::new();
    let end = INPUT.find("\n 3  MODULE\n  203100    P-B-T-N-F-S\n  102200").unwrap();
    let text = format!("{}\n 0\n", &INPUT[..end]);
    let utf_16 = text.encode_utf16().flat_map(u16::to_le_bytes);
    let encoded: [(&str, Vec<u8>); 4] = [
        ("plain", text.clone().into_bytes()),
        ("mark", format!("\u{feff}{text}").into_bytes()),
        ("wide", [0xff, 0xfe].into_iter().chain(utf_16).collect()),
        ("latin", [b"% Stra\xdfe\n".as_slice(), text.as_bytes()].concat()),
    ];
    for (name, bytes) in encoded {
        let name = format!("{name}.inp");
        std::fs::write(bench.path(&name), bytes).unwrap();
        let run = bench.run(&["import", &name]);
        assert_eq!(run.code, Some(0), "{name}: {}", run.stderr);
    }
    let case = |name: &str| bench.read(name).lines().skip(3).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(case("mark.toml"), case("plain.toml"));
    assert_eq!(case("wide.toml"), case("plain.toml"));
}

/// A table that a case needs is written beside it.
#[test]
fn a_distance_is_a_file_of_its_own() {
    let bench = Bench::new();
    let end = INPUT.find("\n 3  MODULE\n  203100    P-B-T-N-F-S\n  102200").unwrap();
    let area = " 1\n 40 40 -8. -8. 0.4 0.4\n 1 1\n 0.0016 0.0004 0.0016 0 0 0\n 0\n";
    let text = INPUT[..end].replace(" -3\n 22 22 5.0 5.0 1.1   MX, MY, AA, BB, SCALE\n", area);
    bench.write("skew.inp", &text);
    let run = bench.run(&["import", "skew.inp", "--output", "cases"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(bench.path("cases/skew_distance.csv").exists());
    let run = bench.run(&["check", "cases/skew.toml"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

/// Paths of profiles lead from the case files to them; one that is missing is named once, with the
/// line that names it.
#[test]
fn profiles_are_found_from_the_cases() {
    let bench = Bench::new();
    let rail = std::fs::read(format!(
        "{}/../../data/profile_uic60_canted.csv",
        env!("CARGO_MANIFEST_DIR")
    ));
    let wheel =
        std::fs::read(format!("{}/../../data/profile_s1002.csv", env!("CARGO_MANIFEST_DIR")));
    let text = "\
 1
 1203100
 0022033
 0000321
 999 100 30 1 1e-5
 0.3 0.3
 0.28 0.28 82000. 82000.
 0.2 0.2 1.0 90d 8.0 4.0
 14.0 0 1435.0 0.0
 'profiles\\rail.csv' 0 1.0 0.0
 0 0 0 0 0 0
 1360. -70. 460.
 'wheel.csv' 0 1.0 0.0
 0.0 3.0 10000. 0.0 0.0 0.0
 2000. 0 0 0 0 -4.34
 1
 1203100
 0111002
 0100321
 0.0 4.0 10000. 0.0 0.0 0.0
 2000. 0 0 0 0 -4.34
 0
";
    bench.write("wheel.inp", text);
    std::fs::create_dir(bench.path("profiles")).unwrap();
    std::fs::write(bench.path("profiles/rail.csv"), rail.unwrap()).unwrap();
    let run = bench.run(&["import", "wheel.inp", "--output", "cases"]);
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    let missing = "wheel.inp:13:2: wheel.profile must be the path of a readable file";
    assert_eq!(run.stderr.matches(missing).count(), 1, "{}", run.stderr);
    assert!(!bench.path("cases/wheel_1.toml").exists());
    std::fs::write(bench.path("wheel.csv"), wheel.unwrap()).unwrap();
    let run = bench.run(&["import", "wheel.inp", "--output", "cases"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let text = bench.read("cases/wheel_2.toml");
    for line in [
        "profile = \"../profiles/rail.csv\"",
        "lateral_position = \"-4 mm\"",
        "angular_velocity = \"4.34 rad/s\"",
        "join_distance = \"8 mm\"",
        "row_motion = \"plane\"",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    let run = bench.run(&["check", "cases/wheel_2.toml"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

/// What is no input file.
#[test]
fn wrong_files_are_named() {
    let bench = bench();
    for (name, bytes, code, expected) in [
        ("none.inp", None, 1, "none.inp: the input file cannot be read"),
        ("zero.inp", Some(&b"3\0"[..]), 2, "zero.inp: the input file must be text, but is not"),
        ("text.inp", Some(b"hello"), 2, "text.inp:1:1: MODULE must be a whole number"),
        ("empty.inp", Some(b"% nothing\n"), 2, "empty.inp: the input file has no cases"),
        ("zeros.inp", Some(b" 0 MODULE\n"), 2, "zeros.inp: the input file has no cases"),
    ] {
        if let Some(bytes) = bytes {
            std::fs::write(bench.path(name), bytes).unwrap();
        }
        let run = bench.run(&["import", name]);
        assert_eq!(run.code, Some(code), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(expected), "{name}: {}", run.stderr);
    }
}

/// Cases that differ in numbers only become a study on request, which `sweep` runs: its rows are
/// those of the cases by themselves.
#[test]
fn cases_become_a_study() {
    let bench = bench();
    let run = bench.run(&["import", "ball.inp", "--study"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert_eq!(
        run.stdout,
        "wrote ball_1_study.toml: cases 1, 3 as 2 states of ball_1.toml\n\
         case 2: not available, see the errors\n"
    );
    let names = ["ball.inp", "ball_1.toml", "ball_1_states.csv", "ball_1_study.toml"];
    assert_eq!(bench.list(), names);
    let run = bench.run(&["sweep", "ball_1_study.toml", "--output", "forces.csv"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let table = bench.read("forces.csv");
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let head = rows.iter().position(|row| row.contains(&"force.x")).unwrap();
    let place = rows[head].iter().position(|name| *name == "force.x").unwrap();
    let run = bench.run(&["import", "ball.inp", "--force", "--quiet"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    for (row, case) in [(head + 1, "ball_1.toml"), (head + 2, "ball_3.toml")] {
        let run = bench.run(&["solve", case, "--quiet", "--json", "-"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        let [found, expected] =
            [rows[row][place].parse::<f64>().unwrap(), json["force"]["x"].as_f64().unwrap()];
        assert!((found - expected).abs() < 1e-6 * expected.abs(), "{case}: {found}, {expected}");
    }
}

/// A directory that is made for the cases: profiles are found from it, the first time and the
/// second.
#[test]
fn profiles_are_found_from_a_directory_that_is_made() {
    let bench = Bench::new();
    for (name, of) in [("rail.csv", "profile_uic60_canted.csv"), ("wheel.csv", "profile_s1002.csv")]
    {
        let bytes = std::fs::read(format!("{}/../../data/{of}", env!("CARGO_MANIFEST_DIR")));
        std::fs::write(bench.path(name), bytes.unwrap()).unwrap();
    }
    bench.write("wheel.inp", POSITION);
    for (more, code) in [(&[][..], 0), (&["--force"], 0)] {
        let import = ["import", "wheel.inp", "--output", "new/deep/cases"];
        let run = bench.run(&[&import[..], more].concat());
        assert_eq!(run.code, Some(code), "{}", run.stderr);
        assert!(run.stderr.contains("contacts closer than D_SEP"), "{}", run.stderr);
    }
    let case = bench.read("new/deep/cases/wheel.toml");
    assert!(case.contains("profile = \"../../../rail.csv\""), "{case}");
    assert_eq!(bench.run(&["check", "new/deep/cases/wheel.toml"]).code, Some(0));
}

/// One position of a left wheel on a rail.
const POSITION: &str = "\
 1  MODULE
  0203100    C-P-B-T-N-F-S
  0022033    V-L-D-C-M-Z-E
  0000111    H-G-I-A-O-W-R
  200 100 30 1 1e-5
 0.3 0.3   FSTAT, FKIN
 0.28 0.28 82000. 82000.
 0.2 0.2 1.0 90d 8.0 4.0   DX, DS, DQREL, A_SEP, D_SEP, D_COMB
 14. 0 1435. 0.0   GAUGHT, GAUGSQ, GAUGWD, CANT
 'rail.csv' 0 1.0 0.0
 0. 0. 0. 0. 0. 0.
 1360. -70. 460.
 'wheel.csv' 0 1.0 0.0
 0. 0.0 80000. 0. 0. 0.
 20000. 0. 0. 0. 0. -43.478
 0
";

/// A value that the case file refuses is told where it stands, and a decimal comma at its column.
#[test]
fn wrong_values_are_told_at_their_line_and_column() {
    let bench = Bench::new();
    let end = INPUT.find("\n 3  MODULE\n  203100    P-B-T-N-F-S\n  102200").unwrap();
    for (from, to, told) in [
        (" 0d 0.25 30000.", " 0d 0.25 -30000.", "ball.inp:9:10: kinematics.speed must be"),
        (" 0.28 0.28 82031", " 0.28 0,28 82031", "ball.inp:10:7: POISS2 must be a number, but is"),
        ("52359.878 0.001", "52359,878 0.001", "ball.inp:7:2: FN must be a number, but is `52359,"),
    ] {
        bench.write("ball.inp", &INPUT[..end].replace(from, to));
        let run = bench.run(&["import", "ball.inp"]);
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        assert!(run.stderr.contains(told), "{told}: {}", run.stderr);
        assert_eq!(bench.list(), ["ball.inp"]);
    }
}
