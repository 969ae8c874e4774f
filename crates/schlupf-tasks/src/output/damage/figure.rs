//! Damage over a run: wear across the profile, the run, and distributions.

use schlupf::analysis::damage::{Histogram, RunPoint};
use schlupf::{Quantity, Status};

use super::DamageReport;
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::marks::{Heading, short};
use crate::output::figures::panels::{self, Axis, Curve, Panel, Stack};

/// Names of all figures.
pub(super) const NAMES: [&str; 3] = ["damage_wear", "damage_run", "damage_histograms"];

/// All figures.
pub(super) fn draw(report: &DamageReport) -> Vec<Named> {
    let drawn = [wear(report), run(report), histograms(report)];
    let named = NAMES.iter().zip(drawn);
    named.filter_map(|(name, svg)| Some(((*name).to_owned(), svg?))).collect()
}

fn page(report: &DamageReport, title: &str, stacks: &[Stack]) -> String {
    let damage = &report.damage;
    let about = format!(
        "{} states over {} km, {} kJ of friction",
        damage.states,
        short(damage.distance / 1e3),
        short(damage.energy / 1e3)
    );
    let remark = if report.left_out.states == 0 { "" } else { "some states are left out" };
    let heading = Heading::new(title, &report.title, about, Status::Converged);
    panels::page(&Heading { remark, ..heading }, stacks)
}

/// Depth of wear of wheel and rail across the profile.
fn wear(report: &DamageReport) -> Option<String> {
    let profile = &report.damage.profile;
    let panel = |label: &str, unit: f64, depths: [&[f64]; 2]| {
        let curves = [(BLUE, "Archard"), (VERMILION, "energy")].into_iter().zip(depths);
        let curves = curves.map(|((color, text), depth)| {
            Curve::solid(panels::across(&profile.y, depth, unit), color, text)
        });
        Panel::new(label, 240.0, curves.collect())
    };
    let ends = panels::across(&profile.y, &profile.wheel_archard, 1.0);
    let panels = vec![
        panel("wheel, over the run (µm)", 1e-6, [&profile.wheel_archard, &profile.wheel_energy]),
        panel("rail, for each wheel (nm)", 1e-9, [&profile.rail_archard, &profile.rail_energy]),
    ];
    let x = [ends.first()?[0], ends.last()?[0]];
    let stack = Stack::over(x, "$y$ across the profile (mm)", panels);
    Some(page(report, "Depth of wear", &[stack]))
}

/// Most points of a curve over the run: of more, the largest and the smallest of each interval.
const MOST: usize = 1200;

/// Wear number, fatigue index and energy over the distance.
fn run(report: &DamageReport) -> Option<String> {
    let points = &report.damage.points;
    let distance = report.damage.distance;
    let (unit, label) =
        if distance >= 2e3 { (1e3, "distance (km)") } else { (1.0, "distance (m)") };
    let panel = |label: &str, color: &str, value: &dyn Fn(&RunPoint) -> f64| {
        let all: Vec<[f64; 2]> = points.iter().map(|p| [p.distance / unit, value(p)]).collect();
        let curve = Curve::new(thinned(&all), panels::stroke(color, 1.3, ""), "");
        Panel::new(label, 150.0, vec![curve])
    };
    let kilojoules = &|point: &RunPoint| point.energy / 1e3;
    let mut all = vec![
        panel("$Tγ$ (N)", BLUE, &|point| point.t_gamma),
        panel("fatigue index", VERMILION, &|point| point.fatigue_index),
        panel("energy (kJ)", BLUE, kilojoules),
    ];
    if points.iter().any(|point| point.position_y != points[0].position_y) {
        all.push(panel("$y$ of the patch (mm)", BLUE, &|point| point.position_y / 1e-3));
    }
    let end = points.last()?.distance.max(distance) / unit;
    let stack = Stack::over([0.0, end], label, all);
    Some(page(report, "Damage along the run", &[stack]))
}

fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= MOST {
        return points.to_vec();
    }
    let of_interval = |interval: &[[f64; 2]]| {
        let by_value = |one: &&[f64; 2], other: &&[f64; 2]| one[1].total_cmp(&other[1]);
        let [low, high] = [interval.iter().min_by(by_value), interval.iter().max_by(by_value)];
        let mut pair: Vec<[f64; 2]> = low.into_iter().chain(high).copied().collect();
        pair.sort_unstable_by(|one, other| one[0].total_cmp(&other[0]));
        pair
    };
    points.chunks(2 * points.len().div_ceil(MOST)).flat_map(of_interval).collect()
}

/// Parts of the distance by quantity, one panel each.
fn histograms(report: &DamageReport) -> Option<String> {
    const HEIGHT: f64 = 190.0;
    let stack = |histogram: &Histogram| {
        let shares = histogram.edges.windows(2).zip(&histogram.shares);
        let bars: Vec<[f64; 3]> =
            shares.map(|(edges, share)| [edges[0], edges[1], 100.0 * share]).collect();
        let most = bars.iter().map(|bar| bar[2]).fold(1.0, f64::max);
        let axis = Axis::Given([0.0, 1.06 * most]);
        let panel = Panel { bars, axis, ..Panel::new("distance (%)", HEIGHT, Vec::new()) };
        let x = [*histogram.edges.first()?, *histogram.edges.last()?];
        Some(Stack::over(x, name(histogram), vec![panel]))
    };
    let stacks: Option<Vec<Stack>> = report.damage.histograms.iter().map(stack).collect();
    Some(page(report, "Distribution over the distance", &stacks?))
}

fn name(histogram: &Histogram) -> String {
    match histogram.quantity {
        Quantity::WearNumber => "$Tγ$ (N)".to_owned(),
        Quantity::FatigueIndex => "fatigue index".to_owned(),
        Quantity::SlipSpeed => "mean slip speed (m/s)".to_owned(),
        other => other.name().replace('_', " "),
    }
}
