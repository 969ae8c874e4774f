//! Values over two axes as colours with labelled contours.

use super::color::ColorScale;
use super::frame::{Frame, TICK_SIZE};
use super::label::{self, Anchor, TextStyle};
use super::lattice::Lattice;
use super::marks::{self, HEADING, Heading, Shape};
use super::panels::{LEFT, WIDTH};
use super::svg::{Drawing, open_path};
use super::ticks::Tick;

/// Shades between two contours.
const SHADES: f64 = 4.0;

const CONTOUR: [&str; 2] = [
    r##"fill="none" stroke="#ffffff" stroke-opacity="0.55" stroke-width="3""##,
    r##"fill="none" stroke="#222222" stroke-width="1.2" stroke-linejoin="round""##,
];

/// A figure of values over two axes.
#[derive(Debug)]
pub(crate) struct Relief<'a> {
    /// The values.
    pub lattice: &'a Lattice,
    /// Their colours.
    pub scale: ColorScale,
    /// Contours.
    pub levels: Vec<Tick>,
    /// Labels of x, of y and of the colours.
    pub labels: [&'a str; 3],
    /// Height of the plot area.
    pub height: f64,
    /// Crosses, where something is largest.
    pub crosses: Vec<[f64; 2]>,
}

/// Space to the right of the plot area, for the colour bar.
const BAR: f64 = 150.0;

/// Width of the plot area.
pub(crate) const PLOT: f64 = WIDTH - LEFT - BAR;

/// White on dark, so that a cross is seen on the colours and beyond the frame.
const CROSS: [&str; 2] = [
    r##"stroke="#222222" stroke-width="4.4" stroke-linecap="round""##,
    r##"stroke="#ffffff" stroke-width="2.2" stroke-linecap="round""##,
];

impl Relief<'_> {
    /// The figure; `None` where an axis has no range.
    pub(crate) fn page(&self, heading: &Heading) -> Option<String> {
        let [x, y] = [ends(&self.lattice.x)?, ends(&self.lattice.y)?];
        let corner = [LEFT, HEADING + 28.0];
        let frame = Frame { corner, size: [PLOT, self.height], x, y, powers: false };
        let mut drawing = Drawing::new(WIDTH, frame.bottom() + 66.0);
        heading.draw(&mut drawing);
        if heading.is_rolling {
            marks::rolling_direction(&mut drawing, [WIDTH - 116.0, HEADING + 8.0]);
        }
        let lattice = self.lattice.refined();
        drawing.begin_clip(&frame.area());
        fill(&mut drawing, &frame, &lattice, (&self.scale, &self.levels));
        lines(&mut drawing, &frame, &lattice, &self.levels);
        drawing.end_group();
        let [along, upwards, label] = self.labels;
        frame.draw_vertical(&mut drawing, upwards);
        frame.draw_horizontal(&mut drawing, along);
        let is_inside = |[at, up]: [f64; 2]| x[0] <= at && at <= x[1] && y[0] <= up && up <= y[1];
        for at in self.crosses.iter().filter(|at| is_inside(**at)) {
            for style in CROSS {
                Shape::Cross.draw(&mut drawing, frame.at(*at), style);
            }
        }
        let bar = [frame.right() + 30.0, corner[1] + 28.0];
        marks::color_bar(&mut drawing, bar, self.height - 28.0, &self.scale, label);
        Some(drawing.finish())
    }
}

/// The range of an axis; `None` if it has none.
pub(crate) fn ends(values: &[f64]) -> Option<[f64; 2]> {
    let ends = [*values.first()?, *values.last()?];
    (ends[1] > ends[0] && ends.iter().all(|end| end.is_finite())).then_some(ends)
}

/// The colours, each over what lies below its upper limit.
fn fill(
    drawing: &mut Drawing,
    frame: &Frame,
    lattice: &Lattice,
    (scale, levels): (&ColorScale, &[Tick]),
) {
    let step = levels.windows(2).map(|pair| pair[1].value - pair[0].value).next();
    // Of a logarithmic scale ten for each decade, so that 2 and 5 are limits, too.
    let shade = step.filter(|_| !scale.powers).unwrap_or(scale.high - scale.low) / SHADES;
    let shade = if scale.powers { 0.1 } else { shade };
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
    let lines = apart(lines);
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

/// The lines without the parts that lie so close to one of another level that they would run
/// together, as near zero creepage, and without what is left of them in crumbs.
fn apart(lines: Vec<Line>) -> Vec<Line> {
    const CLOSE: f64 = 4.5;
    const CRUMB: f64 = 24.0;
    let mut kept: Vec<Line> = Vec::new();
    for line in lines {
        let is_free = |point: &[f64; 2]| {
            let mut others = kept.iter().filter(|other| other.level != line.level);
            !others.any(|other| other.points.iter().any(|at| distance(*at, *point) < CLOSE))
        };
        let parts = line.points.split(|point| !is_free(point));
        let length = |part: &[[f64; 2]]| -> f64 {
            part.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
        };
        let whole = parts.clone().nth(1).is_none();
        let parts = parts.filter(|part| whole || length(part) > CRUMB);
        let parts: Vec<Line> =
            parts.map(|part| Line { points: part.to_vec(), level: line.level }).collect();
        kept.extend(parts);
    }
    kept
}

fn distance(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
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

#[cfg(test)]
mod tests {
    use super::*;

    fn upright(x: f64, level: usize) -> Line {
        Line { points: (0..100).map(|k| [x, f64::from(k)]).collect(), level }
    }

    /// Near zero creepage all levels lie within a few units of the drawing.
    #[test]
    fn contours_that_would_run_together_are_left_out() {
        let lines = [0.0, 2.0, 4.0, 6.0, 8.0, 60.0].into_iter().enumerate();
        let kept = apart(lines.map(|(level, x)| upright(x, level)).collect());
        let levels: Vec<usize> = kept.iter().map(|line| line.level).collect();
        assert_eq!(levels, [0, 3, 5]);
        // One that approaches another ends before it.
        let slanting = Line { points: (0..100).map(|k| [f64::from(k), 50.0]).collect(), level: 1 };
        let kept = apart(vec![upright(0.0, 0), slanting]);
        assert_eq!((kept.len(), kept[1].points[0]), (2, [5.0, 50.0]));
    }
}
