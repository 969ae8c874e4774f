//! A rectangle with axes: ticks, grid, labels.

use super::color::INK;
use super::label::{Anchor, TextStyle};
use super::svg::{Drawing, GRID_LINE, ZERO};
use super::ticks::{Tick, logarithmic_ticks, round_ticks};

/// Font size of tick labels.
pub(crate) const TICK_SIZE: f64 = 13.0;
/// Font size of axis labels.
pub(crate) const LABEL_SIZE: f64 = 15.0;

/// A plot area and its ranges.
#[derive(Debug, Clone)]
pub(crate) struct Frame {
    /// Upper left corner in the drawing.
    pub corner: [f64; 2],
    /// Width and height in the drawing.
    pub size: [f64; 2],
    /// Range of x.
    pub x: [f64; 2],
    /// Range of y.
    pub y: [f64; 2],
    /// Whether x and y are logarithms to base ten.
    pub powers: bool,
}

impl Frame {
    /// Position of a point in the drawing.
    pub(crate) fn at(&self, point: [f64; 2]) -> [f64; 2] {
        let u = (point[0] - self.x[0]) / (self.x[1] - self.x[0]);
        let v = (point[1] - self.y[0]) / (self.y[1] - self.y[0]);
        [self.corner[0] + u * self.size[0], self.corner[1] + (1.0 - v) * self.size[1]]
    }

    /// Drawing units per unit of x and of y.
    pub(crate) fn scale(&self) -> [f64; 2] {
        [self.size[0] / (self.x[1] - self.x[0]), self.size[1] / (self.y[1] - self.y[0])]
    }

    /// Lower edge in the drawing.
    pub(crate) fn bottom(&self) -> f64 {
        self.corner[1] + self.size[1]
    }

    /// Right edge in the drawing.
    pub(crate) fn right(&self) -> f64 {
        self.corner[0] + self.size[0]
    }

    /// The plot area as an SVG element, to clip to.
    pub(crate) fn area(&self) -> String {
        let ([x, y], [width, height]) = (self.corner, self.size);
        format!(r#"<rect x="{x:.2}" y="{y:.2}" width="{width:.2}" height="{height:.2}"/>"#)
    }

    /// Grid lines at the ticks, to be drawn first.
    pub(crate) fn draw_grid(&self, drawing: &mut Drawing) {
        for tick in self.x_ticks() {
            let x = self.at([tick.value, self.y[0]])[0];
            drawing.line([x, self.corner[1]], [x, self.bottom()], GRID_LINE);
        }
        for tick in self.y_ticks() {
            let y = self.at([self.x[0], tick.value])[1];
            drawing.line([self.corner[0], y], [self.right(), y], GRID_LINE);
        }
    }

    /// The lines at zero, where they are within the frame.
    pub(crate) fn draw_zero(&self, drawing: &mut Drawing) {
        let [x, y] = self.at([0.0, 0.0]);
        if self.y[0] <= 0.0 && 0.0 <= self.y[1] {
            drawing.line([self.corner[0], y], [self.right(), y], ZERO);
        }
        if self.x[0] < 0.0 && 0.0 < self.x[1] {
            drawing.line([x, self.corner[1]], [x, self.bottom()], ZERO);
        }
    }

    /// The outline, and ticks and label of the vertical axis.
    pub(crate) fn draw_vertical(&self, drawing: &mut Drawing, label: &str) {
        let left = self.corner[0];
        drawing.rectangle(self.corner, self.size, &outline());
        let mut widest: f64 = 0.0;
        for tick in self.y_ticks() {
            let y = self.at([self.x[0], tick.value])[1];
            drawing.line([left, y], [left - 5.0, y], &tick_line());
            let style = TextStyle::new(TICK_SIZE, Anchor::End);
            drawing.text([left - 9.0, y + 0.36 * TICK_SIZE], &style, &tick.label);
            widest = widest.max(super::label::width(&tick.label) * TICK_SIZE);
        }
        let style = TextStyle { rotation: -90.0, ..TextStyle::new(LABEL_SIZE, Anchor::Middle) };
        let middle = self.corner[1] + 0.5 * self.size[1];
        drawing.text([left - 9.0 - widest.max(22.0) - 14.0, middle], &style, label);
    }

    /// Ticks and label of the horizontal axis.
    pub(crate) fn draw_horizontal(&self, drawing: &mut Drawing, label: &str) {
        let bottom = self.bottom();
        for tick in self.x_ticks() {
            let x = self.at([tick.value, self.y[0]])[0];
            drawing.line([x, bottom], [x, bottom + 5.0], &tick_line());
            let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
            drawing.text([x, bottom + 8.0 + TICK_SIZE], &style, &tick.label);
        }
        for x in self.small_ticks() {
            let x = self.at([x, self.y[0]])[0];
            drawing.line([x, bottom], [x, bottom + 3.0], &tick_line());
        }
        let style = TextStyle::new(LABEL_SIZE, Anchor::Middle);
        drawing.text([self.corner[0] + 0.5 * self.size[0], bottom + 44.0], &style, label);
    }

    fn x_ticks(&self) -> Vec<Tick> {
        self.ticks(self.x, ((self.size[0] / 70.0) as usize).clamp(2, 9))
    }

    fn y_ticks(&self) -> Vec<Tick> {
        self.ticks(self.y, ((self.size[1] / 45.0) as usize).clamp(2, 8))
    }

    fn ticks(&self, range: [f64; 2], about: usize) -> Vec<Tick> {
        if self.powers {
            logarithmic_ticks(range[0], range[1], about)
        } else {
            enough_ticks(range, about)
        }
    }

    /// Places of x between powers of ten.
    fn small_ticks(&self) -> Vec<f64> {
        let [low, high] = self.x;
        if !self.powers {
            return Vec::new();
        }
        let decades = (low.floor() as i32..=high.floor() as i32).map(f64::from);
        let places = decades.flat_map(|x| (2..10).map(move |k| x + f64::from(k).log10()));
        places.filter(|x| (low..=high).contains(x)).collect()
    }
}

/// Approximately the given number of ticks, but at least three: an axis with one tick has no
/// recognisable scale.
fn enough_ticks([low, high]: [f64; 2], about: usize) -> Vec<Tick> {
    const LEAST: usize = 3;
    let ticks = |about| round_ticks(low, high, about);
    (about..=2 * LEAST).map(ticks).find(|t| t.len() >= LEAST).unwrap_or_else(|| ticks(about))
}

/// Stroke of the outline of a plot area.
pub(crate) fn outline() -> String {
    format!(r#"fill="none" stroke="{INK}" stroke-width="1""#)
}

/// Stroke of a tick.
pub(crate) fn tick_line() -> String {
    format!(r#"stroke="{INK}" stroke-width="1""#)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn narrow_axes_have_three_ticks() {
        for high in [0.3, 0.9, 1.08, 2.4, 4.9, 5.1, 7.7, 9.99] {
            assert!(enough_ticks([-high, high], 2).len() >= 3, "{high}");
            assert!(enough_ticks([0.0, high], 2).len() >= 3, "{high}");
        }
        assert_eq!(enough_ticks([0.0, f64::NAN], 2), []);
    }
}
