//! A fit: measured forces with the fitted curves, and what is left.

use std::ops::Range;

use schlupf::Status;
use schlupf::creep_curve::Abscissa;
use schlupf::identification::{Component, Estimate, FittedPoint, Series};

use super::color::{LEVELS, Palette, paint};
use super::frame::Frame;
use super::marks::{self, Entry, HEADING, Sample, short};
use super::panels::{BLUE, Curve, GAP, LEFT, Panel, RIGHT, WIDTH, ZERO};
use super::svg::{Drawing, INK};
use crate::identification::{FitReport, in_usual_unit, with_uncertainty};

/// Heights of the two panels.
const HEIGHTS: [f64; 2] = [340.0, 170.0];
/// Height of a row of the legend.
const LEGEND_ROW: f64 = 22.0;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(report: &FitReport) -> Option<String> {
    let picture = Picture::new(report)?;
    let entries = picture.entries();
    // The legend may take several rows: it is drawn once to see.
    let width = WIDTH - LEFT - RIGHT;
    let rows = marks::legend(&mut Drawing::new(WIDTH, 1.0), [LEFT, 0.0], width, &entries);
    let top = HEADING + 18.0 + rows;
    let mut drawing = Drawing::new(WIDTH, top + HEIGHTS[0] + GAP + HEIGHTS[1] + 62.0);
    picture.heading(&mut drawing);
    marks::legend(&mut drawing, [LEFT, top - 9.0 - (rows - LEGEND_ROW)], width, &entries);
    let mut corner = [LEFT, top];
    for (panel, height) in [picture.forces(), picture.residuals()].into_iter().zip(HEIGHTS) {
        let frame = Frame { corner, size: [width, height], x: picture.x, y: panel.range() };
        panel.draw(&mut drawing, &frame);
        corner[1] += height + GAP;
        if height == HEIGHTS[1] {
            frame.draw_horizontal(&mut drawing, picture.axis());
        }
    }
    Some(drawing.finish())
}

struct Picture<'a> {
    report: &'a FitReport,
    /// Range of the abscissa.
    x: [f64; 2],
    colors: Vec<String>,
    /// Whether every series has a colour and an entry in the legend.
    is_told_apart: bool,
}

/// Most series that are told apart.
const MOST_SERIES: usize = 8;

impl<'a> Picture<'a> {
    fn new(report: &'a FitReport) -> Option<Self> {
        let mut picture = Self { report, x: [0.0, 0.0], colors: Vec::new(), is_told_apart: false };
        let places = || picture.points().map(|point| picture.place(point));
        let [low, high] = [places().fold(0.0, f64::min), places().fold(0.0, f64::max)];
        if !(low < high && low.is_finite() && high.is_finite()) {
            return None;
        }
        let margin = 0.03 * (high - low);
        picture.x = [
            if low < 0.0 { low - margin } else { -0.5 * margin },
            if high > 0.0 { high + margin } else { 0.5 * margin },
        ];
        let count = report.curves.series.len();
        picture.is_told_apart = (2..=MOST_SERIES).contains(&count);
        picture.colors =
            (0..count).map(|k| color(k, if picture.is_told_apart { count } else { 1 })).collect();
        Some(picture)
    }

    fn points(&self) -> impl Iterator<Item = &FittedPoint> {
        self.report.fit.points.iter()
    }

    fn place(&self, point: &FittedPoint) -> f64 {
        let motion = &point.data.condition.kinematics;
        match self.report.curves.abscissa {
            Abscissa::CreepageY => motion.creepage_y,
            Abscissa::Spin => motion.spin,
            _ => motion.creepage_x,
        }
    }

