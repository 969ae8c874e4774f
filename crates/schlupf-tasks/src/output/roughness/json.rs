//! A rough surface, its contact and its k_c as JSON, for other programs.

use schlupf::Status;
use schlupf::interface::roughness::tangential_curve::TangentialCurve;
use schlupf::interface::roughness::{ExponentialFit, LoadCurve, TYPICAL_GAMMA};
use schlupf::reporting::{Message, Record};
use schlupf::surface::{Lattice, Statistics};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::RoughnessReport;
use crate::output::json::{PROGRAM, text};
use crate::output::report::Report;
use crate::output::table::Arrays;

/// The report as a JSON document, in SI units. A number that is not finite, such as the hardness of
/// elastic bodies, becomes `null`.
pub(super) fn document(report: &RoughnessReport) -> String {
    let result = &report.result;
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: report.status(),
        surface: Surface { lattice: report.surface.lattice(), statistics: &result.statistics },
        spectrum: Spectrum::new(report),
        bodies: Bodies {
            contact_modulus: report.contact_modulus,
            poisson_ratio: report.bodies.poisson_ratio,
            friction_coefficient: report.bodies.friction_coefficient,
            hardness: report.hardness,
        },
        normal: Arrays(&result.normal),
        contact_law: ContactLaw {
            stiffness: result.stiffness.common.stiffness,
            spread: result.stiffness.spread,
            root_mean_square_error: result.stiffness.common.root_mean_square_error,
            largest_error: result.stiffness.common.largest_error,
            slope_factor: result.gamma,
            closed_form: Closed { stiffness: result.closed_form, slope_factor: TYPICAL_GAMMA },
        },
        pressures: result
            .tangential
            .iter()
            .zip(&result.stiffness.fits)
            .map(|(curve, fit)| Curve::new(report, curve, fit))
            .collect(),
        remarks: &report.remarks,
        warnings: &report.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    surface: Surface<'a>,
    spectrum: Spectrum<'a>,
    bodies: Bodies,
    normal: Arrays<'a, LoadCurve>,
    contact_law: ContactLaw,
    pressures: Vec<Curve<'a>>,
    remarks: &'a [String],
    warnings: &'a [Message],
}

#[derive(Serialize)]
struct Surface<'a> {
    #[serde(flatten)]
    lattice: &'a Lattice,
    #[serde(flatten)]
    statistics: &'a Statistics,
}

#[derive(Serialize)]
struct Spectrum<'a> {
    hurst_exponent: Option<f64>,
    power_law_wave_numbers: Option<[f64; 2]>,
    wave_numbers: &'a [f64],
    densities: &'a [f64],
}

impl<'a> Spectrum<'a> {
    fn new(report: &'a RoughnessReport) -> Self {
        let law = report.spectrum.power_law();
        Self {
            hurst_exponent: law.map(|law| law.hurst_exponent),
            power_law_wave_numbers: law.map(|law| law.wave_numbers),
            wave_numbers: &report.spectrum.wave_numbers,
            densities: &report.spectrum.densities,
        }
    }
}

#[derive(Serialize)]
struct Bodies {
    contact_modulus: f64,
    poisson_ratio: f64,
    friction_coefficient: f64,
    hardness: f64,
}

#[derive(Serialize)]
struct ContactLaw {
    stiffness: f64,
    spread: f64,
    root_mean_square_error: f64,
    largest_error: f64,
    slope_factor: Option<f64>,
    closed_form: Closed,
}

#[derive(Serialize)]
struct Closed {
    stiffness: f64,
    slope_factor: f64,
}

#[derive(Serialize)]
struct Curve<'a> {
    mean_pressure: f64,
    corrected_contact_fraction: f64,
    stiffness: f64,
    root_mean_square_error: f64,
    largest_error: f64,
    full_sliding_displacement: f64,
    initial_stiffness: f64,
    #[serde(flatten)]
    points: CurvePoints<'a>,
}

/// All columns except the stiffness, whose name is used for k_c here.
struct CurvePoints<'a>(&'a TangentialCurve);

impl Serialize for CurvePoints<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let columns = TangentialCurve::COLUMNS.iter().filter(|c| c.name != "stiffness");
        let mut map = serializer.serialize_map(None)?;
        for column in columns {
            let number = |row| (column.value)(self.0, row).number();
            map.serialize_entry(column.name, &(0..self.0.rows()).map(number).collect::<Vec<_>>())?;
        }
        map.end()
    }
}

impl<'a> Curve<'a> {
    fn new(report: &RoughnessReport, curve: &'a TangentialCurve, fit: &ExponentialFit) -> Self {
        let normal = &report.result.normal;
        Self {
            mean_pressure: curve.mean_pressure,
            corrected_contact_fraction: normal.corrected_contact_fraction(curve.mean_pressure),
            stiffness: fit.stiffness,
            root_mean_square_error: fit.root_mean_square_error,
            largest_error: fit.largest_error,
            full_sliding_displacement: curve.full_sliding_displacement,
            initial_stiffness: curve.initial_stiffness,
            points: CurvePoints(curve),
        }
    }
}
