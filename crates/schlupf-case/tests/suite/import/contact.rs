//! Input files of CONTACT, written from the documented meaning of their values: each choice, what a
//! case keeps of those before it, signs, and what is not available.

use super::support::{BALL, errors, has, import, import_with, one, posed, with};
use schlupf_case::import::contact::WheelBody;

/// The whole of the simplest case: every value under its unit and sign.
#[test]
fn a_ball_on_a_plane() {
    let expected = "\
# Case 1 of ball.inp, line 4: input of CONTACT, module 3.

title = \"A steel ball that brakes\"

[kinematics]
speed = \"30 m/s\"
creepage_x = 0.001
creepage_y = -0.0005
spin = \"0.2 1/m\"

[wheel]
young_modulus = \"210 GPa\"
poisson_ratio = 0.28

[rail]
young_modulus = \"210 GPa\"
poisson_ratio = 0.28

[normal]
model = \"ellipse\"
semi_axis_x = \"5 mm\"
semi_axis_y = \"5 mm\"
load = \"52.359878 kN\"

[elasticity]
model = \"half-space\"

[contact_law]
model = \"coulomb\"

[friction]
model = \"constant\"
coefficient = 0.3

[heat]
model = \"none\"

[grid]
cells_x = 40
cells_y = 40
";
    assert_eq!(one(BALL).text, expected);
}

/// MAXOUT: one iteration leaves the pressure of unlike bodies as it is.
#[test]
fn iterations_between_pressure_and_tractions() {
    let unlike = with(BALL, &[("82031.25 82031.25", "82031.25 41015.625")]);
    let one_way = "unlike_bodies = \"one-way\"";
    has(&one(&unlike).text, &[one_way]);
    for coupled in [with(&unlike, &[("30 1 1e-5", "30 20 1e-5")]), BALL.to_owned()] {
        let text = one(&coupled).text;
        assert!(!text.contains("unlike_bodies"), "{text}");
    }
}

/// M = 1: FG = E/E∞ − 1 and TC of both bodies, of which the wheel is the first or the second.
#[test]
fn standard_linear_solids() {
    let solids = ("GG 1,2\n", "GG 1,2\n 1.0 0.0 0.009 0.0\n");
    let text = with(BALL, &[("022020", "022120"), solids]);
    let polymer = ["relaxed_modulus = \"105 GPa\"", "retardation_time = \"0.009 s\""];
    let steel = ["relaxed_modulus = \"210 GPa\"", "retardation_time = \"0 s\""];
    let first = one(&text).text;
    has(&first, &["model = \"viscoelastic\"", "model = \"coulomb\""]);
    let second = import_with(&text, WheelBody::Second).cases.swap_remove(0).text;
    for (text, [of_wheel, of_rail]) in [(first, [polymer, steel]), (second, [steel, polymer])] {
        let (wheel, rail) = text.split_once("[rail]").unwrap();
        has(wheel, &of_wheel);
        has(rail, &of_rail);
    }
}

/// Hertz's contact in all descriptions, with a load and with an approach. A sphere of R = 300 mm
/// has A1 = B1 = 1/(2 R), an approach of a²/R and N = 4 E* a³/(3 R) (Johnson 1985, Eqs. 4.22–4.24).
#[test]
fn hertz_in_all_descriptions() {
    let sphere = "-1\n 44 44 0.00166666666666667 0.00166666666666667 1.1";
    let ratio = "-2\n 44 44 0.00166666666666667 1.0 1.1";
    let radii = ["radius_x = \"300 mm\"", "radius_y = \"300 mm\"", "load = \"52.359878 kN\""];
    has(&one(&with(BALL, &[("-3\n 44 44 5.0 5.0 1.1", sphere)])).text, &radii);
    has(&one(&with(BALL, &[("-3\n 44 44 5.0 5.0 1.1", ratio)])).text, &radii);
    // a = 5 mm: δ = 25/300 mm, N = 4 E* a³/(3 R) with E* = G/(1 − ν).
    let load = 4.0 * 82031.25 / 0.72 * 125.0 / 900.0 / 1e3;
    let approach = &[("203100", "203000"), (" 52359.878", " 0.0833333333333333")];
    for area in [sphere, ratio, "-3\n 44 44 5.0 5.0 1.1"] {
        let text = with(&with(BALL, approach), &[("-3\n 44 44 5.0 5.0 1.1", area)]);
        let case = one(&text);
        let line = case.text.lines().find(|line| line.starts_with("load")).unwrap();
        let found: f64 = line.split(['"', ' ']).nth(3).unwrap().parse().unwrap();
        assert!((found / load - 1.0).abs() < 1e-9, "{area}: {found}, not {load}");
        assert!(case.text.contains("# The load is that for an approach of "), "{}", case.text);
    }
}

