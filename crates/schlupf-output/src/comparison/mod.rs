//! Several methods on the same case: JSON, CSV and a summary. The figure is among the figures.

pub mod csv;
pub mod json;
pub mod summary;

use schlupf::{Solution, Status};

/// What several methods make of one case.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Title of the case.
    pub title: String,
    /// At least one.
    pub entries: Vec<Entry>,
}

/// What one method makes of it.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Name for people, such as `FASTSIM`.
    pub name: &'static str,
    /// Model of elasticity of the full method, as case files name it.
    pub elasticity: Option<&'static str>,
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
        self.solution.warnings.iter().map(|text| format!("{}: {text}", self.name))
    }

    /// Whether to trust it.
    pub fn is_converged(&self) -> bool {
        self.solution.status == Status::Converged
    }
}

impl Comparison {
    /// Whether every method converged.
    pub fn is_converged(&self) -> bool {
        self.entries.iter().all(Entry::is_converged)
    }
}
