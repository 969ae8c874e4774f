//! Everything that can be wrong with a case file: each error names the field, what it must be, what
//! it is and where it stands.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::support::{assert_errors, read};
use schlupf_case::{CaseFile, Folder, Overrides};

#[test]
fn unknown_names_come_with_a_suggestion() {
    assert_errors(&[
        (
            "[kinematics]\ncreepage = 0.1",
            "kinematics.creepage",
            &["case.toml:2:1", "unknown field", "did you mean `kinematics.creepage_x`?"],
        ),
        ("[kinematics]\nload = \"80 kN\"", "kinematics.load", &["did you mean `normal.load`?"]),
        (
            "[friction]\nmu = 0.3",
            "friction.mu",
            &["the fields of [friction] are model, coefficient"],
        ),
        ("titel = \"x\"", "titel", &["case.toml:1:1", "did you mean `title`?"]),
        (
            "[kinematic]\nspeed = \"1 m/s\"",
            "kinematic",
            &["case.toml:1:2", "did you mean [kinematics]?"],
        ),
        ("[tyre]", "tyre", &["the sections are kinematics, wheel, rail"]),
        ("kinematics = 3", "kinematics", &["is a section", "[kinematics]"]),
        ("[wheel.material]\nE = 1", "wheel.material", &["unknown section"]),
    ]);
}

#[test]
fn per_cent_is_no_unit_of_a_creepage() {
    const ADVICE: &str = "not a percentage: 1 % is 0.01";
    assert_errors(&[
        ("[kinematics]\ncreepage_x = 1.539", "kinematics.creepage_x", &["reversed", ADVICE]),
        ("[kinematics]\ncreepage_y = -1.539", "kinematics.creepage_y", &["below 1", ADVICE]),
        ("[kinematics]\ncreepage_x = \"1 %\"", "kinematics.creepage_x", &["quotes", ADVICE]),
        (
            "[history]\ntime = [\"0 s\", \"1 s\"]\ncreepage_x = [0.0, 1.539]",
            "history.creepage_x",
            &["at 1 s", "reversed", ADVICE],
        ),
        (
            "[history]\ntime = [\"0 s\", \"1 s\"]\ncreepage_y = [0.0, 1.539]",
            "history.creepage_y",
            &[ADVICE],
        ),
    ]);
}

#[test]
fn wrong_types_are_named() {
    assert_errors(&[
        (
            "[kinematics]\nspeed = true",
            "kinematics.speed",
            &["case.toml:2:9", "a speed", "is true"],
        ),
        ("[kinematics.speed]\nx = 1", "kinematics.speed", &["a speed", "a table"]),
        ("[kinematics]\nspeed = 1979-05-27", "kinematics.speed", &["is a date"]),
        ("[grid]\ncells_x = 24.5", "grid.cells_x", &["a whole number", "24.5"]),
        ("[grid]\ncells_x = \"24\"", "grid.cells_x", &["a whole number", "without quotes"]),
        ("[grid]\ncells_x = 99999999999999999999", "grid.cells_x", &["too many digits"]),
        ("title = 3", "title", &["text in quotes", "is 3"]),
        (
            "[friction]\nmodel = 3",
            "friction.model",
            &["one of \"temperature-linear\", \"constant\""],
        ),
        (
            "[friction]\nmodel = \"constnat\"",
            "friction.model",
            &["but is \"constnat\"", "did you mean \"constant\"?"],
        ),
        (
            "[heat]\npartition = \"speed\"",
            "heat.partition",
            &["a number without unit, or \"velocity\""],
        ),
        ("[history]\ntime = \"0 s\"", "history.time", &["an array"]),
        (
            "[history]\ntime = [\"0 s\", 1]",
            "history.time",
            &["case.toml:2:16", "a time with its unit"],
        ),
        ("[history]\ncreepage_x = [0, \"1\"]", "history.creepage_x", &["case.toml:2:18"]),
    ]);
}

/// An .npy file holds no positions; the model would do without spacings for another file.
#[test]
fn spacings_are_missing_for_an_npy_file() {
    let files = BTreeMap::from([("p.npy".to_owned(), b"\x93NUMPY".to_vec())]);
    let text = "[normal]\nmodel = \"tabulated\"\nfile = \"p.npy\"\nspacing_x = \"1 mm\"\n";
    let errors =
        CaseFile::from_str(text, "case.toml", Arc::new(files), Overrides::NONE).unwrap_err();
    let message = errors.first.to_string();
    let expected = "case.toml:3:8: normal.spacing_y is missing, which normal.file needs";
    assert!(message.starts_with(expected), "{message}");
}

