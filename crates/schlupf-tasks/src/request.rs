//! What a task is asked: fields, read from what a face gives for them.
//!
//! A task defines its request with the macro `request!`: name, type, form and meaning of each
//! field. Options of the command, arguments in Python and their documentation follow from that, and
//! every face has its values read and checked here.

use std::fmt::{Display, Write};
use std::path::PathBuf;

use schlupf::Quantity;
use schlupf::message::quoted;
use schlupf_case::{CaseError, CaseFile, Family, InputFile, Place, fields, quantity_field};
use schlupf_case::{depths, direction, length, position, range};

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

/// How often a field is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Need {
    /// Once, unless it has a default.
    Once,
    /// Once, or not at all.
    Optional,
    /// As often as one likes.
    Several,
}

/// What may stand in a field. Numbers without unit from Python are in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// Whether or not.
    Flag,
    /// A whole number between two.
    Count([usize; 2]),
    /// A dimensionless number between two.
    Number([f64; 2]),
    /// A length of any sign.
    Position,
    /// A length that is not negative.
    Length,
    /// Start and end of lengths that increase from zero or above.
    Depths,
    /// An angle.
    Angle,
    /// Start and end of what gives a quantity in a case.
    Range(Quantity),
    /// One of several names, with their meanings.
    Choice(&'static [(&'static str, &'static str)]),
    /// A field of the case with values, `section.field=value,…`.
    Family,
    /// A file that is read.
    File,
    /// Text, with what stands for it in help.
    Text(&'static str),
}

impl Form {
    /// The unit of its numbers; empty where they are dimensionless or there are none.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Position | Self::Length | Self::Depths => "m",
            Self::Angle => "rad",
            Self::Range(quantity) => {
                fields::find(quantity_field(quantity)).map_or("", |field| field.kind.unit())
            }
            _ => "",
        }
    }

    /// Whether it has a start and an end.
    pub fn is_range(self) -> bool {
        matches!(self, Self::Depths | Self::Range(_))
    }

    /// What stands for it in help.
    pub fn placeholder(self) -> &'static str {
        match self {
            Self::Flag => "",
            Self::Count(_) => "N",
            Self::Number(_) => "NUMBER",
            Self::Position | Self::Length => "LENGTH",
            Self::Depths | Self::Range(_) => "START..END",
            Self::Angle => "ANGLE",
            Self::Choice(_) => "NAME",
            Self::Family => "SECTION.FIELD=VALUE,…",
            Self::File => "FILE",
            Self::Text(placeholder) => placeholder,
        }
    }
}

impl Field {
    /// One with a name, a type and a meaning.
    pub fn new<T: FromValues>(name: &'static str, form: Form, doc: &'static str) -> Self {
        let (need, default) = (T::NEED, None);
        Self { name, form, need, default, is_positional: false, option: None, doc }
    }

    /// The same with what it is when left out.
    #[must_use]
    pub fn default(self, default: impl Display) -> Self {
        Self { default: Some(default.to_string()), ..self }
    }

    /// The same, needing no name.
    #[must_use]
    pub fn positional(self) -> Self {
        Self { is_positional: true, ..self }
    }

    /// The same with another name of the option.
    #[must_use]
    pub fn option(self, option: &'static str) -> Self {
        Self { option: Some(option), ..self }
    }

    /// Its option without hyphens before it.
    pub fn long(&self) -> String {
        self.option.unwrap_or(self.name).replace('_', "-")
    }
}

/// Where a request comes from, which decides what messages call its fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// Options of the command.
    Command,
    /// Arguments of functions.
    Functions,
}

/// A value that a face gives.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Text, with a unit where the field has one.
    Text(String),
    /// A number in SI units.
    Number(f64),
    /// Whether or not.
    Flag(bool),
    /// Several values: start and end, or those of a field that is given several times.
    List(Vec<Value>),
    /// A file.
    File(InputFile),
}

impl Value {
    /// As text, numbers with a unit.
    fn text(&self, form: Form) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => format!("{number} {}", form.unit()).trim_end().to_owned(),
            Self::Flag(flag) => flag.to_string(),
            Self::File(file) => file.path().display().to_string(),
            Self::List(parts) => {
                let parts: Vec<String> = parts.iter().map(|part| part.text(form)).collect();
                parts.join(if form.is_range() { ".." } else { "," })
            }
        }
    }
}

/// What a face gives for the fields of a request.
#[derive(Debug, Clone)]
pub struct Asked {
    face: Face,
    fields: Vec<Field>,
    values: Vec<(&'static str, Value)>,
}

impl Asked {
    /// Nothing yet.
    pub fn new(face: Face, fields: Vec<Field>) -> Self {
        Self { face, fields, values: Vec::new() }
    }

    /// Gives a value to a field; an unknown one is left out, and so is a flag that is not raised.
    pub fn give(&mut self, name: &str, value: Value) {
        if value == Value::Flag(false) {
            return;
        }
        let name = self.fields.iter().find(|field| field.name == name).map(|field| field.name);
        self.values.extend(name.map(|name| (name, value)));
    }

