//! Ranges of a field and directions, as the command line gives them.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::FieldPath;
use crate::document::{Content, Value};
use crate::error::CaseError;
use crate::fields::{self, Allowed, Field, Kind, Requirement};
use crate::place::Place;
use crate::setting::{Refusal, Setting};
use crate::units::Measure;
use schlupf::analysis::creep_curve::MAX_POINTS;
use schlupf::reporting::quoted;

/// Where along a quantity something is computed, in its SI unit.
#[derive(Debug, Clone, PartialEq)]
pub enum Points {
    /// Between these two ends, which differ.
    Range([f64; 2]),
    /// At each of these, two at least, which increase or decrease from one to the next.
    Each(Vec<f64>),
}

impl Points {
    /// The first and the last.
    pub fn ends(&self) -> [f64; 2] {
        match self {
            Self::Range(ends) => *ends,
            Self::Each(values) => [values[0], values[values.len() - 1]],
        }
    }

    /// Each, or so many (two at least) at even steps over a range: exact at its ends, and in the
    /// middle of one that is symmetric about zero.
    pub fn evenly(&self, count: usize) -> Vec<f64> {
        match self {
            Self::Range([start, end]) => {
                let last = count.max(2) - 1;
                let share = |k: usize| k as f64 / last as f64;
                (0..=last).map(|k| start * (1.0 - share(k)) + end * share(k)).collect()
            }
            Self::Each(values) => values.clone(),
        }
    }
}

/// Points of a field: a range `START..END`, or each of them, `V1,V2,…`. What has no unit has that
/// of the last.
pub fn points(option: &str, path: FieldPath, text: &str) -> Result<Points, CaseError> {
    points_of(option, &path.field().allowed(), text)
}

/// Lengths (in m) that increase from zero or above: a range, or each of them.
pub fn depths(option: &str, text: &str) -> Result<Points, CaseError> {
    let field = length_field(Requirement::Between(0.0, LONGEST));
    let points = points_of(option, &field, text)?;
    let [start, end] = points.ends();
    if start < end {
        return Ok(points);
    }
    let place = Place::Override { option: option.into(), text: text.to_owned() };
    let after = |before: f64, value: f64| {
        format!("but is {} m after {} m", fields::readable(value), fields::readable(before))
    };
    let message = match points {
        Points::Range(_) => {
            format!("the end of the range must be larger than its start, {}", after(start, end))
        }
        Points::Each(values) => {
            format!(
                "each value of {option} must be larger than the one before, {}",
                after(values[0], values[1])
            )
        }
    };
    Err(CaseError::new("", message, place))
}

/// A length (in m) of any sign that an option gives.
pub fn position(option: &str, text: &str) -> Result<f64, CaseError> {
    single(option, option, text, &length_field(Requirement::Magnitude(LONGEST)))
}

/// A length (in m) that is not negative, which an option gives.
pub fn length(option: &str, text: &str) -> Result<f64, CaseError> {
    single(option, option, text, &length_field(Requirement::Between(0.0, LONGEST)))
}

/// Pressures (in Pa): a range START..END, of which six even steps are taken, or a list `P1,P2,…`.
/// One without unit has that of the last.
pub fn pressures(option: &str, text: &str) -> Result<Vec<f64>, CaseError> {
    const STEPS: u32 = 5;
    let field = alone("pressure", &Measure::PRESSURE, Requirement::Between(1.0, 1e14));
    let field = Allowed { usual: Some(Requirement::Between(1e5, 1e11)), ..field };
    if text.contains("..") {
        let [start, end] = range_of(option, &field, text)?;
        let step = (end - start) / f64::from(STEPS);
        return Ok((0..=STEPS).map(|k| start + f64::from(k) * step).collect());
    }
    each(option, &field, text)
}

/// Values of a list `V1,V2,…`. One without unit has that of the last.
fn each(option: &str, field: &Allowed, text: &str) -> Result<Vec<f64>, CaseError> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let unit = parts.last().map_or("", |last| unit_of(last));
    let what = format!("each value of {option}");
    let read = |part: &&str| {
        let with_unit = format!("{part} {unit}");
        let text = if part.parse::<f64>().is_ok() { with_unit.trim_end() } else { part };
        single(option, &what, text, field)
    };
    parts.iter().map(read).collect()
}

/// The largest length that an option may give, in m.
const LONGEST: f64 = 1e3;

/// What is no field of a case file but is read as one.
const fn alone(name: &'static str, measure: &'static Measure, requirement: Requirement) -> Allowed {
    Allowed { name, kind: Kind::Quantity(measure), requirement, usual: None }
}

