//! Unit expressions: products, quotients and powers of unit symbols.
//!
//! ```text
//! expression = ["/"] power { ["*" | "·" | "×" | "/"] power }     read from left to right
//! power      = atom [ ["^"] integer | superscripts ]
//! atom       = symbol | "1" | "(" expression ")"
//! ```

use std::iter::Peekable;
use std::str::Chars;

use super::error::QuantityError;
use super::symbol::{Unit, look_up};

/// No unit of physics needs more; it bounds the depth of the recursion.
const MAX_LENGTH: usize = 80;
/// Exponents beyond this are typing errors.
const MAX_EXPONENT: i32 = 9;

/// The unit that an expression such as `W/(m K)` stands for.
pub(super) fn parse(text: &str) -> Result<Unit, QuantityError> {
    let mut parser = Parser { text, rest: text.chars().peekable() };
    if text.len() > MAX_LENGTH {
        return Err(parser.malformed());
    }
    let unit = parser.expression()?;
    if parser.rest.peek().is_some() {
        return Err(parser.malformed());
    }
    Ok(unit)
}

struct Parser<'a> {
    text: &'a str,
    rest: Peekable<Chars<'a>>,
}

impl Parser<'_> {
    fn expression(&mut self) -> Result<Unit, QuantityError> {
        self.skip_spaces();
        let mut unit = match self.rest.peek() {
            Some('/') => Unit::ONE,
            _ => self.power()?,
        };
        loop {
            self.skip_spaces();
            match self.rest.peek() {
                None | Some(')') => return Ok(unit),
                Some('/') => {
                    self.rest.next();
                    unit = unit.times(self.power()?, -1);
                }
                Some('*' | '·' | '⋅' | '×') => {
                    self.rest.next();
                    unit = unit.times(self.power()?, 1);
                }
                Some(_) => unit = unit.times(self.power()?, 1),
            }
        }
    }

    fn power(&mut self) -> Result<Unit, QuantityError> {
        self.skip_spaces();
        let (base, may_have_digits) = match self.rest.peek() {
            Some('(') => {
                self.rest.next();
                let inner = self.expression()?;
                self.rest.next_if_eq(&')').ok_or_else(|| self.malformed())?;
                (inner, true)
            }
            Some('1') => {
                self.rest.next();
                (Unit::ONE, false)
            }
            _ => (self.symbol()?, true),
        };
        match self.exponent(may_have_digits)? {
            Some(exponent) => Ok(Unit::ONE.times(base, exponent)),
            None => Ok(base),
        }
    }

    fn symbol(&mut self) -> Result<Unit, QuantityError> {
        let mut name = String::new();
        while let Some(c) = self.rest.next_if(|c| c.is_alphabetic() || *c == '°' || *c == '%') {
            name.push(c);
        }
        if name.is_empty() {
            return Err(self.malformed());
        }
        look_up(&name).ok_or(QuantityError::UnknownUnit { symbol: name })
    }

    /// `^-2`, `-2`, `2` or `⁻²`; bare digits only after a symbol or a parenthesis.
    fn exponent(&mut self, may_have_digits: bool) -> Result<Option<i32>, QuantityError> {
        let caret = self.rest.next_if_eq(&'^').is_some();
        let mut digits = String::new();
        if caret || may_have_digits {
            while let Some(c) = self.rest.next_if(|c| exponent_digit(*c).is_some()) {
                digits.extend(exponent_digit(c));
            }
        }
        if digits.is_empty() && !caret {
            return Ok(None);
        }
        match digits.parse() {
            Ok(exponent) if (-MAX_EXPONENT..=MAX_EXPONENT).contains(&exponent) => {
                Ok(Some(exponent))
            }
            _ => Err(self.malformed()),
        }
    }

    fn skip_spaces(&mut self) {
        while self.rest.next_if(|c| c.is_whitespace()).is_some() {}
    }

    fn malformed(&self) -> QuantityError {
        QuantityError::MalformedUnit { text: self.text.to_owned() }
    }
}

/// The ASCII character of a digit or sign, raised or not.
fn exponent_digit(c: char) -> Option<char> {
    match c {
        '0'..='9' | '-' => Some(c),
        '−' | '⁻' => Some('-'),
        '⁰' => Some('0'),
        '¹' => Some('1'),
        '²' => Some('2'),
        '³' => Some('3'),
        '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::dimension::Dimension;
    use super::*;
    use approx::assert_relative_eq;

    #[track_caller]
    fn assert_same(first: &str, second: &str) {
        let first = parse(first).unwrap();
        let second = parse(second).unwrap();
        assert_eq!(first.dimension, second.dimension);
        assert_relative_eq!(first.factor, second.factor, max_relative = 1e-15);
    }

    #[test]
    fn one_unit_has_many_spellings() {
        for spelling in ["W/m/K", "W/(m·K)", "W/(m*K)", "W m^-1 K^-1", "W·m⁻¹·K⁻¹", "W m-1 K-1"]
        {
            assert_same(spelling, "W/(m K)");
        }
        for spelling in ["kg/m3", "kg/m³", "kg m^-3", "kg m⁻³", "(kg)/(m m m)"] {
            assert_same(spelling, "kg/m^3");
        }
        assert_same("/m", "1/m");
        assert_same("(m)^2", "m^2");
        assert_same("m⁹", "m^9");
    }

    #[test]
    fn quotients_are_read_from_left_to_right() {
        assert_eq!(parse("W/m K").unwrap().dimension, parse("W K/m").unwrap().dimension);
        assert_same("J/kg/K", "J/(kg K)");
    }

    #[test]
    fn prefixes_are_raised_with_their_unit() {
        assert_relative_eq!(parse("1/mm").unwrap().factor, 1e3, max_relative = 1e-15);
        assert_relative_eq!(parse("N/mm^3").unwrap().factor, 1e9, max_relative = 1e-14);
        assert_relative_eq!(parse("km/h").unwrap().factor, 1.0 / 3.6, max_relative = 1e-15);
    }

    #[test]
    fn powers_and_inverses_cancel() {
        for unit in ["m", "kN", "GPa", "W/(m K)", "deg", "ms", "J/kg/K"] {
            for exponent in -4..=4 {
                let product =
                    parse(&format!("({unit})^{exponent} ({unit})^{}", -exponent)).unwrap();
                assert_eq!(product.dimension, Dimension::NONE);
                assert_relative_eq!(product.factor, 1.0, max_relative = 1e-14);
            }
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for text in ["", "m^", "m^x", "m^99", "(m", "m)", "2 m", "m//s", "m/", "()", "*", "m^--1"] {
            assert!(parse(text).is_err(), "{text:?} was accepted");
        }
        assert!(parse(&"(".repeat(100_000)).is_err());
        let unknown = QuantityError::UnknownUnit { symbol: "furlong".to_owned() };
        assert_eq!(parse("furlong/h"), Err(unknown));
    }
}
