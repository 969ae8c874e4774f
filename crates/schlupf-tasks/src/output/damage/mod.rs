//! Damage over a run: JSON, CSV, a summary and figures.

mod figure;
pub(crate) mod json;
mod summary;

use schlupf::Status;
use schlupf::analysis::damage::{Laws, RunDamage};
use schlupf::reporting::Message;

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues};

/// The damage of a run with its input.
#[derive(Debug, Clone)]
pub struct DamageReport {
    /// Name of the run.
    pub title: String,
    /// The laws of fatigue and wear.
    pub laws: Laws,
    /// The damage of all states that have a solution and a friction power.
    pub damage: RunDamage,
    /// The others.
    pub left_out: LeftOut,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// States of a run that have no solution or no friction power.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct LeftOut {
    /// How many.
    pub states: usize,
    /// Distance over which they hold, in m.
    pub distance: f64,
}

impl DamageReport {
    /// Format of the run, a table with a row for each state.
    pub const RUN: &str = "run";
}

impl Report for DamageReport {
    fn status(&self) -> Status {
        if self.left_out.states == 0 { Status::Converged } else { Status::NotConverged }
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

    /// The depth of wear across the profile.
    fn csv(&self) -> Option<String> {
        let note = "wheel: over the run; rail: by one passing wheel, mean over the run";
        Some(table::csv(&self.damage.profile, note))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        vec![
            ("profile", table::columns(&self.damage.profile)),
            ("run", table::columns(self.damage.points.as_slice())),
        ]
    }

    fn figure_names() -> Vec<String> {
        figure::NAMES.map(str::to_owned).to_vec()
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        Ok(figure::draw(self))
    }

    fn own_files() -> &'static [OwnFile] {
        const { &[OwnFile::new(Self::RUN, "along", "Write the run as CSV, one row for each state")] }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        let run = || table::csv(self.damage.points.as_slice(), "").into_bytes();
        (format == Self::RUN).then(run)
    }
}
