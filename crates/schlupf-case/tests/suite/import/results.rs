//! What imported cases give against CONTACT's own results for the same input: creep forces of
//! module 3, a start of rolling, and a wheelset of module 1.

use std::path::Path;
use std::sync::Arc;

use super::support::{BALL, one, posed, rows, with};
use schlupf::solver::march;
use schlupf::wheel_rail::WheelSolution;
use schlupf_case::import::contact::{self, Options};
use schlupf_case::{CaseFile, Folder, Overrides, Rolling, Source};

/// CONTACT (rev. 2707), steady rolling of Hertz contacts with Coulomb friction: an input with the
/// creepages of a row has its forces and its moment, within 0.3 % of μN and μN√(ab) on 40 cells and
/// the error that the row tells.
#[test]
fn creep_forces_of_contact() {
    let names = ["R0.5_003", "R0.5_060", "R0.5_063", "R1_003", "R1_060", "R1_063"];
    let mut checked = 0;
    for row in rows("contact_creep.csv").iter().filter(|row| names.contains(&row[0].as_str())) {
        let number = |k: usize| row[k].parse::<f64>().unwrap();
        let [a, b] = [1e3 * number(2), 1e3 * number(3)];
        let text = with(
            BALL,
            &[
                ("5.0 5.0 1.1", &format!("{a} {b} 1.1")),
                ("0.001 -0.0005 0.0002 ", &format!("{} {} {} ", row[4], row[5], 1e-3 * number(6))),
            ],
        );
        let case = posed(&one(&text));
        let solution = case.solver().solve(&case.problem, &schlupf::unwatched).unwrap();
        let limit = 0.3 * 52_359.878;
        let size = (1e-6 * a * b).sqrt();
        let found = [
            solution.force.x / limit,
            solution.force.y / limit,
            solution.force.moment_z.unwrap() / (limit * size),
        ];
        for (k, found) in found.into_iter().enumerate() {
            let (expected, error) = (number(7 + k), number(10));
            assert!((found - expected).abs() < 3e-3 + error, "{}: {found}, not {expected}", row[0]);
        }
        checked += 1;
    }
    assert_eq!(checked, names.len());
}

/// Modified FASTSIM of the locomotive Eurosprinter (CONTACT, rev. 2707): with K0_MF = 0.54 and
/// BETAMF = 0.62 an imported input has CONTACT's forces within the 1.5 % of μ0 N in which both
/// FASTSIM differ without it, and at ξ = 0.01 its traction coefficient of .2873 (BETAMF as our β
/// would give .2239).
#[test]
fn modified_fastsim_of_contact() {
    let locomotive = |creepage: &str| {
        with(
            BALL,
            &[
                ("203100", "233100"),
                ("022020", "422320"),
                (" 52359.878 0.001 -0.0005 0.0002 ", &format!(" 106700. {creepage} 0. 0. ")),
                (" 0.3 0.3   FSTAT, FKIN\n", " 0.1368 0.2232 990. 0. 1.\n 0.003 1.0\n"),
                ("0.25 30000.", "0.2889 10000."),
                ("82031.25 82031.25   POISS 1,2, GG 1,2\n", "82000. 82000.\n .54 .02 .62\n"),
                ("-3\n 44 44 5.0 5.0 1.1", "-2\n 48 44 0.0008 0.5 1.1"),
            ],
        )
    };
    let mut checked = 0;
    for row in rows("eurosprinter_layer.csv").iter().filter(|row| row[0] == "modified-fastsim") {
        let case = posed(&one(&locomotive(&row[1])));
        let solution = case.solver().solve(&case.problem, &schlupf::unwatched).unwrap();
        let expected: f64 = row[2].parse().unwrap();
        let off = (solution.force.x - expected) / (0.36 * 106_700.0);
        assert!(off.abs() < 0.015, "{}: {off}", row[1]);
        if row[1] == "0.01" {
            let coefficient = -solution.force.x / 106_700.0;
            assert!((coefficient / 0.2873 - 1.0).abs() < 0.016, "{coefficient}");
        }
        checked += 1;
    }
    assert_eq!(checked, 30);
}

