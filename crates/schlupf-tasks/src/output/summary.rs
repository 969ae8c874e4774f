//! Lines of a text summary, in engineering units.

use std::fmt::{self, Display, Formatter};

use schlupf::Solution;
use schlupf::solution::Resultant;

use crate::output::number::significant as number;

/// A text summary: its lines, in their order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Summary {
    /// The lines.
    pub lines: Vec<Line>,
}

/// A line of a summary.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Line {
    /// A quantity in an engineering unit.
    Entry {
        /// Its name; two spaces in front of it make it a part of the entry above.
        name: String,
        /// Its value as text.
        value: String,
        /// Its unit; may be empty.
        unit: String,
        /// A remark; may be empty.
        remark: String,
    },
    /// Anything else; may be empty.
    Text(String),
}

impl Display for Line {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::Entry { name, value, unit, remark } => {
                let line = format!("{name:<22}{value:>11} {unit:<4} {remark}");
                f.write_str(line.trim_end())
            }
            Self::Text(text) => f.write_str(text.trim_end()),
        }
    }
}

impl Display for Summary {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        self.lines.iter().try_for_each(|line| writeln!(f, "{line}"))
    }
}

impl Summary {
    /// Begins with a title.
    pub(crate) fn titled(title: &str) -> Self {
        Self { lines: vec![Line::Text(title.to_owned())] }
    }

    /// Adds an empty line.
    pub(crate) fn blank(&mut self) {
        self.lines.push(Line::Text(String::new()));
    }
}

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
pub(crate) fn friction_power(text: &mut Summary, solution: &Solution) {
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
    text: &mut Summary,
    name: &str,
    value: impl Into<Option<f64>>,
    unit: &str,
    remark: &str,
) {
    let [name, unit, remark] = [name, unit, remark].map(str::to_owned);
    text.lines.push(Line::Entry { name, value: number(value), unit, remark });
}

pub(crate) fn line(text: &mut Summary, line: &str) {
    text.lines.push(Line::Text(line.to_owned()));
}
