//! `[contact_law.roughness]`: k_c from heights, a spectrum or files, and what is wrong with bad
//! ones.

use std::path::Path;

use crate::support::{Row, assert_errors, read};
use approx::assert_relative_eq;
use schlupf::unwatched;
use schlupf_case::{Case, CaseFile, Folder, LawStiffness, Overrides, StiffnessOrigin};

fn texts(notices: &[schlupf::reporting::Message]) -> Vec<String> {
    notices.iter().map(|notice| notice.text.clone()).collect()
}

/// k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms) for ν = 0.28, μ0 = 0.4 (the defaults), in 1/m.
fn by_hand(slope_factor: f64, rms_height: f64) -> f64 {
    1.44 / (0.4 * 1.72 * slope_factor * rms_height)
}

fn stiffness(text: &str) -> LawStiffness {
    read(text, &[]).unwrap().law_stiffness
}

/// In the folder of the samples of other formats.
fn with_samples(text: &str, overrides: &[&str]) -> Result<Case, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/surfaces");
    let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
    CaseFile::from_str(
        text,
        "case.toml",
        Folder::new(folder),
        Overrides { option: "--set", assignments: &overrides },
    )
    .and_then(|file| file.pose(&unwatched))
    .map_err(|error| error.to_string())
}

/// A surface of 128² cells that the tests solve quickly.
const SPECTRUM: &str = "[contact_law.roughness]\nrms_slope = 0.1\nlongest_wavelength = \"100 um\"\n\
                        shortest_wavelength = \"25 um\"\ncells = 128\n";

#[test]
fn the_closed_form_is_that_of_the_theory() {
    let one = stiffness("[contact_law]\nroughness = { rms_height = \"1.5 um\" }");
    assert_relative_eq!(one.stiffness, by_hand(0.45, 1.5e-6), max_relative = 1e-12);
    assert!(matches!(one.origin, StiffnessOrigin::ClosedForm { slope_factor: 0.45, .. }));
    let both = stiffness(
        "contact_law.roughness.rms_height_wheel = \"3 um\"\n\
         contact_law.roughness.rms_height_rail = \"4 um\"\n\
         contact_law.roughness.slope_factor = 0.4",
    );
    assert_relative_eq!(both.stiffness, by_hand(0.4, 5e-6), max_relative = 1e-12);
    let smooth_wheel = stiffness("[contact_law.roughness]\nrms_height_rail = \"2 um\"");
    assert_relative_eq!(smooth_wheel.stiffness, by_hand(0.45, 2e-6), max_relative = 1e-12);
}

#[test]
fn an_override_may_name_a_roughness_or_take_it_out() {
    let set = |text: &str, set: &str| read(text, &[set]).unwrap().law_stiffness;
    let roughness = set("", "contact_law.roughness.rms_height=1 um");
    assert_relative_eq!(roughness.stiffness, by_hand(0.45, 1e-6), max_relative = 1e-12);
    let none =
        set("[contact_law]\nroughness = { rms_height = \"1 um\" }", "contact_law.roughness=");
    assert!(matches!(none.origin, StiffnessOrigin::Default) && none.stiffness == 5e6);
    let given = read("[contact_law]\nstiffness = \"1e6 1/m\"", &[]).unwrap().law_stiffness;
    assert!(matches!(given.origin, StiffnessOrigin::Given) && given.stiffness == 1e6);
    // The default case has a roughness as easily as any other.
    let template = CaseFile::default_text();
    let roughness = set(&template, "contact_law.roughness.rms_height=1 um");
    assert!(matches!(roughness.origin, StiffnessOrigin::ClosedForm { .. }));
}

/// Two different bodies: the ratio of tangential to normal compliance of a circular spot is c = ½ Σ
/// (2 − ν)/G / Σ (1 − ν)/G (Johnson 1985, Eq. 7.42 over Eq. 3.36), and k_c = 1/(μ c γ h_rms).
#[test]
fn johnson_1985_two_different_bodies() {
    let case = stiffness(
        "[wheel]\nyoung_modulus = \"100 GPa\"\npoisson_ratio = 0.4\n\
         [contact_law]\nroughness = { rms_height = \"1 um\" }",
    );
    let shear = [100e9 / 2.8, 210e9 / 2.56];
    let sum = |value: [f64; 2]| value[0] / shear[0] + value[1] / shear[1];
    let ratio = 0.5 * sum([1.6, 1.72]) / sum([0.6, 0.72]);
    assert_relative_eq!(case.stiffness, 1.0 / (0.4 * ratio * 0.45e-6), max_relative = 1e-12);
}

