//! Elements shared by several figures: heading, colour bar, arrows, legend.

use schlupf::bodies::{ReferencePoint, ReferenceSpeed};
use schlupf::{Solution, Status};

use super::color::{ColorScale, INK, LEVELS, MUTED, paint};
use super::frame::{LABEL_SIZE, TICK_SIZE, outline, tick_line};
use super::label::{self, Anchor, TextStyle};
use super::patch::Patch;
use super::svg::{Drawing, open_path};
use crate::output::number::significant;

/// Height of the heading.
pub(crate) const HEADING: f64 = 84.0;
/// Left end of the heading.
const MARGIN: f64 = 24.0;

/// What stands above a figure.
#[derive(Debug)]
pub(crate) struct Heading<'a> {
    /// Title of the figure, in the markup of labels.
    pub title: &'a str,
    /// Title of the case, as given.
    pub case: &'a str,
    /// Its conditions, in the markup of labels.
    pub about: String,
    /// A remark in red.
    pub remark: &'static str,
    /// Whether an arrow says where the wheel rolls.
    pub is_rolling: bool,
}

impl<'a> Heading<'a> {
    /// A heading that says whether the results converged.
    pub(crate) fn new(title: &'a str, case: &'a str, about: String, status: Status) -> Self {
        let remark = if status == Status::NotConverged { "not converged" } else { "" };
        Self { title, case, about, remark, is_rolling: false }
    }

    /// The case of a patch with its kinematics; a patch at rest rolls nowhere.
    pub(crate) fn of(patch: &Patch<'a>, title: &'a str) -> Self {
        let is_rolling = patch.is_rolling();
        let status = patch.solution.status;
        Self { is_rolling, ..Self::new(title, patch.title, conditions(patch.solution), status) }
    }

    /// Draws it at the upper left.
    pub(crate) fn draw(&self, drawing: &mut Drawing) {
        drawing.text([MARGIN, 32.0], &TextStyle::new(19.0, Anchor::Start), self.title);
        let small = TextStyle { color: MUTED, ..TextStyle::new(13.0, Anchor::Start) };
        let space = (drawing.width - 2.0 * MARGIN) / small.size;
        drawing.plain_text([MARGIN, 54.0], &small, &shortened(self.case, space));
        drawing.text([MARGIN, 74.0], &small, &self.about);
        if !self.remark.is_empty() {
            let style = TextStyle { color: ALARM, ..TextStyle::new(15.0, Anchor::End) };
            drawing.text([drawing.width - MARGIN, 32.0], &style, self.remark);
        }
    }
}

/// Colour for results that did not converge.
pub(crate) const ALARM: &str = "#b40426";

/// A text truncated to a width in font sizes.
pub(crate) fn shortened(text: &str, space: f64) -> String {
    if label::width(text) <= space {
        return text.to_owned();
    }
    let kept = (space / 0.6) as usize;
    text.chars().take(kept.saturating_sub(1)).chain(['…']).collect()
}

/// The motion and the load of a solution, in the markup of labels.
pub(crate) fn conditions(solution: &Solution) -> String {
    let load = format!("$N$ = {} kN", short(solution.normal.load / 1e3));
    let kinematics = &solution.kinematics;
    if kinematics.speed == 0.0 {
        return format!("at rest, {load}");
    }
    let mut parts = vec![format!("$ξ$ = {}", short(kinematics.creepage_x))];
    if kinematics.creepage_y != 0.0 {
        parts.push(format!("$η$ = {}", short(kinematics.creepage_y)));
    }
    if kinematics.spin != 0.0 {
        parts.push(format!("$φ$ = {} 1/m", short(kinematics.spin)));
    }
    if solution.reference == ReferencePoint::File {
        parts.push("at the origin of the file".to_owned());
    }
    let symbol = match kinematics.reference_speed {
        ReferenceSpeed::Vehicle => "$v$_0",
        ReferenceSpeed::Mean => "$V$",
    };
    parts.extend([format!("{symbol} = {} m/s", short(kinematics.speed)), load]);
    parts.join(", ")
}

/// A number with a true minus sign.
pub(crate) fn short(value: f64) -> String {
    significant(value).replace('-', "\u{2212}")
}

