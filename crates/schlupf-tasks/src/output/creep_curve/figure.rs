//! Creep curves: force on the rail over load, moment and temperature rise against creepage; or
//! creepage against a prescribed force.

use schlupf::analysis::creep_curve::{Abscissa, CreepCurve, Point, VariedForce};
use schlupf::solution::Resultant;
use schlupf::{Quantity, Status};

use super::{CurveFamily, FieldValue, Member, words};
use crate::output::figures::color;
use crate::output::figures::color::{INK, MUTED};
use crate::output::figures::frame::TICK_SIZE;
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::marks::{self, ALARM, Entry, Heading, Shape, short};
use crate::output::figures::panels::{self, Curve, Mark, Panel, RIGHT, Stack, WIDTH, known};
use crate::output::figures::smooth::smooth;
use crate::output::figures::svg::Drawing;
use crate::output::figures::units::{self, Unit};
use crate::output::report::Report;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(family: &CurveFamily) -> Option<String> {
    let picture = Picture::new(family)?;
    let stack = Stack::over(picture.x, picture.axis(), picture.panels());
    let least = picture.legend_height() + 16.0;
    let (mut drawing, top) = panels::lay_out(&picture.heading(), &[stack], picture.right(), least);
    picture.legend(&mut drawing, [picture.right() + 22.0, top]);
    Some(drawing.finish())
}

/// A component of the force: its direction in the contact plane, name, and the dash pattern of its
/// curves.
struct Component {
    direction: [f64; 2],
    name: &'static str,
    remark: &'static str,
    dashes: &'static str,
}

impl Component {
    /// The component on the rail.
    fn of(&self, force: &Resultant) -> f64 {
        -(force.x * self.direction[0] + force.y * self.direction[1])
    }
}

/// Contents and abscissa of the figure.
struct Picture<'a> {
    family: &'a CurveFamily,
    along: Along,
    /// Range of the abscissa.
    x: [f64; 2],
    /// Unit of the abscissa.
    unit: Unit,
    /// Colour of each member.
    colors: Vec<String>,
    /// Whether each member is a line among bent curves.
    are_lines: Vec<bool>,
    /// The main component of the force, and the other one if it is visible.
    components: Vec<Component>,
}

/// What varies.
#[derive(Clone, Copy, PartialEq)]
enum Along {
    Creepage(Abscissa),
    Force(VariedForce),
}

/// A component below this fraction of the largest force is invisible.
const INVISIBLE: f64 = 0.01;

/// Names of the axes of creepages.
const LONGITUDINAL: &str = "longitudinal creepage $ξ$";
const LATERAL: &str = "lateral creepage $η$";
const SPIN: &str = "spin creepage $φ$ (1/m)";

/// Name of the axis of an abscissa.
pub(in crate::output) fn axis(abscissa: Abscissa) -> String {
    let name = match abscissa {
        Abscissa::CreepageX => LONGITUDINAL,
        Abscissa::CreepageY => LATERAL,
        Abscissa::Spin => SPIN,
        Abscissa::Total { direction } => {
            let degrees = short(direction.to_degrees());
            return format!("creepage $ν$ at {degrees}° to the rolling direction");
        }
    };
    name.to_owned()
}

/// Width of the legend of the members.
const LEGEND: f64 = 170.0;

/// Spacing of its entries.
const LEGEND_ROW: f64 = 24.0;

impl<'a> Picture<'a> {
    fn new(family: &'a CurveFamily) -> Option<Self> {
        let creepage = family.abscissa().map(Along::Creepage);
        let along = creepage.or(family.force().map(Along::Force))?;
        let range = family.members.first()?.curve.path.range();
        let largest = range[0].abs().max(range[1].abs());
        let unit = match along {
            Along::Force(VariedForce::X | VariedForce::Y) => units::pick(units::FORCE, largest),
            _ => Unit { size: 1.0, symbol: "" },
        };
        let [from, to] = range.map(|end| end / unit.size);
        let x = [from.min(to), from.max(to)];
        let mut picture = Self {
            family,
            along,
            x,
            unit,
            colors: colors(family),
            are_lines: lines_among_curves(family),
            components: vec![],
        };
        if !(x[1] > x[0] && x[0].is_finite() && x[1].is_finite()) {
            return None;
        }
        let Along::Creepage(abscissa) = along else { return Some(picture) };
        let [main, other] = components(abscissa);
        let largest = |component: &Component| picture.largest(|point| component.of(&point.force));
        let [of_main, of_other] = [largest(&main), largest(&other)];
        if of_main.max(of_other) == 0.0 {
            return None;
        }
        let is_seen = of_other > INVISIBLE * of_main;
        picture.components.push(main);
        picture.components.extend(is_seen.then_some(other));
        Some(picture)
    }

