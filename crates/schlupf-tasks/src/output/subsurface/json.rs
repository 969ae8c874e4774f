//! Stresses below the surface as JSON, for other programs.

use schlupf::Status;
use schlupf::analysis::subsurface::{Largest, Measure, PointStress};
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use serde::Serialize;

use super::StressReport;
use crate::output::json::{PROGRAM, text};
use crate::output::table::{Arrays, Row};

/// The stresses as a JSON document: lengths in m, stresses in Pa.
pub(super) fn document(report: &StressReport) -> String {
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: report.status,
        body: report.body(),
        normal: &report.normal,
        largest: Points::of(report, |largest| Some(&largest.anywhere)),
        surface: Points::of(report, |largest| Some(&largest.surface)),
        below: Points::of(report, |largest| largest.below.as_ref()),
        profile: Arrays(report.profile.as_slice()),
        points: report.points.as_deref().map(Arrays),
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
    largest: Points<'a>,
    surface: Points<'a>,
    below: Points<'a>,
    profile: Arrays<'a, [PointStress]>,
    /// Null unless points were asked for.
    points: Option<Arrays<'a, [PointStress]>>,
    layers: Layers,
    warnings: &'a [Message],
}

/// The points with the largest stresses; null where there is none.
#[derive(Serialize)]
struct Points<'a> {
    von_mises: Row<'a, [PointStress]>,
    shear: Row<'a, [PointStress]>,
    tension: Row<'a, [PointStress]>,
}

impl<'a> Points<'a> {
    fn of(
        report: &'a StressReport,
        point: impl Fn(&'a Largest) -> Option<&'a PointStress>,
    ) -> Self {
        let row = |largest| Row(point(largest).map(std::slice::from_ref));
        let [von_mises, shear, tension] = report.largest.each_ref().map(row);
        Self { von_mises, shear, tension }
    }
}

/// The largest stresses of every layer.
#[derive(Serialize)]
struct Layers {
    depth: Vec<f64>,
    von_mises_stress: Vec<f64>,
    largest_shear_stress: Vec<f64>,
    largest_principal_stress: Vec<f64>,
}