/// Whoever embeds the reader names what overrides the file.
#[test]
fn overrides_have_the_name_that_the_caller_gives() {
    let text = "[kinematics]\nangular_velocity = \"60 rad/s\"\nwheel_radius = \"0.5 m\"\n";
    let assignments = ["kinematics.creepage_x=0.1".to_owned()];
    let option = String::from("keyword");
    let overrides = Overrides { option: &option, assignments: &assignments };
    let file = CaseFile::from_str(text, "case.toml", Folder::new(""), overrides);
    let message = file.unwrap_err().first.to_string();
    for part in [
        "keyword kinematics.creepage_x=0.1: kinematics.creepage_x must not be given together",
        "from the file, or with keyword kinematics.",
    ] {
        assert!(message.contains(part), "{part:?} is not in {message}");
    }
}

#[test]
fn units_are_checked() {
    assert_errors(&[
        (
            "[kinematics]\nspeed = 30",
            "kinematics.speed",
            &["case.toml:2:9", "in m/s or km/h", "but is 30", "write the unit and quotes"],
        ),
        ("[kinematics]\nspeed = \"30\"", "kinematics.speed", &["the unit is missing"]),
        (
            "[kinematics]\nspeed = \"30 kN\"",
            "kinematics.speed",
            &["m/s or km/h", "\"30 kN\"", "`kN` is the unit of a force"],
        ),
        ("[kinematics]\nspeed = \"30 kmh\"", "kinematics.speed", &["unknown unit `kmh`"]),
        ("[kinematics]\nspeed = \"30 m//s\"", "kinematics.speed", &["not a product or quotient"]),
        ("[kinematics]\nspeed = \"fast\"", "kinematics.speed", &["no number in front"]),
        ("[kinematics]\nspeed = \"30,5 m/s\"", "kinematics.speed", &["write 30.5 m/s"]),
        (
            "[kinematics]\ncreepage_x = \"0.8 %\"",
            "kinematics.creepage_x",
            &["a number without unit", "\"0.8 %\"", "without quotes and unit"],
        ),
        (
            "[kinematics]\nangular_velocity = \"10 Hz\"",
            "kinematics.angular_velocity",
            &["rad/s, deg/s or rpm", "`Hz` is s^-1"],
        ),
        (
            "[friction]\ntemperature_at_zero_friction = \"700 degC\"",
            "friction.temperature_at_zero_friction",
            &["a temperature difference", "a difference is given in K"],
        ),
        (
            "[wheel]\nbulk_temperature = \"20 W\"",
            "wheel.bulk_temperature",
            &["degC, K or degF", "`W` is kg m^2 s^-3"],
        ),
    ]);
}

