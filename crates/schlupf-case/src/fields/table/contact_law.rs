//! `[contact_law]` and `[contact_law.roughness]`.

use super::quantity;
use super::solver::{FULL, METHOD};
use crate::fields::choice::{Choose, ContactLawModel, FormTakenOff};
use crate::fields::field::Default::{Computed, Nothing, Same, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::fields::path::FieldPath;
use crate::surface::{BAND_COLUMNS, HEIGHT_COLUMNS};
use crate::units::Measure;
use schlupf::reporting::Requirement::{self, AboveUpTo, Between, Finite};

const MODEL: FieldPath = field!("contact_law.model");
/// The model without bristles.
const COULOMB: &[&str] = &[ContactLawModel::Coulomb.name()];

const CONTACT_STIFFNESS: Requirement = Between(1e-3, 1e12);
const HEIGHT: Requirement = Between(1e-12, 1e-2);
const SLOPE: Requirement = Between(1e-6, 10.0);
const WAVELENGTH: Requirement = Between(1e-9, 1.0);
const PRESSURE: Requirement = Between(1.0, 1e14);
const CELLS: Requirement = Between(16.0, 16384.0);
/// Whole numbers of 32 bits.
const SEED: Requirement = Between(0.0, 4_294_967_295.0);

section! {
    ContactLaw "contact_law"
        "How traction grows with the sliding of rough surfaces.";

    "model" [ContactLaw] Kind::Choice(ContactLawModel::CHOICES), Finite, Text("incremental"),
        "measure of sliding", with(METHOD, FULL);
    "stiffness" [ContactStiffness] quantity(&Measure::PER_LENGTH), CONTACT_STIFFNESS,
        Computed("5e6 1/m where there is no roughness"),
        "k_c, rate at which traction approaches the friction limit", example("5e6 1/m"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
}

section! {
    Roughness "contact_law.roughness" [ContactRoughness]
        "Roughness from which k_c follows, in place of stiffness: heights, a spectrum or files.";

    "rms_height" [RmsHeight] quantity(&Measure::LENGTH), HEIGHT, Nothing,
        "h_rms of both surfaces together", example("1.5 um"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "rms_height_wheel" [] quantity(&Measure::LENGTH), HEIGHT, Nothing,
        "h_rms of the wheel", example("1 um"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "rms_height_rail" [] quantity(&Measure::LENGTH), HEIGHT, Nothing,
        "h_rms of the rail", example("1 um"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "slope_factor" [SlopeFactor] Kind::Number, Between(1e-3, 1e3), Computed("0.45"),
        "γ of the closed form k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms)", example("0.45"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "rms_slope" [RmsSlope] Kind::Number, SLOPE, Nothing,
        "h'_rms, in place of h_rms; with the wavelengths", example("0.1"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "longest_wavelength" [LongestWavelength] quantity(&Measure::LENGTH), WAVELENGTH, Nothing,
        "a self-affine surface for the micro model, its longest wave", example("100 um"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "roll_off_wavelength" [RollOffWavelength] quantity(&Measure::LENGTH), WAVELENGTH,
        Same(field!("contact_law.roughness.longest_wavelength")),
        "longer waves have a constant spectrum", example("50 um"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "shortest_wavelength" [ShortestWavelength] quantity(&Measure::LENGTH), WAVELENGTH, Nothing,
        "its shortest wave", example("5 um"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "hurst" [HurstExponent] Kind::Number, Between(0.0, 1.0), Computed("0.8"),
        "H, its Hurst exponent", example("0.8"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "file" [Heights] Kind::Path, Finite, Nothing,
        "a measured surface, profile or spectrum for the micro model: .csv, .npy, .x3p or .xyz",
        example("surface.x3p"), with(METHOD, FULL), idle_with(MODEL, COULOMB),
        of_columns(&[&HEIGHT_COLUMNS, &BAND_COLUMNS]);
    "second_file" [] Kind::Path, Finite, Nothing,
        "the surface of the other body, on the same lattice", example("rail.x3p"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB),
        of_columns(&[&HEIGHT_COLUMNS, &BAND_COLUMNS]);
    "unit" [] Kind::Text, Finite, Nothing,
        "unit of heights in .npy files, of all lengths in .xyz files", example("um"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "spacing" [SpacingX SpacingY] quantity(&Measure::LENGTH), AboveUpTo(0.0, 1.0), Nothing,
        "spacing of the points of an .npy file, or of heights alone", example("1 um"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "form" [Form] Kind::Choice(FormTakenOff::CHOICES), Finite, Computed("\"plane\""),
        "form removed from the file's heights", example("cylinder"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "cutoff_wavelength" [CutoffWavelength] quantity(&Measure::LENGTH), WAVELENGTH, Nothing,
        "λc: longer waves are removed from the file's heights (Gaussian filter, ISO 16610)",
        example("0.8 mm"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "fill_holes" [] Kind::Flag, Finite, Computed("false"),
        "whether points without a height are filled smoothly", example("true"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "square_cells" [] Kind::Flag, Finite, Computed("false"),
        "whether cells that are not square are resampled", example("true"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "cells" [Columns Rows] Kind::Count, CELLS,
        Computed("as measured; suitable for a self-affine surface"),
        "cells of the micro model along x", example("512"), with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "seed" [] Kind::Count, SEED, Computed("1"),
        "of the random phases of a self-affine surface or one from a profile", example("1"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "hardness" [Hardness] quantity(&Measure::PRESSURE), PRESSURE, Computed("none, elastic bodies"),
        "largest pressure in the micro model: the hardness of the softer body", example("2.5 GPa"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
    "pressures" [MeanPressure] Kind::Quantities(&Measure::PRESSURE), PRESSURE,
        Computed("three that divide the load of the patch"),
        "mean pressures to which k_c is fitted", example("[\"0.3 GPa\", \"0.6 GPa\", \"0.9 GPa\"]"),
        with(METHOD, FULL), idle_with(MODEL, COULOMB);
}
