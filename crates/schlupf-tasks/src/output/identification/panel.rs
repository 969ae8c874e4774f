//! A panel with measured points, the ranges of their standard deviations, and curves.

use std::ops::Range;

use crate::output::figures::color::INK;
use crate::output::figures::frame::Frame;
use crate::output::figures::marks::{self, Sample};
use crate::output::figures::panels::{Curve, Panel, ZERO};
use crate::output::figures::svg::Drawing;

/// Shape of a mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// A disc.
    Dot,
    /// A square.
    Square,
}

impl Shape {
    /// The mark in a legend.
    pub(super) fn sample(self, color: &str) -> Sample {
        match self {
            Self::Dot => Sample::Dot(fill(color)),
            Self::Square => Sample::Square(fill(color)),
        }
    }
}

/// A point with the range of its standard deviation.
pub(super) struct Mark {
    /// Position.
    pub at: [f64; 2],
    /// Range of its ordinate; empty if unknown.
    pub range: Range<f64>,
    /// Its colour.
    pub color: String,
    /// Its shape.
    pub shape: Shape,
}

/// A panel with points.
pub(super) struct MarkedPanel {
    /// Label, height and curves.
    pub panel: Panel,
    /// Measured points.
    pub marks: Vec<Mark>,
    /// Computed points.
    pub crosses: Vec<[f64; 2]>,
}

/// Stroke of a curve.
pub(super) fn curve_stroke(color: &str) -> String {
    format!(r#"stroke="{color}" stroke-width="2" stroke-linejoin="round""#)
}

fn fill(color: &str) -> String {
    format!(r##"fill="{color}" stroke="#ffffff" stroke-width="0.7""##)
}

fn thin(color: &str) -> String {
    format!(r#"stroke="{color}" stroke-width="1.6""#)
}

/// Margin above and below the contents, as a fraction of the height.
const CLEARANCE: f64 = 0.04;

impl MarkedPanel {
    /// Stroke of a computed point: dark, so that it is visible on top of the measured one.
    pub(super) fn cross() -> String {
        thin(INK)
    }

    /// Range of everything drawn, including zero.
    pub(super) fn range(&self) -> [f64; 2] {
        let ends = self.marks.iter().flat_map(|mark| [mark.range.start, mark.range.end]);
        let crosses = self.crosses.iter().map(|at| at[1]);
        let marks: Vec<[f64; 2]> = ends.chain(crosses).map(|value| [0.0, value]).collect();
        let curves = self.panel.curves.iter().map(|curve| curve.points.clone());
        let invisible = |points| Curve { points, stroke: String::new(), text: String::new() };
        let curves = curves.chain([marks]).map(invisible).collect();
        let [low, high] = Panel { label: String::new(), height: self.panel.height, curves }.range();
        // All residuals may be zero.
        if low >= high {
            return [-1e-3, 1e-3];
        }
        let space = CLEARANCE * (high - low);
        [if low < 0.0 { low - space } else { low }, if high > 0.0 { high + space } else { high }]
    }

    /// Draws the panel into a frame.
    pub(super) fn draw(&self, drawing: &mut Drawing, frame: &Frame) {
        frame.draw_grid(drawing);
        let [zero_x, zero_y] = frame.at([0.0, 0.0]);
        drawing.line([frame.corner[0], zero_y], [frame.right(), zero_y], ZERO);
        drawing.line([zero_x, frame.corner[1]], [zero_x, frame.bottom()], ZERO);
        self.panel.draw_curves(drawing, frame);
        for Mark { at, range, color, shape } in &self.marks {
            if range.start < range.end {
                let [from, to] = [range.start, range.end].map(|y| frame.at([at[0], y]));
                drawing.line(from, to, &thin(color));
            }
            match shape {
                Shape::Dot => marks::dot(drawing, frame.at(*at), &fill(color)),
                Shape::Square => marks::square(drawing, frame.at(*at), &fill(color)),
            }
        }
        for at in &self.crosses {
            marks::cross(drawing, frame.at(*at), &Self::cross());
        }
        frame.draw_vertical(drawing, &self.panel.label);
    }
}
