//! The points at which a curve is computed.

use super::Path;
use crate::reporting::{CurveError, Error, Quantity, Requirement, require};

/// The points of a curve, at least two.
#[derive(Debug, Clone, PartialEq)]
pub enum Sampling {
    /// So many, uniform in u with an abscissa ∝ sinh 5u, |u| ≤ 1: steps grow from zero outwards,
    /// almost constant near zero and by a constant factor far from it. Starting from zero, the last
    /// of 41 steps is some 70 times the first.
    Refined(usize),
    /// So many, uniform in the abscissa.
    Even(usize),
    /// At these abscissae of the path (each in its unit: dimensionless, in 1/m, N or N m), in the
    /// order from its start to its end.
    At(Vec<f64>),
}

/// Maximum number of points of a curve.
pub const MAX_POINTS: usize = 10_000;

impl Default for Sampling {
    fn default() -> Self {
        Self::Refined(41)
    }
}

impl Sampling {
    /// Checks that there are at least two points and not too many.
    pub fn check(&self) -> Result<(), Error> {
        let requirement = Requirement::Between(2.0, MAX_POINTS as f64);
        require(Quantity::CurvePoints, requirement, self.points() as f64)
    }

    /// Checks that given points lie on the path, each beyond the one before.
    pub(super) fn check_order(&self, path: &Path) -> Result<(), Error> {
        let Self::At(abscissae) = self else { return Ok(()) };
        let range = path.range();
        let mut reached = f64::NEG_INFINITY;
        for &value in abscissae {
            let share = (value - range[0]) / (range[1] - range[0]);
            if !(0.0..=1.0).contains(&share) || share <= reached {
                return Err(CurveError::Order { quantity: path.quantity(), value, range }.into());
            }
            reached = share;
        }
        Ok(())
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        match self {
            Self::Refined(points) | Self::Even(points) => *points,
            Self::At(abscissae) => abscissae.len(),
        }
    }

    /// Abscissae from `from` to `to` (each in the unit of the ends: dimensionless, in 1/m, N or
    /// N m). A refined range that contains zero has a point there.
    pub fn abscissae(&self, [from, to]: [f64; 2]) -> Vec<f64> {
        let steps = self.points() - 1;
        match self {
            Self::At(abscissae) => abscissae.clone(),
            Self::Even(_) => (0..=steps).map(|k| between([from, to], k, steps)).collect(),
            Self::Refined(_) => {
                let largest = from.abs().max(to.abs());
                let scale = largest / STRENGTH.sinh();
                let [start, end] = [from, to].map(|end| (end / scale).asinh());
                let zero_inside = start * end < 0.0 && steps > 1;
                let before = (start / (start - end) * steps as f64).round() as usize;
                let before = if zero_inside { before.clamp(1, steps - 1) } else { 0 };
                let side = |k: usize| match k {
                    0 => from,
                    _ if k == steps => to,
                    _ if k < before => scale * between([start, 0.0], k, before).sinh(),
                    _ if zero_inside => {
                        scale * between([0.0, end], k - before, steps - before).sinh()
                    }
                    _ => scale * between([start, end], k, steps).sinh(),
                };
                (0..=steps).map(side).collect()
            }
        }
    }
}

/// Strength of the refinement at zero: sinh 5u.
const STRENGTH: f64 = 5.0;

/// The k-th of `steps` equal steps; exactly zero where only rounding error differs from zero.
fn between([from, to]: [f64; 2], k: usize, steps: usize) -> f64 {
    if k == steps {
        return to;
    }
    let value = from + (to - from) * (k as f64 / steps as f64);
    if value.abs() < 1e-12 * from.abs().max(to.abs()) { 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::Creepages;
    use super::*;

    fn refined(points: usize, range: [f64; 2]) -> Vec<f64> {
        Sampling::Refined(points).abscissae(range)
    }

    #[test]
    fn steps_grow_from_zero_outwards() {
        let points = refined(41, [0.0, 0.05]);
        assert_eq!((points.len(), points[0], points[40]), (41, 0.0, 0.05));
        let steps: Vec<f64> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(steps.windows(2).all(|pair| pair[1] > pair[0]));
        assert!((60.0..90.0).contains(&(steps[39] / steps[0])), "{}", steps[39] / steps[0]);
        let down = refined(41, [0.05, 0.0]);
        for (up, down) in points.iter().zip(down.iter().rev()) {
            assert_relative_eq!(up, down, max_relative = 1e-12);
        }
    }

    #[test]
    fn a_range_through_zero_has_a_point_there_and_is_fine_about_it() {
        for (range, points) in [([-0.05, 0.05], 41), ([-0.001, 0.05], 10), ([0.05, -0.02], 3)] {
            let values = refined(points, range);
            assert_eq!(values.len(), points);
            assert_eq!([values[0], values[points - 1]], range);
            assert_eq!(values.iter().filter(|value| **value == 0.0).count(), 1, "{values:?}");
            let rises = range[1] > range[0];
            assert!(values.windows(2).all(|pair| (pair[1] > pair[0]) == rises), "{values:?}");
        }
        assert_eq!(refined(2, [-0.01, 0.02]), [-0.01, 0.02]);
    }

    #[test]
    fn even_steps_are_even() {
        assert_eq!(Sampling::Even(5).abscissae([-0.5, 0.5]), [-0.5, -0.25, 0.0, 0.25, 0.5]);
        let values = Sampling::Even(7).abscissae([-0.03, 0.03]);
        assert_eq!(values[3], 0.0);
        assert!(Sampling::Even(1).check().is_err());
        assert!(Sampling::Even(MAX_POINTS + 1).check().is_err());
        assert!(Sampling::At(vec![0.0]).check().is_err());
        assert_eq!(Sampling::default().check(), Ok(()));
    }

    #[test]
    fn given_points_follow_the_path() {
        let [start, end] = [0.02, -0.01].map(|x| Creepages { x, ..Creepages::default() });
        let path = Path::new(start, end).unwrap();
        let check = |points: &[f64]| Sampling::At(points.to_vec()).check_order(&path);
        assert_eq!(check(&[0.02, 0.0, -0.01]), Ok(()));
        assert_eq!(check(&[0.01, 0.0]), Ok(()));
        for wrong in [[0.02, 0.02], [0.0, 0.01], [0.0, -0.02], [0.0, f64::NAN]] {
            let message = check(&wrong).unwrap_err().to_string();
            assert!(message.contains("must run from 0.02 to -0.01"), "{message}");
        }
    }
}
