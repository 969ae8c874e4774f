//! Results of several methods for one case: bars side by side, and their times.

use schlupf::problem::FastMethod;
use schlupf::{Method, Status};

use super::{Answer, Comparison, Entry};
use crate::output::figures::color::{BLUE, GREEN, MUTED, VERMILION};
use crate::output::figures::frame::{LABEL_SIZE, TICK_SIZE, outline, tick_line};
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::marks::{self, HEADING, Heading, short};
use crate::output::figures::svg::{Drawing, GRID_LINE, ZERO};
use crate::output::figures::ticks::{logarithmic_ticks, round_ticks};
use crate::output::report::Report;

const NAMES: f64 = 204.0;
const COLUMN: f64 = 200.0;
const GAP: f64 = 30.0;
const ROW: f64 = 34.0;
const BAR: f64 = 18.0;
/// Spacing between a bar and its number, and between the number and the edge.
const SPACE: f64 = 6.0;
/// Space below the columns for their ticks.
const TICKS: f64 = 46.0;
/// Height of a line of the notes at the foot.
const NOTE: f64 = 20.0;

/// A quantity with a bar for every method.
struct Column {
    label: &'static str,
    value: fn(&Answer) -> Option<f64>,
    color: &'static str,
}

const COLUMNS: [Column; 4] = [
    Column {
        label: "\u{2212}$F$_x/$N$",
        value: |answer| Some(-answer.solution.force.x / answer.solution.normal.load),
        color: BLUE,
    },
    Column {
        label: "\u{2212}$F$_y/$N$",
        value: |answer| Some(-answer.solution.force.y / answer.solution.normal.load),
        color: VERMILION,
    },
    Column {
        label: "\u{2212}$M$_z (N m)",
        value: |answer| Some(-answer.solution.force.moment_z?),
        color: "#8a5aa3",
    },
    Column {
        label: "largest temp. rise (K)",
        value: |answer| Some(answer.solution.temperature?.max_rise),
        color: GREEN,
    },
];

/// Seen where not all have the same normal contact.
const PRESSURE: Column = Column {
    label: "$p$_0 (MPa)",
    value: |answer| Some(answer.solution.normal.peak_pressure / 1e6),
    color: MUTED,
};

/// Styles of the dots of the cold and the warm times.
const TIME_STYLES: [&str; 2] = [
    r##"fill="#ffffff" stroke="#4a4a4a" stroke-width="1.6""##,
    r##"fill="#4a4a4a" stroke="#4a4a4a" stroke-width="1.6""##,
];
/// Style of the line between them.
const TIME_LINE: &str = r##"stroke="#a0a0a0" stroke-width="1.6""##;
const TIME_NOTE: &str =
    "time: hollow circles with set-up (the number), full circles for the forces alone";

/// Values below this fraction of μ0 N (or of μ0 N √(ab)) are invisible.
const INVISIBLE: f64 = 1e-6;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(comparison: &Comparison) -> Option<String> {
    let first = comparison.answers().next()?;
    let columns = COLUMNS.iter().filter(|column| column.is_seen(comparison));
    let pressure = comparison.has_normal_methods().then_some(&PRESSURE);
    let columns: Vec<&Column> = columns.chain(pressure).collect();
    if columns.is_empty() {
        return None;
    }
    let rows: Vec<(&Entry, &Answer)> = comparison
        .entries
        .iter()
        .filter_map(|entry| Some((entry, entry.answer.as_ref().ok()?)))
        .collect();
    let answers: Vec<&Answer> = rows.iter().map(|(_, answer)| *answer).collect();
    let notes = notes(comparison);
    let width = NAMES + (columns.len() + 1) as f64 * (COLUMN + GAP);
    let top = HEADING + 44.0;
    let bottom = top + ROW * rows.len() as f64;
    let mut drawing = Drawing::new(width, bottom + TICKS + NOTE * notes.len() as f64 + 8.0);
    let about = format!("{}; on the rail", marks::conditions(&first.solution));
    let status = comparison.status();
    let remark = if status == Status::Converged { "" } else { "not all converged" };
    let heading = Heading::new("Methods on the same case", &comparison.title, about, status);
    Heading { remark, ..heading }.draw(&mut drawing);
    for (k, (entry, _)) in rows.iter().enumerate() {
        let style = TextStyle::new(TICK_SIZE, Anchor::End);
        drawing.plain_text([NAMES - 12.0, baseline(middle(top, k))], &style, entry.name);
    }
    let left = |k: usize| NAMES + k as f64 * (COLUMN + GAP);
    for (k, column) in columns.iter().enumerate() {
        column.draw(&mut drawing, [left(k), top], &answers);
    }
    draw_times(&mut drawing, [left(columns.len()), top], &answers);
    let style = TextStyle { color: MUTED, ..TextStyle::new(TICK_SIZE, Anchor::Start) };
    for (k, note) in notes.iter().enumerate() {
        let note = marks::shortened(note, (width - 2.0 * GAP) / TICK_SIZE);
        drawing.plain_text([24.0, bottom + TICKS + NOTE * (k as f64 + 0.6)], &style, &note);
    }
    Some(drawing.finish())
}

