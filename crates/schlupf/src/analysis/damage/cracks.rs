//! Cracks by rolling contact fatigue as a function of Tγ.

use crate::reporting::{Error, Quantity, require_finite};

/// Damage of a passage as a function of the wear number Tγ, linear between points: the reciprocal
/// of the number of such passages until a crack is there. It is constant below the first point; a
/// last line that falls goes on, to negative values where wear removes more than a passage damages,
/// and beyond one that rises the function is constant.
///
/// Limits: the steel, the profiles and the traffic that the function was fitted to; Tγ without
/// spin; no history of load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CrackFunction {
    t_gamma: Vec<f64>,
    damage: Vec<f64>,
}

impl Default for CrackFunction {
    /// Burstow (2004, RSSB T355) for British rails of grade R220 and R260: none up to 15 N, most
    /// at 65 N, a crack in 10⁵ passages, and wear from 175 N on.
    fn default() -> Self {
        Self { t_gamma: vec![0.0, 15.0, 65.0, 175.0], damage: vec![0.0, 0.0, 1e-5, 0.0] }
    }
}

impl CrackFunction {
    /// Through points with ascending Tγ (in N) and the damage of a passage (dimensionless).
    ///
    /// # Errors
    /// Fewer than two points, another number of damages, Tγ that does not ascend, and numbers that
    /// are not finite.
    pub fn new(t_gamma: Vec<f64>, damage: Vec<f64>) -> Result<Self, Error> {
        let quantity = Quantity::CrackWearNumber;
        if t_gamma.len() < 2 {
            return Err(Error::TooFew { quantity, fewest: 2, count: t_gamma.len() });
        }
        let [expected, count] = [t_gamma.len(), damage.len()];
        if count != expected {
            return Err(Error::WrongCount { quantity: Quantity::CrackDamage, expected, count });
        }
        t_gamma.iter().try_for_each(|value| require_finite(quantity, *value))?;
        damage.iter().try_for_each(|value| require_finite(Quantity::CrackDamage, *value))?;
        if let Some(k) = t_gamma.windows(2).position(|pair| pair[1] <= pair[0]) {
            let [before, after] = [t_gamma[k], t_gamma[k + 1]];
            return Err(Error::NotAscending { quantity, axis: "", before, after });
        }
        Ok(Self { t_gamma, damage })
    }

    /// The damage of a passage (dimensionless) with a wear number (in N).
    pub fn of(&self, t_gamma: f64) -> f64 {
        let last = self.t_gamma.len() - 1;
        let upper = self.t_gamma.partition_point(|at| *at <= t_gamma).clamp(1, last);
        let [x, y] = [&self.t_gamma, &self.damage].map(|values| [values[upper - 1], values[upper]]);
        let farthest = if y[1] < y[0] { f64::INFINITY } else { 1.0 };
        let part = ((t_gamma - x[0]) / (x[1] - x[0])).clamp(0.0, farthest);
        y[0] + part * (y[1] - y[0])
    }
}
