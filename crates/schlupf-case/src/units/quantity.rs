//! Text of a number and a unit to a value in SI units.

use super::dimension::Dimension;
use super::error::QuantityError;
use super::expression;
use super::measure::{Measure, Scale};

/// Value in SI units (temperatures in degC) of a text such as `"108 km/h"`. Infinity needs no unit.
pub fn parse_quantity(text: &str, measure: &Measure) -> Result<f64, QuantityError> {
    let (number, unit) = split_number(text.trim())?;
    if !number.is_finite() && unit.is_empty() {
        return Ok(number);
    }
    let convert = parse_unit(unit, measure)?;
    Ok(convert.apply(number))
}

/// How a number of some unit becomes one of the measure's SI unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conversion {
    factor: f64,
    offset: f64,
}

impl Conversion {
    /// The value in the SI unit (degC for temperatures).
    pub fn apply(&self, number: f64) -> f64 {
        // 1e-6 has no exact binary form, but 1e6 has.
        let inverse = self.factor.recip();
        let is_part = self.factor < 1.0 && inverse.fract() == 0.0;
        let scaled = if is_part { number / inverse } else { number * self.factor };
        scaled + self.offset
    }
}

/// How files name the unit of levels.
const LEVEL_UNITS: [&str; 4] = ["dB", "dB re 1 um", "dB re 1 µm", "dB re 1 μm"];

/// How a number of the unit becomes one of the measure's SI unit.
pub fn parse_unit(unit: &str, measure: &Measure) -> Result<Conversion, QuantityError> {
    let unit = unit.trim();
    if unit.is_empty() {
        return Err(QuantityError::NoUnit);
    }
    match (measure.scale, absolute_temperature(unit)) {
        (Scale::AbsoluteTemperature, Some(conversion)) => Ok(conversion),
        (Scale::Level, _) if LEVEL_UNITS.contains(&unit) => {
            Ok(Conversion { factor: 1.0, offset: 0.0 })
        }
        (Scale::AbsoluteTemperature | Scale::Level, _) => {
            let parsed = expression::parse(unit)?;
            Err(wrong_dimension(unit, parsed.dimension))
        }
        (scale, Some(_)) if unit != "K" => {
            if scale.takes(Dimension::TEMPERATURE) {
                return Err(QuantityError::TemperatureForDifference { unit: unit.to_owned() });
            }
            let kind = "a temperature scale, not a unit".to_owned();
            Err(QuantityError::WrongDimension { unit: unit.to_owned(), kind })
        }
        (scale, _) => {
            let parsed = expression::parse(unit)?;
            if !scale.takes(parsed.dimension) {
                return Err(wrong_dimension(unit, parsed.dimension));
            }
            Ok(Conversion { factor: parsed.factor, offset: 0.0 })
        }
    }
}

fn wrong_dimension(unit: &str, dimension: Dimension) -> QuantityError {
    let named = Measure::RATIOS.into_iter().find(|m| m.scale.takes(dimension));
    let kind = match named {
        Some(measure) => format!("the unit of {}", measure.name),
        None if dimension == Dimension::NONE => "without dimension".to_owned(),
        None => format!("{dimension} in SI base units"),
    };
    QuantityError::WrongDimension { unit: unit.to_owned(), kind }
}

/// The dimension of a unit that is no temperature scale.
///
/// # Errors
/// What is no unit.
pub fn dimension(unit: &str) -> Result<Dimension, QuantityError> {
    Ok(expression::parse(unit)?.dimension)
}

/// From an absolute temperature scale to degC.
fn absolute_temperature(unit: &str) -> Option<Conversion> {
    match unit {
        "degC" | "°C" | "\u{2103}" => Some(Conversion { factor: 1.0, offset: 0.0 }),
        "K" => Some(Conversion { factor: 1.0, offset: -273.15 }),
        "degF" | "°F" => Some(Conversion { factor: 5.0 / 9.0, offset: -160.0 / 9.0 }),
        _ => None,
    }
}

/// The number in front, and what follows it. `inf` and `nan` are numbers, for the check that comes
/// later to name them.
fn split_number(text: &str) -> Result<(f64, &str), QuantityError> {
    let (negative, unsigned) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let sign = if negative { -1.0 } else { 1.0 };
    for (word, value) in [("inf", f64::INFINITY), ("nan", f64::NAN)] {
        let is_word = unsigned.get(..3).is_some_and(|start| start.eq_ignore_ascii_case(word));
        if is_word && !unsigned[3..].starts_with(char::is_alphabetic) {
            return Ok((sign * value, &unsigned[3..]));
        }
    }
    let (digits, rest) = unsigned.split_at(number_length(unsigned));
    let number: f64 = digits.parse().map_err(|_| QuantityError::NoNumber)?;
    if rest.starts_with(',') {
        return Err(QuantityError::Comma { readings: comma_readings(text) });
    }
    if number.is_infinite() {
        return Err(QuantityError::TooLarge);
    }
    Ok((sign * number, rest))
}