/// The footnotes: what is omitted and why, and the meaning of the times.
fn notes(comparison: &Comparison) -> Vec<String> {
    let missing = comparison.entries.iter().filter_map(|entry| {
        entry.reason().map(|reason| format!("{}: not available: {reason}", entry.name))
    });
    missing.chain([TIME_NOTE.to_owned()]).collect()
}

/// Centre of a row.
fn middle(top: f64, row: usize) -> f64 {
    top + ROW * (row as f64 + 0.5)
}

/// Baseline of a text centred in a row.
fn baseline(middle: f64) -> f64 {
    middle + 0.36 * TICK_SIZE
}

/// Width of a number including the space on both sides.
fn space(text: &str) -> f64 {
    /// Width of a digit, in font sizes.
    const DIGIT: f64 = 0.64;
    DIGIT * TICK_SIZE * text.chars().count() as f64 + 2.0 * SPACE
}

const NOT_GIVEN: &str = "not given";

fn text(value: f64) -> String {
    if value.is_finite() { short(value) } else { NOT_GIVEN.to_owned() }
}

/// Mapping from values to positions: zero, as distance from the left edge in the drawing, and
/// drawing units per unit.
#[derive(Clone, Copy)]
struct Scale {
    zero: f64,
    unit: f64,
}

impl Scale {
    /// The widest bars that leave space for their numbers.
    fn new(values: &[(f64, bool)]) -> Self {
        let mut sides = [vec![(0.0, 0.0)], vec![(0.0, 0.0)]];
        for &(value, counts) in values {
            let length = if counts && value.is_finite() { value.abs() } else { 0.0 };
            sides[usize::from(value < 0.0)].push((length, space(&text(value))));
        }
        let [right, left] = &sides;
        let pairs = right.iter().flat_map(|right| left.iter().map(move |left| (right, left)));
        let unit = pairs
            .filter(|(right, left)| right.0 + left.0 > 0.0)
            .map(|(right, left)| (COLUMN - right.1 - left.1) / (right.0 + left.0))
            .fold(f64::INFINITY, f64::min);
        let unit = if unit.is_finite() { unit } else { 1.0 };
        let zero = left.iter().map(|(length, space)| length * unit + space).fold(0.0, f64::max);
        Self { zero, unit }
    }

    fn at(self, value: f64) -> f64 {
        self.zero + self.unit * value
    }
}

impl Column {
    /// Magnitude of the number of an answer, 0 if it is not given.
    fn size(&self, answer: &Answer) -> f64 {
        (self.value)(answer).unwrap_or(0.0).abs()
    }

    fn is_seen(&self, comparison: &Comparison) -> bool {
        let scale = |answer: &Answer| {
            let bound = answer.solution.force.x / answer.solution.normalised.x;
            if bound.is_finite() { bound / answer.solution.normal.load } else { 1.0 }
        };
        comparison.answers().any(|answer| self.size(answer) > INVISIBLE * scale(answer))
    }

    /// All values, NaN for one that is not given, each with a flag telling whether its magnitude
    /// affects the axis. For the linear theory, which has no bound, only the sign counts if it
    /// would dwarf all others.
    fn values(&self, answers: &[&Answer]) -> Vec<(f64, bool)> {
        /// Ratio to the largest of the others.
        const DWARFING: f64 = 1.5;
        let is_bounded =
            |answer: &Answer| answer.solution.method != Method::Fast(FastMethod::KalkerLinear);
        let bounded = answers.iter().filter(|answer| is_bounded(answer));
        let largest = bounded.map(|answer| self.size(answer)).fold(0.0, f64::max);
        let value = |answer: &&Answer| {
            let value = (self.value)(answer).unwrap_or(f64::NAN);
            let is_small = largest == 0.0 || self.size(answer) < DWARFING * largest;
            (value, is_bounded(answer) || is_small)
        };
        answers.iter().map(value).collect()
    }

    fn draw(&self, drawing: &mut Drawing, [left, top]: [f64; 2], answers: &[&Answer]) {
        let values = self.values(answers);
        let scale = Scale::new(&values);
        let height = ROW * answers.len() as f64;
        let [low, high] = [0.0, COLUMN].map(|place| (place - scale.zero) / scale.unit);
        for tick in round_ticks(low, high, 3) {
            draw_tick(drawing, [left + scale.at(tick.value), top], height, &tick.label);
        }
        let zero = left + scale.zero;
        drawing.line([zero, top], [zero, top + height], ZERO);
        for (k, (value, _)) in values.into_iter().enumerate() {
            self.draw_bar(drawing, [left, middle(top, k)], value, scale);
        }
        draw_outline(drawing, [left, top], height, self.label);
    }

