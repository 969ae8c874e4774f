//! Half-space, calibrated layer and uncoupled springs side by side: forces against creepage, and
//! the traction along the centre line of the patch.

use schlupf::calibration::side_by_side::{Answer, Course, Model, SideBySide};

use crate::output::figures::color::{BLUE, GREEN, INK, VERMILION};
use crate::output::figures::frame::Frame;
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::marks::{self, Entry, HEADING, Sample, short};
use crate::output::figures::panels::{Curve, Panel, ZERO};
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
    let remark = if converged { "" } else { "not converged" };
    marks::title_block(&mut drawing, "The layer against the half-space", [title, &ratios], remark);
    for (row, (course, [name, force, traction])) in courses.into_iter().enumerate() {
        let plots = [
            Plot {
                title: format!("force under {name}"),
                axes: ["creepage over that of linear theory for $μN$".to_owned(), force.to_owned()],
                x: [0.0, course.creepage.last().copied()?],
                curves: curves(course, |answer| {
                    course.creepage.iter().copied().zip(answer.force.iter().copied()).collect()
                }),
            },
            Plot {
                title: format!("traction along $y$ = 0, {name} {}", short(course.traction_at)),
                axes: ["$x$/$a$".to_owned(), traction.to_owned()],
                x: [-1.0, 1.0],
                curves: curves(course, |answer| {
                    answer.traction.iter().map(|p| (p[0], p[1])).collect()
                }),
            },
        ];
        for (column, plot) in plots.into_iter().enumerate() {
            let corner = [
                LEFT + column as f64 * (SIZE[0] + BETWEEN[0]),
                TOP + row as f64 * (SIZE[1] + BETWEEN[1]),
            ];
            plot.draw(&mut drawing, corner);
        }
    }
    legend(&mut drawing, courses[0].0);
    Some(drawing.finish())
}

fn curves(course: &Course, points: impl Fn(&Answer) -> Vec<(f64, f64)>) -> Vec<Curve> {
    let curve = |answer: &Answer| Curve {
        points: points(answer).into_iter().map(|(x, y)| [x, y]).collect(),
        stroke: stroke(answer.model),
        text: String::new(),
    };
    course.answers.iter().map(curve).collect()
}

/// The half-space is drawn first, with a wide line, so that lines on top of it remain visible.
fn stroke(model: Model) -> String {
    let (color, width, dashes) = match model {
        Model::HalfSpace => ("#b8b8b8", 5.0, ""),
        Model::Layer => (BLUE, 1.8, ""),
        Model::KalkerBed => (VERMILION, 1.8, r#" stroke-dasharray="7 4""#),
        Model::Fastsim => (GREEN, 1.8, r#" stroke-dasharray="2 3""#),
    };
    format!(r#"stroke="{color}" stroke-width="{width}" stroke-linejoin="round"{dashes}"#)
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
    let entry = |answer: &Answer| Entry {
        sample: Sample::Line(vec![stroke(answer.model)]),
        text: name(answer.model).to_owned(),
    };
    let entries: Vec<Entry> = course.answers.iter().map(entry).collect();
    let width = 2.0 * SIZE[0] + BETWEEN[0];
    marks::legend(drawing, [LEFT, TOP - 36.0], width, &entries);
}

/// Curves with their own axes.
struct Plot {
    title: String,
    axes: [String; 2],
    x: [f64; 2],
    curves: Vec<Curve>,
}

impl Plot {
    fn draw(self, drawing: &mut Drawing, corner: [f64; 2]) {
        let panel = Panel { label: String::new(), height: SIZE[1], curves: self.curves };
        let frame = Frame { corner, size: SIZE, x: self.x, y: panel.range() };
        frame.draw_grid(drawing);
        let zero = frame.at([self.x[0], 0.0])[1];
        drawing.line([corner[0], zero], [frame.right(), zero], ZERO);
        panel.draw_curves(drawing, &frame);
        frame.draw_vertical(drawing, &self.axes[1]);
        frame.draw_horizontal(drawing, &self.axes[0]);
        let style = TextStyle { color: INK, ..TextStyle::new(TITLE_SIZE, Anchor::Start) };
        drawing.text([corner[0], corner[1] - 10.0], &style, &self.title);
    }
}
