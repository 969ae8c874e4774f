//! Lines of a text summary, in engineering units.

use std::fmt::Write;

use schlupf::Solution;
use schlupf::solution::Resultant;

use crate::number::significant as number;

/// A force or moment, 0 if it is rounding noise: negligible relative to μ0 N or μ0 N √(ab).
pub(crate) fn without_noise(value: f64, normalised: f64) -> f64 {
    const NOISE: f64 = 1e-9;
    if normalised.abs() < NOISE { 0.0 } else { value }
}

/// The moment (in N m), 0 if it is rounding noise, if it is known.
pub(crate) fn moment(force: &Resultant, normalised: &Resultant) -> Option<f64> {
    Some(without_noise(force.moment_z?, normalised.moment_z?))
}

/// Friction power with the power of the creep forces.
pub(crate) fn friction_power(text: &mut String, solution: &Solution) {
    let (watts, unit) = unit_of_power(solution);
    let power = solution.power;
    let creep = format!("creep power {} {unit}", number(power.map(|power| power.creep / watts)));
    entry(text, "friction power", power.map(|power| power.friction / watts), unit, &creep);
}

/// The unit in which the powers of a solution have few digits before the point: its watts, and its
/// symbol.
pub(crate) fn unit_of_power(solution: &Solution) -> (f64, &'static str) {
    const UNITS: [(f64, &str); 4] = [(1e3, "kW"), (1.0, "W"), (1e-3, "mW"), (1e-6, "µW")];
    let power = solution.power.map_or(0.0, |power| power.friction.abs());
    match UNITS.into_iter().find(|(watts, _)| power >= *watts) {
        Some(unit) => unit,
        None if power == 0.0 => UNITS[0],
        None => UNITS[3],
    }
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
