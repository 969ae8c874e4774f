//! Temperatures along a row including its wake, and below a point.

use schlupf::Status;

use super::{Line, Temperatures};
use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::marks::{self, HEADING, short};
use crate::output::figures::panels::{Curve, GAP, Panel, Stack, WIDTH};
use crate::output::figures::svg::Drawing;

/// Height of each of the two panels.
const HEIGHT: f64 = 280.0;
/// Space below the first panel, for its axis.
const AXIS: f64 = 70.0;
/// Opacity of the curves of the row, from the surface downwards.
const STRENGTHS: [f64; 3] = [1.0, 0.6, 0.35];

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(temperatures: &Temperatures) -> Option<String> {
    let stacks = [row(temperatures)?, profile(temperatures)?];
    let top = HEADING + 54.0;
    let heights = stacks.each_ref().map(Stack::plot_height);
    let below = top + heights[0] + GAP + AXIS;
    let mut drawing = Drawing::new(WIDTH, below + heights[1] + AXIS);
    heading(&mut drawing, temperatures);
    marks::rolling_direction(&mut drawing, [WIDTH - 116.0, HEADING + 14.0]);
    let [first, second] = stacks;
    first.draw(&mut drawing, top);
    second.draw(&mut drawing, below);
    Some(drawing.finish())
}

fn heading(drawing: &mut Drawing, temperatures: &Temperatures) {
    let [x, y] = temperatures.request.point.map(|value| short(value / 1e-3));
    let [wheel, rail] = temperatures.bulk.map(short);
    let place = format!(
        "row $y$ = {y} mm, profile below $x$ = {x} mm; bulk: wheel {wheel} °C, rail {rail} °C"
    );
    let converged = temperatures.status == Status::Converged;
    let remark = if converged { "" } else { "not converged" };
    let title = "Temperatures of wheel and rail";
    marks::title_block(drawing, title, [&temperatures.title, &place], remark);
}

/// Against x, with the contact shaded.
fn row(temperatures: &Temperatures) -> Option<Stack<'static>> {
    let mut curves = Vec::new();
    for (row, strength) in temperatures.rows.iter().zip(STRENGTHS) {
        let depth = format!(", {} µm deep", short((row.depth / 1e-6).round()));
        let depth = if row.depth == 0.0 { "" } else { &depth };
        curves.extend(both(&row.line, strength, depth));
    }
    let [entry, exit] = temperatures.request.passage.map(|x| x / 1e-3);
    Some(Stack {
        x: range(&temperatures.rows.first()?.line)?,
        label: "$x$ (mm)",
        panels: vec![panel(curves)],
        shaded: vec![[exit, entry]],
        shading: "contact",
    })
}

/// Against the depth.
fn profile(temperatures: &Temperatures) -> Option<Stack<'static>> {
    let line = &temperatures.profile;
    Some(Stack {
        x: range(line)?,
        label: "depth (mm)",
        panels: vec![panel(both(line, 1.0, "").into())],
        shaded: Vec::new(),
        shading: "",
    })
}

fn panel(curves: Vec<Curve>) -> Panel {
    Panel { label: "temperature (°C)".to_owned(), height: HEIGHT, curves }
}

/// Ends of a line, in mm.
fn range(line: &Line) -> Option<[f64; 2]> {
    let [start, end] = [line.position.first()? / 1e-3, line.position.last()? / 1e-3];
    (start < end && start.is_finite() && end.is_finite()).then_some([start, end])
}

/// Wheel and rail at a depth; the rail is dashed, so that both are visible where they coincide.
fn both(line: &Line, strength: f64, depth: &str) -> [Curve; 2] {
    let points = |values: &[f64]| -> Vec<[f64; 2]> {
        line.position.iter().zip(values).map(|(at, value)| [at / 1e-3, *value]).collect()
    };
    let faded = |curve: Curve| Curve {
        stroke: format!(r#"{} stroke-opacity="{strength}""#, curve.stroke),
        ..curve
    };
    [
        faded(Curve::solid(points(&line.wheel), VERMILION, &format!("wheel{depth}"))),
        faded(Curve::dashed(points(&line.rail), BLUE, &format!("rail{depth}"))),
    ]
}
