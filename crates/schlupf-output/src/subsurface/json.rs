//! Stresses below the surface as JSON, for other programs.

use schlupf::Status;
use schlupf::message::Message;
use schlupf::normal::NormalSummary;
use schlupf::subsurface::{Measure, PointStress};
use serde::Serialize;

use super::StressReport;
use crate::json::{PROGRAM, text};
use crate::table::{Arrays, Row};

/// The stresses as a JSON document: lengths in m, stresses in Pa.
pub(super) fn document(report: &StressReport) -> String {
    let [von_mises, shear, tension] = report.largest.each_ref().map(std::slice::from_ref);
    let [von_mises, shear, tension] = [von_mises, shear, tension].map(|point| Row(Some(point)));
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: report.status,
        body: report.body(),
        normal: &report.normal,
        largest: Largest { von_mises, shear, tension },
        profile: Arrays(report.profile.as_slice()),
        layers: Layers {
            depth: report.volume.layers.iter().map(|layer| layer.depth).collect(),
            von_mises_stress: report.by_depth(Measure::VonMises),
            largest_shear_stress: report.by_depth(Measure::Shear),
            largest_principal_stress: report.by_depth(Measure::Tension),
        },
        warnings: &report.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    body: &'static str,
    normal: &'a NormalSummary,
    largest: Largest<'a>,
    profile: Arrays<'a, [PointStress]>,
    layers: Layers,
    warnings: &'a [Message],
}

/// The points with the largest stresses.
#[derive(Serialize)]
struct Largest<'a> {
    von_mises: Row<'a, [PointStress]>,
    shear: Row<'a, [PointStress]>,
    tension: Row<'a, [PointStress]>,
}

/// The largest stresses of every layer.
#[derive(Serialize)]
struct Layers {
    depth: Vec<f64>,
    von_mises_stress: Vec<f64>,
    largest_shear_stress: Vec<f64>,
    largest_principal_stress: Vec<f64>,
}
