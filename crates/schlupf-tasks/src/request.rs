//! What a task is asked: fields, read from what a face gives for them.
//!
//! A task defines its request with the macro `request!`: name, type, kind and meaning of each
//! field, and the rules that hold between them. Options of the command, arguments in Python and
//! their documentation follow from that, and every face has its values read and checked here.

mod form;
mod kind;

use std::fmt::{Display, Write};
use std::path::PathBuf;

use schlupf_case::{CaseError, CaseFile, Family, Place};

pub use form::{Form, Value};
pub use kind::{FieldType, Kind, Need};

/// A field of a request.
#[derive(Debug, Clone)]
pub struct Field {
    /// Its name, as in Python; that of the option has hyphens.
    pub name: &'static str,
    /// What may stand there.
    pub form: Form,
    /// How often it is given.
    pub need: Need,
    /// What it is when left out, where that is fixed.
    pub default: Option<String>,
    /// Whether it needs no name.
    pub is_positional: bool,
    /// Another name of the option.
    pub option: Option<&'static str>,
    /// Its meaning.
    pub doc: &'static str,
}

impl Field {
    /// One with a name, a kind and a meaning.
    pub fn new<T: FieldType>(name: &'static str, kind: &Kind<T::Value>, doc: &'static str) -> Self {
        let (form, need, default) = (kind.form, T::NEED, None);
        Self { name, form, need, default, is_positional: false, option: None, doc }
    }

    /// Says what it is when left out.
    #[must_use]
    pub fn default(self, default: impl Display) -> Self {
        Self { default: Some(default.to_string()), ..self }
    }

    /// Lets it stand without its name.
    #[must_use]
    pub fn positional(self) -> Self {
        Self { is_positional: true, ..self }
    }

    /// Gives the option another name.
    #[must_use]
    pub fn option(self, option: &'static str) -> Self {
        Self { option: Some(option), ..self }
    }

    /// Its option without hyphens before it.
    pub fn long(&self) -> String {
        self.option.unwrap_or(self.name).replace('_', "-")
    }

    /// Whether it must be given.
    pub fn is_needed(&self) -> bool {
        self.need == Need::Once && self.default.is_none() && !self.form.is_flag()
    }
}

/// What holds between the fields of a request.
#[derive(Debug, Clone, Copy)]
pub enum Rule {
    /// At least one of them is given.
    AnyOf(&'static [&'static str]),
    /// None of the first is given together with another one of the second.
    Apart(&'static [&'static str], &'static [&'static str]),
    /// Each of the first is given together with one of the second.
    With(&'static [&'static str], &'static [&'static str]),
}

/// Where a request comes from, which decides what messages call its fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// Options of the command.
    Command,
    /// Arguments of functions.
    Functions,
}

/// What a face gives for the fields of a request.
#[derive(Debug, Clone)]
pub struct Asked {
    face: Face,
    fields: Vec<(Field, Vec<Value>)>,
}

impl Asked {
    /// Asks a face for the values of each field. A flag that is not raised has none.
    ///
    /// # Errors
    /// Those of the face.
    pub fn new<E>(
        face: Face,
        fields: Vec<Field>,
        values: impl Fn(&Field) -> Result<Vec<Value>, E>,
    ) -> Result<Self, E> {
        let given = |field: Field| {
            let mut values = values(&field)?;
            values.retain(|value| *value != Value::Flag(false) || !field.form.is_flag());
            if let ([Value::List(parts)], Need::Several) = (&values[..], field.need) {
                values = parts.clone();
            }
            Ok((field, values))
        };
        let fields = fields.into_iter().map(given).collect::<Result<_, E>>()?;
        Ok(Self { face, fields })
    }

    /// Where it comes from.
    pub fn face(&self) -> Face {
        self.face
    }

    fn find(&self, name: &str) -> Option<(&Field, &[Value])> {
        let (field, values) = self.fields.iter().find(|(field, _)| field.name == name)?;
        Some((field, values))
    }

    /// What messages call a field.
    pub fn name(&self, name: &str) -> String {
        match (self.face, self.find(name)) {
            (Face::Command, Some((field, _))) if field.is_positional => name.to_uppercase(),
            (Face::Command, Some((field, _))) => self.output(&field.long()),
            _ => name.to_owned(),
        }
    }

