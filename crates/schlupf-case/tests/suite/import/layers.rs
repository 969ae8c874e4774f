//! Input files of CONTACT with a layer between the surfaces, with forces over time, and with many
//! cases that become a study.

use super::support::{BALL, errors, has, import, one, with};
use schlupf_case::import::contact::grouped;

/// Forces over time: FXREL and FYREL times FSTAT FN of each step, in place of the creepages.
#[test]
fn forces_of_steps_become_a_history() {
    let begin = with(
        BALL,
        &[("203100", "202120"), (" 0 MODULE\n", ""), ("0.001 ", "-0.5 "), ("-0.0005", "0.2")],
    );
    let step = " 3\n  002120\n  100000\n 0100111\n 60000. -0.4 0.2 0.0002\n 0\n";
    let case = one(&format!("{begin}{step}"));
    assert_eq!(case.numbers, [1, 2]);
    // Times 0.3 · 52.359878 kN, and 0.3 · 60 kN.
    let lines = [
        "force_x = [\"-7.8539817 kN\", \"-7.8539817 kN\", \"-7.2 kN\"]",
        "force_y = [\"3.14159268 kN\", \"3.14159268 kN\", \"3.6 kN\"]",
    ];
    has(&case.text, &lines);
    assert!(!case.text.contains("creepage_"), "{}", case.text);
    let mixed = step.replace("002120", "002100").replace("-0.4", "0.001");
    let found = errors(&format!("{begin}{mixed}"));
    assert!(found[0].contains("F = 0: a change within a sequence"), "{found:?}");
}

/// A layer between the surfaces, elastic where TAU_C0 is zero, or with a limit; points below the
/// surface are another command's.
#[test]
fn a_layer_and_points_below_the_surface() {
    let layer = |model: &str| {
        let model = format!("GG 1,2\n {model}\n");
        one(&with(BALL, &[("022020", "022420"), ("GG 1,2\n", &model)])).text
    };
    let elastic = layer("8200 1.25 0 0");
    has(&elastic, &["thickness = \"1.25 mm\"", "shear_modulus = \"8200 MPa\""]);
    has(&elastic, &["model = \"half-space\"", "model = \"coulomb\""]);
    assert!(!elastic.contains("yield_stress"), "{elastic}");
    let flows = layer("5000 1 200 434.8");
    has(&flows, &["yield_stress = \"200 MPa\"", "hardening = \"434.8 MPa/mm\""]);
    let below = with(BALL, &[("203100", "203101")]);
    let told = import(&below).notices;
    assert!(told.iter().any(|notice| notice.text.starts_with("line 5: the points of stresses")));
}

/// Cases that differ in numbers only are rows of one study, whatever comes between them; others
/// stay cases: here one with a force in place of a creepage, and one that has an equal neither.
#[test]
fn cases_that_differ_in_numbers_are_a_study() {
    let more = |digits: &str, motion: &str| {
        format!(" 3\n {digits}\n 100000\n 0100111\n {motion} 0.0002\n")
    };
    let text = BALL.trim_end().trim_end_matches("0 MODULE").to_owned()
        + &more("203100", "52359.878 0.002 -0.0005")
        + &more("203110", "52359.878 -0.5 -0.0005")
        + &more("203100", "60000. 0.001 -0.0005")
        + " 0\n";
    let import = import(&text);
    assert!(import.errors.is_empty() && import.cases.len() == 4, "{:#?}", import.errors);
    let grouped = grouped(import.cases);
    let [case] = &grouped.cases[..] else { panic!("{:#?}", grouped.cases) };
    assert_eq!(case.numbers, [3]);
    let [study] = &grouped.studies[..] else { panic!("{:#?}", grouped.studies) };
    assert_eq!(study.numbers, [1, 2, 4]);
    assert_eq!([&study.study.0, &study.states.0], ["ball_1_study.toml", "ball_1_states.csv"]);
    let expected = "# A row for each of the cases 1–2, 4 of an input of CONTACT.\n\n\
                    case = \"ball_1.toml\"\n\n[states]\nfile = \"ball_1_states.csv\"\n";
    assert_eq!(study.study.1, expected);
    // Semi-axes are those of the input; the load changes, and nothing that follows from it.
    let states =
        "normal.load [kN],kinematics.creepage_x\n52.359878,0.001\n52.359878,0.002\n60,0.001\n";
    assert_eq!(study.states.1, states);
    // Cases without any difference have nothing to vary.
    let twice = BALL.trim_end().trim_end_matches("0 MODULE").to_owned()
        + &more("203100", "52359.878 0.001 -0.0005")
        + " 0\n";
    let same = grouped_of(&twice);
    assert!(same.studies.is_empty() && same.cases.len() == 2);
}

fn grouped_of(text: &str) -> schlupf_case::import::contact::Grouped {
    grouped(import(text).cases)
}
