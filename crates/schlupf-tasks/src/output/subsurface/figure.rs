//! Stresses below the surface: the stress of von Mises and the largest shear stress in a section
//! along rolling, the former in one across rolling, too, and stresses below a point.

use schlupf::analysis::subsurface::{Measure, Plane, PointStress, Stress};

use super::StressReport;
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{BLUE, ColorScale, GREEN, Palette, VERMILION};
use crate::output::figures::lattice::Lattice;
use crate::output::figures::marks::{Heading, short};
use crate::output::figures::panels::{self, Curve, Panel, Stack};
use crate::output::figures::relief::{PLOT, Relief, ends};
use crate::output::figures::ticks::round_ticks;
use crate::output::figures::units::{self, Unit};

/// Names of all figures.
pub(super) const NAMES: [&str; 4] =
    ["subsurface_section", "subsurface_across", "subsurface_shear", "subsurface_profile"];

/// Largest height of the section.
const TALLEST: f64 = 620.0;

/// All figures; `None` where there is nothing to draw.
pub(super) fn draw(report: &StressReport) -> Option<Vec<Named>> {
    let [x, y] = report.place();
    let [along, across] = [Plane::AlongRolling { y }, Plane::AcrossRolling { x }];
    let drawn = [
        section(report, Measure::VonMises, along)?,
        section(report, Measure::VonMises, across)?,
        section(report, Measure::Shear, along)?,
        profile(report)?,
    ];
    Some(NAMES.iter().zip(drawn).map(|(name, svg)| ((*name).to_owned(), svg)).collect())
}

fn heading<'a>(report: &'a StressReport, title: &'a str, place: &str) -> Heading<'a> {
    let peak = short(report.normal.peak_pressure / 1e6);
    let load = short(report.normal.load / 1e3);
    let about = format!("{place}; $N$ = {load} kN, $p$_0 = {peak} MPa");
    Heading::new(title, &report.title, about, report.status)
}

/// The unit in which the stress of von Mises is shown.
fn unit(report: &StressReport) -> Unit {
    units::pick(units::PRESSURE, report.largest[0].anywhere.stress.von_mises())
}

/// A plane through the profile; depths downwards in the rail and upwards in the wheel, as they lie
/// in the frame.
fn section(report: &StressReport, measure: Measure, plane: Plane) -> Option<String> {
    let unit = unit(report);
    let (title, symbol) = match measure {
        Measure::VonMises => ("Equivalent stress of von Mises", "$σ$_v"),
        Measure::Shear => ("Largest shear stress", "$τ$_{max}"),
        Measure::Tension => ("Largest principal stress", "$σ$_1"),
    };
    let is_rail = report.body() == "rail";
    let lattice = lattice(report, plane, |stress| measure.of(stress) / unit.size);
    let [low, high] = lattice.range().filter(|[low, high]| high > low)?;
    let (x, y) = (ends(&lattice.x)?, ends(&lattice.y)?);
    let (constant, value, axis) = match plane {
        Plane::AlongRolling { y } => ("y", y, "x"),
        Plane::AcrossRolling { x } => ("x", x, "y"),
    };
    let place = format!("plane ${constant}$ = {} mm of the {}", short(value / 1e-3), report.body());
    let is_rolling = matches!(plane, Plane::AlongRolling { .. });
    let heading = Heading { is_rolling, ..heading(report, title, &place) };
    let cross = |point: &PointStress| {
        let depth = if is_rail { -point.depth } else { point.depth };
        [if is_rolling { point.x } else { point.y }, depth].map(|place| place / 1e-3)
    };
    let relief = Relief {
        lattice: &lattice,
        scale: ColorScale::linear(Palette::Mechanical, [low, high]),
        levels: round_ticks(low, high, 9),
        labels: [&format!("${axis}$ (mm)"), "$z$ (mm)", &format!("{symbol} ({})", unit.symbol)],
        // Lengths are alike both ways, unless the section would become too tall or too flat.
        height: (PLOT * (y[1] - y[0]) / (x[1] - x[0])).clamp(160.0, TALLEST),
        crosses: marked(report, measure, plane).into_iter().map(cross).collect(),
    };
    relief.page(&heading)
}