    /// The largest magnitude of a finite value.
    fn largest(&self, value: impl Fn(&Point) -> f64) -> f64 {
        points(self.family)
            .map(value)
            .filter(|v| v.is_finite())
            .fold(0.0, |most, v| most.max(v.abs()))
    }

    fn is_family(&self) -> bool {
        !self.family.over.is_empty()
    }

    /// Right end of the plot areas.
    fn right(&self) -> f64 {
        WIDTH - if self.is_family() { LEGEND + 2.0 * RIGHT } else { RIGHT }
    }

    fn heading(&self) -> Heading<'a> {
        let title = match (self.along, self.family.members.len()) {
            (Along::Force(_), _) => "Creepage over force",
            (_, 1) => "Creep curve",
            _ => "Creep curves",
        };
        let status = self.family.status();
        let remark = if status == Status::Converged { "" } else { "not converged at some points" };
        let heading =
            Heading::new(title, &self.family.title, conditions(self.family).join(", "), status);
        Heading { remark, ..heading }
    }

    fn axis(&self) -> String {
        let unit = self.unit.symbol;
        match self.along {
            Along::Creepage(abscissa) => axis(abscissa),
            Along::Force(VariedForce::X) => {
                format!("longitudinal force on the wheel $F$_x ({unit})")
            }
            Along::Force(VariedForce::OverLoad) => {
                "traction coefficient \u{2212}$F$_x/$N$".to_owned()
            }
            Along::Force(VariedForce::Y) => format!("lateral force on the wheel $F$_y ({unit})"),
            Along::Force(VariedForce::MomentZ) => "moment on the wheel $M$_z (N m)".to_owned(),
        }
    }

    fn panels(&self) -> Vec<Panel> {
        let mut panels = match self.along {
            Along::Creepage(_) => vec![self.forces()],
            Along::Force(force) => self.creepages(force),
        };
        if self.along != Along::Force(VariedForce::MomentZ) {
            panels.extend(self.moments());
        }
        panels.extend(self.temperatures());
        panels
    }

    /// The creepage that a force needs, and others that are found with it.
    fn creepages(&self, force: VariedForce) -> Vec<Panel> {
        type Creepage = fn(&Point) -> f64;
        let all: [(Quantity, &str, Creepage); 3] = [
            (Quantity::CreepageX, LONGITUDINAL, |point| point.kinematics.creepage_x),
            (Quantity::CreepageY, LATERAL, |point| point.kinematics.creepage_y),
            (Quantity::Spin, SPIN, |point| point.kinematics.spin),
        ];
        let is_own = |of: Quantity| of == force.creepage();
        let is_found = |value: Creepage| {
            let is_constant = |curve: &CreepCurve| {
                curve.points.windows(2).all(|pair| value(&pair[0]) == value(&pair[1]))
            };
            self.family.members.iter().any(|member| !is_constant(&member.curve))
        };
        let shown = all.iter().filter(|(of, _, value)| is_own(*of) || is_found(*value));
        let panels = shown.map(|(of, label, value)| {
            let mut panel = self.panel(label, *value);
            if is_own(*of) {
                panel.height = 330.0;
                explain(&mut panel, false);
            }
            (!is_own(*of), panel)
        });
        let mut panels: Vec<(bool, Panel)> = panels.collect();
        panels.sort_by_key(|(is_other, _)| *is_other);
        panels.into_iter().map(|(_, panel)| panel).collect()
    }

    fn forces(&self) -> Panel {
        let main = &self.components[0];
        let label = match self.components.len() {
            1 => format!("force on the rail {}/$N$", main.name),
            _ => "force on the rail over load".to_owned(),
        };
        let mut curves = Vec::new();
        let mut entries = Vec::new();
        for component in &self.components {
            for (k, (member, color)) in self.members().enumerate() {
                let load = member.curve.normal.load;
                let value = |force: &Resultant| component.of(force) / load;
                let points = with_maxima(&member.curve, value);
                curves.push(self.curve(k, &points, color, component.dashes));
            }
            if self.components.len() > 1 {
                let color = if self.colors.len() > 1 { INK } else { &self.colors[0] };
                let text = format!("{}/$N${}", component.name, component.remark);
                entries.push(Entry::line(&stroke(color, component.dashes), &text));
            }
        }
        let of_main =
            |member: &Member, force: &Resultant| main.of(force) / member.curve.normal.load;
        let mut marks = self.maxima(&curves);
        marks.extend(self.failures(|member, point| of_main(member, &point.force)));
        let mut panel = Panel { marks, entries, ..Panel::new(label, 330.0, curves) };
        let has_slope = self.add_tangents(&mut panel, of_main);
        explain(&mut panel, has_slope);
        panel
    }

    /// The members with their colours.
    fn members(&self) -> impl Iterator<Item = (&'a Member, &String)> {
        self.family.members.iter().zip(&self.colors)
    }

    /// The curve of a member, free if it is a line among bent ones. What lies between given points
    /// may be anything, which a smooth curve would make up.
    fn curve(&self, member: usize, points: &[[f64; 2]], color: &str, dashes: &str) -> Curve {
        let is_free = self.are_lines.get(member).copied().unwrap_or_default();
        let is_given = self.family.spacing == CurveFamily::GIVEN;
        let points = if is_given { points.to_vec() } else { smooth(points) };
        Curve { is_free, ..Curve::new(points, stroke(color, dashes), "") }
    }

    /// Adds the initial-slope lines of a quantity computed from the force; returns whether there
    /// are any.
    fn add_tangents(&self, panel: &mut Panel, value: impl Fn(&Member, &Resultant) -> f64) -> bool {
        let count = panel.curves.len();
        let tangent = |(member, color): (&Member, &String)| {
            let slope = value(member, &member.curve.initial_slope.as_ref()?.force);
            let zero = member.curve.points.iter().find(|point| point.abscissa == 0.0)?;
            let start = value(member, &zero.force);
            let points = self.x.map(|x| [x, start + slope * x]).to_vec();
            let curve = Curve::new(points, tangent_stroke(color), "");
            let is_seen = start.is_finite() && slope.is_finite() && slope != 0.0;
            is_seen.then_some(Curve { is_free: true, ..curve })
        };
        panel.curves.splice(0..0, self.members().filter_map(tangent));
        panel.curves.len() > count
    }

    /// Marks on the curves of the main component: where full sliding sets in, the force is that of
    /// the curve, not the largest, from which it differs by up to a thousandth.
    fn maxima(&self, curves: &[Curve]) -> Vec<Mark> {
        let mut marks = Vec::new();
        for ((member, color), curve) in self.members().zip(curves) {
            for maximum in &member.curve.maxima {
                if let Some(at) = on_curve(curve, maximum.abscissa) {
                    let style = dot(color, maximum.is_saturated);
                    marks.push(Mark { at, shape: Shape::Dot, style, range: None });
                }
            }
        }
        marks
    }

    /// Points that did not converge.
    fn failures(&self, value: impl Fn(&Member, &Point) -> f64) -> Vec<Mark> {
        let mut crosses = Vec::new();
        for member in &self.family.members {
            let failed = member.curve.points.iter().filter(|p| p.status == Status::NotConverged);
            crosses.extend(failed.map(|point| {
                let at = [point.abscissa / self.unit.size, value(member, point)];
                Mark { at, shape: Shape::Cross, style: cross(), range: None }
            }));
        }
        crosses.retain(|cross| cross.at.iter().all(|c| c.is_finite()));
        crosses
    }

    /// `None` if there is no moment and none is requested.
    fn moments(&self) -> Option<Panel> {
        let is_over_spin = self.along == Along::Creepage(Abscissa::Spin);
        let is_seen = is_over_spin
            || self.largest(|point| point.normalised.moment_z.unwrap_or(0.0)) > INVISIBLE;
        let value = |point: &Point| -known(point.force.moment_z);
        let mut panel = self.panel("moment \u{2212}$M$_z (N m)", value);
        if is_over_spin {
            self.add_tangents(&mut panel, |_, force| -known(force.moment_z));
        }
        is_seen.then_some(panel)
    }

    /// `None` if there is no heat.
    fn temperatures(&self) -> Option<Panel> {
        let value = |point: &Point| known(point.max_rise);
        (self.largest(value) > 0.0).then(|| self.panel("largest temp. rise (K)", value))
    }

    fn panel(&self, label: &str, value: impl Fn(&Point) -> f64 + Copy) -> Panel {
        let curves = self.members().enumerate().map(|(k, (member, color))| {
            let points = member.curve.points.iter();
            let points = points.map(|point| [point.abscissa / self.unit.size, value(point)]);
            self.curve(k, &points.collect::<Vec<_>>(), color, "")
        });
        let marks = self.failures(|_, point| value(point));
        Panel { marks, ..Panel::new(label, 180.0, curves.collect()) }
    }

    fn legend_height(&self) -> f64 {
        if self.is_family() { LEGEND_ROW * self.family.members.len() as f64 } else { 0.0 }
    }

    /// The members with their colours, listed downwards from the upper left corner.
    fn legend(&self, drawing: &mut Drawing, [left, top]: [f64; 2]) {
        const SAMPLE: f64 = 26.0;
        let Some(field) = self.family.over.first() else { return };
        let space = (LEGEND + RIGHT) / TICK_SIZE;
        let style = TextStyle { color: MUTED, ..TextStyle::new(TICK_SIZE, Anchor::Start) };
        drawing.plain_text([left, top - 9.0], &style, &marks::shortened(&words(field), space));
        for (k, (member, color)) in self.members().enumerate() {
            let y = top + 18.0 + LEGEND_ROW * k as f64;
            let middle = y - 0.36 * TICK_SIZE;
            drawing.line([left, middle], [left + SAMPLE, middle], &stroke(color, ""));
            let style = TextStyle::new(TICK_SIZE, Anchor::Start);
            let text = member.values.first().map_or(String::new(), FieldValue::short);
            let text = marks::shortened(&text, space - (SAMPLE + 8.0) / TICK_SIZE);
            drawing.plain_text([left + SAMPLE + 8.0, y], &style, &text);
        }
    }
}

