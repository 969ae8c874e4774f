//! Figures of a wheelset: which points of both profiles touch each other over the lateral position,
//! and what follows for rolling radii, angles and conicity.

use schlupf::wheel_rail::{Contact, RollingRadiusDifference, Side, Surface};

use super::{WheelsetAt, WheelsetReport};
use crate::output::figures::color::{BLUE, ColorScale, GREEN, INK, Palette, VERMILION};
use crate::output::figures::frame::Frame;
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::marks::{self, HEADING, Heading, short};
use crate::output::figures::panels::{self, Axis, Curve, Panel, Stack, WIDTH, known};
use crate::output::figures::svg::Drawing;
use crate::output::profiles::places;
use crate::output::report::Report;

/// Distance by which the wheels are drawn above the rails, in mm.
const LIFT: f64 = 14.0;

/// Width of a view of one side, in mm.
const VIEW: f64 = 116.0;

/// Outmost position that a view shows beyond the middle of the rail, in mm.
const BEYOND: f64 = 40.0;

/// Space between both views, and right of them for the colours.
const BETWEEN: f64 = 70.0;
const BAR: f64 = 84.0;

/// Both profiles of each side, the wheel lifted, with a line between the points that touch each
/// other at each lateral position.
pub(super) fn contacts(report: &WheelsetReport) -> Option<String> {
    let [left, right] = [report.positions.first()?.lateral, report.positions.last()?.lateral];
    let ends = [1e3 * left.min(right), 1e3 * left.max(right)];
    let ends = if left == right { [ends[0], ends[0] + 1.0] } else { ends };
    let scale = ColorScale::linear(Palette::Mechanical, ends);
    let width = 0.5 * (WIDTH - 60.0 - BETWEEN - BAR);
    let low = -46.0;
    let high = LIFT + 12.0;
    let height = width * (high - low) / VIEW;
    let top = HEADING + 34.0;
    let mut drawing = Drawing::new(WIDTH, top + height + 66.0);
    let load = format!(
        "lateral positions {} to {} mm, $N$ = {} kN on each wheel; wheels drawn {LIFT} mm above the \
         rails, patches to scale",
        short(1e3 * left),
        short(1e3 * right),
        short(1e-3 * report.load)
    );
    Heading::new("Contact points", &report.title, load, report.status()).draw(&mut drawing);
    for (k, side) in [Side::Left, Side::Right].into_iter().enumerate() {
        // As seen by who looks along the track, so the axis is that of −y.
        let outer = -side.outwards() * (1e3 * report.pairs.of(side).rail_origin()[0] + BEYOND);
        let inner = outer + side.outwards() * VIEW;
        let frame = Frame {
            corner: [60.0 + k as f64 * (width + BETWEEN), top],
            size: [width, height],
            x: [outer.min(inner), outer.max(inner)],
            y: [low, high],
            powers: false,
        };
        view(&mut drawing, report, (&frame, side, &scale));
    }
    let bar = [WIDTH - BAR + 24.0, top + 20.0];
    marks::color_bar(&mut drawing, bar, height - 20.0, &scale, "$y$ (mm)");
    Some(drawing.finish())
}

