//! Panels over a common horizontal axis, in stacks: a figure is a heading and a list of stacks.

use super::color::INK;
use super::frame::Frame;
use super::marks::{self, Entry, HEADING, Heading, Sample};
pub(crate) use super::panel::{Axis, Curve, Mark, Panel, across, known, stroke};
use super::svg::Drawing;

/// Panels over one horizontal axis.
#[derive(Debug)]
pub(crate) struct Stack {
    /// Range of the horizontal axis.
    pub x: [f64; 2],
    /// Label of the horizontal axis.
    pub label: String,
    /// The panels from top to bottom.
    pub panels: Vec<Panel>,
    /// Shaded ranges of the horizontal axis.
    pub shaded: Vec<[f64; 2]>,
    /// Meaning of the shading.
    pub shading: &'static str,
    /// Whether all places are logarithms to base ten.
    pub powers: bool,
}

/// Width of the drawing.
pub(crate) const WIDTH: f64 = 900.0;
/// Left end of the plot area.
pub(crate) const LEFT: f64 = 92.0;
/// Margin to the right of the plot area.
pub(crate) const RIGHT: f64 = 30.0;
const SHADE: &str = r##"fill="#e9eef4""##;
/// Gap between two panels, for the legend of the lower one.
const GAP: f64 = 36.0;
/// Space for the horizontal axis between two stacks, and below the last.
const BETWEEN: f64 = 104.0;
const FOOT: f64 = 64.0;

/// A figure of stacks one below the other.
pub(crate) fn page(heading: &Heading, stacks: &[Stack]) -> String {
    lay_out(heading, stacks, WIDTH - RIGHT, 0.0).0.finish()
}

/// The same with plot areas that end at `right`, at least `least` high; returns the top of the
/// first plot area, too.
pub(crate) fn lay_out(
    heading: &Heading,
    stacks: &[Stack],
    right: f64,
    least: f64,
) -> (Drawing, f64) {
    let width = right - LEFT;
    let start = HEADING + 40.0;
    let heights = stacks.iter().map(|stack| stack.height(width) + BETWEEN);
    let bottom = start + heights.sum::<f64>() - BETWEEN + FOOT;
    let first =
        stacks.first().and_then(|stack| Some(stack.further_rows(width, stack.panels.first()?)));
    let top = start + first.unwrap_or_default();
    let mut drawing = Drawing::new(WIDTH, bottom.max(top + least));
    heading.draw(&mut drawing);
    if heading.is_rolling {
        marks::rolling_direction(&mut drawing, [right - 86.0, HEADING + 8.0]);
    }
    let mut corner = [LEFT, start];
    for stack in stacks {
        stack.draw(&mut drawing, corner, width);
        corner[1] += stack.height(width) + BETWEEN;
    }
    (drawing, top)
}

impl Stack {
    /// Panels without shading.
    pub(crate) fn over(x: [f64; 2], label: impl Into<String>, panels: Vec<Panel>) -> Self {
        Self { x, label: label.into(), panels, shaded: Vec::new(), shading: "", powers: false }
    }

    /// Height of the plot areas with their gaps and legends, except for the first row of the first.
    fn height(&self, width: f64) -> f64 {
        let space = |panel: &Panel| panel.height + GAP + self.further_rows(width, panel);
        self.panels.iter().map(space).sum::<f64>() - GAP
    }

    /// Draws all panels from a corner downwards.
    pub(crate) fn draw(&self, drawing: &mut Drawing, [left, top]: [f64; 2], width: f64) {
        let mut top = top;
        for (index, panel) in self.panels.iter().enumerate() {
            top += self.further_rows(width, panel);
            let (corner, size) = ([left, top], [width, panel.height]);
            let frame = Frame { corner, size, x: self.x, y: panel.range(), powers: self.powers };
            self.draw_panel(drawing, panel, &frame);
            if index + 1 == self.panels.len() {
                frame.draw_horizontal(drawing, &self.label);
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
        if !self.powers {
            frame.draw_zero(drawing);
        }
        panel.draw_bars(drawing, frame);
        panel.draw_curves(drawing, frame);
        frame.draw_vertical(drawing, &panel.label);
        // On top of the frame, which would cut them.
        panel.draw_marks(drawing, frame);
        marks::legend_above(drawing, frame.corner, frame.size[0], &self.entries(panel));
    }

    /// Height of the legend of a panel beyond its first row.
    fn further_rows(&self, width: f64, panel: &Panel) -> f64 {
        marks::further_rows(width, &self.entries(panel))
    }

    /// The entries of the legend: only of curves that are seen.
    fn entries(&self, panel: &Panel) -> Vec<Entry> {
        let named = panel
            .curves
            .iter()
            .filter(|curve| !curve.text.is_empty() && curve.values().nth(1).is_some());
        let line = |curve: &Curve| Entry::line(&curve.stroke, &curve.text);
        let mut entries: Vec<Entry> = named.map(line).collect();
        entries.extend(panel.entries.iter().cloned());
        let first = self.panels.first().is_some_and(|first| std::ptr::eq(first, panel));
        if first && self.shaded.iter().any(|[from, to]| to > from) {
            let style = format!(r#"{SHADE} stroke="{INK}" stroke-width="0.4""#);
            entries.push(Entry { sample: Sample::Area(style), text: self.shading.to_owned() });
        }
        entries
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_that_are_not_seen_are_not_listed() {
        let seen = Curve::solid(vec![[0.0, 1.0], [1.0, 2.0]], INK, "seen");
        let mut panel = Panel::new("", 150.0, vec![seen]);
        panel.curves.push(Curve::dashed(vec![[0.0, f64::NAN]; 4], INK, "unknown"));
        panel.curves.push(Curve::dashed(Vec::new(), INK, "empty"));
        let mut stack = Stack::over([0.0, 1.0], "", vec![panel]);
        (stack.shaded, stack.shading) = (vec![[0.5, 0.5]], "nowhere");
        let texts: Vec<String> =
            stack.entries(&stack.panels[0]).into_iter().map(|entry| entry.text).collect();
        assert_eq!(texts, ["seen"]);
    }
}
