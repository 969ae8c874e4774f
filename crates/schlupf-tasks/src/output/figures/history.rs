//! Forces and temperature against the distance rolled, or against time if the speed varies.

use schlupf::solution::Instant;

use super::color::{BLUE, GREEN, INK, VERMILION};
use super::marks::Heading;
use super::panels::{self, Curve, Panel, Stack, known};
use super::patch::Patch;
use super::units::{self, Unit};

/// Forces on the rail, what varies of load, speed and creepages, and the largest temperature rise.
pub(crate) fn draw(patch: &Patch) -> String {
    let history = &patch.solution.history;
    let axis = Axis::of(history);
    let places: Vec<f64> = history.iter().map(axis.place).collect();
    let start = places.first().copied().filter(|_| axis.has_own_start).unwrap_or(0.0);
    let end = places.last().copied().unwrap_or(0.0);
    let unit = units::pick(axis.units, start.abs().max(end.abs()));
    let x: Vec<f64> = places.iter().map(|place| place / unit.size).collect();
    let mut panels = vec![forces(history, &x)];
    panels.extend(load(history, &x));
    panels.extend(speed(history, &x));
    panels.extend(creepages(history, &x));
    panels.extend(temperature(history, &x));
    let range = [start, end].map(|place| place / unit.size);
    let is_range = range[1] > range[0] && range.iter().all(|end| end.is_finite());
    let range = if is_range { range } else { [0.0, 1.0] };
    let label = format!("{} ({})", axis.label, unit.symbol);
    // It covers both rest and rolling.
    let heading = Heading { is_rolling: false, ..Heading::of(patch, axis.title) };
    panels::page(&heading, &[Stack::over(range, label, panels)])
}

/// What the curves are drawn against.
struct Axis {
    title: &'static str,
    label: &'static str,
    units: &'static [Unit],
    place: fn(&Instant) -> f64,
    /// Whether it need not begin at zero.
    has_own_start: bool,
}

impl Axis {
    /// Time if anything varies over it; otherwise the distance, with which the contact settles.
    fn of(history: &[Instant]) -> Self {
        let given: [fn(&Instant) -> f64; 5] = [
            |instant| instant.kinematics.speed,
            |instant| instant.kinematics.creepage_x,
            |instant| instant.kinematics.creepage_y,
            |instant| instant.kinematics.spin,
            |instant| instant.load,
        ];
        if given.into_iter().any(|value| varies(history, value)) {
            return Self {
                title: "Forces over time",
                label: "time",
                units: units::TIME,
                place: |instant| instant.time,
                has_own_start: true,
            };
        }
        Self {
            title: "Forces over the rolled distance",
            label: "rolled distance",
            units: units::DISTANCE,
            place: |instant| instant.distance,
            has_own_start: false,
        }
    }
}

fn varies(history: &[Instant], value: fn(&Instant) -> f64) -> bool {
    let first = history.first().map(value);
    history.iter().any(|instant| Some(value(instant)) != first)
}

fn points(x: &[f64], history: &[Instant], value: impl Fn(&Instant) -> f64) -> Vec<[f64; 2]> {
    x.iter().zip(history).map(|(x, instant)| [*x, value(instant)]).collect()
}

fn forces(history: &[Instant], x: &[f64]) -> Panel {
    let largest = history.iter().map(|instant| instant.force.x.hypot(instant.force.y));
    let unit = units::pick(units::FORCE, largest.filter(|f| f.is_finite()).fold(0.0, f64::max));
    let curves = vec![
        Curve::solid(
            points(x, history, |instant| -instant.force.x / unit.size),
            BLUE,
            "\u{2212}$F$_x",
        ),
        Curve::solid(
            points(x, history, |instant| -instant.force.y / unit.size),
            VERMILION,
            "\u{2212}$F$_y",
        ),
    ];
    Panel::of_components(format!("force on the rail ({})", unit.symbol), 260.0, curves)
}

/// `None` if it is constant.
fn load(history: &[Instant], x: &[f64]) -> Option<Panel> {
    let largest = history.iter().map(|instant| instant.load).fold(0.0, f64::max);
    let unit = units::pick(units::FORCE, largest);
    let points = points(x, history, |instant| instant.load / unit.size);
    let is_shown = varies(history, |instant| instant.load);
    is_shown.then(|| condition(format!("load $N$ ({})", unit.symbol), points))
}

/// `None` if it is constant, apart from a shift at rest.
fn speed(history: &[Instant], x: &[f64]) -> Option<Panel> {
    let (history, x) = rolling(history, x);
    let points = points(x, history, |instant| instant.kinematics.speed);
    let is_shown = varies(history, |instant| instant.kinematics.speed);
    is_shown.then(|| condition("speed $v$_0 (m/s)".to_owned(), points))
}

/// A panel of what is prescribed.
fn condition(label: String, points: Vec<[f64; 2]>) -> Panel {
    Panel::new(label, 150.0, vec![Curve::solid(points, INK, "")])
}

/// What comes after a shift at rest.
fn rolling<'a>(history: &'a [Instant], x: &'a [f64]) -> (&'a [Instant], &'a [f64]) {
    let at_rest = history.iter().take_while(|instant| instant.kinematics.speed == 0.0).count();
    (&history[at_rest..], &x[at_rest..])
}

/// `None` if they are constant. A shift at rest has none.
fn creepages(history: &[Instant], x: &[f64]) -> Option<Panel> {
    let (history, x) = rolling(history, x);
    let first = history.first()?.kinematics;
    let changes = history.iter().any(|instant| {
        instant.kinematics.creepage_x != first.creepage_x
            || instant.kinematics.creepage_y != first.creepage_y
    });
    let curves = vec![
        Curve::solid(points(x, history, |instant| instant.kinematics.creepage_x), BLUE, "$ξ$"),
        Curve::solid(points(x, history, |instant| instant.kinematics.creepage_y), VERMILION, "$η$"),
    ];
    changes.then(|| Panel::of_components("creepage".to_owned(), 150.0, curves))
}

/// `None` if there is no heat.
fn temperature(history: &[Instant], x: &[f64]) -> Option<Panel> {
    let hot = history.iter().any(|instant| instant.max_rise.is_some_and(|rise| rise != 0.0));
    let curves =
        vec![Curve::solid(points(x, history, |instant| known(instant.max_rise)), GREEN, "")];
    hot.then(|| Panel::new("largest rise (K)", 180.0, curves))
}