/// A quadratic distance is Hertz's contact, about its lowest point; cells are those across it.
#[test]
fn a_quadratic_distance() {
    let area = "1\n 60 60 -5.5 -6.0 0.2 0.2\n 1 1  IBASE, IPLAN\n";
    let centred = "0.00166666666666667 0 0.00166666666666667 0 0 0.5";
    let case = one(&with(BALL, &[("-3\n 44 44 5.0 5.0 1.1", &(area.to_owned() + centred))]));
    // a³ = 3 N R/(4 E*): 4.7047 mm.
    has(&case.text, &["radius_x = \"300 mm\"", "cells_x = 47", "cells_y = 47"]);
    // Moved by 0.5 mm along and 0.3 mm across: ξ − φ y0, η + φ x0 there.
    let moved = "0.00166666666666667 0 0.00166666666666667 -0.00166666666666667 -0.001 0.0";
    let case = one(&with(BALL, &[("-3\n 44 44 5.0 5.0 1.1", &(area.to_owned() + moved))]));
    has(&case.text, &["creepage_x = 0.00094", "creepage_y = -0.0004"]);
    // An approach counts from the lowest point, which is 0.00056666666666666 below zero.
    let high = with(BALL, &[("203100", "203000"), (" 52359.878", " 0.1")]);
    let load = |b: &str| {
        let case = one(&with(&high, &[("-3\n 44 44 5.0 5.0 1.1", &(area.to_owned() + b))]));
        let line = case.text.lines().find(|line| line.starts_with("load")).unwrap().to_owned();
        line.split(['"', ' ']).nth(3).unwrap().parse::<f64>().unwrap()
    };
    let ratio = load(moved) / load("0.00166666666666667 0 0.00166666666666667 0 0 0");
    assert!((ratio - (1.0 + 0.000_566_666_666_667_f64 / 0.1).powf(1.5)).abs() < 1e-9, "{ratio}");
}

/// Distances that are no paraboloid become tables, point by point.
#[test]
fn distances_on_the_grid() {
    let area = "3\n 5 4 -1.0 -1.5 0.5 1.0\n ";
    let table = |geometry: &str| {
        let case = one(&with(BALL, &[("-3\n 44 44 5.0 5.0 1.1", &(area.to_owned() + geometry))]));
        has(
            &case.text,
            &["model = \"profile\"", "file = \"ball_distance.csv\"", "reference = \"file\""],
        );
        let (_, bytes) = case.files.into_iter().next().unwrap();
        let text = String::from_utf8(bytes).unwrap();
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("x [mm],y [mm],distance [mm]"));
        lines.map(|l| l.split(',').map(|n| n.parse().unwrap()).collect()).collect::<Vec<Vec<f64>>>()
    };
    let check = |rows: &[Vec<f64>], height: &dyn Fn(f64, f64) -> f64| {
        assert_eq!(rows.len(), 20);
        for (k, row) in rows.iter().enumerate() {
            let (x, y) = (-1.0 + 0.5 * (k % 5) as f64, -1.5 + (k / 5) as f64);
            assert!((row[0] - x).abs() < 1e-12 && (row[1] - y).abs() < 1e-12, "{row:?}");
            assert!((row[2] - height(x, y)).abs() < 1e-12, "{row:?}, not {}", height(x, y));
        }
    };
    check(&table("1 1\n 0.01 0.002 0.02 0 0.001 0.5"), &|x, y| {
        0.01 * x * x + 0.002 * x * y + 0.02 * y * y + 0.001 * y + 0.5
    });
    // A profile of three heights at y = -2, 0, 2, linear and beyond its ends, too.
    check(&table("2 1\n 3 0.1 400. -1.0 1.0\n 0.3 0.0 0.1"), &|x, y| {
        let height = if y < 0.0 { -0.3 * y } else { 0.1 * y };
        height + (x - 0.1).powi(2) / 800.0
    });
    check(&table("3 1\n 0.01 3.0 0.2 0.02 5.0 0.1 900 300"), &|x, y| {
        0.01 * (3.0 * (x - 0.2)).sin() - 0.02 * (5.0 * (x - 0.1)).sin()
            + x * x / 900.0
            + y * y / 300.0
    });
    let values: Vec<String> = (0..20).map(|k| format!("{}", 0.01 * f64::from(k * k))).collect();
    let rows = table(&format!("9 1\n {}\n {}", values[..7].join(" "), values[7..].join(",")));
    for (k, row) in rows.iter().enumerate() {
        assert!((row[2] - 0.01 * (k * k) as f64).abs() < 1e-12, "{row:?}");
    }
}

