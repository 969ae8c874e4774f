//! The solution of a case: JSON, CSV, VTK, a summary and figures.

mod summary;
pub(crate) mod wheel;

use std::sync::Arc;

use schlupf::reporting::Message;
use schlupf::wheel_rail::WheelSolution;
use schlupf::{Solution, Status};

use crate::output::contact_law::ContactLaw;
use crate::output::figures::{self, Drawing, FigureError};
use crate::output::json::{self, Document};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues};
use crate::output::vtk;

/// A solution with its input.
#[derive(Debug, Clone)]
pub struct SolutionReport {
    /// Title of the case.
    pub title: String,
    /// k_c and its origin; `None` for a fast method, which has no contact law.
    pub contact_law: Option<ContactLaw>,
    /// The solution; that of the contact with the largest normal force where a wheel has several.
    pub solution: Solution,
    /// The wheel with all its contacts, if the case has profiles.
    pub wheel: Option<Arc<WheelSolution>>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

impl SolutionReport {
    /// Format of the fields for `ParaView`.
    pub const VTK: &str = "vtk";
    /// Format of the history, a table with a row for each time step.
    pub const HISTORY: &str = "history";
    /// Format of the final state.
    pub const STATE: &str = "state";

    /// Those of all contacts of a wheel, or the only one.
    pub fn solutions(&self) -> Vec<&Solution> {
        match self.wheel.as_deref() {
            Some(wheel) if !wheel.contacts.is_empty() => {
                wheel.contacts.iter().map(|contact| &contact.solution).collect()
            }
            _ => vec![&self.solution],
        }
    }
}

impl Report for SolutionReport {
    fn status(&self) -> Status {
        self.wheel.as_ref().map_or(self.solution.status, |wheel| wheel.status())
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        let document = Document::new(&self.title, &self.solution, &self.warnings);
        let document = document.with_law(self.contact_law.as_ref());
        json::text(&document.with_wheel(self.wheel.as_deref(), self.status()))
    }

    fn summary(&self) -> Summary {
        summary::text(self)
    }

    fn csv(&self) -> Option<String> {
        let note = "tractions on the wheel, positions are centroids of the covered part of a cell";
        Some(table::csv(&self.solution.fields, note))
    }

    /// Fields and scalars, of each contact of a wheel; the wheel and its contacts; time steps, and
    /// the fields at some of them.
    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        let mut tables = Vec::new();
        for solution in self.solutions() {
            tables.push(("fields", table::columns(&solution.fields)));
            tables.push(("solution", table::columns(solution)));
        }
        if let Some(wheel) = self.wheel.as_deref() {
            tables.push(("wheel", table::columns(wheel)));
            tables.extend(wheel.contacts.iter().map(|of| ("contact", table::columns(of))));
        }
        let frames = self.solution.field_history.iter();
        tables.extend(frames.map(|at| ("frame", table::columns(&at.fields))));
        if !self.solution.history.is_empty() {
            tables.push(("history", table::columns(self.solution.history.as_slice())));
        }
        tables
    }

    fn figure_names() -> Vec<String> {
        figures::names()
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        if self.solution.fields.is_empty() {
            return Ok(Vec::new());
        }
        figures::drawings(&self.title, &self.solution)
    }

    fn own_files() -> &'static [OwnFile] {
        const {
            &[
                OwnFile::new(Self::VTK, "vtk", "Write the fields as a VTK file"),
                OwnFile::new(
                    Self::HISTORY,
                    "history",
                    "Write the history as CSV, one row for each time step",
                ),
                OwnFile {
                    replaces: Some("initial_state"),
                    ..OwnFile::new(
                        Self::STATE,
                        "final-state",
                        "Write the final state, from which another run may start",
                    )
                },
            ]
        }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        match format {
            Self::VTK => Some(vtk::structured_points(&self.title, &self.solution)),
            Self::HISTORY => {
                let note = "forces on the wheel";
                Some(table::csv(self.solution.history.as_slice(), note).into_bytes())
            }
            Self::STATE => serde_json::to_vec(&self.solution.state).ok(),
            _ => None,
        }
    }
}