/// CONTACT (rev. 2707) with total forces prescribed (F = 1 and 2): an input with the forces of a
/// row has the creepages that CONTACT found, within 1 % or 2e-5 on 40 cells.
#[test]
fn creepages_of_prescribed_forces() {
    let mut checked = 0;
    for row in rows("contact_prescribed_force.csv") {
        let number = |k: usize| row[k].parse::<f64>();
        let [digits, fy] = match number(6) {
            Ok(force) => ["203120", &force.to_string()],
            Err(_) => ["203110", "0.0"],
        };
        let spin = 1e-3 * number(7).unwrap();
        let motion = format!("75398.224 {} {fy} {spin} ", number(5).unwrap());
        let text = with(
            BALL,
            &[
                ("203100", digits),
                ("52359.878 0.001 -0.0005 0.0002 ", &motion),
                ("5.0 5.0 1.1", "6.0 6.0 1.1"),
            ],
        );
        let case = posed(&one(&text));
        let solution = case.solver().solve(&case.problem, &schlupf::unwatched).unwrap();
        let found = [solution.kinematics.creepage_x, solution.kinematics.creepage_y];
        for (found, place) in found.into_iter().zip([12, 13]) {
            let expected = number(place).unwrap();
            let most = (0.01 * expected.abs()).max(2e-5);
            assert!((found - expected).abs() < most, "{}: {found}, not {expected}", row[0]);
        }
        checked += 1;
    }
    assert_eq!(checked, 6);
}

/// An input of module 1: a position of the Manchester benchmark, case, with what the digit F
/// asks for in place of VPITCH.
fn benchmark(row: &[String], force: u8, last: &str) -> String {
    let config = u8::from(row[0] != "left");
    format!(
        "% Manchester benchmark, {} mm\n 1\n {config}2031{force}0\n 0022033\n 0000321\n\
         999 100 30 1 1e-5\n 0.3 0.3\n 0.28 0.28 82000. 82000.\n 0.2 0.2 1.0 90d 8.0 4.0\n\
         14.0 0 1435.0 0.0  GAUGHT, GAUGSQ, GAUGWD, CANT\n\
         'profile_uic60_canted.csv' 0 1.0 0.0\n 0 0 0 0 0 0\n 1360. -70. 460.\n\
         'profile_s1002.csv' 0 1.0 0.0\n\
         0.0 {} 10000. {} {} 0.0   S, Y, FZ, ROLL, YAW, PITCH\n\
         2000. 0 0 0 0 {last}   VS, VY, VZ, VROLL, VYAW, VPITCH or FX_WS or MY_WS\n 0\n",
        row[1], row[1], row[3], row[2]
    )
}

fn imported(text: String) -> contact::Import {
    let source = Arc::new(Source { name: "benchmark.inp".to_owned(), text });
    contact::import(&source, &Options { stem: "a".to_owned(), ..Options::default() })
}

/// The wheel of the only case of an input, solved.
fn wheel(text: String) -> Arc<WheelSolution> {
    let import = imported(text);
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let text = &import.cases[0].text;
    let file = CaseFile::from_str(text, "a.toml", Folder::new(folder), Overrides::NONE);
    let case = file.unwrap_or_else(|errors| panic!("{errors}\n{text}"));
    case.pose(&schlupf::unwatched).unwrap().wheel.unwrap()
}

/// The Manchester benchmark, case, as an input of module 1: contact points, forces and
/// largest pressure of CONTACT (rev. 2707), within the accuracy of its grid.
#[test]
fn manchester_benchmark() {
    let table = rows("manchester_a22.csv");
    for (side, lateral) in [("right", "3.0"), ("left", "4.0")] {
        let row = table.iter().find(|row| row[0] == side && row[1] == lateral).unwrap();
        let number = |k: usize| row[k].parse::<f64>().unwrap();
        let wheel = wheel(benchmark(row, 0, &row[4]));
        assert_eq!(wheel.contacts.len(), 1);
        let contact = &wheel.contacts[0];
        let force = &contact.solution.force;
        let (load, limit) = (number(15), 0.3 * number(15));
        let close = |what: &str, found: f64, expected: f64, most: f64| {
            assert!((found - expected).abs() < most, "{side} {what}: {found}, not {expected}");
        };
        // y to the right and z down there: Fx changes its sign as it acts on the rail, y and the
        // angle theirs.
        close("y", contact.position[1], -1e-3 * number(7), 2e-5);
        close("angle", contact.angle, -number(9), 5e-4);
        close("height", wheel.height, -1e-3 * number(5), 2e-6);
        close("Fn", contact.solution.normal.load, load, 3e-3 * load);
        close("Fx", force.x, -number(16), 2e-2 * limit);
        close("Fs", force.y, number(17), 2e-2 * limit);
        let pressure = 1e6 * number(20);
        close("pmax", contact.solution.normal.peak_pressure, pressure, 2.5e-2 * pressure);
    }
}

