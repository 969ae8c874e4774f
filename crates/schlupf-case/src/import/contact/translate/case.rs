//! A case that is being translated: what is written of it, and what cannot be.

use std::sync::Arc;

use crate::{CaseError, FieldPath, Source};

use crate::import::Notice;
use crate::import::contact::given::{At, Given};
use crate::import::document::Document;

/// What is written of a case, and what is not available.
#[derive(Debug)]
pub struct Translation {
    source: Arc<Source>,
    /// The case file.
    pub document: Document,
    /// Why it cannot be written.
    pub errors: Vec<CaseError>,
    /// What its users should know, with the value that it is about.
    pub notices: Vec<(Notice, At)>,
    /// Where the values of fields stand.
    pub places: Vec<(FieldPath, At)>,
}

impl Translation {
    /// Nothing yet.
    pub fn new(source: &Arc<Source>) -> Self {
        Self {
            source: Arc::clone(source),
            document: Document::default(),
            errors: Vec::new(),
            notices: Vec::new(),
            places: Vec::new(),
        }
    }

    /// The text of the input file.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    /// A value that is not available: `what` completes the sentence that begins with it.
    pub fn refuse(&mut self, given: Given, what: &str, help: impl Into<String>) {
        let value = crate::import::document::number(given.value);
        let message = format!("{} = {value}: {what}", given.name);
        let place = given.at.place(&self.source);
        let help: String = help.into();
        let help = Some(help).filter(|help| !help.is_empty());
        self.errors.push(CaseError::new(given.name, message, place).help(help));
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

    /// A field with the number of a value, times a factor, and its unit.
    pub fn quantity(&mut self, path: FieldPath, given: Given, (factor, unit): (f64, &str)) {
        self.document.quantity(path, factor * given.value, unit);
        self.stands(path, given);
    }

    /// A field that follows from a value.
    pub fn stands(&mut self, path: FieldPath, given: Given) {
        self.places.push((path, given.at));
    }

    /// Something that users of the case should know, which the command prints.
    pub fn notice(&mut self, notice: Notice, given: Given) {
        self.notices.push((notice, given.at));
    }

    /// A sentence for the head of the case file, which changes nothing.
    pub fn remark(&mut self, sentence: impl Into<String>) {
        self.document.comments.push(sentence.into());
    }
}
