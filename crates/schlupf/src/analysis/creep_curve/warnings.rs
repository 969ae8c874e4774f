//! The warnings of all points, each kind reported once.

use crate::reporting::{Message, Quantity, Tallied, Tally, Unconverged, Warning, Words, places};
use crate::solution::Status;

use super::Point;

/// A warning of a creep curve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct CurveWarning {
    /// The warning; the worst one where several points have one.
    pub warning: Warning,
    /// Where it applies; `None` for the whole curve.
    pub at: Option<Points>,
}

/// Points of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Points {
    /// The abscissa of the curve.
    pub abscissa: Quantity,
    /// Abscissa of the worst of them, or the first of equal ones, in its unit or dimensionless.
    pub worst: f64,
    /// How many there are.
    pub count: usize,
    /// Whether all of them are equally severe.
    pub is_even: bool,
}

impl CurveWarning {
    /// The message in the words of an interface.
    pub fn message(&self, words: &dyn Words) -> Message {
        let message = self.warning.message(words);
        let Some(Points { abscissa, worst, count, is_even }) = self.at else { return message };
        let place = format!("{} = {}", words.word(abscissa), abscissa.six_digits(worst));
        message.about(&places(&place, "point", count, is_even))
    }
}

/// Warnings of a curve.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    of_points: Tally<Warning, f64>,
    /// Warnings of the curve as a whole.
    others: Vec<Warning>,
}

/// Maximum number of points that a warning names.
const MOST_NAMES: usize = 12;

impl Warnings {
    /// Warnings of the solution at an abscissa.
    pub(super) fn note(&mut self, abscissa: f64, warnings: &[Warning]) {
        for warning in warnings {
            self.of_points.note(warning.clone(), abscissa);
        }
    }

    /// Adds a warning of the curve as a whole.
    pub(super) fn extend(&mut self, warning: Option<Warning>) {
        self.others.extend(warning);
    }

    /// All of them, the points that did not converge first.
    pub(super) fn all(self, abscissa: Quantity, points: &[Point]) -> Vec<CurveWarning> {
        let of_curve = not_converged(abscissa, points).into_iter().chain(self.others);
        let of_curve = of_curve.map(|warning| CurveWarning { warning, at: None });
        let of_points = self.of_points.into_iter().map(|found| {
            let Tallied { worst: warning, place: worst, count, is_even } = found;
            let is_everywhere = is_even && count == points.len();
            let at = (!is_everywhere).then_some(Points { abscissa, worst, count, is_even });
            CurveWarning { warning, at }
        });
        of_curve.chain(of_points).collect()
    }
}

fn not_converged(abscissa: Quantity, points: &[Point]) -> Option<Warning> {
    let failed = points.iter().filter(|point| point.status == Status::NotConverged);
    let failed: Vec<f64> = failed.map(|point| point.abscissa).collect();
    let places = failed.iter().take(MOST_NAMES).copied().collect();
    let (failed, count) = (failed.len(), points.len());
    (failed > 0).then(|| Warning::of(Unconverged::Points { abscissa, places, failed, count }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reporting::Names;

    #[test]
    fn warnings_that_differ_in_values_are_one() {
        let mut warnings = Warnings::default();
        let margin = |edge| Warning::SmallMargin { edge };
        let (always, once) = (Warning::BranchLost {}, Warning::NoSensitivity {});
        warnings.note(0.0, &[margin(0.013), always.clone()]);
        warnings.note(0.1, &[always.clone(), once]);
        warnings.note(0.2, &[margin(0.05), always]);
        warnings.extend(Some(Warning::NoInitialSlope { abscissa: Quantity::Spin }));
        let all = warnings.all(Quantity::Spin, &[]);
        let texts: Vec<String> = all.iter().map(|warning| warning.message(&Names).text).collect();
        assert!(texts[0].starts_with("no initial slope"));
        assert!(texts[1].starts_with("spin = 0.2 1/m, the worst of 2 points: margin: "));
        assert!(texts[2].starts_with("spin = 0 1/m and 2 more points: friction falls"));
        assert!(texts[3].starts_with("spin = 0.1 1/m: sensitivity: "));
    }
}
