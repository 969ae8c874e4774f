//! Inputs of CONTACT's module 1 in which rails are placed by their origin, rails and wheels
//! deviate, wheels run on rollers, and tracks are curved.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;

use super::support::has;
use schlupf::wheel_rail::WheelSolution;
use schlupf_case::import::contact::{self, Import, Options};
use schlupf_case::{CaseFile, Overrides, Source};

/// A profile of height z(y) over ±50 mm, both in mm.
fn profile(z: impl Fn(f64) -> f64) -> String {
    let mut text = "y [mm],z [mm]\n".to_owned();
    for k in -500..=500 {
        let y = 0.1 * f64::from(k);
        writeln!(text, "{y},{}", z(y)).unwrap();
    }
    text
}

/// Lines of an input that differ.
struct Input {
    /// Digit C1.
    side: u8,
    /// Digit N: whether the vertical force is given.
    force: u8,
    /// FKIN and the shear modulus.
    material: [&'static str; 2],
    track: &'static str,
    rail: &'static str,
    rail_deviation: &'static str,
    wheelset: &'static str,
    wheel: &'static str,
    position: &'static str,
    velocity: &'static str,
    wheel_deviation: &'static str,
}

fn import(input: &Input) -> Import {
    let Input { side, force, material: [friction, shear], .. } = input;
    let text = format!(
        " 1 MODULE\n {side}203{force}00\n 0022035\n 0000321\n 999 100 30 1 1e-7\n\
         {friction} {friction}\n 0.28 0.28 {shear} {shear}\n 0.2 0.2 1.0 90d 8.0 4.0\n {}\n\
         '{}.csv' 0 1.0 0.0 -1\n {}\n {}\n '{}.csv' 0 1.0 0.0 -1\n {}\n {}\n {}\n 0 0 0 0 0 0\n 0\n",
        input.track,
        input.rail,
        input.rail_deviation,
        input.wheelset,
        input.wheel,
        input.position,
        input.velocity,
        input.wheel_deviation
    );
    let source = Arc::new(Source { name: "a.inp".to_owned(), text });
    contact::import(&source, &Options { stem: "a".to_owned(), ..Options::default() })
}

/// The text of its only case, and the wheel, solved.
fn solved(input: &Input) -> (String, Arc<WheelSolution>) {
    let mut import = import(input);
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    let text = import.cases.remove(0).text;
    let ball = |y: f64| (100.0_f64.powi(2) - y * y).sqrt() - 100.0;
    let files: BTreeMap<String, Vec<u8>> = [
        ("plane.csv", profile(|_| 0.0)),
        ("cone.csv", profile(|y| 0.2_f64.tan() * y)),
        ("up.csv", profile(|y| -ball(y))),
        ("down.csv", profile(ball)),
    ]
    .into_iter()
    .map(|(name, text)| (name.to_owned(), text.into_bytes()))
    .collect();
    let file = CaseFile::from_str(&text, "a.toml", Arc::new(files), Overrides::NONE);
    let case = file.unwrap_or_else(|errors| panic!("{errors}\n{text}"));
    let wheel = case.pose(&schlupf::unwatched).unwrap_or_else(|errors| panic!("{errors}\n{text}"));
    (text, wheel.wheel.unwrap())
}

/// x, y and z (in mm) and angle (in rad) of the contact, Fn, Fx and Fs (in N) as in an output of
/// CONTACT: y to the right, z downwards, forces on the rail. Positions within 0.5 µm and the digits
/// printed, forces within `most` of the friction limit.
fn compare(wheel: &WheelSolution, expected: [f64; 7], (friction, most): (f64, f64)) {
    let [contact] = &wheel.contacts[..] else { panic!("{} contacts", wheel.contacts.len()) };
    let ([x, y, z], force) = (contact.position, contact.solution.force);
    let load = contact.solution.normal.load;
    let found = [1e3 * x, -1e3 * y, -1e3 * z, -contact.angle, load, -force.x, force.y];
    let limit = friction * load;
    let within = [6e-4, 6e-4, 6e-4, 6e-5, 2.5e-3 * load, most * limit, most * limit];
    for (k, found) in found.into_iter().enumerate() {
        assert!((found - expected[k]).abs() < within[k], "{k}: {found}, not {}", expected[k]);
    }
}

/// A wheel that is an ellipsoid of 133.3 and 100 mm, 1.87 mm above its nominal height, on a roller
/// of 400 mm with a cone of 0.2 rad.
const ON_CONE: Input = Input {
    side: 5,
    force: 0,
    material: ["0.3", "82000."],
    track: "-1.0 200.0 0.0 400.0   GAUGHT, RAILY0, RAILZ0, NOMRADR",
    rail: "cone",
    rail_deviation: "0 0 0 0 0 0",
    wheelset: "200. -100. 133.33333",
    wheel: "down",
    position: "0. 0. -1.870 0. 0. 0.",
    velocity: "0.24381 0. 0. 0. 0. -0.75   RPITCH, VY, VZ, VROLL, VYAW, VPITCH",
    wheel_deviation: "0 0 0 0 0 0",
};

/// CONTACT (rev. 2707, testbank, test-rollers2, cases 10 to 12): on a cone; on a cylinder that
/// leans by as much, whose contact is at the same place; and with a wheelset that rolls by 0.267
/// rad.
#[test]
fn rollers() {
    let (text, wheel) = solved(&ON_CONE);
    has(
        &text,
        &[
            "origin_y = \"200 mm\"",
            "radius_x = \"400 mm\"",
            "angular_velocity = \"0.24381 rad/s\"",
            "flange_back_position = \"-100 mm\"",
        ],
    );
    compare(&wheel, [0.0, 180.145, -4.0248, 0.2, 98_050.0, -18.05, 14_170.0], (0.3, 5e-3));
    let leaning = Input { rail: "plane", rail_deviation: "0 0 0.2r 0 0 0", ..ON_CONE };
    let (text, wheel) = solved(&leaning);
    has(&text, &["[right_rail]", "roll_angle = \"200 mrad\""]);
    compare(&wheel, [0.0, 180.145, -4.0248, 0.2, 97_860.0, -21.47, 14_020.0], (0.3, 1e-2));
    let rolled = Input {
        position: "0. 0. -56.60956 0.266667r 0. 0.",
        velocity: "0.2451499 0. 0. 0. 0. -0.75",
        ..ON_CONE
    };
    let expected = [0.0, 164.292, -7.2384, 0.2, 97_460.0, 1.806, -102.4];
    compare(&solved(&rolled).1, expected, (0.3, 5e-3));
}

/// CONTACT (rev. 2707, testbank, m1_steady_roll): a cylindrical wheel that leans by 5° on its axle,
/// yawed, on a rail with an arc of 100 mm in the middle of the track.
#[test]
fn a_wheel_that_leans_on_its_axle() {
    let input = Input {
        side: 1,
        force: 1,
        material: ["0.4", "200."],
        track: "-1. 0. 0. 0.   GAUGHT, RAILY0, RAILZ0, CANT",
        rail: "up",
        wheelset: "0. 0. 100.",
        wheel: "plane",
        position: "0. 0. 237. 0. 0.004 0.",
        velocity: "100. 0. 0. 0. 0. -0.996",
        wheel_deviation: "0 0 0 5.0d 0 0",
        ..ON_CONE
    };
    let (text, wheel) = solved(&input);
    has(&text, &["[right_wheel]", "flange_back_distance = \"0 mm\""]);
    let expected = [-0.0697, 8.7104, 0.3801, 0.0872, 240.0, -37.65, -23.54];
    compare(&wheel, expected, (0.4, 1e-2));
}

/// Signs and sides: y and z, and the turns about them, point the other way there.
#[test]
fn signs_of_deviations_and_curves() {
    let input = Input {
        side: 0,
        track: "-1. -200. 3. 0.05 2e-6   GAUGHT, RAILY0, RAILZ0, CANT, CURV",
        rail_deviation: "1. 2. 0.01 3. 4. 0.02",
        wheel_deviation: "1. 2. 3. 0.01 0.02 0.5",
        velocity: "1000. 0. 0. 0. 0. -7.5",
        ..ON_CONE
    };
    let import = import(&input);
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    let text = &import.cases[0].text;
    has(
        text,
        &[
            "origin_y = \"200 mm\"",
            "origin_z = \"-3 mm\"",
            "curve_radius = \"-500 m\"",
            "[left_rail]",
            "vertical_velocity = \"-4 mm/s\"",
            "[left_wheel]",
            "longitudinal_displacement = \"1 mm\"",
            "yaw_angle = \"-20 mrad\"",
        ],
    );
    for line in ["lateral_displacement = \"-1 mm\"", "vertical_displacement = \"-2 mm\""] {
        assert!(text.split("[left_rail]").nth(1).unwrap().contains(line), "{line}\n{text}");
    }
    // The pitch of a round wheel does not count.
    assert!(!text.contains("pitch"), "{text}");
    let ahead = Input { position: "1. 0. -1.870 0. 0. 0.", ..ON_CONE };
    let errors: Vec<String> = self::import(&ahead).errors.iter().map(ToString::to_string).collect();
    let [error] = &errors[..] else { panic!("{errors:?}") };
    assert!(error.contains("S_WS = 1: a wheel before or behind the top of its roller"), "{error}");
}
