//! Cases of a wheel on a rail: formats of profiles, which all give the same curve, and what cannot
//! be.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;

use schlupf::unwatched;
use schlupf::wheel_rail::{Along, Drive, NormalMethod, ProfileCurve, RowsMove, Side, Support};
use schlupf_case::{Case, CaseFile, Folder, Overrides};

const HEAD: &str = "\
[normal]
model = \"wheel-rail\"
load = \"10 kN\"
[kinematics]
speed = \"2 m/s\"
angular_velocity = \"4.35 rad/s\"
[elasticity]
model = \"half-space\"
[friction]
model = \"constant\"
coefficient = 0.3
[heat]
model = \"none\"
";

/// A case with files in memory, or its message.
fn read(text: &str, files: &[(&str, &str)]) -> Result<CaseFile, String> {
    let files = files.iter().map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()));
    let files: BTreeMap<String, Vec<u8>> = files.collect();
    CaseFile::from_str(text, "case.toml", Arc::new(files), Overrides::NONE)
        .map_err(|errors| errors.to_string())
}

fn solve(text: &str) -> Case {
    let file = CaseFile::from_str(text, "case.toml", Folder::new(""), Overrides::NONE).unwrap();
    file.pose(&unwatched).unwrap()
}

/// The wheel's curve from a file of some name.
fn wheel_curve(name: &str, text: &str) -> Result<ProfileCurve, String> {
    let case =
        format!("{HEAD}[wheel]\nprofile = {name:?}\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n");
    let file = read(&case, &[(name, text)])?;
    let pair = file.wheel().map_err(|error| error.to_string())?.pair();
    Ok(pair.wheel().uniform().unwrap().clone())
}

/// Points of a flanged wheel, y outwards and z up, in mm.
fn points() -> Vec<[f64; 2]> {
    (-60..=60)
        .map(|y| {
            let y = f64::from(y);
            let flange = -28.0 / (1.0 + ((y + 50.0) / 12.0).powi(4));
            [y, flange + 0.05 * y]
        })
        .collect()
}

fn lines(line: impl Fn([f64; 2]) -> String) -> String {
    points().into_iter().map(|point| line(point) + "\n").collect()
}

/// The same points in all formats, with axes either way, from either end: one curve.
#[test]
fn all_formats_give_the_same_curve() {
    let csv = format!("y [mm],z [mm]\n{}", lines(|[y, z]| format!("{y},{z}")));
    let expected = wheel_curve("a.csv", &csv).unwrap();
    let mut reversed: Vec<String> =
        lines(|[y, z]| format!("{y},{z}")).lines().map(str::to_owned).collect();
    reversed.reverse();
    let simpack = |head: &str, unit: f64, y_sign: f64, z_sign: f64| {
        let mut text = format!(
            "! a wheel\nheader.begin\n version = 1\n type = 1 ! wheel\nheader.end\nspline.begin\n{head}\n\
             point.begin\n ! y z\n"
        );
        for [y, z] in points() {
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "  {:.9}  {:.9}  1.0 ! weight",
                y_sign * y * unit,
                z_sign * z * unit
            );
        }
        text + "point.end\nspline.end\n"
    };
    let miniprof = |columns: &str, row: &dyn Fn([f64; 2]) -> String| {
        format!("ProgramName=x\nDate=a\nXYPoints=121\n{columns}\n\n{}", lines(row))
    };
    let files = [
        ("a.csv", format!("# z down\ny_mm,z_mm\n{}", lines(|[y, z]| format!("{y},{}", -z)))),
        ("a.csv", format!("z [m],y [um]\n{}", lines(|[y, z]| format!("{},{}", 1e-3 * z, 1e3 * y)))),
        ("a.csv", format!("y [mm],z [mm]\n{}", reversed.join("\n"))),
        ("a.csv", format!("y [mm],z [mm]\n{}", lines(|[y, z]| format!("{},{z}", -y)))),
        ("a.txt", lines(|[y, z]| format!("  {y}\t{z}"))),
        ("a.prw", simpack("", 1.0, 1.0, 1.0)),
        ("a.prw", simpack("units.len.f = 1.0", 1e-3, 1.0, -1.0)),
        ("a.prw", simpack("units.len.f = 1000.\nmirror.y = 1\ninversion = 1", 1.0, -1.0, 1.0)),
        ("a.whl", miniprof("ColumnDef=X,Y,A,C,N", &|[y, z]| format!("{y} {z} 0 0 1"))),
        ("a.whl", miniprof("ColumnDef=N,Y,X", &|[y, z]| format!("7 {z} {y}"))),
        ("a.whl", miniprof("", &|[y, z]| format!("{y} {z}"))),
    ];
    for (name, text) in files {
        let curve = wheel_curve(name, &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!((curve.length() - expected.length()).abs() < 1e-9, "{name}\n{}", &text[..80]);
        for k in 0..=50 {
            let s = expected.length() * f64::from(k) / 50.0;
            let [one, two] = [curve.at(s).place, expected.at(s).place];
            assert!((one[0] - two[0]).hypot(one[1] - two[1]) < 1e-9, "{name}\n{}", &text[..80]);
        }
    }
    let shifted = wheel_curve("a.prw", &simpack("shift.y = 2.0\nshift.z = -1.0", 1.0, 1.0, 1.0));
    let [y, z] = shifted.unwrap().at(0.0).place;
    let [y0, z0] = expected.at(0.0).place;
    assert!((y - y0 - 2e-3).abs() < 1e-12 && (z - z0 + 1e-3).abs() < 1e-12);
}

