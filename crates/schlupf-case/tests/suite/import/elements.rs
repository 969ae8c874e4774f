//! Elements so few that they have one pressure, numbers as Fortran and people write them, and what
//! an import tells.

use super::support::{BALL, errors, has, import, one, posed, with};
use schlupf::solver::march;
use schlupf_case::Rolling;

/// An ellipse of 5 mm under 44 elements in both directions.
const AREA: &str = "-3\n 44 44 5.0 5.0 1.1";

/// Goal: one element is a square under one pressure, not the ellipse in it. Set-up: 900 N on one
/// element of 1 mm², shifted by 1 µm. The pressure is 900 MPa; the traction follows from Boussinesq
/// and Cerruti's displacement in the middle of a square of side c under a uniform traction (Love
/// 1929; Johnson 1985, §3.6): u = p c (2 asinh 1 (2 - ν)/(π G)) of both bodies together, with
/// half of that for each. Our elements average over the area, where CONTACT takes the middle.
#[test]
fn one_element_is_a_square_under_one_pressure() {
    let square = with(
        BALL,
        &[
            ("203100", "201100"),
            (" 0.0d 0.25 30000.   CHI, DQ, VELOC\n", ""),
            (" 52359.878 0.001 -0.0005 0.0002", " 900. -0.001 0. 0."),
            (AREA, "-3\n 1 1 0.5 0.5 1.0"),
        ],
    );
    let case = one(&square);
    has(&case.text, &["model = \"tabulated\"", "load = \"0.9 kN\""]);
    let (name, table) = &case.files[0];
    assert_eq!(name, "ball_pressure.csv");
    let table = String::from_utf8(table.clone()).unwrap();
    assert!(table.lines().skip(1).all(|line| line.ends_with(",900")), "{table}");
    let posed = posed(&case);
    let contact = posed.problem.normal.normal_contact(None).unwrap();
    let extent = contact.extent();
    let sides = [extent.x, extent.y].map(|[low, high]| high - low);
    assert!(sides.iter().all(|side| (side / 1e-3 - 1.0).abs() < 1e-9), "{sides:?}");
    assert!((contact.summary.peak_pressure / 900e6 - 1.0).abs() < 1e-9);
    let Rolling::Transient(shift) = posed.rolling(None).unwrap() else {
        panic!("the case must be a shift");
    };
    let solution = march(&shift, &posed.options, &schlupf::unwatched).unwrap();
    // G of both: 82031.25 N/mm².
    let softness = 2.0 * 1f64.asinh() * (2.0 - 0.28) / (std::f64::consts::PI * 82_031.25);
    let expected = 0.001 / softness;
    let found = solution.history.last().unwrap().force.x;
    assert!((found / expected - 1.0).abs() < 0.1, "{found}, not {expected}");
}

/// One or two elements in both directions are a rectangle, of Hertz's contact in any description or
/// of a quadratic distance; in one direction alone they are no ellipse and refused.
#[test]
fn few_elements_are_a_rectangle_or_refused() {
    let table = |area: &str| {
        let case = one(&with(BALL, &[(AREA, area)]));
        let text = String::from_utf8(case.files[0].1.clone()).unwrap();
        let first = text.lines().nth(1).unwrap().to_owned();
        first.split(',').map(|number| number.parse::<f64>().unwrap()).collect::<Vec<_>>()
    };
    // 2 · 5 · 1.1 mm by 2 · 4 · 1.1 mm, four samples along x, two across.
    let found = table("-3\n 2 1 5.0 4.0 1.1");
    let expected = [-4.125, -2.2, 52_359.878 / (11.0 * 8.8)];
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{found:?}");
    // Hertz: a = (3 N R/(4 E*))^(1/3) of a sphere with R = 300 mm, E* = 113932 N/mm².
    let found = table("-1\n 1 1 0.00166666666666667 0.00166666666666667 1.0");
    assert!((found[0] + 0.5 * 4.6937).abs() < 1e-3, "{found:?}");
    let found = table("1\n 1 1 -3 -2 8 4\n 1 1\n .002 0 .002 0 0 0");
    assert!((found[2] - 52_359.878 / 32.0).abs() < 1e-6, "{found:?}");
    // Two by two, 8 by 6 mm about the lowest point (0.5, -1) mm: larger or smaller than Hertz's
    // contact, which has a = 4.7 mm.
    for b in [".002 0 .002 -.002 .004 0", ".02 0 .02 -.02 .04 0", ".0002 0 0 -.0002 0 0"] {
        let found = table(&format!("1\n 2 2 -3.5 -4 4 3\n 1 1\n {b}"));
        let expected = [-3.0, -2.25, 52_359.878 / 48.0];
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{b}: {found:?}");
    }
    for (area, told) in [
        ("-3\n 1 40 5.0 5.0 1.0", "ball.inp:14:2: MX = 1: one or two elements have the same"),
        ("-3\n 40 2 5.0 5.0 1.0", "ball.inp:14:5: MY = 2: one or two elements have the same"),
        ("-3\n 2 2 5.0 5.0 3.0", "ball.inp:14:2: MX = 2: one or two elements have the same"),
        ("1\n 2 2 -5 -5 5 5\n 1 1\n .004 0 .004 -.002 0 0", "ball.inp:14:2: MX = 2: one or two"),
        ("1\n 2 9 -6 -6 6 1.5\n 1 1\n .002 0 .002 0 0 0", "ball.inp:14:2: MX = 2: one or two"),
    ] {
        let found = errors(&with(BALL, &[(AREA, area)]));
        assert!(found.iter().any(|error| error.starts_with(told)), "{area}: {found:#?}");
    }
    let approach =
        with(BALL, &[(AREA, "-3\n 1 1 5 5 1"), ("203100", "203000"), ("52359.878", ".1")]);
    let found = errors(&approach);
    assert!(
        found[0].starts_with("ball.inp:9:2: PEN = 0.1: an approach is not available for so few")
    );
    let bound = with(BALL, &[(AREA, "-3\n 1 1 5 5 1"), ("203100", "223100")]);
    assert!(errors(&bound)[0].starts_with("ball.inp:5:4: B = 2: an elliptic"), "{bound}");
}

