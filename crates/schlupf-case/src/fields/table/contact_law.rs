//! `[contact_law]` and `[contact_law.roughness]`.

use super::{quantity, solver};
use crate::fields::choice::{Choose, ContactLawModel, FormTakenOff};
use crate::fields::field::Default::{Computed, Nothing, Same, Text};
use crate::fields::field::{Field, Kind};
use crate::units::Measure;
use schlupf::requirement::Requirement::{self, AboveUpTo, Between, Finite};

const CONTACT_STIFFNESS: Requirement = Between(1e-3, 1e12);
const HEIGHT: Requirement = Between(1e-12, 1e-2);
const SLOPE: Requirement = Between(1e-6, 10.0);
const WAVELENGTH: Requirement = Between(1e-9, 1.0);
const PRESSURE: Requirement = Between(1.0, 1e14);
const CELLS: Requirement = Between(16.0, 16384.0);
/// Whole numbers of 32 bits.
const SEED: Requirement = Between(0.0, 4_294_967_295.0);

pub(super) const FIELDS: &[Field] = &[
    Field::new(
        "contact_law.model",
        Kind::Choice(ContactLawModel::CHOICES),
        Finite,
        Text("incremental"),
        "which sliding counts",
    )
    .with(solver::METHOD, solver::FULL),
    Field::new(
        "contact_law.stiffness",
        quantity(&Measure::PER_LENGTH),
        CONTACT_STIFFNESS,
        Computed("5e6 1/m where there is no roughness"),
        "k_c, rate at which traction approaches the friction limit",
    )
    .example("5e6 1/m")
    .with(solver::METHOD, solver::FULL),
];

/// A field that belongs to the full method.
const fn of(field: Field, example: &'static str) -> Field {
    field.example(example).with(solver::METHOD, solver::FULL)
}

const fn height(path: &'static str, doc: &'static str, example: &'static str) -> Field {
    of(Field::new(path, quantity(&Measure::LENGTH), HEIGHT, Nothing, doc), example)
}

pub(super) const ROUGHNESS: &[Field] = &[
    height("contact_law.roughness.rms_height", "h_rms of both surfaces together", "1.5 um"),
    height("contact_law.roughness.rms_height_wheel", "h_rms of the wheel", "1 um"),
    height("contact_law.roughness.rms_height_rail", "h_rms of the rail", "1 um"),
    of(
        Field::new(
            "contact_law.roughness.slope_factor",
            Kind::Number,
            Between(1e-3, 1e3),
            Computed("0.45"),
            "γ of the closed form k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms)",
        ),
        "0.45",
    ),
    of(
        Field::new(
            "contact_law.roughness.rms_slope",
            Kind::Number,
            SLOPE,
            Nothing,
            "h'_rms, in place of h_rms; with the wavelengths",
        ),
        "0.1",
    ),
    wavelength(
        "contact_law.roughness.longest_wavelength",
        Nothing,
        "a self-affine surface for the micro model, its longest wave",
        "100 um",
    ),
    wavelength(
        "contact_law.roughness.roll_off_wavelength",
        Same("contact_law.roughness.longest_wavelength"),
        "longer waves have a constant spectrum",
        "50 um",
    ),
    wavelength("contact_law.roughness.shortest_wavelength", Nothing, "its shortest wave", "5 um"),
    of(
        Field::new(
            "contact_law.roughness.hurst",
            Kind::Number,
            Between(0.0, 1.0),
            Computed("0.8"),
            "H, its Hurst exponent",
        ),
        "0.8",
    ),
    of(
        Field::new(
            "contact_law.roughness.file",
            Kind::Path,
            Finite,
            Nothing,
            "a measured surface or profile for the micro model: .csv, .npy, .x3p or .xyz",
        ),
        "surface.x3p",
    ),
    of(
        Field::new(
            "contact_law.roughness.second_file",
            Kind::Path,
            Finite,
            Nothing,
            "the surface of the other body, on the same lattice",
        ),
        "rail.x3p",
    ),
    of(
        Field::new(
            "contact_law.roughness.unit",
            Kind::Text,
            Finite,
            Nothing,
            "unit of heights in .npy files, of all lengths in .xyz files",
        ),
        "um",
    ),
    of(
        Field::new(
            "contact_law.roughness.spacing",
            quantity(&Measure::LENGTH),
            AboveUpTo(0.0, 1.0),
            Nothing,
            "distance of the points of an .npy file",
        ),
        "1 um",
    ),
    of(
        Field::new(
            "contact_law.roughness.form",
            Kind::Choice(FormTakenOff::CHOICES),
            Finite,
            Computed("\"plane\""),
            "what is taken off the file's heights",
        ),
        "cylinder",
    ),
    wavelength(
        "contact_law.roughness.cutoff_wavelength",
        Nothing,
        "λc: longer waves are taken off the file's heights (Gaussian filter, ISO 16610)",
        "0.8 mm",
    ),
    flag("contact_law.roughness.fill_holes", "whether points without a height are filled smoothly"),
    flag("contact_law.roughness.square_cells", "whether cells that are not square are made so"),
    of(
        Field::new(
            "contact_law.roughness.cells",
            Kind::Count,
            CELLS,
            Computed("as measured; suitable for a self-affine surface"),
            "cells of the micro model along x",
        ),
        "512",
    ),
    of(
        Field::new(
            "contact_law.roughness.seed",
            Kind::Count,
            SEED,
            Computed("1"),
            "of the random phases of a self-affine surface or one from a profile",
        ),
        "1",
    ),
    of(
        Field::new(
            "contact_law.roughness.hardness",
            quantity(&Measure::PRESSURE),
            PRESSURE,
            Computed("none, elastic bodies"),
            "largest pressure in the micro model: the hardness of the softer body",
        ),
        "2.5 GPa",
    ),
    of(
        Field::new(
            "contact_law.roughness.pressures",
            Kind::Quantities(&Measure::PRESSURE),
            PRESSURE,
            Computed("three that divide the load of the patch"),
            "mean pressures to which k_c is fitted",
        ),
        "[\"0.3 GPa\", \"0.6 GPa\", \"0.9 GPa\"]",
    ),
];

const fn wavelength(
    path: &'static str,
    default: crate::fields::field::Default,
    doc: &'static str,
    example: &'static str,
) -> Field {
    of(Field::new(path, quantity(&Measure::LENGTH), WAVELENGTH, default, doc), example)
}

const fn flag(path: &'static str, doc: &'static str) -> Field {
    of(Field::new(path, Kind::Flag, Finite, Computed("false"), doc), "true")
}
