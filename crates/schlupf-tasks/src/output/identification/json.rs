//! A fit as JSON, for other programs.

use serde::Serialize;

use schlupf::Status;
use schlupf::reporting::Message;
use schlupf::solution::Work;

use super::FitReport;
use crate::output::json::{self, PROGRAM};
use crate::output::table::Arrays;

/// The fit as a JSON document: SI units, forces on the rail divided by the load.
pub(super) fn document(report: &FitReport) -> String {
    let FitReport { fit, .. } = report;
    json::text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: fit.status,
        data: &report.data,
        parameters: Parameter::all(report),
        correlation: &fit.correlation,
        roughness: report.roughness.map(|roughness| Roughness {
            gamma: roughness.gamma,
            contact_stiffness: roughness.contact_stiffness,
        }),
        rms_residual: fit.rms_residual,
        r_squared: fit.r_squared,
        reduced_chi_squared: fit.reduced_chi_squared,
        degrees_of_freedom: fit.degrees_of_freedom,
        iterations: fit.iterations,
        points: Arrays(report),
        warnings: &report.warnings,
        work: &fit.work,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    data: &'a str,
    parameters: Vec<Parameter<'a>>,
    correlation: &'a [Vec<f64>],
    roughness: Option<Roughness>,
    rms_residual: f64,
    r_squared: Option<f64>,
    reduced_chi_squared: Option<f64>,
    degrees_of_freedom: usize,
    iterations: usize,
    points: Arrays<'a, FitReport>,
    warnings: &'a [Message],
    work: &'a Work,
}

#[derive(Serialize)]
struct Parameter<'a> {
    name: &'a str,
    symbol: &'static str,
    unit: &'static str,
    start: f64,
    value: f64,
    standard_error: Option<f64>,
    half_width_95: Option<f64>,
}

impl<'a> Parameter<'a> {
    fn all(report: &'a FitReport) -> Vec<Self> {
        let estimates = report.fit.estimates.iter().zip(&report.names);
        let parameters = estimates.map(|(estimate, name)| Self {
            name,
            symbol: estimate.parameter.quantity().symbol(),
            unit: estimate.parameter.quantity().unit(),
            start: estimate.start,
            value: estimate.value,
            standard_error: estimate.standard_error,
            half_width_95: estimate.half_width,
        });
        parameters.collect()
    }
}

#[derive(Serialize)]
struct Roughness {
    gamma: f64,
    contact_stiffness: f64,
}
