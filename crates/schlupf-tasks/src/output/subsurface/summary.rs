//! Stresses below the surface as text.

use schlupf::analysis::subsurface::{Measure, PointStress};

use super::StressReport;
use crate::output::number::significant as number;
use crate::output::report::{reasons, verdict};
use crate::output::summary::{Summary, entry, line};

/// Rows of the table of the profile.
const ROWS: usize = 11;

/// The largest stresses with their places, and the profile.
pub(super) fn text(report: &StressReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    line(
        &mut text,
        &format!("stresses in the {}, in its half-space below the contact", report.body()),
    );
    let peak = report.normal.peak_pressure;
    entry(&mut text, "largest pressure", peak / 1e6, "MPa", "p0");
    let measures = ["von Mises stress", "shear stress", "principal stress"];
    for ((name, measure), largest) in measures.into_iter().zip(Measure::ALL).zip(&report.largest) {
        let described = |point: &PointStress| {
            let value = measure.of(&point.stress);
            (value, format!("{} p0, {}", number(value / peak), place(point)))
        };
        let (value, remark) = described(&largest.anywhere);
        entry(&mut text, &format!("largest {name}"), value / 1e6, "MPa", &remark);
        let other = match &largest.below {
            Some(below) if *below == largest.anywhere => Some(("on the surface", &largest.surface)),
            Some(below) => Some(("maximum below", below)),
            None => None,
        };
        if let Some((name, point)) = other {
            let (value, remark) = described(point);
            entry(&mut text, &format!("  {name}"), value / 1e6, "MPa", &remark);
        }
    }
    text.blank();
    let [x, y] = report.place().map(|place| number(place / 1e-3));
    line(&mut text, &format!("below x = {x} mm, y = {y} mm"));
    let files = if report.points.is_some() { "JSON has" } else { "CSV and JSON have" };
    profile(&mut text, &report.profile, files);
    if let Some(points) = &report.points {
        text.blank();
        asked_for(&mut text, points);
    }
    text.blank();
    line(&mut text, verdict(report.status));
    for reason in reasons(&report.warnings) {
        line(&mut text, &format!("  {reason}"));
    }
    text
}

fn place(point: &PointStress) -> String {
    let [x, y, depth] = [point.x, point.y, point.depth].map(|place| number(place / 1e-3));
    format!("at x = {x} mm, y = {y} mm, {depth} mm deep")
}

/// How many points were asked for, and the largest stress of von Mises among them.
fn asked_for(text: &mut Summary, points: &[PointStress]) {
    let von_mises = |point: &&PointStress| point.stress.von_mises();
    let largest = points.iter().max_by(|one, other| von_mises(one).total_cmp(&von_mises(other)));
    let Some(largest) = largest else { return };
    let count = format!("points asked for: {}; CSV and JSON have them all", points.len());
    line(text, &count);
    let value = largest.stress.von_mises() / 1e6;
    entry(text, "  largest von Mises", value, "MPa", &place(largest));
}

/// The profile; `files` have all of it.
fn profile(text: &mut Summary, points: &[PointStress], files: &str) {
    let heads = ["depth (mm)", "σxx (MPa)", "σyy (MPa)", "σzz (MPa)", "σxz (MPa)", "von Mises"];
    line(text, &heads.map(|head| format!("{head:>12}")).concat());
    let last = points.len().saturating_sub(1);
    let rows = last.clamp(1, ROWS - 1);
    for point in (0..=rows.min(last)).filter_map(|row| points.get(row * last / rows)) {
        let stress = &point.stress;
        let values = [stress.xx, stress.yy, stress.zz, stress.xz, stress.von_mises()];
        let values = values.map(|value| format!("{:>12}", number(value / 1e6))).concat();
        line(text, &format!("{:>12}{values}", number(point.depth / 1e-3)));
    }
    if rows < last {
        line(text, &format!("  ({} of {} points; {files} all)", rows + 1, last + 1));
    }
}
