//! A fit as text.

use schlupf::analysis::identification::Estimate;

use super::{FitReport, in_usual_unit, with_uncertainty};
use crate::output::number::significant as number;
use crate::output::report::{reasons, verdict};
use crate::output::summary::{Summary, line};

/// The parameters with their intervals and correlations, the quality of the fit, status and
/// warnings.
pub(super) fn text(report: &FitReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    let fit = &report.fit;
    line(&mut text, &format!("{} measured forces of {}", fit.points.len(), report.data));
    text.blank();
    line(
        &mut text,
        &format!(
            "{:<38}{:<6}{:>12}{:>12} {:<5}{:>10}",
            "parameter", "", "value", "± 95 %", "", "start"
        ),
    );
    for (estimate, name) in fit.estimates.iter().zip(&report.names) {
        parameter(&mut text, estimate, name);
    }
    if let Some(roughness) = report.roughness {
        let gamma = number(roughness.gamma);
        let stiffness = number(roughness.contact_stiffness);
        line(&mut text, &format!("  so contact_law.stiffness = {stiffness} 1/m, with γ = {gamma}"));
    }
    correlations(&mut text, report);
    quality(&mut text, report);
    status(&mut text, report);
    text
}

fn parameter(text: &mut Summary, estimate: &Estimate, name: &str) {
    let parameter = estimate.parameter;
    let usual = |value| in_usual_unit(parameter, value);
    let (value, unit) = usual(estimate.value);
    let half_width = estimate.half_width.map(|width| usual(width).0);
    let start = usual(estimate.start).0;
    let [value, half_width] = with_uncertainty(value, half_width);
    line(
        text,
        &format!(
            "{name:<38}{:<6}{value:>12}{half_width:>12} {unit:<5}{:>10}",
            parameter.quantity().symbol(),
            number(start)
        ),
    );
}

fn correlations(text: &mut Summary, report: &FitReport) {
    let estimates = &report.fit.estimates;
    if estimates.len() < 2 {
        text.blank();
        return;
    }
    let symbols = || estimates.iter().map(|estimate| estimate.parameter.quantity().symbol());
    let header: Vec<String> = symbols().map(|symbol| format!("{symbol:>9}")).collect();
    line(text, &format!("\n{:<16}{}", "correlation", header.concat()));
    for (symbol, row) in symbols().zip(&report.fit.correlation) {
        let entries: Vec<String> = row.iter().map(|entry| format!("{entry:>9.3}")).collect();
        line(text, &format!("  {symbol:<14}{}", entries.concat()));
    }
    text.blank();
}

fn quality(text: &mut Summary, report: &FitReport) {
    let fit = &report.fit;
    let largest = fit.points.iter().map(|point| point.residual().abs()).fold(0.0, f64::max);
    line(
        text,
        &format!(
            "r.m.s. residual of F/N  {}, largest {}",
            number(fit.rms_residual),
            number(largest)
        ),
    );
    let r_squared = fit.r_squared.map_or_else(|| "n/a".to_owned(), |value| format!("{value:.5}"));
    line(text, &format!("R²                      {r_squared}"));
    if let Some(reduced) = fit.reduced_chi_squared {
        let freedom = fit.degrees_of_freedom;
        line(text, &format!("χ² over {freedom} degrees of freedom  {}", number(reduced)));
    }
}

fn status(text: &mut Summary, report: &FitReport) {
    let fit = &report.fit;
    let work = match fit.work.newton_iterations {
        0 => String::new(),
        newton => {
            let products = fit.work.operator_products + fit.work.sensitivity_products as f64;
            format!(", {newton} Newton iterations, {} products", number(products))
        }
    };
    line(text, &format!("{}, {} steps{work}", verdict(fit.status), fit.iterations));
    for reason in reasons(&report.warnings) {
        line(text, &format!("  {reason}"));
    }
}