    fn axis(&self) -> &'static str {
        match self.report.curves.abscissa {
            Abscissa::CreepageY => "lateral creepage $η$",
            Abscissa::Spin => "spin creepage $φ$ (1/m)",
            _ => "longitudinal creepage $ξ$",
        }
    }

    fn heading(&self, drawing: &mut Drawing) {
        let fit = &self.report.fit;
        let found: Vec<String> = fit.estimates.iter().map(result).collect();
        let is_converged = fit.status == Status::Converged;
        let remark = if is_converged { "" } else { "not converged" };
        let title = "Fit to measured creep forces";
        let found = found.join(",  ");
        marks::title_block(drawing, title, [&self.report.title, &found], remark);
    }

    fn entries(&self) -> Vec<Entry> {
        let mut entries = vec![Entry {
            sample: Sample::Dot(dot(if self.is_told_apart { INK } else { BLUE })),
            text: "measured".to_owned(),
        }];
        let has_curves = self.report.curves.series.iter().any(|series| !series.curve.is_empty());
        if !has_curves {
            let sample = Sample::Cross(cross(if self.is_told_apart { INK } else { BLUE }));
            entries.push(Entry { sample, text: "fitted".to_owned() });
        } else if !self.is_told_apart {
            let sample = Sample::Line(vec![stroke(BLUE)]);
            entries.push(Entry { sample, text: "fitted".to_owned() });
        }
        if self.is_told_apart {
            for (series, color) in self.report.curves.series.iter().zip(&self.colors) {
                let sample = Sample::Line(vec![stroke(color)]);
                entries.push(Entry { sample, text: self.name(series) });
            }
        }
        entries
    }

    /// What a series has that others do not.
    fn name(&self, series: &Series) -> String {
        let all = &self.report.curves.series;
        let motion = &series.condition.kinematics;
        let differs =
            |value: fn(&Series) -> f64| all.iter().any(|other| value(other) != value(series));
        let mut parts = Vec::new();
        if differs(|series| series.component.index() as f64) {
            let component = match series.component {
                Component::Longitudinal => "\u{2212}$F$_x/$N$",
                Component::Lateral => "\u{2212}$F$_y/$N$",
            };
            parts.push(component.to_owned());
        }
        if differs(|series| series.condition.kinematics.speed) {
            parts.push(format!("{} m/s", short(motion.speed)));
        }
        if differs(|series| series.condition.load.unwrap_or_default()) {
            let load = series.condition.load.unwrap_or(self.report.load);
            parts.push(format!("{} kN", short(load / 1e3)));
        }
        if differs(|series| series.condition.kinematics.creepage_x) {
            parts.push(format!("$ξ$ = {}", short(motion.creepage_x)));
        }
        if differs(|series| series.condition.kinematics.creepage_y) {
            parts.push(format!("$η$ = {}", short(motion.creepage_y)));
        }
        if differs(|series| series.condition.kinematics.spin) {
            parts.push(format!("$φ$ = {} 1/m", short(motion.spin)));
        }
        parts.join(", ")
    }

    fn forces(&self) -> MarkedPanel {
        let label = match self.only_component() {
            Some(Component::Longitudinal) => "force on the rail \u{2212}$F$_x/$N$",
            Some(Component::Lateral) => "force on the rail \u{2212}$F$_y/$N$",
            None => "force on the rail over load",
        };
        let mut panel = self.panel(label, HEIGHTS[0], |point| point.data.force_ratio);
        for (series, color) in self.report.curves.series.iter().zip(&self.colors) {
            panel.panel.curves.push(Curve {
                points: series.curve.clone(),
                stroke: stroke(color),
                text: String::new(),
            });
            if series.curve.is_empty() {
                for k in &series.members {
                    let point = &self.report.fit.points[*k];
                    panel.crosses.push(([self.place(point), point.fitted], color.clone()));
                }
            }
        }
        panel
    }

    fn residuals(&self) -> MarkedPanel {
        self.panel("measured \u{2212} fitted", HEIGHTS[1], FittedPoint::residual)
    }

    fn only_component(&self) -> Option<Component> {
        let first = self.points().next()?.data.component;
        self.points().all(|point| point.data.component == first).then_some(first)
    }

    /// Dots of a value of all points.
    fn panel(&self, label: &str, height: f64, value: impl Fn(&FittedPoint) -> f64) -> MarkedPanel {
        let mut dots = Vec::new();
        for (series, color) in self.report.curves.series.iter().zip(&self.colors) {
            for k in &series.members {
                let point = &self.report.fit.points[*k];
                let deviation = point.data.standard_deviation.unwrap_or(0.0);
                let middle = value(point);
                let range = middle - deviation..middle + deviation;
                dots.push(Dot { at: [self.place(point), middle], range, color: color.clone() });
            }
        }
        let panel = Panel { label: label.to_owned(), height, curves: Vec::new() };
        MarkedPanel { panel, dots, crosses: Vec::new() }
    }
}

