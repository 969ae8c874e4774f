//! `[damage]`.

use schlupf::reporting::Requirement::{self, Between, Finite};

use super::{MODULUS, quantity};
use crate::fields::field::Default::{Computed, Nothing, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::tables::layouts;
use crate::units::Measure;

const COEFFICIENT: Requirement = Between(1e-12, 1.0);
const RATE: Requirement = Between(1e-18, 1.0);
const WEAR_NUMBER: Requirement = Between(0.0, 1e9);
const CRACK: Requirement = Between(-1.0, 1.0);
const TEMPERATURE: Requirement = Between(-273.15, 1e5);

section! {
    Damage "damage"
        "What turns rolling into fatigue and wear, for `schlupf wear` and `schlupf damage`." for "wear" "damage";

    "shear_yield_stress" [ShearYieldStress] quantity(&Measure::PRESSURE), MODULUS, Text("300 MPa"),
        "k, yield stress in pure shear, for the fatigue index (Ekberg, Kabo and Andersson 2002)",
        usually(Between(1e6, 1e10));
    "hardness" [WearHardness] quantity(&Measure::PRESSURE), MODULUS, Text("2.7 GPa"),
        "H of the softer body, for Archard's law of wear; that of rail steel R260",
        usually(Between(1e7, 1e11));
    "wear_coefficient_mild" [WearCoefficientMild] Kind::Number, COEFFICIENT, Computed("5e-4"),
        "k of Archard's law for mild wear (Jendel 2002)", example("5e-4");
    "wear_coefficient_severe" [WearCoefficientSevere] Kind::Number, COEFFICIENT, Computed("35e-4"),
        "the same for slip speeds between 0.2 and 0.7 m/s", example("35e-4");
    "wear_coefficient_catastrophic" [WearCoefficientCatastrophic] Kind::Number, COEFFICIENT, Computed("350e-4"),
        "the same for pressures above 0.8 H", example("350e-4");
    "wear_map" [] Kind::Path, Finite, Nothing,
        "CSV with the columns slip_speed, pressure_ratio (p/H) and coefficient, in place of them",
        example("wear_map.csv"), of_columns(&[&layouts::WEAR_MAP]);
    "wear_rate_mild" [WearRateMild] quantity(&Measure::WEAR_RATE), RATE, Text("5.3 ug/J"),
        "mass worn per energy, up to 10.4 N/mm^2 (Braghin, Lewis, Dwyer-Joyce and Bruni 2006)";
    "wear_rate_catastrophic" [WearRateCatastrophic] quantity(&Measure::WEAR_RATE), RATE, Text("61.9 ug/J"),
        "the same beyond 77.2 N/mm^2";
    "crack_t_gamma" [CrackWearNumber] Kind::Quantities(&Measure::FORCE), WEAR_NUMBER, Nothing,
        "Tγ, ascending, at which crack_damage is given; default: Burstow (2004)",
        example("[\"0 N\", \"15 N\", \"65 N\", \"175 N\"]");
    "crack_damage" [CrackDamage] Kind::Numbers, CRACK, Nothing,
        "reciprocal of the number of passages until there is a crack; linear in between and beyond",
        example("[0.0, 0.0, 1e-5, 0.0]");
    "melting_temperature" [MeltingTemperature] quantity(&Measure::TEMPERATURE), TEMPERATURE, Text("1390 degC"),
        "from which on a surface melts; solidus of iron with 0.75 % of carbon",
        usually(Between(0.0, 4e3));
}