/// Lengths in a contact and around it.
const fn length_field(requirement: Requirement) -> Allowed {
    let field = alone("length", &Measure::LENGTH, requirement);
    Allowed { usual: Some(Requirement::Magnitude(0.1)), ..field }
}

fn single(option: &str, what: &str, text: &str, field: &Allowed) -> Result<f64, CaseError> {
    number(field, text).map_err(|refusal| {
        let place = Place::Override { option: option.into(), text: text.to_owned() };
        CaseError::new("", refusal.message(what), place).help(refusal.help)
    })
}

/// A range or a list.
fn points_of(option: &str, field: &Allowed, text: &str) -> Result<Points, CaseError> {
    if text.contains("..") || !text.contains(',') {
        return range_of(option, field, text).map(Points::Range);
    }
    let place = || Place::Override { option: option.into(), text: text.to_owned() };
    let count = text.split(',').count();
    if count > MAX_POINTS {
        let message = format!("{option} must have at most {MAX_POINTS} values, but has {count}");
        return Err(CaseError::new(field.name, message, place()));
    }
    let values = each(option, field, text)?;
    let is_up = values[0] < values[1];
    let turn = values.windows(2).find(|two| (two[0] < two[1]) != is_up || two[0] == two[1]);
    let Some(turn) = turn else { return Ok(Points::Each(values)) };
    let [before, after] = [turn[0], turn[1]].map(fields::readable);
    let message = format!(
        "the values of {option} must increase or decrease from each to the next, but {after} \
         follows {before}"
    );
    Err(CaseError::new(field.name, message, place()))
}

fn range_of(option: &str, field: &Allowed, text: &str) -> Result<[f64; 2], CaseError> {
    let path = field.name;
    let place = Place::Override { option: option.into(), text: text.to_owned() };
    let unit = field.kind.unit();
    let example = format!("\"0..2 {}\"", field.units_of(2.0).first().unwrap_or(&unit));
    let example = if unit.is_empty() { "0..0.05".to_owned() } else { example };
    let form = || {
        format!(
            "{option} must be a range, such as {example}, or several values, but is {}",
            quoted(text)
        )
    };
    let ends = text.split_once("..").map(|(start, end)| (start.trim(), end.trim()));
    let Some((start, end)) = ends.filter(|(start, end)| !start.is_empty() && !end.is_empty())
    else {
        return Err(CaseError::new(path, form(), place));
    };
    let start_with_unit = format!("{start} {}", unit_of(end)).trim_end().to_owned();
    let is_bare = start.parse::<f64>().is_ok() && !unit.is_empty();
    let read = |what: &str, text: &str| {
        number(field, text).map_err(|refusal| {
            CaseError::new(path, refusal.message(what), place.clone()).help(refusal.help)
        })
    };
    // A start without unit has that of the end, which is looked at first.
    let end = read("the end of the range", end).map_err(|error| match end.parse() {
        Ok(number) if !unit.is_empty() => {
            let units = field.units_of(number).into_iter();
            let ranges: Vec<_> = units.map(|unit| format!("\"{text} {unit}\"")).collect();
            error.help(Some(format!("such as {}", ranges.join(" or "))))
        }
        _ => error,
    })?;
    let start = read("the start of the range", if is_bare { &start_with_unit } else { start })?;
    if start == end {
        let value = format!("{} {unit}", fields::readable(start));
        let message = format!(
            "the end of the range must differ from its start, but both are {}",
            value.trim_end()
        );
        return Err(CaseError::new(path, message, place));
    }
    Ok([start, end])
}

/// Values of a field at even steps over a range, `START..END` or `START..END:COUNT`, as text: with
/// the unit of the range, if both ends have the same, else in SI units.
pub(crate) fn even_values(
    option: &str,
    field: &Field,
    text: &str,
) -> Result<Vec<String>, CaseError> {
    const COUNT: usize = 11;
    const MOST: usize = 1000;
    let (ends, count) = match text.rsplit_once(':') {
        None => (text, COUNT),
        Some((ends, count)) => {
            let number = count.trim().parse().ok().filter(|count| (2..=MOST).contains(count));
            let refused = || {
                let message = format!(
                    "the number of values after `:` must be a whole number between 2 and {MOST}, \
                     but is {}",
                    quoted(count.trim())
                );
                let place = Place::Override { option: option.into(), text: text.to_owned() };
                CaseError::new(field.path, message, place)
            };
            (ends, number.ok_or_else(refused)?)
        }
    };
    let range = range_of(option, &field.allowed(), ends.trim())?;
    let (range, unit) = as_given(ends).unwrap_or((range, field.kind.unit()));
    let step = (range[1] - range[0]) / (count - 1) as f64;
    let value = |k: usize| {
        let value = if k + 1 == count { range[1] } else { range[0] + k as f64 * step };
        // What rounding leaves in the last digits would only be hard to read.
        let rounded = format!("{value:.8e}").parse().unwrap_or(value);
        format!("{rounded} {unit}").trim_end().to_owned()
    };
    Ok((0..count).map(value).collect())
}