#[test]
fn illegal_numbers_are_named() {
    assert_errors(&[
        (
            "[kinematics]\nspeed = \"0 m/s\"",
            "kinematics.speed",
            &["must be between 1e-6 and 10000 m/s", "\"0 m/s\""],
        ),
        (
            "[kinematics]\nspeed = \"-3 m/s\"",
            "kinematics.speed",
            &["must be between 1e-6 and 10000 m/s", "\"-3 m/s\""],
        ),
        ("[kinematics]\nspeed = \"inf m/s\"", "kinematics.speed", &["between"]),
        ("[kinematics]\nspeed = nan", "kinematics.speed", &["a speed", "NaN"]),
        ("[kinematics]\ncreepage_x = nan", "kinematics.creepage_x", &["must be finite", "NaN"]),
        ("[kinematics]\ncreepage_x = inf", "kinematics.creepage_x", &["must be finite", "inf"]),
        ("[kinematics]\ncreepage_y = 1", "kinematics.creepage_y", &["above -1 and below 1"]),
        ("[kinematics]\nyaw_angle = \"90.1 deg\"", "kinematics.yaw_angle", &["below"]),
        ("[kinematics]\nspin = \"1e999 1/m\"", "kinematics.spin", &["too large"]),
        ("[wheel]\nyoung_modulus = \"0 GPa\"", "wheel.young_modulus", &["between"]),
        ("[rail]\npoisson_ratio = 0.6", "rail.poisson_ratio", &["between 0 and 0.5", "0.6"]),
        ("[rail]\nradius_y = \"0 mm\"", "rail.radius_y", &["in magnitude"]),
        ("[rail]\nradius_y = \"nan\"", "rail.radius_y", &["in magnitude", "nan"]),
        (
            "[rail]\nbulk_temperature = \"-1 K\"",
            "rail.bulk_temperature",
            &["between -273.15 and 1e5 degC"],
        ),
        ("[normal]\nload = \"0 kN\"", "normal.load", &["between"]),
        (
            "[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"-1 mm\"",
            "normal.semi_axis_x",
            &["between"],
        ),
        ("[elasticity]\nbedding_x = \"0 N/m^3\"", "elasticity.bedding_x", &["between"]),
        ("[elasticity]\ncoupling_x = \"-1 N/m\"", "elasticity.coupling_x", &["between 0 and"]),
        ("[elasticity]\nmargin = \"inf\"", "elasticity.margin", &["between"]),
        ("[contact_law]\nstiffness = \"0 1/m\"", "contact_law.stiffness", &["between"]),
        ("[friction]\ncoefficient = -0.1", "friction.coefficient", &["between"]),
        (
            "[friction]\nminimum_coefficient = -0.1",
            "friction.minimum_coefficient",
            &["between 0 and"],
        ),
        (
            "[friction]\ntemperature_at_zero_friction = \"0 K\"",
            "friction.temperature_at_zero_friction",
            &["between"],
        ),
        ("[heat]\npartition = 1.1", "heat.partition", &["between 0 and 1"]),
        ("[grid]\ncells_x = 1", "grid.cells_x", &["between 2 and 1024", "is 1"]),
        ("[grid]\ncells_y = 1025", "grid.cells_y", &["between 1 and 1024", "is 1025"]),
        ("[solver]\ntolerance = 0.0", "solver.tolerance", &["between"]),
        ("[solver]\nmax_steps = 0", "solver.max_steps", &["at least 1"]),
        ("[solver]\nslip_threshold = 1.5", "solver.slip_threshold", &["above 0 and at most 0.999"]),
        ("[history]\nload = [\"80 kN\", \"0 kN\"]", "history.load", &["between", "case.toml:2:18"]),
    ]);
}

#[test]

fn contradictions_name_both_sides() {
    assert_errors(&[
        (
            "[kinematics]\ncreepage_x = 0.1\nangular_velocity = \"60 rad/s\"",
            "kinematics.creepage_x",
            &["together with kinematics.angular_velocity", "0.1", "\"60 rad/s\"", "case.toml:3:20"],
        ),
        (
            "[kinematics]\ncreepage_y = 0.1\nyaw_angle = \"1 deg\"",
            "kinematics.creepage_y",
            &["together with kinematics.yaw_angle"],
        ),
        (
            "[normal]\nmodel = \"ellipse\"\nload = \"80 kN\"\npeak_pressure = \"1 GPa\"",
            "normal.load",
            &["together with normal.peak_pressure", "the peak pressure determines the load"],
        ),
        (
            "[normal]\nload = \"80 kN\"\napproach = \"50 um\"",
            "normal.load",
            &["together with normal.approach", "the approach determines the load"],
        ),
        (
            "[normal]\napproach = \"50 um\"\n[history]\ntime = [\"0 s\", \"1 s\"]\n\
             load = [\"80 kN\", \"90 kN\"]",
            "history.load",
            &["together with normal.approach"],
        ),
        (
            "[elasticity]\nbedding_x = \"1e13 N/m^3\"\nspring_x = \"1e6 N/m\"",
            "elasticity.spring_x",
            &["together with elasticity.bedding_x"],
        ),
        (
            "[elasticity]\ncalibration = \"half-space\"\ncoupling_x_across = \"1e7 N/m\"",
            "elasticity.coupling_x_across",
            &["together with elasticity.calibration", "the calibration gives all stiffnesses"],
        ),
        (
            "[normal]\napproach = \"50 um\"\n[elasticity]\nmodel = \"viscoelastic\"",
            "normal.approach",
            &["must not be given for viscoelastic bodies"],
        ),
        (
            "[normal]\nmodel = \"wheel-rail\"\n[elasticity]\nmodel = \"viscoelastic\"",
            "elasticity.model",
            &["must not be viscoelastic with normal.model"],
        ),
        (
            "[elasticity]\nmodel = \"viscoelastic\"\n[rail]\nrelaxed_modulus = \"211 GPa\"",
            "rail.relaxed_modulus",
            &["2.1e11", "2.11e11"],
        ),
        (
            "[history]\nfile = \"h.csv\"\ntime = [\"0 s\", \"1 s\"]",
            "history.time",
            &["together with history.file"],
        ),
    ]);
}

