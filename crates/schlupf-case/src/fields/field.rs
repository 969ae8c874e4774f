//! What a field is.

use super::choice::Choice;
use super::path::FieldPath;
use super::suggestion::{NOT_PER_CENT, closest, creepage_in_per_cent, is_per_cent};
use super::{Requirement, readable};
use crate::document::{Content, Value};
use crate::setting::{Refusal, Setting};
use crate::tables::TableColumn;
use crate::units::{Measure, QuantityError, comma, comma_readings, parse_quantity, parse_unit};
use schlupf::Quantity;
use schlupf::reporting::Names;

/// A part of the case file under one heading.
#[derive(Debug)]
pub struct Section {
    /// Heading; empty for the top level.
    pub name: &'static str,
    /// The quantities that all of it gives.
    pub quantities: &'static [Quantity],
    /// What it is about.
    pub doc: &'static str,
    /// The tasks that alone use it; none where all may.
    pub tasks: &'static [&'static str],
    /// Its fields.
    pub fields: &'static [Field],
}

/// One field of the case file.
#[derive(Debug, Clone, Copy)]
pub struct Field {
    /// Dotted path, such as `kinematics.speed`.
    pub path: FieldPath,
    /// The quantities that it gives.
    pub quantities: &'static [Quantity],
    /// What may stand there.
    pub kind: Kind,
    /// What its number must be, in SI units.
    pub requirement: Requirement,
    /// What its number is in almost all cases, in SI units: another one may be in a wrong unit.
    pub usual: Option<Requirement>,
    /// What it is when left out.
    pub default: Default,
    /// The choice with which alone the default counts, if there is one.
    pub default_with: Option<UsedWith>,
    /// A choice with which the default is another text.
    pub other_default: Option<(UsedWith, &'static str)>,
    /// A value to show; the default where there is none.
    pub example: Option<&'static str>,
    /// The choices it belongs to, of which any will do.
    pub used_with: [Option<UsedWith>; 2],
    /// The choice with which it has no effect, if there is one.
    pub idle_with: Option<UsedWith>,
    /// Whether normal contact or elasticity may depend on it.
    pub shapes_contact: bool,
    /// Whether it is a constant of a material, which is given with the others, used or not.
    pub is_of_material: bool,
    /// The columns that its file may have, if it is a table: those of each kind of table.
    pub columns: &'static [&'static [TableColumn]],
    /// Its meaning, with the symbol.
    pub doc: &'static str,
}

/// A choice that a field belongs to: the path of the choice and the names that the field is used
/// with.
pub type UsedWith = (FieldPath, &'static [&'static str]);

/// What may stand in a field, or in an option that is read as one.
#[derive(Debug, Clone, Copy)]
pub struct Allowed {
    /// What it is called.
    pub name: &'static str,
    /// What may stand there.
    pub kind: Kind,
    /// What its number must be, in SI units.
    pub requirement: Requirement,
    /// What its number is in almost all cases, in SI units.
    pub usual: Option<Requirement>,
}

