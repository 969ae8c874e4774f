//! Rows of a batch that are solved.

use std::path::Path;

use schlupf::reporting::{Message, Tally};

use crate::study::error::StudyError;
use crate::study::plan::Study;
use crate::study::table::{Cells, Rows};

/// Rows of a batch, to be kept by a [`Run`](crate::study::run::Run), with the fields of their cells
/// where the study keeps them.
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    pub(crate) rows: Rows,
    pub(crate) fields: Option<Rows>,
    /// Warnings by row; none where the rows come from a text.
    pub(crate) warnings: Tally<Message, usize>,
}

impl Solved {
    /// The rows as text, from which [`Self::from_text`] makes them again.
    ///
    /// # Errors
    /// A study that keeps fields, which are too large to be sent.
    pub fn to_text(&self) -> Result<String, StudyError> {
        if self.fields.is_some() {
            return Err(no_fields());
        }
        let mut bytes = Vec::new();
        let fail = |cause| StudyError::file(Path::new("a batch"), cause);
        crate::study::table::write_rows(&mut bytes, &self.rows).map_err(fail)?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// The rows of a batch of a study from their text.
    ///
    /// # Errors
    /// A text that is not that of the batch.
    pub fn from_text(study: &Study, batch: usize, text: &str) -> Result<Self, StudyError> {
        let contents = study.contents([1, 1]);
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
        let wanted = contents.rows_of(batch).len();
        let rows = crate::study::table::read_rows(&mut reader, &contents.columns, wanted);
        let wrong = |reason: String| StudyError::table(Path::new("a batch"), reason);
        let rows = rows.map_err(wrong)?;
        if rows.first().map_or(0, Cells::len) != wanted {
            return Err(wrong(format!("it should have {wanted} rows")));
        }
        Ok(Self { rows, fields: None, warnings: Tally::default() })
    }
}

/// Why rows with fields are not sent.
pub(crate) fn no_fields() -> StudyError {
    let reason = "fields stay on the machine that solves them: divide the study into shards";
    StudyError::table(Path::new("[fields]"), reason)
}