/// One side, seen along the track.
fn view(
    drawing: &mut Drawing,
    report: &WheelsetReport,
    (frame, side, scale): (&Frame, Side, &ColorScale),
) {
    let sign = side.outwards();
    let pair = report.pairs.of(side);
    let line = |curve: &Surface, place: &dyn Fn([f64; 2]) -> [f64; 2]| -> Vec<[f64; 2]> {
        places(curve).map(|at| frame.at(place(at))).collect()
    };
    let rail = |[y, z]: [f64; 2]| [-1e3 * sign * y, 1e3 * z];
    let wheel = |[y, z]: [f64; 2]| [-1e3 * sign * (y + pair.wheel_offset()), 1e3 * z + LIFT];
    drawing.begin_clip(&frame.area());
    let stroke = format!(r#"stroke="{INK}" stroke-width="1.8" stroke-linejoin="round""#);
    drawing.polyline(&line(pair.rail(), &rail), &stroke);
    drawing.polyline(&line(pair.wheel(), &wheel), &stroke);
    for at in &report.positions {
        let Some(solution) = at.wheel(side) else { continue };
        let color = scale.paint(1e3 * at.lateral);
        for contact in &solution.contacts {
            let on_wheel = on_profile(pair.wheel(), contact.wheel_position).map(wheel);
            let on_rail = [-1e3 * contact.position[1], 1e3 * contact.position[2]];
            if let Some(on_wheel) = on_wheel {
                let style = format!(r#"stroke="{color}" stroke-width="1.2""#);
                drawing.line(frame.at(on_rail), frame.at(on_wheel), &style);
            }
            patch(drawing, frame, contact, &color);
        }
    }
    drawing.end_group();
    frame.draw_vertical(drawing, if side == Side::Left { "$z$ (mm)" } else { "" });
    frame.draw_horizontal(drawing, "to the right, −$y$ (mm)");
    let name = format!("{} wheel and rail", side.name());
    let at = [frame.corner[0], frame.corner[1] - 10.0];
    drawing.text(at, &TextStyle::new(14.0, Anchor::Start), &name);
}

/// The width of a patch on the rail.
fn patch(drawing: &mut Drawing, frame: &Frame, contact: &Contact, color: &str) {
    let half = 1e3 * contact.solution.normal.semi_axis_y;
    let (sin, cos) = contact.angle.sin_cos();
    let origin = contact.solution.normal.origin.map_or(0.0, |origin| 1e3 * origin[1]);
    let [_, y, z] = contact.position.map(|part| 1e3 * part);
    let end = |s: f64| frame.at([-y - s * cos, z - s * sin]);
    let style =
        format!(r#"stroke="{color}" stroke-width="4" stroke-linecap="round" stroke-opacity="0.7""#);
    drawing.line(end(origin - half), end(origin + half), &style);
}

/// The lowest point of a wheel's profile at y (in m).
fn on_profile(curve: &Surface, y: f64) -> Option<[f64; 2]> {
    let points: Vec<[f64; 2]> = places(curve).collect();
    let crossing = |pair: &[[f64; 2]]| {
        let share = (y - pair[0][0]) / (pair[1][0] - pair[0][0]);
        (0.0..=1.0).contains(&share).then(|| [y, pair[0][1] + share * (pair[1][1] - pair[0][1])])
    };
    points.windows(2).filter_map(crossing).min_by(|p, q| p[1].total_cmp(&q[1]))
}

/// Δr of rigid bodies (in mm) over the lateral positions (in mm) between two (in m).
fn rigid(radii: &RollingRadiusDifference, from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> {
    let points = radii.lateral.iter().zip(&radii.difference);
    let within = points.filter(move |(y, _)| (from.min(to)..=from.max(to)).contains(*y));
    within.map(|(y, difference)| [1e3 * y, 1e3 * difference])
}

/// Height of each panel.
const HEIGHT: f64 = 210.0;

/// Largest slope of a rail at a contact on its head, in rad: beyond it is the gauge corner or the
/// flange, where Δr is many times as large.
const TREAD: f64 = 0.5;

/// The largest slope of both rails at the contacts of a position, in rad.
fn steepest(at: &WheelsetAt) -> f64 {
    let wheels = [Side::Left, Side::Right].into_iter().filter_map(|side| at.wheel(side));
    let contacts = wheels.flat_map(|wheel| &wheel.contacts);
    contacts.map(|contact| contact.angle.abs()).fold(0.0, f64::max)
}

/// The range of an axis for values (Δr) on the treads, where it is less than half of that of all.
fn on_treads(points: &[[f64; 2]], steepest: &[f64]) -> Option<[f64; 2]> {
    let known = points.iter().zip(steepest).filter(|(point, _)| point[1].is_finite());
    let largest = |most: f64| {
        let within = known.clone().filter(|(_, slope)| **slope <= most);
        within.map(|(point, _)| point[1].abs()).fold(0.0, f64::max)
    };
    let end = 1.25 * largest(TREAD);
    (0.0 < end && end < 0.5 * largest(f64::INFINITY)).then_some([-end, end])
}

/// Δr and angles over the lateral position, and the equivalent conicity over the amplitude.
pub(super) fn radii(report: &WheelsetReport) -> Option<String> {
    let [from, to] = [report.positions.first()?.lateral, report.positions.last()?.lateral];
    if from == to {
        return None;
    }
    let of = |value: &dyn Fn(&WheelsetAt) -> Option<f64>| -> Vec<[f64; 2]> {
        let point = |at: &WheelsetAt| [1e3 * at.lateral, known(value(at))];
        report.positions.iter().map(point).collect()
    };
    let difference = of(&|at| at.rolling_radius_difference().map(|value| 1e3 * value));
    let rigid: Vec<[f64; 2]> =
        report.radii.iter().flat_map(|radii| rigid(radii, from, to)).collect();
    let angle =
        |side: Side| of(&move |at| at.wheel(side)?.contacts.first().map(|contact| contact.angle));
    let slopes: Vec<f64> = report.positions.iter().map(steepest).collect();
    let treads = on_treads(&difference, &slopes);
    let of_radii = vec![
        Curve::solid(difference, GREEN, "left minus right"),
        Curve::dashed(rigid, INK, "rigid, without roll"),
    ];
    let of_angles = vec![
        Curve::solid(angle(Side::Left), BLUE, "left wheel"),
        Curve::solid(angle(Side::Right), VERMILION, "right wheel"),
    ];
    let curve = &report.conicity;
    let points = |of: &[Option<f64>]| -> Vec<[f64; 2]> {
        curve.amplitude.iter().zip(of).map(|(a, c)| [1e3 * a, known(*c)]).collect()
    };
    let nonlinear = "wavelength of the nonlinear motion (EN 15302)";
    let of_conicity = vec![
        Curve::solid(points(&curve.nonlinear), INK, nonlinear),
        Curve::dashed(points(&curve.harmonic), VERMILION, "harmonic linearisation"),
    ];
    let axis = treads.map_or(Axis::Zero, Axis::Given);
    let over_position = vec![
        Panel::new("Δ$r$ (mm)", HEIGHT, of_radii).with_axis(axis),
        Panel::new("contact angle (rad)", HEIGHT, of_angles),
    ];
    let widest = 1e3 * curve.amplitude.last().copied().unwrap_or(1e-3);
    let panel = Panel::new("equivalent conicity", HEIGHT, of_conicity);
    let label = "lateral position to the left, $y$ (mm)";
    let stacks = [
        Stack::over([1e3 * from.min(to), 1e3 * from.max(to)], label, over_position),
        Stack::over([0.0, widest], "amplitude (mm)", vec![panel]),
    ];
    let cut = if treads.is_some() { "; Δ$r$ of flange contacts beyond its axis" } else { "" };
    let load = format!("$N$ = {} kN on each wheel{cut}", short(1e-3 * report.load));
    let title = "Rolling radius, contact angle and conicity";
    Some(panels::page(&Heading::new(title, &report.title, load, report.status()), &stacks))
}

#[cfg(test)]
mod tests {
    use super::on_treads;

    /// Δr of some 20 mm on the flange would flatten the tread.
    #[test]
    fn the_axis_of_radii_is_that_of_the_treads() {
        let points = [[-7.0, -20.0], [-3.0, -0.8], [0.0, 0.0], [3.0, 0.8], [7.0, f64::NAN]];
        assert_eq!(on_treads(&points, &[1.2, 0.1, 0.0, 0.1, 0.0]), Some([-1.0, 1.0]));
        assert_eq!(on_treads(&points, &[0.1; 5]), None);
        assert_eq!(on_treads(&points, &[1.2; 5]), None);
    }
}