/// A parameter with its interval, in the markup of labels.
fn result(estimate: &Estimate) -> String {
    let parameter = estimate.parameter;
    let (value, unit) = in_usual_unit(parameter, estimate.value);
    let (half_width, _) = in_usual_unit(parameter, estimate.half_width);
    let [value, half_width] = with_uncertainty(value, half_width);
    let number = format!("{value} ± {half_width} {unit}").replace('-', "\u{2212}");
    format!("{} = {}", symbol(parameter.symbol()), number.trim_end())
}

/// A symbol such as `T_E` or `μ0` in the markup of labels.
fn symbol(text: &str) -> String {
    let (letter, index) = text.split_once('_').unwrap_or_else(|| {
        let end = text.find(|c: char| c.is_ascii_digit()).unwrap_or(text.len());
        text.split_at(end)
    });
    if index.is_empty() { format!("${letter}$") } else { format!("${letter}$_{{{index}}}") }
}

/// Colours from dark to light, so that they differ in grey, too.
fn color(k: usize, count: usize) -> String {
    /// The light end of the palette is not seen on white.
    const LIGHTEST: f64 = 0.78;
    if count == 1 {
        return BLUE.to_owned();
    }
    let level = LIGHTEST * k as f64 / (count - 1) as f64 * (LEVELS - 1) as f64;
    paint(Palette::Mechanical, level.round() as usize)
}

fn stroke(color: &str) -> String {
    format!(r#"stroke="{color}" stroke-width="2" stroke-linejoin="round""#)
}

fn dot(color: &str) -> String {
    format!(r##"fill="{color}" stroke="#ffffff" stroke-width="0.7""##)
}

fn cross(color: &str) -> String {
    format!(r#"stroke="{color}" stroke-width="1.6""#)
}

/// A point with the range of its standard deviation.
struct Dot {
    at: [f64; 2],
    range: Range<f64>,
    color: String,
}

/// Room above and below what is drawn, over the height.
const ROOM: f64 = 0.04;

/// A panel with points.
struct MarkedPanel {
    panel: Panel,
    dots: Vec<Dot>,
    crosses: Vec<([f64; 2], String)>,
}

impl MarkedPanel {
    /// Range of all that is drawn, and zero.
    fn range(&self) -> [f64; 2] {
        let ends = self.dots.iter().flat_map(|dot| [dot.range.start, dot.range.end]);
        let crosses = self.crosses.iter().map(|(at, _)| at[1]);
        let marks: Vec<[f64; 2]> = ends.chain(crosses).map(|value| [0.0, value]).collect();
        let curves = self.panel.curves.iter().map(|curve| curve.points.clone());
        let invisible = |points| Curve { points, stroke: String::new(), text: String::new() };
        let curves = curves.chain([marks]).map(invisible).collect();
        let [low, high] = Panel { label: String::new(), height: self.panel.height, curves }.range();
        // All residuals may be zero.
        if low >= high {
            return [-1e-3, 1e-3];
        }
        let room = ROOM * (high - low);
        [if low < 0.0 { low - room } else { low }, high + room]
    }

    fn draw(&self, drawing: &mut Drawing, frame: &Frame) {
        frame.draw_grid(drawing);
        let [zero_x, zero_y] = frame.at([0.0, 0.0]);
        drawing.line([frame.corner[0], zero_y], [frame.right(), zero_y], ZERO);
        drawing.line([zero_x, frame.corner[1]], [zero_x, frame.bottom()], ZERO);
        self.panel.draw_curves(drawing, frame);
        for Dot { at, range, color } in &self.dots {
            if range.start < range.end {
                let [from, to] = [range.start, range.end].map(|y| frame.at([at[0], y]));
                drawing.line(from, to, &cross(color));
            }
            marks::dot(drawing, frame.at(*at), &dot(color));
        }
        for (at, color) in &self.crosses {
            marks::cross(drawing, frame.at(*at), &cross(color));
        }
        frame.draw_vertical(drawing, &self.panel.label);
    }
}

#[cfg(test)]
mod tests {
    use super::symbol;

    #[test]
    fn symbols_are_set_with_their_index() {
        let set = ["T_E", "μ0", "h_rms", "A", "ΔT", "s1"].map(symbol);
        assert_eq!(set, ["$T$_{E}", "$μ$_{0}", "$h$_{rms}", "$A$", "$ΔT$", "$s$_{1}"]);
    }
}