/// Exponents without a letter, with D, and decimal commas, which would be two values.
#[test]
fn numbers_as_they_are_written() {
    let plain = one(BALL).text;
    let fortran = with(BALL, &[("1e-5", ".1-04"), (" 0.001 ", " .1D-02 "), ("30000.", "3.+4")]);
    assert_eq!(one(&fortran).text, plain);
    for (from, to, told) in [
        ("0.001 -0.0005", "0,001 -0.0005", "ball.inp:9:12: CKSI must be a number, but is `0,001`"),
        ("0.3 0.3 ", "0,3 0,3 ", "ball.inp:10:2: FSTAT must be a number, but is `0,3`"),
        ("0.0d 0.25", "0.0d 0,25", "ball.inp:11:7: DQ must be a number, but is `0,25`"),
    ] {
        let found = errors(&with(BALL, &[(from, to)]));
        assert!(found[0].starts_with(told), "{found:?}");
        assert!(found[0].contains("a comma separates values"), "{found:?}");
    }
    // Commas that separate: with a space, with a point, or in a list.
    for list in ["0.3, 0.3", "0.3,0.3", "0.3 ,0.3"] {
        assert_eq!(one(&with(BALL, &[("0.3 0.3", list)])).text, plain, "{list}");
    }
    // Whole numbers are separated, too, where the line needs both of them.
    let text = |list: &str| one(&with(BALL, &[("0.3 0.3", list)])).text;
    assert_eq!(text("1,1"), text("1.0 1.0"));
    assert_eq!(text("1,1 FSTAT, FKIN"), text("1.0 1.0"));
    assert_eq!(
        one(&with(BALL, &[("44 44 5.0 5.0 1.1", "44,44 5,5 2")])).text,
        one(&with(BALL, &[("44 44 5.0 5.0 1.1", "44 44 5.0 5.0 2.0")])).text
    );
}

/// What changes results is a value, refused, or told: each kind once, with its first line.
#[test]
fn what_differs_is_told() {
    let gg = "GG 1,2\n 0.5 0.02 0.6\n";
    let fastsim = [("203100", "223100"), ("022020", "022320"), ("GG 1,2\n", gg)];
    let codes = |text: &str| {
        let import = import(text);
        assert!(import.errors.is_empty(), "{:#?}", import.errors);
        import.notices.iter().map(|notice| notice.code).collect::<Vec<_>>()
    };
    assert_eq!(codes(BALL), ["settings-left-out"]);
    let expected = ["settings-left-out", "other-fastsim", "other-slope-reduction"];
    assert_eq!(codes(&with(BALL, &fastsim)), expected);
    let straight = with(&with(BALL, &fastsim), &[("-0.0005 0.0002", "0. 0.")]);
    assert_eq!(codes(&straight), expected[..2]);
    let strips = [("022020", "022520"), ("GG 1,2\n", "GG 1,2\n 1 1 0\n")];
    assert_eq!(codes(&with(BALL, &strips)), ["settings-left-out", "no-strips"]);
    let moved = "1\n 60 60 -5.5 -6.0 0.2 0.2\n 1 1\n .0017 0 .0017 -.0017 -.001 0";
    assert_eq!(codes(&with(BALL, &[(AREA, moved)])), ["settings-left-out", "moment-at-middle"]);
    let second = " 3\n 223100\n 122320\n 0100111\n 52359.878 0.002 0 0\n 0. 0.25 30000.\n \
                  .28 .28 82031.25 82031.25\n 1 1 0\n -3\n 44 44 5. 5. 1.1\n 0\n";
    let import = import(&with(&straight, &[(" 0 MODULE\n", second)]));
    assert!(import.errors.is_empty(), "{:#?}", import.errors);
    let told: Vec<_> = import.notices.iter().map(|notice| notice.text.as_str()).collect();
    assert!(told[1].starts_with("line 6 and 1 more: CONTACT's FASTSIM"), "{told:?}");
    // All of the plastic work heats here.
    let heat = "GG 1,2\n 8200 1.25 200 0\n 0. 450. 50e-3 7.85e-6\n 0. 450. 50e-3 7.85e-6\n";
    let part = |part: &str| {
        let heat = format!("{heat} {part}\n");
        let text = [("022020", "022420"), ("0000111", "3000111"), ("GG 1,2\n", heat.as_str())];
        errors(&with(BALL, &text))
    };
    assert!(part("1.0").is_empty());
    assert!(
        part("0.9")[0].contains("BETAPL = 0.9: a part of the plastic work"),
        "{:?}",
        part("0.9")
    );
}
