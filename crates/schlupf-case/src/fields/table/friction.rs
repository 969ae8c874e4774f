//! `[friction]`.

use super::{TEMPERATURE, quantity};
use crate::fields::choice::{Choose, FrictionModel, SpeedModel};
use crate::fields::field::Default::{Nothing, Same, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::fields::path::FieldPath;
use crate::tables::layouts;
use crate::units::Measure;
use schlupf::reporting::Requirement::{self, Between, Finite, Magnitude};

const COEFFICIENT: Requirement = Between(1e-9, 1e2);
const PART: Requirement = Between(0.0, 1e2);
const DIFFERENCE: Requirement = Between(1e-3, 1e6);
const SLIP_SPEED: Requirement = Between(1e-9, 1e6);
const DECAY: Requirement = Between(1e-9, 1e9);
const MEMORY_DISTANCE: Requirement = Between(1e-9, 1e2);
const MEMORY_SPEED: Requirement = Between(0.0, 1e6);
const POSITION: Requirement = Magnitude(1e2);
const INCLINATION: Requirement = Magnitude(std::f64::consts::FRAC_PI_2);

/// What coefficients are in almost all cases: clean metal in air stays below.
const USUAL: Requirement = Between(1e-3, 1.5);
const USUAL_PART: Requirement = Between(0.0, 1.5);

const MODEL: FieldPath = field!("friction.model");
const SPEED_MODEL: FieldPath = field!("friction.speed_model");

const NORMAL_MODEL: FieldPath = field!("normal.model");

const WHEEL_RAIL: &[&str] = &["wheel-rail"];
const LINEAR: &[&str] = &["temperature-linear"];
const PIECEWISE: &[&str] = &["temperature-piecewise-linear"];
const OF_TEMPERATURE: &[&str] = &["temperature-linear", "temperature-piecewise-linear"];
const COMBINED: &[&str] = &["temperature-linear", "constant", "temperature-piecewise-linear"];
const TERMS: &[&str] = &["exponential", "rational", "linear-in-speed"];
const POLACH: &[&str] = &["polach"];

impl Field {
    /// The same, of the laws with two terms, by themselves or combined with another law.
    const fn of_terms(self) -> Self {
        self.with(SPEED_MODEL, TERMS).with(MODEL, TERMS)
    }
}

section! {
    Friction "friction"
        "Coefficient of friction. T is counted from the reference temperature, s is the slip \
         speed.";

    "model" [FrictionModel] Kind::Choice(FrictionModel::CHOICES), Finite,
        Text("temperature-linear"),
        "law of friction";
    "coefficient" [FrictionCoefficient] Kind::Number, COEFFICIENT, Text("0.4"),
        "μ0, without slip, at the reference temperature, at y = 0",
        usually(USUAL);
    "temperature_at_zero_friction" [TemperatureAtZeroFriction] quantity(&Measure::TEMPERATURE_DIFFERENCE),
        DIFFERENCE, Text("700 K"),
        "T_E, a difference", with(MODEL, LINEAR),
        usually(Between(20.0, 1e4));
    "reference_temperature" [ReferenceTemperature] quantity(&Measure::TEMPERATURE), TEMPERATURE,
        Same(field!("rail.bulk_temperature")),
        "T is counted from it", example("20 degC"), with(MODEL, OF_TEMPERATURE),
        usually(Between(-80.0, 800.0));
    "minimum_coefficient" [MinimumCoefficient] Kind::Number, PART, Text("0.0"),
        "floor of μ, before speed_model and the variation over y apply", with(MODEL, LINEAR),
        usually(USUAL_PART);
    "hot_coefficient" [HotCoefficient] Kind::Number, PART, Nothing,
        "μ_hot; above μ0 where friction rises", example("0.2"), with(MODEL, PIECEWISE),
        usually(USUAL_PART);
    "temperature_range" [TemperatureRange] quantity(&Measure::TEMPERATURE_DIFFERENCE), DIFFERENCE,
        Nothing,
        "ΔT over which μ falls from μ0 to μ_hot, a difference", example("800 K"),
        with(MODEL, PIECEWISE),
        usually(Between(20.0, 1e4));
    "speed_model" [] Kind::Choice(SpeedModel::CHOICES), Finite, Text("none"),
        "law of the slip speed: μ is that of model times the fall μ/μ0 of this one",
        with(MODEL, COMBINED);
    "kinetic_coefficient" [KineticCoefficient] Kind::Number, PART, Nothing,
        "μ_kin, limit at large slip speeds, at most μ0", example("0.2"), of_terms(),
        usually(USUAL_PART);
    "half_speed" [HalfSpeed] quantity(&Measure::SPEED), SLIP_SPEED, Nothing,
        "s1, slip speed at which the term with μ1 has halved", example("1 m/s"), of_terms();
    "second_coefficient" [SecondCoefficient] Kind::Number, PART, Nothing,
        "μ2, size of a second term, which needs second_half_speed", example("0.05"), of_terms(),
        usually(USUAL_PART);
    "second_half_speed" [SecondHalfSpeed] quantity(&Measure::SPEED), SLIP_SPEED, Nothing,
        "s2, slip speed at which the second term has halved", example("0.1 m/s"), of_terms();
    "limit_ratio" [LimitRatio] Kind::Number, Between(0.0, 1.0), Nothing,
        "A, μ(∞)/μ0", example("0.40"), with(SPEED_MODEL, POLACH), with(MODEL, POLACH);
    "decay" [Decay] quantity(&Measure::PER_SPEED), DECAY, Nothing,
        "B, rate of the fall with the slip speed", example("0.60 s/m"), with(SPEED_MODEL, POLACH),
        with(MODEL, POLACH);
    "memory_distance" [MemoryDistance] quantity(&Measure::LENGTH), MEMORY_DISTANCE, Nothing,
        "d_c, sliding distance over which friction approaches its law; default: instantly",
        example("20 um");
    "memory_speed" [MemorySpeed] quantity(&Measure::SPEED), MEMORY_SPEED, Nothing,
        "s0, smallest slip speed that counts for the memory; default: 0",
        example("1 mm/s");
    "variation_y" [VariationY] Kind::Quantities(&Measure::LENGTH), POSITION, Nothing,
        "positions across the patch, ascending, at which variation_factor is given",
        example("[\"-5 mm\", \"0 mm\", \"5 mm\"]");
    "variation_inclination" [VariationInclination] Kind::Quantities(&Measure::ANGLE), INCLINATION,
        Nothing,
        "inclinations of the surface of the rail's profile, ascending, in place of positions: negative \
         on the gauge face, positive where the surface falls outwards",
        example("[\"-60 deg\", \"-20 deg\", \"0 deg\"]"),
        with(NORMAL_MODEL, WHEEL_RAIL);
    "variation_factor" [VariationFactor] Kind::Numbers, PART, Nothing,
        "factors on μ, 1 at y = 0 or inclination 0; linear in between, constant outside",
        example("[0.5, 1.0, 1.0]");
    "variation_file" [] Kind::Path, Finite, Nothing,
        "CSV with the header `y [mm],factor`, in place of the arrays", example("friction.csv"),
        of_columns(&[&layouts::VARIATION]);
}
