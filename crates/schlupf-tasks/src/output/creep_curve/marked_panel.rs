//! A panel of a figure of curves, with the marks on its curves.

use schlupf::creep_curve::CreepCurve;
use schlupf::solution::Resultant;

use crate::output::figures::color::INK;
use crate::output::figures::frame::Frame;
use crate::output::figures::marks::{self, ALARM, Entry, Sample};
use crate::output::figures::panels::{Panel, ZERO};
use crate::output::figures::svg::Drawing;

/// The line of the initial slope.
pub(super) struct Tangent {
    /// Value at zero abscissa, and slope.
    pub value: f64,
    pub slope: f64,
    pub color: String,
}

impl Tangent {
    pub fn new(curve: &CreepCurve, value: impl Fn(&Resultant) -> f64, color: &str) -> Option<Self> {
        let slope = value(&curve.initial_slope.as_ref()?.force);
        let zero = curve.points.iter().find(|point| point.abscissa == 0.0)?;
        let value = value(&zero.force);
        (value.is_finite() && slope.is_finite() && slope != 0.0).then(|| Self {
            value,
            slope,
            color: color.to_owned(),
        })
    }

    /// The part of the line within a frame.
    pub fn within(&self, frame: &Frame) -> [[f64; 2]; 2] {
        let crossings = frame.y.map(|y| (y - self.value) / self.slope);
        let [low, high] = [crossings[0].min(crossings[1]), crossings[0].max(crossings[1])];
        [low.max(frame.x[0]), high.min(frame.x[1])].map(|x| [x, self.value + self.slope * x])
    }
}

/// A maximum.
pub(super) struct Dot {
    pub at: [f64; 2],
    pub color: String,
    pub hollow: bool,
}

/// A panel with the marks on its curves.
pub(super) struct MarkedPanel {
    pub panel: Panel,
    /// Whether each curve is a line that may leave the picture.
    pub are_lines: Vec<bool>,
    pub tangents: Vec<Tangent>,
    pub dots: Vec<Dot>,
    pub crosses: Vec<[f64; 2]>,
    pub entries: Vec<Entry>,
}

impl Dot {
    pub fn style(color: &str, hollow: bool) -> String {
        if hollow {
            format!(r##"fill="#ffffff" stroke="{color}" stroke-width="2""##)
        } else {
            format!(r##"fill="{color}" stroke="#ffffff" stroke-width="1.2""##)
        }
    }
}

fn tangent_stroke(color: &str) -> String {
    format!(r#"stroke="{color}" stroke-width="1" stroke-dasharray="4 3""#)
}

fn cross_stroke() -> String {
    format!(r#"stroke="{ALARM}" stroke-width="2""#)
}

impl MarkedPanel {
    /// Adds legend entries for the marks.
    pub fn explain(&mut self) {
        let mut entry = |sample, text: &str| {
            self.entries.push(Entry { sample, text: text.to_owned() });
        };
        if !self.tangents.is_empty() {
            entry(Sample::Line(vec![tangent_stroke(INK)]), "initial slope");
        }
        for (hollow, text) in [(false, "maximum of |$F$|"), (true, "saturation")] {
            if self.dots.iter().any(|dot| dot.hollow == hollow) {
                entry(Sample::Dot(Dot::style(INK, hollow)), text);
            }
        }
        if !self.crosses.is_empty() {
            entry(Sample::Cross(cross_stroke()), "not converged");
        }
    }

    /// Range of the curves including zero, with some margin for the marks; of a line, only where it
    /// begins.
    pub fn range(&self) -> [f64; 2] {
        const CLEARANCE: f64 = 0.05;
        let curves = self.panel.curves.iter().zip(&self.are_lines);
        let points = curves.flat_map(|(curve, is_line)| {
            curve.points.iter().filter(move |point| !is_line || point[0] == 0.0)
        });
        let finite = || points.clone().map(|point| point[1]).filter(|value| value.is_finite());
        let [low, high] = [finite().fold(0.0, f64::min), finite().fold(0.0, f64::max)];
        let space = CLEARANCE * (high - low);
        let [below, above] = self.panel.range_around([low, high]);
        [
            if low < 0.0 { below.min(low - space) } else { below },
            if high > 0.0 { above.max(high + space) } else { above },
        ]
    }

    pub fn draw(&self, drawing: &mut Drawing, frame: &Frame) {
        frame.draw_grid(drawing);
        let [left, right] = [frame.corner[0], frame.right()];
        let [zero_x, zero_y] = frame.at([0.0, 0.0]);
        drawing.line([left, zero_y], [right, zero_y], ZERO);
        if zero_x > left && zero_x < right {
            drawing.line([zero_x, frame.corner[1]], [zero_x, frame.bottom()], ZERO);
        }
        for tangent in &self.tangents {
            let [from, to] = tangent.within(frame).map(|point| frame.at(point));
            drawing.line(from, to, &tangent_stroke(&tangent.color));
        }
        drawing.begin_clip(&frame.area());
        self.panel.draw_curves(drawing, frame);
        drawing.end_group();
        for dot in &self.dots {
            marks::dot(drawing, frame.at(dot.at), &Dot::style(&dot.color, dot.hollow));
        }
        for at in &self.crosses {
            marks::cross(drawing, frame.at(*at), &cross_stroke());
        }
        frame.draw_vertical(drawing, &self.panel.label);
        marks::legend_above(drawing, frame.corner, frame.size[0], &self.entries);
    }
}