/// Goal: the micro model answers with a k_c near the closed form of its own h_rms, and says how
/// well Eq. (8) fits. Source: γ = 0.35 to 0.55 (Persson 2007, Lorenz and Persson 2009).
#[test]
fn a_spectrum_goes_through_the_micro_model() {
    let case = read(SPECTRUM, &[]).unwrap();
    let micro = case.micro_contact().unwrap();
    let height = micro.result.statistics.root_mean_square_height;
    assert_relative_eq!(micro.result.statistics.spectral_gradient, 0.1, max_relative = 1e-9);
    let stiffness = case.law_stiffness.stiffness;
    let gamma = by_hand(1.0, height) / stiffness;
    assert!((0.35..0.55).contains(&gamma), "{gamma}");
    assert_eq!(stiffness, micro.result.stiffness.common.stiffness);
    assert_eq!(micro.result.stiffness.mean_pressures.len(), 3);
    let pressures = format!("{SPECTRUM}pressures = [\"0.3 GPa\", \"0.9 GPa\"]");
    let micro = read(&pressures, &[]).unwrap();
    assert_eq!(micro.micro_contact().unwrap().result.stiffness.mean_pressures, [0.3e9, 0.9e9]);
}

/// Of a family the normal contact is solved once, where it is the same; k_c follows the friction.
#[test]
fn a_like_case_takes_the_normal_contact_over() {
    let case = read(SPECTRUM, &[]).unwrap();
    let slippery =
        case.with("--over", &["friction.coefficient=0.2".to_owned()], &unwatched).unwrap();
    let ratio = slippery.law_stiffness.stiffness / case.law_stiffness.stiffness;
    assert_relative_eq!(ratio, 2.0, max_relative = 1e-6);
    let again = read(SPECTRUM, &["friction.coefficient=0.2"]).unwrap();
    assert_eq!(slippery.law_stiffness.stiffness, again.law_stiffness.stiffness);
    let heavy = case.with("--over", &["normal.load=200 kN".to_owned()], &unwatched).unwrap();
    let again = read(SPECTRUM, &["normal.load=200 kN"]).unwrap();
    assert_eq!(heavy.law_stiffness.stiffness, again.law_stiffness.stiffness);
}

/// The short form names a file; the long one says more about it.
#[test]
fn files_go_through_the_micro_model() {
    let short = with_samples("[contact_law]\nroughness = \"wave.x3p\"", &[]).unwrap();
    let long = with_samples(
        "[contact_law.roughness]\nfile = \"wave.npy\"\nunit = \"um\"\nspacing = \"1.5 um\"",
        &[],
    )
    .unwrap();
    let [short, long] = [short, long].map(|case| case.law_stiffness.stiffness);
    assert_relative_eq!(short, long, max_relative = 1e-6);
    let set = with_samples("", &["contact_law.roughness=wave.x3p"]).unwrap();
    assert_eq!(set.law_stiffness.stiffness, short);
    assert_eq!(&*set.files()[0].0, "contact_law.roughness.file");
    // The same surface on both bodies is twice as high.
    let both = ["contact_law.roughness.second_file=wave.x3p"];
    let both = with_samples("[contact_law]\nroughness = \"wave.x3p\"", &both).unwrap();
    let height =
        |case: &Case| case.micro_contact().unwrap().result.statistics.root_mean_square_height;
    assert_relative_eq!(height(&both), 2.0 * height(&set), max_relative = 1e-9);
    let profile = with_samples("[contact_law]\nroughness = \"profile.x3p\"", &[]).unwrap();
    assert!(profile.micro_contact().is_some());
}

