//! What may stand in the fields of requests, as all faces show it.

use schlupf_case::fields::{self, Choice};
use schlupf_case::{FieldPath, InputFile, TableColumn};

/// What may stand in a field. Numbers without unit from Python are in SI units.
#[derive(Debug, Clone, Copy)]
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
    /// Lengths that increase from zero or above: two ends, or each of them.
    Depths,
    /// An angle.
    Angle,
    /// Two ends of what may stand in a field of the case, or each value.
    Points(FieldPath),
    /// One of several names.
    Choice(&'static [Choice]),
    /// A field of the case with values, `section.field=value,…`.
    Family,
    /// A file that is read; the columns that it may have, if it is a table.
    File(&'static [TableColumn]),
    /// Several texts with commas between them, and what stands for them in help.
    List(&'static str),
    /// What may stand in a field of the case.
    OfCase(FieldPath),
}

impl Form {
    /// What may stand in the field of the case, if that decides.
    pub fn of_case(self) -> Option<fields::Kind> {
        let Self::OfCase(path) = self else { return None };
        Some(path.field().kind)
    }

    /// Whether it is given or not, without a value.
    pub fn is_flag(self) -> bool {
        matches!(self, Self::Flag) || matches!(self.of_case(), Some(fields::Kind::Flag))
    }

    /// Whether it is a file that is read.
    pub fn is_file(self) -> bool {
        matches!(self, Self::File(_)) || matches!(self.of_case(), Some(fields::Kind::Path))
    }

    /// The columns of the tables that a file may be.
    pub fn tables(self) -> Vec<&'static [TableColumn]> {
        match self {
            Self::File(columns) if !columns.is_empty() => vec![columns],
            Self::OfCase(path) => path.field().columns.to_vec(),
            _ => Vec::new(),
        }
    }

    /// Whether it is a range or each of several values.
    pub fn is_points(self) -> bool {
        matches!(self, Self::Depths | Self::Points(_))
    }

    /// Whether it begins with a number that may have a sign, if a wrong one.
    pub fn is_signed(self) -> bool {
        matches!(self, Self::Points(_)) || !self.unit().is_empty()
    }

    /// The names that may stand there, where it is one of several.
    pub fn choices(self) -> &'static [Choice] {
        match self {
            Self::Choice(choices) => choices,
            other => other.of_case().map_or(&[], fields::Kind::choices),
        }
    }

    /// The unit of its numbers; empty where they are dimensionless or there are none.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Position | Self::Length | Self::Depths => "m",
            Self::Angle => "rad",
            Self::Points(path) => path.field().kind.unit(),
            other => other.of_case().map_or("", fields::Kind::unit),
        }
    }

    /// Bounds of its numbers, where it has some.
    pub fn bounds(self) -> [Option<f64>; 2] {
        match self {
            Self::Count(ends) => ends.map(|end| Some(end as f64)),
            Self::Number(ends) => ends.map(Some),
            _ => [None; 2],
        }
    }

    /// What stands for it in help.
    pub fn placeholder(self) -> String {
        let placeholder = match self {
            Self::Flag => "",
            Self::Count(_) => "N",
            Self::Number(_) => "NUMBER",
            Self::Position | Self::Length => "LENGTH",
            Self::Depths | Self::Points(_) => "START..END|VALUE,…",
            Self::Angle => "ANGLE",
            Self::Choice(_) => "NAME",
            Self::Family => "SECTION.FIELD=VALUE,…",
            Self::File(_) => "FILE",
            Self::List(placeholder) => placeholder,
            Self::OfCase(_) => return self.of_case().map_or_else(String::new, of_kind),
        };
        placeholder.to_owned()
    }
}

/// What stands for a value of a case in help.
fn of_kind(kind: fields::Kind) -> String {
    use fields::Kind;
    let measured = |name: &str| name.rsplit(' ').next().unwrap_or(name).to_uppercase();
    match kind {
        Kind::Quantity(measure) => measured(measure.name),
        Kind::Quantities(measure) => {
            let each = measured(measure.name);
            format!("START..END|{each},…")
        }
        Kind::Number => "NUMBER".to_owned(),
        Kind::Count => "N".to_owned(),
        Kind::Flag => String::new(),
        Kind::Choice(_) | Kind::NumberOr(_) => "NAME".to_owned(),
        Kind::Text => "TEXT".to_owned(),
        Kind::Path => "FILE".to_owned(),
        Kind::Numbers => "NUMBER,…".to_owned(),
    }
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
    /// Start and end of a range.
    Range(Box<[Value; 2]>),
    /// Several values: those of a list or of a field that is given several times.
    List(Vec<Value>),
    /// A file.
    File(InputFile),
}

impl Value {
    /// As text, numbers with a unit; a flag that is raised needs none.
    pub fn text(&self, form: Form) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => format!("{number} {}", form.unit()).trim_end().to_owned(),
            Self::Flag(true) if form.is_flag() => String::new(),
            Self::Flag(flag) => flag.to_string(),
            Self::File(file) => file.path().display().to_string(),
            Self::Range(ends) => ends.each_ref().map(|end| end.text(form)).join(".."),
            Self::List(parts) => {
                let parts: Vec<String> = parts.iter().map(|part| part.text(form)).collect();
                parts.join(",")
            }
        }
    }
}
