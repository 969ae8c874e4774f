//! Creep curves as text: a table with some of the points, slope and maximum of every curve.

use std::fmt::Write;

use schlupf::analysis::creep_curve::{
    Abscissa, CreepCurve, InitialSlope, Maximum, PLATEAU, Point, VariedForce,
};
use schlupf::bodies::ReferencePoint;
use schlupf::solution::Resultant;
use schlupf::{Method, Status};

use super::{CurveFamily, Member};
use crate::output::number::significant as number;
use crate::output::summary::{self, Summary, line, without_noise};

/// Remark on the reference point of creepages and moments if it is not the centre of the patch.
const FROM_THE_FILE: &str = "creepages and moment at the origin of the file";

/// Maximum number of points of a curve in the table, apart from those that did not converge.
const MOST_ROWS: usize = 21;

/// The curves as text: forces on the wheel, temperatures, slope and maximum.
pub(super) fn text(family: &CurveFamily) -> Summary {
    let mut text = Summary::titled(&family.title);
    for member in &family.members {
        text.blank();
        if let Some(name) = family.name(member) {
            line(&mut text, &name);
        }
        curve(&mut text, member);
    }
    text
}

fn curve(text: &mut Summary, member: &Member) {
    let curve = &member.curve;
    conditions(text, curve);
    table(text, curve);
    // Along a force there is neither.
    let Some(abscissa) = curve.path.abscissa() else { return };
    match &curve.initial_slope {
        Some(slope) => self::slope(text, slope, abscissa),
        None if curve.holds_forces => {
            line(text, "initial slope     none: forces are prescribed");
        }
        None if curve.path.has_origin() => line(text, "initial slope     not found"),
        None => line(text, "initial slope     none: the curve does not reach zero creepage"),
    }
    for maximum in &curve.maxima {
        top(text, maximum, abscissa);
    }
    if curve.maximum().is_none() {
        largest(text, curve, abscissa);
    }
}

fn conditions(text: &mut Summary, curve: &CreepCurve) {
    let [start, end] = [curve.path.start(), curve.path.end()];
    let speed = curve.points.first().map_or(f64::NAN, |point| point.kinematics.speed);
    let mut parts = vec![
        format!("load {} kN", number(curve.normal.load / 1e3)),
        format!("speed {} m/s", number(speed)),
    ];
    let constant = [
        ("creepage_x", start.x, end.x, ""),
        ("creepage_y", start.y, end.y, ""),
        ("spin", start.spin, end.spin, " 1/m"),
    ];
    for (name, start, end, unit) in constant {
        if start == end && start != 0.0 {
            parts.push(format!("{name} {}{unit}", number(start)));
        }
    }
    if let Some(Abscissa::Total { direction }) = curve.path.abscissa() {
        parts.push(format!("direction {}°", number(direction.to_degrees())));
    }
    if curve.reference == ReferencePoint::File {
        parts.push(FROM_THE_FILE.to_owned());
    }
    if curve.method != Method::Full {
        parts.push(format!("by the fast method {:?}", curve.method.name()));
    }
    line(text, &parts.join(", "));
}

/// A column of the table: its heading, and the getter of its number.
type Column = (String, fn(&Point) -> Option<f64>);

fn table(text: &mut Summary, curve: &CreepCurve) {
    let points = &curve.points;
    let creepages: [Column; 3] = [
        ("creepage_x".to_owned(), |point| Some(point.kinematics.creepage_x)),
        ("creepage_y".to_owned(), |point| Some(point.kinematics.creepage_y)),
        ("spin (1/m)".to_owned(), |point| Some(point.kinematics.spin)),
    ];
    let is_given = |column: &Column| points.iter().all(|point| (column.1)(point) == Some(0.0));
    let name = curve.path.quantity().name();
    let first: Column = match curve.path.abscissa() {
        Some(Abscissa::Spin) => ("spin (1/m)".to_owned(), |point| Some(point.abscissa)),
        _ => (name.to_owned(), |point| Some(point.abscissa)),
    };
    let forces: [Column; 3] = [
        ("Fx (kN)".to_owned(), |point| {
            Some(without_noise(point.force.x, point.normalised.x) / 1e3)
        }),
        ("Fy (kN)".to_owned(), |point| {
            Some(without_noise(point.force.y, point.normalised.y) / 1e3)
        }),
        ("|F|/N".to_owned(), |point| {
            Some(without_noise(point.traction_coefficient, point.traction_coefficient))
        }),
    ];
    let mut columns: Vec<Column> = match curve.path.force() {
        None => [first].into_iter().chain(forces).collect(),
        // What causes the forces; those that are prescribed are among the others.
        Some(force) => {
            let found = creepages.into_iter().filter(|column| !is_given(column));
            let over_load = (force == VariedForce::OverLoad).then_some(first);
            over_load.into_iter().chain(forces).chain(found).collect()
        }
    };
    let moment: Column =
        ("Mz (N m)".to_owned(), |point| summary::moment(&point.force, &point.normalised));
    let rise: Column = ("rise (K)".to_owned(), |point| point.max_rise);
    for column in [moment, rise] {
        if points.iter().any(|point| (column.1)(point).is_some_and(|value| value != 0.0)) {
            columns.push(column);
        }
    }
    row(text, columns.iter().map(|(name, _)| name.clone()), "");
    let stride = (points.len() - 1).div_ceil(MOST_ROWS - 1).max(1);
    let last = points.len() - 1;
    let mut rows = 0;
    for (k, point) in points.iter().enumerate() {
        let is_marked = point.status == Status::NotConverged;
        if k % stride != 0 && k != last && !is_marked {
            continue;
        }
        rows += 1;
        let remark = if is_marked { "  NOT CONVERGED" } else { "" };
        row(text, columns.iter().map(|(_, value)| number(value(point))), remark);
    }
    if rows < points.len() {
        line(text, &format!("  ({rows} of {} points; CSV and JSON have all)", points.len()));
    }
}

