//! Maps of creep curves: colours with labelled contours.

use schlupf::Status;
use schlupf::analysis::creep_curve::{Abscissa, VariedForce};

use super::{Axis, CreepMap, CurveFamily, figure};
use crate::output::figures::Drawing as Named;
use crate::output::figures::color::{ColorScale, Palette};
use crate::output::figures::lattice::Lattice;
use crate::output::figures::marks::{self, Heading};
use crate::output::figures::relief::Relief;
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

/// Values that differ by less than this part of the largest are the same everywhere.
const FLAT: f64 = 1e-3;

impl Picture {
    /// `None` where nothing is known, or all is zero.
    fn draw(&self, family: &CurveFamily, map: &CreepMap) -> Option<String> {
        let column = map.column(self.column)?;
        let number = |value: &Option<f64>| value.unwrap_or(f64::NAN);
        let rows = column.rows.iter().map(|row| row.iter().map(number).collect()).collect();
        let [x, y] = [&map.x, &map.y].map(InUnit::of);
        let mut lattice = Lattice { x: x.values, y: y.values, rows };
        let [low, high] = lattice.range().filter(|range| *range != [0.0; 2])?;
        let is_flat = high - low <= FLAT * high.abs().max(low.abs());
        let powers = if is_flat { None } else { powers(&mut lattice) };
        // Where all is the same there is one colour, and a bar that says which.
        let range = if is_flat { [low.min(0.0), high.max(0.0)] } else { [low, high] };
        let scale = ColorScale {
            powers: powers.is_some(),
            ..ColorScale::linear(self.palette, powers.unwrap_or(range))
        };
        let relief = Relief {
            lattice: &lattice,
            scale,
            levels: if is_flat { Vec::new() } else { scale.ticks(9) },
            labels: [&x.label, &y.label, &self.label],
            height: HEIGHT,
            crosses: Vec::new(),
        };
        let status = family.status();
        let heading = Heading::new(self.title, &family.title, conditions(family), status);
        let gaps = if status == Status::Converged { "" } else { "not converged at some points" };
        relief.page(&Heading { remark: gaps, ..heading })
    }
}

/// Takes logarithms of values that are positive and spread over decades, of which a linear scale
/// would show one; returns their range. Zero is as much as the least colour.
fn powers(lattice: &mut Lattice) -> Option<[f64; 2]> {
    /// Ratio of the largest value to the median from which on, and decades shown at most.
    const SPREAD: f64 = 20.0;
    const MOST: f64 = 4.0;
    let mut values: Vec<f64> = lattice.rows.concat();
    values.retain(|value| value.is_finite());
    values.sort_unstable_by(f64::total_cmp);
    let [least, median, largest] =
        [*values.first()?, *values.get(values.len() / 2)?, *values.last()?];
    if least < 0.0 || largest < SPREAD * median {
        return None;
    }
    let high = largest.log10();
    let positive = values.into_iter().find(|value| *value > 0.0)?;
    let low = positive.log10().max(high - MOST);
    for value in lattice.rows.iter_mut().flatten().filter(|value| !value.is_nan()) {
        *value = value.log10().max(low);
    }
    Some([low, high])
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
            field => &super::words(field),
        };
        let label =
            if symbol.is_empty() { label.to_owned() } else { format!("{label} ({symbol})") };
        Self { values: axis.values.iter().map(|value| value / size).collect(), label }
    }
}

/// What all curves have in common.
fn conditions(family: &CurveFamily) -> String {
    let mut parts = figure::conditions(family);
    let first = family.members.first().filter(|_| family.over.len() == 2);
    if let (Some(first), Some(abscissa)) = (first, family.abscissa()) {
        let [start, end] = first.curve.path.range().map(marks::short);
        parts.push(format!("${}$ from {start} to {end}", abscissa.quantity().symbol()));
    }
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use super::{Lattice, powers};

    #[test]
    fn only_values_over_decades_have_logarithmic_colours() {
        let of = |rows: Vec<Vec<f64>>| Lattice { x: Vec::new(), y: Vec::new(), rows };
        let mut wide = of(vec![vec![0.0, 1e-3, 2e-3], vec![1e-2, f64::NAN, 1.0]]);
        assert_eq!(powers(&mut wide), Some([-3.0, 0.0]));
        assert_eq!(wide.rows[0][..2], [-3.0; 2]);
        assert!(wide.rows[1][1].is_nan());
        let mut even = of(vec![vec![0.0, 0.1, 0.2], vec![0.3, 0.4, 0.5]]);
        assert_eq!(powers(&mut even), None);
        assert_eq!(even.rows[0], [0.0, 0.1, 0.2]);
    }
}
