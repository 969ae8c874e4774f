//! Forces and temperature against the distance rolled.

use schlupf::solution::Instant;

use super::color::{BLUE, GREEN, VERMILION};
use super::marks::{self, HEADING};
use super::panels::{Curve, Panel, Stack, known};
use super::patch::Patch;
use super::units;

/// Forces on the rail, varying creepages, and the largest temperature rise against the distance
/// rolled.
pub(crate) fn draw(patch: &Patch) -> String {
    let history = &patch.solution.history;
    let distance: Vec<f64> = history.iter().map(|instant| instant.distance).collect();
    let total = distance.last().copied().unwrap_or(0.0);
    let unit = units::pick(units::DISTANCE, total);
    let x: Vec<f64> = distance.iter().map(|s| s / unit.size).collect();
    let mut panels = vec![forces(history, &x)];
    panels.extend(creepages(history, &x));
    panels.extend(temperature(history, &x));
    let end = if total > 0.0 && total.is_finite() { total / unit.size } else { 1.0 };
    let label = if unit.symbol == "m" { "rolled distance (m)" } else { "rolled distance (mm)" };
    let stack = Stack { x: [0.0, end], label, panels, shaded: Vec::new(), shading: "" };
    let mut drawing = stack.drawing();
    marks::heading(&mut drawing, patch, "Forces over the rolled distance");
    stack.draw(&mut drawing, HEADING + 40.0);
    drawing.finish()
}

fn points(x: &[f64], history: &[Instant], value: impl Fn(&Instant) -> f64) -> Vec<[f64; 2]> {
    x.iter().zip(history).map(|(x, instant)| [*x, value(instant)]).collect()
}

fn forces(history: &[Instant], x: &[f64]) -> Panel {
    let largest = history.iter().map(|instant| instant.force.x.hypot(instant.force.y));
    let unit = units::pick(units::FORCE, largest.filter(|f| f.is_finite()).fold(0.0, f64::max));
    let curves = vec![
        Curve::solid(
            points(x, history, |instant| -instant.force.x / unit.size),
            BLUE,
            "\u{2212}$F$_x",
        ),
        Curve::solid(
            points(x, history, |instant| -instant.force.y / unit.size),
            VERMILION,
            "\u{2212}$F$_y",
        ),
    ];
    Panel { label: format!("force on the rail ({})", unit.symbol), height: 260.0, curves }
}

/// `None` if they are constant. A shift at rest has none.
fn creepages(history: &[Instant], x: &[f64]) -> Option<Panel> {
    let at_rest = history.iter().take_while(|instant| instant.kinematics.speed == 0.0).count();
    let (history, x) = (&history[at_rest..], &x[at_rest..]);
    let first = history.first()?.kinematics;
    let changes = history.iter().any(|instant| {
        instant.kinematics.creepage_x != first.creepage_x
            || instant.kinematics.creepage_y != first.creepage_y
    });
    let curves = vec![
        Curve::solid(points(x, history, |instant| instant.kinematics.creepage_x), BLUE, "$ξ$"),
        Curve::solid(points(x, history, |instant| instant.kinematics.creepage_y), VERMILION, "$η$"),
    ];
    changes.then_some(Panel { label: "creepage".to_owned(), height: 150.0, curves })
}

/// `None` if there is no heat.
fn temperature(history: &[Instant], x: &[f64]) -> Option<Panel> {
    let hot = history.iter().any(|instant| instant.max_rise.is_some_and(|rise| rise != 0.0));
    let curves =
        vec![Curve::solid(points(x, history, |instant| known(instant.max_rise)), GREEN, "")];
    let label = "largest rise (K)".to_owned();
    hot.then_some(Panel { label, height: 180.0, curves })
}
