//! Calibrated stiffnesses of the elastic layer: a summary with a snippet for the case file, and
//! JSON.

mod figure;
mod json;
mod snippet;
mod summary;

use schlupf::analysis::calibration::Deviation;
use schlupf::analysis::calibration::displacements::DisplacementFit;
use schlupf::analysis::calibration::side_by_side::SideBySide;
use schlupf::elasticity::elastic_layer::LayerStiffness;
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use schlupf::solution::Status;

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{Table, entry};

/// Name of the figure.
const FIGURE: &str = "calibration";

/// Stiffnesses for a patch, and the data they were fitted to.
#[derive(Debug, Clone)]
pub struct CalibrationReport {
    /// Title of the case.
    pub title: String,
    /// The patch.
    pub normal: NormalSummary,
    /// Combined shear modulus G of the bodies, in Pa.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio ν of the bodies, dimensionless.
    pub poisson_ratio: f64,
    /// From the table; `None` for a patch outside it.
    pub tabulated: Option<Layer>,
    /// Calibrated for this particular patch.
    pub direct: Option<Direct>,
    /// Fitted to displacements.
    pub fitted: Option<Fitted>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
    /// Forces and tractions of all models, for the figure.
    pub sides: Option<SideBySide>,
    /// Whether everything that was computed converged.
    pub status: Status,
}

/// Stiffnesses for displacements along and across rolling.
#[derive(Debug, Clone, Copy)]
pub struct Layer {
    /// The stiffnesses.
    pub stiffness: [LayerStiffness; 2],
    /// Deviation of the layer from the half-space, if computed.
    pub deviation: Option<Deviation>,
}

/// A calibration for one patch.
#[derive(Debug, Clone, Copy)]
pub struct Direct {
    /// The layer.
    pub layer: Layer,
    /// An uncoupled Winkler bedding, fitted to the same forces.
    pub uncoupled: Layer,
}

/// A fit to displacements.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// The components that were loaded: along and across rolling.
    pub components: [Option<FittedComponent>; 2],
}

/// A fitted component.
#[derive(Debug, Clone)]
pub struct FittedComponent {
    /// The fit.
    pub fit: DisplacementFit,
    /// Names of the files that load it, in the order of the fit's deviations.
    pub files: Vec<String>,
}

impl FittedComponent {
    fn stiffness(&self) -> LayerStiffness {
        LayerStiffness {
            bedding: self.fit.bedding,
            coupling_along_x: self.fit.coupling_along_x,
            coupling_along_y: self.fit.coupling_along_y,
        }
    }
}

impl Fitted {
    fn stiffness(&self) -> [Option<LayerStiffness>; 2] {
        self.components.each_ref().map(|fitted| fitted.as_ref().map(FittedComponent::stiffness))
    }
}

/// Stiffnesses and their origin.
struct Origin {
    name: &'static str,
    stiffness: [Option<LayerStiffness>; 2],
    deviation: Option<Deviation>,
}

impl CalibrationReport {
    /// Format of the section of a case file with the stiffnesses that are known best.
    pub const SECTION: &str = "section";

    /// All stiffnesses; the last ones except the uncoupled ones are those requested.
    fn origins(&self) -> Vec<Origin> {
        let layer = |name, layer: &Layer| Origin {
            name,
            stiffness: layer.stiffness.map(Some),
            deviation: layer.deviation,
        };
        let mut origins = Vec::new();
        origins.extend(self.tabulated.iter().map(|tabulated| layer("table", tabulated)));
        if let Some(direct) = &self.direct {
            origins.push(layer("direct", &direct.layer));
            origins.push(layer("uncoupled", &direct.uncoupled));
        }
        if let Some(fitted) = &self.fitted {
            let stiffness = fitted.stiffness();
            origins.push(Origin { name: "fitted", stiffness, deviation: None });
        }
        origins
    }

    /// The stiffnesses to use.
    fn best(&self) -> [Option<LayerStiffness>; 2] {
        let layer = self.direct.map(|direct| direct.layer).or(self.tabulated);
        match (&self.fitted, layer) {
            (Some(fitted), _) => fitted.stiffness(),
            (None, Some(layer)) => layer.stiffness.map(Some),
            (None, None) => [None; 2],
        }
    }
}

impl Report for CalibrationReport {
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

    /// One row for each component of each origin of stiffnesses.
    fn csv(&self) -> Option<String> {
        let table = Table::default().with("origin", "name").with("component", "x or y");
        let mut table = table.with("bedding", "N/m^3").with("coupling", "N/m");
        table = table.with("coupling_across", "N/m");
        for Origin { name, stiffness, .. } in self.origins() {
            for (component, stiffness) in ["x", "y"].into_iter().zip(stiffness) {
                let Some(stiffness) = stiffness else { continue };
                let LayerStiffness { bedding, coupling_along_x, coupling_along_y } = stiffness;
                let numbers = [bedding, coupling_along_x, coupling_along_y];
                let numbers = numbers.map(|number| entry(number.into()));
                table.push([name, component].map(str::to_owned).into_iter().chain(numbers));
            }
        }
        Some(table.csv("couplings along and across rolling"))
    }

    fn own_files() -> &'static [OwnFile] {
        const DOC: &str = "Write the section [elasticity] of a case with the stiffnesses";
        const { &[OwnFile::new(Self::SECTION, "section", DOC)] }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        (format == Self::SECTION).then(|| snippet::snippet(self).into_bytes())
    }

    fn figure_names() -> Vec<String> {
        vec![FIGURE.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let Some(sides) = &self.sides else { return Ok(Vec::new()) };
        let svg = figure::draw(&self.title, sides).ok_or(FigureError::NoSides)?;
        Ok(vec![(FIGURE.to_owned(), svg)])
    }
}
