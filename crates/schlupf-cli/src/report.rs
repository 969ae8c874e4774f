//! Errors on standard error, with the line they stand in.

use std::fmt;
use std::io::{IsTerminal, Write, stderr};
use std::ops::Range;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode,
};
use schlupf::Status;
use schlupf::reporting::Message;
use schlupf_case::{CaseError, Place, Source};

use crate::failure::Failure;

/// Prints a failure. Nothing is left to do if that fails, too.
pub fn print(failure: &Failure) {
    let text = match failure {
        Failure::Case(errors) => {
            let reports: Vec<String> =
                errors.iter().map(|error| render(&Report::new(error))).collect();
            reports.join("\n")
        }
        other => render(&Report::plain(other.to_string())),
    };
    let _ = stderr().write_all(text.as_bytes());
}

/// Prints warnings, and that results did not converge where none of them says so.
pub fn warn_all(messages: &[Message], status: Status) {
    messages.iter().for_each(warn);
    if status == Status::NotConverged && !messages.iter().any(Message::is_of_convergence) {
        let _ = writeln!(stderr(), "warning: not converged: do not trust these numbers");
    }
}

/// Prints a warning.
pub fn warn(message: &Message) {
    let what = if message.is_of_convergence() { "not converged: " } else { "" };
    let _ = writeln!(stderr(), "warning: {what}{}", message.text);
}

/// With colours and lines on a terminal, else in plain characters and without line breaks of its
/// own.
fn render(report: &Report) -> String {
    let handler = if stderr().is_terminal() {
        GraphicalReportHandler::new()
    } else {
        let mut theme = GraphicalTheme::none();
        "error:".clone_into(&mut theme.characters.error);
        GraphicalReportHandler::new_themed(theme).with_width(10_000).with_wrap_lines(false)
    };
    let mut text = String::new();
    match handler.with_links(false).render_report(&mut text, report) {
        // As the argument parser writes it.
        Ok(()) => text.strip_prefix("  error:").map(|rest| format!("error:{rest}")).unwrap_or(text),
        Err(fmt::Error) => format!("error: {report}\n"),
    }
}

/// Whether the lines of some bytes, with one before and one after, are few and short enough to be
/// shown.
fn is_quotable(source: &Source, span: &Range<usize>) -> bool {
    const MOST_LINES: usize = 12;
    const LONGEST: usize = 200;
    let lines = [span.start, span.end].map(|byte| source.position(byte).0);
    let lines = lines[0].saturating_sub(1).max(1)..=lines[1] + 1;
    lines.clone().count() <= MOST_LINES
        && lines.map(|line| source.line(line).len()).all(|length| length <= LONGEST)
}

/// A case error in miette's terms.
#[derive(Debug)]
struct Report {
    message: String,
    help: Option<String>,
    source: Option<NamedSource<String>>,
    labels: Vec<LabeledSpan>,
}

impl Report {
    fn new(error: &CaseError) -> Self {
        let message = format!("{}: {}", error.place, error.message);
        let help = error.help.clone().map(String::from);
        let (source, labels) = match &error.place {
            Place::Text { source, span } if is_quotable(source, span) => (
                Some(NamedSource::new(&source.name, source.text.clone())),
                vec![LabeledSpan::new_with_span(None, span.clone())],
            ),
            _ => (None, Vec::new()),
        };
        Self { message, help, source, labels }
    }

    fn plain(message: String) -> Self {
        Self { message, help: None, source: None, labels: Vec::new() }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Report {}

impl Diagnostic for Report {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as _)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source as _)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}