fn points(family: &CurveFamily) -> impl Iterator<Item = &Point> {
    family.members.iter().flat_map(|member| &member.curve.points)
}

/// Conditions shared by all points of all curves.
pub(super) fn conditions(family: &CurveFamily) -> Vec<String> {
    let constant = |value: fn(&Point) -> f64| {
        let first = points(family).next().map(value)?;
        points(family).all(|point| value(point) == first).then_some(first)
    };
    let creepage = |value: fn(&Point) -> f64| constant(value).filter(|value| *value != 0.0);
    let load = family.members.first().map(|member| member.curve.normal.load);
    let is_same = |load: &f64| family.members.iter().all(|m| m.curve.normal.load == *load);
    let parts = [
        creepage(|point| point.kinematics.creepage_x).map(|x| format!("$ξ$ = {}", short(x))),
        creepage(|point| point.kinematics.creepage_y).map(|y| format!("$η$ = {}", short(y))),
        creepage(|point| point.kinematics.spin).map(|s| format!("$φ$ = {} 1/m", short(s))),
        constant(|point| point.kinematics.speed).map(|v| format!("$v$_0 = {} m/s", short(v))),
        load.filter(is_same).map(|load| format!("$N$ = {} kN", short(load / 1e3))),
    ];
    parts.into_iter().flatten().collect()
}

