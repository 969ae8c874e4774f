//! The interface shared by all commands: a result that is written in several forms.

use std::any::Any;

use schlupf::Status;
use schlupf::reporting::Message;

use crate::output::figures::{self, Drawing, Figure, FigureError};
use crate::output::summary::Summary;
use crate::output::table::ColumnValues;

/// A result with all its output forms.
///
/// ```
/// use schlupf::{solver, Options, Problem, unwatched};
/// use schlupf_tasks::output::{Report, solution::SolutionReport};
///
/// let problem = Problem::builder().creepage_x(0.003).build()?;
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let solution = solver::solve(&problem, &options, &unwatched)?;
/// let (title, warnings) = ("braking".to_owned(), Vec::new());
/// let report = SolutionReport { title, contact_law: None, solution, wheel: None, warnings };
/// assert!(report.summary().to_string().starts_with("braking"));
/// assert!(report.csv().is_some_and(|table| table.contains("traction_x")));
/// # Ok::<(), schlupf::Error>(())
/// ```
pub trait Report: Any + Send + Sync {
    /// Whether the solution converged.
    fn status(&self) -> Status;

    /// Warnings for whoever uses the results.
    fn warnings(&self) -> &[Message];

    /// For other programs; an unknown number is `null`.
    fn json(&self) -> String;

    /// Summary in engineering units, for people.
    fn summary(&self) -> Summary;

    /// As a table: a comment line (`#`) with the units, a header line, then one row per record.
    /// Every number has enough digits to be read back exactly; unknown values are empty.
    fn csv(&self) -> Option<String> {
        None
    }

    /// All its tables by name, as arrays; one name has several where there are several curves or
    /// lines of a kind.
    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        Vec::new()
    }

    /// The files that only this kind of result has.
    fn own_files() -> &'static [OwnFile]
    where
        Self: Sized,
    {
        &[]
    }

    /// Names of all possible figures.
    fn figure_names() -> Vec<String>
    where
        Self: Sized;

    /// The available drawings.
    fn drawings(&self) -> Result<Vec<Drawing>, FigureError>;

    /// The same as rendered figures.
    fn figures(&self) -> Result<Vec<Figure>, FigureError> {
        figures::render(self.drawings()?)
    }

    /// The bytes of a file specific to this kind of result, by the name of its format.
    fn own_file(&self, _format: &str) -> Option<Vec<u8>> {
        None
    }
}

/// A file that only one kind of result has.
#[derive(Debug, Clone, Copy)]
pub struct OwnFile {
    /// The name of its format.
    pub format: &'static str,
    /// The option of the command that names it, without hyphens before it.
    pub option: &'static str,
    /// What is in it, as an imperative sentence.
    pub doc: &'static str,
    /// The file of the request that it may replace.
    pub replaces: Option<&'static str>,
    /// Whether functions want it every time, because what they return has what is in it.
    pub is_part: bool,
}

impl OwnFile {
    pub(crate) const fn new(format: &'static str, option: &'static str, doc: &'static str) -> Self {
        Self { format, option, doc, replaces: None, is_part: false }
    }

    /// Has functions want it every time.
    pub(crate) const fn part(self) -> Self {
        Self { is_part: true, ..self }
    }
}

/// The reasons why results did not converge, one per line, to be shown next to their status.
pub(crate) fn reasons(warnings: &[Message]) -> impl Iterator<Item = &str> {
    let reasons = warnings.iter().filter(|message| message.is_of_convergence());
    reasons.map(|message| message.text.as_str())
}

/// A status in words.
pub(crate) fn verdict(status: Status) -> &'static str {
    match status {
        Status::Converged => "converged",
        Status::NotConverged => "NOT CONVERGED: do not trust these numbers",
    }
}