/// What is doubtful about a surface is a notice: this one has too few cells.
#[test]
fn a_doubtful_surface_is_mentioned() {
    let case = with_samples("[contact_law]\nroughness = \"wave.x3p\"", &[]).unwrap();
    let notices = texts(&case.notices).join("\n");
    for expected in [
        "contact_law.roughness: the spots carry ",
        "cells are in contact at the largest pressure: k_c is doubtful",
    ] {
        assert!(notices.contains(expected), "{notices}");
    }
    let hard = ["contact_law.roughness.hardness=2.7 GPa"];
    let hard = with_samples("[contact_law]\nroughness = \"wave.x3p\"", &hard).unwrap();
    assert!(!texts(&hard.notices).join("").contains("the spots carry"), "{:?}", hard.notices);
    let smooth = with_samples("contact_law.roughness.rms_height = \"1 um\"", &[]).unwrap();
    assert_eq!(texts(&smooth.notices), [""; 0]);
}

/// Waves longer than the contact are waviness: here all but those below 40 µm.
#[test]
fn waviness_is_mentioned() {
    let large = with_samples(SPECTRUM, &[]).unwrap();
    assert!(!texts(&large.notices).join("").contains("waviness"), "{:?}", large.notices);
    let small = "[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"20 um\"\n\
                 semi_axis_y = \"15 um\"\nload = \"1 N\"\n";
    let small = with_samples(&format!("{small}{SPECTRUM}"), &[]).unwrap();
    let notices = texts(&small.notices).join("\n");
    assert!(notices.contains("waves longer than the contact, 0.040 mm"), "{notices}");
}

/// Heights in a wrong unit are noticed, also where k_c has a closed form; steep surfaces, too.
#[test]
fn wrong_units_are_mentioned() {
    for (height, is_doubtful) in [("1 mm", true), ("1 pm", true), ("1 nm", false), ("90 um", false)]
    {
        let case = read(&format!("contact_law.roughness.rms_height = \"{height}\""), &[]).unwrap();
        let is_said = case.notices.iter().any(|notice| notice.text.contains("is its unit right?"));
        assert_eq!(is_said, is_doubtful, "{height}: {:?}", case.notices);
    }
    let steep = read(SPECTRUM, &["contact_law.roughness.rms_slope=0.7"]).unwrap();
    let notices = texts(&steep.notices).join("\n");
    assert!(notices.contains("gradient is 0.7: the model takes slopes for small"), "{notices}");
}

/// A case text, the field that the error names, and parts of its text.
const BAD: &[Row] = &[
    (
        "[contact_law]\nstiffness = \"5e6 1/m\"\nroughness = { rms_height = \"1 um\" }",
        "contact_law.roughness.rms_height",
        &[
            "case.toml:3:",
            "must not be given together with contact_law.stiffness",
            "determines k_c",
        ],
    ),
    (
        "[contact_law.roughness]\nrms_height = 1.5",
        "contact_law.roughness.rms_height",
        &["case.toml:2:", "a length with its unit"],
    ),
    (
        "[contact_law.roughness]\nrms_height = \"0 um\"",
        "contact_law.roughness.rms_height",
        &["case.toml:2:", "must be between"],
    ),
    (
        "[contact_law]\nroughness = { rms_hight = \"1 um\" }",
        "contact_law.roughness.rms_hight",
        &["did you mean `contact_law.roughness.rms_height`?"],
    ),
    (
        "[contact_law]\nroughness = 3",
        "contact_law.roughness",
        &["contact_law.roughness is a section"],
    ),
    (
        "[contact_law.roughness]\nrms_height = \"1 um\"\nrms_height_rail = \"1 um\"",
        "contact_law.roughness.rms_height_rail",
        &["together with contact_law.roughness.rms_height"],
    ),
    (
        "[contact_law.roughness]\nslope_factor = 0.4",
        "contact_law.roughness.rms_height",
        &["contact_law.roughness.rms_height is missing, which contact_law.roughness.slope_factor"],
    ),
    (
        "[contact_law.roughness]\nunit = \"um\"",
        "contact_law.roughness.file",
        &["contact_law.roughness.file is missing, which contact_law.roughness.unit needs"],
    ),
    (
        "[contact_law.roughness]\nrms_height = \"1 um\"\nhurst = 0.8",
        "contact_law.roughness.longest_wavelength",
        &["longest_wavelength is missing, which contact_law.roughness.hurst needs"],
    ),
    (
        "[contact_law.roughness]\nlongest_wavelength = \"100 um\"\nshortest_wavelength = \"5 um\"",
        "contact_law.roughness.rms_height",
        &["contact_law.roughness.rms_height is missing"],
    ),
    (
        "[contact_law.roughness]\nrms_slope = 0.1\nlongest_wavelength = \"5 um\"\n\
         shortest_wavelength = \"100 um\"",
        "contact_law.roughness.longest_wavelength",
        &["case.toml:3:", "must be at least the shortest wavelength, 1e-4 m, but is 5e-6 m"],
    ),
    (
        "[contact_law.roughness]\nrms_slope = 0.1\nlongest_wavelength = \"100 um\"\n\
         shortest_wavelength = \"5 um\"\ncells = 32",
        "contact_law.roughness.shortest_wavelength",
        &["case.toml:4:", "must be at least two cells"],
    ),
    (
        "[contact_law.roughness]\nrms_slope = 0.1\nlongest_wavelength = \"100 um\"\n\
         shortest_wavelength = \"25 um\"\nhardness = \"0.5 GPa\"",
        "contact_law.roughness.hardness",
        &["case.toml:5:", "must be above the largest mean pressure", "5e8 Pa"],
    ),
    (
        "[contact_law.roughness]\nrms_slope = 0.1\nlongest_wavelength = \"100 um\"\n\
         shortest_wavelength = \"25 um\"\npressures = []",
        "contact_law.roughness.pressures",
        &["case.toml:5:", "at least one entry"],
    ),
    (
        "[contact_law]\nroughness = { file = \"none.x3p\" }",
        "contact_law.roughness.file",
        &["case.toml:2:", "contact_law.roughness.file must be a readable file"],
    ),
];

