//! Stresses below the surface: the stress of von Mises and the largest shear stress in a section
//! along rolling, the former in one across rolling, too, and stresses below a point.

use schlupf::Status;
use schlupf::subsurface::{Measure, Plane, PointStress, Stress};

use super::StressReport;
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{BLUE, ColorScale, GREEN, Palette, VERMILION};
use crate::output::figures::frame::Frame;
use crate::output::figures::lattice::Lattice;
use crate::output::figures::marks::{self, HEADING, short};
use crate::output::figures::panels::{Curve, LEFT, Panel, Stack, WIDTH};
use crate::output::figures::relief;
use crate::output::figures::svg::Drawing;
use crate::output::figures::ticks::round_ticks;
use crate::output::figures::units::{self, Unit};

/// Names of all figures.
pub(super) const NAMES: [&str; 4] =
    ["subsurface_section", "subsurface_across", "subsurface_shear", "subsurface_profile"];

/// Largest height of the section.
const TALLEST: f64 = 620.0;
/// Space to the right of the section, for the colour bar.
const BAR: f64 = 150.0;

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

fn heading(drawing: &mut Drawing, report: &StressReport, title: &str, place: &str) {
    let remark = if report.status == Status::Converged { "" } else { "not converged" };
    let peak = short(report.normal.peak_pressure / 1e6);
    let load = short(report.normal.load / 1e3);
    let about = format!("{place}; $N$ = {load} kN, $p$_0 = {peak} MPa");
    marks::title_block(drawing, title, [&report.title, &about], remark);
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
    let coarse = lattice(report, plane, |stress| measure.of(stress) / unit.size);
    let [low, high] = coarse.range().filter(|[low, high]| high > low)?;
    let ends = |values: &[f64]| {
        let ends = [*values.first()?, *values.last()?];
        (ends[1] > ends[0]).then_some(ends)
    };
    let (x, y) = (ends(&coarse.x)?, ends(&coarse.y)?);
    // Lengths are alike both ways, unless the section would become too tall or too flat.
    let width = WIDTH - LEFT - BAR;
    let height = (width * (y[1] - y[0]) / (x[1] - x[0])).clamp(160.0, TALLEST);
    let frame = Frame { corner: [LEFT, HEADING + 34.0], size: [width, height], x, y };
    let mut drawing = Drawing::new(WIDTH, frame.bottom() + 66.0);
    let (constant, value, axis) = match plane {
        Plane::AlongRolling { y } => ("y", y, "x"),
        Plane::AcrossRolling { x } => ("x", x, "y"),
    };
    let place = format!("plane ${constant}$ = {} mm of the {}", short(value / 1e-3), report.body());
    heading(&mut drawing, report, title, &place);
    if matches!(plane, Plane::AlongRolling { .. }) {
        marks::rolling_direction(&mut drawing, [WIDTH - 116.0, HEADING + 8.0]);
    }
    let scale = ColorScale { palette: Palette::Mechanical, low, high };
    let levels = round_ticks(low, high, 9);
    relief::draw(&mut drawing, &frame, &coarse.refined(), (&scale, &levels));
    for point in marked(report, measure, plane) {
        let depth = if is_rail { -point.depth } else { point.depth };
        let along = match plane {
            Plane::AlongRolling { .. } => point.x,
            Plane::AcrossRolling { .. } => point.y,
        };
        let at = [along, depth].map(|place| place / 1e-3);
        if frame.x[0] <= at[0] && at[0] <= frame.x[1] && frame.y[0] <= at[1] && at[1] <= frame.y[1]
        {
            marks::cross(&mut drawing, frame.at(at), MARK);
        }
    }
    frame.draw_vertical(&mut drawing, "$z$ (mm)");
    frame.draw_horizontal(&mut drawing, &format!("${axis}$ (mm)"));
    let bar = [frame.right() + 30.0, frame.corner[1] + 28.0];
    let label = format!("{symbol} ({})", unit.symbol);
    marks::color_bar(&mut drawing, bar, height - 28.0, &scale, &label);
    Some(drawing.finish())
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
    rows.sort_by(|one, other| one.0.total_cmp(&other.0));
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

/// The largest stresses.
const MARK: &str = r##"stroke="#ffffff" stroke-width="2.4" fill="none""##;

/// Invariants and components against the depth.
fn profile(report: &StressReport) -> Option<String> {
    let points = &report.profile;
    let range = [points.first()?.depth / 1e-3, points.last()?.depth / 1e-3];
    if range[1] <= range[0] {
        return None;
    }
    let unit = unit(report);
    let along = |value: fn(&Stress) -> f64| -> Vec<[f64; 2]> {
        let point = |point: &PointStress| [point.depth / 1e-3, value(&point.stress) / unit.size];
        points.iter().map(point).collect()
    };
    let invariants = vec![
        Curve::solid(along(Stress::von_mises), BLUE, "von Mises"),
        Curve::solid(along(Stress::largest_shear), VERMILION, "largest shear"),
    ];
    let components = vec![
        Curve::solid(along(|stress| stress.xx), BLUE, "$σ$_{xx}"),
        Curve::solid(along(|stress| stress.yy), GREEN, "$σ$_{yy}"),
        Curve::solid(along(|stress| stress.zz), VERMILION, "$σ$_{zz}"),
        Curve::dashed(along(|stress| stress.xz), BLUE, "$σ$_{xz}"),
        Curve::dashed(along(|stress| stress.yz), VERMILION, "$σ$_{yz}"),
    ];
    let label = format!("stress ({})", unit.symbol);
    let stack = Stack {
        x: range,
        label: "depth (mm)",
        panels: vec![
            Panel { label: label.clone(), height: 200.0, curves: invariants },
            Panel { label, height: 260.0, curves: components },
        ],
        shaded: Vec::new(),
        shading: "",
    };
    let mut drawing = stack.drawing();
    let [x, y] = report.place().map(|place| short(place / 1e-3));
    let place = format!("in the {} at $x$ = {x} mm, $y$ = {y} mm", report.body());
    heading(&mut drawing, report, "Stresses below a point", &place);
    stack.draw(&mut drawing, HEADING + 30.0);
    Some(drawing.finish())
}