/// The same positions with the longitudinal force of CONTACT's results in place of its pitch rate:
/// F = 1, the force on the rail along the wheelset's axis, from the forces of the contact by the
/// attitude of the wheelset; and F = 2, the moment on the rail about the axle, from the tangential
/// forces at the arm to the axle. The wheel turns as it does there, within 2 % of its creepage.
#[test]
fn forces_of_the_manchester_benchmark() {
    let table = rows("manchester_a22.csv");
    for (side, lateral) in [("right", "3.0"), ("left", "4.0"), ("right", "9.0")] {
        let row = table.iter().find(|row| row[0] == side && row[1] == lateral).unwrap();
        let number = |k: usize| row[k].parse::<f64>().unwrap();
        let (yaw, roll, angle) = (number(2), number(3), number(9));
        // On the rail in the track: x, y to the right, z down. The normal force presses it
        // downwards, along n = (0, −sin δ, cos δ); s = (0, cos δ, sin δ).
        let [normal, x, s, moment] = [15, 16, 17, 18].map(number);
        let (sin, cos) = angle.sin_cos();
        let force = [x, s * cos - normal * sin, s * sin + normal * cos];
        let along = [yaw.cos(), roll.cos() * yaw.sin(), roll.sin() * yaw.sin()];
        let fx = (0..3).map(|k| along[k] * force[k]).sum::<f64>();
        // The axle, and the way from its middle to the contact, in mm.
        let axle = [-yaw.sin(), roll.cos() * yaw.cos(), roll.sin() * yaw.cos()];
        let middle = [0.0, number(1), number(5) - 460.0];
        let arm = [6, 7, 8].map(number);
        let arm = [0, 1, 2].map(|k| arm[k] - middle[k]);
        let slip = [x, s * cos, s * sin];
        let turning = [
            arm[1] * slip[2] - arm[2] * slip[1],
            arm[2] * slip[0] - arm[0] * slip[2],
            arm[0] * slip[1] - arm[1] * slip[0],
        ];
        let spinning = moment * (cos * axle[2] - sin * axle[1]);
        let my = (0..3).map(|k| turning[k] * axle[k]).sum::<f64>() + spinning;
        let size = number(12).hypot(number(13));
        for (force, last) in [(1, fx), (2, my)] {
            let wheel = wheel(benchmark(row, force, &last.to_string()));
            let off = wheel.angular_velocity / -number(4) - 1.0;
            assert!(off.abs() < 0.02 * size, "{side} {lateral}, F = {force}: {off:e} of {size}");
        }
    }
}

