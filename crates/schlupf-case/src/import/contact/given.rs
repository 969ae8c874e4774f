//! A value of an input file with its name and its place.

use std::sync::Arc;

use crate::{Place, Source};

/// Where a value stands.
#[derive(Debug, Clone, Copy, Default)]
pub struct At {
    /// Its line, numbered from 1.
    pub line: usize,
    /// Its first byte, and the one behind its last.
    pub bytes: [usize; 2],
}

impl At {
    /// The same in the text of the file.
    pub fn place(self, source: &Arc<Source>) -> Place {
        let [start, end] = self.bytes;
        Place::Text { source: Arc::clone(source), span: start..end }
    }
}

/// A number of an input file.
#[derive(Debug, Clone, Copy)]
pub struct Given {
    /// What CONTACT's user guide calls it.
    pub name: &'static str,
    /// In the unit of the input file: mm, N, N/mm², mm/s, rad, s, °C; dimensionless for a digit.
    pub value: f64,
    /// Its place.
    pub at: At,
}

/// Two are alike if their values are, wherever they stand.
impl PartialEq for Given {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl Given {
    /// It as a whole number; what is none, or out of reach of one, is zero.
    pub fn whole(self) -> i64 {
        self.value as i64
    }

    /// Whether it is this whole number.
    pub fn is(self, number: i64) -> bool {
        self.value == number as f64
    }
}

/// Text of an input file.
#[derive(Debug, Clone)]
pub struct GivenText {
    /// The text without its quotes.
    pub text: String,
    /// Its place.
    pub at: At,
}

/// Two are alike if their texts are, wherever they stand.
impl PartialEq for GivenText {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

/// Name and form of a number that is to be read.
#[derive(Debug, Clone, Copy)]
pub struct Item {
    /// What CONTACT's user guide calls it.
    pub name: &'static str,
    /// How it is written.
    pub form: Form,
}

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A whole number.
    Whole,
    /// Any number.
    Real,
    /// In radians, or with a `d` at its end in degrees.
    Angle,
}

/// A whole number.
pub const fn whole(name: &'static str) -> Item {
    Item { name, form: Form::Whole }
}

/// Any number.
pub const fn real(name: &'static str) -> Item {
    Item { name, form: Form::Real }
}

/// An angle.
pub const fn angle(name: &'static str) -> Item {
    Item { name, form: Form::Angle }
}

impl Item {
    /// What a word stands for, if it has this form.
    pub fn number(self, word: &str) -> Option<f64> {
        match self.form {
            Form::Whole => word.parse::<i32>().ok().map(f64::from),
            Form::Real => real_number(word),
            Form::Angle => {
                if let Some(degrees) = word.strip_suffix(['d', 'D']) {
                    return real_number(degrees).map(f64::to_radians);
                }
                real_number(word.strip_suffix(['r', 'R']).unwrap_or(word))
            }
        }
    }

    /// What it must be.
    pub fn form_name(self) -> &'static str {
        match self.form {
            Form::Whole => "a whole number",
            Form::Real => "a number",
            Form::Angle => "an angle, such as 0.1 (rad) or 5d (degrees)",
        }
    }
}

/// A number as Fortran writes it: `e` or `d` before the exponent, or its sign alone.
fn real_number(word: &str) -> Option<f64> {
    // Rust takes names for infinity and for what is no number; the file may not have these.
    if !word.chars().all(|c| c.is_ascii_digit() || "+-.eEdD".contains(c)) {
        return None;
    }
    let mut number = word.replace(['d', 'D', 'E'], "e");
    if !number.contains('e')
        && let Some(sign) = number.rfind(['+', '-']).filter(|sign| *sign > 0)
    {
        number.insert(sign, 'e');
    }
    number.parse::<f64>().ok().filter(|number| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_fortran_writes_them() {
        let cases = [
            (real("X"), "1d-5", Some(1e-5)),
            (real("X"), "-.5", Some(-0.5)),
            (real("X"), "106700.", Some(106_700.0)),
            (real("X"), ".1-07", Some(1e-8)),
            (real("X"), "-2.5+3", Some(-2500.0)),
            (real("X"), "1.5D+02", Some(150.0)),
            (real("X"), "1-", None),
            (real("X"), "1-2.5", None),
            (real("X"), "1-2-3", None),
            (real("X"), "nan", None),
            (real("X"), "inf", None),
            (real("X"), "1e999", None),
            (real("X"), "FN", None),
            (angle("X"), "180d", Some(std::f64::consts::PI)),
            (angle("X"), "180.d", Some(std::f64::consts::PI)),
            (angle("X"), "18.+1d", Some(std::f64::consts::PI)),
            (angle("X"), "0.25r", Some(0.25)),
            (angle("X"), "0.25", Some(0.25)),
            (whole("X"), "-3", Some(-3.0)),
            (whole("X"), "3.5", None),
        ];
        for (item, word, expected) in cases {
            assert_eq!(item.number(word), expected, "{word}");
        }
    }
}