/// The numbers of a range in its own unit, if there is only one.
fn as_given(range: &str) -> Option<([f64; 2], &str)> {
    let (start, end) = range.split_once("..")?;
    let [start, end] = [start.trim(), end.trim()];
    let [of_start, unit] = [unit_of(start), unit_of(end)];
    let number = |text: &str, unit: &str| text.strip_suffix(unit)?.trim_end().parse().ok();
    let ends = [number(start, of_start)?, number(end, unit)?];
    (of_start.is_empty() || of_start == unit).then_some((ends, unit))
}

/// The angle (in rad) that an option gives for a direction.
pub fn direction(option: &str, text: &str) -> Result<f64, CaseError> {
    let field = alone("direction", &Measure::ANGLE, Requirement::Magnitude(TAU));
    single(
        option,
        option,
        text,
        &Allowed { usual: Some(Requirement::Magnitude(FRAC_PI_2)), ..field },
    )
}

fn number(field: &Allowed, text: &str) -> Result<f64, Refusal> {
    let plain = matches!(field.kind, Kind::Number).then(|| text.parse().ok()).flatten();
    let content = plain.map_or_else(|| Content::Text(text.to_owned()), Content::Float);
    let value = Value { content, span: 0..0 };
    match field.read(&value)? {
        Setting::Number(number) => Ok(number),
        _ => Err(Refusal::new("a number".to_owned(), &value)),
    }
}

