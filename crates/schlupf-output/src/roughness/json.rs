//! A rough surface, its contact and its k_c as JSON, for other programs.

use schlupf::interface::roughness::load_curve::LoadPoint;
use schlupf::interface::roughness::stiffness::{ExponentialFit, TYPICAL_GAMMA};
use schlupf::interface::roughness::tangential_curve::{TangentialCurve, TangentialPoint};
use serde::Serialize;

use super::RoughnessReport;
use crate::json::{PROGRAM, status, text};

/// The report as a JSON document, in SI units. A number that is not finite, such as the hardness of
/// elastic bodies, becomes `null`.
pub fn document(report: &RoughnessReport) -> String {
    let result = &report.result;
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: status(report.status()),
        surface: Surface::new(report),
        spectrum: Spectrum::new(report),
        bodies: Bodies {
            contact_modulus: report.contact_modulus,
            poisson_ratio: report.bodies.poisson_ratio,
            friction_coefficient: report.bodies.friction_coefficient,
            hardness: report.hardness,
        },
        normal: Normal::new(result.normal.points()),
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
    status: &'static str,
    surface: Surface,
    spectrum: Spectrum<'a>,
    bodies: Bodies,
    normal: Normal,
    contact_law: ContactLaw,
    pressures: Vec<Curve>,
    remarks: &'a [String],
    warnings: &'a [String],
}

#[derive(Serialize)]
struct Surface {
    columns: usize,
    rows: usize,
    spacing_x: f64,
    spacing_y: f64,
    arithmetic_mean_height: f64,
    root_mean_square_height: f64,
    skewness: f64,
    kurtosis: f64,
    peak_height: f64,
    pit_depth: f64,
    maximum_height: f64,
    root_mean_square_gradient: f64,
    developed_area_ratio: f64,
    spectral_gradient: f64,
}

impl Surface {
    fn new(report: &RoughnessReport) -> Self {
        let (lattice, statistics) = (report.surface.lattice(), &report.result.statistics);
        Self {
            columns: lattice.columns,
            rows: lattice.rows,
            spacing_x: lattice.spacing_x,
            spacing_y: lattice.spacing_y,
            arithmetic_mean_height: statistics.arithmetic_mean_height,
            root_mean_square_height: statistics.root_mean_square_height,
            skewness: statistics.skewness,
            kurtosis: statistics.kurtosis,
            peak_height: statistics.peak_height,
            pit_depth: statistics.pit_depth,
            maximum_height: statistics.maximum_height,
            root_mean_square_gradient: statistics.root_mean_square_gradient,
            developed_area_ratio: statistics.developed_area_ratio,
            spectral_gradient: statistics.spectral_gradient,
        }
    }
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

/// One array per quantity, all of the same length.
#[derive(Serialize)]
struct Normal {
    mean_pressure: Vec<f64>,
    approach: Vec<f64>,
    mean_gap: Vec<f64>,
    contact_fraction: Vec<f64>,
    corrected_contact_fraction: Vec<f64>,
    spot_pressure: Vec<f64>,
    plastic_fraction: Vec<f64>,
    iterations: Vec<usize>,
}

impl Normal {
    fn new(points: &[LoadPoint]) -> Self {
        let column = |value: fn(&LoadPoint) -> f64| points.iter().map(value).collect();
        Self {
            mean_pressure: column(|point| point.mean_pressure),
            approach: column(|point| point.approach),
            mean_gap: column(|point| point.mean_gap),
            contact_fraction: column(|point| point.contact_fraction),
            corrected_contact_fraction: column(|point| point.corrected_contact_fraction),
            spot_pressure: column(|point| point.spot_pressure),
            plastic_fraction: column(|point| point.plastic_fraction),
            iterations: points.iter().map(|point| point.iterations).collect(),
        }
    }
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
struct Curve {
    mean_pressure: f64,
    corrected_contact_fraction: f64,
    stiffness: f64,
    root_mean_square_error: f64,
    largest_error: f64,
    full_sliding_displacement: f64,
    initial_stiffness: f64,
    displacement: Vec<f64>,
    normalised_traction: Vec<f64>,
    micro_slip: Vec<f64>,
    sliding_fraction: Vec<f64>,
}

impl Curve {
    fn new(report: &RoughnessReport, curve: &TangentialCurve, fit: &ExponentialFit) -> Self {
        let column = |value: fn(&TangentialPoint) -> f64| curve.points.iter().map(value).collect();
        Self {
            mean_pressure: curve.mean_pressure,
            corrected_contact_fraction: report
                .result
                .normal
                .corrected_contact_fraction(curve.mean_pressure),
            stiffness: fit.stiffness,
            root_mean_square_error: fit.root_mean_square_error,
            largest_error: fit.largest_error,
            full_sliding_displacement: curve.full_sliding_displacement,
            initial_stiffness: curve.initial_stiffness,
            displacement: column(|point| point.displacement),
            normalised_traction: column(|point| point.normalised_traction),
            micro_slip: column(|point| point.micro_slip),
            sliding_fraction: column(|point| point.sliding_fraction),
        }
    }
}