    /// Where it comes from.
    pub fn face(&self) -> Face {
        self.face
    }

    /// What messages call a field.
    pub fn name(&self, name: &str) -> String {
        let field = self.fields.iter().find(|field| field.name == name);
        match (self.face, field) {
            (Face::Command, Some(field)) if field.is_positional => name.to_uppercase(),
            (Face::Command, Some(field)) => format!("--{}", field.long()),
            _ => name.to_owned(),
        }
    }

    fn form(&self, name: &str) -> Option<Form> {
        self.fields.iter().find(|field| field.name == name).map(|field| field.form)
    }

    /// Whether a field is given.
    pub fn has(&self, name: &str) -> bool {
        self.values.iter().any(|(given, _)| *given == name)
    }

    /// Those of some fields that are given, as they were.
    pub fn given(&self, names: &[&str]) -> String {
        let mut text = String::new();
        for (name, value) in self.values.iter().filter(|(name, _)| names.contains(name)) {
            let value = value.text(self.form(name).unwrap_or(Form::Flag));
            // Writing to a string cannot fail.
            let _ = write!(text, " {} {value}", self.name(name));
        }
        text.trim_start().to_owned()
    }

    /// An error about a field.
    pub fn refuse(&self, name: &str, message: String) -> CaseError {
        let value = self.values.iter().find(|(given, _)| *given == name);
        let form = self.form(name).unwrap_or(Form::Flag);
        let text = value.map_or_else(String::new, |(_, value)| value.text(form));
        CaseError::new("", message, Place::Override { option: self.name(name).into(), text })
    }

    /// Requires that at most one of some fields is given.
    ///
    /// # Errors
    /// Two of them.
    pub fn require_one_of(&self, names: &[&str]) -> Result<(), CaseError> {
        let given: Vec<&&str> = names.iter().filter(|name| self.has(name)).collect();
        let [first, second, ..] = given[..] else { return Ok(()) };
        let [one, other] = [first, second].map(|name| self.name(name));
        Err(self.refuse(second, format!("{other} must not be given together with {one}")))
    }

    /// Requires another field where some fields are given.
    ///
    /// # Errors
    /// One of them without it.
    pub fn require_with(&self, names: &[&str], other: &str) -> Result<(), CaseError> {
        let alone = names.iter().find(|name| self.has(name) && !self.has(other));
        alone.map_or(Ok(()), |name| {
            let [own, other] = [name, other].map(|name| self.name(name));
            Err(self.refuse(name, format!("{own} must be given together with {other}")))
        })
    }

