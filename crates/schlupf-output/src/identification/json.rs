//! A fit as JSON, for other programs.

use serde::Serialize;

use schlupf::identification::{Estimate, FittedPoint};

use super::{FitReport, component};
use crate::json::{self, PROGRAM, Work};

/// The fit as a JSON document: SI units, forces on the rail over the load.
pub fn document(report: &FitReport) -> String {
    let FitReport { fit, .. } = report;
    json::text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: json::status(fit.status),
        data: &report.data,
        parameters: fit.estimates.iter().map(Parameter::from).collect(),
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
        points: Points::new(report),
        warnings: &fit.warnings,
        work: (&fit.work).into(),
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: &'static str,
    data: &'a str,
    parameters: Vec<Parameter>,
    correlation: &'a [Vec<f64>],
    roughness: Option<Roughness>,
    rms_residual: f64,
    r_squared: f64,
    reduced_chi_squared: Option<f64>,
    degrees_of_freedom: usize,
    iterations: usize,
    points: Points,
    warnings: &'a [String],
    work: Work,
}

#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    symbol: &'static str,
    unit: &'static str,
    start: f64,
    value: f64,
    standard_error: f64,
    half_width_95: f64,
}

impl From<&Estimate> for Parameter {
    fn from(estimate: &Estimate) -> Self {
        Self {
            name: estimate.parameter.name(),
            symbol: estimate.parameter.symbol(),
            unit: estimate.parameter.unit(),
            start: estimate.start,
            value: estimate.value,
            standard_error: estimate.standard_error,
            half_width_95: estimate.half_width,
        }
    }
}

#[derive(Serialize)]
struct Roughness {
    gamma: f64,
    contact_stiffness: f64,
}

/// Arrays of one length.
#[derive(Serialize)]
struct Points {
    creepage_x: Vec<f64>,
    creepage_y: Vec<f64>,
    spin: Vec<f64>,
    speed: Vec<f64>,
    load: Vec<f64>,
    component: Vec<&'static str>,
    force_ratio: Vec<f64>,
    standard_deviation: Vec<Option<f64>>,
    fitted: Vec<f64>,
    residual: Vec<f64>,
}

impl Points {
    fn new(report: &FitReport) -> Self {
        let points = &report.fit.points;
        let column = |value: fn(&FittedPoint) -> f64| points.iter().map(value).collect();
        Self {
            creepage_x: column(|point| point.data.condition.kinematics.creepage_x),
            creepage_y: column(|point| point.data.condition.kinematics.creepage_y),
            spin: column(|point| point.data.condition.kinematics.spin),
            speed: column(|point| point.data.condition.kinematics.speed),
            load: points.iter().map(|point| report.load_of(point)).collect(),
            component: points.iter().map(|point| component(point.data.component)).collect(),
            force_ratio: column(|point| point.data.force_ratio),
            standard_deviation: points.iter().map(|point| point.data.standard_deviation).collect(),
            fitted: column(|point| point.fitted),
            residual: column(FittedPoint::residual),
        }
    }
}
