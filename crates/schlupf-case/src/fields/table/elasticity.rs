//! `[elasticity]`.

use super::solver::{FULL, METHOD};
use super::{NORMAL_MODEL, quantity};
use crate::fields::choice::{CalibratedWith, Choose, ElasticityModel, UnlikeBodiesModel};
use crate::fields::field::Default::{Computed, Nothing, Same, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::fields::path::FieldPath;
use crate::units::Measure;
use schlupf::reporting::Requirement::{self, Between, Finite};

const BEDDING: Requirement = Between(1.0, 1e20);
const COUPLING: Requirement = Between(0.0, 1e18);
const SPRING: Requirement = Between(1e-9, 1e18);
const MARGIN: Requirement = Between(0.0, 1e3);

pub(super) const MODEL: FieldPath = field!("elasticity.model");
const LAYER: &[&str] = &["elastic-layer"];
const HALF_SPACE: &[&str] = &["half-space"];
pub(super) const VISCOELASTIC: &[&str] = &["viscoelastic"];
const SPRINGS: &[&str] = &["elastic-layer", "winkler"];

section! {
    Elasticity "elasticity"
        "How the bodies deform under tangential traction.";

    "model" [Elasticity] Kind::Choice(ElasticityModel::CHOICES), Finite, Text("elastic-layer"),
        "model of the deformation; \"half-space\" by default with normal.model = \"wheel-rail\"",
        shaping(), with(METHOD, FULL), default_else(NORMAL_MODEL, &["wheel-rail", "line"], "half-space");
    "calibration" [Calibration] Kind::Choice(CalibratedWith::CHOICES), Finite,
        Computed("\"half-space\", where no stiffness is given"),
        "where the stiffnesses come from", shaping(), example("half-space"), with(MODEL, SPRINGS);
    "unlike_bodies" [UnlikeBodies] Kind::Choice(UnlikeBodiesModel::CHOICES), Finite, Text("coupled"),
        "coupling of pressure and tractions where wheel and rail differ in their elastic constants",
        shaping(), with(MODEL, HALF_SPACE);
    "bedding_x" [BeddingX] quantity(&Measure::BEDDING), BEDDING, Nothing,
        "c, bedding stiffness for displacements along x", shaping(), example("1.0e13 N/m^3"),
        with(MODEL, SPRINGS);
    "bedding_y" [BeddingY] quantity(&Measure::BEDDING), BEDDING, Same(field!("elasticity.bedding_x")),
        "the same for displacements along y", shaping(), example("1.0e13 N/m^3"),
        with(MODEL, SPRINGS);
    "coupling_x" [CouplingX] quantity(&Measure::STIFFNESS), COUPLING, Nothing,
        "g, coupling stiffness for displacements along x", shaping(), example("3.24e7 N/m"),
        with(MODEL, LAYER);
    "coupling_x_across" [CouplingXAcross] quantity(&Measure::STIFFNESS), COUPLING,
        Same(field!("elasticity.coupling_x")),
        "the same between neighbours across rolling, if different", shaping(),
        example("3.24e7 N/m"), with(MODEL, LAYER);
    "coupling_y" [CouplingY] quantity(&Measure::STIFFNESS), COUPLING, Same(field!("elasticity.coupling_x")),
        "g, coupling stiffness for displacements along y", shaping(), example("3.24e7 N/m"),
        with(MODEL, LAYER);
    "coupling_y_across" [CouplingYAcross] quantity(&Measure::STIFFNESS), COUPLING,
        Same(field!("elasticity.coupling_y")),
        "the same between neighbours across rolling, if different", shaping(),
        example("3.24e7 N/m"), with(MODEL, LAYER);
    "spring_x" [SpringX] quantity(&Measure::STIFFNESS), SPRING, Nothing,
        "Δc, spring of one cell along x, in place of the stiffnesses per area", shaping(),
        example("2.0e6 N/m"), with(MODEL, LAYER);
    "spring_y" [SpringY] quantity(&Measure::STIFFNESS), SPRING, Same(field!("elasticity.spring_x")),
        "the same along y", shaping(), example("2.0e6 N/m"), with(MODEL, LAYER);
    "spring_coupling_x" [SpringCouplingX] quantity(&Measure::STIFFNESS), COUPLING, Nothing,
        "Δc_k, spring between neighbouring cells for displacements along x", shaping(),
        example("3.24e7 N/m"), with(MODEL, LAYER);
    "spring_coupling_y" [SpringCouplingY] quantity(&Measure::STIFFNESS), COUPLING,
        Same(field!("elasticity.spring_coupling_x")),
        "the same for displacements along y", shaping(), example("3.24e7 N/m"), with(MODEL, LAYER);
    "margin" [Margin] quantity(&Measure::LENGTH), MARGIN, Computed("eight decay lengths √(g/c)"),
        "width of the surroundings of the patch on each side", shaping(), example("12 mm"),
        with(MODEL, LAYER);
}
