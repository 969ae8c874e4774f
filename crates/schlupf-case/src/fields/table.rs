//! The table.

mod contact_law;
mod elasticity;
mod friction;
mod solver;

use super::choice::{Choose, HeatChoice, NormalModel, PartitionChoice, Reference};
use super::field::Default::{self, Nothing, Same, Text};
use super::field::{Field, Kind, Section};
use crate::units::Measure;
use schlupf::requirement::Requirement::{self, Between, Finite, Inside, Magnitude, Radius};
use std::f64::consts::FRAC_PI_2;

/// The same; normal contact or elasticity may depend on it.
const fn shaping(
    path: &'static str,
    kind: Kind,
    requirement: Requirement,
    default: Default,
    doc: &'static str,
) -> Field {
    Field { shapes_contact: true, ..Field::new(path, kind, requirement, default, doc) }
}

impl Field {
    const fn example(self, text: &'static str) -> Self {
        Self { example: Some(text), ..self }
    }

    /// The same with a choice that it belongs to, besides the one it may have.
    const fn with(self, choice: &'static str, names: &'static [&'static str]) -> Self {
        Self { used_with: [Some((choice, names)), self.used_with[0]], ..self }
    }
}

const fn quantity(measure: &'static Measure) -> Kind {
    Kind::Quantity(measure)
}

/// Bounds that no rolling contact comes near, and within which no product or quotient leaves the range
/// of double precision. Each in the SI unit of its fields, temperatures in degC.
const MODULUS: Requirement = Between(1e3, 1e14);
const THERMAL: Requirement = Between(1e-6, 1e9);
const TEMPERATURE: Requirement = Between(-273.15, 1e5);
const CURVATURE: Requirement = Radius(1e-6, 1e12);
const ROLLING_RADIUS: Requirement = Between(1e-6, 1e6);
const SPEED: Requirement = Between(1e-6, 1e4);
const CREEPAGE: Requirement = Magnitude(1e6);
const TURNING: Requirement = Magnitude(1e6);
const LOAD: Requirement = Between(1e-3, 1e12);
const PEAK_PRESSURE: Requirement = Between(1.0, 1e14);
const SEMI_AXIS: Requirement = Between(1e-7, 1e2);
const SPACING: Requirement = Between(1e-9, 1e2);
const COOLED_AREA: Requirement = Between(1e-9, 1e6);
const INSTANT: Requirement = Magnitude(1e9);
/// Bodies that are shifted by more than the size of a wheel do not touch where they did.
const SHIFT: Requirement = Magnitude(1.0);

macro_rules! body {
    ($body:literal, $radius_x:literal, $radius_y:literal) => {
        [
            shaping(
                concat!($body, ".young_modulus"),
                quantity(&Measure::PRESSURE),
                MODULUS,
                Text("210 GPa"),
                "E, Young's modulus",
            ),
            shaping(
                concat!($body, ".poisson_ratio"),
                Kind::Number,
                Between(0.0, 0.5),
                Text("0.28"),
                "ν, Poisson's ratio",
            ),
            Field::new(
                concat!($body, ".conductivity"),
                quantity(&Measure::CONDUCTIVITY),
                THERMAL,
                Text("50 W/(m K)"),
                "λ, thermal conductivity",
            ),
            Field::new(
                concat!($body, ".density"),
                quantity(&Measure::DENSITY),
                THERMAL,
                Text("7850 kg/m^3"),
                "ρ, density",
            ),
            Field::new(
                concat!($body, ".specific_heat"),
                quantity(&Measure::SPECIFIC_HEAT),
                THERMAL,
                Text("450 J/(kg K)"),
                "c, specific heat",
            ),
            Field::new(
                concat!($body, ".bulk_temperature"),
                quantity(&Measure::TEMPERATURE),
                TEMPERATURE,
                Text("20 degC"),
                "temperature far from the contact",
            ),
            shaping(
                concat!($body, ".radius_x"),
                quantity(&Measure::LENGTH),
                CURVATURE,
                Text($radius_x),
                "radius of curvature along rolling: \"inf\" where straight, negative where concave",
            ),
            shaping(
                concat!($body, ".radius_y"),
                quantity(&Measure::LENGTH),
                CURVATURE,
                Text($radius_y),
                "radius of curvature across rolling",
            ),
        ]
    };
}

/// All sections, in the order of the case file.
pub const SECTIONS: &[Section] = &[
    Section {
        name: "",
        doc: "",
        fields: &[Field::new(
            "title",
            Kind::Text,
            Finite,
            Text("wheel on rail"),
            "stands over the summary and the figures",
        )
        .example("steel wheel, 80 kN, braking")],
    },
    Section {
        name: "kinematics",
        doc: "How the wheel moves over the rail. Braking has a positive creepage and a negative force.",
        fields: KINEMATICS,
    },
    Section {
        name: "wheel",
        doc: "The wheel: elastic and thermal constants, temperature, curvature radii.",
        fields: &body!("wheel", "0.46 m", "inf"),
    },
    Section {
        name: "rail",
        doc: "The rail: the same fields as the wheel.",
        fields: &body!("rail", "inf", "300 mm"),
    },
    Section { name: "normal", doc: "Where the normal pressure comes from.", fields: NORMAL },
    Section {
        name: "elasticity",
        doc: "How the bodies deform under tangential traction.",
        fields: elasticity::FIELDS,
    },
    Section {
        name: "contact_law",
        doc: "How traction grows with the sliding of rough surfaces.",
        fields: contact_law::FIELDS,
    },
    Section {
        name: "contact_law.roughness",
        doc: "Roughness from which k_c follows, in place of stiffness: heights, a spectrum or files.",
        fields: contact_law::ROUGHNESS,
    },
    Section {
        name: "friction",
        doc: "Coefficient of friction. T is counted from the reference temperature, s is the slip speed.",
        fields: friction::FIELDS,
    },
    Section { name: "heat", doc: "Frictional heating of both surfaces.", fields: HEAT },
    Section {
        name: "cooling",
        doc: "What cools the wheel in the long run, for `schlupf bulk`.",
        fields: COOLING,
    },
    Section { name: "grid", doc: "Cells across the contact patch.", fields: solver::GRID },
    Section { name: "solver", doc: "What is solved, and how.", fields: solver::FIELDS },
    Section {
        name: "fastsim",
        doc: "The bristles of FASTSIM, plain and modified.",
        fields: solver::FASTSIM,
    },
    Section {
        name: "history",
        doc: "Transient rolling: values over time, linear in between, from arrays or from a CSV file; \
              before it, or alone, a shift at rest.",
        fields: HISTORY,
    },
];

const KINEMATICS: &[Field] = &[
    Field::new(
        "kinematics.speed",
        quantity(&Measure::SPEED),
        SPEED,
        Text("108 km/h"),
        "v0, speed of the vehicle",
    ),
    Field::new(
        "kinematics.creepage_x",
        Kind::Number,
        CREEPAGE,
        Text("0.0"),
        "ξ, longitudinal creepage: positive when braking",
    )
    .example("0.008"),
    Field::new(
        "kinematics.angular_velocity",
        quantity(&Measure::ANGULAR_VELOCITY),
        TURNING,
        Nothing,
        "ω of the wheel, in place of creepage_x",
    )
    .example("64.7 rad/s"),
    Field::new(
        "kinematics.wheel_radius",
        quantity(&Measure::LENGTH),
        ROLLING_RADIUS,
        Same("wheel.radius_x"),
        "R, rolling radius that goes with angular_velocity",
    )
    .example("0.46 m"),
    Field::new(
        "kinematics.creepage_y",
        Kind::Number,
        Inside(-1.0, 1.0),
        Text("0.0"),
        "η, lateral creepage",
    ),
    Field::new(
        "kinematics.yaw_angle",
        quantity(&Measure::ANGLE),
        Inside(-FRAC_PI_2, FRAC_PI_2),
        Nothing,
        "α, slip angle, in place of creepage_y",
    )
    .example("0.5 deg"),
    Field::new(
        "kinematics.spin",
        quantity(&Measure::PER_LENGTH),
        TURNING,
        Text("0 1/m"),
        "φ, spin creepage",
    ),
    Field::new(
        "kinematics.reference",
        Kind::Choice(Reference::CHOICES),
        Finite,
        Text("patch"),
        "where creepages hold (those of a history, too) and about which point the moment is taken",
    ),
];

const NORMAL: &[Field] = &[
    shaping(
        "normal.model",
        Kind::Choice(NormalModel::CHOICES),
        Finite,
        Text("hertz"),
        "source of the pressure",
    ),
    shaping("normal.load", quantity(&Measure::FORCE), LOAD, Text("80 kN"), "N, normal load"),
    shaping(
        "normal.semi_axis_x",
        quantity(&Measure::LENGTH),
        SEMI_AXIS,
        Nothing,
        "a, semi-axis along rolling",
    )
    .example("6 mm")
    .with("normal.model", &["ellipse"]),
    shaping(
        "normal.semi_axis_y",
        quantity(&Measure::LENGTH),
        SEMI_AXIS,
        Nothing,
        "b, semi-axis across rolling",
    )
    .example("5 mm")
    .with("normal.model", &["ellipse"]),
    shaping(
        "normal.peak_pressure",
        quantity(&Measure::PRESSURE),
        PEAK_PRESSURE,
        Nothing,
        "p0, largest pressure, in place of load",
    )
    .example("1 GPa")
    .with("normal.model", &["ellipse"]),
    shaping(
        "normal.file",
        Kind::Path,
        Finite,
        Nothing,
        "CSV with the header `x [mm],y [mm],pressure [MPa]`, or with \"profile\" `x [mm],y [mm],distance [um]` or \
         `y [mm],distance [mm]` (across at x = 0); or .npy in Pa or m, each row along x",
    )
    .example("pressure.csv")
    .with("normal.model", FILES),
    shaping(
        "normal.spacing_x",
        quantity(&Measure::LENGTH),
        SPACING,
        Nothing,
        "distance of the columns of an .npy file",
    )
    .example("0.5 mm")
    .with("normal.model", FILES),
    shaping(
        "normal.spacing_y",
        quantity(&Measure::LENGTH),
        SPACING,
        Nothing,
        "distance of the rows of an .npy file",
    )
    .example("0.5 mm")
    .with("normal.model", FILES),
    shaping(
        "normal.cells",
        Kind::Count,
        Between(16.0, 512.0),
        Text("128"),
        "cells across the contact each way, on which the pressure of a profile is found",
    )
    .with("normal.model", &["profile"]),
];

/// Models that read a file.
const FILES: &[&str] = &["tabulated", "profile"];

const HEAT: &[Field] = &[
    Field::new(
        "heat.model",
        Kind::Choice(HeatChoice::CHOICES),
        Finite,
        Text("duhamel"),
        "model of the surface temperature",
    )
    .with(solver::METHOD, solver::CELLS),
    Field::new(
        "heat.partition",
        Kind::NumberOr(PartitionChoice::CHOICES),
        Between(0.0, 1.0),
        Text("velocity"),
        "share of the wheel, or \"velocity\"",
    )
    .with("heat.model", &["duhamel", "constant-source"]),
];

const COOLING: &[Field] = &[
    Field::new(
        "cooling.film_coefficient",
        quantity(&Measure::HEAT_TRANSFER),
        THERMAL,
        Nothing,
        "h, heat transfer coefficient between the wheel and the air",
    )
    .example("40 W/(m^2 K)"),
    Field::new(
        "cooling.area",
        quantity(&Measure::AREA),
        COOLED_AREA,
        Nothing,
        "A, surface of the wheel that the air cools",
    )
    .example("1.5 m^2"),
    Field::new(
        "cooling.air_temperature",
        quantity(&Measure::TEMPERATURE),
        TEMPERATURE,
        Same("rail.bulk_temperature"),
        "temperature of the air",
    )
    .example("20 degC"),
];

const HISTORY: &[Field] = &[
    shaping(
        "history.time",
        Kind::Quantities(&Measure::TIME),
        INSTANT,
        Nothing,
        "instants, increasing",
    )
    .example("[\"0 s\", \"1 ms\"]"),
    Field::new(
        "history.creepage_x",
        Kind::Numbers,
        CREEPAGE,
        Nothing,
        "ξ at these instants; likewise the others",
    )
    .example("[0.0, 0.002]"),
    Field::new("history.creepage_y", Kind::Numbers, Inside(-1.0, 1.0), Nothing, "η")
        .example("[0.0, 0.0]"),
    Field::new("history.spin", Kind::Quantities(&Measure::PER_LENGTH), TURNING, Nothing, "φ")
        .example("[\"0 1/m\", \"0 1/m\"]"),
    Field::new("history.speed", Kind::Quantities(&Measure::SPEED), SPEED, Nothing, "v0")
        .example("[\"30 m/s\", \"30 m/s\"]"),
    shaping("history.load", Kind::Quantities(&Measure::FORCE), LOAD, Nothing, "N")
        .example("[\"80 kN\", \"60 kN\"]"),
    Field::new(
        "history.shift_x",
        quantity(&Measure::LENGTH),
        SHIFT,
        Nothing,
        "shift of the wheel over the rail along rolling, at rest, before it rolls; times may be left out then",
    )
    .example("0.015 mm"),
    Field::new(
        "history.shift_y",
        quantity(&Measure::LENGTH),
        SHIFT,
        Nothing,
        "the same across rolling",
    )
    .example("0 mm"),
    shaping(
        "history.file",
        Kind::Path,
        Finite,
        Nothing,
        "CSV with a header such as `time [s],creepage_x,load [kN]`, in place of the arrays",
    )
    .example("history.csv"),
];
