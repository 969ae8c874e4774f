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
    let panels = ROWS.iter().filter_map(|row| row.panel(history, &x)).collect();
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

/// A panel: what it shows, and when.
struct Row {
    label: &'static str,
    units: &'static [Unit],
    height: f64,
    curves: &'static [Line],
    shown: Shown,
}

/// A number of an instant, its colour and its name.
type Line = (fn(&Instant) -> f64, &'static str, &'static str);

#[derive(PartialEq)]
enum Shown {
    /// Always.
    Always,
    /// If it varies: the load.
    Varying,
    /// If it varies after a shift at rest, which has none.
    VaryingInRolling,
    /// If it is not zero.
    NonZero,
}

const ROWS: [Row; 5] = [
    Row {
        label: "force on the rail",
        units: units::FORCE,
        height: 260.0,
        curves: &[
            (|instant| -instant.force.x, BLUE, "\u{2212}$F$_x"),
            (|instant| -instant.force.y, VERMILION, "\u{2212}$F$_y"),
        ],
        shown: Shown::Always,
    },
    Row {
        label: "load $N$",
        units: units::FORCE,
        height: 150.0,
        curves: &[(|instant| instant.load, INK, "")],
        shown: Shown::Varying,
    },
    Row {
        label: "speed $v$_0",
        units: &[Unit { size: 1.0, symbol: "m/s" }],
        height: 150.0,
        curves: &[(|instant| instant.kinematics.speed, INK, "")],
        shown: Shown::VaryingInRolling,
    },
    Row {
        label: "creepage",
        units: &[],
        height: 150.0,
        curves: &[
            (|instant| instant.kinematics.creepage_x, BLUE, "$ξ$"),
            (|instant| instant.kinematics.creepage_y, VERMILION, "$η$"),
        ],
        shown: Shown::VaryingInRolling,
    },
    Row {
        label: "largest rise",
        units: units::TEMPERATURE_RISE,
        height: 180.0,
        curves: &[(|instant| known(instant.max_rise), GREEN, "")],
        shown: Shown::NonZero,
    },
];

impl Row {
    /// `None` if it is not shown.
    fn panel(&self, history: &[Instant], x: &[f64]) -> Option<Panel> {
        let is_at_rest = |instant: &&Instant| instant.kinematics.speed == 0.0;
        let skipped = match self.shown {
            Shown::VaryingInRolling => history.iter().take_while(is_at_rest).count(),
            _ => 0,
        };
        let (history, x) = (&history[skipped..], &x[skipped..]);
        let values = self.curves.iter().flat_map(|line| history.iter().map(line.0));
        let largest = values.map(f64::abs).filter(|v| v.is_finite()).fold(0.0, f64::max);
        let is_shown = match self.shown {
            Shown::Always => true,
            Shown::NonZero => largest > 0.0,
            _ => self.curves.iter().any(|line| varies(history, line.0)),
        };
        let unit = units::pick(self.units, largest);
        let curve = |(value, color, text): &Line| {
            let points = x.iter().zip(history);
            let points = points.map(|(x, instant)| [*x, value(instant) / unit.size]);
            Curve::solid(points.collect(), color, text)
        };
        let curves = self.curves.iter().map(curve).collect();
        let label = match unit.symbol {
            "" => self.label.to_owned(),
            symbol => format!("{} ({symbol})", self.label),
        };
        is_shown.then(|| Panel::of_components(label, self.height, curves))
    }
}
