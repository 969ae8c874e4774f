//! Input files of CONTACT with a layer between the surfaces, and with forces over time.

mod support;

use support::{BALL, errors, has, one, with};

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
    assert!(one(&below).text.contains("`schlupf subsurface`"));
}
