//! Curves and marks with their own vertical axis.

use super::color::{BLUE, MUTED};
use super::frame::Frame;
use super::label::{Anchor, TextStyle};
use super::marks::{Entry, Shape};
use super::svg::Drawing;
use super::ticks::round_axis;

/// A coordinate; an unknown one interrupts its curve.
pub(crate) fn known(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}

/// A curve.
#[derive(Debug)]
pub(crate) struct Curve {
    /// Its points; those that are not finite interrupt it.
    pub points: Vec<[f64; 2]>,
    /// SVG attributes of its stroke.
    pub stroke: String,
    /// Its name in the legend, in the markup of labels; empty for none.
    pub text: String,
    /// Whether it may leave the picture: such a curve does not set the axis.
    pub is_free: bool,
}

impl Curve {
    /// A curve with a stroke of its own.
    pub(crate) fn new(points: Vec<[f64; 2]>, stroke: String, text: &str) -> Self {
        Self { points, stroke, text: text.to_owned(), is_free: false }
    }

    /// A solid curve.
    pub(crate) fn solid(points: Vec<[f64; 2]>, color: &str, text: &str) -> Self {
        Self::new(points, stroke(color, 2.2, ""), text)
    }

    /// A wide pale curve, which is seen beneath a solid one, too.
    pub(crate) fn pale(points: Vec<[f64; 2]>, text: &str) -> Self {
        Self::new(points, stroke("#c6c6c6", 6.5, ""), text)
    }

    /// A dashed curve.
    pub(crate) fn dashed(points: Vec<[f64; 2]>, color: &str, text: &str) -> Self {
        Self::new(points, stroke(color, 1.6, "7 4"), text)
    }

    /// The finite values.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> {
        let finite = self.points.iter().filter(|point| point.iter().all(|c| c.is_finite()));
        finite.map(|point| point[1])
    }

    /// Its largest magnitude.
    fn largest(&self) -> f64 {
        self.values().map(f64::abs).fold(0.0, f64::max)
    }
}

/// Depths (in m) across a profile as points in mm and a unit (in m), down to zero at both ends.
pub(crate) fn across(y: &[f64], depth: &[f64], unit: f64) -> Vec<[f64; 2]> {
    let half = match *y {
        [first, second, ..] => 0.5 * (second - first),
        _ => 1e-4,
    };
    let first = y.first().map(|y| [(y - half) / 1e-3, 0.0]);
    let last = y.last().map(|y| [(y + half) / 1e-3, 0.0]);
    let points = y.iter().zip(depth).map(|(y, depth)| [y / 1e-3, depth / unit]);
    first.into_iter().chain(points).chain(last).collect()
}

/// SVG attributes of a line; solid without a pattern of dashes.
pub(crate) fn stroke(color: &str, width: f64, dashes: &str) -> String {
    let dashes =
        if dashes.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{dashes}""#) };
    format!(r#"stroke="{color}" stroke-width="{width}" stroke-linejoin="round"{dashes}"#)
}

/// A point with a shape.
#[derive(Debug)]
pub(crate) struct Mark {
    /// Its place.
    pub at: [f64; 2],
    /// Its shape.
    pub shape: Shape,
    /// SVG attributes of the shape.
    pub style: String,
    /// The range of its ordinate and the colour of the line that shows it, if there is one.
    pub range: Option<([f64; 2], String)>,
}

/// Range of a vertical axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Axis {
    /// That of what is drawn, including zero.
    Zero,
    /// That of what is drawn: for temperatures in °C, whose zero means nothing.
    Own,
    /// A given one, beyond which curves are cut.
    Given([f64; 2]),
}

/// Curves and marks with their own vertical axis.
#[derive(Debug)]
pub(crate) struct Panel {
    /// Label of the vertical axis.
    pub label: String,
    /// Height of the plot area.
    pub height: f64,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Points, on top of the curves.
    pub marks: Vec<Mark>,
    /// Bars from zero: both edges, and the value.
    pub bars: Vec<[f64; 3]>,
    /// Words at places.
    pub words: Vec<([f64; 2], &'static str)>,
    /// Entries of the legend after those of the curves.
    pub entries: Vec<Entry>,
    /// Range of the vertical axis.
    pub axis: Axis,
}

impl Panel {
    /// A panel of curves.
    pub(crate) fn new(label: impl Into<String>, height: f64, curves: Vec<Curve>) -> Self {
        let (marks, bars, words, entries) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let label = label.into();
        Self { label, height, curves, marks, bars, words, entries, axis: Axis::Zero }
    }

    /// A panel without the curves that are invisible everywhere; if all are, with the first.
    pub(crate) fn of_components(label: String, height: f64, mut curves: Vec<Curve>) -> Self {
        const INVISIBLE: f64 = 1e-4;
        let largest = curves.iter().map(Curve::largest).fold(0.0, f64::max);
        if largest > 0.0 {
            curves.retain(|curve| curve.largest() > INVISIBLE * largest);
        } else {
            curves.truncate(1);
        }
        Self::new(label, height, curves)
    }

    /// The same with another vertical axis.
    pub(crate) fn with_axis(self, axis: Axis) -> Self {
        Self { axis, ..self }
    }