/// What follows the number that a text begins with.
fn unit_of(text: &str) -> &str {
    let is_number =
        |end: &usize| text.get(..*end).is_some_and(|start| start.trim_end().parse::<f64>().is_ok());
    let end = (0..=text.len()).rev().find(is_number).unwrap_or(0);
    text[end..].trim_start()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn creepage(text: &str) -> Result<[f64; 2], CaseError> {
        points("--creepage-x", field!("kinematics.creepage_x"), text).map(|points| points.ends())
    }

    fn spin(text: &str) -> Result<[f64; 2], CaseError> {
        points("--spin", field!("kinematics.spin"), text).map(|points| points.ends())
    }

    #[test]
    fn ranges_run_up_down_and_through_zero() {
        assert_eq!(creepage("0..0.05"), Ok([0.0, 0.05]));
        assert_eq!(creepage(" -1e-3 .. 5e-2 "), Ok([-1e-3, 5e-2]));
        assert_eq!(creepage("0.05..0."), Ok([0.05, 0.0]));
        assert_eq!(creepage("0...5"), Ok([0.0, 0.5]));
        assert_eq!(spin("0 1/m..2 1/m"), Ok([0.0, 2.0]));
        assert_eq!(spin("-1..2/m"), Ok([-1.0, 2.0]));
        assert_eq!(spin("0..2e-3 1/mm"), Ok([0.0, 2.0]));
    }

    #[test]
    fn what_is_no_range_is_refused_with_its_value() {
        let message = |text| creepage(text).unwrap_err().to_string();
        assert_eq!(
            message("0.05"),
            "--creepage-x 0.05: --creepage-x must be a range, such as 0..0.05, or several values, \
             but is \"0.05\""
        );
        assert!(message("0..").contains("must be a range"));
        assert!(message("0..fast").contains("the end of the range must be a number without unit"));
        assert!(message("nan..1").contains("the start of the range must be finite"));
        assert!(message("0..1e9").contains("at most ±1e6"));
        assert!(message("0.05..0.05").contains("must differ from its start, but both are 0.05"));
        assert!(message("0..2 1/m").contains("write the number alone"));
        let message = |text| spin(text).unwrap_err().to_string();
        assert!(message("0..2").contains("the unit is missing"), "{}", message("0..2"));
        let help = points("--force-x", field!("kinematics.force_x"), "0..-20").unwrap_err().help;
        assert_eq!(help.as_deref(), Some("such as \"0..-20 N\" or \"0..-20 kN\""));
        assert!(message("0 1/m..2 m").contains("`m` is the unit of a length"));
        assert!(message("1 m..2 1/m").contains("the start of the range must be an inverse length"));
    }

    #[test]
    fn points_are_each_given_in_order() {
        let read = |text| points("--spin", field!("kinematics.spin"), text);
        assert_eq!(read("0, 0.5, 2 1/m"), Ok(Points::Each(vec![0.0, 0.5, 2.0])));
        assert_eq!(read("2 1/m,-1 1/m"), Ok(Points::Each(vec![2.0, -1.0])));
        assert_eq!(read("-1..1 1/m").unwrap().evenly(3), [-1.0, 0.0, 1.0]);
        assert_eq!(read("0,0.5,2 1/m").unwrap().evenly(7), [0.0, 0.5, 2.0]);
        let message = |text| read(text).unwrap_err().to_string();
        for (text, told) in [
            ("0,1,0.5 1/m", "from each to the next, but 0.5 follows 1"),
            ("0,-1,-1 1/m", "from each to the next, but -1 follows -1"),
            ("0,1", "each value of --spin must be an inverse length"),
            ("0,nan 1/m", "must be finite"),
        ] {
            assert!(message(text).contains(told), "{}", message(text));
        }
        let deep = |text| depths("--depth", text);
        assert_eq!(deep("0,1,5 mm"), Ok(Points::Each(vec![0.0, 1e-3, 5e-3])));
        let told = deep("2,1 mm").unwrap_err().to_string();
        assert!(told.contains("must be larger than the one before, but is 1e-3 m after 2e-3 m"));
        let told = read(&format!("{}1 1/m", "0,".repeat(10_000))).unwrap_err().to_string();
        assert!(told.contains("--spin must have at most 10000 values, but has 10001"), "{told}");
    }

    #[test]
    fn lengths_and_depths_have_units_and_signs() {
        assert_relative_eq!(position("--x", "-3 mm").unwrap(), -3e-3);
        assert_relative_eq!(length("--wake", "5 cm").unwrap(), 0.05);
        assert_eq!(depths("--depth", "0..2mm"), Ok(Points::Range([0.0, 2e-3])));
        assert_eq!(depths("--depth", "0.25 mm..0.5 mm"), Ok(Points::Range([0.25e-3, 0.5e-3])));
        let message = |text| depths("--depth", text).unwrap_err().to_string();
        assert!(message("2mm..0mm").contains("larger than its start, but is 0 m after 2e-3 m"));
        assert!(message("-1mm..1mm").contains("between 0 and 1000 m"), "{}", message("-1mm..1mm"));
        assert!(message("0..2").contains("the unit is missing"));
        assert!(message("1mm..1mm").contains("must differ from its start"));
        assert!(message("2mm").contains("such as \"0..2 mm\""), "{}", message("2mm"));
        let message = length("--wake", "-1 mm").unwrap_err().to_string();
        assert!(message.contains("--wake must be between 0 and 1000 m, but is \"-1 mm\""));
        let error = position("--x", "3").unwrap_err();
        assert!(error.to_string().starts_with("--x 3: --x must be a length with its unit"));
        assert_eq!(error.help.as_deref(), Some("such as 3 mm or 3 µm"));
    }

    #[test]
    fn pressures_come_as_a_range_or_a_list() {
        let read = |text| pressures("--pressure", text).unwrap();
        let range = read("0.2..1.2 GPa");
        assert_eq!(range.len(), 6);
        for (k, pressure) in (1..).zip(range) {
            assert_relative_eq!(pressure, 0.2e9 * f64::from(k), max_relative = 1e-12);
        }
        assert_eq!(read("0.5 GPa"), [5e8]);
        assert_eq!(read("200 MPa, 500 MPa, 1 GPa"), [2e8, 5e8, 1e9]);
        assert_eq!(read("200,500 MPa"), [2e8, 5e8]);
        let message = |text| pressures("--pressure", text).unwrap_err().to_string();
        assert!(message("1").contains("--pressure 1: each value of --pressure must be a pressure"));
        assert!(message("1 mm").contains("`mm` is the unit of a length"));
        assert!(message("1 GPa,,2 GPa").contains("but is \"\""), "{}", message("1 GPa,,2 GPa"));
        assert!(message("0..1 GPa").contains("the start of the range must be between 1"));
    }

    #[test]
    fn directions_are_angles() {
        assert_relative_eq!(direction("--direction", "30deg").unwrap(), TAU / 12.0);
        assert_relative_eq!(direction("--direction", "-0.5 rad").unwrap(), -0.5);
        let message = |text| direction("--direction", text).unwrap_err().to_string();
        assert!(message("30").contains("--direction must be an angle with its unit"));
        let help = direction("--direction", "30").unwrap_err().help;
        assert_eq!(help.as_deref(), Some("such as 30 deg or 30 mrad"));
        assert!(message("400 deg").contains("at most ±6.28319 rad"));
    }
}
