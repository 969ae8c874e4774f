//! Calibrated stiffnesses as JSON.

use schlupf::Status;
use schlupf::analysis::calibration::Deviation;
use schlupf::elasticity::elastic_layer::LayerStiffness;
use schlupf::reporting::Message;
use serde::Serialize;

use super::{CalibrationReport, FittedComponent, Layer};
use crate::output::json::{self, PROGRAM};

/// The stiffnesses as a JSON document, SI units.
pub(super) fn document(report: &CalibrationReport) -> String {
    json::text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: report.status,
        normal: Normal {
            load: report.normal.load,
            semi_axis_x: report.normal.semi_axis_x,
            semi_axis_y: report.normal.semi_axis_y,
        },
        bodies: Bodies { shear_modulus: report.shear_modulus, poisson_ratio: report.poisson_ratio },
        table: report.tabulated.map(LayerEntry::new),
        direct: report.direct.map(|direct| LayerEntry::new(direct.layer)),
        uncoupled: report.direct.map(|direct| LayerEntry::new(direct.uncoupled)),
        fitted: report.fitted.as_ref().map(|fitted| {
            let [x, y] = fitted.components.each_ref().map(|c| c.as_ref().map(FittedEntry::new));
            FittedEntries { x, y }
        }),
        warnings: &report.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    normal: Normal,
    bodies: Bodies,
    table: Option<LayerEntry>,
    direct: Option<LayerEntry>,
    uncoupled: Option<LayerEntry>,
    fitted: Option<FittedEntries<'a>>,
    warnings: &'a [Message],
}

#[derive(Serialize)]
struct Normal {
    load: f64,
    semi_axis_x: f64,
    semi_axis_y: f64,
}

#[derive(Serialize)]
struct Bodies {
    shear_modulus: f64,
    poisson_ratio: f64,
}

/// Names as in a case file, without the component.
#[derive(Serialize)]
struct StiffnessEntry {
    bedding: f64,
    coupling: f64,
    coupling_across: f64,
    decay_length: f64,
    decay_length_across: f64,
}

impl StiffnessEntry {
    fn new(stiffness: LayerStiffness) -> Self {
        let [decay_length, decay_length_across] = stiffness.decay_lengths();
        Self {
            bedding: stiffness.bedding,
            coupling: stiffness.coupling_along_x,
            coupling_across: stiffness.coupling_along_y,
            decay_length,
            decay_length_across,
        }
    }
}

#[derive(Serialize)]
struct LayerEntry {
    x: StiffnessEntry,
    y: StiffnessEntry,
    deviation: Option<Deviation>,
}

impl LayerEntry {
    fn new(layer: Layer) -> Self {
        let [x, y] = layer.stiffness.map(StiffnessEntry::new);
        Self { x, y, deviation: layer.deviation }
    }
}

#[derive(Serialize)]
struct FittedEntries<'a> {
    x: Option<FittedEntry<'a>>,
    y: Option<FittedEntry<'a>>,
}

#[derive(Serialize)]
struct FittedEntry<'a> {
    #[serde(flatten)]
    stiffness: StiffnessEntry,
    converged: bool,
    is_open: [bool; 2],
    files: Vec<FileEntry<'a>>,
}

#[derive(Serialize)]
struct FileEntry<'a> {
    file: &'a str,
    deviation: f64,
}

impl<'a> FittedEntry<'a> {
    fn new(component: &'a FittedComponent) -> Self {
        let files = component.files.iter().zip(&component.fit.deviation);
        Self {
            stiffness: StiffnessEntry::new(component.stiffness()),
            converged: component.fit.converged,
            is_open: component.fit.is_open,
            files: files.map(|(file, &deviation)| FileEntry { file, deviation }).collect(),
        }
    }
}
