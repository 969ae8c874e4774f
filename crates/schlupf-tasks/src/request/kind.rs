//! How the fields of requests are read.

use schlupf::reporting::quoted;
use schlupf_case::fields::Choice;
use schlupf_case::{CaseError, Family, FieldPath, InputFile, Place, Points, TableColumn};
use schlupf_case::{depths, direction, length, points, position};

use super::form::{Form, Value};

/// What may stand in a field, and how it is read: its type follows, so no field can have a form
/// that its type does not read.
pub struct Kind<T> {
    /// What may stand there.
    pub form: Form,
    /// Reads a value of what is called by a name.
    pub read: Read<T>,
}

/// Reads a value of what is called by a name.
type Read<T> = Box<dyn Fn(&str, &Value) -> Result<T, CaseError>>;

impl<T> Kind<T> {
    /// Reads text; numbers have their units in it.
    fn of_text(form: Form, read: impl Fn(&str, &str) -> Result<T, CaseError> + 'static) -> Self {
        let read = move |name: &str, value: &Value| {
            let text = value.text(form);
            read(name, &text).map_err(|mut error| {
                // A number needs no quotes.
                if !matches!(value, Value::Text(_)) {
                    error.message = error.message.replace(&quoted(&text), &text);
                }
                error
            })
        };
        Self { form, read: Box::new(read) }
    }
}

impl Kind<bool> {
    /// Whether or not.
    pub fn flag() -> Self {
        let read = |name: &str, value: &Value| match value {
            Value::Flag(flag) => Ok(*flag),
            other => Err(wrong(name, &other.text(Form::Flag), "true or false")),
        };
        Self { form: Form::Flag, read: Box::new(read) }
    }
}

impl Kind<usize> {
    /// A whole number between two.
    pub fn count(least: usize, most: usize) -> Self {
        Self::of_text(Form::Count([least, most]), move |name, text| {
            let count = text.trim().parse().ok().filter(|count| (least..=most).contains(count));
            let between = || format!("a whole number between {least} and {most}");
            count.ok_or_else(|| wrong(name, text, &between()))
        })
    }
}

impl Kind<f64> {
    /// A dimensionless number between two.
    pub fn number(least: f64, most: f64) -> Self {
        Self::of_text(Form::Number([least, most]), move |name, text| {
            let number = text.trim().parse().ok();
            let number = number.filter(|number| (least..=most).contains(number));
            number.ok_or_else(|| wrong(name, text, &format!("a number between {least} and {most}")))
        })
    }

    /// A length of any sign.
    pub fn position() -> Self {
        Self::of_text(Form::Position, position)
    }

    /// A length that is not negative.
    pub fn length() -> Self {
        Self::of_text(Form::Length, length)
    }

    /// An angle.
    pub fn angle() -> Self {
        Self::of_text(Form::Angle, direction)
    }
}

impl Kind<Points> {
    /// Lengths that increase from zero or above: two ends, or each of them.
    pub fn depths() -> Self {
        Self::of_text(Form::Depths, depths)
    }

    /// Two ends of what may stand in a field of the case, or each value.
    pub fn points(path: FieldPath) -> Self {
        Self::of_text(Form::Points(path), move |name, text| points(name, path, text))
    }
}

impl Kind<&'static str> {
    /// One of several names.
    pub fn choice(choices: &'static [Choice]) -> Self {
        Self::of_text(Form::Choice(choices), move |name, text| {
            let found = choices.iter().find(|choice| choice.name == text);
            found.map(|choice| choice.name).ok_or_else(|| {
                let names: Vec<_> =
                    choices.iter().map(|choice| format!("{:?}", choice.name)).collect();
                wrong(name, text, &format!("one of {}", names.join(", ")))
            })
        })
    }
}

impl Kind<String> {
    /// Several texts with commas between them, which the task itself reads.
    pub fn list(placeholder: &'static str) -> Self {
        Self::of_text(Form::List(placeholder), |_, text| Ok(text.to_owned()))
    }

    /// What may stand in a field of the case, which reads it.
    pub fn of_case(path: FieldPath) -> Self {
        Self::of_text(Form::OfCase(path), |_, text| Ok(text.to_owned()))
    }
}

impl Kind<InputFile> {
    /// A file that is read.
    pub fn file() -> Self {
        Self::table(&[])
    }

    /// A table that is read, with the columns that it may have.
    pub fn table(columns: &'static [TableColumn]) -> Self {
        Self::of_file(Form::File(columns))
    }

    /// A file that a field of the case names.
    pub fn file_of_case(path: FieldPath) -> Self {
        Self::of_file(Form::OfCase(path))
    }

    fn of_file(form: Form) -> Self {
        let read = move |name: &str, value: &Value| match value {
            Value::File(file) => Ok(file.clone()),
            other => Err(wrong(name, &other.text(form), "a file")),
        };
        Self { form, read: Box::new(read) }
    }
}

impl Kind<Family> {
    /// A field of the case with values.
    pub fn family() -> Self {
        Self::of_text(Form::Family, |name, text| Family::parse(name, text))
    }
}

fn wrong(name: &str, text: &str, requirement: &str) -> CaseError {
    let place = Place::Override { option: name.to_owned().into(), text: text.to_owned() };
    CaseError::new("", format!("{name} must be {requirement}, but is {}", quoted(text)), place)
}

/// The type of a field, which says how often it is given.
pub trait FieldType: Sized {
    /// That of one value.
    type Value;
    /// How often it is given.
    const NEED: Need;

    /// The field with its values, if there are enough of them.
    fn of(values: Vec<Self::Value>) -> Option<Self>;
}

impl<T> FieldType for Option<T> {
    type Value = T;
    const NEED: Need = Need::Optional;

    fn of(mut values: Vec<T>) -> Option<Self> {
        Some(values.pop())
    }
}

impl<T> FieldType for Vec<T> {
    type Value = T;
    const NEED: Need = Need::Several;

    fn of(values: Vec<T>) -> Option<Self> {
        Some(values)
    }
}

/// Types of fields that are given once.
macro_rules! once {
    ($($type:ty),*) => {
        $(impl FieldType for $type {
            type Value = Self;
            const NEED: Need = Need::Once;

            fn of(mut values: Vec<Self>) -> Option<Self> {
                values.pop()
            }
        })*
    };
}

once!(bool, usize, f64, Points, &'static str, String, InputFile, Family);

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
