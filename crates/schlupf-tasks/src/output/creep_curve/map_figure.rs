//! Maps of creep curves: colours with labelled contours.

use schlupf::Status;
use schlupf::creep_curve::{Abscissa, VariedForce};
use schlupf_case::field;

use super::{Axis, CreepMap, CurveFamily};
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{ColorScale, Palette};
use crate::output::figures::frame::Frame;
use crate::output::figures::lattice::Lattice;
use crate::output::figures::marks::{self, HEADING};
use crate::output::figures::panels::{LEFT, WIDTH};
use crate::output::figures::relief;
use crate::output::figures::svg::Drawing;
use crate::output::figures::ticks::round_ticks;
use crate::output::figures::units::{self, Unit};
use crate::output::report::Report;

/// Names of all possible figures.
pub(super) const NAMES: &[&str] = &["creep_map", "creep_map_creepage", "creep_map_temperature"];

/// The maps of a family.
pub(super) fn draw(family: &CurveFamily) -> Vec<Named> {
    let Some(map) = family.map() else { return Vec::new() };
    let is_of_peaks = family.over.len() == 2;
    let force = family.force().map(VariedForce::creepage);
    let Some(creepage) = force.or(family.abscissa().map(Abscissa::quantity)) else {
        return Vec::new();
    };
    let unit = if creepage.unit().is_empty() { "" } else { " (1/m)" };
    let symbol = format!("${}${unit}", creepage.symbol());
    let pictures = [
        Picture {
            name: NAMES[0],
            title: if is_of_peaks { "Largest adhesion" } else { "Adhesion" },
            label: "|$F$|/$N$".to_owned(),
            // A prescribed force needs no map.
            column: if force.is_some() { "" } else { "traction_coefficient" },
            palette: Palette::Mechanical,
        },
        Picture {
            name: NAMES[1],
            title: if is_of_peaks { "Creepage of the largest adhesion" } else { "Creepage" },
            label: symbol,
            column: if is_of_peaks || force.is_some() { creepage.name() } else { "" },
            palette: Palette::Mechanical,
        },
        Picture {
            name: NAMES[2],
            title: "Largest temperature rise",
            label: "rise (K)".to_owned(),
            column: "max_rise",
            palette: Palette::Thermal,
        },
    ];
    let drawn = pictures.iter().filter_map(|picture| {
        let svg = picture.draw(family, &map)?;
        Some((picture.name.to_owned(), svg))
    });
    drawn.collect()
}

/// A map of one quantity.
struct Picture {
    name: &'static str,
    title: &'static str,
    label: String,
    column: &'static str,
    palette: Palette,
}

/// Height of the plot area.
const HEIGHT: f64 = 440.0;

/// Space to the right of the plot area, for the colour bar.
const BAR: f64 = 150.0;

/// Values that differ by less than this part of the largest are the same everywhere.
const FLAT: f64 = 1e-3;

impl Picture {
    /// `None` where nothing is known, or all is zero.
    fn draw(&self, family: &CurveFamily, map: &CreepMap) -> Option<String> {
        let column = map.column(self.column)?;
        let number = |value: &Option<f64>| value.unwrap_or(f64::NAN);
        let rows = column.rows.iter().map(|row| row.iter().map(number).collect()).collect();
        let [x, y] = [&map.x, &map.y].map(InUnit::of);
        let coarse = Lattice { x: x.values, y: y.values, rows };
        let [low, high] = coarse.range().filter(|range| *range != [0.0; 2])?;
        let lattice = coarse.refined();
        let size = [WIDTH - LEFT - BAR, HEIGHT];
        let corner = [LEFT, HEADING + 20.0];
        let frame = Frame { corner, size, x: ends(&coarse.x)?, y: ends(&coarse.y)? };
        let mut drawing = Drawing::new(WIDTH, frame.bottom() + 66.0);
        let gaps = "not converged at some points";
        let remark = if family.status() == Status::Converged { "" } else { gaps };
        let about = conditions(family);
        marks::title_block(&mut drawing, self.title, [&family.title, &about], remark);
        let is_flat = high - low <= FLAT * high.abs().max(low.abs());
        let levels = if is_flat { Vec::new() } else { round_ticks(low, high, 9) };
        // One colour, and a bar that says which.
        let [low, high] = if is_flat { [low.min(0.0), high.max(0.0)] } else { [low, high] };
        let scale = ColorScale { palette: self.palette, low, high };
        relief::draw(&mut drawing, &frame, &lattice, (&scale, &levels));
        frame.draw_vertical(&mut drawing, &y.label);
        frame.draw_horizontal(&mut drawing, &x.label);
        let bar = [frame.right() + 30.0, corner[1] + 28.0];
        marks::color_bar(&mut drawing, bar, HEIGHT - 28.0, &scale, &self.label);
        Some(drawing.finish())
    }
}

/// The range of an axis; `None` if it has none.
fn ends(values: &[f64]) -> Option<[f64; 2]> {
    let ends = [*values.first()?, *values.last()?];
    (ends[1] > ends[0] && ends.iter().all(|end| end.is_finite())).then_some(ends)
}

/// An axis in the unit of a figure.
struct InUnit {
    values: Vec<f64>,
    /// Name and unit.
    label: String,
}

impl InUnit {
    fn of(axis: &Axis) -> Self {
        let units = match axis.unit {
            "N" => units::FORCE,
            "Pa" => units::PRESSURE,
            "m" => units::DISTANCE,
            symbol => &[Unit { size: 1.0, symbol }],
        };
        let largest = axis.values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let Unit { size, symbol } = units::pick(units, largest);
        let label = match axis.name.as_str() {
            "creepage_x" => "longitudinal creepage $ξ$",
            "creepage_y" => "lateral creepage $η$",
            "spin" => "spin creepage $φ$",
            "creepage" => "creepage $ν$",
            "force_x" => "longitudinal force on the wheel $F$_x",
            "force_over_load" => "traction coefficient \u{2212}$F$_x/$N$",
            "force_y" => "lateral force on the wheel $F$_y",
            "moment_z" => "moment on the wheel $M$_z",
            field => &field
                .trim_start_matches("kinematics.")
                .trim_start_matches("normal.")
                // An underscore is markup.
                .replace(['.', '_'], " "),
        };
        let label =
            if symbol.is_empty() { label.to_owned() } else { format!("{label} ({symbol})") };
        Self { values: axis.values.iter().map(|value| value / size).collect(), label }
    }
}

/// What all curves have in common.
fn conditions(family: &CurveFamily) -> String {
    let Some(first) = family.members.first() else { return String::new() };
    let speed = field!("kinematics.speed");
    let is_varied = |field: &str| family.over.iter().any(|over| over == field);
    let mut parts = Vec::new();
    if let Some(point) = first.curve.points.first().filter(|_| !is_varied(&speed)) {
        parts.push(format!("$v$_0 = {} m/s", marks::short(point.kinematics.speed)));
    }
    let load = first.curve.normal.load;
    if family.members.iter().all(|member| member.curve.normal.load == load) {
        parts.push(format!("$N$ = {} kN", marks::short(load / 1e3)));
    }
    if family.over.len() == 2 {
        let [start, end] = first.curve.path.range().map(marks::short);
        if let Some(abscissa) = family.abscissa() {
            let name = abscissa.quantity().symbol();
            parts.push(format!("${name}$ from {start} to {end}"));
        }
    }
    parts.join(", ")
}