/// Each names the field, the file and the line.
#[test]
fn what_is_no_profile_is_told() {
    let long = lines(|[y, z]| format!("{y},{z}"));
    for (name, text, expected) in [
        ("a.csv", "", "a.csv:1:1: wheel.profile: the file must have points, but is empty"),
        ("a.csv", "y [mm],z [s]\n0,1\n", "column `z` must name its unit, m, mm or µm"),
        (
            "a.csv",
            "y [mm],z [mm]\n0,1\n1,x\n",
            "a.csv:3:1: wheel.profile: z must be a finite number, but is \"x\"",
        ),
        ("a.csv", "y [mm],z [mm]\n0,1\n9,1\n", "wheel.profile needs at least 4 points"),
        ("a.csv", "y [mm],h [mm]\n0,1\n", "the header must be such as `y [m],z [m]`"),
        (
            "a.txt",
            "0 1\n1 2 3\n",
            "a.txt:2:1: wheel.profile: a line must have y and z in mm, but has 3",
        ),
        ("a.prw", "header.begin\n", "points between point.begin and point.end"),
        ("a.prw", "spline.begin\nunits.len.f = 0\n", "units.len.f must be positive, but is 0"),
        ("a.prw", "spline.begin\nrotate = 0.1\n", "rotate must be 0, but is 0.1"),
        (
            "a.prw",
            "spline.begin\npoint.begin\n1\n",
            "a.prw:3:1: wheel.profile: a point must have y, z",
        ),
        ("a.whl", "ColumnDef=X,A\n\n1 2\n", "must name a column Y, but is \"X,A\""),
        ("a.whl", "ColumnDef=X,Y,A\n\n1\n", "a row must have at least 2 numbers, but has 1"),
    ] {
        let error = wheel_curve(name, text).unwrap_err();
        assert!(error.contains(expected), "{name}: {error}\n{expected}");
    }
    let metres = format!("y [m],z [m]\n{long}");
    let error = wheel_curve("a.csv", &metres).unwrap_err();
    let expected = "wheel.profile must be at most ±1 m, but is -60000 mm in line 2 of the file (were \
                    its numbers 0.001 times as large (um for mm), it would be 120 mm wide";
    assert!(error.contains(expected), "{error}");
}

fn with(lines: &str) -> String {
    format!("{HEAD}{lines}")
}

