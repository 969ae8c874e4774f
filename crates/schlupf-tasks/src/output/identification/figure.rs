//! A fit: measured forces with the fitted curves, a panel for each component, and the residuals.

use schlupf::analysis::identification::{Component, Condition, Estimate, FittedPoint};

use super::{FitReport, in_usual_unit, with_uncertainty};
use crate::output::creep_curve::axis;
use crate::output::figures::color::{BLUE, INK, LEVELS, Palette, paint};
use crate::output::figures::marks::{Entry, Heading, Sample, Shape, short};
use crate::output::figures::panels::{self, Curve, Mark, Panel, Stack, known};

/// Height of the panel of forces if there is one, and of each if there are two.
const FORCES: [f64; 2] = [340.0, 260.0];
/// Height of the panel of residuals.
const RESIDUALS: f64 = 170.0;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(report: &FitReport) -> Option<String> {
    let picture = Picture::new(report)?;
    let fit = &report.fit;
    let found: Vec<String> = fit.estimates.iter().map(result).collect();
    let title = "Fit to measured creep forces";
    let heading = Heading::new(title, &report.title, found.join(",  "), fit.status);
    let mut panels = picture.panels();
    if let Some(first) = panels.first_mut() {
        first.entries = picture.entries();
    }
    Some(panels::page(&heading, &[Stack::over(picture.x, axis(report.curves.abscissa), panels)]))
}

fn curve_stroke(color: &str) -> String {
    panels::stroke(color, 2.0, "")
}