#[test]
fn missing_fields_say_what_needs_them() {
    assert_errors(&[
        (
            "[normal]\nmodel = \"ellipse\"",
            "normal.semi_axis_x",
            &["is missing", "normal.model = \"ellipse\"", "such as semi_axis_x = \"6 mm\""],
        ),
        (
            "[normal]\nmodel = \"tabulated\"",
            "normal.file",
            &["case.toml:2:9", "is missing", "\"tabulated\""],
        ),
        (
            "[normal]\nmodel = \"tabulated\"\nfile = \"none.csv\"",
            "normal.file",
            &["case.toml:3:8", "readable file", "/nowhere/none.csv"],
        ),
        (
            "[elasticity]\nspring_x = \"1e6 N/m\"",
            "elasticity.spring_coupling_x",
            &["is missing", "Δc_k"],
        ),
        (
            "[elasticity]\nbedding_x = \"1e13 N/m^3\"",
            "elasticity.coupling_x",
            &["is missing", "coupling stiffness"],
        ),
        (
            "[elasticity]\nmodel = \"winkler\"\nbedding_y = \"1e13 N/m^3\"",
            "elasticity.bedding_x",
            &["is missing", "elasticity.model = \"winkler\""],
        ),
        ("[history]\ncreepage_x = [0.0, 0.1]", "history.time", &["is missing"]),
    ]);
}

#[test]
fn what_the_physics_refuses_is_named_at_its_place() {
    assert_errors(&[
        (
            "[kinematics]\nangular_velocity = \"0 rad/s\"",
            "kinematics.angular_velocity",
            &[
                "case.toml:2:20",
                "kinematics.angular_velocity must be positive",
                "0 rad/s",
                "locked",
            ],
        ),
        (
            "[kinematics]\nangular_velocity = \"-60 rad/s\"",
            "kinematics.angular_velocity",
            &["-60 rad/s", "reversed"],
        ),
        ("[kinematics]\ncreepage_x = 1.0", "kinematics.creepage_x", &["case.toml:2:14", "locked"]),
        (
            "[kinematics]\nangular_velocity = \"60 rad/s\"\n[wheel]\nradius_x = \"inf\"",
            "kinematics.wheel_radius",
            &["between 1e-6 and 1e6 m", "wheel.radius_x", "case.toml:4:12"],
        ),
        (
            "[wheel]\nbulk_temperature = \"1500 degC\"",
            "wheel.bulk_temperature",
            &["case.toml:2:20", "enters the contact at 760 degC", "at 720 degC"],
        ),
        ("[friction]\nminimum_coefficient = 0.5", "friction.minimum_coefficient", &["0.5"]),
        ("[rail]\nradius_y = \"inf\"", "rail.radius_y", &["case.toml:2:12"]),
        (
            "[history]\ntime = [\"0 s\", \"1 s\", \"0.5 s\"]\nspin = [\"0 1/m\", \"0 1/m\", \"0 1/m\"]",
            "history.time",
            &["case.toml:2:8", "time must ascend"],
        ),
        (
            "[history]\ntime = [\"0 s\", \"1 s\"]\ncreepage_x = [0.0]",
            "history.creepage_x",
            &["case.toml:3:14", "as many entries as history.time, 2, but has 1"],
        ),
    ]);
}