/// What goes with one contact only, and what is missing.
#[test]
fn contradictions_are_told() {
    let profiles = "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n";
    for (text, expected) in [
        (
            with("[rail]\nprofile = \"60E1\"\n"),
            "wheel.profile is missing, which normal.model = \"wheel-rail\" needs",
        ),
        (
            with("[wheel]\nprofile = \"S1003\"\n[rail]\nprofile = \"60E1\"\n"),
            "built in are \"S1002\"",
        ),
        (
            with(profiles).replace("load = \"10 kN\"\n", ""),
            "normal.load is missing, which normal.model = \"wheel-rail\" needs",
        ),
        (
            with(profiles).replace("load = \"10 kN\"", "") + "[wheelset]\nheight = \"0 mm\"\n",
            "wheelset.roll_angle is missing, which wheelset.height needs",
        ),
        (
            with(profiles).replace("load = ", "approach = \"50 um\"\n#"),
            "normal.approach must not be given with normal.model = \"wheel-rail\", but is \"50 um\": \
             the contacts of a wheel have wheelset.height in common",
        ),
        (
            with(profiles) + "[history]\ntime = [\"0 s\", \"1 s\"]\ncreepage_y = [0.0, 0.1]\n",
            "history.creepage_y must be left out with normal.model = \"wheel-rail\"",
        ),
        (
            with(profiles) + "[history]\ntime = [\"0 s\", \"1 s\"]\nheight = [\"0 mm\"]\n",
            "history.height must have as many entries as history.time, 2, but has 1",
        ),
        (
            with(profiles)
                + "[history]\ntime = [\"0 s\", \"0 s\"]\nlateral_position = [\"0 mm\", \"1 mm\"]\n",
            "history.lateral_position must be the same at equal times, at which a wheelset without \
             history.shift_duration is not shifted, but changes at 0 s",
        ),
        (
            with(profiles)
                + "[history]\ntime = [\"0 s\", \"1 s\"]\n[solver]\nmethod = \"polach\"\n",
            "solver.method must be \"full\" with history.time",
        ),
        (
            with(profiles).replace("angular_velocity = \"4.35 rad/s\"", "creepage_x = 1.5"),
            "kinematics.creepage_x must be below 1, at which the wheel locks, but is 1.5",
        ),
        (
            with(profiles)
                + "[contact_law.roughness]\nrms_height = \"0.5 um\"\n\
                   longest_wavelength = \"0.1 mm\"\nshortest_wavelength = \"2 um\"\n",
            "the micro model of a roughness needs one patch, but normal.model is \"wheel-rail\"",
        ),
        (
            with(profiles).replace(
                "0.3\n",
                "0.3\nvariation_inclination = [\"-1 rad\", \"1 rad\"]\n\
                 variation_factor = [0.5, 1]\n",
            ),
            "variation_factor: the factor must be 1 at α = 0, where friction is \
             friction.coefficient, but is 0.75 there",
        ),
        (
            with(profiles) + "[track]\ngauge = \"1435\"\n",
            "track.gauge must be a length with its unit",
        ),
    ] {
        let error = read(&text, &[]).map(|_| ()).unwrap_err();
        assert!(error.contains(expected), "{error}\n{expected}");
    }
    let file = read("", &[]).unwrap();
    let error = file.wheel().unwrap_err().to_string();
    assert!(error.contains("normal.model must be \"wheel-rail\" for the contacts"), "{error}");
}

/// With what the rows of a contact move, and how it is found, are names.
#[test]
fn the_motion_of_rows_is_chosen() {
    let profiles = "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n";
    let rows = |choice: &str| {
        let chosen = with(profiles).replace("load =", &format!("{choice}\nload ="));
        read(&chosen, &[]).map(|file| file.wheel().unwrap().rows)
    };
    assert_eq!(rows(""), Ok(RowsMove::Automatic));
    assert_eq!(rows("row_motion = \"automatic\""), Ok(RowsMove::Automatic));
    assert_eq!(rows("row_motion = \"surface\""), Ok(RowsMove::WithSurface));
    assert_eq!(rows("row_motion = \"plane\""), Ok(RowsMove::WithPlane));
    let method = |choice: &str| {
        let chosen = with(profiles).replace("load =", &format!("{choice}\nload ="));
        read(&chosen, &[]).unwrap().wheel().unwrap().normal_method
    };
    assert_eq!(method(""), NormalMethod::HalfSpaces);
    assert_eq!(method("method = \"kik-piotrowski\""), NormalMethod::KikPiotrowski);
    let error = rows("row_motion = \"plain\"").unwrap_err();
    assert!(error.contains("normal.row_motion") && error.contains("\"plane\""), "{error}");
}

