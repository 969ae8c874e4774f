//! Damage over a run: wear across the profile, the run, and distributions.

use schlupf::Quantity;
use schlupf::damage::{Histogram, Profile, RunPoint};

use super::DamageReport;
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::frame::Frame;
use crate::output::figures::marks::{self, HEADING, short};
use crate::output::figures::panels::{Curve, LEFT, Panel, RIGHT, Stack, WIDTH};
use crate::output::figures::svg::Drawing;

/// Names of all figures.
pub(super) const NAMES: [&str; 3] = ["damage_wear", "damage_run", "damage_histograms"];

/// All figures.
pub(super) fn draw(report: &DamageReport) -> Vec<Named> {
    let drawn = [wear(report), run(report), histograms(report)];
    let named = NAMES.iter().zip(drawn);
    named.filter_map(|(name, svg)| Some(((*name).to_owned(), svg?))).collect()
}

fn heading(drawing: &mut Drawing, report: &DamageReport, title: &str) {
    let damage = &report.damage;
    let about = format!(
        "{} states over {} km, {} kJ of friction",
        damage.states,
        short(damage.distance / 1e3),
        short(damage.energy / 1e3)
    );
    let remark = if report.left_out.states == 0 { "" } else { "some states are left out" };
    marks::title_block(drawing, title, [&report.title, &about], remark);
}

fn finished(report: &DamageReport, title: &str, stack: &Stack) -> String {
    let mut drawing = stack.drawing();
    heading(&mut drawing, report, title);
    stack.draw(&mut drawing, HEADING + 30.0);
    drawing.finish()
}

/// Depth of wear of wheel and rail across the profile.
fn wear(report: &DamageReport) -> Option<String> {
    let profile = &report.damage.profile;
    let panel = |label: &str, unit: f64, depths: [&[f64]; 2]| {
        let curves = [(BLUE, "Archard"), (VERMILION, "energy")].into_iter().zip(depths);
        let curves = curves
            .map(|((color, text), depth)| Curve::solid(outline(profile, depth, unit), color, text));
        Panel { label: label.to_owned(), height: 240.0, curves: curves.collect() }
    };
    let ends = outline(profile, &profile.wheel_archard, 1.0);
    let stack = Stack {
        x: [ends.first()?[0], ends.last()?[0]],
        label: "$y$ across the profile (mm)",
        panels: vec![
            panel(
                "wheel, over the run (µm)",
                1e-6,
                [&profile.wheel_archard, &profile.wheel_energy],
            ),
            panel("rail, for each wheel (nm)", 1e-9, [&profile.rail_archard, &profile.rail_energy]),
        ],
        shaded: Vec::new(),
        shading: "",
    };
    Some(finished(report, "Depth of wear", &stack))
}

/// Points in mm and a unit (in m), down to zero at both ends.
fn outline(profile: &Profile, depth: &[f64], unit: f64) -> Vec<[f64; 2]> {
    let half = match profile.y[..] {
        [first, second, ..] => 0.5 * (second - first),
        _ => 1e-4,
    };
    let point = |(y, depth): (&f64, &f64)| [y / 1e-3, depth / unit];
    let first = profile.y.first().map(|y| [(y - half) / 1e-3, 0.0]);
    let last = profile.y.last().map(|y| [(y + half) / 1e-3, 0.0]);
    let points = profile.y.iter().zip(depth).map(point);
    first.into_iter().chain(points).chain(last).collect()
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
        let curve = Curve {
            stroke: format!(r#"stroke="{color}" stroke-width="1.3" stroke-linejoin="round""#),
            ..Curve::solid(thinned(&all), color, "")
        };
        Panel { label: label.to_owned(), height: 150.0, curves: vec![curve] }
    };
    let kilojoules = &|point: &RunPoint| point.energy / 1e3;
    let mut panels = vec![
        panel("$Tγ$ (N)", BLUE, &|point| point.t_gamma),
        panel("fatigue index", VERMILION, &|point| point.fatigue_index),
        panel("energy (kJ)", BLUE, kilojoules),
    ];
    if points.iter().any(|point| point.position_y != points[0].position_y) {
        panels.push(panel("$y$ of the patch (mm)", BLUE, &|point| point.position_y / 1e-3));
    }
    let stack = Stack {
        x: [0.0, points.last()?.distance.max(distance) / unit],
        label,
        panels,
        shaded: Vec::new(),
        shading: "",
    };
    Some(finished(report, "Damage along the run", &stack))
}

fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= MOST {
        return points.to_vec();
    }
    let of_interval = |interval: &[[f64; 2]]| {
        let by_value = |one: &&[f64; 2], other: &&[f64; 2]| one[1].total_cmp(&other[1]);
        let [low, high] = [interval.iter().min_by(by_value), interval.iter().max_by(by_value)];
        let mut pair: Vec<[f64; 2]> = low.into_iter().chain(high).copied().collect();
        pair.sort_by(|one, other| one[0].total_cmp(&other[0]));
        pair
    };
    points.chunks(2 * points.len().div_ceil(MOST)).flat_map(of_interval).collect()
}

/// Parts of the distance by quantity, one panel each.
fn histograms(report: &DamageReport) -> Option<String> {
    const EACH: f64 = 190.0;
    const AXIS: f64 = 74.0;
    let histograms = &report.damage.histograms;
    let top = HEADING + 20.0;
    let mut drawing = Drawing::new(WIDTH, top + histograms.len() as f64 * (EACH + AXIS));
    heading(&mut drawing, report, "Parts of the distance");
    let mut corner = [LEFT, top];
    for histogram in histograms {
        let most = 100.0 * histogram.shares.iter().copied().fold(0.0, f64::max);
        let x = [*histogram.edges.first()?, *histogram.edges.last()?];
        let y = [0.0, 1.06 * most.max(1.0)];
        let frame = Frame { corner, size: [WIDTH - LEFT - RIGHT, EACH], x, y };
        frame.draw_grid(&mut drawing);
        for (edges, share) in histogram.edges.windows(2).zip(&histogram.shares) {
            let [left, top] = frame.at([edges[0], 100.0 * share]);
            let [right, bottom] = frame.at([edges[1], 0.0]);
            let size = [right - left, bottom - top];
            let fill = format!(r##"fill="{BLUE}" stroke="#ffffff" stroke-width="1""##);
            drawing.rectangle([left, top], size, &fill);
        }
        frame.draw_vertical(&mut drawing, "distance (%)");
        frame.draw_horizontal(&mut drawing, &axis(histogram));
        corner[1] += EACH + AXIS;
    }
    Some(drawing.finish())
}

fn axis(histogram: &Histogram) -> String {
    match histogram.quantity {
        Quantity::WearNumber => "$Tγ$ (N)".to_owned(),
        Quantity::FatigueIndex => "fatigue index".to_owned(),
        Quantity::SlipSpeed => "mean slip speed (m/s)".to_owned(),
        other => other.name().replace('_', " "),
    }
}
