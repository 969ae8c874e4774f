//! Coefficients of Archard's law over slip speed and pressure.

use crate::reporting::{Error, Quantity, Requirement, require, require_finite};

/// A table of coefficients of Archard's law: constant in rectangles of the slip speed and of the
/// pressure over the hardness, each of which begins at an edge and ends before the next.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct WearMap {
    slip_speeds: Vec<f64>,
    pressure_ratios: Vec<f64>,
    coefficients: Vec<f64>,
}

impl Default for WearMap {
    /// [`Self::jendel`] with [its coefficients](Self::DRY_STEEL).
    fn default() -> Self {
        Self::jendel(Self::DRY_STEEL)
    }
}

impl WearMap {
    /// Coefficients of mild, severe and catastrophic wear of dry steel (dimensionless): the middle
    /// of the ranges of Jendel (2002), 1 to 10, 30 to 40 and 300 to 400 times 10⁻⁴.
    pub const DRY_STEEL: [f64; 3] = [5e-4, 35e-4, 350e-4];

    /// Slip speeds from which and up to which Jendel's map has severe wear, in m/s.
    pub const SEVERE: [f64; 2] = [0.2, 0.7];

    /// Pressure over the hardness from which on Jendel's map has catastrophic wear, dimensionless.
    pub const CATASTROPHIC: f64 = 0.8;

    /// The map of KTH (Jendel 2002) with its coefficients of mild, severe and catastrophic wear
    /// (dimensionless): catastrophic from 0.8 H on, below it severe for slip speeds between 0.2 and
    /// 0.7 m/s, and mild for those below and above.
    ///
    /// Limits: dry steel on steel.
    pub fn jendel([mild, severe, catastrophic]: [f64; 3]) -> Self {
        let [low, high] = Self::SEVERE;
        Self {
            slip_speeds: vec![0.0, low, high],
            pressure_ratios: vec![0.0, Self::CATASTROPHIC],
            coefficients: vec![mild, severe, mild, catastrophic, catastrophic, catastrophic],
        }
    }

    /// From the edges at which rectangles begin, slip speeds in m/s and pressures over the hardness
    /// (dimensionless), both from zero on and ascending, and a coefficient (dimensionless) for each
    /// rectangle: all slip speeds of the lowest pressure first.
    ///
    /// # Errors
    /// Edges that do not begin at zero or do not ascend, another number of coefficients, and
    /// coefficients that are not between 0 and 1.
    pub fn new(
        slip_speeds: Vec<f64>,
        pressure_ratios: Vec<f64>,
        coefficients: Vec<f64>,
    ) -> Result<Self, Error> {
        let edges =
            [(Quantity::LocalSlipSpeed, &slip_speeds), (Quantity::PressureRatio, &pressure_ratios)];
        for (quantity, edges) in edges {
            let first = edges.first().copied().unwrap_or(f64::NAN);
            require(quantity, Requirement::Between(0.0, 0.0), first)?;
            edges.iter().try_for_each(|edge| require_finite(quantity, *edge))?;
            if let Some(k) = edges.windows(2).position(|pair| pair[1] <= pair[0]) {
                let [before, after] = [edges[k], edges[k + 1]];
                return Err(Error::NotAscending { quantity, axis: "", before, after });
            }
        }
        let expected = slip_speeds.len() * pressure_ratios.len();
        let quantity = Quantity::WearCoefficient;
        if coefficients.len() != expected {
            return Err(Error::WrongCount { quantity, expected, count: coefficients.len() });
        }
        let part = Requirement::Between(0.0, 1.0);
        coefficients.iter().try_for_each(|value| require(quantity, part, *value))?;
        Ok(Self { slip_speeds, pressure_ratios, coefficients })
    }

    /// The coefficient (dimensionless) for a slip speed (in m/s) and a pressure over the hardness
    /// (dimensionless).
    pub fn coefficient(&self, slip_speed: f64, pressure_ratio: f64) -> f64 {
        let rectangle = |edges: &[f64], value: f64| {
            edges.partition_point(|edge| *edge <= value).saturating_sub(1)
        };
        let column = rectangle(&self.slip_speeds, slip_speed);
        let row = rectangle(&self.pressure_ratios, pressure_ratio);
        self.coefficients[row * self.slip_speeds.len() + column]
    }

    /// Slip speeds at which rectangles begin, in m/s.
    pub fn slip_speeds(&self) -> &[f64] {
        &self.slip_speeds
    }

    /// Pressures over the hardness at which rectangles begin, dimensionless.
    pub fn pressure_ratios(&self) -> &[f64] {
        &self.pressure_ratios
    }

    /// The coefficients (dimensionless), all slip speeds of the lowest pressure first.
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }
}
