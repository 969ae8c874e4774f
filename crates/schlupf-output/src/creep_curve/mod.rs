//! Creep curves, one or a family of them: JSON, CSV and a summary. The figure is among the figures.

mod figure;
mod json;
mod summary;

use schlupf::Status;
use schlupf::creep_curve::{Abscissa, CreepCurve, Sampling};
use schlupf::message::Message;

use crate::figures::{Drawing, FigureError};
use crate::report::Report;
use crate::summary::Summary;
use crate::table::{Table, entries, entry, quoted};

/// Name of the figure.
const FIGURE: &str = "creep_curve";

/// Creep curves over the same creepages, for cases that differ in one field.
#[derive(Debug, Clone)]
pub struct CurveFamily {
    /// Title of the case.
    pub title: String,
    /// Dotted path of the field in which the members differ; `None` for a single curve.
    pub over: Option<String>,
    /// Spacing of the points.
    pub sampling: Sampling,
    /// At least one curve.
    pub members: Vec<Member>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// One curve of a family.
#[derive(Debug, Clone)]
pub struct Member {
    /// The value of the field, as written; `None` for a single curve.
    pub value: Option<String>,
    /// The same as a number with its SI unit (temperatures in degC), which may be empty; `None` for
    /// what is no number.
    pub number: Option<(f64, &'static str)>,
    /// Warnings for whoever uses the curve.
    pub warnings: Vec<Message>,
    /// The curve.
    pub curve: CreepCurve,
}

impl CurveFamily {
    /// Curves with their warnings: a warning common to all is listed once, the others with the name
    /// of their curve.
    pub fn new(
        title: String,
        over: Option<String>,
        sampling: Sampling,
        members: Vec<Member>,
    ) -> Self {
        let mut family = Self { title, over, sampling, members, warnings: Vec::new() };
        family.warnings = family.all_warnings();
        family
    }

    /// The common abscissa of all curves.
    pub fn abscissa(&self) -> Option<Abscissa> {
        self.members.first().map(|member| member.curve.path.abscissa())
    }

    /// Name of a member, such as `normal.load = 60 kN`.
    pub fn name(&self, member: &Member) -> Option<String> {
        Some(format!("{} = {}", self.over.as_ref()?, member.value.as_ref()?))
    }

    fn all_warnings(&self) -> Vec<Message> {
        let Some((first, others)) = self.members.split_first() else { return Vec::new() };
        // Points that did not converge are those of one curve, even where as many are those of
        // another.
        let is_of_one = |message: &Message| !others.is_empty() && message.is_of_convergence();
        let is_common = |message: &&Message| {
            !is_of_one(message) && others.iter().all(|member| member.warnings.contains(message))
        };
        let common: Vec<Message> = first.warnings.iter().filter(is_common).cloned().collect();
        let own = self.members.iter().flat_map(|member| {
            let own = member.warnings.iter().filter(|message| !common.contains(message)).cloned();
            own.map(|message| match self.name(member) {
                Some(name) => message.about(&name),
                None => message,
            })
        });
        let own: Vec<Message> = own.collect();
        common.into_iter().chain(own).collect()
    }
}

impl Report for CurveFamily {
    fn status(&self) -> Status {
        let is_converged = self.members.iter().all(|member| member.curve.is_converged());
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

    /// The first column is the field in which the curves differ, if there is one, in its SI unit if
    /// it is a number, otherwise as given; then follows the
    /// total creepage if the curves have a fixed direction.
    fn csv(&self) -> Option<String> {
        let total = self.abscissa().filter(|a| matches!(a, Abscissa::Total { .. }));
        let mut table = Table::default();
        let numbers: Option<Vec<_>> = self.members.iter().map(|member| member.number).collect();
        if let Some(over) = &self.over {
            let unit = numbers.as_ref().and_then(|numbers| Some(numbers.first()?.1));
            table = table.with(
                over,
                unit.map_or("as given", |unit| if unit.is_empty() { "1" } else { unit }),
            );
        }
        if let Some(total) = total {
            table = table.with(total.quantity().name(), "1");
        }
        let mut table = table.with_columns::<CreepCurve>();
        for Member { value, number, curve, .. } in &self.members {
            for (row, point) in curve.points.iter().enumerate() {
                let number = number.filter(|_| numbers.is_some());
                let number = number.map(|(number, _)| entry(number.into()));
                let value = number.or_else(|| value.as_deref().map(quoted));
                let total = total.map(|_| entry(point.abscissa.into()));
                table.push(value.into_iter().chain(total).chain(entries(curve, row)));
            }
        }
        Some(table.csv("forces on the wheel"))
    }

    fn figure_names() -> Vec<String> {
        vec![FIGURE.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let svg = figure::draw(self).ok_or(FigureError::NoCurve)?;
        Ok(vec![(FIGURE.to_owned(), svg)])
    }
}
