//! `[layer]`.

use schlupf::reporting::Requirement::{self, Between};

use super::quantity;
use crate::fields::field::Default::Nothing;
use crate::fields::field::{Field, Section};
use crate::units::Measure;

const THICKNESS: Requirement = Between(0.0, 1.0);
const MODULUS: Requirement = Between(1.0, 1e14);
const HARDENING: Requirement = Between(-1e20, 1e20);

section! {
    Layer "layer"
        "A third body between the surfaces, such as oxides, leaves or sand; left out: none.";

    "thickness" [LayerThickness] quantity(&Measure::LENGTH), THICKNESS, Nothing,
        "h, thickness of the layer; 0: rigid until it yields", shaping(), example("1.25 mm"),
        usually(Between(0.0, 1e-2));
    "shear_modulus" [LayerShearModulus] quantity(&Measure::PRESSURE), MODULUS, Nothing,
        "G, shear modulus of the layer, which is sheared by t h/G", shaping(), example("8200 MPa"),
        usually(Between(1e4, 1e12));
    "yield_stress" [LayerYieldStress] quantity(&Measure::PRESSURE), MODULUS, Nothing,
        "τ_c0, traction at which the layer yields; left out: it is elastic", shaping(),
        example("560 MPa"),
        usually(Between(1e3, 1e11));
    "hardening" [LayerHardening] quantity(&Measure::BEDDING), HARDENING, Nothing,
        "k_τ, growth of that with the plastic displacement; negative: it softens; left out: 0",
        shaping(), example("400 MPa/mm");
}