/// An approach PEN is measured from where the distance is zero, in a table as in Hertz's contact: a
/// sphere of 300 mm that is lower by a part of the approach, or by all of it, reaches the contact
/// of 5 mm, with the load of its closed form.
#[test]
fn an_approach_of_any_distance() {
    for (lower, approach) in [(0.01, " 0.0733333333333333"), (25.0 / 300.0, " 0.0")] {
        let height = |k: i32| (0.1 * f64::from(k)).powi(2) / 600.0 - lower;
        let profile: Vec<String> = (-80..=80).map(|k| height(k).to_string()).collect();
        let area = format!(
            "3\n 141 141 -7.0 -7.0 0.1 0.1\n 2 1\n 161 0.0 300. -8.0 0.1\n {}",
            profile.join("\n ")
        );
        let changes = [
            ("203100", "203000"),
            (" 52359.878", approach),
            ("-3\n 44 44 5.0 5.0 1.1", area.as_str()),
        ];
        let case = one(&with(BALL, &changes));
        let load = 4.0 * 82031.25 / 0.72 * 125.0 / 900.0 / 1e3;
        let line = case.text.lines().find(|line| line.starts_with("load")).unwrap();
        let found: f64 = line.split(['"', ' ']).nth(3).unwrap().parse().unwrap();
        assert!((found / load - 1.0).abs() < 3e-4, "{found}, not {load}");
    }
}

/// One row of elements is a line contact, of any distance that is quadratic along x: CONTACT's
/// example of Carter's problem (Vollebregt 2022, user guide, §5.2), by its load and by the approach
/// that CONTACT found.
#[test]
fn one_row_is_a_line_contact() {
    let quadratic = "3\n 55 1 -1.05 3.0 0.04 200.0\n 1 1\n 0.001 0.0 0.0 0.0 0.0 0.0";
    let circular = "3\n 55 1 -1.05 3.0 0.04 200.0\n 2 1\n 2 0.0 500. -10. 20.\n 0.0 0.0";
    for area in [quadratic, circular] {
        let steel = ("0.28 0.28 82031.25 82031.25", "0.28 0.28 82000. 82000.");
        let row = [("-3\n 44 44 5.0 5.0 1.1", area), steel];
        let of_load = with(BALL, &row);
        let of_load =
            with(&of_load, &[(" 52359.878 0.001 -0.0005 0.0002", " 35780. -0.00024 0. 0.")]);
        let case = one(&of_load);
        has(
            &case.text,
            &[
                "model = \"line\"",
                "length = \"200 mm\"",
                "radius_x = \"500 mm\"",
                "load = \"35.78 kN\"",
                "cells_x = 50",
                "cells_y = 1",
            ],
        );
        let contact = posed(&case).problem.normal.normal_contact(None).unwrap().summary;
        assert!((contact.approach.unwrap() / 6.49156e-6 - 1.0).abs() < 2e-4);
        let by_approach = with(&of_load, &[("203100", "203000"), (" 35780.", " 0.00649156")]);
        let text = one(&by_approach).text;
        let line = text.lines().find(|line| line.starts_with("load")).unwrap();
        let found: f64 = line.split(['"', ' ']).nth(3).unwrap().parse().unwrap();
        assert!((found / 35.78 - 1.0).abs() < 3e-4, "{found}");
    }
}

/// Axes by which body is the wheel and which way it rolls. A spin centre moves the creepages.
#[test]
fn signs_follow_wheel_and_direction() {
    let back = with(BALL, &[("0.0d 0.25", "180d 0.25")]);
    let creepages = |text: &str, wheel: WheelBody| {
        let import = import_with(text, wheel);
        let text = import.cases[0].text.clone();
        let of = |field: &str| {
            let line = text.lines().find(|line| line.starts_with(field)).unwrap();
            line.rsplit(" = ").next().unwrap().to_owned()
        };
        [of("creepage_x"), of("creepage_y"), of("spin")]
    };
    let spin = "\"0.2 1/m\"";
    assert_eq!(creepages(BALL, WheelBody::First), ["0.001", "-0.0005", spin]);
    assert_eq!(creepages(BALL, WheelBody::Second), ["-0.001", "-0.0005", spin]);
    assert_eq!(creepages(&back, WheelBody::First), ["-0.001", "0.0005", spin]);
    assert_eq!(creepages(&back, WheelBody::Second), ["0.001", "0.0005", spin]);
    let centre = with(BALL, &[("0.0002    FN", "0.0002 2.0 -1.0  FN")]);
    // ξ + φ y_o, η − φ x_o at the middle.
    assert_eq!(creepages(&centre, WheelBody::First), ["0.0008", "-0.0009", spin]);
}

