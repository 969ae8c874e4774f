//! The text of a case file.

use std::fmt::Write;

use crate::fields::{FieldPath, SECTIONS};

/// Digits of a number after its first one: enough for any input that people write, few enough to
/// hide the rounding of conversions.
const DIGITS: usize = 12;
/// Below it numbers have an exponent.
const SMALL: f64 = 1e-4;

/// A case file that is being written.
#[derive(Debug, Clone, Default)]
pub struct Document {
    /// Title of the case.
    pub title: String,
    /// Lines of the comment above it.
    pub comments: Vec<String>,
    fields: Vec<Field>,
    /// Files that the case names.
    pub files: Vec<(String, Vec<u8>)>,
}

/// A field with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Its path.
    pub path: FieldPath,
    /// Its value in TOML.
    value: String,
    /// The value as one number with its unit, which is empty where it has no dimension.
    pub number: Option<(String, String)>,
}

impl Field {
    /// Whether it is that of another case, or differs in its number only.
    pub fn is_like(&self, other: &Self) -> bool {
        let unit = |field: &Self| field.number.as_ref().map(|(_, unit)| unit.clone());
        let is_number = self.number.is_some() && unit(self) == unit(other);
        self.path == other.path && (is_number || self.value == other.value)
    }
}

impl Document {
    /// A dimensionless number.
    pub fn number(&mut self, path: FieldPath, value: f64) {
        let text = number(value);
        // TOML tells whole numbers from others.
        let is_whole = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'-');
        let value = if is_whole { format!("{text}.0") } else { text.clone() };
        self.set(path, value, Some((text, String::new())));
    }

    /// All fields, in the order in which they were given.
    pub fn fields(&self) -> &[Field] {
        &self.fields
    }

    /// A whole number.
    pub fn count(&mut self, path: FieldPath, value: usize) {
        let text = value.to_string();
        self.set(path, text.clone(), Some((text, String::new())));
    }

    /// A number with its unit.
    pub fn quantity(&mut self, path: FieldPath, value: f64, unit: &str) {
        self.set(path, quantity(value, unit), Some((number(value), unit.to_owned())));
    }

    /// Text, such as one of several names.
    pub fn text(&mut self, path: FieldPath, text: &str) {
        self.set(path, quoted(text), None);
    }

    /// Dimensionless numbers.
    pub fn numbers(&mut self, path: FieldPath, values: &[f64]) {
        let values: Vec<String> = values
            .iter()
            .map(|value| {
                let text = number(*value);
                if text.contains(['.', 'e']) { text } else { format!("{text}.0") }
            })
            .collect();
        self.set(path, format!("[{}]", values.join(", ")), None);
    }

    /// Numbers with their unit.
    pub fn quantities(&mut self, path: FieldPath, values: &[f64], unit: &str) {
        let values: Vec<String> = values.iter().map(|value| quantity(*value, unit)).collect();
        self.set(path, format!("[{}]", values.join(", ")), None);
    }

    fn set(&mut self, path: FieldPath, value: String, number: Option<(String, String)>) {
        let field = Field { path, value, number };
        // What is given twice has its last value.
        match self.fields.iter_mut().find(|known| known.path == path) {
            Some(known) => *known = field,
            None => self.fields.push(field),
        }
    }

    /// The text of the file.
    pub fn to_toml(&self) -> String {
        let mut text = String::new();
        for comment in &self.comments {
            for line in wrapped(comment) {
                // Writing to a string cannot fail.
                let _ = writeln!(text, "# {line}");
            }
        }
        let _ = writeln!(text, "\ntitle = {}", quoted(&self.title));
        for section in SECTIONS.iter().map(|section| section.name) {
            let fields: Vec<_> =
                self.fields.iter().filter(|field| field.path.section() == section).collect();
            if !fields.is_empty() {
                let _ = writeln!(text, "\n[{section}]");
            }
            for field in fields {
                let _ = writeln!(text, "{} = {}", field.path.name(), field.value);
            }
        }
        text
    }
}

/// A number without the noise of conversions, as short as it can be.
pub fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.DIGITS$e}").parse().unwrap_or(value);
    // Minus zero is zero.
    let rounded = if rounded == 0.0 { 0.0 } else { rounded };
    let size = rounded.abs();
    if size != 0.0 && !(SMALL..1e12).contains(&size) {
        format!("{rounded:e}")
    } else {
        rounded.to_string()
    }
}

fn quantity(value: f64, unit: &str) -> String {
    quoted(&format!("{} {unit}", number(value)))
}

pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            control if control.is_control() => quoted.push(' '),
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}

/// Words in lines of a width.
fn wrapped(text: &str) -> Vec<String> {
    const WIDTH: usize = 96;
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split_whitespace() {
        let fits = lines.last().is_none_or(|line| {
            line.is_empty() || line.chars().count() + 1 + word.chars().count() <= WIDTH
        });
        if !fits {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_is_toml_in_the_order_of_a_case_file() {
        let mut document = Document { title: "a \"b\"".to_owned(), ..Document::default() };
        document.comments.push("from a.inp".to_owned());
        document.quantity(field!("normal.load"), 52_359.878 / 1e3, "kN");
        document.number(field!("kinematics.creepage_x"), -0.0);
        document.number(field!("kinematics.creepage_y"), 1e-5);
        document.count(field!("grid.cells_x"), 20);
        document.quantities(field!("history.time"), &[0.0, 0.1 + 0.2], "s");
        let expected = "# from a.inp\n\ntitle = \"a \\\"b\\\"\"\n\n[kinematics]\ncreepage_x = 0.0\n\
                        creepage_y = 1e-5\n\n[normal]\nload = \"52.359878 kN\"\n\n[grid]\n\
                        cells_x = 20\n\n[history]\ntime = [\"0 s\", \"0.3 s\"]\n";
        assert_eq!(document.to_toml(), expected);
    }
}
