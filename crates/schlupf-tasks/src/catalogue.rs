//! What there is, as JSON: sections and fields of a case, tasks and the fields of their requests.
//! Faces make signatures, forms and documentation of it.

use schlupf::reporting::Requirement;
use schlupf_case::fields::{self, ALTERNATIVES, Kind, SECTIONS};
use schlupf_case::units::parse_quantity;
use schlupf_case::{FieldNames, Preset, TableColumn};
use serde_json::{Value, json};

use crate::TASKS;
use crate::request::{Field, Form, Need};

/// Sections of a case with their fields in the order of the case file, tasks with what they are
/// asked, and presets: constants to start with.
///
/// ```
/// let catalogue = schlupf_tasks::catalogue();
/// let task = &catalogue["tasks"][0];
/// assert_eq!((&task["name"], &task["about"]), (&"solve".into(), &"Solve a case".into()));
/// ```
pub fn catalogue() -> Value {
    let sections: Vec<Value> = SECTIONS
        .iter()
        .map(|section| {
            let fields: Vec<Value> = section.fields.iter().map(of_case).collect();
            json!({ "name": section.name, "doc": section.doc, "fields": fields })
        })
        .collect();
    let tasks: Vec<Value> = TASKS
        .iter()
        .map(|task| {
            json!({
                "name": task.name,
                "function": task.function,
                "about": task.about,
                "sources": task.sources,
                "case": task.case.doc(),
                "is_of_argument": task.is_of_argument(),
                "has_several": task.has_several,
                "fields": (task.fields)().iter().map(of_request).collect::<Vec<_>>(),
            })
        })
        .collect();
    let presets: Vec<Value> = schlupf_case::presets()
        .iter()
        .map(|preset| {
            let Preset { group, name, doc, source, fields } = preset;
            json!({
                "group": group,
                "name": name,
                "doc": doc,
                "source": source,
                "section": preset.section(),
                "fields": fields,
            })
        })
        .collect();
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "sections": sections,
        "tasks": tasks,
        "presets": presets,
    })
}

/// A field of a case: path, kind, SI unit, what its numbers must be and mostly are, default (in
/// words where it is computed), a unit that people give it in, whether it may have no value,
/// choices, defining equation and meaning.
fn of_case(field: &fields::Field) -> Value {
    let is_number = !matches!(field.kind, Kind::Flag | Kind::Choice(_) | Kind::Text | Kind::Path);
    let requirement = field.requirement.text(field.kind.unit(), &FieldNames::CASE);
    let columns: Vec<Value> = field.columns.iter().map(|kind| of_columns(kind)).collect();
    let uses: Vec<Value> =
        field.uses().map(|(path, names)| json!([path.as_str(), names])).collect();
    json!({
        "path": field.path.as_str(),
        "name": field.name(),
        "kind": kind(field.kind),
        "units": field.kind.unit(),
        "requirement": if is_number { requirement } else { String::new() },
        "bounds": ends(field.requirement),
        "usual": field.usual.map(ends),
        "default": field.default.text().or(field.default.in_words()),
        "given_in": given_in(field),
        "is_optional": is_optional(field),
        "choices": choices(field.kind.choices()),
        "used_with": uses,
        "columns": columns,
        "definition": field.quantities.first().map_or("", |quantity| quantity.definition()),
        "doc": field.doc,
    })
}

/// The ends of what is allowed, where it has some.
fn ends(requirement: Requirement) -> [Option<f64>; 2] {
    requirement.bounds().map(|end| end.map(|(value, _)| value))
}

/// The unit of the default or example of a field, with its value in SI units.
fn given_in(field: &fields::Field) -> Option<(&'static str, f64)> {
    let Kind::Quantity(measure) = field.kind else { return None };
    let text = field.default.text().or(field.example)?;
    let (_, unit) = text.split_once(' ')?;
    Some((unit, parse_quantity(&format!("1 {unit}"), measure).ok()?))
}

/// Whether there are cases in which it has no value.
fn is_optional(field: &fields::Field) -> bool {
    let mut pairs = ALTERNATIVES.iter().flat_map(|pair| [pair.first, pair.second]);
    field.default.text().is_none()
        || field.default_with.is_some()
        || pairs.any(|paths| paths.contains(&field.path))
}

/// A field of a request: name, kind, how often it is given, whether without its name, default as
/// text, SI unit, bounds of its numbers, choices, columns of tables with their units, meaning.
fn of_request(field: &Field) -> Value {
    let tables = field.form.tables();
    json!({
        "name": field.name,
        "is_several": field.need == Need::Several,
        "is_needed": field.is_needed(),
        "is_positional": field.is_positional,
        "default": field.default,
        "units": field.form.unit(),
        "bounds": field.form.bounds(),
        "choices": choices(field.form.choices()),
        "kind": if tables.is_empty() { kind_of_request(field.form) } else { "table" },
        "columns": tables.iter().map(|table| of_columns(table)).collect::<Vec<_>>(),
        "doc": field.doc,
    })
}

fn choices(choices: &[fields::Choice]) -> Vec<[&'static str; 2]> {
    choices.iter().map(|choice| [choice.name, choice.doc]).collect()
}

/// The columns of a table: name, SI unit.
fn of_columns(columns: &[TableColumn]) -> Value {
    columns.iter().map(|column| json!([column.name, column.unit()])).collect()
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Quantity(_) => "quantity",
        Kind::Number => "number",
        Kind::Count => "count",
        Kind::Flag => "flag",
        Kind::Choice(_) => "choice",
        Kind::NumberOr(_) => "number-or-choice",
        Kind::Text => "text",
        Kind::Path => "path",
        Kind::Quantities(_) => "quantities",
        Kind::Numbers => "numbers",
    }
}

fn kind_of_request(form: Form) -> &'static str {
    match form {
        Form::Flag => "flag",
        Form::Count(_) => "count",
        Form::Number(_) | Form::Position | Form::Length | Form::Angle => "number",
        Form::Depths | Form::Points(_) => "points",
        Form::Choice(_) => "choice",
        Form::Family => "family",
        Form::File(_) => "file",
        Form::List(_) => "list",
        Form::OfCase(_) => match form.of_case() {
            Some(Kind::Flag) => "flag",
            Some(Kind::Count) => "count",
            Some(Kind::Number | Kind::Quantity(_)) => "number",
            Some(Kind::Quantities(_) | Kind::Numbers) => "numbers",
            Some(Kind::Choice(_)) => "choice",
            Some(Kind::Path) => "file",
            Some(Kind::NumberOr(_) | Kind::Text) | None => "text",
        },
    }
}
