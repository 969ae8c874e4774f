//! The text of a case file as a flat list of fields with their places.

use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::CaseError;
use crate::fields;
use crate::place::{Place, Source};
use crate::units::{comma, comma_readings};
use schlupf::reporting::{cut, quoted, shortened};

/// A value with its bytes in the text.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// What it is.
    pub content: Content,
    /// Where in the text.
    pub span: Range<usize>,
}

/// What a value is.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// Text in quotes.
    Text(String),
    /// A whole number.
    Integer(i64),
    /// A number with a point or an exponent, infinity or nan.
    Float(f64),
    /// True or false.
    Flag(bool),
    /// An array.
    Array(Vec<Value>),
    /// Something that no field takes, by its name.
    Other(&'static str),
}

impl Value {
    /// A value of a TOML document.
    pub fn of(value: &Spanned<DeValue<'_>>) -> Self {
        Self { content: Content::of(value.get_ref()), span: value.span() }
    }
}

impl Content {
    /// A value of a TOML document.
    pub fn of(value: &DeValue<'_>) -> Self {
        match value {
            DeValue::String(text) => Self::Text(text.to_string()),
            DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
                .map_or(Self::Other("a number of too many digits"), Self::Integer),
            DeValue::Float(digits) => {
                digits.as_str().parse().map_or(Self::Other("a number"), Self::Float)
            }
            DeValue::Boolean(flag) => Self::Flag(*flag),
            DeValue::Datetime(_) => Self::Other("a date"),
            DeValue::Table(_) => Self::Other("a table"),
            DeValue::Array(entries) => Self::Array(entries.iter().map(Value::of).collect()),
        }
    }

    /// The number, where it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Integer(number) => Some(*number as f64),
            Self::Float(number) => Some(*number),
            _ => None,
        }
    }

    /// The value as an error message shows it.
    pub fn shown(&self) -> String {
        match self {
            Self::Text(text) => quoted(text),
            Self::Integer(number) => number.to_string(),
            Self::Float(number) => format!("{number:?}"),
            Self::Array(entries) => format!("an array of {}", entries.len()),
            Self::Flag(flag) => flag.to_string(),
            Self::Other(name) => (*name).to_owned(),
        }
    }
}

/// A field that was given.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Dotted path.
    pub path: String,
    /// Bytes of the key.
    pub key: Range<usize>,
    /// Its value.
    pub value: Value,
    /// Where it was given.
    pub origin: Origin,
}

/// Where a field was given.
#[derive(Debug, Clone)]
pub enum Origin {
    /// In the case file.
    File(Arc<Source>),
    /// By what overrides it, such as an option of the command line.
    Override {
        /// What that is called, such as `--set`.
        option: Arc<str>,
        /// The text after it.
        text: String,
    },
}

impl Origin {
    /// The place of some bytes.
    pub fn place(&self, span: &Range<usize>) -> Place {
        match self {
            Self::File(source) => Place::Text { source: Arc::clone(source), span: span.clone() },
            Self::Override { option, text } => {
                Place::Override { option: Arc::clone(option), text: text.clone() }
            }
        }
    }
}

/// All fields that a text gives, in its order, and what stands there that is neither field nor
/// section.
pub fn parse(source: &Arc<Source>) -> Result<(Vec<Entry>, Vec<CaseError>), CaseError> {
    let table = DeTable::parse(&source.text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        let place = Place::Text { source: Arc::clone(source), span };
        let message = error.message().trim().replace('\n', "; ");
        CaseError::new("", format!("not TOML: {}", cut(&message, LONGEST_MESSAGE)), place)
            .help(comma_help(&source.text, error.span().unwrap_or(0..0).start))
    })?;
    let origin = Origin::File(Arc::clone(source));
    let mut flat = Flat { origin, entries: Vec::new(), errors: Vec::new() };
    for (key, value) in table.get_ref() {
        flat.add("", key, value);
    }
    flat.entries.sort_by_key(|entry| entry.key.start);
    Ok((flat.entries, flat.errors))
}

/// Characters of a message of the parser, which may quote the text.
const LONGEST_MESSAGE: usize = 200;

/// Advice for a text that is not TOML because the number in the line of a byte has a comma.
fn comma_help(text: &str, byte: usize) -> Option<String> {
    let start = text.get(..byte)?.rfind('\n').map_or(0, |end| end + 1);
    let (_, value) = text[start..].lines().next()?.split_once('=')?;
    let readings = comma_readings(value.split_whitespace().next()?);
    (!readings.is_empty()).then(|| comma(&readings))
}

/// What a text gives, without its sections.
struct Flat {
    origin: Origin,
    entries: Vec<Entry>,
    errors: Vec<CaseError>,
}

