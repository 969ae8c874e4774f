//! Half-space, calibrated layer and uncoupled springs side by side: forces against creepage, and
//! the traction along the centre line of the patch.

use schlupf::Status;
use schlupf::analysis::calibration::side_by_side::{Answer, Course, Model, SideBySide};

use crate::output::figures::color::{BLUE, GREEN, INK, VERMILION};
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::marks::{self, Entry, HEADING, Heading, short};
use crate::output::figures::panels::{self, Curve, Panel, Stack};
use crate::output::figures::svg::Drawing;

const LEFT: f64 = 84.0;
const RIGHT: f64 = 24.0;
const SIZE: [f64; 2] = [372.0, 270.0];
/// Gaps between plot areas.
const BETWEEN: [f64; 2] = [84.0, 92.0];
const TOP: f64 = HEADING + 64.0;
const TITLE_SIZE: f64 = 15.0;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(title: &str, sides: &SideBySide) -> Option<String> {
    let courses = [
        (
            &sides.longitudinal,
            ["longitudinal creepage", "\u{2212}$F$_x/$μN$", "\u{2212}$t$_x/($μp$_0)"],
        ),
        (&sides.spin, ["spin", "\u{2212}$F$_y/$μN$", "\u{2212}$t$_y/($μp$_0)"]),
    ];
    let first = courses[0].0.answers.first()?;
    if first.force.len() < 2 || first.traction.len() < 2 {
        return None;
    }
    let width = LEFT + 2.0 * SIZE[0] + BETWEEN[0] + RIGHT;
    let height = TOP + 2.0 * SIZE[1] + BETWEEN[1] + 64.0;
    let mut drawing = Drawing::new(width, height);
    let converged = courses.iter().flat_map(|(course, _)| &course.answers).all(|a| a.converged);
    let ratios = format!(
        "$a$/$b$ = {}, $ν$ = {}; forces and tractions on the rail",
        short(sides.axis_ratio),
        short(sides.poisson_ratio)
    );
    let status = if converged { Status::Converged } else { Status::NotConverged };
    Heading::new("The layer against the half-space", title, ratios, status).draw(&mut drawing);
    for (row, (course, [name, force, traction])) in courses.into_iter().enumerate() {
        let of_force = curves(course, |answer| {
            course.creepage.iter().zip(&answer.force).map(|(x, y)| [*x, *y]).collect()
        });
        let of_traction = curves(course, |answer| answer.traction.clone());
        let plots = [
            (
                format!("force under {name}"),
                Stack::over(
                    [0.0, course.creepage.last().copied()?],
                    "creepage over that of linear theory for $μN$",
                    vec![Panel::new(force, SIZE[1], of_force)],
                ),
            ),
            (
                format!("traction along $y$ = 0, {name} {}", short(course.traction_at)),
                Stack::over(
                    [-1.0, 1.0],
                    "$x$/$a$",
                    vec![Panel::new(traction, SIZE[1], of_traction)],
                ),
            ),
        ];
        for (column, (title, stack)) in plots.into_iter().enumerate() {
            let corner = [
                LEFT + column as f64 * (SIZE[0] + BETWEEN[0]),
                TOP + row as f64 * (SIZE[1] + BETWEEN[1]),
            ];
            stack.draw(&mut drawing, corner, SIZE[0]);
            let style = TextStyle { color: INK, ..TextStyle::new(TITLE_SIZE, Anchor::Start) };
            drawing.text([corner[0], corner[1] - 10.0], &style, &title);
        }
    }
    legend(&mut drawing, courses[0].0);
    Some(drawing.finish())
}

fn curves(course: &Course, points: impl Fn(&Answer) -> Vec<[f64; 2]>) -> Vec<Curve> {
    let curve = |answer: &Answer| Curve::new(points(answer), stroke(answer.model), "");
    course.answers.iter().map(curve).collect()
}

/// The half-space is drawn first, with a wide line, so that lines on top of it remain visible.
fn stroke(model: Model) -> String {
    let (color, width, dashes) = match model {
        Model::HalfSpace => ("#b8b8b8", 5.0, ""),
        Model::Layer => (BLUE, 1.8, ""),
        Model::KalkerBed => (VERMILION, 1.8, "7 4"),
        Model::Fastsim => (GREEN, 1.8, "2 3"),
    };
    panels::stroke(color, width, dashes)
}

fn name(model: Model) -> &'static str {
    match model {
        Model::HalfSpace => "half-space",
        Model::Layer => "calibrated layer",
        Model::KalkerBed => "Winkler, Kalker's bed",
        Model::Fastsim => "FASTSIM",
    }
}

fn legend(drawing: &mut Drawing, course: &Course) {
    let entry = |answer: &Answer| Entry::line(&stroke(answer.model), name(answer.model));
    let entries: Vec<Entry> = course.answers.iter().map(entry).collect();
    let width = 2.0 * SIZE[0] + BETWEEN[0];
    marks::legend(drawing, [LEFT, TOP - 36.0], width, &entries);
}
