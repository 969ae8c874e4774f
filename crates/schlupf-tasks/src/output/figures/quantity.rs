//! The quantities shown over the patch.

use schlupf::reporting::Record;
use schlupf::solution::Fields;

use super::color::{ColorScale, Palette};
use super::patch::Patch;
use super::ticks::round_axis;
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
    /// Whether it is bounded by the pressure and therefore vanishes at the rim of the patch. Such a
    /// field is a mean over the whole cell, which may be only partly covered.
    pub vanishes_at_rim: bool,
    /// Whether it is dimensionless with a maximum of one.
    pub normalised: bool,
    /// Colours.
    pub palette: Palette,
    /// Value at which colours and surface begin: zero except for temperatures in °C.
    pub base: f64,
}

impl Quantity {
    /// Smallest and largest value, the base included.
    pub(crate) fn range(&self) -> [f64; 2] {
        let low = self.values.iter().copied().fold(self.base, f64::min);
        let high = self.values.iter().copied().fold(self.base, f64::max);
        [low, high]
    }

    /// Colours over a range: from zero for values of one sign, except for a few stray ones,
    /// otherwise symmetric about zero; from the base if that is not zero.
    pub(crate) fn colors(&self, range: [f64; 2]) -> ColorScale {
        let [low, high] = range;
        let largest = high.max(-low);
        let is_signed = low < -STRAY * largest && high > STRAY * largest;
        let (palette, range) = if self.base != 0.0 {
            (self.palette, range)
        } else if is_signed {
            (Palette::Signed, [-largest, largest])
        } else if high >= -low {
            (self.palette, [0.0, high])
        } else {
            (self.palette, [low, 0.0])
        };
        ColorScale::linear(palette, range)
    }

    /// A field of negative values with its sign reversed, so that a surface is a hill and not a pit
    /// that hides its own bottom; the label says so.
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

    /// Whether it has anything to show: some value above rounding error.
    pub(crate) fn is_visible(&self, threshold: f64) -> bool {
        let [low, high] = self.range();
        (high - self.base).max(self.base - low) > threshold
    }
}

/// The fraction of the largest value up to which values of the other sign are considered stray.
const STRAY: f64 = 0.1;

/// A field of the cells as shown in maps: its magnitude, if it is a vector.
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
            base: 0.0,
        }
    }
}

/// A column of the fields.
fn column(patch: &Patch, quantity: schlupf::Quantity) -> Vec<f64> {
    let fields = patch.fields();
    let column = Fields::COLUMNS.iter().find(|column| column.quantity == quantity);
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

/// The surface of the hotter body: its temperature where the bulk temperatures differ, because then
/// the rises of the two cannot be compared; otherwise its rise.
fn temperature(patch: &Patch) -> Quantity {
    let bulk = patch.different_bulks();
    let [wheel, rail] = patch.surface_temperatures().map(|field| finite(field.into_iter()));
    let largest = |field: &[f64]| field.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let [hot_wheel, hot_rail] = [largest(&wheel), largest(&rail)];
    let difference = (hot_wheel - hot_rail).abs();
    let (body, values) = if difference <= 1e-6 * hot_wheel.abs().max(hot_rail.abs()) {
        ("wheel and rail", wheel)
    } else if hot_wheel > hot_rail {
        ("wheel", wheel)
    } else {
        ("rail", rail)
    };
    let rise = RISE.physical(patch);
    if bulk.is_none() {
        return Quantity { title: format!("{}, {body}", RISE.title), values, ..rise };
    }
    let coldest = values.iter().copied().fold(f64::INFINITY, f64::min);
    let base = round_axis(coldest, largest(&values), 5).0[0];
    let title = format!("Temperature of the surface, {body}");
    Quantity { title, label: "$T$ (°C)".to_owned(), values, base, ..rise }
}

/// A field in a unit suitable for its largest value.
pub(crate) fn scaled(field: &[f64], candidates: &[Unit]) -> (Unit, Vec<f64>) {
    let values = finite(field.iter().copied());
    let unit = units::pick(candidates, values.iter().fold(0.0, |largest, v| v.abs().max(largest)));
    let values = values.iter().map(|v| v / unit.size).collect();
    (unit, values)
}

/// Values with zero in place of NaN and infinity, so that a figure shows the rest.
fn finite(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.map(|v| if v.is_finite() { v } else { 0.0 }).collect()
}
