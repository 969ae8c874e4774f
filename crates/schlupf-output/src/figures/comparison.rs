//! What several methods make of one case: bars side by side.

use schlupf::Method;

use super::frame::{LABEL_SIZE, TICK_SIZE, outline, tick_line};
use super::label::{Anchor, TextStyle};
use super::marks::{self, HEADING, short};
use super::panels::{BLUE, GREEN, VERMILION, ZERO};
use super::svg::{Drawing, GRID_LINE, MUTED};
use super::ticks::round_ticks;
use crate::comparison::{Comparison, Entry};

const NAMES: f64 = 190.0;
const COLUMN: f64 = 200.0;
const GAP: f64 = 22.0;
const ROW: f64 = 34.0;
const BAR: f64 = 18.0;
/// What a number beside a bar takes.
const LABEL_ROOM: f64 = 64.0;

/// A quantity with a bar for every method.
struct Column {
    label: &'static str,
    value: fn(&Entry) -> f64,
    color: &'static str,
}

const COLUMNS: [Column; 4] = [
    Column {
        label: "\u{2212}$F$_x/$N$",
        value: |entry| -entry.solution.force.x / entry.solution.normal.load,
        color: BLUE,
    },
    Column {
        label: "\u{2212}$F$_y/$N$",
        value: |entry| -entry.solution.force.y / entry.solution.normal.load,
        color: VERMILION,
    },
    Column {
        label: "\u{2212}$M$_z (N m)",
        value: |entry| -entry.solution.force.moment_z,
        color: "#8a5aa3",
    },
    Column {
        label: "largest temp. rise (K)",
        value: |entry| entry.solution.temperature.max_rise,
        color: GREEN,
    },
];

/// Below this part of μ0 N (or of μ0 N √(ab)) there is nothing to see.
const INVISIBLE: f64 = 1e-6;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(comparison: &Comparison) -> Option<String> {
    let first = comparison.entries.first()?;
    let columns: Vec<&Column> =
        COLUMNS.iter().filter(|column| column.is_seen(comparison)).collect();
    if columns.is_empty() {
        return None;
    }
    let width = (NAMES + columns.len() as f64 * (COLUMN + GAP) + GAP).max(640.0);
    let top = HEADING + 44.0;
    let height = top + ROW * comparison.entries.len() as f64 + 46.0;
    let mut drawing = Drawing::new(width, height);
    let remark = if comparison.is_converged() { "" } else { "not all converged" };
    let lines = [comparison.title.as_str(), &conditions(first)];
    marks::title_block(&mut drawing, "Methods on the same case", lines, remark);
    for (k, entry) in comparison.entries.iter().enumerate() {
        let y = top + ROW * (k as f64 + 0.5) + 0.36 * TICK_SIZE;
        let style = TextStyle::new(TICK_SIZE, Anchor::End);
        drawing.plain_text([NAMES - 12.0, y], &style, entry.name);
    }
    for (k, column) in columns.into_iter().enumerate() {
        column.draw(&mut drawing, [NAMES + k as f64 * (COLUMN + GAP), top], comparison);
    }
    Some(drawing.finish())
}

fn conditions(entry: &Entry) -> String {
    let motion = &entry.solution.kinematics;
    let mut parts = vec![format!("$ξ$ = {}", short(motion.creepage_x))];
    if motion.creepage_y != 0.0 {
        parts.push(format!("$η$ = {}", short(motion.creepage_y)));
    }
    if motion.spin != 0.0 {
        parts.push(format!("$φ$ = {} 1/m", short(motion.spin)));
    }
    parts.push(format!("$v$_0 = {} m/s", short(motion.speed)));
    parts.push(format!("$N$ = {} kN; on the rail", short(entry.solution.normal.load / 1e3)));
    parts.join(", ")
}

impl Column {
    fn is_seen(&self, comparison: &Comparison) -> bool {
        let scale = |entry: &Entry| {
            let bound = entry.solution.force.x / entry.solution.normalised.x;
            if bound.is_finite() { bound / entry.solution.normal.load } else { 1.0 }
        };
        comparison.entries.iter().any(|entry| (self.value)(entry).abs() > INVISIBLE * scale(entry))
    }

    /// The range of the axis. Of the linear theory, which knows no bound, only the direction counts, lest it
    /// dwarf all others.
    fn range(&self, comparison: &Comparison) -> [f64; 2] {
        let bounded = |entry: &&Entry| entry.solution.method != Method::KalkerLinear;
        let values = || {
            let entries = comparison.entries.iter().filter(bounded);
            entries.map(self.value).filter(|value| value.is_finite())
        };
        let [low, high] = [values().fold(0.0, f64::min), values().fold(0.0, f64::max)];
        let room = 0.42 * (high - low).max(f64::MIN_POSITIVE);
        [if low < 0.0 { low - room } else { low }, if high > 0.0 { high + room } else { high }]
    }

    fn draw(&self, drawing: &mut Drawing, [left, top]: [f64; 2], comparison: &Comparison) {
        let [low, high] = self.range(comparison);
        let height = ROW * comparison.entries.len() as f64;
        let at = |value: f64| left + COLUMN * (value - low) / (high - low);
        for tick in round_ticks(low, high, 3) {
            let x = at(tick.value);
            drawing.line([x, top], [x, top + height], GRID_LINE);
            drawing.line([x, top + height], [x, top + height + 5.0], &tick_line());
            let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
            drawing.text([x, top + height + 20.0], &style, &tick.label);
        }
        drawing.line([at(0.0), top], [at(0.0), top + height], ZERO);
        for (k, entry) in comparison.entries.iter().enumerate() {
            let middle = top + ROW * (k as f64 + 0.5);
            self.draw_bar(drawing, middle, (self.value)(entry), [left, at(0.0)], &at);
        }
        drawing.rectangle([left, top], [COLUMN, height], &outline());
        let style = TextStyle::new(LABEL_SIZE, Anchor::Middle);
        drawing.text([left + 0.5 * COLUMN, top - 14.0], &style, self.label);
    }

    /// A bar with its number, cut off at the edge of the column.
    fn draw_bar(
        &self,
        drawing: &mut Drawing,
        middle: f64,
        value: f64,
        [left, zero]: [f64; 2],
        at: &impl Fn(f64) -> f64,
    ) {
        let baseline = middle + 0.36 * TICK_SIZE;
        if !value.is_finite() {
            let style = TextStyle { color: MUTED, ..TextStyle::new(TICK_SIZE, Anchor::Start) };
            drawing.plain_text([zero + 6.0, baseline], &style, "not given");
            return;
        }
        let end = at(value).clamp(left, left + COLUMN);
        let is_cut = end != at(value);
        let fill =
            format!(r#"fill="{}"{}"#, self.color, if is_cut { r#" opacity="0.45""# } else { "" });
        let size = [(end - zero).abs(), BAR];
        drawing.rectangle([zero.min(end), middle - 0.5 * BAR], size, &fill);
        let text = short(value);
        if is_cut {
            let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
            drawing.plain_text([0.5 * (zero + end), baseline], &style, &text);
        } else if value < 0.0 && end - left > LABEL_ROOM {
            let style = TextStyle::new(TICK_SIZE, Anchor::End);
            drawing.plain_text([end - 5.0, baseline], &style, &text);
        } else {
            let style = TextStyle::new(TICK_SIZE, Anchor::Start);
            drawing.plain_text([end.max(zero) + 5.0, baseline], &style, &text);
        }
    }
}
