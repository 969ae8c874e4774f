//! The commands that do not solve, from the outside.

use crate::support::Bench;
use serde_json::Value;

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
    assert_eq!(bench.run(&["init", "case.toml/case.toml"]).code, Some(1));
    assert_eq!(bench.list(), ["case.toml"]);
}

/// A condition by name makes a case that says where its numbers are from, and that converges at
/// all creepages.
#[test]
fn init_writes_a_condition_of_the_rail() {
    let bench = Bench::new();
    // Polach 2005, the grease and the leaves of Olofsson and Lewis 2006, and sand of Hou 1997.
    for (name, source, friction) in [
        ("dry", "Wear 258", 0.55),
        ("wet", "Wear 258", 0.30),
        ("leaves", "Handbook of Railway Vehicle Dynamics", 0.075),
        ("oil", "Handbook of Railway Vehicle Dynamics", 0.075),
        ("sanded", "Hou, Kalousek and Magel", 0.55),
    ] {
        let written = bench.run(&["init", "case.toml", "--condition", name, "--force"]);
        assert_eq!(written.code, Some(0), "{}", written.stderr);
        let text = bench.read("case.toml");
        assert!(text.contains(&format!("# {name}: ")) && text.contains(source), "{text}");
        assert_eq!(text.contains("\n[layer]"), name == "sanded");
        let coarse = ["--set", "grid.cells_x=12", "--set", "grid.cells_y=12"];
        let arguments = [&["solve", "case.toml", "--json", "-"], &coarse[..]].concat();
        let run = bench.run(&arguments);
        assert_eq!(run.code, Some(0), "{name}: {}", run.stderr);
        let found: Value = serde_json::from_str(&run.stdout).unwrap();
        // Braking at ξ = 0.008: no more than friction, and most of it where that is low.
        let used = -found["force"]["x"].as_f64().unwrap() / 80e3 / friction;
        assert!(used > 0.4 && used <= 1.0, "{name}: {used}");
        let arguments = ["curve", "case.toml", "--creepage-x", "0..0.1", "--points", "21"];
        let run = bench.run(&[&arguments, &coarse[..], &["--json", "-"]].concat());
        assert_eq!(run.code, Some(0), "{name}: {}", run.stderr);
        let found: Value = serde_json::from_str(&run.stdout).unwrap();
        let products = found["curves"][0]["work"]["operator_products"].as_f64().unwrap();
        assert!(products < 21.0 * 100.0, "{name}: {products}");
    }
    let run = bench.run(&["init", "--condition", "icy"]);
    assert_eq!(run.code, Some(2));
    for part in ["--condition", "icy", "dry", "wet", "leaves", "oil", "sanded"] {
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
}

#[test]
fn check_says_what_it_would_solve() {
    let bench = Bench::new();
    bench.run(&["init"]);
    let run = bench.run(&["check", "case.toml", "--set", "normal.load=60 kN"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    for part in ["steel wheel", "load 60 kN", "24 x 24", "kinematics.speed", "\"60 kN\"  (--set)"] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
    assert_eq!(bench.list(), ["case.toml"]);
}

/// What was read of profiles is told and drawn, also where the wheel does not touch the rail.
#[test]
fn check_shows_and_draws_profiles() {
    let bench = Bench::new();
    let case = "wheel.profile = \"S1002\"\nrail = { profile = \"60E1\", cant = 0.025 }\n\
                normal = { model = \"wheel-rail\", load = \"80 kN\" }\n";
    bench.write("case.toml", case);
    let read = [
        "wheel.profile: S1002",
        "129.5 mm wide, 30.6357 mm high",
        "y outwards (by its shape), z up (by its shape)",
        "back at y = -70 mm",
        "rail.profile: 60E1",
    ];
    for (position, code) in [("0 mm", 0), ("200 mm", 2)] {
        let set = format!("wheelset.lateral_position={position}");
        let run = bench.run(&["check", "case.toml", "--set", &set, "--figures", "figures"]);
        assert_eq!(run.code, Some(code), "{}", run.stderr);
        for part in read {
            assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
        }
        let drawing = std::fs::read_to_string(bench.path("figures/profiles.svg")).unwrap();
        assert!(drawing.contains("Profiles in place"));
        std::fs::remove_dir_all(bench.path("figures")).unwrap();
    }
    let run = bench.run(&["check", "--figures", "figures"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("--figures draws the profiles of a case"), "{}", run.stderr);
}

/// Microwatts are not told in kilowatts.
#[test]
fn powers_have_a_unit_of_their_size() {
    let small = ["--set", "grid.cells_x=8", "--set", "grid.cells_y=8", "--set"];
    let power = |creepage: &str| {
        let run = Bench::new().run(&[&["solve"], &small[..], &[creepage]].concat());
        let line = run.stdout.lines().find(|line| line.starts_with("friction power"));
        line.unwrap().split_whitespace().nth(3).unwrap().to_owned()
    };
    assert_eq!(power("kinematics.creepage_x=0.008"), "kW");
    assert_eq!(power("kinematics.creepage_x=1e-6"), "µW");
}

#[test]
fn check_shows_the_creepages_of_a_moving_wheel() {
    let bench = Bench::new();
    bench.write("case.toml", "[kinematics]\nspeed = \"30 m/s\"\nyaw_angle = \"1 deg\"\n");
    let stdout = bench.run(&["check", "case.toml"]).stdout;
    assert!(stdout.contains("ξ = 0, η = -0.01745"), "{stdout}");
}

/// What the models that were chosen do not use is not listed, nor a load that the file gives.
#[test]
fn check_lists_fields_with_an_effect_only() {
    let bench = Bench::new();
    let fields = |text: &str| {
        bench.write("case.toml", text);
        let run = bench.run(&["check", "case.toml"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        run.stdout
    };
    let ellipse = "normal = { model = \"ellipse\", semi_axis_x = \"5 mm\", semi_axis_y = \"5 mm\", \
                   load = \"50 kN\" }\n";
    let turning = fields(ellipse);
    // The default of the rolling radius.
    assert!(turning.contains("wheel.radius_x") && !turning.contains("rail.radius_x"), "{turning}");
    let cold = fields("heat.model = \"none\"\n");
    assert!(!cold.contains("conductivity") && cold.contains("young_modulus"), "{cold}");
    bench.write("p.csv", "x [mm],y [mm],pressure [MPa]\n0,0,900\n1,0,500\n0,1,500\n1,1,300\n");
    let table = fields("normal = { model = \"tabulated\", file = \"p.csv\" }\n");
    assert!(!table.contains("normal.load") && table.contains("normal.file"), "{table}");
    let forces = fields("solver.method = \"polach\"\n");
    assert!(!forces.contains("\ncells ") && !forces.contains("\nk_c "), "{forces}");
    let cooled = fields("cooling = { film_coefficient = \"40 W/(m^2 K)\", area = \"1.5 m^2\" }\n");
    assert!(cooled.contains("(schlupf bulk only)"), "{cooled}");
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

/// The help of every command begins with what it does, and no two begin alike.
#[test]
fn help_says_what_each_command_does() {
    let help = Bench::new().run(&["--help"]).stdout;
    assert!(help.starts_with("Rolling contact of wheel and rail: "), "{help}");
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let lines = lines.take_while(|line| !line.is_empty());
    let mut all: Vec<&str> =
        lines.filter_map(|line| line.trim().split_once("  ")).map(|l| l.1.trim()).collect();
    let count = all.len();
    all.sort_unstable();
    all.dedup();
    assert!(count > 15 && all.len() == count, "{help}");
    let run = Bench::new().run(&["curve", "--help"]);
    assert!(run.stdout.contains("creep curve"), "{}", run.stdout);
}

#[test]
fn help_lists_the_exit_codes() {
    let run = Bench::new().run(&["solve", "--help"]);
    assert_eq!(run.code, Some(0));
    assert!(run.stdout.contains("3  not converged"), "{}", run.stdout);
    assert_eq!(Bench::new().run(&[]).code, Some(2));
}