/// Bodies keep their sides with their temperatures.
#[test]
fn heat_of_both_bodies() {
    let heat = "GG 1,2\n 10. 450. 50e-3 7.85e-6\n 150. 460. 45e-3 7.80e-6\n";
    let text = with(BALL, &[("0000111", "3000111"), ("GG 1,2\n", heat)]);
    let lines = ["bulk_temperature = \"10 degC\"", "conductivity = \"45 W/(m K)\""];
    let case = one(&text).text;
    has(
        &case,
        &["density = \"7850 kg/m^3\"", "specific_heat = \"460 J/(kg K)\"", "model = \"duhamel\""],
    );
    has(&case, &lines);
    let [wheel, rail] = [case.find("[wheel]").unwrap(), case.find("[rail]").unwrap()];
    assert!((wheel..rail).contains(&case.find("\"10 degC\"").unwrap()));
    let other = import_with(&text, WheelBody::Second).cases[0].text.clone();
    let rail = other.find("[rail]").unwrap();
    assert!(other.find("\"10 degC\"").unwrap() > rail);
}

/// Every law of friction with its parameters.
#[test]
fn laws_of_friction() {
    let law = |digits: &str, values: &str| {
        let text = with(BALL, &[("022020", digits), (" 0.3 0.3   FSTAT, FKIN", values)]);
        one(&text).text
    };
    let terms = " 0.2 0.1 500. 0.05 2000.\n 0.001 1.0\n";
    let of_terms = [
        "coefficient = 0.35",
        "kinetic_coefficient = 0.2",
        "half_speed = \"500 mm/s\"",
        "second_coefficient = 0.05",
        "second_half_speed = \"2000 mm/s\"",
        "memory_distance = \"1 um\"",
        "memory_speed = \"1 mm/s\"",
    ];
    for (digits, model) in
        [("222020", "linear-in-speed"), ("322020", "rational"), ("422020", "exponential")]
    {
        let text = law(digits, terms);
        has(&text, &of_terms);
        has(&text, &[&format!("model = \"{model}\"")]);
    }
    let first_only = law("422020", " 0.2 0.1 500. 0.0 1.0\n 0.0 0.0\n");
    assert!(!first_only.contains("second_") && !first_only.contains("memory"), "{first_only}");
    let none = law("422020", " 0.2 0.0 500. 0.0 1.0\n 0.0 0.0\n");
    has(&none, &["model = \"constant\"", "coefficient = 0.2"]);
    let heat = "GG 1,2\n 0. 450. 50e-3 7.85e-6\n 0. 450. 50e-3 7.85e-6\n";
    let text = with(
        BALL,
        &[
            ("022020", "622020"),
            ("0000111", "3000111"),
            (" 0.3 0.3   FSTAT, FKIN", " 0.33 20. -0.2 600.\n 0. 0.\n"),
            ("GG 1,2\n", heat),
        ],
    );
    has(
        &one(&text).text,
        &[
            "model = \"temperature-piecewise-linear\"",
            "hot_coefficient = 0.13",
            "reference_temperature = \"20 degC\"",
            "temperature_range = \"600 K\"",
        ],
    );
}

/// Friction by row: factors on that at the middle, at the middles of the rows.
#[test]
fn friction_by_row() {
    let rows = "5.0 5.0 1.1\n 0.1 0.1\n 0.2 0.2\n 0.4 0.4\n 0.5 0.5";
    let text = with(
        BALL,
        &[
            ("  022020", "3022020"),
            (" 0.3 0.3   FSTAT, FKIN\n", ""),
            ("44 44 5.0 5.0 1.1", &format!("44 4 {rows}")),
        ],
    );
    let lines = [
        "coefficient = 0.3",
        "variation_y = [\"-4.125 mm\", \"-1.375 mm\", \"1.375 mm\", \"4.125 mm\"]",
    ];
    has(&one(&text).text, &lines);
    let factors =
        "variation_factor = [0.3333333333333, 0.6666666666667, 1.333333333333, 1.666666666667]";
    has(&one(&text).text, &[factors]);
    let other = import_with(&text, WheelBody::Second).cases[0].text.clone();
    let reversed =
        "variation_factor = [1.666666666667, 1.333333333333, 0.6666666666667, 0.3333333333333]";
    has(&other, &[reversed]);
}

