//! A factor of friction from a table.

use crate::numerics::interpolation::piecewise_linear;
use crate::reporting::{Error, Place, Quantity, Requirement, require_at};

/// Tolerance of the factor at zero: tables have few digits.
const ROUNDING: f64 = 1e-6;

/// A factor of friction over a position or an angle: linear between the points of a table, constant
/// outside, and 1 at zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation {
    at: Vec<f64>,
    factor: Vec<f64>,
}

impl Variation {
    /// Factors (dimensionless) at positions y across rolling (in m, ascending).
    pub fn over_y(y: Vec<f64>, factor: Vec<f64>) -> Result<Self, Error> {
        Self::new(Quantity::VariationY, y, factor)
    }

    /// Factors (dimensionless) at inclinations of the surface of the rail (in rad, ascending):
    /// negative on the gauge face, positive where the surface falls outwards.
    pub fn over_inclination(inclination: Vec<f64>, factor: Vec<f64>) -> Result<Self, Error> {
        Self::new(Quantity::VariationInclination, inclination, factor)
    }

    fn new(quantity: Quantity, at: Vec<f64>, mut factor: Vec<f64>) -> Result<Self, Error> {
        let (fewest, count) = (2, at.len());
        if count < fewest {
            return Err(Error::TooFew { quantity, fewest, count });
        }
        if factor.len() != count {
            let (quantity, expected) = (Quantity::VariationFactor, count);
            return Err(Error::WrongCount { quantity, expected, count: factor.len() });
        }
        for (k, at) in at.iter().enumerate() {
            require_at(quantity, Requirement::Finite, *at, Place::Index(k + 1))?;
        }
        if let Some(pair) = at.windows(2).find(|pair| pair[1] <= pair[0]) {
            let (before, after) = (pair[0], pair[1]);
            return Err(Error::NotAscending { quantity, axis: "", before, after });
        }
        for (k, factor) in factor.iter().enumerate() {
            let place = Place::Index(k + 1);
            require_at(Quantity::VariationFactor, Requirement::NotNegative, *factor, place)?;
        }
        let [centre, _] = piecewise_linear(&at, &factor, 0.0);
        if (centre - 1.0).abs() > ROUNDING {
            return Err(Error::OffCentreFactor { over: quantity, factor: centre });
        }
        for factor in &mut factor {
            *factor /= centre;
        }
        Ok(Self { at, factor })
    }

    /// The factor at a position (in m) or an angle (in rad), and its derivative (in 1/m or 1/rad).
    pub fn at(&self, at: f64) -> [f64; 2] {
        piecewise_linear(&self.at, &self.factor, at)
    }

    /// The factors over ascending positions y (in m), from the angle at each; not necessarily 1 at
    /// y = 0.
    pub(crate) fn mapped(&self, y: Vec<f64>, at: impl Fn(f64) -> f64) -> Self {
        let factor = y.iter().map(|y| self.at(at(*y))[0]).collect();
        Self { at: y, factor }
    }
}