/// Style of a computed point: dark, so that it is visible on top of the measured one.
fn cross() -> String {
    format!(r#"stroke="{INK}" stroke-width="1.6""#)
}

fn fill(color: &str) -> String {
    format!(r##"fill="{color}" stroke="#ffffff" stroke-width="0.7""##)
}

struct Picture<'a> {
    report: &'a FitReport,
    /// Range of the abscissa.
    x: [f64; 2],
    /// Components that were measured.
    components: Vec<Component>,
    /// Conditions of the series, except for the varying creepage; both components may have the
    /// same.
    conditions: Vec<Condition>,
    coloring: Coloring,
}

/// Meaning of the colours.
enum Coloring {
    /// None: everything has one colour.
    None,
    /// The condition; each has an entry in the legend.
    Conditions,
    /// A number related to the condition, if there are too many conditions for the legend.
    Number { of: Quantity, range: [f64; 2] },
}

/// A number of a condition, with its unit.
struct Quantity {
    value: fn(&Condition, f64) -> f64,
    unit: &'static str,
}

const SPEED: Quantity = Quantity { value: |condition, _| condition.kinematics.speed, unit: "m/s" };
const LOAD: Quantity =
    Quantity { value: |condition, load| condition.load.unwrap_or(load) / 1e3, unit: "kN" };

/// Maximum number of conditions with separate colours.
const MOST_CONDITIONS: usize = 8;

impl Coloring {
    fn new(conditions: &[Condition], load: f64) -> Self {
        match conditions.len() {
            0 | 1 => return Self::None,
            2..=MOST_CONDITIONS => return Self::Conditions,
            _ => {}
        }
        for of in [SPEED, LOAD] {
            let values = || conditions.iter().map(|condition| (of.value)(condition, load));
            let range = [
                values().fold(f64::INFINITY, f64::min),
                values().fold(f64::NEG_INFINITY, f64::max),
            ];
            if range[0] < range[1] {
                return Self::Number { of, range };
            }
        }
        Self::None
    }
}

impl<'a> Picture<'a> {
    fn new(report: &'a FitReport) -> Option<Self> {
        let points = || report.fit.points.iter();
        let places = || points().map(|point| report.curves.place(&point.data));
        let [low, high] = [places().fold(0.0, f64::min), places().fold(0.0, f64::max)];
        if !(low < high && low.is_finite() && high.is_finite()) {
            return None;
        }
        let margin = 0.03 * (high - low);
        let x = [
            if low < 0.0 { low - margin } else { -0.5 * margin },
            if high > 0.0 { high + margin } else { 0.5 * margin },
        ];
        let is_measured =
            |component: &Component| points().any(|point| point.data.component == *component);
        let components = [Component::Longitudinal, Component::Lateral];
        let components = components.into_iter().filter(is_measured).collect();
        let mut conditions: Vec<Condition> = Vec::new();
        for series in &report.curves.series {
            if !conditions.contains(&series.condition) {
                conditions.push(series.condition);
            }
        }
        let coloring = Coloring::new(&conditions, report.load);
        Some(Self { report, x, components, conditions, coloring })
    }

    fn place(&self, point: &FittedPoint) -> f64 {
        self.report.curves.place(&point.data)
    }

    fn color(&self, condition: &Condition) -> String {
        match &self.coloring {
            Coloring::None => BLUE.to_owned(),
            Coloring::Conditions => {
                let place = self.conditions.iter().position(|other| other == condition);
                color(place.unwrap_or(0) as f64 / (self.conditions.len() - 1) as f64)
            }
            Coloring::Number { of, range: [low, high] } => {
                color(((of.value)(condition, self.report.load) - low) / (high - low))
            }
        }
    }

    /// Squares mark lateral forces if there are both components.
    fn shape(&self, component: Component) -> Shape {
        let is_other = self.components.len() > 1 && component == Component::Lateral;
        if is_other { Shape::Square } else { Shape::Dot }
    }

    /// Legend entries: shapes of the marks, meaning of a line and a cross, and colours.
    fn entries(&self) -> Vec<Entry> {
        let own = if matches!(self.coloring, Coloring::None) { BLUE } else { INK };
        let mut entries = Vec::new();
        for component in &self.components {
            let text = if self.components.len() == 1 {
                "measured".to_owned()
            } else {
                format!("measured {}", ratio(*component))
            };
            entries.push(Entry::mark(self.shape(*component), fill(own), &text));
        }
        let series = &self.report.curves.series;
        if series.iter().any(|series| !series.curve.is_empty()) {
            entries.push(Entry::line(&curve_stroke(own), "fitted"));
        }
        if series.iter().any(|series| series.curve.is_empty()) {
            entries.push(Entry::mark(Shape::Cross, cross(), "fitted"));
        }
        let swatch =
            |color: &str, text| Entry { sample: Sample::Area(format!(r#"fill="{color}""#)), text };
        match &self.coloring {
            Coloring::None => {}
            Coloring::Conditions => {
                for condition in &self.conditions {
                    entries.push(swatch(&self.color(condition), self.name(condition)));
                }
            }
            Coloring::Number { of, range: [low, high] } => {
                for share in [0.0, 0.5, 1.0] {
                    let value = low + share * (high - low);
                    entries.push(swatch(&color(share), format!("{} {}", short(value), of.unit)));
                }
            }
        }
        entries
    }

    /// The part of a condition that distinguishes it from the others.
    fn name(&self, condition: &Condition) -> String {
        let motion = &condition.kinematics;
        let differs = |value: fn(&Condition) -> f64| {
            self.conditions.iter().any(|other| value(other) != value(condition))
        };
        let mut parts = Vec::new();
        if differs(|condition| condition.kinematics.speed) {
            parts.push(format!("{} m/s", short(motion.speed)));
        }
        if differs(|condition| condition.load.unwrap_or_default()) {
            let load = condition.load.unwrap_or(self.report.load);
            parts.push(format!("{} kN", short(load / 1e3)));
        }
        if differs(|condition| condition.kinematics.creepage_x) {
            parts.push(format!("$ξ$ = {}", short(motion.creepage_x)));
        }
        if differs(|condition| condition.kinematics.creepage_y) {
            parts.push(format!("$η$ = {}", short(motion.creepage_y)));
        }
        if differs(|condition| condition.kinematics.spin) {
            parts.push(format!("$φ$ = {} 1/m", short(motion.spin)));
        }
        parts.join(", ")
    }

    fn panels(&self) -> Vec<Panel> {
        let height = FORCES[usize::from(self.components.len() > 1)];
        let forces = self.components.iter().map(|component| self.forces(*component, height));
        forces.chain([self.residuals()]).collect()
    }

    /// Measured forces with the curves of the model.
    fn forces(&self, component: Component, height: f64) -> Panel {
        let label = format!("force on the rail {}", ratio(component));
        let mut panel = self.panel(&label, height, &[component], |point| point.data.force_ratio);
        let all = self.report.curves.series.iter();
        for series in all.filter(|series| series.component == component) {
            let curve = series.curve.iter();
            let points = curve.map(|p| [p.creepage, known(p.force_ratio)]).collect();
            let stroke = curve_stroke(&self.color(&series.condition));
            panel.curves.push(Curve::new(points, stroke, ""));
            if series.curve.is_empty() {
                let points = series.members.iter().map(|k| &self.report.fit.points[*k]);
                panel.marks.extend(points.map(|point| {
                    let at = [self.place(point), point.fitted];
                    Mark { at, shape: Shape::Cross, style: cross(), range: None }
                }));
            }
        }
        panel
    }

    fn residuals(&self) -> Panel {
        self.panel("measured \u{2212} fitted", RESIDUALS, &self.components, FittedPoint::residual)
    }

    /// A panel with a value of all points of some components.
    fn panel(
        &self,
        label: &str,
        height: f64,
        components: &[Component],
        value: impl Fn(&FittedPoint) -> f64,
    ) -> Panel {
        let mut points = Vec::new();
        let all = self.report.curves.series.iter();
        for series in all.filter(|series| components.contains(&series.component)) {
            for k in &series.members {
                let point = &self.report.fit.points[*k];
                let middle = value(point);
                let color = self.color(&series.condition);
                let deviation = point.data.standard_deviation.filter(|deviation| *deviation > 0.0);
                let range = deviation.map(|by| ([middle - by, middle + by], color.clone()));
                let (at, shape) = ([self.place(point), middle], self.shape(series.component));
                points.push(Mark { at, shape, style: fill(&color), range });
            }
        }
        Panel { marks: points, ..Panel::new(label, height, Vec::new()) }
    }
}

/// A force ratio in the markup of labels.
fn ratio(component: Component) -> &'static str {
    match component {
        Component::Longitudinal => "\u{2212}$F$_x/$N$",
        Component::Lateral => "\u{2212}$F$_y/$N$",
    }
}

/// A parameter with its interval, in the markup of labels.
fn result(estimate: &Estimate) -> String {
    let parameter = estimate.parameter;
    let (value, unit) = in_usual_unit(parameter, estimate.value);
    let half_width = estimate.half_width.map(|width| in_usual_unit(parameter, width).0);
    let [value, half_width] = with_uncertainty(value, half_width);
    let number = format!("{value} ± {half_width} {unit}").replace('-', "\u{2212}");
    format!("{} = {}", symbol(parameter.quantity().symbol()), number.trim_end())
}

/// A symbol such as `T_E` or `μ0` in the markup of labels.
fn symbol(text: &str) -> String {
    let (letter, index) = text.split_once('_').unwrap_or_else(|| {
        let end = text.find(|c: char| c.is_ascii_digit()).unwrap_or(text.len());
        text.split_at(end)
    });
    if index.is_empty() { format!("${letter}$") } else { format!("${letter}$_{{{index}}}") }
}

/// Colours from dark (0) to light (1), so that they also differ in greyscale.
fn color(share: f64) -> String {
    /// The light end of the palette is invisible on white.
    const LIGHTEST: f64 = 0.78;
    let level = LIGHTEST * share * (LEVELS - 1) as f64;
    paint(Palette::Mechanical, level.round() as usize)
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
