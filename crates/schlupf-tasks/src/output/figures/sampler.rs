//! Interpolation of a field between the cells, for a smooth surface over the patch.

use super::patch::Patch;
use super::run::{extend, without_slivers};

/// A field that can be evaluated anywhere; positions are normalised by a and b.
#[derive(Debug)]
pub(crate) enum Sampler<'a> {
    /// A Hertzian patch: strips along rolling, stretched to the ellipse.
    Strips(Strips),
    /// Any other: linear between the cell centres; outside the contact the given value.
    Cells(&'a Patch<'a>, &'a [f64], f64),
}

impl<'a> Sampler<'a> {
    /// A sampler for values of the contact cells. A field that vanishes at the rim is one bounded
    /// by the pressure; see [`Quantity`](super::quantity::Quantity).
    pub(crate) fn new(patch: &'a Patch, values: &'a [f64], vanishes_at_rim: bool) -> Self {
        if patch.elliptic {
            Self::Strips(Strips::new(patch, values, vanishes_at_rim))
        } else {
            Self::Cells(patch, values, 0.0)
        }
    }

    /// The same with a value other than zero outside the contact.
    pub(crate) fn above(self, outside: f64) -> Self {
        match self {
            Self::Cells(patch, values, _) => Self::Cells(patch, values, outside),
            strips @ Self::Strips(_) => strips,
        }
    }

    /// The value at a position.
    pub(crate) fn value(&self, position: [f64; 2]) -> f64 {
        match self {
            Self::Strips(strips) => strips.value(position),
            Self::Cells(patch, values, outside) => {
                between_cells(patch, (values, *outside), position)
            }
        }
    }
}

/// Values along strips of the ellipse. A field that vanishes at the rim is stored as its ratio to
/// the pressure, which is smooth up to the rim, and multiplied by the exact pressure on evaluation.
#[derive(Debug)]
pub(crate) struct Strips {
    strips: Vec<Strip>,
    times_ellipsoid: bool,
}

#[derive(Debug)]
struct Strip {
    /// Normalised by b.
    y: f64,
    /// From the trailing to the leading edge: position along the chord from −1 to 1, and value.
    knots: Vec<[f64; 2]>,
}

impl Strips {
    fn new(patch: &Patch, values: &[f64], vanishes_at_rim: bool) -> Self {
        let pressure = &patch.fields().pressure;
        let peak = patch.solution.normal.peak_pressure;
        let ratios: Vec<f64> = if vanishes_at_rim {
            values.iter().zip(pressure).map(|(value, p)| value * peak / p).collect()
        } else {
            values.to_vec()
        };
        let rows = patch.fields().grid.rows;
        let strips = (0..rows).filter_map(|row| Strip::new(patch, &ratios, row)).collect();
        Self { strips, times_ellipsoid: vanishes_at_rim }
    }

    fn value(&self, position: [f64; 2]) -> f64 {
        let [x, y] = position;
        // Beyond the outermost strips the chord shrinks to a point; the strip must not shrink with
        // it.
        let outermost = |strip: &Strip| y.abs() > strip.y.abs() && strip.y * y > 0.0;
        let above = self.strips.partition_point(|strip| strip.y < y);
        let below = above.saturating_sub(1);
        let (Some(lower), Some(upper)) =
            (self.strips.get(below), self.strips.get(above).or(self.strips.last()))
        else {
            return 0.0;
        };
        let beyond = std::ptr::eq(lower, upper) || (above == 0 && outermost(lower));
        let chord = half_chord(if beyond { upper.y } else { y });
        let place = (x / chord).clamp(-1.0, 1.0);
        let mixed = mix([lower.y, lower.value(place)], [upper.y, upper.value(place)], y);
        if self.times_ellipsoid { mixed * Patch::ellipsoid(position) } else { mixed }
    }
}

impl Strip {
    fn new(patch: &Patch, values: &[f64], row: usize) -> Option<Self> {
        let fields = patch.fields();
        let [a, b] = patch.semi_axes();
        let cells: Vec<usize> =
            (0..fields.grid.columns).filter_map(|column| patch.cell(column, row)).collect();
        let cells = without_slivers(patch, &cells);
        let covered: f64 = cells.iter().map(|&cell| fields.covered[cell]).sum();
        let moment: f64 = cells.iter().map(|&cell| fields.covered[cell] * fields.y[cell]).sum();
        let y = moment / covered / b;
        let mut knots: Vec<[f64; 2]> = cells
            .iter()
            .map(|&cell| [fields.x[cell] / a / half_chord(y), values[cell]])
            .filter(|knot| knot.iter().all(|number| number.is_finite()))
            .collect();
        extend(&mut knots, [-1.0, 1.0]);
        (y.is_finite() && !knots.is_empty()).then_some(Self { y, knots })
    }

    /// Linear between the knots.
    fn value(&self, place: f64) -> f64 {
        let above = self.knots.partition_point(|knot| knot[0] < place);
        let upper = self.knots[above.min(self.knots.len() - 1)];
        let lower = self.knots[above.saturating_sub(1)];
        mix(lower, upper, place)
    }
}

/// Half-length of the ellipse's chord at y, normalised by a.
fn half_chord(y: f64) -> f64 {
    (1.0 - y * y).max(1e-12).sqrt()
}

/// Linear between two points, constant beyond them.
fn mix(lower: [f64; 2], upper: [f64; 2], at: f64) -> f64 {
    let width = upper[0] - lower[0];
    let share = if width > 0.0 { ((at - lower[0]) / width).clamp(0.0, 1.0) } else { 0.0 };
    lower[1] + share * (upper[1] - lower[1])
}

fn between_cells(patch: &Patch, (values, outside): (&[f64], f64), position: [f64; 2]) -> f64 {
    let grid = &patch.fields().grid;
    let [a, b] = patch.semi_axes();
    let u = (position[0] * a - grid.origin_x) / grid.spacing_x - 0.5;
    let v = (position[1] * b - grid.origin_y) / grid.spacing_y - 0.5;
    let (column, row) = (u.floor(), v.floor());
    let corner = |i: f64, j: f64| {
        if i < 0.0 || j < 0.0 {
            return outside;
        }
        patch.cell(i as usize, j as usize).map_or(outside, |cell| values[cell])
    };
    let along =
        |j: f64| mix([column, corner(column, j)], [column + 1.0, corner(column + 1.0, j)], u);
    mix([row, along(row)], [row + 1.0, along(row + 1.0)], v)
}