/// Friction over the inclination of the rail (V = 1) and along the track (V = 2), the latter at the
/// place S of the wheelset; approximate contacts (B = 5, 6) with FASTSIM (M = 3).
#[test]
fn friction_and_methods_of_module_1() {
    let row = &rows("manchester_a22.csv")[2];
    let plain = benchmark(row, 0, "-4.35");
    let sets = " 2\n -20d 0.2 0.2\n 10d 0.5 0.5\n 0.28";
    let over_rail = plain.replace("0022033", "1022033").replace(" 0.3 0.3\n 0.28", sets);
    let text = imported(over_rail).cases.swap_remove(0).text;
    let expected = [
        "coefficient = 0.4",
        "variation_inclination = [\"-20 deg\", \"10 deg\"]",
        "variation_factor = [0.5, 1.25]",
    ];
    super::support::has(&text, &expected);
    let sets = " 2\n -100 0.2 0.2\n 100 0.3 0.3\n 0.28";
    let along = plain.replace("0022033", "2022033").replace(" 0.3 0.3\n 0.28", sets);
    let text = imported(along).cases.swap_remove(0).text;
    super::support::has(&text, &["coefficient = 0.25"]);
    // The slope reduction of M = 3 follows the elastic constants.
    let fast = plain.replace("2031", "2531").replace("0022033", "0022333");
    let fast = fast.replace("82000. 82000.\n", "82000. 82000.\n 1.0 1.0 1.0\n");
    let import = imported(fast);
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    super::support::has(
        &import.cases[0].text,
        &["method = \"ellipse-corrected\"", "method = \"fastsim\""],
    );
    assert!(import.notices.iter().any(|notice| notice.code == "other-shares"));
    let analyn = imported(plain.replace("2031", "2631"));
    assert!(analyn.errors.is_empty(), "{:#?}", analyn.errors);
    super::support::has(&analyn.cases[0].text, &["method = \"analyn\""]);
}

/// Contacts on a curved surface (D = 4), with bent half-spaces (C3 = 4), which are ours, or not.
#[test]
fn curved_surfaces_of_module_1() {
    let row = &rows("manchester_a22.csv")[2];
    let plain = benchmark(row, 0, "-4.35");
    let curved = plain.replace("0022033", "0042033");
    let bent = curved.replace("0042033", "0044033").replace(" 0.28 0.28", " 1 4\n 0.28 0.28");
    for (text, is_told) in [(curved, true), (bent, false)] {
        let import = imported(text);
        assert!(import.errors.is_empty(), "{:#?}", import.errors);
        let text = &import.cases[0].text;
        super::support::has(text, &["method = \"conformal\""]);
        assert!(!text.contains("row_motion"), "{text}");
        assert_eq!(import.notices.iter().any(|told| told.code == "bent-half-spaces"), is_told);
    }
    let flat = plain.replace("0022033", "0024033").replace(" 0.28 0.28", " 1 4\n 0.28 0.28");
    let refused = imported(flat).errors;
    assert!(format!("{refused:?}").contains("C3 = 4: influence coefficients"), "{refused:?}");
}

/// What goes with the digit F of module 1, and what does not, with its line.
#[test]
fn forces_of_module_1() {
    let row = &rows("manchester_a22.csv")[2];
    let text = |force: u8, last: &str| benchmark(row, force, last);
    let lines = ["force_x = \"-1.5 kN\"", "force_axis = \"wheelset\""];
    super::support::has(&imported(text(1, "1500")).cases[0].text, &lines);
    super::support::has(&imported(text(2, "-69e3")).cases[0].text, &["wheel_torque = \"69 N m\""]);
    let first = text(0, "-4.3");
    let yielding = text(3, "10").replace("0 0 0 0 0 0\n 13", "0 0 0 0 0 0\n 1e4 0 1e5 0\n 13");
    // The position is new, the velocities are kept: VPITCH stands where a force is asked for.
    let kept = format!(
        "{} 1\n 0203110\n 0111001\n 0100321\n 0.0 1.0 10000. 0 0 0\n 0\n",
        first.strip_suffix(" 0\n").unwrap()
    );
    for (text, expected) in [
        (
            text(1, "10").replace("2031", "2001"),
            ":3:7: F = 1: a force in place of VPITCH needs fric",
        ),
        (
            text(1, "10").replace("2031", "2030"),
            ":3:7: F = 1: a force in place of VPITCH needs the",
        ),
        (yielding, "F = 3: rails that give way are not available"),
        (kept, ":16:15: VPITCH = -4.3: the velocities that are kept end with this value"),
    ] {
        let found = imported(text.clone()).errors;
        let is_told = found.iter().any(|error| error.to_string().contains(expected));
        assert!(is_told, "{expected}: {found:#?}\n{text}");
    }
}

