//! Creep curves, one or a family of them, or one over two fields: JSON, CSV, a summary and figures.

mod figure;
mod json;
mod map;
mod map_figure;
mod summary;

use schlupf::Status;
use schlupf::analysis::creep_curve::{Abscissa, CreepCurve, VariedForce};
use schlupf::reporting::{Column, Message, Record};

use crate::output::figures::{Drawing, FigureError, marks};
use crate::output::report::Report;
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues, Table, entries, entry, quoted};

#[cfg(feature = "fitting")]
pub(in crate::output) use figure::axis;
pub use map::{Axis, CreepMap, MapColumn};

/// Name of the figure of the curves.
const FIGURE: &str = "creep_curve";

/// Creep curves over the same creepages, for cases that differ in one field or two.
#[derive(Debug, Clone)]
pub struct CurveFamily {
    /// Title of the case.
    pub title: String,
    /// Dotted paths of the fields in which the members differ, two at most; none for a single
    /// curve.
    pub over: Vec<String>,
    /// Spacing of the points.
    pub spacing: &'static str,
    /// At least one curve.
    pub members: Vec<Member>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// One curve of a family.
#[derive(Debug, Clone)]
pub struct Member {
    /// The values of the fields; none for a single curve.
    pub values: Vec<FieldValue>,
    /// Warnings for whoever uses the curve.
    pub warnings: Vec<Message>,
    /// The curve.
    pub curve: CreepCurve,
}

/// A value of a field.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldValue {
    /// As written.
    pub text: String,
    /// As a number with its SI unit (temperatures in degC), which may be empty; `None` for what is
    /// no number.
    pub number: Option<(f64, &'static str)>,
}

impl CurveFamily {
    /// The spacing of points that are given, each for itself.
    pub const GIVEN: &str = "given";

    /// Curves with their warnings: a warning common to all is listed once, the others with the name
    /// of their curve.
    pub fn new(
        title: String,
        over: Vec<String>,
        spacing: &'static str,
        members: Vec<Member>,
    ) -> Self {
        let mut family = Self { title, over, spacing, members, warnings: Vec::new() };
        family.warnings = family.all_warnings();
        family
    }

    /// The creepage along all curves; none if a force is.
    pub fn abscissa(&self) -> Option<Abscissa> {
        self.members.first().and_then(|member| member.curve.path.abscissa())
    }

    /// The prescribed force along all curves; none if a creepage is.
    pub fn force(&self) -> Option<VariedForce> {
        self.members.first().and_then(|member| member.curve.path.force())
    }

    /// Name of a member, such as `normal.load = 60 kN`.
    pub fn name(&self, member: &Member) -> Option<String> {
        let fields = self.over.iter().zip(&member.values);
        let parts: Vec<String> =
            fields.map(|(field, value)| format!("{field} = {}", value.text)).collect();
        (!parts.is_empty()).then(|| parts.join(", "))
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

/// A field in words: `kinematics.speed` is the speed, and an underscore is markup in labels.
fn words(field: &str) -> String {
    let name = field.trim_start_matches("kinematics.").trim_start_matches("normal.");
    name.replace(['.', '_'], " ")
}

impl FieldValue {
    /// As a legend shows it: a number with four digits, and its unit as written.
    fn short(&self) -> String {
        let text = self.text.trim_matches('"');
        let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)));
        let (number, unit) = text.split_at(end.unwrap_or(text.len()));
        match number.parse::<f64>() {
            Ok(number) if number.is_finite() => format!("{}{unit}", marks::short(number)),
            _ => self.text.clone(),
        }
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

    /// The first columns are the fields in which the curves differ, if there are any, in their SI
    /// units if they are numbers, otherwise as given; then follows what varies, unless it is among
    /// the columns of the points, such as the total creepage in a fixed direction.
    fn csv(&self) -> Option<String> {
        let is_column = |name| {
            CreepCurve::COLUMNS.iter().any(|column: &Column<CreepCurve>| column.name == name)
        };
        let varied = self.members.first().map(|member| member.curve.path.quantity());
        let varied = varied.filter(|quantity| !is_column(quantity.name()));
        let mut table = Table::default();
        let mut are_numbers = Vec::new();
        for (k, over) in self.over.iter().enumerate() {
            let numbers = self.members.iter().map(|member| member.values.get(k)?.number);
            let unit = numbers.collect::<Option<Vec<_>>>().and_then(|all| Some(all.first()?.1));
            are_numbers.push(unit.is_some());
            table = table.with(
                over,
                unit.map_or("as given", |unit| if unit.is_empty() { "1" } else { unit }),
            );
        }
        if let Some(varied) = varied {
            let unit = varied.unit();
            table = table.with(varied.name(), if unit.is_empty() { "1" } else { unit });
        }
        let mut table = table.with_columns::<CreepCurve>();
        for Member { values, curve, .. } in &self.members {
            let values = values.iter().zip(&are_numbers).map(|(value, is_number)| {
                let number = value.number.filter(|_| *is_number);
                number.map_or_else(|| quoted(&value.text), |(number, _)| entry(number.into()))
            });
            let values: Vec<String> = values.collect();
            for (row, point) in curve.points.iter().enumerate() {
                let varied = varied.map(|_| entry(point.abscissa.into()));
                table.push(values.iter().cloned().chain(varied).chain(entries(curve, row)));
            }
        }
        Some(table.csv("forces on the wheel"))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        self.members.iter().map(|member| ("points", table::columns(&member.curve))).collect()
    }

    fn figure_names() -> Vec<String> {
        [FIGURE].iter().chain(map_figure::NAMES).map(|name| (*name).to_owned()).collect()
    }

    /// Curves, unless they are over two fields; maps, where there are any.
    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let mut drawings = Vec::new();
        if self.over.len() < 2 {
            let svg = figure::draw(self).ok_or(FigureError::NoCurve)?;
            drawings.push((FIGURE.to_owned(), svg));
        }
        drawings.extend(map_figure::draw(self));
        if drawings.is_empty() { Err(FigureError::NoCurve) } else { Ok(drawings) }
    }
}