impl Flat {
    /// Adds the fields below a key. A table that is no section would vanish when it is empty: it is
    /// an error here.
    fn add(&mut self, parent: &str, key: &Spanned<impl AsRef<str>>, value: &Spanned<DeValue<'_>>) {
        let name = key.get_ref().as_ref();
        let path = if parent.is_empty() { name.to_owned() } else { format!("{parent}.{name}") };
        let is_section = !path.is_empty() && fields::section(&path).is_some();
        let place = || self.origin.place(&key.span());
        let path = match (value.get_ref(), shorthand(&path)) {
            (DeValue::Table(table), _) if is_section => {
                for (key, value) in table {
                    self.add(&path, key, value);
                }
                return;
            }
            (DeValue::Table(_), _) if fields::find(&path).is_none() => {
                return self.errors.push(unknown_section(&path, place()));
            }
            (DeValue::String(_), Some(file)) => file,
            _ if is_section => {
                let message = format!("{path} is a section, not a field");
                let error = CaseError::new(&path, message, place());
                let help = format!("put its fields under a heading [{path}]");
                return self.errors.push(error.help(help));
            }
            _ => path,
        };
        let value = Value::of(value);
        self.entries.push(Entry { path, key: key.span(), value, origin: self.origin.clone() });
    }
}

/// The field that a text in place of a section within a section stands for: its file.
fn shorthand(path: &str) -> Option<String> {
    let is_inner = path.contains('.') && fields::section(path).is_some();
    is_inner.then(|| format!("{path}.file")).filter(|file| fields::find(file).is_some())
}

fn unknown_section(path: &str, place: Place) -> CaseError {
    let names = || fields::SECTIONS.iter().map(|section| section.name).filter(|n| !n.is_empty());
    let help = match fields::closest(path, names()) {
        Some(name) => format!("did you mean [{name}]?"),
        None => format!("the sections are {}", names().collect::<Vec<_>>().join(", ")),
    };
    CaseError::new(path, format!("unknown section `{}`", shortened(path)), place).help(help)
}

/// Puts an override `path=value`, given by an option, in place of what the file says. An empty
/// value takes the field out.
pub fn apply(entries: &mut Vec<Entry>, option: &Arc<str>, text: &str) -> Result<(), CaseError> {
    let place = Place::Override { option: Arc::clone(option), text: text.to_owned() };
    let Some((path, value)) = text.split_once('=') else {
        let message =
            format!("an override must be of the form section.field=value, but is {}", quoted(text));
        return Err(CaseError::new("", message, place));
    };
    let origin = Origin::Override { option: Arc::clone(option), text: text.to_owned() };
    assign(entries, origin, path.trim(), value.trim());
    Ok(())
}

/// Puts a value in place of what the file says.
pub fn assign(entries: &mut Vec<Entry>, origin: Origin, path: &str, value: &str) {
    let file = shorthand(path);
    if file.is_some() {
        let within = format!("{path}.");
        entries.retain(|entry| !entry.path.starts_with(&within));
    }
    let path = file.as_deref().unwrap_or(path);
    entries.retain(|entry| entry.path != path);
    // An unknown field stays in the list, to be reported with a suggestion.
    if !value.is_empty() || fields::find(path).is_none() {
        entries.push(Entry {
            path: path.to_owned(),
            key: 0..0,
            value: Value { content: override_content(path, value), span: 0..0 },
            origin,
        });
    }
}

/// The value of an override: TOML if it is, else plain text, as shells eat quotes.
fn override_content(path: &str, text: &str) -> Content {
    let parsed = DeValue::parse(text).map(|value| Content::of(value.get_ref()));
    let wants_text = fields::find(path).is_some_and(|field| field.kind.is_text());
    match parsed {
        Ok(Content::Text(text)) => Content::Text(text),
        Ok(content) if !wants_text => content,
        _ => Content::Text(text.to_owned()),
    }
}

/// A text without the quotes of TOML around it, if it has any.
pub fn without_quotes(text: &str) -> String {
    match DeValue::parse(text).map(|value| Content::of(value.get_ref())) {
        Ok(Content::Text(text)) => text,
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(text: &str) -> Vec<Entry> {
        let source = Source { name: "case.toml".to_owned(), text: text.to_owned() };
        parse(&Arc::new(source)).unwrap().0
    }

    #[test]
    fn headings_dotted_keys_and_inline_tables_are_the_same() {
        for text in [
            "[kinematics]\nspeed = \"30 m/s\"",
            "kinematics.speed = \"30 m/s\"",
            "kinematics = { speed = \"30 m/s\" }",
        ] {
            let entries = entries(text);
            assert_eq!(entries.len(), 1);
            assert_eq!(entries[0].path, "kinematics.speed");
            assert_eq!(&text[entries[0].value.span.clone()], "\"30 m/s\"");
        }
    }

    #[test]
    fn overrides_replace_and_remove() {
        let mut entries = entries("[kinematics]\nspeed = \"30 m/s\"\ncreepage_x = 0.1");
        apply(&mut entries, &"--set".into(), "kinematics.speed=60 km/h").unwrap();
        apply(&mut entries, &"--set".into(), "kinematics.creepage_x=").unwrap();
        assert_eq!(entries.len(), 1);
        assert_eq!(entries[0].value.content, Content::Text("60 km/h".to_owned()));
    }

    #[test]
    fn overrides_are_toml_or_text() {
        assert_eq!(override_content("grid.cells_x", "12"), Content::Integer(12));
        assert_eq!(override_content("title", "12"), Content::Text("12".to_owned()));
        assert_eq!(override_content("title", "\"a b\""), Content::Text("a b".to_owned()));
        let load = override_content("normal.load", "60 kN");
        assert_eq!(load, Content::Text("60 kN".to_owned()));
        assert!(matches!(override_content("history.time", "[\"0 s\"]"), Content::Array(_)));
    }
}
