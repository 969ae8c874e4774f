//! `[elasticity]`.

use super::solver::{FULL, METHOD};
use super::{choice, field, quantity};
use crate::fields::field::Default::{Computed, Nothing, Same, Text};
use crate::fields::field::{Field, Kind};
use crate::units::Measure;
use schlupf::requirement::Requirement::{self, Between, Finite};

const BEDDING: Requirement = Between(1.0, 1e20);
const COUPLING: Requirement = Between(0.0, 1e18);
const SPRING: Requirement = Between(1e-9, 1e18);
const MARGIN: Requirement = Between(0.0, 1e3);

const MODEL: &str = "elasticity.model";
const LAYER: &[&str] = &["elastic-layer"];

pub(super) const FIELDS: &[Field] = &[
    field(
        "elasticity.model",
        Kind::Choice(&[
            choice("elastic-layer", "a bed of springs, each coupled with its neighbours"),
            choice(
                "half-space",
                "Boussinesq and Cerruti: exact for bodies large against the patch",
            ),
            choice("winkler", "a bed of springs without coupling"),
            choice("rigid", "no deformation: the slip is prescribed"),
        ]),
        Finite,
        Text("elastic-layer"),
        "model of the deformation",
    )
    .with(METHOD, FULL),
    field(
        "elasticity.calibration",
        Kind::Choice(&[choice(
            "half-space",
            "stiffnesses with which the springs answer like the half-space on the same patch in steady rolling; without \
             coupling those of Kalker 1982",
        )]),
        Finite,
        Computed("\"half-space\", where no stiffness is given"),
        "where the stiffnesses come from",
    )
    .example("half-space")
    .with(MODEL, &["elastic-layer", "winkler"]),
    field(
        "elasticity.bedding_x",
        quantity(&Measure::BEDDING),
        BEDDING,
        Nothing,
        "c, bedding stiffness for displacements along x",
    )
    .example("1.0e13 N/m^3")
    .with(MODEL, &["elastic-layer", "winkler"]),
    field(
        "elasticity.bedding_y",
        quantity(&Measure::BEDDING),
        BEDDING,
        Same("elasticity.bedding_x"),
        "the same for displacements along y",
    )
    .example("1.0e13 N/m^3")
    .with(MODEL, &["elastic-layer", "winkler"]),
    field(
        "elasticity.coupling_x",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Nothing,
        "g, coupling stiffness for displacements along x",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.coupling_x_across",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.coupling_x"),
        "the same between neighbours across rolling, if it is another one",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.coupling_y",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.coupling_x"),
        "g, coupling stiffness for displacements along y",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.coupling_y_across",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.coupling_y"),
        "the same between neighbours across rolling, if it is another one",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.spring_x",
        quantity(&Measure::STIFFNESS),
        SPRING,
        Nothing,
        "Δc, spring of one cell along x, in place of the stiffnesses per area",
    )
    .example("2.0e6 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.spring_y",
        quantity(&Measure::STIFFNESS),
        SPRING,
        Same("elasticity.spring_x"),
        "the same along y",
    )
    .example("2.0e6 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.spring_coupling_x",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Nothing,
        "Δc_k, spring between neighbouring cells for displacements along x",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.spring_coupling_y",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.spring_coupling_x"),
        "the same for displacements along y",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    field(
        "elasticity.margin",
        quantity(&Measure::LENGTH),
        MARGIN,
        Computed("eight decay lengths √(g/c)"),
        "width of the surroundings of the patch on each side",
    )
    .example("12 mm")
    .with(MODEL, LAYER),
];
