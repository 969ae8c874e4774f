//! Calibrated stiffnesses as text.

use schlupf::analysis::calibration::Deviation;
use schlupf::elasticity::elastic_layer::LayerStiffness;

use super::snippet::snippet;
use super::{CalibrationReport, Fitted, Origin};
use crate::output::number::significant as number;
use crate::output::report::verdict;
use crate::output::summary::{Summary, entry, line};

/// The patch, the stiffnesses side by side, their deviations from the data they were fitted to, and
/// a section for a case file.
pub(super) fn text(report: &CalibrationReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    patch(&mut text, report);
    let origins = report.origins();
    stiffnesses(&mut text, &origins);
    deviations(&mut text, &origins);
    if let Some(fitted) = &report.fitted {
        displacements(&mut text, fitted);
    }
    snippet(report).lines().for_each(|each| line(&mut text, each));
    text.blank();
    line(&mut text, verdict(report.status));
    text
}

fn patch(text: &mut Summary, report: &CalibrationReport) {
    let [a, b] = report.normal.semi_axes();
    let across = format!("along rolling, {} mm across, a/b = {}", number(b / 1e-3), number(a / b));
    entry(text, "semi-axes", a / 1e-3, "mm", &across);
    entry(text, "load", report.normal.load / 1e3, "kN", "");
    let poisson = format!("of both bodies, ν = {}", number(report.poisson_ratio));
    entry(text, "shear modulus", report.shear_modulus / 1e9, "GPa", &poisson);
    text.blank();
}

/// Width of the names of quantities, and of a column.
const NAME: usize = 27;
const COLUMN: usize = 12;

fn stiffnesses(text: &mut Summary, origins: &[Origin]) {
    let names = origins.iter().map(|origin| format!("  {:>1$}", origin.name, 2 * COLUMN));
    line(text, &format!("{:NAME$}{}", "", names.collect::<String>()));
    let pair = format!("  {:>COLUMN$}{:>COLUMN$}", "along x", "along y");
    line(text, &format!("{:NAME$}{}", "displacements", pair.repeat(origins.len())));
    let mut row = |name: &str, value: &dyn Fn(&LayerStiffness) -> f64, unit: &str| {
        let cell = |stiffness: &Option<LayerStiffness>| match stiffness {
            Some(stiffness) => format!("{:>COLUMN$}", number(value(stiffness))),
            None => format!("{:>COLUMN$}", "–"),
        };
        let columns = origins.iter().map(|origin| {
            let [x, y] = origin.stiffness.each_ref().map(cell);
            format!("  {x}{y}")
        });
        line(text, &format!("{name:NAME$}{}  {unit}", columns.collect::<String>()));
    };
    row("bedding c", &|s| s.bedding, "N/m³");
    row("coupling g along rolling", &|s| s.coupling_along_x, "N/m");
    row("              across", &|s| s.coupling_along_y, "N/m");
    row("decay length along rolling", &|s| s.decay_lengths()[0] / 1e-3, "mm");
    row("              across", &|s| s.decay_lengths()[1] / 1e-3, "mm");
    text.blank();
}

fn deviations(text: &mut Summary, origins: &[Origin]) {
    if origins.iter().all(|origin| origin.deviation.is_none()) {
        return;
    }
    line(text, "away from the half-space");
    let mut row = |name: &str, value: fn(&Deviation) -> f64, unit: &str| {
        let columns = origins.iter().map(|origin| match &origin.deviation {
            Some(deviation) => format!("  {:>1$}", percent(value(deviation)), 2 * COLUMN),
            None => format!("  {:>1$}", "", 2 * COLUMN),
        });
        line(text, &format!("{name:NAME$}{}  {unit}", columns.collect::<String>()));
    };
    row("forces, largest", |deviation| deviation.force, "% of μN");
    row("  with spin", |deviation| deviation.force_with_spin, "% of μN");
    row("tractions, mean", |deviation| deviation.field, "%");
    row("  with spin", |deviation| deviation.field_with_spin, "%");
    text.blank();
}

fn displacements(text: &mut Summary, fitted: &Fitted) {
    line(text, "away from the displacements");
    for (direction, component) in ["x", "y"].into_iter().zip(&fitted.components) {
        let Some(component) = component else { continue };
        for (file, deviation) in component.files.iter().zip(&component.fit.deviation) {
            let name = format!("displacement_{direction}");
            line(
                text,
                &format!("{name:NAME$}  {:>1$}  %  {file}", percent(*deviation), 2 * COLUMN),
            );
        }
    }
    text.blank();
}

/// A fraction in %, with two decimals.
fn percent(part: f64) -> String {
    format!("{:.2}", 100.0 * part)
}