    /// The files that are read, with the fields that name them; a family may name files of a case.
    pub fn files(&self, case: &CaseFile) -> Vec<(&'static str, PathBuf)> {
        let mut files = Vec::new();
        for (name, value) in &self.values {
            let parts = if let Value::List(parts) = value {
                parts.as_slice()
            } else {
                std::slice::from_ref(value)
            };
            for part in parts {
                match part {
                    Value::File(file) => files.push((*name, file.path())),
                    Value::Text(text) if self.form(name) == Some(Form::Family) => {
                        // What is wrong with it is told when it is read.
                        let named = Family::parse(*name, text).map(|family| family.files(case));
                        files.extend(named.into_iter().flatten().map(|path| (*name, path)));
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
    pub fn read<T: FromValues>(&self, name: &str) -> Result<T, CaseError> {
        let Some(field) = self.fields.iter().find(|field| field.name == name) else {
            return Err(self.refuse(name, format!("there is no field {}", quoted(name))));
        };
        let own = self.name(name);
        let given = self.values.iter().filter(|(given, _)| *given == name);
        let default = field.default.as_ref().map(|text| Value::Text(text.clone()));
        let mut values: Vec<&Value> = given.map(|(_, value)| value).collect();
        values.extend(default.iter().filter(|_| !self.has(name)));
        if let ([Value::List(parts)], Need::Several) = (&values[..], field.need) {
            values = parts.iter().collect();
        }
        if values.is_empty() && field.need == Need::Once && field.form != Form::Flag {
            return Err(self.refuse(name, format!("{own} must be given")));
        }
        T::from_values(&values, field, &own)
    }
}

/// A request of a task.
pub trait Request: Sized {
    /// Its fields, in the order of help and signatures.
    fn fields() -> Vec<Field>;

    /// Reads it.
    ///
    /// # Errors
    /// A field that is missing, or with a value that cannot stand there.
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

/// The type of a field.
pub trait FromValues: Sized {
    /// How often it is given.
    const NEED: Need;

    /// Reads it.
    ///
    /// # Errors
    /// A value that cannot stand there.
    fn from_values(values: &[&Value], field: &Field, name: &str) -> Result<Self, CaseError>;
}

/// The type of one value of a field.
trait FromValue: Sized {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError>;
}

impl<T: FromValue> FromValues for Option<T> {
    const NEED: Need = Need::Optional;

    fn from_values(values: &[&Value], field: &Field, name: &str) -> Result<Self, CaseError> {
        values.last().map(|value| T::from_value(value, field, name)).transpose()
    }
}

impl<T: FromValue> FromValues for Vec<T> {
    const NEED: Need = Need::Several;

    fn from_values(values: &[&Value], field: &Field, name: &str) -> Result<Self, CaseError> {
        values.iter().map(|value| T::from_value(value, field, name)).collect()
    }
}

/// Types of fields that are given once.
macro_rules! once {
    ($($type:ty),*) => {
        $(impl FromValues for $type {
            const NEED: Need = Need::Once;

            fn from_values(values: &[&Value], field: &Field, name: &str) -> Result<Self, CaseError> {
                let default = Value::Flag(false);
                Self::from_value(values.last().unwrap_or(&&default), field, name)
            }
        })*
    };
}

once!(bool, usize, f64, [f64; 2], &'static str, String, InputFile, Family);

fn wrong(name: &str, text: &str, requirement: &str) -> CaseError {
    let place = Place::Override { option: name.to_owned().into(), text: text.to_owned() };
    CaseError::new("", format!("{name} must be {requirement}, but is {}", quoted(text)), place)
}

impl FromValue for bool {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        match value {
            Value::Flag(flag) => Ok(*flag),
            other => Err(wrong(name, &other.text(field.form), "true or false")),
        }
    }
}

impl FromValue for usize {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        let Form::Count([least, most]) = field.form else { return Ok(0) };
        let text = value.text(field.form);
        let count = text.trim().parse().ok().filter(|count| (least..=most).contains(count));
        let between = || format!("a whole number between {least} and {most}");
        count.ok_or_else(|| wrong(name, &text, &between()))
    }
}

impl FromValue for f64 {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        let text = value.text(field.form);
        match field.form {
            Form::Position => position(name, name, &text),
            Form::Length => length(name, name, &text),
            Form::Angle => direction(name, &text),
            Form::Number([least, most]) => {
                let number = text.trim().parse().ok();
                let number = number.filter(|number| (least..=most).contains(number));
                number.ok_or_else(|| {
                    wrong(name, &text, &format!("a number between {least} and {most}"))
                })
            }
            _ => Ok(0.0),
        }
    }
}

impl FromValue for [f64; 2] {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        let text = value.text(field.form);
        match field.form {
            Form::Range(quantity) => range(name, quantity_field(quantity), &text),
            _ => depths(name, &text),
        }
    }
}

impl FromValue for &'static str {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        let Form::Choice(choices) = field.form else { return Ok("") };
        let text = value.text(field.form);
        let found = choices.iter().find(|(choice, _)| *choice == text);
        found.map(|(choice, _)| *choice).ok_or_else(|| {
            let names: Vec<String> = choices.iter().map(|(name, _)| format!("{name:?}")).collect();
            wrong(name, &text, &format!("one of {}", names.join(", ")))
        })
    }
}

impl FromValue for String {
    fn from_value(value: &Value, field: &Field, _name: &str) -> Result<Self, CaseError> {
        Ok(value.text(field.form))
    }
}

impl FromValue for InputFile {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        match value {
            Value::File(file) => Ok(file.clone()),
            other => Err(wrong(name, &other.text(field.form), "a file")),
        }
    }
}

impl FromValue for Family {
    fn from_value(value: &Value, field: &Field, name: &str) -> Result<Self, CaseError> {
        Self::parse(name, &value.text(field.form))
    }
}

/// Defines the request of a task: name, type, [`Form`] and meaning of its fields, and what else
/// there is to say of them.
macro_rules! request {
    ($(#[$about:meta])* $name:ident {
        $(
            $(#[doc = $doc:literal])+ $field:ident: $type:ty = $form:expr
                $(, $attribute:ident($($value:expr)?))*;
        )*
    }) => {
        $(#[$about])*
        #[derive(Debug, Clone)]
        pub struct $name {
            $($(#[doc = $doc])+ pub $field: $type,)*
            /// As it was given.
            #[allow(dead_code, reason = "not every task speaks of its fields")]
            pub asked: $crate::request::Asked,
        }

        impl $crate::request::Request for $name {
            fn fields() -> Vec<$crate::request::Field> {
                vec![$(
                    $crate::request::Field::new::<$type>(
                        stringify!($field),
                        $form,
                        concat!($($doc),+).trim_ascii(),
                    )$(.$attribute($($value)?))*
                ),*]
            }

            fn read(
                asked: &$crate::request::Asked,
            ) -> Result<Self, schlupf_case::CaseError> {
                Ok(Self { $($field: asked.read(stringify!($field))?,)* asked: asked.clone() })
            }
        }
    };
}

pub(crate) use request;
