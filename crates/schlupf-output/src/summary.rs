//! Lines of a summary for people, in engineering units.

use std::fmt::Write;

use crate::number::significant as number;

/// A force or moment, 0 where it is rounding noise: where it is next to nothing over μ0 N or μ0 N √(ab).
pub(crate) fn without_noise(value: f64, normalised: f64) -> f64 {
    const NOISE: f64 = 1e-9;
    if normalised.abs() < NOISE { 0.0 } else { value }
}

/// One quantity: its name, value and unit in columns, and a remark.
pub(crate) fn entry(text: &mut String, name: &str, value: f64, unit: &str, remark: &str) {
    line(text, &format!("{name:<22}{:>11} {unit:<4} {remark}", number(value)));
}

pub(crate) fn line(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", line.trim_end());
}
