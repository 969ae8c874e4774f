//! Lines of a summary for people, in engineering units.

use std::fmt::Write;

use schlupf::Solution;
use schlupf::solution::Resultant;

use crate::number::significant as number;

/// A force or moment, 0 where it is rounding noise: where it is next to nothing over μ0 N or μ0 N
/// √(ab).
pub(crate) fn without_noise(value: f64, normalised: f64) -> f64 {
    const NOISE: f64 = 1e-9;
    if normalised.abs() < NOISE { 0.0 } else { value }
}

/// The moment (in N m), 0 where it is rounding noise, if it is known.
pub(crate) fn moment(force: &Resultant, normalised: &Resultant) -> Option<f64> {
    Some(without_noise(force.moment_z?, normalised.moment_z?))
}

/// Friction power with the power of the creep forces.
pub(crate) fn friction_power(text: &mut String, solution: &Solution) {
    let power = solution.power;
    let creep = format!("creep power {} kW", number(power.map(|power| power.creep / 1e3)));
    entry(text, "friction power", power.map(|power| power.friction / 1e3), "kW", &creep);
}

/// One quantity: its name, value and unit in columns, and a remark.
pub(crate) fn entry(
    text: &mut String,
    name: &str,
    value: impl Into<Option<f64>>,
    unit: &str,
    remark: &str,
) {
    line(text, &format!("{name:<22}{:>11} {unit:<4} {remark}", number(value)));
}

pub(crate) fn line(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", line.trim_end());
}