    /// What messages call an output, or another option that is no field.
    pub fn output(&self, option: &str) -> String {
        match self.face {
            Face::Command => format!("--{option}"),
            Face::Functions => option.to_owned(),
        }
    }

    /// Whether a field is given.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some_and(|(_, values)| !values.is_empty())
    }

    /// The value of a field as it was given.
    pub fn text(&self, name: &str) -> Option<String> {
        let (field, values) = self.find(name)?;
        values.last().map(|value| value.text(field.form))
    }

    /// Those of some fields that are given, as they were.
    pub fn given(&self, names: &[&str]) -> String {
        let mut text = String::new();
        for name in names {
            if let Some(value) = self.text(name) {
                // Writing to a string cannot fail.
                let _ = write!(text, " {} {value}", self.name(name));
            }
        }
        text.trim().to_owned()
    }

    /// An error about a field.
    pub fn refuse(&self, name: &str, message: String) -> CaseError {
        let (option, text) = (self.name(name).into(), self.text(name).unwrap_or_default());
        CaseError::new("", message, Place::Override { option, text })
    }

    /// Refuses what divides a range where a field gives each point.
    ///
    /// # Errors
    /// The first of `others` that is given.
    pub fn check_range(&self, each: &str, others: &[&str]) -> Result<(), CaseError> {
        others.iter().find(|other| self.has(other)).map_or(Ok(()), |other| {
            let [each, own] = [each, other].map(|name| self.name(name));
            let message = format!("{own} must be left out where {each} gives each point");
            Err(self.refuse(other, message))
        })
    }

    /// Requires the rules to hold.
    ///
    /// # Errors
    /// The first one that is broken.
    pub fn check(&self, rules: &[Rule]) -> Result<(), CaseError> {
        rules.iter().try_for_each(|rule| match *rule {
            Rule::AnyOf(names) if names.iter().any(|name| self.has(name)) => Ok(()),
            Rule::AnyOf(names) => {
                let message = format!("one of {} must be given", self.any_of(names));
                Err(CaseError::new("", message, Place::File { name: String::new() }))
            }
            Rule::Apart(ones, others) => {
                ones.iter().filter(|one| self.has(one)).try_for_each(|one| {
                    let other = others.iter().find(|other| *other != one && self.has(other));
                    other.map_or(Ok(()), |other| {
                        let names = [one, other].map(|name| self.name(name));
                        let message =
                            format!("{} must not be given together with {}", names[0], names[1]);
                        Err(self.refuse(one, message))
                    })
                })
            }
            Rule::With(ones, others) => {
                let alone = ones.iter().find(|one| self.has(one));
                match alone.filter(|_| !others.iter().any(|other| self.has(other))) {
                    Some(one) => {
                        let (own, others) = (self.name(one), self.any_of(others));
                        let message = format!("{own} must be given together with {others}");
                        Err(self.refuse(one, message))
                    }
                    None => Ok(()),
                }
            }
        })
    }

    /// `a, b or c`.
    fn any_of(&self, names: &[&str]) -> String {
        let names: Vec<String> = names.iter().map(|name| self.name(name)).collect();
        match &names[..] {
            [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
            _ => names.concat(),
        }
    }

    /// The files that are read, with the fields that name them; a family may name files of a case.
    pub fn files(&self, case: &CaseFile) -> Vec<(&'static str, PathBuf)> {
        let mut files = Vec::new();
        for (field, values) in &self.fields {
            for value in values {
                match value {
                    Value::File(file) => files.push((field.name, file.path())),
                    Value::Text(text) if matches!(field.form, Form::Family) => {
                        // What is wrong with it is told when it is read.
                        let named = Family::parse(field.name, text);
                        let named = named.map(|family| family.files(case));
                        files.extend(named.into_iter().flatten().map(|path| (field.name, path)));
                    }
                    _ => {}
                }
            }
        }
        files
    }

    /// The value of a field.
    ///
    /// # Errors
    /// One that is missing, or that cannot stand there.
    pub fn read<T: FieldType>(&self, name: &str, kind: &Kind<T::Value>) -> Result<T, CaseError> {
        let (own, found) = (self.name(name), self.find(name));
        let mut values = found.map_or_else(Vec::new, |(_, values)| values.to_vec());
        if values.is_empty() {
            let default = found.and_then(|(field, _)| field.default.clone()).map(Value::Text);
            let lowered = matches!(kind.form, Form::Flag).then_some(Value::Flag(false));
            values.extend(default.or(lowered));
        }
        let values = values.iter().map(|value| (kind.read)(&own, value));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        T::of(values).ok_or_else(|| self.refuse(name, format!("{own} must be given")))
    }
}

