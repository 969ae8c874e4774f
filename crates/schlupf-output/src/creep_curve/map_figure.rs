//! Maps of creep curves: colours with labelled contours.

use schlupf::Status;
use schlupf::creep_curve::Abscissa;

use super::{Axis, CreepMap, CurveFamily};
use crate::figures::Drawing as Named;
use crate::figures::color::{ColorScale, Palette};
use crate::figures::frame::{Frame, TICK_SIZE};
use crate::figures::label::{self, Anchor, TextStyle};
use crate::figures::lattice::Lattice;
use crate::figures::marks::{self, HEADING};
use crate::figures::panels::{LEFT, WIDTH};
use crate::figures::svg::{Drawing, open_path};
use crate::figures::ticks::{Tick, round_ticks};
use crate::figures::units::{self, Unit};
use crate::report::Report;

/// Names of all possible figures.
pub(super) const NAMES: &[&str] = &["creep_map", "creep_map_creepage", "creep_map_temperature"];

/// The maps of a family.
pub(super) fn draw(family: &CurveFamily) -> Vec<Named> {
    let Some(map) = family.map() else { return Vec::new() };
    let is_of_peaks = family.over.len() == 2;
    let Some(creepage) = family.abscissa().map(Abscissa::quantity) else { return Vec::new() };
    let unit = if creepage.unit().is_empty() { "" } else { " (1/m)" };
    let symbol = format!("${}${unit}", creepage.symbol());
    let pictures = [
        Picture {
            name: NAMES[0],
            title: if is_of_peaks { "Largest adhesion" } else { "Adhesion" },
            label: "|$F$|/$N$".to_owned(),
            column: "traction_coefficient",
            palette: Palette::Mechanical,
        },
        Picture {
            name: NAMES[1],
            title: "Creepage of the largest adhesion",
            label: symbol,
            column: if is_of_peaks { creepage.name() } else { "" },
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

/// Shades between two contours.
const SHADES: f64 = 4.0;

/// Values that differ by less than this part of the largest are the same everywhere.
const FLAT: f64 = 1e-3;

const CONTOUR: [&str; 2] = [
    r##"fill="none" stroke="#ffffff" stroke-opacity="0.55" stroke-width="3""##,
    r##"fill="none" stroke="#222222" stroke-width="1.2" stroke-linejoin="round""##,
];

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
        drawing.begin_clip(&frame.area());
        fill(&mut drawing, &frame, &lattice, (&scale, &levels));
        lines(&mut drawing, &frame, &lattice, &levels);
        drawing.end_group();
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
    let is_varied = |field: &str| family.over.iter().any(|over| over == field);
    let mut parts = Vec::new();
    if let Some(point) = first.curve.points.first().filter(|_| !is_varied("kinematics.speed")) {
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

/// The colours, each over what lies below its upper limit.
fn fill(
    drawing: &mut Drawing,
    frame: &Frame,
    lattice: &Lattice,
    (scale, levels): (&ColorScale, &[Tick]),
) {
    let step = levels.windows(2).map(|pair| pair[1].value - pair[0].value).next();
    let shade = step.unwrap_or(scale.high - scale.low) / SHADES;
    let first = levels.first().map_or(scale.low, |tick| tick.value);
    // Limits of shades lie on contours.
    let lowest = ((scale.low - first) / shade).floor() as i64;
    let highest = ((scale.high - first) / shade).ceil() as i64;
    drawing.begin_group(r#"shape-rendering="crispEdges""#);
    for number in (lowest..=highest).rev() {
        let [below, above] = [number, number + 1].map(|number| first + number as f64 * shade);
        let color = scale.paint(0.5 * (below + above));
        let path = lattice.below(above).iter().fold(String::new(), |path, polygon| {
            let points: Vec<[f64; 2]> = polygon.iter().map(|at| frame.at(*at)).collect();
            path + &open_path(&points) + "z"
        });
        drawing.path(&path, &format!(r#"fill="{color}""#));
    }
    drawing.end_group();
}

/// A contour in units of the drawing.
struct Line {
    points: Vec<[f64; 2]>,
    level: usize,
}

/// The contours and their labels.
fn lines(drawing: &mut Drawing, frame: &Frame, lattice: &Lattice, levels: &[Tick]) {
    let mut lines = Vec::new();
    for (level, tick) in levels.iter().enumerate() {
        for chain in lattice.contour(tick.value) {
            let first = chain.points.first().copied().filter(|_| chain.is_closed);
            let points = chain.points.iter().copied().chain(first);
            lines.push(Line { points: points.map(|at| frame.at(at)).collect(), level });
        }
    }
    for stroke in CONTOUR {
        for line in &lines {
            drawing.path(&open_path(&line.points), stroke);
        }
    }
    let mut labels: Vec<[f64; 2]> = Vec::new();
    for line in &lines {
        if let Some((at, angle)) = label_place(line, &lines, &labels, frame) {
            draw_label(drawing, at, angle, &levels[line.level].label);
            labels.push(at);
        }
    }
}

/// Where on a line its label has most space, and the slope of the line there; `None` where there is
/// too little.
fn label_place(
    line: &Line,
    lines: &[Line],
    labels: &[[f64; 2]],
    frame: &Frame,
) -> Option<([f64; 2], f64)> {
    /// Distances from other contours, from labels and from the frame; half the length of a label.
    const FROM_LINES: f64 = 11.0;
    const FROM_LABELS: f64 = 60.0;
    const FROM_FRAME: f64 = 24.0;
    const HALF: f64 = 20.0;
    let distance = |one: [f64; 2], other: [f64; 2]| (one[0] - other[0]).hypot(one[1] - other[1]);
    let nearest = |at: [f64; 2], points: &mut dyn Iterator<Item = [f64; 2]>| {
        points.map(|point| distance(at, point)).fold(f64::INFINITY, f64::min)
    };
    let others: Vec<[f64; 2]> = lines
        .iter()
        .filter(|other| other.level != line.level)
        .flat_map(|other| other.points.iter().copied())
        .collect();
    let place = |k: usize| {
        let at = line.points[k];
        let before = (0..k).rev().map(|k| line.points[k]).find(|p| distance(at, *p) >= HALF)?;
        let after = line.points[k + 1..].iter().copied().find(|p| distance(at, *p) >= HALF)?;
        let is_inside = [0, 1].iter().all(|axis| {
            let along = at[*axis] - frame.corner[*axis];
            along > FROM_FRAME && along < frame.size[*axis] - FROM_FRAME
        });
        let space = nearest(at, &mut others.iter().copied()) - FROM_LINES;
        let from_labels = nearest(at, &mut labels.iter().copied()) - FROM_LABELS;
        if !is_inside || space < 0.0 || from_labels < 0.0 {
            return None;
        }
        let [dx, dy] = [after[0] - before[0], after[1] - before[1]];
        // Straight lines are easier to read; the text never stands on its head.
        let straight = distance(before, after) / (2.0 * HALF);
        let angle = if dx == 0.0 { 90.0 } else { (dy / dx).atan().to_degrees() };
        Some((space.min(40.0) * straight + 0.02 * from_labels.min(200.0), at, angle))
    };
    let places = (0..line.points.len()).step_by(2).filter_map(place);
    let best = places.max_by(|one, other| one.0.total_cmp(&other.0))?;
    Some((best.1, best.2))
}

fn draw_label(drawing: &mut Drawing, [x, y]: [f64; 2], angle: f64, text: &str) {
    // Centred on the line: the text turns about its own middle.
    let shift = 0.36 * TICK_SIZE;
    let (sin, cos) = angle.to_radians().sin_cos();
    let at = [x - shift * sin, y + shift * cos];
    let style = TextStyle { rotation: angle, ..TextStyle::new(TICK_SIZE, Anchor::Middle) };
    let inner = label::escape(text);
    let element = label::element(at, &style, &inner);
    let halo = r##"stroke="#ffffff" stroke-width="7" stroke-linejoin="round""##;
    drawing.begin_group(halo);
    drawing.shape(&element);
    drawing.end_group();
    drawing.shape(&element);
}
