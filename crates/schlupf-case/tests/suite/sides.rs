//! Wheels and rails that differ from side to side, rails that are placed by their origin, and
//! rollers, as a case gives them.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;

use schlupf::unwatched;
use schlupf::wheel_rail::{Roll, RollingRadiusDifference, WheelOnRail};
use schlupf_case::{CaseFile, Overrides};

const HEAD: &str = "\
[normal]
model = \"wheel-rail\"
load = \"80 kN\"
[kinematics]
speed = \"20 m/s\"
[wheel]
profile = \"S1002\"
radius_x = \"460 mm\"
[rail]
profile = \"60E1\"
cant = 0.025
";

/// A case with a cone 1:20 in a file, in m, or its message.
fn read(text: &str) -> Result<CaseFile, String> {
    let mut cone = String::new();
    for k in -60..=60 {
        let y = f64::from(k);
        writeln!(cone, "{y},{}", 0.05 * y).unwrap();
    }
    let files: BTreeMap<String, Vec<u8>> = [("cone.csv".to_owned(), cone.into_bytes())].into();
    CaseFile::from_str(text, "case.toml", Arc::new(files), Overrides::NONE)
        .map_err(|errors| errors.to_string())
}

fn wheel(more: &str) -> WheelOnRail {
    let file = read(&format!("{HEAD}{more}")).unwrap_or_else(|error| panic!("{error}"));
    file.wheel().unwrap().clone()
}

fn message(text: &str) -> String {
    read(text).err().unwrap_or_default()
}

/// Without fields of one side both have one pair; each profile is told once.
#[test]
fn sides_are_alike_by_default() {
    let pairs = wheel("").pairs;
    assert!(pairs.are_one());
    let pairs = wheel("[left_wheel]\nradius_x = \"460 mm\"\n").pairs;
    assert!(pairs.are_one());
    let names = |more: &str| -> Vec<String> {
        let file = read(&format!("{HEAD}{more}")).unwrap();
        file.profiles().iter().map(|profile| profile.field.to_string()).collect()
    };
    assert_eq!(names("[right_rail]\nroll_angle = \"1 mrad\"\n"), ["wheel.profile", "rail.profile"]);
    let own = "[left_wheel]\nprofile = \"cone.csv\"\nprofile_z = \"up\"\n";
    assert_eq!(names(own), ["left_wheel.profile", "wheel.profile", "rail.profile"]);
}

/// A left wheel with a radius 0.4 mm larger: so is Δr in the middle of the track.
#[test]
fn radii_of_both_sides() {
    let difference = |more: &str| {
        let pairs = wheel(more).pairs;
        RollingRadiusDifference::new(&pairs, (1e-3, 1), Roll::Neglected, &unwatched).unwrap()
    };
    let alike = difference("").at(0.0).unwrap();
    assert_eq!(alike, 0.0);
    let own = difference("[left_wheel]\nradius_x = \"460.4 mm\"\n").at(0.0).unwrap();
    assert!((own - 0.4e-3).abs() < 1e-9, "{own}");
}

/// An irregularity moves the rail of its side, in the axes of the track.
#[test]
fn irregularities_are_in_the_axes_of_the_track() {
    let origin = wheel("").pairs.left.rail_origin();
    let moved = "lateral_displacement = \"2 mm\"\nvertical_displacement = \"-1 mm\"\n";
    let pairs = wheel(&format!("[left_rail]\n{moved}[right_rail]\n{moved}")).pairs;
    for (pair, sign) in [(&pairs.left, 1.0), (&pairs.right, -1.0)] {
        let [y, z] = pair.rail_origin();
        assert!((y - origin[0] - sign * 2e-3).abs() < 1e-12, "{y}");
        assert!((z - origin[1] + 1e-3).abs() < 1e-12, "{z}");
    }
}

/// A rail has its gauge or the place of its origin; one side may have its own.
#[test]
fn rails_by_their_origin() {
    let placed = HEAD.replace("cant = 0.025", "cant = 0.025\norigin_y = \"752 mm\"");
    let text = format!("{placed}origin_z = \"1 mm\"\n[right_rail]\norigin_y = \"750 mm\"\n");
    let pairs = read(&text).unwrap().wheel().unwrap().pairs.clone();
    assert_eq!(pairs.left.rail_origin(), [0.752, 1e-3]);
    assert_eq!(pairs.right.rail_origin(), [0.75, 1e-3]);
    let both = message(&format!("{placed}[track]\ngauge = \"1435 mm\"\n"));
    assert!(both.contains("track.gauge must not be given together with rail.origin_y"), "{both}");
}

/// The same cone in mm and, with a scale, in m.
#[test]
fn profiles_have_a_scale() {
    let cone = "profile = \"cone.csv\"\nprofile_z = \"up\"\nprofile_y = \"outwards\"\n";
    let pair = |scale: &str| {
        let text = HEAD.replace("profile = \"S1002\"", &format!("{cone}{scale}"));
        read(&text).unwrap().wheel().unwrap().pairs.left.clone()
    };
    assert!(
        (pair("").wheel().length() / pair("profile_scale = 0.5").wheel().length() - 2.0).abs()
            < 1e-9
    );
}

/// The angular velocity of a roller makes v0, with profiles and without, and with that of the wheel
/// the creepage: ξ = 1 − ω R/(ω_r R_r).
#[test]
fn rollers_turn() {
    let roller = "radius_x = \"0.5 m\"\nangular_velocity = \"40 rad/s\"\n";
    let profiles = HEAD.replace("speed = \"20 m/s\"", "angular_velocity = \"43 rad/s\"");
    let motion = read(&format!("{profiles}{roller}")).unwrap().wheel().unwrap().motion;
    assert_eq!([motion.speed, motion.angular_velocity], [20.0, 43.0]);
    let hertz = "[kinematics]\nangular_velocity = \"398 rad/s\"\n[wheel]\nradius_x = \"50 mm\"\n\
                 radius_y = \"100 mm\"\n[rail]\nradius_y = \"inf\"\n[normal]\nload = \"1 kN\"\n";
    let discs = hertz.replace("[rail]\n", &format!("[rail]\n{roller}"));
    let case = read(&discs).unwrap().pose(&unwatched).unwrap();
    let motion = case.problem.kinematics;
    assert_eq!(motion.speed, 20.0);
    assert!((motion.creepage_x - 0.005).abs() < 1e-12, "{}", motion.creepage_x);
    assert!(case.problem.normal.normal_contact(None).is_ok());
    let both = message(&format!("{HEAD}{roller}"));
    assert!(both.contains("given together with rail.angular_velocity"), "{both}");
    let straight = message(&discs.replace("radius_x = \"0.5 m\"\n", ""));
    assert!(straight.contains("is that of a roller, which needs its rail.radius_x"), "{straight}");
    let backwards = message(&discs.replace("\"40 rad/s", "\"-40 rad/s"));
    assert!(backwards.contains("must be positive, for a roller to roll forwards"), "{backwards}");
}