    pub(super) fn draw_bars(&self, drawing: &mut Drawing, frame: &Frame) {
        let fill = format!(r##"fill="{BLUE}" stroke="#ffffff" stroke-width="1""##);
        for &[from, to, value] in &self.bars {
            let [[left, top], [right, bottom]] = [frame.at([from, value]), frame.at([to, 0.0])];
            drawing.rectangle([left, top], [right - left, bottom - top], &fill);
        }
    }

    pub(super) fn draw_curves(&self, drawing: &mut Drawing, frame: &Frame) {
        let is_cut = self.axis != Axis::Zero || self.curves.iter().any(|curve| curve.is_free);
        if is_cut {
            drawing.begin_clip(&frame.area());
        }
        for curve in &self.curves {
            let pieces = curve.points.split(|point| !point.iter().all(|c| c.is_finite()));
            for piece in pieces.filter(|piece| !piece.is_empty()) {
                let points: Vec<[f64; 2]> = piece.iter().map(|point| frame.at(*point)).collect();
                drawing.polyline(&points, &curve.stroke);
            }
        }
        if is_cut {
            drawing.end_group();
        }
    }

    pub(super) fn draw_marks(&self, drawing: &mut Drawing, frame: &Frame) {
        for ([x, y], text) in &self.words {
            let style = TextStyle { color: MUTED, ..TextStyle::new(15.0, Anchor::Middle) };
            let [x, y] = frame.at([*x, *y]);
            drawing.text([x, y + 5.0], &style, text);
        }
        for Mark { at, shape, style, range } in &self.marks {
            if let Some((ends, color)) = range {
                let [from, to] = ends.map(|y| frame.at([at[0], y]));
                drawing.line(from, to, &stroke(color, 1.6, ""));
            }
            shape.draw(drawing, frame.at(*at), style);
        }
    }

    /// Range of the vertical axis: with some space for marks and beside free curves.
    pub(super) fn range(&self) -> [f64; 2] {
        const CLEARANCE: f64 = 0.05;
        let curves = self.curves.iter().filter(|curve| !curve.is_free);
        let of_marks = self.marks.iter().flat_map(|mark| {
            let range = mark.range.as_ref().map_or([mark.at[1]; 2], |(range, _)| *range);
            range.into_iter().filter(|value| value.is_finite())
        });
        let bars = self.bars.iter().map(|bar| bar[2]);
        let values: Vec<f64> = curves.flat_map(Curve::values).chain(of_marks).chain(bars).collect();
        let start = match self.axis {
            Axis::Given(range) => return range,
            Axis::Zero => Some(0.0),
            Axis::Own => None,
        };
        let ends = [f64::min, f64::max].map(|end| values.iter().copied().chain(start).reduce(end));
        let [low, high] = ends.map(Option::unwrap_or_default);
        let [below, above] = self.range_around([low, high]);
        let is_tight = self.marks.is_empty() && !self.curves.iter().any(|curve| curve.is_free);
        let space = if is_tight { 0.0 } else { CLEARANCE * (high - low) };
        [
            if Some(low) == start { below } else { below.min(low - space) },
            if Some(high) == start { above } else { above.max(high + space) },
        ]
    }

    /// A range slightly widened.
    fn range_around(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let margin = 0.04 * (high - low);
        let about = ((self.height / 45.0) as usize).clamp(2, 8);
        let ([below, above], _) = round_axis(low, high, about);
        if high <= low {
            // All is zero.
            return [below, above].map(|end| low + end);
        }
        // Up to the next tick, unless that would leave much of the panel empty.
        [below.max(low - 2.5 * margin), above.min(high + 2.5 * margin)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::color::INK;
    use super::*;

    fn panel(values: &[f64], axis: Axis) -> Panel {
        let points = values.iter().enumerate().map(|(k, value)| [k as f64, *value]).collect();
        Panel::new("", 150.0, vec![Curve::solid(points, INK, "")]).with_axis(axis)
    }

    /// 80 °C is no eighty times as much as 1 °C.
    #[test]
    fn only_axes_of_differences_begin_at_zero() {
        assert_eq!(panel(&[88.0, 125.0], Axis::Zero).range()[0], 0.0);
        let [low, high] = panel(&[88.0, 125.0], Axis::Own).range();
        assert!((78.0..=88.0).contains(&low) && (125.0..=135.0).contains(&high), "{low} {high}");
        assert_eq!(panel(&[20.0, 20.0], Axis::Own).range(), [20.0, 21.0]);
        assert_eq!(panel(&[0.0, 0.0], Axis::Zero).range(), [0.0, 1.0]);
    }

    #[test]
    fn marks_have_space_and_free_curves_none() {
        let mut panel = panel(&[0.0, 1.0], Axis::Zero);
        let points = vec![[0.0, 0.0], [1.0, 50.0]];
        panel.curves.push(Curve { is_free: true, ..Curve::solid(points, INK, "") });
        assert!(panel.range()[1] < 1.2);
        let (shape, style) = (Shape::Cross, String::new());
        panel.marks.push(Mark { at: [1.0, 2.0], shape, style, range: None });
        assert!((2.1..2.5).contains(&panel.range()[1]));
    }
}
