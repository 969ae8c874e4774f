//! Wear, fatigue and melting per wheel passage: JSON, CSV, a summary and figures.

mod figure;
mod json;
mod summary;

use schlupf::analysis::damage::{Laws, Passage};
use schlupf::reporting::Message;
use schlupf::{Solution, Status};

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues};

/// The damage per wheel passage with its input.
#[derive(Debug, Clone)]
pub struct WearReport {
    /// Title of the case.
    pub title: String,
    /// The laws of fatigue and wear.
    pub laws: Laws,
    /// What they give.
    pub passage: Passage,
    /// The solution that it is of.
    pub solution: Solution,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

impl WearReport {
    /// Format of the depths across the profile, a table with a row for each row of cells.
    pub const PROFILE: &str = "profile";
}

impl Report for WearReport {
    fn status(&self) -> Status {
        self.solution.status
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

    /// Wear rates in the cells; none if the method has no fields.
    fn csv(&self) -> Option<String> {
        let wear = self.passage.wear.as_ref()?;
        let note = "archard: depth per distance in the contact; energy: mass per area and distance";
        Some(table::csv(&wear.cells, note))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        let wear = self.passage.wear.iter();
        wear.flat_map(|wear| {
            [("profile", table::columns(&wear.profile)), ("cells", table::columns(&wear.cells))]
        })
        .collect()
    }

    fn figure_names() -> Vec<String> {
        figure::NAMES.map(str::to_owned).to_vec()
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        Ok(figure::draw(self))
    }

    fn own_files() -> &'static [OwnFile] {
        const {
            &[OwnFile::new(
                Self::PROFILE,
                "profile",
                "Write the depths across the profile as CSV, one row for each row of cells",
            )]
        }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        let wear = self.passage.wear.as_ref().filter(|_| format == Self::PROFILE)?;
        let note =
            "depth per wheel passage: of the rail by one wheel, of the wheel in a revolution";
        Some(table::csv(&wear.profile, note).into_bytes())
    }
}
