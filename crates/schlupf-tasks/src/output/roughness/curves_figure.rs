//! Tangential curves of a rough contact, Figure 3 of Neuhaus and Sextro (2014), with the fit of Eq.
//! (8).

use schlupf::Status;

use super::RoughnessReport;
use crate::output::figures::color::{self, INK};
use crate::output::figures::marks::{self, HEADING, short};
use crate::output::figures::panels::{Curve, GAP, Panel, Stack, WIDTH};
use crate::output::figures::svg::Drawing;
use crate::output::report::Report;

/// Height of each of the two panels.
const HEIGHT: f64 = 290.0;
/// Space below the first panel, for its axis.
const AXIS: f64 = 70.0;
/// Space above the first panel, for the legend.
const LEGEND: f64 = 40.0;
/// Maximum number of named curves.
const MOST_NAMES: usize = 6;

/// The figure; `None` where there is no curve.
pub(super) fn draw(report: &RoughnessReport) -> Option<String> {
    let stacks = [normalised(report)?, over_displacement(report)?];
    let heights = stacks.each_ref().map(Stack::plot_height);
    let top = HEADING + LEGEND;
    let below = top + heights[0] + GAP + AXIS;
    let mut drawing = Drawing::new(WIDTH, below + heights[1] + AXIS);
    heading(&mut drawing, report);
    let [first, second] = stacks;
    first.draw(&mut drawing, top);
    second.draw(&mut drawing, below);
    Some(drawing.finish())
}

fn heading(drawing: &mut Drawing, report: &RoughnessReport) {
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
    marks::title_block(drawing, title, [&report.title, &conditions], remark(report));
}

/// The remark in red above a figure.
pub(super) fn remark(report: &RoughnessReport) -> &'static str {
    if report.status() == Status::Converged { "" } else { "not converged" }
}

/// Q/(μP) against u/u_s, with a separate fit for each pressure.
fn normalised(report: &RoughnessReport) -> Option<Stack<'static>> {
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
    curves.push(Curve::dashed(Vec::new(), INK, "Eq. (8), fitted to each"));
    let label = "displacement over that of full sliding, $u$/$u$_s";
    let end = curves.first()?.points.last()?[0];
    Some(stack([0.0, end], label, curves))
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
fn over_displacement(report: &RoughnessReport) -> Option<Stack<'static>> {
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

fn stack(x: [f64; 2], label: &'static str, curves: Vec<Curve>) -> Stack<'static> {
    let panel =
        Panel { label: "force over that of full sliding".to_owned(), height: HEIGHT, curves };
    Stack { x, label, panels: vec![panel], shaded: Vec::new(), shading: "" }
}
