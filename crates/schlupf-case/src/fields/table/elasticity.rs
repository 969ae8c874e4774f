//! `[elasticity]`.

use super::solver::{FULL, METHOD};
use super::{quantity, shaping};
use crate::fields::choice::{CalibratedWith, Choose, ElasticityModel};
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
    shaping(
        "elasticity.model",
        Kind::Choice(ElasticityModel::CHOICES),
        Finite,
        Text("elastic-layer"),
        "model of the deformation",
    )
    .with(METHOD, FULL),
    shaping(
        "elasticity.calibration",
        Kind::Choice(CalibratedWith::CHOICES),
        Finite,
        Computed("\"half-space\", where no stiffness is given"),
        "where the stiffnesses come from",
    )
    .example("half-space")
    .with(MODEL, &["elastic-layer", "winkler"]),
    shaping(
        "elasticity.bedding_x",
        quantity(&Measure::BEDDING),
        BEDDING,
        Nothing,
        "c, bedding stiffness for displacements along x",
    )
    .example("1.0e13 N/m^3")
    .with(MODEL, &["elastic-layer", "winkler"]),
    shaping(
        "elasticity.bedding_y",
        quantity(&Measure::BEDDING),
        BEDDING,
        Same("elasticity.bedding_x"),
        "the same for displacements along y",
    )
    .example("1.0e13 N/m^3")
    .with(MODEL, &["elastic-layer", "winkler"]),
    shaping(
        "elasticity.coupling_x",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Nothing,
        "g, coupling stiffness for displacements along x",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.coupling_x_across",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.coupling_x"),
        "the same between neighbours across rolling, if it is another one",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.coupling_y",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.coupling_x"),
        "g, coupling stiffness for displacements along y",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.coupling_y_across",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.coupling_y"),
        "the same between neighbours across rolling, if it is another one",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.spring_x",
        quantity(&Measure::STIFFNESS),
        SPRING,
        Nothing,
        "Δc, spring of one cell along x, in place of the stiffnesses per area",
    )
    .example("2.0e6 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.spring_y",
        quantity(&Measure::STIFFNESS),
        SPRING,
        Same("elasticity.spring_x"),
        "the same along y",
    )
    .example("2.0e6 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.spring_coupling_x",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Nothing,
        "Δc_k, spring between neighbouring cells for displacements along x",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.spring_coupling_y",
        quantity(&Measure::STIFFNESS),
        COUPLING,
        Same("elasticity.spring_coupling_x"),
        "the same for displacements along y",
    )
    .example("3.24e7 N/m")
    .with(MODEL, LAYER),
    shaping(
        "elasticity.margin",
        quantity(&Measure::LENGTH),
        MARGIN,
        Computed("eight decay lengths √(g/c)"),
        "width of the surroundings of the patch on each side",
    )
    .example("12 mm")
    .with(MODEL, LAYER),
];
