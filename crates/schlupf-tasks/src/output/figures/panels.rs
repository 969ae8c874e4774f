//! Curves over a common horizontal axis, in stacked panels.

use super::color::INK;
use super::frame::Frame;
use super::marks::{self, Entry, HEADING, Sample};
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
}

impl Curve {
    /// A solid curve.
    pub(crate) fn solid(points: Vec<[f64; 2]>, color: &str, text: &str) -> Self {
        let stroke = format!(r#"stroke="{color}" stroke-width="2.2" stroke-linejoin="round""#);
        Self { points, stroke, text: text.to_owned() }
    }

    /// Its largest magnitude.
    fn largest(&self) -> f64 {
        let values = self.points.iter().map(|point| point[1].abs());
        values.filter(|value| value.is_finite()).fold(0.0, f64::max)
    }

    /// A wide pale curve, which is seen beneath a solid one, too.
    pub(crate) fn pale(points: Vec<[f64; 2]>, text: &str) -> Self {
        let stroke = r##"stroke="#c6c6c6" stroke-width="6.5" stroke-linejoin="round""##.to_owned();
        Self { points, stroke, text: text.to_owned() }
    }

    /// A dashed curve.
    pub(crate) fn dashed(points: Vec<[f64; 2]>, color: &str, text: &str) -> Self {
        let stroke = format!(r#"stroke="{color}" stroke-width="1.6" stroke-dasharray="7 4""#);
        Self { points, stroke, text: text.to_owned() }
    }
}

/// Curves with their own vertical axis.
#[derive(Debug)]
pub(crate) struct Panel {
    /// Label of the vertical axis.
    pub label: String,
    /// Height of the plot area.
    pub height: f64,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// Panels over one horizontal axis.
#[derive(Debug)]
pub(crate) struct Stack<'a> {
    /// Range of the horizontal axis.
    pub x: [f64; 2],
    /// Label of the horizontal axis.
    pub label: &'a str,
    /// The panels from top to bottom.
    pub panels: Vec<Panel>,
    /// Shaded ranges of the horizontal axis.
    pub shaded: Vec<[f64; 2]>,
    /// Meaning of the shading.
    pub shading: &'static str,
}

/// Width of the drawing.
pub(crate) const WIDTH: f64 = 900.0;
/// Left end of the plot area.
pub(crate) const LEFT: f64 = 92.0;
/// Margin to the right of the plot area.
pub(crate) const RIGHT: f64 = 30.0;
/// Width of the plot area.
const PLOT: f64 = WIDTH - LEFT - RIGHT;
const SHADE: &str = r##"fill="#e9eef4""##;
/// Stroke of the line at zero.
pub(crate) const ZERO: &str = r##"stroke="#8a8a8a" stroke-width="1""##;

impl Stack<'_> {
    /// Height of the drawing.
    pub(crate) fn height(&self) -> f64 {
        HEADING + 30.0 + self.plot_height() + GAP + 36.0
    }

    /// Height of the plot areas with their gaps and legends, except for the first row of the first.
    pub(crate) fn plot_height(&self) -> f64 {
        let space = |panel: &Panel| panel.height + GAP + self.further_rows(panel);
        self.panels.iter().map(space).sum::<f64>() - GAP
    }

    /// An empty drawing of the right size.
    pub(crate) fn drawing(&self) -> Drawing {
        Drawing::new(WIDTH, self.height())
    }

    /// Draws all panels, from `top` downwards.
    pub(crate) fn draw(&self, drawing: &mut Drawing, top: f64) {
        let mut top = top;
        for (index, panel) in self.panels.iter().enumerate() {
            top += self.further_rows(panel);
            let frame = Frame {
                corner: [LEFT, top],
                size: [PLOT, panel.height],
                x: self.x,
                y: panel.range(),
            };
            self.draw_panel(drawing, panel, &frame);
            if index + 1 == self.panels.len() {
                frame.draw_horizontal(drawing, self.label);
            }
            top += panel.height + GAP;
        }
    }

    fn draw_panel(&self, drawing: &mut Drawing, panel: &Panel, frame: &Frame) {
        for &[from, to] in &self.shaded {
            let [left, right] = [from, to].map(|x| frame.at([x, 0.0])[0]);
            drawing.rectangle([left, frame.corner[1]], [right - left, panel.height], SHADE);
        }
        frame.draw_grid(drawing);
        let zero = frame.at([self.x[0], 0.0])[1];
        drawing.line([LEFT, zero], [frame.right(), zero], ZERO);
        panel.draw_curves(drawing, frame);
        frame.draw_vertical(drawing, &panel.label);
        marks::legend_above(drawing, frame.corner, PLOT, &self.entries(panel));
    }

    /// Height of the legend of a panel beyond its first row.
    fn further_rows(&self, panel: &Panel) -> f64 {
        marks::further_rows(PLOT, &self.entries(panel))
    }

    fn entries(&self, panel: &Panel) -> Vec<Entry> {
        let named = panel.curves.iter().filter(|curve| !curve.text.is_empty());
        let mut entries: Vec<Entry> = named
            .map(|curve| Entry {
                sample: Sample::Line(vec![curve.stroke.clone()]),
                text: curve.text.clone(),
            })
            .collect();
        let first = self.panels.first().is_some_and(|first| std::ptr::eq(first, panel));
        if first && !self.shaded.is_empty() {
            let style = format!(r#"{SHADE} stroke="{INK}" stroke-width="0.4""#);
            entries.push(Entry { sample: Sample::Area(style), text: self.shading.to_owned() });
        }
        entries
    }
}

/// Gap between two panels, for the legend of the lower one.
pub(crate) const GAP: f64 = 36.0;

impl Panel {
    /// A panel without the curves that are invisible everywhere; if all are, with the first.
    pub(crate) fn of_components(label: String, height: f64, mut curves: Vec<Curve>) -> Self {
        const INVISIBLE: f64 = 1e-4;
        let largest = curves.iter().map(Curve::largest).fold(0.0, f64::max);
        if largest > 0.0 {
            curves.retain(|curve| curve.largest() > INVISIBLE * largest);
        } else {
            curves.truncate(1);
        }
        Self { label, height, curves }
    }

    /// Draws the curves into a frame.
    pub(crate) fn draw_curves(&self, drawing: &mut Drawing, frame: &Frame) {
        for curve in &self.curves {
            let pieces = curve.points.split(|point| !point.iter().all(|c| c.is_finite()));
            for piece in pieces.filter(|piece| !piece.is_empty()) {
                let points: Vec<[f64; 2]> = piece.iter().map(|point| frame.at(*point)).collect();
                drawing.polyline(&points, &curve.stroke);
            }
        }
    }

    /// Range of its curves including zero, slightly widened.
    pub(crate) fn range(&self) -> [f64; 2] {
        let points = self.curves.iter().flat_map(|curve| &curve.points);
        let values = points.map(|point| point[1]).filter(|value| value.is_finite());
        self.range_around([values.clone().fold(0.0, f64::min), values.fold(0.0, f64::max)])
    }

    /// A range slightly widened.
    pub(crate) fn range_around(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let margin = 0.04 * (high - low);
        let about = ((self.height / 45.0) as usize).clamp(2, 8);
        let ([below, above], _) = round_axis(low, high, about);
        if high <= low {
            // All is zero.
            return [below, above];
        }
        // Up to the next tick, unless that would leave much of the panel empty.
        [below.max(low - 2.5 * margin), above.min(high + 2.5 * margin)]
    }
}