#[test]
fn each_defect_is_named_with_its_place() {
    assert_errors(BAD);
}

/// A roughness text, and parts of the error.
const BAD_FILES: &[(&str, &[&str])] = &[
    (
        "file = \"flat.x3p\"",
        &["case.toml:2:", "contact_law.roughness.file", "the surface must not be flat"],
    ),
    (
        "file = \"wave_single_holes.x3p\"",
        &[
            "case.toml:2:",
            "1 of 384 are missing, the first in row 5, column 7",
            "fill_holes = true",
        ],
    ),
    ("file = \"wave_not_square.x3p\"", &["must have square cells", "square_cells = true"]),
    ("file = \"wave.npy\"", &["contact_law.roughness.unit must be a unit of length"]),
    (
        "file = \"wave.npy\"\nunit = \"um\"",
        &["contact_law.roughness.spacing must be given, because"],
    ),
    (
        "file = \"wave.npy\"\nunit = \"s\"\nspacing = \"1 um\"",
        &["case.toml:3:", "`s` is the unit of a time"],
    ),
    ("file = \"make.py\"", &["must be a .csv, .npy, .x3p or .xyz file"]),
    (
        "file = \"wave.x3p\"\nsecond_file = \"flat.x3p\"",
        &[
            "case.toml:3:",
            "contact_law.roughness.second_file is no surface: the surface must not be flat",
        ],
    ),
    (
        "file = \"wave.npy\"\nunit = \"m\"\nspacing = \"1.5 um\"\nform = \"none\"",
        &[
            "case.toml:2:",
            "must have a root mean square gradient of at most 2",
            "is the unit of the",
        ],
    ),
    (
        "rms_height = \"50 um\"\nlongest_wavelength = \"50 um\"\nshortest_wavelength = \"10 um\"",
        &["case.toml:2:", "rms_height must have a root mean square gradient of at most 2"],
    ),
];

#[test]
fn each_defect_of_a_file_is_named() {
    for (text, parts) in BAD_FILES {
        let text = format!("[contact_law.roughness]\n{text}\n");
        let message = with_samples(&text, &[]).unwrap_err();
        for part in *parts {
            assert!(message.contains(part), "{text}: {part:?} is not in {message:?}");
        }
    }
}

/// Fast methods have no contact law: a roughness is neither read nor solved.
#[test]
fn a_fast_method_needs_no_roughness() {
    let fast = "[solver]\nmethod = \"fastsim\"\n[contact_law.roughness]\nfile = \"none.x3p\"";
    let case = read(fast, &[]).unwrap();
    assert!(matches!(case.law_stiffness.origin, StiffnessOrigin::Default));
    assert!(case.notices[0].text.contains("contact_law.roughness.file has no effect"));
}
