//! Creep curves, one or a family of them: JSON, CSV and a summary. The figure is among the figures.

mod figure;
mod json;
mod summary;

use schlupf::Status;
use schlupf::creep_curve::{Abscissa, CreepCurve, Sampling};
use schlupf::message::Message;

use crate::figures::{Drawing, FigureError};
use crate::report::Report;
use crate::table::{Table, entries, entry, quoted};

/// Name of the figure.
const FIGURE: &str = "creep_curve";

/// Creep curves over the same creepages, of cases that differ in one field.
#[derive(Debug, Clone)]
pub struct CurveFamily {
    /// Title of the case.
    pub title: String,
    /// Dotted path of the field in which the members differ; `None` for one curve.
    pub over: Option<String>,
    /// How the points are spaced.
    pub sampling: Sampling,
    /// At least one curve.
    pub members: Vec<Member>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// One curve of a family.
#[derive(Debug, Clone)]
pub struct Member {
    /// The value of the field, as it was written; `None` for one curve.
    pub value: Option<String>,
    /// What its reader must know.
    pub warnings: Vec<Message>,
    /// The curve.
    pub curve: CreepCurve,
}

impl CurveFamily {
    /// Curves with their warnings: one that all of them have once, the others with the name of
    /// their curve.
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

    /// What all curves are drawn over.
    pub fn abscissa(&self) -> Option<Abscissa> {
        self.members.first().map(|member| member.curve.path.abscissa())
    }

    /// What a member is called, such as `normal.load = 60 kN`.
    pub fn name(&self, member: &Member) -> Option<String> {
        Some(format!("{} = {}", self.over.as_ref()?, member.value.as_ref()?))
    }

    fn all_warnings(&self) -> Vec<Message> {
        let Some((first, others)) = self.members.split_first() else { return Vec::new() };
        let is_common =
            |message: &&Message| others.iter().all(|member| member.warnings.contains(message));
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

    fn summary(&self) -> String {
        summary::text(self)
    }

    /// The first column is the field in which the curves differ, if there is one; then comes the
    /// total creepage where the curves run in a fixed direction.
    fn csv(&self) -> Option<String> {
        let total = self.abscissa().filter(|a| matches!(a, Abscissa::Total { .. }));
        let mut table = Table::default();
        if let Some(over) = &self.over {
            table = table.with(over, "as given");
        }
        if let Some(total) = total {
            table = table.with(total.quantity().name(), "1");
        }
        let mut table = table.with_columns::<CreepCurve>();
        for Member { value, curve, .. } in &self.members {
            for (row, point) in curve.points.iter().enumerate() {
                let value = value.as_deref().map(quoted);
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