/// Colours of the members: from dark to light for numbers, otherwise without an order.
fn colors(family: &CurveFamily) -> Vec<String> {
    let is_number = |value: &str| {
        let first = value.trim_start_matches(['"', '+', '-', '.']).chars().next();
        first.is_some_and(|character| character.is_ascii_digit())
    };
    let mut values = family.members.iter().filter_map(|member| member.values.first());
    let count = family.members.len();
    if values.any(|value| !is_number(&value.text)) {
        return color::unordered(count);
    }
    color::series(count)
}

/// Which members are lines while the forces of others are bounded by friction; none if all are.
fn lines_among_curves(family: &CurveFamily) -> Vec<bool> {
    let lines: Vec<bool> = family.members.iter().map(|member| is_line(&member.curve)).collect();
    if lines.contains(&false) { lines } else { vec![false; lines.len()] }
}

/// Whether all forces are those of the initial slope.
fn is_line(curve: &CreepCurve) -> bool {
    /// Of the largest force.
    const ROUNDING: f64 = 1e-9;
    let zero = curve.points.iter().find(|point| point.abscissa == 0.0);
    let (Some(slope), Some(zero)) = (&curve.initial_slope, zero) else { return false };
    let largest = curve.points.iter().map(|point| point.force.x.hypot(point.force.y));
    let least = ROUNDING * largest.fold(0.0, f64::max);
    curve.points.iter().all(|Point { abscissa, force, .. }| {
        let x = force.x - zero.force.x - slope.force.x * abscissa;
        let y = force.y - zero.force.y - slope.force.y * abscissa;
        x.hypot(y) <= least
    })
}