/// FASTSIM with both bounds, plain and with a reduced slope.
#[test]
fn fastsim() {
    let fastsim = |bound: &str, values: &str| {
        let gg = format!("GG 1,2\n {values}\n");
        let text = with(BALL, &[("203100", bound), ("022020", "022320"), ("GG 1,2\n", &gg)]);
        one(&text).text
    };
    has(&fastsim("233100", "1. 1. 0."), &["method = \"fastsim\"", "bound = \"parabolic\""]);
    has(&fastsim("223100", "1. 1. 0."), &["method = \"fastsim\"", "bound = \"elliptic\""]);
    let modified = fastsim("223100", "0.54 0.02 0.62");
    has(
        &modified,
        &["method = \"modified-fastsim\"", "initial_reduction = 0.54", "reduction_decay = 0.3348"],
    );
    assert!(!modified.contains("[contact_law]") && !modified.contains("[elasticity]"));
}

/// Forces over the friction limit become forces on the wheel; the other direction keeps its
/// creepage. With the wheel as body 2 the force on it has the other sign along x, as slips have;
/// rolling along -x turns both.
#[test]
fn prescribed_forces() {
    let text = with(BALL, &[("203100", "203110"), ("0.001 ", "-0.5 ")]);
    // 0.5 · 0.3 · 52.359878 kN.
    let one_force = one(&text).text;
    has(&one_force, &["force_x = \"-7.8539817 kN\"", "creepage_y = -0.0005"]);
    assert!(!one_force.contains("creepage_x"));
    let both = with(BALL, &[("203100", "203120"), ("0.001 ", "-0.5 "), ("-0.0005", "0.4")]);
    let two_forces = one(&both).text;
    has(&two_forces, &["force_x = \"-7.8539817 kN\"", "force_y = \"6.28318536 kN\""]);
    assert!(!two_forces.contains("creepage"));
    let turned = one(&with(&both, &[("0.0d 0.25", "180d 0.25")])).text;
    has(&turned, &["force_x = \"7.8539817 kN\"", "force_y = \"-6.28318536 kN\""]);
    let below = import_with(&both, WheelBody::Second);
    has(&below.cases[0].text, &["force_x = \"7.8539817 kN\"", "force_y = \"6.28318536 kN\""]);
}

/// Compression without friction is rolling without creepage; a shift is one of the wheel.
#[test]
fn compression_and_shift() {
    let text = with(BALL, &[("203100", "200100"), (" 0.0d 0.25 30000.   CHI, DQ, VELOC\n", "")]);
    let text = one(&text).text;
    assert!(!text.contains("creepage_") && text.contains("T = 0"), "{text}");
    let text = with(
        BALL,
        &[("203100", "201100"), (" 0.0d 0.25 30000.   CHI, DQ, VELOC\n", ""), ("0.0002 ", "0.0 ")],
    );
    let lines = ["shift_x = \"0.001 mm\"", "shift_y = \"-0.0005 mm\""];
    has(&one(&text).text, &lines);
    // The first case begins without tractions in any event; a later one with P = 0 does not.
    let first = text.replace("201100", " 01100");
    has(&one(&first).text, &lines);
    let second = " 3\n 001100\n 100000\n 0100111\n 52359.878 0.001 0 0\n 0\n";
    let found = errors(&text.replace(" 0 MODULE\n", &second.replace(" 001100", " 301100")));
    assert!(found[0].contains("P = 3: a shift that is repeated"), "{found:?}");
    let case = one(&text.replace(" 0 MODULE\n", second));
    assert_eq!(case.numbers, [1, 2]);
    let lines =
        ["shifts_x = [\"0.001 mm\", \"0.001 mm\"]", "shifts_y = [\"-0.0005 mm\", \"0 mm\"]"];
    has(&case.text, &lines);
    assert!(!case.text.contains("shift_x") && !case.text.contains("load = ["), "{}", case.text);
}

