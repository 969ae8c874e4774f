//! What a handle stands for: an element with room for what it finds, and what kept it from it.

use std::path::Path;

use schlupf::Warning;
use schlupf::element::{Element, Evaluation};
use schlupf_case::{CaseErrors, CaseFile, FieldNames, Folder, Overrides};

use crate::Status;
use crate::trouble::Trouble;

/// An element with what belongs to it.
#[derive(Debug, Clone)]
pub struct Held {
    contact: Result<Contact, Trouble>,
    /// Of the last call; none where it did its work.
    pub trouble: Option<Trouble>,
}

/// An element, with room for what it finds.
#[derive(Debug, Clone)]
pub struct Contact {
    /// The element.
    pub element: Element,
    /// With derivatives.
    found: Evaluation,
    /// Without, which is less work.
    plain: Evaluation,
}

/// Where a case comes from.
pub enum Origin<'a> {
    /// A text, and the folder of the files that it names.
    Text(&'a str, &'a str),
    /// A file.
    File(&'a str),
}

impl Held {
    /// The element of a case with overrides, or why there is none.
    pub fn new(origin: &Origin<'_>, assignments: &[String]) -> Self {
        let contact = element(origin, assignments).map_err(Trouble::from).map(|element| {
            let (found, plain) = (element.evaluation(), element.evaluation_without_derivatives());
            Contact { element, found, plain }
        });
        Self { contact, trouble: None }
    }

    /// None, and why.
    pub fn failed(trouble: Trouble) -> Self {
        Self { contact: Err(trouble), trouble: None }
    }

    /// Whether there is one, as a status.
    pub fn status(&self) -> Status {
        self.contact.as_ref().map_or_else(Trouble::status, |_| Status::Found)
    }

    /// The element, or why there is none.
    pub fn contact(&mut self) -> Result<&mut Contact, Trouble> {
        self.contact.as_mut().map_err(|trouble| trouble.clone())
    }

    /// What the method of its case neglects, a line for each warning.
    pub fn warnings(&self) -> String {
        let warnings = self.contact.iter().flat_map(|contact| contact.element.warnings());
        warnings.map(line).collect::<Vec<_>>().join("\n")
    }

    /// What is wrong: with the case, or else with the last call.
    pub fn message(&self) -> String {
        let trouble = self.contact.as_ref().err().or(self.trouble.as_ref());
        trouble.map(ToString::to_string).unwrap_or_default()
    }
}

fn element(origin: &Origin<'_>, assignments: &[String]) -> Result<Element, CaseErrors> {
    let set = Overrides { option: "override", assignments };
    let file = match origin {
        Origin::Text(text, folder) => {
            CaseFile::from_str(text, "the case", Folder::new(*folder), set)?
        }
        Origin::File(path) => CaseFile::from_path(Path::new(path), set)?,
    };
    Ok(file.pose(&schlupf::unwatched)?.element()?)
}

/// A warning with its code, on a line.
pub fn line(warning: &Warning) -> String {
    format!("{}: {}", warning.code(), warning.text(&FieldNames::CASE))
}

impl Contact {
    /// Numbers of inputs, outputs and states.
    pub fn counts(&self) -> [usize; 3] {
        let Self { element, .. } = self;
        [element.inputs().len(), element.outputs().len(), element.states().len()]
    }

    /// Number of derivatives.
    pub fn derivatives(&self) -> usize {
        self.found.derivatives.len()
    }

    /// Finds forces and what belongs to them, with derivatives or without.
    pub fn evaluate(
        &mut self,
        (inputs, states): (&[f64], &[f64]),
        with_derivatives: bool,
    ) -> (Result<Status, Trouble>, &Evaluation) {
        let found = if with_derivatives { &mut self.found } else { &mut self.plain };
        let status = self.element.evaluate(inputs, states, found).into();
        (outcome(&self.element, status, inputs, states), found)
    }

    /// Lets time pass (in s) with constant inputs.
    pub fn advance(
        &self,
        inputs: &[f64],
        states: &mut [f64],
        duration: f64,
    ) -> Result<Status, Trouble> {
        if !duration.is_finite() || duration < 0.0 {
            return Err(Trouble::Duration(duration));
        }
        let status = self.element.advance(inputs, states, duration).into();
        outcome(&self.element, status, inputs, states)
    }
}

/// A status with what there is to say about it.
fn outcome(
    element: &Element,
    status: Status,
    inputs: &[f64],
    states: &[f64],
) -> Result<Status, Trouble> {
    if status.has_outputs() {
        return Ok(status);
    }
    let variables = element.inputs().iter().chain(element.states()).map(|signal| signal.quantity);
    let mut given = variables.zip(inputs.iter().chain(states));
    let trouble = given.find(|(_, value)| !value.is_finite());
    Err(match trouble.filter(|_| status == Status::NotFinite) {
        Some((quantity, value)) => Trouble::Value { quantity, value: *value },
        None => Trouble::Status(status),
    })
}
