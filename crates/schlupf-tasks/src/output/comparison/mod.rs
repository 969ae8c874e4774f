//! Several methods on the same case: JSON, CSV and a summary. The figure is among the figures.

mod figure;
mod json;
mod summary;

use schlupf::reporting::{Column, Message, Record, Value, columns};
use schlupf::{Solution, Status};

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::Report;
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues, Table, entries, quoted};

/// Name of the figure.
const FIGURE: &str = "comparison";

/// Results of several methods for one case.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Title of the case.
    pub title: String,
    /// At least one, and at least one with an answer.
    pub entries: Vec<Entry>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// A method and its result for the case.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Display name, such as `FASTSIM`.
    pub name: &'static str,
    /// The method, as named in case files.
    pub method: &'static str,
    /// Elasticity model of the full method, as named in case files.
    pub elasticity: Option<&'static str>,
    /// Method of the normal contact, as named in case files, if it is not that of the case.
    pub normal: Option<&'static str>,
    /// The answer, or why there is none.
    pub answer: Result<Answer, String>,
}

/// Result of one method for the case.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The result.
    pub solution: Solution,
    /// Time from a cold start, set-up included, in s.
    pub time: f64,
    /// Time to compute the forces again without set-up, in s.
    pub time_again: f64,
}

impl Entry {
    /// Whether it has an answer that did not converge.
    pub fn is_unconverged(&self) -> bool {
        self.answer.as_ref().is_ok_and(|answer| answer.solution.status != Status::Converged)
    }

    /// The reason why there is no answer, if there is none.
    pub fn reason(&self) -> Option<&str> {
        self.answer.as_ref().err().map(String::as_str)
    }

    /// `converged`, `not-converged` or `not-available`.
    fn status(&self) -> &'static str {
        self.answer.as_ref().map_or("not-available", |answer| answer.solution.status.name())
    }
}

impl Comparison {
    /// All answers.
    pub fn answers(&self) -> impl Iterator<Item = &Answer> {
        self.entries.iter().filter_map(|entry| entry.answer.as_ref().ok())
    }

    /// Whether some have a normal contact of their own.
    fn has_normal_methods(&self) -> bool {
        self.entries.iter().any(|entry| entry.normal.is_some())
    }

    /// A number of the answer of an entry (in its unit, or dimensionless), if it has one.
    fn of<N: Into<Value>>(&self, row: usize, number: fn(&Answer) -> N) -> Value {
        self.entries[row].answer.as_ref().map_or(Value::Unknown, |answer| number(answer).into())
    }
}

/// Results of the methods, forces on the wheel.
impl Record for Comparison {
    fn rows(&self) -> usize {
        self.entries.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Comparison:
        ForceX => |methods, k| methods.of(k, |answer| answer.solution.force.x),
        ForceY => |methods, k| methods.of(k, |answer| answer.solution.force.y),
        MomentZ => |methods, k| methods.of(k, |answer| answer.solution.force.moment_z),
        NormalisedX => |methods, k| methods.of(k, |answer| answer.solution.normalised.x),
        NormalisedY => |methods, k| methods.of(k, |answer| answer.solution.normalised.y),
        NormalisedMomentZ => |methods, k| {
            methods.of(k, |answer| answer.solution.normalised.moment_z)
        },
        TractionCoefficient => |methods, k| {
            methods.of(k, |answer| answer.solution.traction_coefficient)
        },
        CreepPower => |methods, k| {
            methods.of(k, |answer| answer.solution.power.map(|power| power.creep))
        },
        MaxRise => |methods, k| {
            methods.of(k, |answer| answer.solution.temperature.map(|largest| largest.max_rise))
        },
        PeakPressure => |methods, k| methods.of(k, |answer| answer.solution.normal.peak_pressure),
        Approach => |methods, k| methods.of(k, |answer| answer.solution.normal.approach),
        ComputingTime "time" => |methods, k| methods.of(k, |answer| answer.time),
        ComputingTimeAgain "time_again" => |methods, k| methods.of(k, |answer| answer.time_again),
    };
}

impl Report for Comparison {
    fn status(&self) -> Status {
        let is_converged = !self.entries.iter().any(Entry::is_unconverged);
        if is_converged { Status::Converged } else { Status::NotConverged }
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

    fn csv(&self) -> Option<String> {
        let names = ["method", "elasticity", "normal_method"];
        let mut table = names
            .into_iter()
            .fold(Table::default(), |table, name| table.with(name, "name"))
            .with_columns::<Self>()
            .with("status", "converged or not-converged or not-available")
            .with("reason", "text");
        for (row, entry) in self.entries.iter().enumerate() {
            let [elasticity, normal] =
                [entry.elasticity, entry.normal].map(Option::unwrap_or_default);
            let names = [entry.method, elasticity, normal].map(str::to_owned);
            let reason = entry.reason().map(quoted).unwrap_or_default();
            let end = [entry.status().to_owned(), reason];
            table.push(names.into_iter().chain(entries(self, row)).chain(end));
        }
        Some(table.csv("forces on the wheel"))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        vec![("methods", table::columns(self))]
    }

    fn figure_names() -> Vec<String> {
        vec![FIGURE.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let svg = figure::draw(self).ok_or(FigureError::NothingToCompare)?;
        Ok(vec![(FIGURE.to_owned(), svg)])
    }
}