/// Forces over FSTAT FN in place of shifts, constant or not; a turn in rad; loads that change; the
/// grid is that of the largest load.
#[test]
fn forces_and_turns_in_shifts() {
    let shift = [("203100", "201120"), (" 0.0d 0.25 30000.   CHI, DQ, VELOC\n", "")];
    let begin = with(BALL, &[&shift[..], &[("0.001 ", "-0.2 "), ("-0.0005 ", "0.1 ")]].concat());
    let lines =
        ["force_x = \"-3.14159268 kN\"", "force_y = \"1.57079634 kN\"", "turn = \"0.0002 rad\""];
    has(&one(&begin).text, &lines);
    let step = " 3\n 001120\n 100000\n 0100111\n 60000. -0.2 0.2 0\n 0\n";
    let text = one(&begin.replace(" 0 MODULE\n", step)).text;
    let lines = [
        "force_x = [\"-3.14159268 kN\", \"-3.6 kN\"]",
        "force_y = [\"1.57079634 kN\", \"3.6 kN\"]",
        "turns = [\"0.0002 rad\", \"0 rad\"]",
        "load = [\"52.359878 kN\", \"60 kN\"]",
        "load = \"60 kN\"",
    ];
    has(&text, &lines);
    assert!(!text.contains("shifts_") && !text.contains("time"), "{text}");
    posed(&one(&begin.replace(" 0 MODULE\n", step)));
}

/// Later cases keep what they do not give anew: law of friction, material and rolling, grid and
/// distance; and each result element keeps its own.
#[test]
fn cases_keep_what_they_do_not_give() {
    let second = "\
% The same with more creepage
 3
  203100
  100000
 0100111
 52359.878 0.002 0 0
 0
";
    let text = BALL.trim_end().trim_end_matches("0 MODULE").to_owned() + second;
    let import = import(&text);
    assert!(import.errors.is_empty(), "{:?}", import.errors);
    let names: Vec<&str> = import.cases.iter().map(|case| case.name.as_str()).collect();
    assert_eq!(names, ["ball_1.toml", "ball_2.toml"]);
    assert_eq!(import.cases[1].title, "The same with more creepage");
    let body = |k: usize| {
        let text = &import.cases[k].text;
        text[text.find("[wheel]").unwrap()..].to_owned()
    };
    assert_eq!(body(0), body(1));
    has(&import.cases[1].text, &["creepage_x = 0.002", "speed = \"30 m/s\"", "spin = \"0 1/m\""]);
    // Another element has nothing to keep; the digit R keeps the module, and may skip a case.
    let other = errors(&text.replace("\n 3\n  203100", "\n 3 2\n  203100"));
    assert!(
        other[0].contains("L = 1 keeps what an earlier case has, but there is none"),
        "{other:?}"
    );
    let stays = text.replace("0000111", "0000112").replace("\n 3\n  203100", "\n  203100");
    let import = super::support::import(&stays);
    assert!(import.errors.is_empty(), "{:?}", import.errors);
    assert_eq!((import.skipped, import.cases.len()), (vec![1], 1));
}

/// Steps of transient rolling are one case with a history, from nothing or from a shift.
#[test]
fn steps_become_a_history() {
    let begin = with(BALL, &[("203100", "202100"), (" 0 MODULE\n", "")]);
    let step = |load: &str, creepage: &str| {
        format!(" 3\n  002100\n  100000\n 0100111\n {load} {creepage} -0.0005 0.0002\n")
    };
    let text = format!("{begin}{}{} 0\n", step("52359.878", "0.001"), step("60000.", "0.002"));
    let case = one(&text);
    assert_eq!(case.numbers, [1, 2, 3]);
    // 0.25 mm at 30 m/s; a step has one creepage throughout.
    let lines = [
        "time = [\"0 ms\", \"0.008333333333333 ms\", \"0.01666666666667 ms\", \"0.01666666666667 ms\", \
         \"0.025 ms\"]",
        "creepage_x = [0.001, 0.001, 0.001, 0.002, 0.002]",
        "load = [\"52.359878 kN\", \"52.359878 kN\", \"52.359878 kN\", \"52.359878 kN\", \"60 kN\"]",
    ];
    has(&case.text, &lines);
    assert!(!case.text.contains("shift") && case.text.starts_with("# Cases 1 to 3 of ball.inp"));
    let shift = with(
        BALL,
        &[
            ("203100", "201100"),
            (" 0.0d 0.25 30000.   CHI, DQ, VELOC\n", ""),
            ("0.0002 ", "0.0 "),
            (" 0 MODULE\n", ""),
        ],
    );
    let roll = " 3\n 002100\n 102000\n 0100111\n 52359.878 0.001 0 0\n 0 0.25 30000.\n .28 .28 82031.25 82031.25\n 0\n";
    let import = import(&format!("{shift}{roll}"));
    assert!(import.errors.is_empty(), "{:?}", import.errors);
    assert_eq!(import.cases.len(), 1);
    let lines = [
        "time = [\"0 ms\", \"0.008333333333333 ms\"]",
        "shifts_x = [\"0.001 mm\", \"0 mm\"]",
        "creepage_x = 0.001",
    ];
    has(&import.cases[0].text, &lines);
    let steady = with(BALL, &[(" 0 MODULE\n", "")]);
    let import = super::support::import(&format!("{steady}{} 0\n", step("60000.", "0.001")));
    assert!(import.errors.is_empty(), "{:?}", import.errors);
    assert_eq!([0, 1].map(|k| import.cases[k].numbers.clone()), [[1], [2]]);
    let lines = [
        "start = \"steady\"",
        "time = [\"0 ms\", \"0.008333333333333 ms\"]",
        "load = [\"52.359878 kN\", \"60 kN\"]",
    ];
    has(&import.cases[1].text, &lines);
}