/// Steps of module 1 (T = 2) are a history of the wheelset, each over DQREL DX with velocities of
/// its own, which change at once; a shift (T = 1) takes a second, and rolls if the wheel goes on
/// along the rail.
#[test]
fn steps_of_module_1() {
    let row = &rows("manchester_a22.csv")[2];
    let text = |first: &str, digits: &str, motion: &str| {
        let begin = benchmark(row, 0, "-4.3").replace("2031", first);
        let begin = begin.strip_suffix(" 0\n").unwrap().to_owned();
        format!("{begin} 1\n {digits}\n 0111002\n 0100321\n 0.0 1.0 12000. 0 0 0\n {motion}\n 0\n")
    };
    let import = imported(text("2021", "1002100", "2000. 10. 0 0 0 -4.4"));
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    let lines = [
        "time = [\"0 s\", \"0.0001 s\", \"0.0001 s\", \"0.0002 s\"]",
        "load = [\"10 kN\", \"10 kN\", \"10 kN\", \"12 kN\"]",
        "lateral_velocity = [\"0 mm/s\", \"0 mm/s\", \"-10 mm/s\", \"-10 mm/s\"]",
        "angular_velocity = [\"4.3 rad/s\", \"4.3 rad/s\", \"4.4 rad/s\", \"4.4 rad/s\"]",
    ];
    super::support::has(&import.cases[0].text, &lines);
    for (forward, times) in
        [(0.01, "\"0 s\", \"0 s\", \"0 s\""), (0.2, "\"0 s\", \"0 s\", \"1 s\"")]
    {
        let import = imported(text("2011", "1001100", &format!("{forward} 0 0 0 0 0")));
        super::support::has(&import.cases[0].text, &[&format!("time = [{times}]")]);
    }
    // From steady rolling; a shift goes on at its speed.
    for (digits, motion, time) in
        [("1002100", "2000. 0 0 0 0 -4.4", "0.0001"), ("1001100", "0.2 0 0 0 0 -0.00044", "0.0001")]
    {
        let import = imported(text("2031", digits, motion));
        assert!(import.errors.is_empty(), "{:#?}", import.errors);
        let lines = [
            "start = \"steady\"",
            &format!("time = [\"0 s\", \"0 s\", \"{time} s\"]"),
            "load = [\"10 kN\", \"10 kN\", \"12 kN\"]",
            "angular_velocity = [\"4.3 rad/s\", \"4.4 rad/s\", \"4.4 rad/s\"]",
            "speed = \"2 m/s\"",
        ];
        super::support::has(&import.cases[1].text, &lines);
    }
}

/// CONTACT (rev. 2707), T = 2 from a contact without tractions: forty steps over 12 mm with a
/// creepage of 0.0011 give the forces of its grid of 40 cells, within its error of 0.6 % of μN.
#[test]
fn start_of_rolling() {
    let head = with(
        BALL,
        &[
            ("203100", "202100"),
            ("52359.878 0.001 -0.0005 0.0002 ", "75398.224 0.0011 0 0 "),
            ("0.0d 0.25 ", "0.0d 0.3 "),
            ("5.0 5.0 1.1", "6.0 6.0 1.1"),
            (" 0 MODULE\n", ""),
        ],
    );
    let step = " 3\n 002100\n 100000\n 0100111\n 75398.224 0.0011 0 0\n";
    let imported = one(&format!("{head}{} 0\n", step.repeat(39)));
    let case = posed(&imported);
    let Rolling::Transient(transient) = case.rolling(None).unwrap() else {
        panic!("the case must be transient");
    };
    let solution = march(&transient, &case.options, &schlupf::unwatched).unwrap();
    let history = solution.history;
    let limit = 0.3 * 75_398.224;
    let mut checked = 0;
    for row in rows("contact_transient.csv").iter().filter(|row| row[0] == "T1") {
        let [distance, expected]: [f64; 2] = [1, 6].map(|k: usize| row[k].parse().unwrap());
        let near = history.iter().position(|at| (at.distance - 1e-3 * distance).abs() < 1e-9);
        let Some(place) = near else { continue };
        let found = history[place].force.x / limit;
        assert!((found - expected).abs() < 6e-3, "{distance} mm: {found}, not {expected}");
        checked += 1;
    }
    assert!(checked >= 40, "{checked}");
}
