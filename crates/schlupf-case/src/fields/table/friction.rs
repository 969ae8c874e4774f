//! `[friction]`.

use super::{TEMPERATURE, quantity};
use crate::fields::choice::{Choose, FrictionModel, SpeedModel};
use crate::fields::field::Default::{Nothing, Same, Text};
use crate::fields::field::{Field, Kind};
use crate::units::Measure;
use schlupf::requirement::Requirement::{self, Between, Finite, Magnitude};

const COEFFICIENT: Requirement = Between(1e-9, 1e2);
const PART: Requirement = Between(0.0, 1e2);
const DIFFERENCE: Requirement = Between(1e-3, 1e6);
const SLIP_SPEED: Requirement = Between(1e-9, 1e6);
const DECAY: Requirement = Between(1e-9, 1e9);
const MEMORY_DISTANCE: Requirement = Between(1e-9, 1e2);
const MEMORY_SPEED: Requirement = Between(0.0, 1e6);
const POSITION: Requirement = Magnitude(1e2);

const MODEL: &str = "friction.model";
const SPEED_MODEL: &str = "friction.speed_model";

const LINEAR: &[&str] = &["temperature-linear"];
const PIECEWISE: &[&str] = &["temperature-piecewise-linear"];
const OF_TEMPERATURE: &[&str] = &["temperature-linear", "temperature-piecewise-linear"];
const COMBINED: &[&str] = &["temperature-linear", "constant", "temperature-piecewise-linear"];
const TERMS: &[&str] = &["exponential", "rational", "linear-in-speed"];
const POLACH: &[&str] = &["polach"];

/// A field of the laws with two terms, by themselves or combined with another law.
const fn term(field: Field) -> Field {
    field.with(SPEED_MODEL, TERMS).with(MODEL, TERMS)
}

pub(super) const FIELDS: &[Field] = &[
    Field::new(
        MODEL,
        Kind::Choice(FrictionModel::CHOICES),
        Finite,
        Text("temperature-linear"),
        "law of friction",
    ),
    Field::new(
        "friction.coefficient",
        Kind::Number,
        COEFFICIENT,
        Text("0.4"),
        "μ0, without slip, at the reference temperature, at y = 0",
    ),
    Field::new(
        "friction.temperature_at_zero_friction",
        quantity(&Measure::TEMPERATURE_DIFFERENCE),
        DIFFERENCE,
        Text("700 K"),
        "T_E, a difference",
    )
    .with(MODEL, LINEAR),
    Field::new(
        "friction.reference_temperature",
        quantity(&Measure::TEMPERATURE),
        TEMPERATURE,
        Same("rail.bulk_temperature"),
        "T is counted from it",
    )
    .example("20 degC")
    .with(MODEL, OF_TEMPERATURE),
    Field::new(
        "friction.minimum_coefficient",
        Kind::Number,
        PART,
        Text("0.0"),
        "floor of μ, before speed_model and the variation over y act",
    )
    .with(MODEL, LINEAR),
    Field::new(
        "friction.hot_coefficient",
        Kind::Number,
        PART,
        Nothing,
        "μ_hot; above μ0 where friction rises",
    )
    .example("0.2")
    .with(MODEL, PIECEWISE),
    Field::new(
        "friction.temperature_range",
        quantity(&Measure::TEMPERATURE_DIFFERENCE),
        DIFFERENCE,
        Nothing,
        "ΔT over which μ falls from μ0 to μ_hot, a difference",
    )
    .example("800 K")
    .with(MODEL, PIECEWISE),
    Field::new(
        SPEED_MODEL,
        Kind::Choice(SpeedModel::CHOICES),
        Finite,
        Text("none"),
        "law of the slip speed: μ is that of model times the fall μ/μ0 of this one",
    )
    .with(MODEL, COMBINED),
    term(
        Field::new(
            "friction.kinetic_coefficient",
            Kind::Number,
            PART,
            Nothing,
            "μ_kin, limit at large slip speeds, at most μ0",
        )
        .example("0.2"),
    ),
    term(
        Field::new(
            "friction.half_speed",
            quantity(&Measure::SPEED),
            SLIP_SPEED,
            Nothing,
            "s1, slip speed at which the term with μ1 has halved",
        )
        .example("1 m/s"),
    ),
    term(
        Field::new(
            "friction.second_coefficient",
            Kind::Number,
            PART,
            Nothing,
            "μ2, size of a second term, which needs second_half_speed",
        )
        .example("0.05"),
    ),
    term(
        Field::new(
            "friction.second_half_speed",
            quantity(&Measure::SPEED),
            SLIP_SPEED,
            Nothing,
            "s2, slip speed at which the second term has halved",
        )
        .example("0.1 m/s"),
    ),
    Field::new("friction.limit_ratio", Kind::Number, Between(0.0, 1.0), Nothing, "A, μ(∞)/μ0")
        .example("0.40")
        .with(SPEED_MODEL, POLACH)
        .with(MODEL, POLACH),
    Field::new(
        "friction.decay",
        quantity(&Measure::PER_SPEED),
        DECAY,
        Nothing,
        "B, rate of the fall with the slip speed",
    )
    .example("0.60 s/m")
    .with(SPEED_MODEL, POLACH)
    .with(MODEL, POLACH),
    Field::new(
        "friction.memory_distance",
        quantity(&Measure::LENGTH),
        MEMORY_DISTANCE,
        Nothing,
        "d_c, sliding distance over which friction follows its law; at once if left out",
    )
    .example("20 um"),
    Field::new(
        "friction.memory_speed",
        quantity(&Measure::SPEED),
        MEMORY_SPEED,
        Nothing,
        "s0, slip speed below which friction follows as fast as at it; 0 if left out",
    )
    .example("1 mm/s"),
    Field::new(
        "friction.variation_y",
        Kind::Quantities(&Measure::LENGTH),
        POSITION,
        Nothing,
        "positions across the patch, ascending, at which variation_factor is given",
    )
    .example("[\"-5 mm\", \"0 mm\", \"5 mm\"]"),
    Field::new(
        "friction.variation_factor",
        Kind::Numbers,
        PART,
        Nothing,
        "factors on μ, 1 at y = 0; linear in between, constant outside",
    )
    .example("[0.5, 1.0, 1.0]"),
    Field::new(
        "friction.variation_file",
        Kind::Path,
        Finite,
        Nothing,
        "CSV with the header `y [mm],factor`, in place of the arrays",
    )
    .example("friction.csv"),
];
