//! Values over two axes as colours with labelled contours.

use super::color::ColorScale;
use super::frame::{Frame, TICK_SIZE};
use super::label::{self, Anchor, TextStyle};
use super::lattice::Lattice;
use super::svg::{Drawing, open_path};
use super::ticks::Tick;

/// Shades between two contours.
const SHADES: f64 = 4.0;

const CONTOUR: [&str; 2] = [
    r##"fill="none" stroke="#ffffff" stroke-opacity="0.55" stroke-width="3""##,
    r##"fill="none" stroke="#222222" stroke-width="1.2" stroke-linejoin="round""##,
];

/// The colours, and contours at the levels, within the frame.
pub(crate) fn draw(
    drawing: &mut Drawing,
    frame: &Frame,
    lattice: &Lattice,
    (scale, levels): (&ColorScale, &[Tick]),
) {
    drawing.begin_clip(&frame.area());
    fill(drawing, frame, lattice, (scale, levels));
    lines(drawing, frame, lattice, levels);
    drawing.end_group();
}

/// The colours, each over what lies below its upper limit.
fn fill(
    drawing: &mut Drawing,
    frame: &Frame,
    lattice: &Lattice,
    (scale, levels): (&ColorScale, &[Tick]),
) {
    let step = levels.windows(2).map(|pair| pair[1].value - pair[0].value).next();
    let shade = step.unwrap_or(scale.high - scale.low) / SHADES;
    let first = levels.first().map_or(scale.low, |tick| tick.value);
    // Limits of shades lie on contours.
    let lowest = ((scale.low - first) / shade).floor() as i64;
    let highest = ((scale.high - first) / shade).ceil() as i64;
    drawing.begin_group(r#"shape-rendering="crispEdges""#);
    for number in (lowest..=highest).rev() {
        let [below, above] = [number, number + 1].map(|number| first + number as f64 * shade);
        let color = scale.paint(0.5 * (below + above));
        let path = lattice.below(above).iter().fold(String::new(), |path, polygon| {
            let points: Vec<[f64; 2]> = polygon.iter().map(|at| frame.at(*at)).collect();
            path + &open_path(&points) + "z"
        });
        drawing.path(&path, &format!(r#"fill="{color}""#));
    }
    drawing.end_group();
}

/// A contour in units of the drawing.
struct Line {
    points: Vec<[f64; 2]>,
    level: usize,
}

/// The contours and their labels.
fn lines(drawing: &mut Drawing, frame: &Frame, lattice: &Lattice, levels: &[Tick]) {
    let mut lines = Vec::new();
    for (level, tick) in levels.iter().enumerate() {
        for chain in lattice.contour(tick.value) {
            let first = chain.points.first().copied().filter(|_| chain.is_closed);
            let points = chain.points.iter().copied().chain(first);
            lines.push(Line { points: points.map(|at| frame.at(at)).collect(), level });
        }
    }
    for stroke in CONTOUR {
        for line in &lines {
            drawing.path(&open_path(&line.points), stroke);
        }
    }
    let mut labels: Vec<[f64; 2]> = Vec::new();
    for line in &lines {
        if let Some((at, angle)) = label_place(line, &lines, &labels, frame) {
            draw_label(drawing, at, angle, &levels[line.level].label);
            labels.push(at);
        }
    }
}

/// Where on a line its label has most space, and the slope of the line there; `None` where there is
/// too little.
fn label_place(
    line: &Line,
    lines: &[Line],
    labels: &[[f64; 2]],
    frame: &Frame,
) -> Option<([f64; 2], f64)> {
    /// Distances from other contours, from labels and from the frame; half the length of a label.
    const FROM_LINES: f64 = 11.0;
    const FROM_LABELS: f64 = 60.0;
    const FROM_FRAME: f64 = 24.0;
    const HALF: f64 = 20.0;
    let distance = |one: [f64; 2], other: [f64; 2]| (one[0] - other[0]).hypot(one[1] - other[1]);
    let nearest = |at: [f64; 2], points: &mut dyn Iterator<Item = [f64; 2]>| {
        points.map(|point| distance(at, point)).fold(f64::INFINITY, f64::min)
    };
    let others: Vec<[f64; 2]> = lines
        .iter()
        .filter(|other| other.level != line.level)
        .flat_map(|other| other.points.iter().copied())
        .collect();
    let place = |k: usize| {
        let at = line.points[k];
        let before = (0..k).rev().map(|k| line.points[k]).find(|p| distance(at, *p) >= HALF)?;
        let after = line.points[k + 1..].iter().copied().find(|p| distance(at, *p) >= HALF)?;
        let is_inside = [0, 1].iter().all(|axis| {
            let along = at[*axis] - frame.corner[*axis];
            along > FROM_FRAME && along < frame.size[*axis] - FROM_FRAME
        });
        let space = nearest(at, &mut others.iter().copied()) - FROM_LINES;
        let from_labels = nearest(at, &mut labels.iter().copied()) - FROM_LABELS;
        if !is_inside || space < 0.0 || from_labels < 0.0 {
            return None;
        }
        let [dx, dy] = [after[0] - before[0], after[1] - before[1]];
        // Straight lines are easier to read; the text never stands on its head.
        let straight = distance(before, after) / (2.0 * HALF);
        let angle = if dx == 0.0 { 90.0 } else { (dy / dx).atan().to_degrees() };
        Some((space.min(40.0) * straight + 0.02 * from_labels.min(200.0), at, angle))
    };
    let places = (0..line.points.len()).step_by(2).filter_map(place);
    let best = places.max_by(|one, other| one.0.total_cmp(&other.0))?;
    Some((best.1, best.2))
}

fn draw_label(drawing: &mut Drawing, [x, y]: [f64; 2], angle: f64, text: &str) {
    // Centred on the line: the text turns about its own middle.
    let shift = 0.36 * TICK_SIZE;
    let (sin, cos) = angle.to_radians().sin_cos();
    let at = [x - shift * sin, y + shift * cos];
    let style = TextStyle { rotation: angle, ..TextStyle::new(TICK_SIZE, Anchor::Middle) };
    let inner = label::escape(text);
    let element = label::element(at, &style, &inner);
    let halo = r##"stroke="#ffffff" stroke-width="7" stroke-linejoin="round""##;
    drawing.begin_group(halo);
    drawing.shape(&element);
    drawing.end_group();
    drawing.shape(&element);
}
