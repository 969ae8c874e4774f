//! The quantities that are shown over the patch.

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
    /// Whether it is bounded by the pressure and so vanishes at the rim of the patch. Such a field is
    /// a mean over the whole cell, of which only a part may be covered.
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

    /// A field of negative values turned over, so that a surface is a hill and not a pit that hides its
    /// own ground; the label says so.
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

/// The quantities of the flat maps, in engineering units.
pub(crate) fn physical(patch: &Patch) -> Vec<Quantity> {
    vec![pressure(patch), traction(patch), slip(patch), friction_power(patch), temperature(patch)]
}

/// The quantities of the paper's Figures 4 to 7; pressure and traction normalised by Eqs. (24), (25).
pub(crate) fn of_the_paper(patch: &Patch) -> Vec<Quantity> {
    let peak = patch.solution.normal.peak_pressure;
    let limit = patch.cold_friction * peak;
    let fields = patch.fields();
    let force = |name, direction: &str, label: &str, traction: &[f64]| Quantity {
        name,
        title: format!("Tangential force on the rail, {direction}"),
        label: label.to_owned(),
        values: finite(traction.iter().map(|t| -t / limit)),
        vanishes_at_rim: true,
        normalised: true,
        palette: Palette::Mechanical,
    };
    vec![
        Quantity {
            label: "$p$*".to_owned(),
            values: finite(fields.pressure.iter().map(|p| p / peak)),
            normalised: true,
            ..pressure(patch)
        },
        force("force_x", "along rolling", "Δ$F$_{Tx}*", &fields.traction_x).upright(),
        force("force_y", "across rolling", "Δ$F$_{Ty}*", &fields.traction_y).upright(),
        slip(patch),
        friction_power(patch),
        temperature(patch),
    ]
}

fn pressure(patch: &Patch) -> Quantity {
    let (unit, values) = scaled(&patch.fields().pressure, units::PRESSURE);
    Quantity {
        name: "pressure",
        title: "Normal pressure".to_owned(),
        label: format!("$p$_n ({})", unit.symbol),
        values,
        vanishes_at_rim: true,
        normalised: false,
        palette: Palette::Mechanical,
    }
}

fn traction(patch: &Patch) -> Quantity {
    let fields = patch.fields();
    let (unit, values) =
        scaled(&magnitude(&fields.traction_x, &fields.traction_y), units::PRESSURE);
    Quantity {
        name: "traction",
        title: "Tangential traction on the rail".to_owned(),
        label: format!("|$t$| ({})", unit.symbol),
        values,
        vanishes_at_rim: true,
        normalised: false,
        palette: Palette::Mechanical,
    }
}

fn slip(patch: &Patch) -> Quantity {
    let fields = patch.fields();
    let (unit, values) = scaled(&magnitude(&fields.slip_x, &fields.slip_y), units::VELOCITY);
    Quantity {
        name: "slip",
        title: "Slip velocity of the wheel over the rail".to_owned(),
        label: format!("|$v$_s| ({})", unit.symbol),
        values,
        vanishes_at_rim: false,
        normalised: false,
        palette: Palette::Mechanical,
    }
}

fn friction_power(patch: &Patch) -> Quantity {
    let (unit, values) = scaled(&patch.fields().friction_power, units::POWER_PER_AREA);
    Quantity {
        name: "friction_power",
        title: "Friction power per area".to_owned(),
        label: format!("$q$ ({})", unit.symbol),
        values,
        vanishes_at_rim: true,
        normalised: false,
        palette: Palette::Thermal,
    }
}

/// The rise of the hotter body over its bulk temperature.
fn temperature(patch: &Patch) -> Quantity {
    let fields = patch.fields();
    let (wheel, rail) = (&fields.temperature_rise_wheel, &fields.temperature_rise_rail);
    let largest =
        |field: &[f64]| field.iter().copied().filter(|t| t.is_finite()).fold(0.0, f64::max);
    let (body, field) = match (largest(wheel), largest(rail)) {
        (w, r) if (w - r).abs() <= 1e-6 * w.max(r) => ("wheel and rail", wheel),
        (w, r) if w > r => ("wheel", wheel),
        _ => ("rail", rail),
    };
    let (unit, values) = scaled(field, units::TEMPERATURE_RISE);
    Quantity {
        name: "temperature",
        title: format!("Temperature rise of the surface, {body}"),
        label: format!("Δ$T$ ({})", unit.symbol),
        values,
        vanishes_at_rim: false,
        normalised: false,
        palette: Palette::Thermal,
    }
}

/// Lengths of vectors given by their components.
pub(crate) fn magnitude(x: &[f64], y: &[f64]) -> Vec<f64> {
    x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect()
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