/// A case poses the contact with the largest normal force, and keeps the wheel; left out, the roll
/// angle is that at which both wheels rest, and the case is as with that angle given.
#[test]
fn a_case_of_profiles_is_posed() {
    let text = with(
        "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n\
         [wheelset]\nside = \"left\"\nlateral_position = \"3 mm\"\n",
    );
    let case = solve(&text);
    let wheel = case.wheel.as_ref().unwrap();
    assert_eq!(wheel.side, Side::Left);
    let main = &wheel.contacts[0];
    let normal = case.problem.normal.normal_contact(None).unwrap().summary;
    assert_eq!(normal.load, main.solution.normal.load);
    assert!((wheel.force[2] - 10e3).abs() < 2.0);
    let roll = wheel.position.roll;
    assert!(roll > 1e-5 && roll < 1e-3, "{roll}");
    let given = solve(&format!("{text}roll_angle = \"{roll} rad\"\n"));
    let given = given.wheel.unwrap();
    assert!((given.height - wheel.height).abs() < 1e-9);
    let file = read(&text, &[]).unwrap();
    assert_eq!(file.wheel().unwrap().support, Support::Force(10e3));
    let [left, right] = &file.wheels_at(3e-3, &unwatched).unwrap()[..] else { panic!() };
    assert!((left.height - right.height).abs() < 1e-6 && (left.height - wheel.height).abs() < 1e-8);
    assert!(file.files().is_empty());
}

/// Fast methods take the same contacts; their lateral forces are near the full one.
#[test]
fn fast_methods_solve_the_same_contacts() {
    let text = with(
        "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n\
         [wheelset]\nlateral_position = \"-3 mm\"\nyaw_angle = \"-5 mrad\"\nroll_angle = \"0 mrad\"\n",
    );
    let full = solve(&text).wheel.unwrap();
    for method in ["shen-hedrick-elkins", "fastsim"] {
        let fast =
            format!("{text}[solver]\nmethod = {method:?}\n[fastsim]\nbound = \"elliptic\"\n");
        let fast = solve(&fast).wheel.unwrap();
        let [one, two] = [&full, &fast].map(|wheel| wheel.contacts[0].solution.force);
        assert!((one.y - two.y).abs() < 0.1 * one.y.abs(), "{method}: {one:?} {two:?}");
        assert!((full.height - fast.height).abs() < 1e-6);
    }
}

/// A force in place of the angular velocity is that of all contacts together, along the track or
/// across the axle; what a wheelset does not leave open is refused, and the falling branch is.
#[test]
fn a_force_turns_the_wheel() {
    let text = with(
        "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n\
         [wheelset]\nlateral_position = \"-3 mm\"\nyaw_angle = \"-5 mrad\"\nroll_angle = \"0 mrad\"\n",
    );
    let text = text.replace("angular_velocity = \"4.35 rad/s\"", "force_x = \"-800 N\"");
    let drive = |text: &str| read(text, &[]).map(|file| file.wheel().unwrap().drive);
    assert_eq!(drive(&text), Ok(Drive::Force { force: -800.0, along: Along::Track }));
    let across = format!("{text}force_axis = \"wheelset\"\n");
    assert_eq!(drive(&across), Ok(Drive::Force { force: -800.0, along: Along::Wheelset }));
    let other = |field: &str| text.replace("force_x = \"-800 N\"", field);
    assert_eq!(drive(&other("traction_coefficient = 0.08")), Ok(Drive::OverLoad(0.08)));
    assert_eq!(drive(&other("wheel_torque = \"-1 kN m\"")), Ok(Drive::Torque(-1e3)));
    for (wrong, words) in [
        (other("force_y = \"0 N\""), "kinematics.force_y must be left out"),
        (other("moment_z = \"0 N m\""), "kinematics.moment_z must be left out"),
        (format!("{text}[solver]\nbranch = \"high-slip\"\n"), "solver.branch must be \"low-slip\""),
        (text.replace("force_x =", "creepage_x = 0.0\nforce_x ="), "longitudinal force determines"),
        (format!("{text}force_axis = \"rail\"\n"), "wheelset.force_axis"),
        (
            text.clone()
                + "[history]\ntime = [\"0 s\", \"1 ms\"]\nangular_velocity = [\"4 rad/s\", \"4 rad/s\"]\n",
            "longitudinal force determines",
        ),
        (
            format!("{}force_axis = \"track\"\n", other("traction_coefficient = 0.08")),
            "wheelset.force_axis would be ignored: kinematics.force_x is not given",
        ),
    ] {
        let error = drive(&wrong).unwrap_err();
        assert!(error.contains(words), "{error}\n{words}");
    }
    let case = solve(&text);
    let wheel = case.wheel.as_ref().unwrap();
    assert!((wheel.force[0] + 800.0).abs() < 0.05, "{:?}", wheel.force);
    assert!(wheel.angular_velocity > 0.0 && case.problem.prescribed.is_none());
    // The contact that the case poses has the creepages that were found.
    let main = &wheel.contacts[0].solution.kinematics;
    assert_eq!(case.problem.kinematics.creepage_x, main.creepage_x);
    // Over time, too, from the first step on.
    let over_time = solve(&format!("{text}[history]\ntime = [\"0 ms\", \"1 ms\"]\n"));
    for force in over_time.wheel.unwrap().contacts[0].solution.history.iter().map(|at| at.force.x) {
        assert!((force + 800.0).abs() < 0.05, "{force}");
    }
    let beyond = text.replace("-800 N", "-8 kN");
    let file = CaseFile::from_str(&beyond, "case.toml", Folder::new(""), Overrides::NONE).unwrap();
    let error = file.pose(&unwatched).unwrap_err().to_string();
    assert!(error.contains("kinematics.force_x cannot be -8000 N"), "{error}");
}

