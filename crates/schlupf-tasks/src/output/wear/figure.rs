//! Damage per wheel passage: depth of wear across the profile, its rate in the patch, and the
//! shakedown map.

use schlupf::analysis::damage::{PassageWear, ShakedownLimits};

use super::WearReport;
use crate::output::figures::color::{BLUE, GREEN, INK, Palette, VERMILION};
use crate::output::figures::marks::{Entry, Heading, Shape, short};
use crate::output::figures::panels::{self, Axis, Curve, Mark, Panel, Stack};
use crate::output::figures::patch::Patch;
use crate::output::figures::quantity::Quantity;
use crate::output::figures::{Drawing as Named, map};

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

fn page(report: &WearReport, title: &str, about: String, stack: Stack) -> String {
    let heading = Heading::new(title, &report.title, about, report.solution.status);
    panels::page(&heading, &[stack])
}

/// Depth across the profile by both laws.
fn profile(report: &WearReport, wear: &PassageWear) -> Option<String> {
    let profile = &wear.profile;
    let curves = [(BLUE, "Archard", &profile.archard), (VERMILION, "energy", &profile.rail_energy)];
    let curves = curves.map(|(color, law, depth)| {
        Curve::solid(panels::across(&profile.y, depth, 1e-9), color, law)
    });
    let ends = &curves[0].points;
    let x = [ends.first()?[0], ends.last()?[0]];
    let stack = Stack::over(x, "$y$ (mm)", vec![Panel::new("depth (nm)", 280.0, curves.into())]);
    let about = format!("{} N of friction per distance", short(wear.energy_per_distance));
    Some(page(report, "Depth of wear per wheel passage", about, stack))
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
    let (friction, limit) = limits[limits.len() / 12];
    let curves = vec![
        Curve::solid(along(|limits| limits.shakedown), VERMILION, "shakedown limit"),
        Curve::solid(along(|limits| limits.elastic), BLUE, "elastic limit"),
        Curve::dashed(surface, INK, "fatigue index 0: $p$_0/$k$ = $N$/|$F$|"),
    ];
    let style = format!(r##"fill="{GREEN}" stroke="#ffffff" stroke-width="1.5""##);
    let at = [point.traction_coefficient, point.load_factor];
    let mark = Mark { at, shape: Shape::Dot, style: style.clone(), range: None };
    let words = [
        (0.5 * limit.elastic, "elastic"),
        (0.5 * (limit.elastic + limit.shakedown), "shakes down"),
        (0.5 * (limit.shakedown + highest), "beyond shakedown"),
    ];
    // The middle of a wide text stays clear of the axis.
    let clear = |text: &str| friction.max(if text.len() > 12 { 0.16 * widest } else { 0.0 });
    let panel = Panel {
        marks: vec![mark],
        words: words.map(|(height, text)| ([clear(text), height], text)).to_vec(),
        entries: vec![Entry::mark(Shape::Dot, style, "this case")],
        axis: Axis::Given([0.0, highest]),
        ..Panel::new("load factor $p$_0/$k$", 420.0, curves)
    };
    let stack = Stack::over([0.0, widest], "traction coefficient |$F$|/$N$", vec![panel]);
    let about = format!(
        "$p$_0/$k$ = {} at |$F$|/$N$ = {}, with $k$ = {} MPa; limits of a sliding line contact",
        short(point.load_factor),
        short(point.traction_coefficient),
        short(report.laws.fatigue.shear_yield_stress / 1e6)
    );
    page(report, "Shakedown map", about, stack)
}