/// A vertical colour bar from its upper left corner, with ticks and a label on top.
pub(crate) fn color_bar(
    drawing: &mut Drawing,
    corner: [f64; 2],
    height: f64,
    scale: &ColorScale,
    label: &str,
) {
    const WIDTH: f64 = 18.0;
    let [left, top] = corner;
    let step = height / LEVELS as f64;
    drawing.begin_group(r#"shape-rendering="crispEdges""#);
    for level in 0..LEVELS {
        let y = top + height - (level + 1) as f64 * step;
        let fill = format!(r#"fill="{}""#, paint(scale.palette, level));
        // Slightly taller than a level, so that no gap shows between two of them.
        drawing.rectangle([left, y], [WIDTH, step + 0.5], &fill);
    }
    drawing.end_group();
    drawing.rectangle(corner, [WIDTH, height], &outline());
    let right = left + WIDTH;
    for tick in scale.ticks(((height / 55.0) as usize).clamp(3, 8)) {
        let y = top + height * (1.0 - (tick.value - scale.low) / (scale.high - scale.low));
        drawing.line([right, y], [right + 5.0, y], &tick_line());
        let style = TextStyle::new(TICK_SIZE, Anchor::Start);
        drawing.text([right + 9.0, y + 0.36 * TICK_SIZE], &style, &tick.label);
    }
    drawing.text([left, top - 12.0], &TextStyle::new(LABEL_SIZE, Anchor::Start), label);
}

/// The outline of an arrow as path data; `width` is that of its head. Empty for zero length.
pub(crate) fn arrow(from: [f64; 2], to: [f64; 2], width: f64) -> String {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    if length.is_nan() || length < 1e-6 {
        return String::new();
    }
    let along = [dx / length, dy / length];
    let point = |distance: f64, aside: f64| {
        [
            from[0] + along[0] * distance - along[1] * aside,
            from[1] + along[1] * distance + along[0] * aside,
        ]
    };
    // A short arrow is scaled down, not squeezed.
    let head = (1.4 * width).min(0.6 * length);
    let half_head = head / 2.8;
    let half_shaft = 0.3 * half_head;
    let neck = length - head;
    let outline = [
        point(0.0, half_shaft),
        point(neck, half_shaft),
        point(neck, half_head),
        point(length, 0.0),
        point(neck, -half_head),
        point(neck, -half_shaft),
        point(0.0, -half_shaft),
    ];
    open_path(&outline) + "z"
}

/// The rolling direction: an arrow to the right with its name before it, centred on a point.
pub(crate) fn rolling_direction(drawing: &mut Drawing, center: [f64; 2]) {
    let [x, y] = center;
    let style = TextStyle::new(TICK_SIZE, Anchor::End);
    drawing.text([x + 28.0, y + 0.36 * TICK_SIZE], &style, "rolling direction");
    let path = arrow([x + 36.0, y], [x + 86.0, y], 9.0);
    drawing.path(&path, &format!(r#"fill="{INK}""#));
}

/// A dot at a point.
pub(crate) fn dot(drawing: &mut Drawing, [x, y]: [f64; 2], style: &str) {
    drawing.shape(&format!(r#"<circle cx="{x:.2}" cy="{y:.2}" r="4" {style}/>"#));
}

/// Shape of a mark at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A disc.
    Dot,
    /// A square.
    #[cfg(feature = "fitting")]
    Square,
    /// A diagonal cross.
    Cross,
}

impl Shape {
    /// Draws it about a point; `style` holds SVG attributes.
    pub(crate) fn draw(self, drawing: &mut Drawing, [x, y]: [f64; 2], style: &str) {
        const ARM: f64 = 4.5;
        match self {
            Self::Dot => dot(drawing, [x, y], style),
            #[cfg(feature = "fitting")]
            Self::Square => drawing.rectangle([x - 3.7, y - 3.7], [7.4; 2], style),
            Self::Cross => {
                drawing.line([x - ARM, y - ARM], [x + ARM, y + ARM], style);
                drawing.line([x - ARM, y + ARM], [x + ARM, y - ARM], style);
            }
        }
    }
}

/// An entry of a legend: sample strokes (SVG attributes, drawn on top of each other) and text.
#[derive(Debug, Clone)]
pub(crate) struct Entry {
    /// The sample.
    pub sample: Sample,
    /// Its meaning.
    pub text: String,
}

impl Entry {
    /// A line.
    pub(crate) fn line(stroke: &str, text: &str) -> Self {
        Self { sample: Sample::Line(vec![stroke.to_owned()]), text: text.to_owned() }
    }

    /// A mark.
    pub(crate) fn mark(shape: Shape, style: String, text: &str) -> Self {
        Self { sample: Sample::Mark(shape, style), text: text.to_owned() }
    }
}

/// A sample in a legend.
#[derive(Debug, Clone)]
pub(crate) enum Sample {
    /// A line drawn with each of the strokes.
    Line(Vec<String>),
    /// A filled field.
    Area(String),
    /// An arrow.
    Arrow(String),
    /// A mark.
    Mark(Shape, String),
}

/// A legend above a plot area whose upper left corner is given; further rows grow upwards, by
/// [`further_rows`].
pub(crate) fn legend_above(
    drawing: &mut Drawing,
    [left, top]: [f64; 2],
    width: f64,
    entries: &[Entry],
) {
    legend(drawing, [left, top - 9.0 - further_rows(width, entries)], width, entries);
}

/// Height of a legend of a given width beyond its first row.
pub(crate) fn further_rows(width: f64, entries: &[Entry]) -> f64 {
    legend(&mut Drawing::new(width, 1.0), [0.0; 2], width, entries) - LEGEND_ROW
}

/// Height of a row of a legend.
const LEGEND_ROW: f64 = 22.0;

/// Entries in a row from the left end of its baseline, in several rows if they do not fit; returns
/// the height used.
pub(crate) fn legend(drawing: &mut Drawing, at: [f64; 2], width: f64, entries: &[Entry]) -> f64 {
    const SAMPLE: f64 = 30.0;
    let [left, top] = at;
    let [mut x, mut y] = at;
    for entry in entries {
        let is_mark = matches!(entry.sample, Sample::Mark(..));
        let sample = if is_mark { 0.5 * SAMPLE } else { SAMPLE };
        let entry_width = sample + 8.0 + label::width(&entry.text) * TICK_SIZE + 18.0;
        if x > left && x + entry_width > left + width {
            [x, y] = [left, y + LEGEND_ROW];
        }
        let middle = y - 0.36 * TICK_SIZE;
        match &entry.sample {
            Sample::Line(strokes) => {
                for stroke in strokes {
                    drawing.line([x, middle], [x + SAMPLE, middle], stroke);
                }
            }
            Sample::Area(style) => drawing.rectangle([x, middle - 6.0], [SAMPLE, 12.0], style),
            Sample::Arrow(style) => {
                drawing.path(&arrow([x, middle], [x + SAMPLE, middle], 9.0), style);
            }
            Sample::Mark(shape, style) => shape.draw(drawing, [x + 0.5 * sample, middle], style),
        }
        drawing.text([x + sample + 8.0, y], &TextStyle::new(TICK_SIZE, Anchor::Start), &entry.text);
        x += entry_width;
    }
    y - top + LEGEND_ROW
}