/// A request of a task.
pub trait Request: Sized + Send + 'static {
    /// What holds between its fields.
    const RULES: &'static [Rule] = &[];

    /// Its fields, in the order of help and signatures.
    fn fields() -> Vec<Field>;

    /// Reads it.
    ///
    /// # Errors
    /// A field that is missing, or with a value that cannot stand there, and a rule that is broken.
    fn read(asked: &Asked) -> Result<Self, CaseError>;
}

/// A request besides which the case says everything.
pub struct Nothing;

impl Request for Nothing {
    fn fields() -> Vec<Field> {
        Vec::new()
    }

    fn read(_asked: &Asked) -> Result<Self, CaseError> {
        Ok(Self)
    }
}

/// Defines the request of a task: name, type, [`Kind`] and meaning of its fields, what else there
/// is to say of them, and the rules between them.
macro_rules! request {
    ($(#[$about:meta])* $name:ident {
        $(
            $(#[doc = $doc:literal])+ $field:ident: $type:ty = $kind:expr
                $(, $attribute:ident($($value:expr)?))*;
        )*
        $(=> $rules:expr)?
    }) => {
        $(#[$about])*
        #[derive(Debug, Clone)]
        #[allow(dead_code, reason = "a task may look at some fields as they were given")]
        pub struct $name {
            $($(#[doc = $doc])+ pub $field: $type,)*
            /// As it was given.
            pub asked: $crate::request::Asked,
        }

        impl $crate::request::Request for $name {
            $(const RULES: &'static [$crate::request::Rule] = $rules;)?

            fn fields() -> Vec<$crate::request::Field> {
                vec![$(
                    $crate::request::Field::new::<$type>(
                        stringify!($field),
                        &$kind,
                        concat!($($doc),+).trim_ascii(),
                    )$(.$attribute($($value)?))*
                ),*]
            }

            fn read(
                asked: &$crate::request::Asked,
            ) -> Result<Self, schlupf_case::CaseError> {
                asked.check(Self::RULES)?;
                Ok(Self {
                    $($field: asked.read::<$type>(stringify!($field), &$kind)?,)*
                    asked: asked.clone(),
                })
            }
        }
    };
}

pub(crate) use request;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TASKS;

    /// What a rule names exists.
    #[test]
    fn rules_are_about_fields() {
        for task in TASKS {
            let fields = (task.fields)();
            for rule in task.rules {
                let (Rule::AnyOf(ones) | Rule::Apart(ones, _) | Rule::With(ones, _)) = rule;
                let others =
                    if let Rule::Apart(_, all) | Rule::With(_, all) = rule { all } else { ones };
                for name in ones.iter().chain(*others) {
                    assert!(
                        fields.iter().any(|field| field.name == *name),
                        "{}: {name}",
                        task.name
                    );
                }
            }
        }
    }

    /// What the sections of a case call tasks are tasks.
    #[cfg(feature = "study")]
    #[test]
    fn sections_are_for_tasks_that_exist() {
        for name in schlupf_case::fields::SECTIONS.iter().flat_map(|section| section.tasks) {
            assert!(crate::find(name).is_some(), "{name}");
        }
    }

    /// A flag that is not raised is not given; no other field takes one for nothing.
    #[cfg(feature = "fitting")]
    #[test]
    fn a_flag_is_nothing_for_a_flag_alone() {
        let task = crate::find("calibrate").unwrap();
        let asked = |name: &'static str| {
            let given = move |field: &Field| {
                let lowered = (field.name == name).then_some(Value::Flag(false));
                Ok::<_, CaseError>(lowered.into_iter().collect())
            };
            Asked::new(Face::Functions, (task.fields)(), given).unwrap()
        };
        assert!(!asked("direct").has("direct"));
        assert!((task.read)(&asked("direct")).is_ok());
        let refused = (task.read)(&asked("cells")).err().unwrap().to_string();
        assert!(refused.contains("cells must be a whole number between 10 and 80, but is false"));
    }
}