/// The component along the abscissa, and the transverse one.
fn components(abscissa: Abscissa) -> [Component; 2] {
    const DASHES: &str = "8 4";
    let x = |dashes| Component { direction: [1.0, 0.0], name: "\u{2212}$F$_x", remark: "", dashes };
    let y = |dashes| Component { direction: [0.0, 1.0], name: "\u{2212}$F$_y", remark: "", dashes };
    match abscissa {
        Abscissa::CreepageX => [x(""), y(DASHES)],
        Abscissa::CreepageY | Abscissa::Spin => [y(""), x(DASHES)],
        Abscissa::Total { direction } => {
            let (sin, cos) = direction.sin_cos();
            let along = Component {
                direction: [cos, sin],
                name: "\u{2212}$F$_ν",
                remark: " along $ν$",
                dashes: "",
            };
            let across = Component {
                direction: [-sin, cos],
                name: "\u{2212}$F$_n",
                remark: " across $ν$",
                dashes: DASHES,
            };
            [along, across]
        }
    }
}

fn stroke(color: &str, dashes: &str) -> String {
    panels::stroke(color, 2.2, dashes)
}

fn tangent_stroke(color: &str) -> String {
    panels::stroke(color, 1.0, "4 3")
}

fn cross() -> String {
    format!(r#"stroke="{ALARM}" stroke-width="2""#)
}

fn dot(color: &str, hollow: bool) -> String {
    if hollow {
        format!(r##"fill="#ffffff" stroke="{color}" stroke-width="2""##)
    } else {
        format!(r##"fill="{color}" stroke="#ffffff" stroke-width="1.2""##)
    }
}

/// Adds legend entries for the marks, and for the initial slope if it is drawn.
fn explain(panel: &mut Panel, has_slope: bool) {
    if has_slope {
        panel.entries.push(Entry::line(&tangent_stroke(INK), "initial slope"));
    }
    let has = |is: &dyn Fn(&Mark) -> bool| panel.marks.iter().any(is);
    let is_hollow = |mark: &Mark| mark.style.contains("#ffffff\" stroke=\"#");
    let seen = [
        (
            has(&|mark| mark.shape == Shape::Dot && !is_hollow(mark)),
            Shape::Dot,
            dot(INK, false),
            "maximum of |$F$|",
        ),
        (has(&is_hollow), Shape::Dot, dot(INK, true), "saturation"),
        (has(&|mark| mark.shape == Shape::Cross), Shape::Cross, cross(), "not converged"),
    ];
    let seen = seen.into_iter().filter(|(is_seen, ..)| *is_seen);
    panel.entries.extend(seen.map(|(_, shape, style, text)| Entry::mark(shape, style, text)));
}

/// A curve of the forces including its maxima, which are solutions, too.
fn with_maxima(curve: &CreepCurve, value: impl Fn(&Resultant) -> f64) -> Vec<[f64; 2]> {
    let points = curve.points.iter().map(|point| [point.abscissa, value(&point.force)]);
    let maxima = curve.maxima.iter().filter(|maximum| !maximum.is_saturated);
    let maxima = maxima.map(|maximum| [maximum.abscissa, value(&maximum.force)]);
    let mut points: Vec<[f64; 2]> = points.chain(maxima).collect();
    points.sort_unstable_by(|one, other| one[0].total_cmp(&other[0]));
    points.dedup_by_key(|point| point[0]);
    points
}

/// The point of a drawn curve at an abscissa.
fn on_curve(curve: &Curve, abscissa: f64) -> Option<[f64; 2]> {
    let on_piece = |[from, to]: [[f64; 2]; 2]| {
        let share = if to[0] > from[0] { (abscissa - from[0]) / (to[0] - from[0]) } else { 0.0 };
        let value = from[1] + share * (to[1] - from[1]);
        let is_here = (from[0]..=to[0]).contains(&abscissa) && value.is_finite();
        is_here.then_some([abscissa, value])
    };
    curve.points.windows(2).find_map(|pair| on_piece([pair[0], pair[1]]))
}
