//! The quantities that are shown over the patch.

use schlupf::columns::Record;
use schlupf::solution::Fields;

use super::color::{ColorScale, Palette};
use super::patch::Patch;
use super::units::{self, Unit};

/// A field over the contact cells, ready to be drawn.
#[derive(Debug)]
pub(crate) struct Quantity {
    /// Short name, for the file.
    pub name: &'static str,
    /// Title of its figure.
    pub title: String,
    /// Symbol and unit, in the markup of labels.
    pub label: String,
    /// Value in every contact cell, in the unit of the label.
    pub values: Vec<f64>,
    /// Whether it is bounded by the pressure and so vanishes at the rim of the patch. Such a field
    /// is a mean over the whole cell, of which only a part may be covered.
    pub vanishes_at_rim: bool,
    /// Whether it is dimensionless, one being the most it can be.
    pub normalised: bool,
    /// Colours.
    pub palette: Palette,
}

impl Quantity {
    /// Least and largest value, zero included.
    pub(crate) fn range(&self) -> [f64; 2] {
        let low = self.values.iter().copied().fold(0.0, f64::min);
        let high = self.values.iter().copied().fold(0.0, f64::max);
        [low, high]
    }

    /// A field of negative values turned over, so that a surface is a hill and not a pit that hides
    /// its own ground; the label says so.
    fn upright(mut self) -> Self {
        let [low, high] = self.range();
        if low < 0.0 && high < -STRAY * low {
            for value in &mut self.values {
                *value = -*value;
            }
            self.label.insert(0, '\u{2212}');
        }
        self
    }

    /// Whether it has anything to show: some value larger than rounding.
    pub(crate) fn is_visible(&self, threshold: f64) -> bool {
        let [low, high] = self.range();
        high.max(-low) > threshold
    }
}

/// The share of the largest value up to which values of the other sign are stray ones.
const STRAY: f64 = 0.1;

/// Colours over a range: from zero for values of one sign, but for a few stray ones, else symmetric
/// about zero.
pub(crate) fn colors(palette: Palette, range: [f64; 2]) -> ColorScale {
    let [low, high] = range;
    let largest = high.max(-low);
    if low < -STRAY * largest && high > STRAY * largest {
        return ColorScale { palette: Palette::Signed, low: -largest, high: largest };
    }
    if high >= -low {
        ColorScale { palette, low: 0.0, high }
    } else {
        ColorScale { palette, low, high: 0.0 }
    }
}

/// A field of the cells as maps show it: its length, if it is a vector.
struct Map {
    name: &'static str,
    title: &'static str,
    /// In the markup of labels.
    symbol: &'static str,
    units: &'static [Unit],
    /// Its components.
    of: &'static [schlupf::Quantity],
    vanishes_at_rim: bool,
    palette: Palette,
}

const PRESSURE: Map = Map {
    name: "pressure",
    title: "Normal pressure",
    symbol: "$p$_n",
    units: units::PRESSURE,
    of: &[schlupf::Quantity::Pressure],
    vanishes_at_rim: true,
    palette: Palette::Mechanical,
};

const TRACTION: Map = Map {
    name: "traction",
    title: "Tangential traction on the rail",
    symbol: "|$t$|",
    units: units::PRESSURE,
    of: &[schlupf::Quantity::TractionX, schlupf::Quantity::TractionY],
    vanishes_at_rim: true,
    palette: Palette::Mechanical,
};

const SLIP: Map = Map {
    name: "slip",
    title: "Slip velocity of the wheel over the rail",
    symbol: "|$v$_s|",
    units: units::VELOCITY,
    of: &[schlupf::Quantity::SlipX, schlupf::Quantity::SlipY],
    vanishes_at_rim: false,
    palette: Palette::Mechanical,
};

const POWER: Map = Map {
    name: "friction_power",
    title: "Friction power per area",
    symbol: "$q$",
    units: units::POWER_PER_AREA,
    of: &[schlupf::Quantity::FrictionPowerDensity],
    vanishes_at_rim: true,
    palette: Palette::Thermal,
};

