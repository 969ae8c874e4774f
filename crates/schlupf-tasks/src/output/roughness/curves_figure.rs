//! Tangential curves of a rough contact, Figure 3 of Neuhaus and Sextro (2014), with the fit of Eq.
//! (8).

use super::RoughnessReport;
use crate::output::figures::color::{self, INK};
use crate::output::figures::marks::{Entry, Heading, short};
use crate::output::figures::panels::{self, Curve, Panel, Stack};
use crate::output::report::Report;

/// Height of each of the two panels.
const HEIGHT: f64 = 290.0;
/// Maximum number of named curves.
const MOST_NAMES: usize = 6;

/// The figure; `None` where there is no curve.
pub(super) fn draw(report: &RoughnessReport) -> Option<String> {
    let statistics = &report.result.statistics;
    let conditions = format!(
        "$h$_{{rms}} = {} µm, $h'$_{{rms}} = {}, $E$* = {} GPa, $ν$ = {}, $μ$_0 = {}",
        short(statistics.root_mean_square_height / 1e-6),
        short(statistics.spectral_gradient),
        short(report.contact_modulus / 1e9),
        short(report.bodies.poisson_ratio),
        short(report.bodies.friction_coefficient)
    );
    let title = "Tangential force of the rough contact and Eq. (8)";
    let heading = Heading::new(title, &report.title, conditions, report.status());
    Some(panels::page(&heading, &[normalised(report)?, over_displacement(report)?]))
}

/// Q/(μP) against u/u_s, with a separate fit for each pressure.
fn normalised(report: &RoughnessReport) -> Option<Stack> {
    let result = &report.result;
    let mut curves = Vec::new();
    let fits = result.stiffness.fits.iter();
    let colors = color::series(result.tangential.len());
    for (k, ((curve, fit), color)) in result.tangential.iter().zip(fits).zip(&colors).enumerate() {
        let points = curve.points.iter();
        let points = points.map(|point| [point.normalised_displacement, point.normalised_traction]);
        curves.push(Curve::solid(points.collect(), color, &pressure(report, k)));
        let sliding = curve.full_sliding_displacement;
        curves.push(Curve::dashed(exponential(fit.stiffness * sliding), color, ""));
    }
    let label = "displacement over that of full sliding, $u$/$u$_s";
    let end = curves.first()?.points.last()?[0];
    let law = Curve::dashed(Vec::new(), INK, "").stroke;
    let mut stack = stack([0.0, end], label, curves);
    for panel in &mut stack.panels {
        panel.entries.push(Entry::line(&law, "Eq. (8), fitted to each"));
    }
    Some(stack)
}

/// The name of a curve: its mean pressure, for as many curves as have a name.
fn pressure(report: &RoughnessReport, k: usize) -> String {
    let curves = &report.result.tangential;
    if k.is_multiple_of(curves.len().div_ceil(MOST_NAMES)) {
        format!("{} MPa", short((curves[k].mean_pressure / 1e6).round()))
    } else {
        String::new()
    }
}

/// 1 − exp(−k x) up to x = 1.25.
fn exponential(stiffness: f64) -> Vec<[f64; 2]> {
    let at = |k: u32| f64::from(k) / 160.0;
    (0..=200).map(at).map(|x| [x, -(-stiffness * x).exp_m1()]).collect()
}

/// Q/(μP) against u in µm, with one fit for all pressures.
fn over_displacement(report: &RoughnessReport) -> Option<Stack> {
    let result = &report.result;
    let colors = color::series(result.tangential.len());
    let mut curves: Vec<Curve> = result
        .tangential
        .iter()
        .zip(&colors)
        .enumerate()
        .map(|(k, (curve, color))| {
            let point = curve.points.iter();
            let point = point.map(|point| [point.displacement / 1e-6, point.normalised_traction]);
            Curve::solid(point.collect(), color, &pressure(report, k))
        })
        .collect();
    let ends = curves.iter().filter_map(|curve| curve.points.last()).map(|point| point[0]);
    let end = ends.fold(0.0, f64::max);
    let stiffness = result.stiffness.common.stiffness;
    let points = exponential(stiffness * end * 1e-6);
    let points = points.into_iter().map(|[x, y]| [x * end, y]).filter(|[x, _]| *x <= end);
    let text = format!("Eq. (8) with $k$_c = {} 1/m", short(stiffness));
    curves.push(Curve::dashed(points.collect(), "#000000", &text));
    (end > 0.0 && end.is_finite()).then(|| stack([0.0, end], "displacement $u$ (µm)", curves))
}

fn stack(x: [f64; 2], label: &str, curves: Vec<Curve>) -> Stack {
    Stack::over(x, label, vec![Panel::new("force over that of full sliding", HEIGHT, curves)])
}
