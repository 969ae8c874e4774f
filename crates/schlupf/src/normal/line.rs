//! Line contact of two cylinders with parallel axes.

use std::f64::consts::{FRAC_PI_4, PI};

use super::hertz::curvature_sum;
use super::{NormalContact, NormalSummary, Pressure, PressureSource};
use crate::numerics::root::bisection;
use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// Two cylinders that touch along a line across rolling, of length L.
///
/// The pressure is that of plane strain over the whole length (Hertz 1882; Johnson, *Contact
/// Mechanics*, 1985, §4.2c), with the load N on the length L and 1/R = 1/R_wheel + 1/R_rail,
///
/// p = p0 √(1 − x²/a²),  a² = 4 N R/(π L E*),  p0 = 2 N/(π a L).
///
/// In plane strain the approach depends on where the bodies are held. It is that of half-spaces at
/// the middle of the length, under this pressure on a rectangle that is long against its width,
///
/// δ = 2 N/(π L E*) (ln(2 L/a) + ½).
///
/// Limits: no larger pressure at the ends, parallel axes. Rows of cells across the length have
/// tangential tractions with the effect of the ends; in one row there is none, as in plane strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    curvature: f64,
    length: f64,
    contact_modulus: f64,
    load: f64,
}

impl Line {
    /// Cylinders with radii of wheel and rail along rolling and a length (in m), the contact
    /// modulus E* (in Pa) and the load on the whole length, in N.
    ///
    /// ```
    /// use schlupf::normal::{Line, PressureSource};
    ///
    /// let line = Line::new([0.5, f64::INFINITY], 0.2, 114e9, 36e3)?;
    /// let contact = line.normal_contact(None)?.summary;
    /// let mean = 36e3 / (0.2 * 2.0 * contact.semi_axis_x);
    /// assert!((contact.peak_pressure / mean - 4.0 / std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(
        radii: [f64; 2],
        length: f64,
        contact_modulus: f64,
        load: f64,
    ) -> Result<Self, Error> {
        require_positive(Quantity::Load, load)?;
        require_positive(Quantity::LineLength, length)?;
        let [wheel, rail] = radii;
        let curvature =
            curvature_sum([(Quantity::WheelRadiusX, wheel), (Quantity::RailRadiusX, rail)])?;
        Ok(Self { curvature, length, contact_modulus, load })
    }

    /// The same at an approach (in m) in place of the load.
    ///
    /// # Errors
    /// As [`Self::new`], and an approach at which the contact is no longer than wide.
    pub fn from_approach(
        radii: [f64; 2],
        length: f64,
        contact_modulus: f64,
        approach: f64,
    ) -> Result<Self, Error> {
        let unit = Self::new(radii, length, contact_modulus, 1.0)?;
        let widest = 0.5 * length;
        let range = Requirement::AboveUpTo(0.0, unit.approach(widest));
        require(Quantity::Approach, range, approach)?;
        let [a, _] = bisection([0.0, widest], 60, |a| unit.approach(a) < approach);
        let load = FRAC_PI_4 * length * contact_modulus * unit.curvature * a * a;
        Ok(Self { load, ..unit })
    }

    /// Approach (in m) with a half-length a (in m): ½ a²/R (ln(2 L/a) + ½).
    fn approach(&self, a: f64) -> f64 {
        0.5 * self.curvature * a * a * ((2.0 * self.length / a).ln() + 0.5)
    }
}

impl PressureSource for Line {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        let load = load.unwrap_or(self.load);
        require_positive(Quantity::Load, load)?;
        let a = (load / (FRAC_PI_4 * self.length * self.contact_modulus * self.curvature)).sqrt();
        let summary = NormalSummary {
            load,
            semi_axis_x: a,
            semi_axis_y: 0.5 * self.length,
            peak_pressure: 2.0 * load / (PI * a * self.length),
            approach: Some(self.approach(a)),
            origin: None,
            parts: 1,
        };
        Ok(NormalContact { summary, pressure: Pressure::Line, rows: None })
    }

    fn undeformed_distance(&self, x: &[f64], y: &[f64]) -> Option<Vec<f64>> {
        let along: Vec<f64> = x.iter().map(|x| 0.5 * self.curvature * x * x).collect();
        Some(along.repeat(y.len()))
    }

    // Its length is given, and only its width grows.
    fn load_exponent(&self) -> Option<f64> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// CONTACT's example of Carter's problem (Vollebregt 2022, user guide, §5.2): R = 500 mm, 35.78
    /// kN on 200 mm, G = 82 GPa, ν = 0.28 give a = 1 mm; its approach on elements of 0.04 mm is
    /// 6.49156 µm.
    #[test]
    fn vollebregt_2022_carter_example() {
        let modulus = 82e9 / 0.72;
        let line = Line::new([0.5, f64::INFINITY], 0.2, modulus, 35.78e3).unwrap();
        let contact = line.normal_contact(None).unwrap().summary;
        assert_relative_eq!(contact.semi_axis_x, 1e-3, max_relative = 2e-4);
        assert_relative_eq!(contact.peak_pressure, 113.9e6, max_relative = 5e-4);
        let approach = contact.approach.unwrap();
        assert_relative_eq!(approach, 6.49156e-6, max_relative = 2e-4);
        let same = Line::from_approach([0.5, f64::INFINITY], 0.2, modulus, approach).unwrap();
        assert_relative_eq!(same.load, 35.78e3, max_relative = 1e-12);
        assert!(Line::from_approach([0.5, f64::INFINITY], 0.2, modulus, 0.1).is_err());
    }
}
