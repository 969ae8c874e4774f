//! Units of quantities in figures and summaries: the largest one without a leading zero.

/// A unit and its size in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit {
    /// Its size in SI units.
    pub size: f64,
    /// Its symbol, with the markup of figure labels.
    pub symbol: &'static str,
}

const fn unit(size: f64, symbol: &'static str) -> Unit {
    Unit { size, symbol }
}

/// Units of pressure and traction.
pub(crate) const PRESSURE: &[Unit] = &[unit(1e6, "MPa"), unit(1e3, "kPa"), unit(1.0, "Pa")];
/// Units of slip velocity.
pub(crate) const VELOCITY: &[Unit] = &[unit(1.0, "m/s"), unit(1e-3, "mm/s"), unit(1e-6, "µm/s")];
/// Units of power per unit area.
pub(crate) const POWER_PER_AREA: &[Unit] =
    &[unit(1e6, "W/mm²"), unit(1e3, "kW/m²"), unit(1.0, "W/m²")];
/// Units of temperature differences.
pub(crate) const TEMPERATURE_RISE: &[Unit] = &[unit(1.0, "K")];
/// Units of force.
pub(crate) const FORCE: &[Unit] = &[unit(1e3, "kN"), unit(1.0, "N")];
/// Units of distance along the rail.
pub(crate) const DISTANCE: &[Unit] = &[unit(1.0, "m"), unit(1e-3, "mm")];
/// Units of time.
pub(crate) const TIME: &[Unit] = &[unit(1.0, "s"), unit(1e-3, "ms")];

/// Units of lengths on a rough surface.
pub(crate) const ROUGH_LENGTH: &[Unit] = &[unit(1e-3, "mm"), unit(1e-6, "µm")];

/// The first unit, from large to small, in which `largest` is at least one; otherwise the last.
pub(crate) fn pick(units: &[Unit], largest: f64) -> Unit {
    let fits = units.iter().find(|unit| largest >= unit.size);
    *fits.or(units.last()).unwrap_or(&Unit { size: 1.0, symbol: "" })
}