/// What may stand in a field.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Text with a number and a unit.
    Quantity(&'static Measure),
    /// A dimensionless number.
    Number,
    /// A dimensionless whole number.
    Count,
    /// Whether or not.
    Flag,
    /// One of several names.
    Choice(&'static [Choice]),
    /// A dimensionless number or one of several names.
    NumberOr(&'static [Choice]),
    /// Any text.
    Text,
    /// A path relative to the case file.
    Path,
    /// An array of quantities with units.
    Quantities(&'static Measure),
    /// An array of dimensionless numbers.
    Numbers,
}

/// What a field is when it is left out.
#[derive(Debug, Clone, Copy)]
pub enum Default {
    /// Nothing; whether it is missed depends on the others.
    Nothing,
    /// This text.
    Text(&'static str),
    /// The same as another field.
    Same(FieldPath),
    /// Something that is computed.
    Computed(&'static str),
}

impl Default {
    /// What it is, in words, where it is no text.
    pub fn in_words(self) -> Option<&'static str> {
        match self {
            Self::Same(other) => Some(other.as_str()),
            Self::Computed(text) => Some(text),
            Self::Nothing | Self::Text(_) => None,
        }
    }

    /// The text, where it is one.
    pub fn text(self) -> Option<&'static str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }
}

impl Kind {
    /// The names to choose from; empty where there is no choice.
    pub fn choices(self) -> &'static [Choice] {
        match self {
            Self::Choice(choices) | Self::NumberOr(choices) => choices,
            _ => &[],
        }
    }

    /// The SI unit of its numbers; empty where they are dimensionless or there are none.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Quantity(measure) | Self::Quantities(measure) => measure.unit,
            _ => "",
        }
    }

    /// Whether the value is text for which a shell may have eaten the quotes.
    pub fn is_text(self) -> bool {
        matches!(self, Self::Text | Self::Path | Self::Choice(_))
    }

    /// What is expected, in words.
    fn expected(self) -> String {
        match self {
            Self::Quantity(measure) => with_unit(measure),
            Self::Number => "a number without unit".to_owned(),
            Self::Count => "a whole number".to_owned(),
            Self::Flag => "true or false, without quotes".to_owned(),
            Self::Choice(choices) => format!("one of {}", names(choices)),
            Self::NumberOr(choices) => format!("a number without unit, or {}", names(choices)),
            Self::Text => "text in quotes".to_owned(),
            Self::Path => "the path of a file, as text in quotes".to_owned(),
            Self::Quantities(measure) => format!("an array, each entry {}", with_unit(measure)),
            Self::Numbers => "an array of numbers without unit".to_owned(),
        }
    }
}

fn with_unit(measure: &Measure) -> String {
    format!("{} with its unit, as text in {}", measure.name, measure.examples)
}

fn names(choices: &[Choice]) -> String {
    let quoted: Vec<String> = choices.iter().map(|choice| format!("{:?}", choice.name)).collect();
    quoted.join(", ")
}

impl Field {
    /// Without an example, used with any choice.
    pub(crate) const fn new(
        path: FieldPath,
        kind: Kind,
        requirement: Requirement,
        default: Default,
        doc: &'static str,
    ) -> Self {
        Self {
            path,
            quantities: &[],
            kind,
            requirement,
            usual: None,
            default,
            example: None,
            default_with: None,
            other_default: None,
            used_with: [None; 2],
            idle_with: None,
            shapes_contact: false,
            is_of_material: false,
            columns: &[],
            doc,
        }
    }

    /// Name of the section it stands in.
    pub fn section(&self) -> &'static str {
        self.path.section()
    }

    /// Last part of its path.
    pub fn name(&self) -> &'static str {
        self.path.name()
    }

    /// The choices it belongs to, of which any will do; none where it is always used.
    pub fn uses(&self) -> impl Iterator<Item = UsedWith> + use<> {
        self.used_with.into_iter().flatten()
    }

    /// What may stand there.
    pub fn allowed(&self) -> Allowed {
        let Self { kind, requirement, usual, .. } = *self;
        Allowed { name: self.path.as_str(), kind, requirement, usual }
    }

    /// The value of the field, in SI units, or why it cannot stand there.
    pub fn read(&self, value: &Value) -> Result<Setting, Refusal> {
        self.allowed().read(value)
    }
}

impl Allowed {
    /// The value, in SI units, or why it cannot stand there.
    pub fn read(&self, value: &Value) -> Result<Setting, Refusal> {
        match (self.kind, &value.content) {
            (Kind::Text | Kind::Path, Content::Text(text)) => Ok(Setting::Text(text.clone())),
            (Kind::Choice(choices) | Kind::NumberOr(choices), Content::Text(text)) => {
                self.choice(choices, text, value)
            }
            (Kind::Count, Content::Integer(_)) => self.number("", value),
            (Kind::Flag, Content::Flag(flag)) => Ok(Setting::Flag(*flag)),
            (Kind::Number | Kind::NumberOr(_), Content::Integer(_) | Content::Float(_)) => {
                self.number("", value)
            }
            (Kind::Quantity(measure), _) => self.quantity(measure, value).map(Setting::Number),
            (Kind::Quantities(measure), Content::Array(entries)) => entries
                .iter()
                .map(|entry| self.quantity(measure, entry))
                .collect::<Result<_, _>>()
                .map(Setting::Series),
            (Kind::Numbers, Content::Array(entries)) => entries
                .iter()
                .map(|entry| self.plain(entry))
                .collect::<Result<_, _>>()
                .map(Setting::Series),
            _ => Err(self.wrong_type(value)),
        }
    }

    fn choice(&self, choices: &[Choice], text: &str, value: &Value) -> Result<Setting, Refusal> {
        if let Some(choice) = choices.iter().find(|choice| choice.name == text) {
            return Ok(Setting::Choice(choice.name));
        }
        let help = closest(text, choices.iter().map(|choice| choice.name))
            .map(|name| format!("did you mean {name:?}?"));
        let help = help.or_else(|| self.quoted_number(value));
        Err(Refusal::new(self.kind.expected(), value).help(help))
    }

    fn number(&self, unit: &str, value: &Value) -> Result<Setting, Refusal> {
        let number = value.content.number().ok_or_else(|| self.wrong_type(value))?;
        self.require(number, unit, value).map(Setting::Number)
    }

    fn plain(&self, value: &Value) -> Result<f64, Refusal> {
        let number = value.content.number().ok_or_else(|| self.wrong_type(value))?;
        self.require(number, "", value)
    }

