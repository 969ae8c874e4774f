//! A section of the contact along the line y = 0, or along another one if there is no contact
//! there.

use std::f64::consts::PI;

use super::color::{BLUE, VERMILION};
use super::contour::{self, Sliding};
use super::marks::Heading;
use super::panels::{self, Axis, Curve, Panel, Stack};
use super::patch::Patch;
use super::quantity::scaled;
use super::run::{Run, runs};
use super::sampler::Sampler;
use super::units;

/// Traction on the rail with its bound, slip velocity, and temperature along y = 0.
pub(crate) fn draw(patch: &Patch) -> String {
    let cut = Cut::new(patch);
    let mut panels = vec![tractions(&cut)];
    panels.extend(slip(&cut));
    panels.extend(temperature(&cut));
    let (shaded, shading) = (cut.sticking(), "stick");
    let stack = Stack { shaded, shading, ..Stack::over(cut.axis(), "$x$ (mm)", panels) };
    panels::page(&Heading::of(patch, &cut.title()), &[stack])
}

/// The line, from the trailing to the leading edge.
struct Cut<'a> {
    patch: &'a Patch<'a>,
    /// In m.
    y: f64,
    /// In m.
    range: [f64; 2],
}

impl<'a> Cut<'a> {
    /// The line y = 0, or the nearest one that crosses the grid; if that passes between two parts
    /// of the patch, the one through the largest pressure.
    fn new(patch: &'a Patch<'a>) -> Self {
        let grid = &patch.fields().grid;
        let (first, last) = (grid.y(0), grid.y(grid.rows - 1));
        let a = patch.semi_axes()[0];
        let range =
            if patch.elliptic { [-a, a] } else { [grid.edge_x(0), grid.edge_x(grid.columns)] };
        let mut cut = Self { patch, y: 0.0_f64.clamp(first, last), range };
        let row = cut.row();
        if (0..grid.columns).all(|column| patch.cell(column, row).is_none()) {
            cut.y = row_of_largest_pressure(patch).map_or(cut.y, |row| grid.y(row));
        }
        cut
    }

    /// The row of the grid that it crosses.
    fn row(&self) -> usize {
        let grid = &self.patch.fields().grid;
        let row = ((self.y - grid.origin_y) / grid.spacing_y).max(0.0) as usize;
        row.min(grid.rows - 1)
    }

    fn title(&self) -> String {
        if self.y == 0.0 {
            return "Contact along the line $y$ = 0".to_owned();
        }
        format!("Contact along the line $y$ = {:.2} mm", self.y / 1e-3).replace('-', "\u{2212}")
    }

    /// Range of the axis, in mm.
    fn axis(&self) -> [f64; 2] {
        let margin = 0.03 * (self.range[1] - self.range[0]);
        [(self.range[0] - margin) / 1e-3, (self.range[1] + margin) / 1e-3]
    }

    /// Values (one for each contact cell) along the line against x in mm; NaN outside the contact.
    fn along(&self, values: &[f64], vanishes_at_rim: bool) -> Vec<[f64; 2]> {
        if self.patch.elliptic {
            self.across_ellipse(values, vanishes_at_rim)
        } else {
            self.through_cells(values, vanishes_at_rim)
        }
    }

    /// At points concentrated towards the ends, where a Hertzian field falls steeply.
    fn across_ellipse(&self, values: &[f64], vanishes_at_rim: bool) -> Vec<[f64; 2]> {
        const POINTS: u32 = 400;
        let sampler = Sampler::new(self.patch, values, vanishes_at_rim);
        let [a, b] = self.patch.semi_axes();
        (0..=POINTS)
            .map(|index| -(f64::from(index) / f64::from(POINTS) * PI).cos())
            .map(|x| [x * a / 1e-3, sampler.value([x, self.y / b])])
            .collect()
    }

    /// At the cells on the line and the edges of the patch.
    fn through_cells(&self, values: &[f64], vanishes_at_rim: bool) -> Vec<[f64; 2]> {
        let profile = |run: &Run| run.profile(self.patch, values, vanishes_at_rim);
        let runs = runs(self.patch, self.row());
        let profiles = runs.iter().map(profile).collect::<Vec<_>>();
        let points = profiles.join(&[f64::NAN; 2]);
        points.into_iter().map(|[x, value]| [x / 1e-3, value]).collect()
    }