/// What a change of the ball's input must be refused for, and in which line.
fn refused(changes: &[(&str, &str)], line: usize, expected: &str) {
    let found = errors(&with(BALL, changes));
    let place = format!("ball.inp:{line}:");
    let is_named = |error: &String| {
        let after = error.strip_prefix(&place).and_then(|rest| rest.split_once(": "));
        after.is_some_and(|(_, error)| error.starts_with(expected))
    };
    assert!(found.iter().any(is_named), "{changes:?}: {found:#?}");
}

/// Digit by digit: name, value, why, and the line.
#[test]
fn digits_that_are_not_available_are_named() {
    let gg = "GG 1,2\n";
    for (changes, line, expected) in [
        (
            &[("203100", "213100"), (gg, "GG 1,2\n 1e-4\n")][..],
            5,
            "B = 1: a compressible layer (FLXZ)",
        ),
        (&[("203100", "233100")], 5, "B = 3: a parabolic pressure on the half-space"),
        (
            &[("203100", "253000"), (" 52359.878", " 0.1")],
            5,
            "B = 5: approximate contacts (KPEC, ANALYN) need",
        ),
        (
            &[("203100", "202100"), ("022020", "022120"), (gg, "GG 1,2\n 1 1 1 1\n")],
            6,
            "M = 1: viscoelastic bodies",
        ),
        (
            &[("203100", "223100"), ("022020", "022120"), (gg, "GG 1,2\n 1 1 1 1\n")],
            5,
            "B = 2: a given pressure of viscoelastic bodies",
        ),
        (&[("022020", "022120"), (gg, "GG 1,2\n 1 -1 1 1\n")], 13, "FG2 = -1: must not be neg"),
        (&[("022020", "022220"), (gg, "GG 1,2\n 1e-5 1 1 0\n")], 6, "M = 2: FASTSIM with a flexib"),
        (
            &[("022020", "022520"), (gg, "GG 1,2\n 0.5 1 0\n")],
            13,
            "K0_MF = 0.5: FaStrip with reduced slopes",
        ),
        (
            &[("022020", "024020"), (" 0.28 0.28", " 0 1 2\n 0 0 1 0.1\n 0.28 0.28")],
            6,
            "C3 = 4: infl",
        ),
        (
            &[("022020", "029020"), (" 0.28 0.28", " 'a.dat'\n 0.28 0.28")],
            6,
            "C3 = 9: influence co",
        ),
        (&[("022020  ", "022020 2"), (gg, "GG 1,2\n 1 1 1 1\n")], 6, "M2 = 2: damping is not"),
    ] {
        refused(changes, line, expected);
    }
}

