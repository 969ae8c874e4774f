//! A case that is being translated: what is written of it, and what cannot be.

use std::sync::Arc;

use schlupf_case::{CaseError, Place, Source};

use crate::contact::given::Given;
use crate::document::Document;
use schlupf::message::shortened;

/// What is written of a case, and what is not available.
#[derive(Debug)]
pub struct Translation {
    source: Arc<Source>,
    /// The case file.
    pub document: Document,
    /// Why it cannot be written.
    pub errors: Vec<CaseError>,
    /// Lines of fields that name a file.
    pub lines: Vec<(&'static str, usize)>,
}

impl Translation {
    /// Nothing yet.
    pub fn new(source: &Arc<Source>) -> Self {
        let (document, errors, lines) = (Document::default(), Vec::new(), Vec::new());
        Self { source: Arc::clone(source), document, errors, lines }
    }

    /// The text of the input file.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    /// A value that is not available: `what` completes the sentence that begins with it.
    pub fn refuse(&mut self, given: Given, what: &str, help: impl Into<String>) {
        let value = crate::document::number(given.value);
        let message = format!("{} = {value}: {what}", given.name);
        let place = Place::line(&self.source, given.line);
        let help: String = help.into();
        let help = Some(help).filter(|help| !help.is_empty());
        self.errors.push(CaseError::new(given.name, message, place).help(help));
    }

    /// The same of text.
    pub fn refuse_text(&mut self, given: Given, text: &str, what: &str) {
        let message = format!("{} = '{}': {what}", given.name, shortened(text));
        let place = Place::line(&self.source, given.line);
        self.errors.push(CaseError::new(given.name, message, place));
    }

    /// Refuses a value unless it is zero.
    pub fn refuse_unless_zero(&mut self, given: Given, what: &str, help: &str) {
        if given.value != 0.0 {
            self.refuse(given, what, help);
        }
    }

    /// Something that a case must have, but neither it nor an earlier one gives.
    pub fn miss(&mut self, digit: Given, what: &str) {
        let help = "the first case of a sequence must give it";
        self.refuse(
            digit,
            &format!("{what} must be given, but neither this case nor one before it does"),
            help,
        );
    }

    /// A sentence for the head of the case file.
    pub fn remark(&mut self, sentence: impl Into<String>) {
        self.document.comments.push(sentence.into());
    }
}