/// What a text that begins with a number with a comma may mean: with thousands or decimals after
/// the comma, or both. Empty where there is no such number.
pub fn comma_readings(text: &str) -> Vec<String> {
    let is_of_number = |c: char| c.is_ascii_digit() || ".,".contains(c);
    let signed = text.trim_start_matches(['-', '+', '−']);
    let sign = &text[..text.len() - signed.len()];
    let (digits, rest) = signed.split_at(signed.find(|c| !is_of_number(c)).unwrap_or(signed.len()));
    let Some((before, after)) = digits.rsplit_once(',') else { return Vec::new() };
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let thousands = groups(whole, ',').filter(|_| !decimals.contains(['.', ',']));
    let thousands = thousands.map(|whole| format!("{whole}.{decimals}"));
    let is_fraction = !after.is_empty() && after.chars().all(|c| c.is_ascii_digit());
    let plain = Some(before).filter(|before| before.chars().all(|c| c.is_ascii_digit()));
    let whole = plain.map(str::to_owned).or_else(|| groups(before, '.'));
    let decimals = whole.filter(|_| is_fraction).map(|whole| format!("{whole}.{after}"));
    let numbers = thousands.into_iter().chain(decimals).filter_map(|text| text.parse::<f64>().ok());
    numbers.map(|number| format!("{sign}{number}{rest}")).collect()
}

/// A whole number without the separators of its thousands, if it is one with such separators.
fn groups(text: &str, separator: char) -> Option<String> {
    let mut parts = text.split(separator);
    let first = parts.next().filter(|first| (1..=3).contains(&first.len()))?;
    let is_number = |part: &str| part.chars().all(|c| c.is_ascii_digit());
    let are_thousands = is_number(first)
        && !first.starts_with('0')
        && text.contains(separator)
        && parts.all(|part| part.len() == 3 && is_number(part));
    are_thousands.then(|| text.replace(separator, ""))
}