/// A number for every point of a plane, from its lower to its upper edge; lengths in mm.
fn lattice(report: &StressReport, plane: Plane, value: impl Fn(&Stress) -> f64) -> Lattice {
    let volume = &report.volume;
    let grid = &volume.grid;
    let sign = if report.body() == "rail" { -1.0 } else { 1.0 };
    let rows = volume.section(plane).into_iter().zip(&volume.layers);
    let mut rows: Vec<(f64, Vec<f64>)> = rows
        .map(|(row, layer)| (sign * layer.depth / 1e-3, row.iter().map(&value).collect()))
        .collect();
    rows.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
    let (heights, rows) = rows.into_iter().unzip();
    let along = match plane {
        Plane::AlongRolling { .. } => (0..grid.columns).map(|i| grid.x(i) / 1e-3).collect(),
        Plane::AcrossRolling { .. } => (0..grid.rows).map(|j| grid.y(j) / 1e-3).collect(),
    };
    Lattice { x: along, y: heights, rows }
}

/// The points where a measure is largest, on the surface and below, as far as they lie in a plane,
/// to half a cell.
fn marked(report: &StressReport, measure: Measure, plane: Plane) -> Vec<&PointStress> {
    let grid = &report.volume.grid;
    let is_near = |point: &&PointStress| match plane {
        Plane::AlongRolling { y } => (point.y - y).abs() <= 0.5 * grid.spacing_y,
        Plane::AcrossRolling { x } => (point.x - x).abs() <= 0.5 * grid.spacing_x,
    };
    let of_measure = Measure::ALL.iter().zip(&report.largest).filter(|(of, _)| **of == measure);
    let points =
        of_measure.flat_map(|(_, largest)| [Some(&largest.surface), largest.below.as_ref()]);
    points.flatten().filter(is_near).collect()
}

/// Invariants and components against the depth.
fn profile(report: &StressReport) -> Option<String> {
    let points = &report.profile;
    let depths: Vec<f64> = points.iter().map(|point| point.depth / 1e-3).collect();
    let range = ends(&depths)?;
    let unit = unit(report);
    let along = |value: fn(&Stress) -> f64| -> Vec<[f64; 2]> {
        let point = |point: &PointStress| [point.depth / 1e-3, value(&point.stress) / unit.size];
        points.iter().map(point).collect()
    };
    let invariants = vec![
        Curve::solid(along(Stress::von_mises), BLUE, "von Mises"),
        Curve::solid(along(Stress::largest_shear), VERMILION, "largest shear"),
    ];
    let all = [
        Curve::solid(along(|stress| stress.xx), BLUE, "$σ$_{xx}"),
        Curve::solid(along(|stress| stress.yy), GREEN, "$σ$_{yy}"),
        Curve::solid(along(|stress| stress.zz), VERMILION, "$σ$_{zz}"),
        Curve::dashed(along(|stress| stress.xz), BLUE, "$σ$_{xz}"),
        Curve::dashed(along(|stress| stress.yz), VERMILION, "$σ$_{yz}"),
    ];
    let label = format!("stress ({})", unit.symbol);
    let panels = vec![
        Panel::new(label.clone(), 200.0, invariants),
        Panel::of_components(label, 260.0, all.into()),
    ];
    let [x, y] = report.place().map(|place| short(place / 1e-3));
    let place = format!("in the {} at $x$ = {x} mm, $y$ = {y} mm", report.body());
    let stack = Stack::over(range, "depth (mm)", panels);
    Some(panels::page(&heading(report, "Stresses below a point", &place), &[stack]))
}