/// Over the lateral position a force is that on the wheel of the case, on whichever side, and the
/// other wheel turns with it.
#[test]
fn a_force_turns_both_wheels() {
    for side in ["left", "right"] {
        let text = with(&format!(
            "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\ncant = 0.025\n\
             [wheelset]\nside = {side:?}\n"
        ));
        let text = text.replace("angular_velocity = \"4.35 rad/s\"", "force_x = \"-800 N\"");
        let [left, right] = &read(&text, &[]).unwrap().wheels_at(2e-3, &unwatched).unwrap()[..]
        else {
            panic!()
        };
        assert_eq!([left.side, right.side], [Side::Left, Side::Right]);
        assert_eq!(left.angular_velocity, right.angular_velocity);
        let own = if side == "left" { left } else { right };
        assert!((own.force[0] + 800.0).abs() < 0.05, "{side}: {:?}", own.force);
    }
}

/// A rail of which only the top was measured is placed by its end, too far inwards by what is
/// missing, and this is told with both depths; so is a depth below the end of a whole head. 60E1
/// is 72 mm wide where the gauge is measured (EN 13674-1).
#[test]
fn a_rail_that_ends_above_the_gauge_depth_is_told() {
    let case = |rail: &str, fields: &str| {
        format!("{HEAD}{fields}[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = {rail:?}\n")
    };
    let whole = read(&case("60E1", ""), &[]).unwrap();
    let told = |file: &CaseFile| -> Option<String> {
        let notices = file.notices();
        let found = notices.iter().find(|notice| notice.code == "gauge-depth-not-reached")?;
        assert_eq!(found.quantity, "track.gauge_depth");
        Some(found.text.clone())
    };
    assert_eq!(told(&whole), None);
    let pair = whole.wheel().unwrap().pair();
    let [y0, z0] = pair.rail_origin();
    let points = pair
        .rail()
        .uniform()
        .unwrap()
        .points()
        .iter()
        .map(|[y, z]| [1e3 * (y - y0), 1e3 * (z - z0)]);
    let top: Vec<[f64; 2]> = points.filter(|[y, _]| y.abs() < 33.0).collect();
    let rows: Vec<String> = top.iter().map(|[y, z]| format!("{y:.7},{z:.7}")).collect();
    let text = rows.join("\n") + "\n";
    let file = read(&case("top.csv", ""), &[("top.csv", &format!("y [mm],z [mm]\n{text}"))]);
    let file = file.unwrap();
    let shift = 1e3 * (y0 - file.wheel().unwrap().pair().rail_origin()[0]);
    assert!((shift - (36.0 + top[0][0])).abs() < 0.02 && shift > 2.9, "{shift}");
    let expected = format!(
        "track.gauge_depth is 14.00 mm, but on its inner side the rail's profile ends {:.2} mm below",
        top.iter().fold(0.0, |z: f64, point| z.max(point[1])) - top[0][1]
    );
    let found = told(&file).unwrap();
    assert!(found.starts_with(&expected), "{found}\n{expected}");
    // Those that solve tell it, too.
    let notices = file.pose(&unwatched).unwrap().notices;
    assert!(notices.iter().any(|notice| notice.code == "gauge-depth-not-reached"), "{notices:?}");
    let deep = read(&case("60E1", "[track]\ngauge_depth = \"40 mm\"\n"), &[]).unwrap();
    assert!(
        told(&deep).unwrap().contains("is 40.00 mm, but on its inner side"),
        "{:?}",
        told(&deep)
    );
}