/// Negative without a floor, a floor above μ0, contradictory temperatures.
#[test]
fn impossible_friction_is_named() {
    assert_errors(&[
        (
            "[friction]\nmodel = \"linear-in-speed\"\nhalf_speed = \"1 m/s\"",
            "friction.kinetic_coefficient",
            &[
                "case.toml:2:9",
                "is missing",
                "\"linear-in-speed\" needs",
                "limit at large slip speeds",
            ],
        ),
        (
            "[friction]\nmodel = \"exponential\"\nkinetic_coefficient = -0.1\nhalf_speed = \"1 m/s\"",
            "friction.kinetic_coefficient",
            &["case.toml:3:23", "between 0 and 100", "-0.1"],
        ),
        (
            "[friction]\nmodel = \"temperature-piecewise-linear\"\nhot_coefficient = -0.1\n\
             temperature_range = \"800 K\"",
            "friction.hot_coefficient",
            &["case.toml:3:19", "between 0 and 100", "-0.1"],
        ),
        (
            "[friction]\nmodel = \"polach\"\nlimit_ratio = -0.2\ndecay = \"0.6 s/m\"",
            "friction.limit_ratio",
            &["case.toml:3:15", "between 0 and 1", "-0.2"],
        ),
        (
            "[friction]\ncoefficient = 0.3\nminimum_coefficient = 0.35",
            "friction.minimum_coefficient",
            &["case.toml:3:23", "between 0 and friction.coefficient = 0.3", "0.35"],
        ),
        (
            "[friction]\nmodel = \"temperature-piecewise-linear\"\nhot_coefficient = 0.3\n\
             temperature_range = \"0 K\"",
            "friction.temperature_range",
            &["case.toml:4:21", "0 K"],
        ),
        (
            "[friction]\nspeed_model = \"rational\"\nkinetic_coefficient = 0.5\nhalf_speed = \"1 m/s\"",
            "friction.kinetic_coefficient",
            &["case.toml:3:23", "between 0 and friction.coefficient = 0.4", "0.5"],
        ),
        (
            "[friction]\nreference_temperature = \"-800 degC\"",
            "friction.reference_temperature",
            &["between -273.15 and 1e5 degC"],
        ),
        (
            "[friction]\nreference_temperature = \"-100 degC\"\ntemperature_at_zero_friction = \"90 K\"",
            "friction.reference_temperature",
            &[
                "case.toml:2:25",
                "enters the contact at 20 degC",
                "temperature of -100 degC, at -10 degC",
            ],
        ),
        (
            "[friction]\nmodel = \"temperature-piecewise-linear\"\nhot_coefficient = 0.0\n\
             temperature_range = \"50 K\"\n[wheel]\nbulk_temperature = \"200 degC\"",
            "friction.temperature_range",
            &["case.toml:4:21", "enters the contact at 110 degC", "vanishes 50 K above"],
        ),
        (
            "[friction]\nmodel = \"temperature-piecewise-linear\"\nhot_coefficient = 0.1\n\
             temperature_range = \"0 K\"",
            "friction.temperature_range",
            &["between 1e-3 and 1e6 K"],
        ),
    ]);
}

#[test]
fn impossible_friction_over_slip_speed_is_named() {
    assert_errors(&[
        (
            "[friction]\nmodel = \"rational\"\nkinetic_coefficient = 0.3\nhalf_speed = \"1 m/s\"\n\
             second_coefficient = 0.2\nsecond_half_speed = \"1 m/s\"",
            "friction.second_coefficient",
            &["case.toml:5:22", "0.4 - 0.3", "0.2"],
        ),
        (
            "[friction]\nmodel = \"rational\"\nkinetic_coefficient = 0.3\nhalf_speed = \"1 m/s\"\n\
             second_coefficient = 0.1",
            "friction.second_half_speed",
            &["case.toml:5:22", "is missing", "which friction.second_coefficient needs"],
        ),
        (
            "[friction]\nspeed_model = \"polach\"\nlimit_ratio = 0.4",
            "friction.decay",
            &[
                "case.toml:2:15",
                "friction.speed_model = \"polach\" needs",
                "such as decay = \"0.60 s/m\"",
            ],
        ),
        (
            "[friction]\nmodel = \"polach\"\nlimit_ratio = 0.4\ndecay = \"0.6 m/s\"",
            "friction.decay",
            &["an inverse speed", "`m/s` is the unit of a speed"],
        ),
    ]);
}