    /// Ranges of x in which the line sticks, in mm.
    fn sticking(&self) -> Vec<[f64; 2]> {
        let Sliding { values, level } = contour::sliding(self.patch);
        let points = self.along(&values, false);
        let mut ranges: Vec<[f64; 2]> = Vec::new();
        let mut stuck = false;
        for pair in points.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let sticks = from[1] < level && to[1] < level;
            match ranges.last_mut() {
                Some(last) if sticks && stuck => last[1] = to[0],
                _ if sticks => ranges.push([from[0], to[0]]),
                _ => {}
            }
            stuck = sticks;
        }
        ranges
    }
}

fn row_of_largest_pressure(patch: &Patch) -> Option<usize> {
    let fields = patch.fields();
    let cells = fields.cell.iter().zip(&fields.pressure);
    cells.max_by(|(_, p), (_, q)| p.total_cmp(q)).map(|([_, row], _)| *row)
}

fn tractions(cut: &Cut) -> Panel {
    let fields = cut.patch.fields();
    let bound: Vec<f64> =
        fields.friction_coefficient.iter().zip(&fields.pressure).map(|(mu, p)| mu * p).collect();
    let (unit, bound) = scaled(&bound, units::PRESSURE);
    let on_rail =
        |traction: &[f64]| -> Vec<f64> { traction.iter().map(|t| -t / unit.size).collect() };
    let [x, y] = [on_rail(&fields.traction_x), on_rail(&fields.traction_y)];
    let largest = bound.iter().copied().fold(0.0, f64::max);
    let below = |values: &[f64], share: f64| values.iter().any(|v| *v < -share * largest);
    // Wide and pale, so that both are visible where the traction reaches it.
    let mut curves = vec![Curve::pale(cut.along(&bound, true), "bound $μ$ $p$_n")];
    if below(&x, 0.2) || below(&y, 0.2) {
        let negative: Vec<f64> = bound.iter().map(|b| -b).collect();
        curves.push(Curve::pale(cut.along(&negative, true), ""));
    }
    curves.push(Curve::solid(cut.along(&x, true), BLUE, "\u{2212}$t$_x"));
    curves.push(Curve::solid(cut.along(&y, true), VERMILION, "\u{2212}$t$_y"));
    Panel::of_components(format!("traction on the rail ({})", unit.symbol), 260.0, curves)
}

/// `None` if nothing slips, as in a shift at rest.
fn slip(cut: &Cut) -> Option<Panel> {
    let fields = cut.patch.fields();
    let largest = fields.slip_x.iter().chain(&fields.slip_y).copied();
    let largest = largest.filter(|v| v.is_finite()).fold(0.0, |most: f64, v| most.max(v.abs()));
    let unit = units::pick(units::VELOCITY, largest);
    let curve = |field: &[f64], color, text| {
        let values: Vec<f64> = field.iter().map(|v| v / unit.size).collect();
        Curve::solid(cut.along(&values, false), color, text)
    };
    let curves =
        vec![curve(&fields.slip_x, BLUE, "$v$_{sx}"), curve(&fields.slip_y, VERMILION, "$v$_{sy}")];
    let label = format!("slip velocity ({})", unit.symbol);
    (largest > 0.0).then(|| Panel::of_components(label, 150.0, curves))
}

/// `None` if there is no heat.
fn temperature(cut: &Cut) -> Option<Panel> {
    let fields = cut.patch.fields();
    let rises = [&fields.temperature_rise_wheel, &fields.temperature_rise_rail];
    let hot = |field: &Vec<f64>| field.iter().any(|t| *t != 0.0 && t.is_finite());
    let bulks = cut.patch.different_bulks();
    let above = |rise: &[f64], bulk: f64| -> Vec<[f64; 2]> {
        cut.along(rise, false).into_iter().map(|[x, rise]| [x, bulk + rise]).collect()
    };
    let [of_wheel, of_rail] = bulks.unwrap_or_default();
    let [wheel, rail] = [above(rises[0], of_wheel), above(rises[1], of_rail)];
    let [on_wheel, on_rail] = cut.patch.surface_temperatures();
    // Dashes on top, so that both are seen where they coincide.
    let curves = if on_wheel == on_rail {
        vec![Curve::solid(wheel, VERMILION, "wheel and rail")]
    } else {
        vec![Curve::solid(wheel, VERMILION, "wheel"), Curve::dashed(rail, BLUE, "rail")]
    };
    let (label, axis) = match bulks {
        None => ("temperature rise (K)", Axis::Zero),
        Some(_) => ("temperature (°C)", Axis::Own),
    };
    rises.into_iter().any(hot).then(|| Panel::new(label, 150.0, curves).with_axis(axis))
}