/// Length of the decimal number that a text begins with: digits, point, exponent.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits(0);
    if text[end..].starts_with('.') {
        end += 1 + digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let signed = text[end + 1..].starts_with(['+', '-']);
        let start = end + 1 + usize::from(signed);
        let length = digits(start);
        if length > 0 {
            return start + length;
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[track_caller]
    fn assert_value(text: &str, measure: &Measure, expected: f64) {
        let value = parse_quantity(text, measure).unwrap();
        assert_relative_eq!(value, expected, max_relative = 1e-14);
    }

    /// 10 · 1e-6 is 9.999999999999999e-6.
    #[test]
    fn parts_of_units_are_the_nearest_numbers() {
        let value = |text, measure| parse_quantity(text, measure).unwrap();
        assert_eq!(value("10 um", &Measure::LENGTH), 1e-5);
        assert_eq!(value("0.7 mm", &Measure::LENGTH), 0.7e-3);
        assert_eq!(value("3 ms", &Measure::TIME), 3e-3);
    }

    #[test]
    fn quantities_of_the_interface_are_read() {
        assert_value("108 km/h", &Measure::SPEED, 30.0);
        assert_value("80 kN", &Measure::FORCE, 80e3);
        assert_value("5e6 1/m", &Measure::PER_LENGTH, 5e6);
        assert_value("5e6/m", &Measure::PER_LENGTH, 5e6);
        assert_value("1.0e13 N/m^3", &Measure::BEDDING, 1e13);
        assert_value("3.24e7 N/m", &Measure::STIFFNESS, 3.24e7);
        assert_value("50 W/(m K)", &Measure::CONDUCTIVITY, 50.0);
        assert_value("450 J/(kg K)", &Measure::SPECIFIC_HEAT, 450.0);
        assert_value("7850 kg/m³", &Measure::DENSITY, 7850.0);
        assert_value("0.5 deg", &Measure::ANGLE, 0.5_f64.to_radians());
        assert_value("0.5°", &Measure::ANGLE, 0.5_f64.to_radians());
        assert_value("64.7 rad/s", &Measure::ANGULAR_VELOCITY, 64.7);
        assert_value("60 rpm", &Measure::ANGULAR_VELOCITY, 2.0 * std::f64::consts::PI);
        assert_value("1 GPa", &Measure::PRESSURE, 1e9);
        assert_value("-300mm", &Measure::LENGTH, -0.3);
        assert_value("1 ms", &Measure::TIME, 1e-3);
    }

    #[test]
    fn temperatures_are_converted_and_differences_are_not() {
        assert_value("20 degC", &Measure::TEMPERATURE, 20.0);
        assert_eq!(parse_quantity("inf", &Measure::LENGTH), Ok(f64::INFINITY));
        assert_eq!(parse_quantity("-inf m", &Measure::LENGTH), Ok(f64::NEG_INFINITY));
        assert_value("−20 °C", &Measure::TEMPERATURE, -20.0);
        assert_value("293.15 K", &Measure::TEMPERATURE, 20.0);
        assert_value("68 degF", &Measure::TEMPERATURE, 20.0);
        assert_value("700 K", &Measure::TEMPERATURE_DIFFERENCE, 700.0);
        assert_eq!(
            parse_quantity("700 degC", &Measure::TEMPERATURE_DIFFERENCE),
            Err(QuantityError::TemperatureForDifference { unit: "degC".to_owned() })
        );
    }

    #[test]
    fn what_is_wrong_is_told_apart() {
        let speed = |text| parse_quantity(text, &Measure::SPEED).unwrap_err().to_string();
        assert_eq!(speed("108 kN"), "`kN` is the unit of a force");
        assert_eq!(speed("108"), "the unit is missing");
        assert_eq!(speed("fast"), "there is no number in front");
        assert_eq!(speed(""), "there is no number in front");
        assert_eq!(speed("1,5 m/s"), "a comma is no decimal point: write 1.5 m/s");
        assert_eq!(speed("108 kmh"), "unknown unit `kmh`");
        assert_eq!(speed("108 km/"), "`km/` is not a product or quotient of units");
        assert_eq!(speed("1e999 m/s"), "the number is too large");
    }

    /// Issue 38: `80,000 N` was told to use a point, and is 80 N then.
    #[test]
    fn a_comma_that_may_be_of_thousands_or_decimals_is_told_both_ways() {
        let readings = |text| comma_readings(text).join(" | ");
        assert_eq!(readings("80,000 N"), "80000 N | 80 N");
        assert_eq!(readings("-1,234 mm"), "-1234 mm | -1.234 mm");
        assert_eq!(readings("1,234,567 N"), "1234567 N");
        assert_eq!(readings("1,234.5 N"), "1234.5 N");
        assert_eq!(readings("1.234,5 N"), "1234.5 N");
        assert_eq!(readings("0,008"), "0.008");
        assert_eq!(readings("1,5e3 N"), "1.5e3 N");
        assert_eq!(readings("1,,5"), "");
        assert_eq!(readings("80 kN"), "");
        let force = parse_quantity("80,000 N", &Measure::FORCE).unwrap_err().to_string();
        assert_eq!(force, "a comma may separate thousands or decimals: write 80000 N or 80 N");
    }

    /// Spin is an angle per length; an angle is no part of other inverse lengths.
    #[test]
    fn spin_has_units_with_and_without_an_angle() {
        assert_value("2 1/m", &Measure::SPIN, 2.0);
        assert_value("2 rad/m", &Measure::SPIN, 2.0);
        assert_value("2e-3 rad/mm", &Measure::SPIN, 2.0);
        assert_value("2 mrad/mm", &Measure::SPIN, 2.0);
        assert_value("180 deg/m", &Measure::SPIN, std::f64::consts::PI);
        assert!(parse_quantity("2 rad^2/m", &Measure::SPIN).is_err());
        assert!(parse_quantity("2 rad", &Measure::SPIN).is_err());
        let other = parse_quantity("2 rad/m", &Measure::PER_LENGTH).unwrap_err().to_string();
        assert_eq!(other, "`rad/m` is the unit of an inverse length or an angle per length");
    }

    #[test]
    fn the_units_of_every_measure_are_read() {
        for measure in Measure::RATIOS.iter().chain([&Measure::TORQUE, &Measure::TEMPERATURE]) {
            for unit in measure.units() {
                assert!(parse_unit(unit, measure).is_ok(), "{}: {unit}", measure.name);
            }
        }
    }

    #[test]
    fn a_frequency_is_no_angular_velocity() {
        assert!(parse_quantity("10 Hz", &Measure::ANGULAR_VELOCITY).is_err());
        assert!(parse_quantity("10 1/s", &Measure::ANGULAR_VELOCITY).is_err());
    }

    #[test]
    fn numbers_survive_the_way_through_text() {
        for exponent in -30..=30 {
            for mantissa in [1.0, -2.5, 9.999_999_999_999_9] {
                let value = mantissa * 10f64.powi(exponent);
                for text in [format!("{value:e} m"), format!("{value} m"), format!("{value:e}m")] {
                    assert_eq!(parse_quantity(&text, &Measure::LENGTH), Ok(value), "{text}");
                }
            }
        }
    }

    #[test]
    fn no_text_makes_it_panic() {
        let pieces = [
            "", " ", "-", "1", ".", "e", "E+", "inf", "nan", "m", "°", "µ", "/", "(", ")", "^",
            "³", "𝛼",
        ];
        for a in pieces {
            for b in pieces {
                for c in pieces {
                    for d in pieces {
                        let _ = parse_quantity(&format!("{a}{b}{c}{d}"), &Measure::LENGTH);
                    }
                }
            }
        }
    }
}
