//! `[subsurface]`.

use schlupf::reporting::Requirement::{self, Between, Finite};

use super::quantity;
use crate::fields::choice::{BodyChoice, Choose};
use crate::fields::field::Default::{Computed, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::units::Measure;

const DEPTH: Requirement = Between(1e-7, 1e2);
const MARGIN: Requirement = Between(0.0, 1e2);
const LAYERS: Requirement = Between(2.0, 1000.0);

section! {
    Subsurface "subsurface"
        "Where to compute stresses below the surface, for `schlupf subsurface`." for "subsurface";

    "body" [] Kind::Choice(BodyChoice::CHOICES), Finite, Text("rail"), "in which body";
    "depth" [] quantity(&Measure::LENGTH), DEPTH, Computed("twice the larger semi-axis"),
        "depth of the deepest layer", example("12 mm");
    "layers" [] Kind::Count, LAYERS, Text("41"),
        "number of layers, evenly spaced from the surface on";
    "margin" [] quantity(&Measure::LENGTH), MARGIN, Computed("half the size of the patch each way"),
        "surroundings of the patch on each side", example("5 mm");
}