#[test]
fn impossible_friction_over_y_is_named() {
    assert_errors(&[
        (
            "[friction]\nvariation_y = [\"0 mm\", \"1 mm\"]",
            "friction.variation_factor",
            &["case.toml:2:15", "is missing, which friction.variation_y needs: factors"],
        ),
        (
            "[friction]\nvariation_factor = [1, 1]",
            "friction.variation_y",
            &["case.toml:2:20", "is missing, which friction.variation_factor needs"],
        ),
        (
            "[friction]\nvariation_y = [\"0 mm\", \"1 mm\"]\nvariation_factor = [1]",
            "friction.variation_factor",
            &["case.toml:3:20", "needs 2 values, got 1"],
        ),
        (
            "[friction]\nvariation_y = [\"1 mm\", \"0 mm\"]\nvariation_factor = [1, 1]",
            "friction.variation_y",
            &["case.toml:2:15", "must ascend strictly"],
        ),
        (
            "[friction]\nvariation_y = [\"0 mm\", \"1 mm\"]\nvariation_factor = [1, -0.5]",
            "friction.variation_factor",
            &["case.toml:3:24", "between 0 and 100", "-0.5"],
        ),
        (
            "[friction]\nvariation_y = [\"-1 mm\", \"1 mm\"]\nvariation_factor = [0.5, 1]",
            "friction.variation_factor",
            &["case.toml:3:20", "must be 1 at y = 0", "is 0.75 there"],
        ),
        (
            "[friction]\nvariation_file = \"f.csv\"\nvariation_factor = [0.5, 1]",
            "friction.variation_factor",
            &["together with friction.variation_file"],
        ),
        (
            "[friction]\nvariation_file = \"none.csv\"",
            "friction.variation_file",
            &["case.toml:2:18", "readable file"],
        ),
    ]);
}

#[test]
fn what_is_no_toml_is_refused_with_its_line() {
    assert_errors(&[
        ("[kinematics]\nspeed = 30 m/s", "", &["case.toml:2:", "not TOML"]),
        ("[kinematics\n", "", &["case.toml:1:", "not TOML"]),
        ("[grid]\ncells_x = 3\ncells_x = 4", "", &["case.toml:3:1", "duplicate key"]),
    ]);
}

#[test]
fn all_wrong_fields_are_reported_at_once() {
    let errors =
        read("[grid]\ncells_x = 0\ncells_z = 1\n[kinematics]\nspeed = 3", &[]).unwrap_err();
    let fields: Vec<&str> = errors.iter().map(|error| error.field.as_str()).collect();
    assert_eq!(fields, ["grid.cells_x", "grid.cells_z", "kinematics.speed"]);
}

#[test]
fn an_unknown_section_hides_no_other_error() {
    let errors = read("[grid]\ncells_x = 0\n[tyre]\nx = 1\n[heat]\npartition = 2", &["x"]);
    let errors = errors.unwrap_err();
    let fields: Vec<&str> = errors.iter().map(|error| error.field.as_str()).collect();
    assert_eq!(fields, ["grid.cells_x", "tyre", "heat.partition", ""]);
}

#[test]
fn overrides_are_checked_as_the_file_is() {
    let error = |text: &str, overrides: &[&str]| read(text, overrides).unwrap_err().to_string();
    let message = error("", &["normal.load=60 kNN"]);
    assert!(
        message.starts_with("--set normal.load=60 kNN: normal.load must be a force"),
        "{message}"
    );
    let message = error("", &["normal.load"]);
    assert!(message.contains("section.field=value"), "{message}");
    let message = error("", &["normal.lod=60 kN"]);
    assert!(message.contains("did you mean `normal.load`?"), "{message}");
    let file = "[kinematics]\nangular_velocity = \"60 rad/s\"";
    let message = error(file, &["kinematics.creepage_x=0.1"]);
    assert!(message.contains("--set kinematics.angular_velocity="), "{message}");
    let case = read(file, &["kinematics.creepage_x=0.1", "kinematics.angular_velocity="]).unwrap();
    assert_eq!(case.problem.kinematics.creepage_x, 0.1);
}

/// Only a file has an origin of its own.
#[test]
fn the_reference_point_needs_a_file() {
    assert_errors(&[
        (
            "[kinematics]\nreference = \"file\"",
            "kinematics.reference",
            &["case.toml:2:13", "must be \"patch\"", "normal.model = \"hertz\"", "is \"file\""],
        ),
        (
            "[kinematics]\nreference = \"file\"\n[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"5 mm\"\n\
             semi_axis_y = \"5 mm\"",
            "kinematics.reference",
            &["case.toml:2:13", "normal.model = \"ellipse\""],
        ),
        (
            "[kinematics]\nreference = \"wheel\"",
            "kinematics.reference",
            &["case.toml:2:13", "\"patch\"", "\"file\"", "but is \"wheel\""],
        ),
    ]);
}