/// Noise of 5 µm on points every 0.035 mm, smoothed over 2, 3 and 5 mm: the largest pressure
/// approaches that without noise, to 6 % at 5 mm whichever rows are taken. Turns of the noise from
/// point to point were taken for kinks, and pressures grew with the length.
#[test]
fn smoothing_of_dense_points_converges() {
    let built_in = format!("{HEAD}[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\n");
    let built_in = built_in.replace("10 kN", "80 kN");
    let file = read(&built_in, &[]).unwrap();
    let peak = |file: &CaseFile| file.normal_contact(&unwatched).unwrap().summary.peak_pressure;
    let exact = peak(&file);
    let pair = file.wheel().unwrap().pair();
    let ([y0, z0], curve) = (pair.rail_origin(), pair.rail().uniform().unwrap());
    let mut state = 12_345_u64;
    let mut noise = || {
        // Twelve uniform numbers (Knuth's generator) are nearly a normal one.
        let mut uniform = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        0.005 * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0)
    };
    let rows: Vec<String> = (0..(curve.length() / 3.5e-5) as usize)
        .map(|k| {
            let [y, z] = curve.at(3.5e-5 * k as f64).place;
            format!("{:.7},{:.7}\n", 1e3 * (y - y0), 1e3 * (z - z0) + noise())
        })
        .collect();
    let off = |every: usize, length: &str| {
        let points: String = rows.iter().step_by(every).map(String::as_str).collect();
        let case =
            built_in.replace("60E1\"", "r.csv\"") + &format!("profile_smoothing = {length:?}");
        let file = read(&case, &[("r.csv", &format!("y [mm],z [mm]\n{points}"))]).unwrap();
        peak(&file) / exact - 1.0
    };
    for every in [1, 2, 4] {
        let [two, three, five] = ["2 mm", "3 mm", "5 mm"].map(|length| off(every, length));
        println!("{every}: {two} {three} {five}");
        assert!(five.abs() < 0.06, "{every}: {two} {three} {five}");
        assert!(five < three && three < two, "{every}: {two} {three} {five}");
    }
}

/// A contact at the end of a profile names that one, and where it ends.
#[test]
fn the_profile_that_ends_is_named() {
    let case = |wheel: &str, rail: &str| {
        format!("{HEAD}[wheel]\nprofile = {wheel:?}\n[rail]\nprofile = {rail:?}\n")
    };
    let file = read(&case("S1002", "60E1"), &[]).unwrap();
    let contact = file.pose(&unwatched).unwrap().wheel.unwrap().contacts[0].clone();
    let pair = file.wheel().unwrap().pair();
    let on_wheel: Vec<[f64; 2]> = pair.wheel().uniform().unwrap().points().to_vec();
    let [y0, z0] = pair.rail_origin();
    let on_rail: Vec<_> =
        pair.rail().uniform().unwrap().points().iter().map(|[y, z]| [y - y0, z - z0]).collect();
    for (field, points, place) in [
        ("wheel.profile", on_wheel, contact.wheel_position),
        ("rail.profile", on_rail, contact.rail_position),
    ] {
        let kept: Vec<[f64; 2]> = points.into_iter().filter(|[y, _]| *y < place + 1e-3).collect();
        let line = |[y, z]: &[f64; 2]| format!("{:.7},{:.7}\n", 1e3 * y, 1e3 * z);
        let text = "y [mm],z [mm]\n".to_owned() + &kept.iter().map(line).collect::<String>();
        let text = [("short.csv", text.as_str())];
        let case = match field {
            "wheel.profile" => case("short.csv", "60E1"),
            _ => case("S1002", "short.csv"),
        };
        let error = read(&case, &text).unwrap().pose(&unwatched).unwrap_err();
        assert_eq!(error.first.field, field, "{error}");
        let end = format!("y = {:.1} mm", 1e3 * kept[kept.len() - 1][0]);
        assert!(error.first.message.contains(&end), "{error}\n{end}");
    }
}
