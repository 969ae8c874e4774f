//! Temperatures along a row including its wake, and below a point.

use super::{Line, Temperatures};
use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::marks::{Heading, short};
use crate::output::figures::panels::{self, Axis, Curve, Panel, Stack};
use crate::output::figures::relief::ends;

/// Height of each of the two panels.
const HEIGHT: f64 = 280.0;
/// Opacity of the curves of the row, from the surface downwards.
const STRENGTHS: [f64; 3] = [1.0, 0.6, 0.35];

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(temperatures: &Temperatures) -> Option<String> {
    let [x, y] = temperatures.request.point.map(|value| short(value / 1e-3));
    let [wheel, rail] = temperatures.bulk.map(short);
    let place = format!(
        "row $y$ = {y} mm, profile below $x$ = {x} mm; bulk: wheel {wheel} °C, rail {rail} °C"
    );
    let (title, case) = ("Temperatures of wheel and rail", &temperatures.title);
    let heading = Heading::new(title, case, place, temperatures.status);
    let heading = Heading { is_rolling: true, ..heading };
    Some(panels::page(&heading, &[row(temperatures)?, profile(temperatures)?]))
}

/// Against x, with the contact shaded.
fn row(temperatures: &Temperatures) -> Option<Stack> {
    let mut curves = Vec::new();
    for (row, strength) in temperatures.rows.iter().zip(STRENGTHS) {
        let depth = format!(", {} µm deep", short((row.depth / 1e-6).round()));
        let depth = if row.depth == 0.0 { "" } else { &depth };
        curves.extend(both(&row.line, strength, depth));
    }
    let [entry, exit] = temperatures.request.passage.map(|x| x / 1e-3);
    let x = ends(&temperatures.rows.first()?.line.position)?.map(|x| x / 1e-3);
    let (shaded, shading) = (vec![[exit, entry]], "contact");
    Some(Stack { shaded, shading, ..Stack::over(x, "$x$ (mm)", vec![panel(curves)]) })
}

/// Against the depth.
fn profile(temperatures: &Temperatures) -> Option<Stack> {
    let line = &temperatures.profile;
    Some(Stack::over(
        ends(&line.position)?.map(|depth| depth / 1e-3),
        "depth (mm)",
        vec![panel(both(line, 1.0, "").into())],
    ))
}

fn panel(curves: Vec<Curve>) -> Panel {
    Panel::new("temperature (°C)", HEIGHT, curves).with_axis(Axis::Own)
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
