//! Files of slices along a rail or around a wheel: what they mean, and what they cannot be.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;

use schlupf::unwatched;
use schlupf_case::{CaseFile, Overrides};

const CASE: &str = r#"
[normal]
model = "wheel-rail"
load = "50 kN"
[kinematics]
speed = "10 m/s"
angular_velocity = "21.7 rad/s"
[elasticity]
model = "half-space"
[friction]
model = "constant"
coefficient = 0.3
[heat]
model = "none"
[wheel]
profile = "wheel.csv"
profile_y = "outwards"
profile_z = "up"
flange_back_position = "-70 mm"
radius_x = "460 mm"
[rail]
profile = "rails/ramp.slcs"
profile_y = "outwards"
profile_z = "up"
origin_y = "750 mm"
origin_z = "0 mm"
[wheelset]
side = "left"
roll_angle = "0 mrad"
"#;

/// A crown of 300 mm, in mm, 60 mm wide and some height up; `-0.0` as a level line without it.
fn profile(crown: bool, height: f64) -> String {
    let mut text = String::from("y [mm],z [mm]\n");
    for k in -60..=60 {
        let y = 0.5 * f64::from(k);
        let z = if crown { (300.0_f64 * 300.0 - y * y).sqrt() - 300.0 } else { 0.0 };
        writeln!(text, "{y},{}", z + height).unwrap();
    }
    text
}

/// A rail that rises by 1 in 20, in metres along the track.
const RAMP: &str = "\
% three slices
0.1  1000.0   U_OFFSET [usr], U_SCALE [mm/usr]
3             NSLC
2 0 0         NFEAT, NKINK, NACCEL
1             U_INTPOL
-0.5 'low.csv'  % the first
-0.1
  'level.csv'
0.3  'high.csv'
-0.5   0.0   999.
-0.1   0.0   999.
0.3    0.0   999.
";

fn read(ramp: &str, options: &[&str]) -> Result<CaseFile, String> {
    let files = [
        ("wheel.csv", profile(false, 0.0)),
        ("rails/ramp.slcs", ramp.to_owned()),
        ("rails/wheel.slcw", ramp.to_owned()),
        ("rails/low.csv", profile(true, -20.0)),
        ("rails/level.csv", profile(true, 0.0)),
        ("rails/high.csv", profile(true, 20.0)),
    ];
    let files = files.into_iter().map(|(name, text)| (name.to_owned(), text.into_bytes()));
    let files: BTreeMap<String, Vec<u8>> = files.collect();
    let assignments: Vec<String> = options.iter().map(|option| (*option).to_owned()).collect();
    let set = Overrides { option: "--set", assignments: &assignments };
    CaseFile::from_str(CASE, "case.toml", Arc::new(files), set).map_err(|errors| errors.to_string())
}

/// With offset and scale the slices are 0.4 m apart and rise by 20 mm: the wheel rests on an
/// inclined plane of 1 in 20, ahead of its axle by R sin θ, and higher where it is further on.
#[test]
fn slices_make_a_ramp() {
    let solve = |options: &[&str]| {
        let case = read(RAMP, options).unwrap().pose(&unwatched).unwrap();
        case.wheel.unwrap()
    };
    let (here, ahead) = (solve(&[]), solve(&["wheelset.track_position=100 mm"]));
    let angle = 0.05_f64.atan();
    let contact = &here.contacts[0];
    assert!((contact.rise - angle).abs() < 2e-6, "{}", contact.rise);
    assert!((contact.position[0] - 0.46 * angle.sin()).abs() < 5e-6, "{:?}", contact.position);
    assert!((ahead.height - here.height - 5e-3).abs() < 1e-7, "{} {}", ahead.height, here.height);
}

/// A part in one slice only would be nowhere.
#[test]
fn a_part_of_one_slice_is_refused() {
    let parts = RAMP
        .replace("2 0 0         NFEAT", "3 0 0         NFEAT")
        .replace("-0.5   0.0   999.", "-0.5   0.0  30.  999.")
        .replace("-0.1   0.0   999.", "-0.1   0.0  30.  -1")
        .replace("0.3    0.0   999.", "0.3    0.0  30.  -1");
    let message = read(&parts, &[]).unwrap_err();
    let text = "part 2 of the section of rail.profile at -0.4 must be part of a section beside it";
    assert!(message.contains(text), "{message}");
}

/// The first line of the message for a changed file.
fn refused(from: &str, to: &str) -> String {
    assert!(RAMP.contains(from), "{from}");
    read(&RAMP.replace(from, to), &[]).unwrap_err()
}

#[test]
fn what_slices_cannot_be_names_line_requirement_and_value() {
    let expected = [
        ("3             NSLC", "1", "there must be at least 2 slices, but there are 1"),
        ("3             NSLC", "100000000000000", "a slice must have"),
        ("2 0 0  ", "18446744073709551615 0 0  ", "must"),
        ("3             NSLC", "4", "a slice must have its place and its file in quotes"),
        (
            "3             NSLC",
            "many",
            "the number of slices must be a whole number, but is \"many\"",
        ),
        ("1000.0 ", "-1.0 ", "the scale must be positive, but is -1"),
        ("1             U_INTPOL", "3", "must be 1 (through the slices) or 2 (smoother), but is 3"),
        ("1             U_INTPOL", "1 2", "PERTURB must be 0"),
        (
            "0.3  'high",
            "-0.2  'high",
            "slices must ascend by at least 0.001 mm, but -0.2 follows -0.1",
        ),
        (
            "high.csv",
            "highest.csv",
            "a slice must be a readable file, but is \"rails/highest.csv\"",
        ),
        ("0.3    0.0   999.", "0.2    0.0   999.", "breaks must be those of the slice at 0.3"),
        ("0.3    0.0   999.", "0.3  99.0 999.", "break 1 must be within the slice"),
        ("0.3    0.0   999.", "0.3  30. 10.", "breaks must ascend, but break 2 is 10 mm"),
        ("0.3    0.0   999.", "0.3  -1 999.", "section 3 of rail.profile"),
        (
            "0.3    0.0   999.",
            "0.3  0.0 999.\n0.4 0. 999.",
            "rails/ramp.slcs:13:1: rail.profile: the file must end here",
        ),
        ("0.3    0.0   999.", "", "the file must go on with the breaks of a slice, but ends"),
    ];
    for (from, to, text) in expected {
        let message = refused(from, to);
        assert!(message.contains(text), "{from} -> {to}: {message}");
        assert!(message.contains("rail.profile"), "{message}");
    }
    let beyond = read(RAMP, &["wheelset.track_position=0.5 m"]).unwrap_err();
    let text = "wheelset.track_position must be within the slices of rails/ramp.slcs, from -0.4 m to \
                0.4 m, but is 0.5 m";
    assert!(beyond.contains(text), "{beyond}");
    let idle = read(RAMP, &["wheelset.pitch_angle=1 rad"]).unwrap_err();
    assert!(idle.contains("wheelset.pitch_angle would be ignored"), "{idle}");
    let history = read(RAMP, &["history.time=[\"0 s\", \"1 ms\"]"]).unwrap_err();
    assert!(
        history.contains("history.time must be left out with profiles that change"),
        "{history}"
    );
    let wheel = read(RAMP, &["rail.profile=rails/wheel.slcw"]).unwrap_err();
    assert!(
        wheel.contains("the file must be that of a rail, but its name ends in .slcw"),
        "{wheel}"
    );
}