const RISE: Map = Map {
    name: "temperature",
    title: "Temperature rise of the surface",
    symbol: "Δ$T$",
    units: units::TEMPERATURE_RISE,
    of: &[schlupf::Quantity::RiseWheel],
    vanishes_at_rim: false,
    palette: Palette::Thermal,
};

impl Map {
    /// The field in engineering units.
    fn physical(&self, patch: &Patch) -> Quantity {
        let components: Vec<Vec<f64>> = self.of.iter().map(|of| column(patch, *of)).collect();
        let values = match components.as_slice() {
            [x, y] => x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect(),
            _ => components.concat(),
        };
        let (unit, values) = scaled(&values, self.units);
        Quantity {
            name: self.name,
            title: self.title.to_owned(),
            label: format!("{} ({})", self.symbol, unit.symbol),
            values,
            vanishes_at_rim: self.vanishes_at_rim,
            normalised: false,
            palette: self.palette,
        }
    }
}

/// A column of the fields.
fn column(patch: &Patch, quantity: schlupf::Quantity) -> Vec<f64> {
    let fields = patch.fields();
    let column = Fields::columns().iter().find(|column| column.quantity == quantity);
    let value = |cell| column.and_then(|column| (column.value)(fields, cell).number());
    (0..fields.rows()).map(|cell| value(cell).unwrap_or_default()).collect()
}

/// The quantities of the flat maps, in engineering units.
pub(crate) fn physical(patch: &Patch) -> Vec<Quantity> {
    let maps = [PRESSURE, TRACTION, SLIP, POWER].map(|map| map.physical(patch));
    maps.into_iter().chain([temperature(patch)]).collect()
}

/// The quantities of the paper's Figures 4 to 7; pressure and traction normalised by Eqs. (24),
/// (25).
pub(crate) fn of_the_paper(patch: &Patch) -> Vec<Quantity> {
    let peak = patch.solution.normal.peak_pressure;
    let limit = patch.cold_friction * peak;
    let normalised = |of, bound: f64| finite(column(patch, of).iter().map(|value| value / bound));
    let force = |name, direction: &str, label: &str, of| Quantity {
        name,
        title: format!("Tangential force on the rail, {direction}"),
        label: label.to_owned(),
        values: normalised(of, -limit),
        normalised: true,
        ..TRACTION.physical(patch)
    };
    let [along, across] = [schlupf::Quantity::TractionX, schlupf::Quantity::TractionY];
    vec![
        Quantity {
            label: "$p$*".to_owned(),
            values: normalised(schlupf::Quantity::Pressure, peak),
            normalised: true,
            ..PRESSURE.physical(patch)
        },
        force("force_x", "along rolling", "Δ$F$_{Tx}*", along).upright(),
        force("force_y", "across rolling", "Δ$F$_{Ty}*", across).upright(),
        SLIP.physical(patch),
        POWER.physical(patch),
        temperature(patch),
    ]
}

/// The rise of the hotter body over its bulk temperature.
fn temperature(patch: &Patch) -> Quantity {
    let largest = |of| finite(column(patch, of).into_iter()).into_iter().fold(0.0, f64::max);
    let [wheel, rail] = [schlupf::Quantity::RiseWheel, schlupf::Quantity::RiseRail].map(largest);
    let (body, of): (_, &[_]) = if (wheel - rail).abs() <= 1e-6 * wheel.max(rail) {
        ("wheel and rail", RISE.of)
    } else if wheel > rail {
        ("wheel", RISE.of)
    } else {
        ("rail", &[schlupf::Quantity::RiseRail])
    };
    let title = format!("{}, {body}", RISE.title);
    Quantity { title, ..Map { of, ..RISE }.physical(patch) }
}

/// A field in the unit that suits its largest value.
pub(crate) fn scaled(field: &[f64], candidates: &[Unit]) -> (Unit, Vec<f64>) {
    let values = finite(field.iter().copied());
    let unit = units::pick(candidates, values.iter().fold(0.0, |largest, v| v.abs().max(largest)));
    let values = values.iter().map(|v| v / unit.size).collect();
    (unit, values)
}

/// Values with zero in place of what is not a number: a figure shows the rest.
fn finite(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.map(|v| if v.is_finite() { v } else { 0.0 }).collect()
}