    fn quantity(&self, measure: &Measure, value: &Value) -> Result<f64, Refusal> {
        let number = match &value.content {
            Content::Text(text) => parse_quantity(text, measure)
                .map_err(|error| self.wrong_quantity(&error, measure, value))?,
            Content::Float(number) if number.is_infinite() => *number,
            content => {
                let help = content.number().map(|number| {
                    let units = self.units_of(number);
                    let texts: Vec<_> =
                        units.iter().map(|unit| format!("\"{number} {unit}\"")).collect();
                    format!("write the unit and quotes, such as {}", texts.join(" or "))
                });
                return Err(Refusal::new(with_unit(measure), value).help(help));
            }
        };
        self.require(number, measure.unit, value)
            .map_err(|refusal| in_si(refusal, number, measure, &value.content))
    }

    /// The units with which a number is a usual value; that in SI if there are none.
    pub(crate) fn units_of(&self, number: f64) -> Vec<&'static str> {
        let (Kind::Quantity(measure) | Kind::Quantities(measure)) = self.kind else {
            return Vec::new();
        };
        let is_usual = |unit: &&str| {
            let value = parse_unit(unit, measure).map(|convert| convert.apply(number));
            value.is_ok_and(|value| self.usual.is_some_and(|usual| usual.holds(value)))
        };
        let units: Vec<_> = measure.units().filter(is_usual).collect();
        if units.is_empty() { vec![measure.unit] } else { units }
    }

    fn require(&self, number: f64, unit: &str, value: &Value) -> Result<f64, Refusal> {
        if self.requirement.holds(number) {
            return Ok(number);
        }
        let help = creepage_in_per_cent(self.name, number);
        Err(Refusal::new(self.requirement.text(unit, &Names), value).help(help))
    }

    fn wrong_quantity(&self, error: &QuantityError, measure: &Measure, value: &Value) -> Refusal {
        let refusal = Refusal::new(with_unit(measure), value).because(error.to_string());
        let help = match (error, &value.content) {
            (QuantityError::UnknownUnit { .. }, _) => {
                Some(format!("units may be combined, as in {}", measure.examples))
            }
            (QuantityError::NoUnit, Content::Text(text)) => {
                text.trim().parse().ok().map(|number| {
                    let units = self.units_of(number);
                    let texts: Vec<_> =
                        units.iter().map(|unit| format!("{number} {unit}")).collect();
                    format!("such as {}", texts.join(" or "))
                })
            }
            _ => None,
        };
        refusal.help(help)
    }

    fn wrong_type(&self, value: &Value) -> Refusal {
        Refusal::new(self.kind.expected(), value).help(self.quoted_number(value))
    }

    /// Advice for a dimensionless number that was given as text.
    fn quoted_number(&self, value: &Value) -> Option<String> {
        let numeric =
            matches!(self.kind, Kind::Number | Kind::Count | Kind::NumberOr(_) | Kind::Numbers);
        let Content::Text(text) = &value.content else { return None };
        let digit = text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        let readings = comma_readings(text);
        let mut help = "write the number alone, without quotes and unit".to_owned();
        if !readings.is_empty() {
            help = comma(&readings);
        }
        if is_per_cent(text) {
            help = format!("{help}; {NOT_PER_CENT}");
        }
        (numeric && digit).then_some(help)
    }
}

/// Tells the number in the unit of the requirement, where it was given in another one.
fn in_si(refusal: Refusal, number: f64, measure: &Measure, content: &Content) -> Refusal {
    match content {
        Content::Text(text) if !text.trim_end().ends_with(&format!(" {}", measure.unit)) => {
            refusal.because(format!("that is {} {}", readable(number), measure.unit))
        }
        _ => refusal,
    }
}

impl Field {
    /// The default as a case file would give it, where it is fixed.
    pub fn default_value(&self) -> Option<Value> {
        self.default.text().map(|text| self.value_of(text))
    }

    /// A text of the table as the value that a case file would give.
    pub fn value_of(&self, text: &str) -> Value {
        let number = || text.parse().map(Content::Float).ok();
        let content = match self.kind {
            Kind::Count => text.parse().map(Content::Integer).ok(),
            Kind::Flag => text.parse().map(Content::Flag).ok(),
            Kind::Number | Kind::NumberOr(_) => number(),
            _ => None,
        };
        Value { content: content.unwrap_or_else(|| Content::Text(text.to_owned())), span: 0..0 }
    }

    /// The line `name = value` with the example or the default, as TOML.
    pub fn assignment(&self) -> Option<String> {
        let text = self.example.or(self.default.text())?;
        let literal = match (self.kind, self.value_of(text).content) {
            (Kind::Quantities(_) | Kind::Numbers, _) => text.to_owned(),
            (_, Content::Text(text)) => format!("{text:?}"),
            // Numbers stay as the table writes them: 1e-6, not 0.000001.
            _ => text.to_owned(),
        };
        Some(format!("{} = {literal}", self.name()))
    }
}
