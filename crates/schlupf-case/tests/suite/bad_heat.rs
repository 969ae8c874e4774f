//! Friction, temperatures, partition and cooling that are impossible: each error names the field,
//! what it must be, what it is and where it stands.

use crate::support::{assert_errors, read};

fn texts(notices: &[schlupf::reporting::Message]) -> Vec<String> {
    notices.iter().map(|notice| notice.text.clone()).collect()
}

/// No law becomes negative without a floor: each constant that could make it so is refused at its
/// line. A floor of zero is the paper's, and legal.
#[test]
fn laws_that_could_become_negative_are_refused() {
    for (law, field, value, bounds) in [
        ("temperature-linear", "minimum_coefficient", "-0.05", "between 0 and 100"),
        (
            "temperature-linear",
            "temperature_at_zero_friction",
            "\"-700 K\"",
            "between 1e-3 and 1e6 K",
        ),
        ("temperature-piecewise-linear", "hot_coefficient", "-0.05", "between 0 and 100"),
        (
            "temperature-piecewise-linear",
            "temperature_range",
            "\"-30 K\"",
            "between 1e-3 and 1e6 K",
        ),
        ("exponential", "kinetic_coefficient", "-0.05", "between 0 and 100"),
        ("exponential", "second_coefficient", "-0.05", "between 0 and 100"),
        ("rational", "kinetic_coefficient", "-0.05", "between 0 and 100"),
        ("linear-in-speed", "kinetic_coefficient", "-0.05", "between 0 and 100"),
        ("linear-in-speed", "half_speed", "\"-1 m/s\"", "between 1e-9 and 1e6 m/s"),
        ("polach", "limit_ratio", "-0.05", "between 0 and 1"),
        ("polach", "decay", "\"-0.6 s/m\"", "between 1e-9 and 1e9 s/m"),
    ] {
        let text = format!("[friction]\nmodel = \"{law}\"\n{field} = {value}");
        let errors = read(&text, &[]).unwrap_err();
        let message = errors.first.to_string();
        assert_eq!(errors.first.field, format!("friction.{field}"), "{message}");
        for part in ["case.toml:3:", bounds, value.trim_matches('"')] {
            assert!(message.contains(part), "{text:?}: {part:?} is not in {message:?}");
        }
    }
    let case = read("[friction]\nminimum_coefficient = 0.0", &[]).unwrap();
    assert_eq!(texts(&case.notices), [""; 0]);
}

/// Temperatures below absolute zero, and material that enters hotter than friction lasts.
#[test]
fn contradictory_temperatures_are_named() {
    assert_errors(&[
        (
            "[wheel]\nbulk_temperature = \"-300 degC\"",
            "wheel.bulk_temperature",
            &["case.toml:2:20", "between -273.15 and 1e5 degC", "\"-300 degC\""],
        ),
        (
            "[friction]\nreference_temperature = \"-5 K\"",
            "friction.reference_temperature",
            &["case.toml:2:25", "between -273.15 and 1e5 degC", "\"-5 K\""],
        ),
        (
            "[cooling]\nfilm_coefficient = \"40 W/(m^2 K)\"\narea = \"1 m^2\"\nair_temperature = \"-300 degC\"",
            "cooling.air_temperature",
            &["case.toml:4:19", "between -273.15 and 1e5 degC", "\"-300 degC\""],
        ),
        (
            "[friction]\ntemperature_at_zero_friction = \"100 K\"\n[rail]\nbulk_temperature = \"20 degC\"\n\
             [wheel]\nbulk_temperature = \"260 degC\"",
            "friction.temperature_at_zero_friction",
            &[
                "case.toml:2:32",
                "enters the contact at 140 degC",
                "temperature of 20 degC, at 120 degC",
            ],
        ),
        (
            "[friction]\nmodel = \"temperature-piecewise-linear\"\nhot_coefficient = 0.1\n\
             temperature_range = \"-30 K\"",
            "friction.temperature_range",
            &["case.toml:4:21", "between 1e-3 and 1e6 K", "\"-30 K\""],
        ),
    ]);
}

/// The share of the wheel is one number between 0 and 1, or one word.
#[test]
fn impossible_partitions_are_named() {
    assert_errors(&[
        (
            "[heat]\npartition = -0.1",
            "heat.partition",
            &["case.toml:2:13", "between 0 and 1", "-0.1"],
        ),
        ("[heat]\npartition = 1.01", "heat.partition", &["case.toml:2:13", "between 0 and 1"]),
        ("[heat]\npartition = nan", "heat.partition", &["case.toml:2:13", "between 0 and 1"]),
        (
            "[heat]\npartition = \"0.5\"",
            "heat.partition",
            &["case.toml:2:13", "write the number alone, without quotes"],
        ),
        (
            "[heat]\npartition = [0.5, \"velocity\"]",
            "heat.partition",
            &["case.toml:2:13", "a number without unit, or \"velocity\""],
        ),
        (
            "[heat]\npartition = 0.5\npartition = \"velocity\"",
            "",
            &["case.toml:3:1", "duplicate key"],
        ),
    ]);
    let case = read("[heat]\nmodel = \"none\"\npartition = 0.5", &[]).unwrap();
    let expected = "case.toml:3:13: heat.partition has no effect with heat.model = \"none\"";
    assert_eq!(texts(&case.notices), [expected]);
}

#[test]
fn impossible_cooling_is_named() {
    const FILM: &str = "[cooling]\nfilm_coefficient = \"40 W/(m^2 K)\"";
    assert_errors(&[
        (
            FILM,
            "cooling.area",
            &["case.toml:2:20", "is missing, which cooling.film_coefficient needs"],
        ),
        (
            "[cooling]\nfilm_coefficient = \"0 W/(m^2 K)\"",
            "cooling.film_coefficient",
            &["case.toml:2:20", "between 1e-6 and 1e9 W/(m^2 K)"],
        ),
        (
            "[cooling]\nfilm_coefficient = \"40 W/(m K)\"",
            "cooling.film_coefficient",
            &["a heat transfer coefficient", "`W/(m K)` is the unit of a thermal conductivity"],
        ),
        (
            "[cooling]\nfilm_coefficient = \"40 W/(m^2 K)\"\narea = \"-1 m^2\"",
            "cooling.area",
            &["case.toml:3:8", "between 1e-9 and 1e6 m^2", "\"-1 m^2\""],
        ),
        (
            "[cooling]\nflow = 1",
            "cooling.flow",
            &["the fields of [cooling] are film_coefficient, area"],
        ),
    ]);
    let idle = read("[cooling]\narea = \"1 m^2\"", &[]).unwrap();
    assert_eq!(
        texts(&idle.notices),
        ["case.toml:2:8: cooling.area has no effect without cooling.film_coefficient"]
    );
    let message = idle.require_cooling().unwrap_err().to_string();
    assert!(
        message.contains("cooling.film_coefficient is missing, which the bulk temperature"),
        "{message}"
    );
    assert!(
        message.contains("such as film_coefficient = \"40 W/(m^2 K)\" in [cooling]"),
        "{message}"
    );
}