/// Value by value.
#[test]
fn values_that_are_not_available_are_named() {
    let area = "-3\n 44 44 5.0 5.0 1.1";
    for (changes, line, expected) in [
        (&[("022020", "022022")][..], 6, "E = 2: spin in one direction only"),
        (
            &[("022020", "022029"), ("1.1   MX", &EXTRA)],
            6,
            "E = 9: an extra term of the rigid slip",
        ),
        (&[("022020", "522020")], 6, "L must be 0, 2, 3, 4 or 6 where a law of friction is given"),
        (&[("0.3 0.3 ", "0.3 0.2 ")], 10, "FKIN = 0.2: FKIN must equal FSTAT, 0.3"),
        (
            &[("0.0d 0.25", "90d 0.25")],
            11,
            "CHI = 1.570796326795: rolling is available along x only",
        ),
        (&[(area, "-4\n 44 4 0.002 5.0 1.1")], 13, "IPOTCN = -4: a line contact of finite width"),
        (&[(area, "-6\n 44 44 5 4 6 1.1")], 13, "IPOTCN = -6: the contact of two half-ellipses"),
        (&[("5.0 5.0 1.1", "5.0 5.0 0.9")], 14, "SCALE = 0.9: must be at least 1"),
        (
            &[(area, "1\n 9 9 -1 0 .2 99\n 1 1\n 1 0 0 0 0 0")],
            16,
            "B3 = 0: the distance must be curved",
        ),
        (
            &[(area, "1\n 9 1 -1 0 .2 99\n 3 1\n 1 1 0 0 0 0 9 9")],
            15,
            "IBASE = 3: a single row of elements is available",
        ),
        (
            &[(area, "1\n 9 9 -1 -1 .2 .2\n 1 1\n .002 0 .002 0 0 0")],
            14,
            "MX = 9: the potential contact",
        ),
        (
            &[(area, "1\n 60 60 -6 -6 .2 .2\n 1 3\n .002 0 .002 0 0 0\n 1 2 3 4 5 6 7 8")],
            15,
            "IPLAN = 3: a planform",
        ),
        (
            &[("203100", "203000"), (area, "1\n 5 5 -1 -1 .5 .5\n 1 1\n 1 1 1 0 0 0")],
            9,
            "PEN = 52359.878: there is no such contact",
        ),
        (&[("203100", "203130")], 5, "digit F of PBTNFS must be one of 0, 1, 2, but is 3"),
        (
            &[("203100", "203110"), ("0.001 ", "-1.5 ")],
            9,
            "FXREL = -1.5: the force must be less than 1",
        ),
        (
            &[("203100", "203120"), ("0.001 ", "-0.8 "), ("-0.0005", "0.6")],
            9,
            "FXREL = -0.8: the force must be less than 1",
        ),
    ] {
        refused(changes, line, expected);
    }
}

/// Values that no contact has.
#[test]
fn impossible_values_are_named() {
    let area = "-3\n 44 44 5.0 5.0 1.1";
    for (changes, line, expected) in [
        (&[(area, "-3\n 44 44 5.0 0.0 1.1")][..], 14, "BB = 0: must be positive"),
        (&[(area, "-2\n 44 44 0.01 1e9 1.1")], 13, "IPOTCN = -2: there is no such contact"),
        (&[("203100", "203000"), ("52359.878", "-0.1")], 13, "IPOTCN = -3: FN, or PEN, must be"),
        (&[("82031.25 82031.25", "82031.25 0.0")], 12, "GG2 = 0: must be positive"),
        (&[("0.28 0.28 ", "0.6 0.28 ")], 12, "POISS1 = 0.6: must be 0 to 0.5"),
    ] {
        refused(changes, line, expected);
    }
}

/// All that is not available is told at once, and once only though two cases keep it.
#[test]
fn everything_is_told_once() {
    let gg = "GG 1,2\n";
    let several = with(
        BALL,
        &[
            ("203100", "213100"),
            ("022020", "022220"),
            (gg, "GG 1,2\n 1e-4\n 1e-5 1 1 0\n"),
            (" 0 MODULE\n", ""),
        ],
    );
    let second = " 3\n 203100\n 100200\n 0100111\n 52359.878 0.002 0 0\n 0\n";
    let found = errors(&(several + second));
    assert_eq!(found.len(), 3, "{found:#?}");
}

/// What ends the reading of a file is told with what was found before it.
#[test]
fn wrong_input_is_named() {
    for (changes, expected) in [
        (&[("-0.0005", "abc")][..], "ball.inp:9:18: CETA must be a number, but is `abc`"),
        (&[("203100", "2031000")], "PBTNFS must have 6 digits at most, but is 2031000"),
        (&[("203100", "283100")], "digit B of PBTNFS must be one of 0, 1, 2, 3, 4, 5, 6, but is 8"),
        (&[(" 3  MODULE", " 7  MODULE")], "MODULE must be 0, 1 or 3, but is 7"),
        (&[("-3\n", "-9\n")], "IPOTCN must be -6 to -1 or 1 to 4, but is -9"),
        (&[("44 44", "99999 99999")], "MX and MY must be positive and have a product of"),
        (
            &[(" 44 44 5.0 5.0 1.1   MX, MY, AA, BB, SCALE\n 0 MODULE\n", "")],
            "the file must go on with MX, MY, AA, BB, SCALE, but ends",
        ),
        (&[("022020", "122020")], "L = 1 keeps what an earlier case has, but there is none"),
    ] {
        let found = errors(&with(BALL, changes));
        assert!(found.iter().any(|error| error.contains(expected)), "{changes:?}: {found:#?}");
    }
}

/// 2 · 44 · 44 values behind the line of the grid.
static EXTRA: std::sync::LazyLock<String> =
    std::sync::LazyLock::new(|| format!("1.1   MX\n{}", "0 0\n".repeat(44 * 44)));
