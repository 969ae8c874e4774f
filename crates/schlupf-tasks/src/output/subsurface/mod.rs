//! Stresses below the surface: CSV, JSON, VTK, a summary and figures.

mod figure;
mod json;
mod summary;
mod vtk;

use schlupf::analysis::subsurface::{
    Largest, Measure, PointStress, StressVolume, SubsurfaceStress,
};
use schlupf::analysis::temperature_field::Side;
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use schlupf::solution::Status;

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues};

/// Points of the profile below a point.
pub const PROFILE_POINTS: usize = 201;

/// The stresses in a body.
#[derive(Debug, Clone)]
pub struct StressReport {
    /// Title of the case.
    pub title: String,
    /// Whether the solution that they belong to converged.
    pub status: Status,
    /// The stresses at any point.
    pub stresses: SubsurfaceStress,
    /// The stresses in layers from the surface on.
    pub volume: StressVolume,
    /// Where the measures of [`Measure::ALL`] are largest in the body.
    pub largest: [Largest; 3],
    /// Stresses below a point, from the surface on.
    pub profile: Vec<PointStress>,
    /// Stresses at the points that were asked for.
    pub points: Option<Vec<PointStress>>,
    /// The normal contact.
    pub normal: NormalSummary,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

impl StressReport {
    /// Format of the volume for `ParaView`.
    pub const VTK: &str = "vtk";

    /// Name of the body.
    pub fn body(&self) -> &'static str {
        match self.stresses.side() {
            Side::Wheel => "wheel",
            Side::Rail => "rail",
        }
    }

    /// Place of the profile, x and y in m.
    pub fn place(&self) -> [f64; 2] {
        self.profile.first().map_or([0.0; 2], |point| [point.x, point.y])
    }

    /// The largest value of a measure in every layer, in Pa.
    fn by_depth(&self, measure: Measure) -> Vec<f64> {
        let of_layer = |stress: &[schlupf::analysis::subsurface::Stress]| {
            stress.iter().map(|stress| measure.of(stress)).fold(f64::NEG_INFINITY, f64::max)
        };
        self.volume.layers.iter().map(|layer| of_layer(&layer.stress)).collect()
    }
}

impl Report for StressReport {
    fn status(&self) -> Status {
        self.status
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        json::document(self)
    }

    fn summary(&self) -> Summary {
        summary::text(self)
    }

    /// The points that were asked for, else those of the profile.
    fn csv(&self) -> Option<String> {
        let note = format!("stresses in the {}, tension positive, z up", self.body());
        Some(table::csv(self.points.as_ref().unwrap_or(&self.profile).as_slice(), &note))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        vec![("profile", table::columns(self.profile.as_slice()))]
    }

    fn figure_names() -> Vec<String> {
        figure::NAMES.map(str::to_owned).to_vec()
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        figure::draw(self).ok_or(FigureError::NoStress)
    }

    fn own_files() -> &'static [OwnFile] {
        const { &[OwnFile::new(Self::VTK, "vtk", "Write the stresses in all layers as a VTK file")] }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        (format == Self::VTK).then(|| vtk::rectilinear_grid(self))
    }
}
