//! An elliptic patch with given semi-axes and Hertzian pressure.

use std::f64::consts::TAU;

use super::{NormalContact, NormalSummary, Pressure, PressureSource};
use crate::reporting::{Error, Quantity, require_positive};

/// Semi-ellipsoidal pressure on an ellipse with given semi-axes, N = (2/3) π a b p0.
///
/// Whatever the load is, the semi-axes are those given and the pressure is scaled, as in
/// derivatives with respect to the load: a patch that grows is one of bodies, [`super::Hertz`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    semi_axis_x: f64,
    semi_axis_y: f64,
    load: f64,
}

impl Ellipse {
    /// An ellipse with given semi-axes (in m) and load (in N).
    ///
    /// ```
    /// use schlupf::normal::{PressureSource, Ellipse};
    ///
    /// let contact = Ellipse::from_load(6e-3, 5e-3, 80e3)?.normal_contact(None)?.summary;
    /// let mean = 80e3 / (std::f64::consts::PI * 6e-3 * 5e-3);
    /// assert!((contact.peak_pressure / mean - 1.5).abs() < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn from_load(semi_axis_x: f64, semi_axis_y: f64, load: f64) -> Result<Self, Error> {
        require_positive(Quantity::SemiAxisX, semi_axis_x)?;
        require_positive(Quantity::SemiAxisY, semi_axis_y)?;
        require_positive(Quantity::Load, load)?;
        Ok(Self { semi_axis_x, semi_axis_y, load })
    }

    /// An ellipse with given semi-axes (in m) and largest pressure (in Pa).
    pub fn from_peak_pressure(
        semi_axis_x: f64,
        semi_axis_y: f64,
        peak_pressure: f64,
    ) -> Result<Self, Error> {
        require_positive(Quantity::PeakPressure, peak_pressure)?;
        let load = TAU / 3.0 * semi_axis_x * semi_axis_y * peak_pressure;
        require_positive(Quantity::SemiAxisX, semi_axis_x)?;
        require_positive(Quantity::SemiAxisY, semi_axis_y)?;
        Self::from_load(semi_axis_x, semi_axis_y, load)
    }
}

impl PressureSource for Ellipse {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        let load = load.unwrap_or(self.load);
        require_positive(Quantity::Load, load)?;
        let (a, b) = (self.semi_axis_x, self.semi_axis_y);
        let summary = NormalSummary {
            load,
            semi_axis_x: a,
            semi_axis_y: b,
            peak_pressure: 3.0 * load / (TAU * a * b),
            approach: None,
            origin: None,
            parts: 1,
        };
        Ok(NormalContact { summary, pressure: Pressure::Elliptic, rows: None })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn load_and_peak_pressure_say_the_same() {
        let load = TAU / 3.0 * 6e-3 * 5e-3 * 1e9;
        let one = Ellipse::from_load(6e-3, 5e-3, load).unwrap();
        let two = Ellipse::from_peak_pressure(6e-3, 5e-3, 1e9).unwrap();
        assert_eq!(one, two);
    }

    #[test]
    fn another_load_scales_the_pressure() {
        let ellipse = Ellipse::from_load(6e-3, 5e-3, 80e3).unwrap();
        let [own, heavier] =
            [None, Some(160e3)].map(|load| ellipse.normal_contact(load).unwrap().summary);
        assert_eq!(heavier.semi_axis_x, 6e-3);
        assert_relative_eq!(heavier.peak_pressure, 2.0 * own.peak_pressure, max_relative = 1e-14);
    }
}
