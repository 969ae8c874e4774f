//! Several methods on the same case: JSON, CSV and a summary. The figure is among the figures.

pub mod csv;
pub mod json;
pub mod summary;

use schlupf::{Solution, Status};

use crate::json::status;

/// What several methods make of one case.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Title of the case.
    pub title: String,
    /// At least one, and at least one with an answer.
    pub entries: Vec<Entry>,
}

/// A method, and what it makes of the case.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Name for people, such as `FASTSIM`.
    pub name: &'static str,
    /// The method, as case files name it.
    pub method: &'static str,
    /// Model of elasticity of the full method, as case files name it.
    pub elasticity: Option<&'static str>,
    /// The answer, or why there is none.
    pub answer: Result<Answer, String>,
}

/// What one method makes of the case.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The result.
    pub solution: Solution,
    /// How long it took from nothing, set-up included, in s.
    pub time: f64,
    /// How long the forces take once more with the set-up there, in s.
    pub time_again: f64,
}

impl Entry {
    /// What its number needs to be read, one entry a warning.
    pub fn warnings(&self) -> impl Iterator<Item = String> + use<'_> {
        let answer = self.answer.iter();
        answer.flat_map(|a| &a.solution.warnings).map(|text| format!("{}: {text}", self.name))
    }

    /// Whether it has an answer that did not converge.
    pub fn is_unconverged(&self) -> bool {
        self.answer.as_ref().is_ok_and(|answer| answer.solution.status != Status::Converged)
    }

    /// Why there is no answer, if there is none.
    pub fn reason(&self) -> Option<&str> {
        self.answer.as_ref().err().map(String::as_str)
    }

    /// `converged`, `not-converged` or `not-available`.
    fn status(&self) -> &'static str {
        self.answer.as_ref().map_or("not-available", |answer| status(answer.solution.status))
    }
}

impl Comparison {
    /// All answers.
    pub fn answers(&self) -> impl Iterator<Item = &Answer> {
        self.entries.iter().filter_map(|entry| entry.answer.as_ref().ok())
    }

    /// Whether every answer converged.
    pub fn is_converged(&self) -> bool {
        !self.entries.iter().any(Entry::is_unconverged)
    }
}