fn row(text: &mut Summary, entries: impl Iterator<Item = String>, remark: &str) {
    let entries = entries.map(|entry| format!("{entry:>12}")).collect::<Vec<_>>().concat();
    line(text, &format!("{entries}{remark}"));
}

fn slope(text: &mut Summary, slope: &InitialSlope, abscissa: Abscissa) {
    let (symbol, coefficients, force_unit, moment_unit, bound) = match abscissa {
        Abscissa::CreepageX => ("ξ", ["C11", "", ""], "kN", "N m", "μ0 N"),
        Abscissa::CreepageY => ("η", ["", "C22", "-C23"], "kN", "N m", "μ0 N"),
        Abscissa::Spin => ("φ", ["", "C23", "C33"], "kN m", "N m²", "m μ0 N"),
        Abscissa::Total { .. } => ("ν", ["", "", ""], "kN", "N m", "μ0 N"),
    };
    let kalker = |component: fn(&Resultant) -> Option<f64>| component(slope.kalker.as_ref()?);
    let components = [
        ("dFx", slope.force.x / 1e3, force_unit, slope.normalised.x, kalker(|k| Some(k.x))),
        ("dFy", slope.force.y / 1e3, force_unit, slope.normalised.y, kalker(|k| Some(k.y))),
        (
            "dMz",
            slope.force.moment_z.unwrap_or(0.0),
            moment_unit,
            slope.normalised.moment_z.unwrap_or(0.0),
            kalker(|k| k.moment_z),
        ),
    ];
    let largest = components.iter().map(|component| component.3.abs()).fold(0.0, f64::max);
    let mut name = "initial slope";
    for ((what, value, unit, normalised, kalker), coefficient) in
        components.into_iter().zip(coefficients)
    {
        // Within the tolerance of the solutions, or unknown.
        if normalised.abs() <= 1e-5 * largest {
            continue;
        }
        let bound = if what == "dMz" { format!("{bound} √(ab)") } else { bound.to_owned() };
        let mut entry = format!(
            "{name:<18}{what}/d{symbol} = {} {unit} = {} {bound}",
            number(value),
            number(normalised)
        );
        if let Some(kalker) = kalker.filter(|_| !coefficient.is_empty()) {
            // Writing to a String cannot fail.
            let _ = write!(entry, ", as with Kalker's {coefficient} = {}", number(kalker));
        }
        line(text, &entry);
        name = "";
    }
}

fn top(text: &mut Summary, maximum: &Maximum, abscissa: Abscissa) {
    let value = number(maximum.traction_coefficient);
    let place = abscissa.quantity().equation(significant(maximum.abscissa));
    let entry = if maximum.is_saturated {
        let level = number(100.0 * PLATEAU);
        format!("|F|/N = {value}, saturated: within {level} % from {place} on")
    } else {
        format!("|F|/N = {value} at {place}")
    };
    line(text, &format!("{:<18}{entry}", "maximum"));
}

/// The position of the largest force, if that is not a maximum.
fn largest(text: &mut Summary, curve: &CreepCurve, abscissa: Abscissa) {
    let converged = curve.points.iter().filter(|point| point.status == Status::Converged);
    let largest = converged
        .max_by(|one, other| one.traction_coefficient.total_cmp(&other.traction_coefficient));
    let entry = match largest {
        Some(point) if curve.is_converged() => format!(
            "none within the range: |F|/N is largest at an end of it, {} at {}",
            number(point.traction_coefficient),
            abscissa.quantity().equation(point.abscissa)
        ),
        _ => "none found between the points that converged".to_owned(),
    };
    line(text, &format!("{:<18}{entry}", "maximum"));
}

/// Four significant digits: positions are not known more accurately.
fn significant(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
