//! Damage of a passage: depth of wear across the profile, its rate in the patch, and the shakedown
//! map.

use schlupf::Status;
use schlupf::damage::{PassageWear, ShakedownLimits};

use super::WearReport;
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{BLUE, GREEN, INK, MUTED, Palette, VERMILION};
use crate::output::figures::frame::Frame;
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::map;
use crate::output::figures::marks::{self, Entry, HEADING, Sample, short};
use crate::output::figures::panels::{Curve, LEFT, Panel, RIGHT, Stack, WIDTH};
use crate::output::figures::patch::Patch;
use crate::output::figures::quantity::Quantity;
use crate::output::figures::svg::Drawing;

/// Names of all figures.
pub(super) const NAMES: [&str; 3] = ["wear_profile", "wear_rate", "wear_shakedown"];

/// All figures: without wear, the shakedown map.
pub(super) fn draw(report: &WearReport) -> Vec<Named> {
    let wear = report.passage.wear.as_ref();
    let drawn = [
        wear.and_then(|wear| profile(report, wear)),
        wear.and_then(|wear| rate(report, wear)),
        Some(shakedown(report)),
    ];
    let named = NAMES.iter().zip(drawn);
    named.filter_map(|(name, svg)| Some(((*name).to_owned(), svg?))).collect()
}

fn heading(drawing: &mut Drawing, report: &WearReport, title: &str, about: &str) {
    let remark = if report.solution.status == Status::Converged { "" } else { "not converged" };
    marks::title_block(drawing, title, [&report.title, about], remark);
}

/// Depth across the profile by both laws.
fn profile(report: &WearReport, wear: &PassageWear) -> Option<String> {
    let profile = &wear.profile;
    let width = match profile.y[..] {
        [first, second, ..] => second - first,
        _ => return None,
    };
    let outline = |depth: &[f64]| -> Vec<[f64; 2]> {
        let ends = [profile.y.first(), profile.y.last()].map(|end| end.copied().unwrap_or(0.0));
        let points = profile.y.iter().zip(depth).map(|(y, depth)| [y / 1e-3, depth / 1e-9]);
        let first = [(ends[0] - 0.5 * width) / 1e-3, 0.0];
        let last = [(ends[1] + 0.5 * width) / 1e-3, 0.0];
        [first].into_iter().chain(points).chain([last]).collect()
    };
    let curves = vec![
        Curve::solid(outline(&profile.archard), BLUE, "Archard"),
        Curve::solid(outline(&profile.rail_energy), VERMILION, "energy"),
    ];
    let ends = &curves[0].points;
    let stack = Stack {
        x: [ends.first()?[0], ends.last()?[0]],
        label: "$y$ (mm)",
        panels: vec![Panel { label: "depth (nm)".to_owned(), height: 280.0, curves }],
        shaded: Vec::new(),
        shading: "",
    };
    let mut drawing = stack.drawing();
    let about = format!("{} N of friction per distance", short(wear.energy_per_distance));
    heading(&mut drawing, report, "Depth of wear of one passage", &about);
    stack.draw(&mut drawing, HEADING + 30.0);
    Some(drawing.finish())
}

/// Rate of Archard's law over the patch.
fn rate(report: &WearReport, wear: &PassageWear) -> Option<String> {
    let patch = Patch::new(&report.title, &report.solution)?;
    let quantity = Quantity {
        name: "wear_rate",
        title: "Depth worn per distance in the contact, Archard".to_owned(),
        label: "nm/mm".to_owned(),
        values: wear.cells.archard.iter().map(|rate| rate / 1e-6).collect(),
        vanishes_at_rim: true,
        normalised: false,
        palette: Palette::Thermal,
        base: 0.0,
    };
    quantity.is_visible(0.0).then(|| map::draw(&patch, &quantity, None))
}

/// Points of the curves of the map.
const POINTS: u32 = 40;

/// The shakedown map of a line contact with the point of the case.
fn shakedown(report: &WearReport) -> String {
    let point = &report.passage.shakedown;
    let widest = (1.2 * point.traction_coefficient).max(0.6);
    let highest = (1.2 * point.load_factor).max(6.0);
    let top = HEADING + 30.0;
    let frame = Frame {
        corner: [LEFT, top],
        size: [WIDTH - LEFT - RIGHT, 420.0],
        x: [0.0, widest],
        y: [0.0, highest],
    };
    let mut drawing = Drawing::new(WIDTH, frame.bottom() + 66.0);
    let about = format!(
        "p_0/k = {} at |F|/N = {}, with k = {} MPa; limits of a sliding line contact",
        short(point.load_factor),
        short(point.traction_coefficient),
        short(report.laws.fatigue.shear_yield_stress / 1e6)
    );
    let about = about.replace("p_0", "$p$_0").replace("|F|/N", "|$F$|/$N$");
    heading(&mut drawing, report, "Shakedown map", &about);
    frame.draw_grid(&mut drawing);
    let limits: Vec<(f64, ShakedownLimits)> = (0..=POINTS)
        .map(|k| widest * f64::from(k) / f64::from(POINTS))
        .map(|friction| (friction, ShakedownLimits::of(friction, point.poisson_ratio)))
        .collect();
    let along = |value: fn(&ShakedownLimits) -> f64| -> Vec<[f64; 2]> {
        limits.iter().map(|(friction, limits)| [*friction, value(limits)]).collect()
    };
    let surface: Vec<[f64; 2]> = (1..=20 * POINTS)
        .map(|k| widest * f64::from(k) / f64::from(20 * POINTS))
        .map(|friction| [friction, friction.recip()])
        .filter(|point| point[1] <= highest)
        .collect();
    let curves = [
        Curve::solid(along(|limits| limits.shakedown), VERMILION, "shakedown limit"),
        Curve::solid(along(|limits| limits.elastic), BLUE, "elastic limit"),
        Curve::dashed(surface, INK, "fatigue index 0: $p$_0/$k$ = $N$/|$F$|"),
    ];
    for curve in &curves {
        let points: Vec<[f64; 2]> = curve.points.iter().map(|point| frame.at(*point)).collect();
        drawing.polyline(&points, &curve.stroke);
    }
    let style = TextStyle { color: MUTED, ..TextStyle::new(15.0, Anchor::Middle) };
    let mid = limits.len() / 12;
    let (friction, limit) = limits[mid];
    for (height, text) in [
        (0.5 * limit.elastic, "elastic"),
        (0.5 * (limit.elastic + limit.shakedown), "shakes down"),
        (0.5 * (limit.shakedown + highest), "beyond shakedown"),
    ] {
        // The middle of a wide text stays clear of the axis.
        let x = friction.max(if text.len() > 12 { 0.16 * widest } else { 0.0 });
        let [x, y] = frame.at([x, height]);
        drawing.text([x, y + 5.0], &style, text);
    }
    let at = frame.at([point.traction_coefficient, point.load_factor]);
    let mark = format!(r##"fill="{GREEN}" stroke="#ffffff" stroke-width="1.5""##);
    marks::dot(&mut drawing, at, &mark);
    frame.draw_vertical(&mut drawing, "load factor $p$_0/$k$");
    frame.draw_horizontal(&mut drawing, "traction coefficient |$F$|/$N$");
    let line = |curve: &Curve| Entry {
        sample: Sample::Line(vec![curve.stroke.clone()]),
        text: curve.text.clone(),
    };
    let mut entries: Vec<Entry> = curves.iter().map(line).collect();
    entries.push(Entry { sample: Sample::Dot(mark), text: "this case".to_owned() });
    marks::legend_above(&mut drawing, frame.corner, frame.size[0], &entries);
    drawing.finish()
}