    /// A bar with its number beyond its end. A bar too long for that is pale, cut off at the edge
    /// of the column, and contains its number.
    fn draw_bar(&self, drawing: &mut Drawing, [left, middle]: [f64; 2], value: f64, scale: Scale) {
        let zero = left + scale.zero;
        let text = text(value);
        let style = TextStyle::new(TICK_SIZE, Anchor::Start);
        if !value.is_finite() {
            let style = TextStyle { color: MUTED, ..style };
            drawing.plain_text([zero + SPACE, baseline(middle)], &style, &text);
            return;
        }
        let end = left + scale.at(value).clamp(0.0, COLUMN);
        let edge = if value < 0.0 { left } else { left + COLUMN };
        // Rounding error must not cut the bar that sets the scale.
        let is_long = (edge - (left + scale.at(value))) * value.signum() < space(&text) - 1e-6;
        let fill =
            format!(r#"fill="{}"{}"#, self.color, if is_long { r#" opacity="0.45""# } else { "" });
        let size = [(end - zero).abs(), BAR];
        drawing.rectangle([zero.min(end), middle - 0.5 * BAR], size, &fill);
        let (place, anchor) = if is_long {
            (0.5 * (zero + edge), Anchor::Middle)
        } else if value < 0.0 {
            (end - SPACE, Anchor::End)
        } else {
            (end + SPACE, Anchor::Start)
        };
        let style = TextStyle { anchor, ..style };
        drawing.plain_text([place, baseline(middle)], &style, &text);
    }
}

/// A grid line with its tick below and its number.
fn draw_tick(drawing: &mut Drawing, [x, top]: [f64; 2], height: f64, label: &str) {
    drawing.line([x, top], [x, top + height], GRID_LINE);
    drawing.line([x, top + height], [x, top + height + 5.0], &tick_line());
    let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
    drawing.text([x, top + height + 20.0], &style, label);
}

fn draw_outline(drawing: &mut Drawing, [left, top]: [f64; 2], height: f64, label: &str) {
    drawing.rectangle([left, top], [COLUMN, height], &outline());
    let style = TextStyle::new(LABEL_SIZE, Anchor::Middle);
    drawing.text([left + 0.5 * COLUMN, top - 14.0], &style, label);
}

/// The column of times, in ms on a logarithmic axis: cold and warm. They are dots, because lengths
/// have no meaning where the axis has no zero.
fn draw_times(drawing: &mut Drawing, [left, top]: [f64; 2], answers: &[&Answer]) {
    let height = ROW * answers.len() as f64;
    let times: Vec<[f64; 2]> =
        answers.iter().map(|answer| [answer.time, answer.time_again].map(|t| 1e3 * t)).collect();
    let logarithms = || times.iter().flatten().filter(|time| is_time(**time)).map(|t| t.log10());
    // The dot of the shortest time is within the column.
    let low = logarithms().reduce(f64::min).unwrap_or(0.0).floor() - 0.3;
    let unit = times
        .iter()
        .filter_map(|time| Some((COLUMN - space(&text(time[0])) - SPACE) / (last(time)? - low)))
        .fold(COLUMN, f64::min);
    let at = |logarithm: f64| left + unit * (logarithm - low);
    for tick in logarithmic_ticks(low, low + COLUMN / unit, 5) {
        draw_tick(drawing, [at(tick.value), top], height, &tick.label);
    }
    for (k, time) in times.iter().enumerate() {
        let middle = middle(top, k);
        if time.iter().all(|time| is_time(*time)) {
            let [from, to] = time.map(|time| [at(time.log10()), middle]);
            drawing.line(from, to, TIME_LINE);
        }
        for (time, style) in time.iter().zip(TIME_STYLES).filter(|(time, _)| is_time(**time)) {
            marks::dot(drawing, [at(time.log10()), middle], style);
        }
        let end = last(time).map_or(left, |end| at(end) + SPACE);
        let style = TextStyle::new(TICK_SIZE, Anchor::Start);
        drawing.plain_text([end + SPACE, baseline(middle)], &style, &text(time[0]));
    }
    draw_outline(drawing, [left, top], height, "time (ms)");
}

/// The dot to the right, as a logarithm: no number may stand under it.
fn last(times: &[f64; 2]) -> Option<f64> {
    times.iter().filter(|time| is_time(**time)).map(|time| time.log10()).reduce(f64::max)
}

/// Whether a time can be shown on a logarithmic axis.
fn is_time(time: f64) -> bool {
    time > 0.0 && time.is_finite()
}
